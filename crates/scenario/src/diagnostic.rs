//! What is wrong with the input, and where: all of it at once.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A file that was read.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// Its name as the user gave it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Where something stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In a file.
    File {
        /// The file.
        source: Arc<Source>,
        /// The bytes of its text.
        span: Range<usize>,
    },
    /// In an override, such as `launch.axial_speed=60 m/s`.
    Override(String),
}

/// A place as a person counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The file's name.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
}

/// One thing that is wrong with the input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The path in the scenario, such as `web.space.side`; empty where none applies.
    pub path: String,
    /// What is wrong, and what was expected.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// Where it stands; none for a file that cannot be read at all.
    pub place: Option<Place>,
}

impl Diagnostic {
    /// Something wrong at `place`.
    pub fn new(path: impl fmt::Display, message: impl Into<String>, place: Option<Place>) -> Self {
        Self { path: path.to_string(), message: message.into(), help: None, place }
    }

    /// Adds what to do about it.
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// Adds what to do about it, where there is something.
    pub fn with_help_if(self, help: Option<String>) -> Self {
        Self { help, ..self }
    }

    /// File, line and column; none where it does not stand in a file.
    pub fn location(&self) -> Option<Location> {
        let Some(Place::File { source, span }) = &self.place else { return None };
        let before = source.text.get(..span.start).unwrap_or(&source.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Some(Location {
            file: source.name.clone(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
        })
    }
}

impl fmt::Display for Diagnostic {
    /// `net.toml:3:8: web.space.side: message (help)`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.location(), &self.place) {
            (Some(at), _) => write!(formatter, "{}:{}:{}: ", at.file, at.line, at.column)?,
            (None, Some(Place::Override(text))) => write!(formatter, "--set {text}: ")?,
            _ => {}
        }
        if !self.path.is_empty() {
            write!(formatter, "{}: ", self.path)?;
        }
        formatter.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(formatter, " ({help})"),
            None => Ok(()),
        }
    }
}

/// Everything that is wrong with the input, never empty, in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics(pub Vec<Diagnostic>);

impl Diagnostics {
    /// Fails with everything found: file by file as they were read, each from top to bottom, then the overrides.
    ///
    /// # Errors
    /// Where anything was found.
    pub fn fail_if_any(mut found: Vec<Diagnostic>) -> Result<(), Self> {
        if found.is_empty() {
            return Ok(());
        }
        let mut files: Vec<Arc<Source>> = Vec::new();
        for diagnostic in &found {
            if let Some(Place::File { source, .. }) = &diagnostic.place
                && !files.iter().any(|file| Arc::ptr_eq(file, source))
            {
                files.push(source.clone());
            }
        }
        // stable: what stands at one place keeps its order
        found.sort_by_key(|diagnostic| match &diagnostic.place {
            Some(Place::File { source, span }) => {
                (files.iter().position(|file| Arc::ptr_eq(file, source)).unwrap_or(files.len()), span.start)
            }
            Some(Place::Override(_)) => (files.len(), 0),
            None => (files.len(), 1),
        });
        found.dedup();
        Err(Self(found))
    }
}

impl From<Diagnostic> for Diagnostics {
    fn from(diagnostic: Diagnostic) -> Self {
        Self(vec![diagnostic])
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, diagnostic) in self.0.iter().enumerate() {
            let newline = if place == 0 { "" } else { "\n" };
            write!(formatter, "{newline}{diagnostic}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_characters_from_one() {
        let source = Arc::new(Source { name: "net.toml".into(), text: "title = 1\ntitel = \"µ\" x\n".into() });
        let at = |span: Range<usize>| {
            let place = Some(Place::File { source: source.clone(), span });
            let location = Diagnostic::new("", "", place).location().unwrap();
            (location.line, location.column)
        };
        assert_eq!(at(0..1), (1, 1));
        assert_eq!(at(10..12), (2, 1));
        let x = source.text.find(" x").unwrap() + 1;
        assert_eq!(at(x..x + 1), (2, 13));
        assert_eq!(at(source.text.len()..source.text.len()), (3, 1));
    }
}
