//! Diagnostics: faults of the input with their places, all reported at once.

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

/// A place in the input.
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

/// A place in a file as editors count it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The file's name.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
}

/// A fault of the input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The path in the scenario, such as `web.space.side`; empty where none applies.
    pub path: String,
    /// The fault, and what was expected.
    pub message: String,
    /// How to correct it.
    pub help: Option<String>,
    /// Its place; `None` for a file that cannot be read.
    pub place: Option<Place>,
}

/// The most characters of a message and of a help. A cell of a file may be as long as the file.
const LONGEST_MESSAGE: usize = 400;
const LONGEST_HELP: usize = 1000;

/// A text of at most so many characters, and an ellipsis where it was longer.
fn cut(text: String, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

impl Diagnostic {
    /// A fault at `place`, without help.
    pub fn new(path: impl fmt::Display, message: impl Into<String>, place: Option<Place>) -> Self {
        Self { path: path.to_string(), message: cut(message.into(), LONGEST_MESSAGE), help: None, place }
    }

    /// Adds a help: how to correct the fault.
    pub fn with_help(self, help: impl Into<String>) -> Self {
        self.with_help_if(Some(help.into()))
    }

    /// Sets the help, which may be absent.
    pub fn with_help_if(self, help: Option<String>) -> Self {
        Self { help: help.map(|help| cut(help, LONGEST_HELP)), ..self }
    }

    /// File, line and column; `None` where the place is not in a file.
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

/// All faults of the input, in the order of the files; never empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics(pub Vec<Diagnostic>);

impl Diagnostics {
    /// Fails with all faults in `found`, sorted by file in the order of reading and by place in the file, then
    /// overrides.
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
        // a stable sort keeps the order of faults at the same place
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
