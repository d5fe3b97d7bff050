//! The path of a value in a scenario: `web.space.side`, `tractors[0].corner`.

use std::fmt;

/// One step down the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Into a table.
    Key(String),
    /// Into an array, from 0.
    Index(usize),
}

/// The path of a value; empty for the whole scenario.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Path(pub Vec<Step>);

impl Path {
    /// Reads `tractors.0.corner`, `tractors[0].corner`, `points."knot 3"`. A step that is a whole number is an index
    /// of an array or a key of a table, depending on the tree.
    pub fn parse(text: &str) -> Self {
        let mut steps = Vec::new();
        let mut rest = text;
        while !rest.is_empty() {
            let enclosed = match rest.chars().next() {
                Some('"') => rest[1..].split_once('"'),
                Some('[') => rest[1..].split_once(']'),
                _ => None,
            };
            let (step, after) = enclosed.unwrap_or_else(|| {
                let end = rest.char_indices().skip(1).find(|(_, c)| matches!(c, '.' | '[')).map(|(end, _)| end);
                rest.split_at(end.unwrap_or(rest.len()))
            });
            steps.push(Step::Key(step.to_string()));
            rest = after.strip_prefix('.').unwrap_or(after);
        }
        Self(steps)
    }

    /// The path of the value of `key` in the table at this path.
    pub fn key(&self, key: &str) -> Self {
        self.then(Step::Key(key.to_string()))
    }

    /// The path of element `index`, counted from 0, of the array at this path.
    pub fn index(&self, index: usize) -> Self {
        self.then(Step::Index(index))
    }

    /// The path of the table or array that holds this value. The parent of the empty path is the empty path.
    pub fn parent(&self) -> Self {
        Self(self.0[..self.0.len().saturating_sub(1)].to_vec())
    }

    fn then(&self, step: Step) -> Self {
        let mut steps = self.0.clone();
        steps.push(step);
        Self(steps)
    }
}

impl fmt::Display for Path {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, step) in self.0.iter().enumerate() {
            match step {
                Step::Index(index) => write!(formatter, "[{index}]")?,
                Step::Key(key) => {
                    let dot = if place == 0 { "" } else { "." };
                    let bare =
                        !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
                    if bare { write!(formatter, "{dot}{key}")? } else { write!(formatter, "{dot}{key:?}")? }
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_written_as_it_is_read() {
        assert_eq!(Path::parse("tractors.0.corner"), Path::parse("tractors[0].corner"));
        assert_eq!(Path::default().key("tractors").index(0).key("corner").to_string(), "tractors[0].corner");
        assert_eq!(Path::parse("points.\"knot.3\"").to_string(), "points.\"knot.3\"");
        assert_eq!(Path::parse("points.\"knot.3\"").0.len(), 2);
        assert_eq!(Path::parse("web.graph.outline[2]").0.len(), 4);
    }

    proptest::proptest! {
        #[test]
        fn no_text_panics(text in "\\PC*") {
            let _ = Path::parse(&text).to_string();
        }
    }
}
