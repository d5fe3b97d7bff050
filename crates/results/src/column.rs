//! A column of `history.csv`: its name, what it holds, and how a record's value is found.

use crate::quantity::Dimension;

/// A column of the history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Its name; `{}` stands for the point, link class or energy channel that it is of.
    pub name: &'static str,
    /// What kind of value it holds.
    pub dimension: Dimension,
    /// What it holds, in a sentence.
    pub definition: &'static str,
    /// Title of its figure in the report and name of its curve there; none where it shares a figure with others or has
    /// none.
    pub figure: Option<(&'static str, &'static str)>,
}

/// A column with its value in a record of what it is of.
pub type ColumnOf<T> = (Column, fn(&T) -> Option<f64>);

impl Column {
    pub(crate) const fn new(name: &'static str, dimension: Dimension, definition: &'static str) -> Self {
        Self { name, dimension, definition, figure: None }
    }

    /// With a figure of its own in the report.
    pub(crate) const fn drawn(self, title: &'static str, curve: &'static str) -> Self {
        Self { figure: Some((title, curve)), ..self }
    }

    /// Its name for one of the things that it is of.
    pub fn name_of(&self, thing: &str) -> String {
        self.name.replace("{}", thing)
    }
}
