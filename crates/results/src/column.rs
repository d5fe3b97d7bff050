//! A column of `history.csv`: name, definition, and the function that reads its value from a record.

use crate::quantity::Dimension;

/// A column of the history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Name; `{}` stands for a point, a link class or an energy channel.
    pub name: &'static str,
    /// Kind of value, which gives the unit.
    pub dimension: Dimension,
    /// Definition, in a sentence.
    pub definition: &'static str,
    /// Title of its own figure in the report and name of its curve there; none for a column that shares a figure or
    /// has none.
    pub figure: Option<(&'static str, &'static str)>,
}

/// A column and the function that reads its value from a record of type `T`.
pub type ColumnOf<T> = (Column, fn(&T) -> Option<f64>);

impl Column {
    pub(crate) const fn new(name: &'static str, dimension: Dimension, definition: &'static str) -> Self {
        Self { name, dimension, definition, figure: None }
    }

    /// The same column with a figure of its own in the report.
    pub(crate) const fn drawn(self, title: &'static str, curve: &'static str) -> Self {
        Self { figure: Some((title, curve)), ..self }
    }

    /// Name for one point, link class or energy channel.
    pub fn name_of(&self, thing: &str) -> String {
        self.name.replace("{}", thing)
    }
}
