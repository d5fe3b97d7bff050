//! The list of ropes while a web is drawn: each new rope gets the next number in its class.

use std::collections::BTreeMap;

use crate::{Class, Rope};

/// A growing list of ropes.
#[derive(Default)]
pub(crate) struct RopeList {
    ropes: Vec<Rope>,
    /// Number of ropes so far.
    count: BTreeMap<Class, usize>,
}

impl RopeList {
    /// Adds a rope. Its label is its class and its number in the class, as in "radial rope 7".
    pub(crate) fn tie(&mut self, a: usize, b: usize, class: Class) {
        let number = self.count.entry(class.clone()).or_insert(0);
        *number += 1;
        let label = format!("{class} rope {number}");
        self.ropes.push(Rope { a, b, class, label, rest_length: None, segments: None });
    }

    /// Adds a rope from each of these knots to the next.
    pub(crate) fn tie_along(&mut self, knots: &[usize], class: Class) {
        for pair in knots.windows(2) {
            self.tie(pair[0], pair[1], class.clone());
        }
    }

    /// The ropes in the order in which they were tied.
    pub(crate) fn into_ropes(self) -> Vec<Rope> {
        self.ropes
    }
}
