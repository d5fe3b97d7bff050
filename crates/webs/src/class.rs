//! Link classes: the names under which tensions and lengths of ropes are reported.

use std::fmt;

/// The class of a rope. Results list classes in this order.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// From a corner of the web to its tractor.
    Traction,
    /// Along the outline.
    Outline,
    /// A second rope along the outline: the drawstring of a purse.
    Gathering,
    /// Along a closed line round the centre, inside the outline.
    Ring,
    /// On a straight line through the centre.
    Radial,
    /// Any other rope inside the outline.
    Inner,
    /// A side of a rope hexagon, which stands in the place of a canopy.
    Hexagon,
    /// A member that stands for a canopy's fabric. A model of canopies has such members, a [`crate::Web`] never.
    Canopy,
    /// A thread that holds a node in its stowed place until the thread breaks; not part of a [`crate::Web`].
    Tie,
    /// A thread that holds two folds together until the thread breaks; not part of a [`crate::Web`].
    Stitch,
    /// A class that the user named.
    Named(String),
}

impl Class {
    /// The class of ropes with this name: a built-in class in upper or lower case, else [`Class::Named`] with the
    /// trimmed name. None if the name belongs to a class without ropes.
    pub fn from_name(name: &str) -> Option<Class> {
        let built_in = [
            Class::Traction,
            Class::Outline,
            Class::Gathering,
            Class::Ring,
            Class::Radial,
            Class::Inner,
            Class::Hexagon,
            Class::Canopy,
            Class::Tie,
            Class::Stitch,
        ];
        let name = name.trim();
        let known = built_in.into_iter().find(|class| class.name().eq_ignore_ascii_case(name));
        Some(known.unwrap_or_else(|| Class::Named(name.to_owned()))).filter(Class::is_rope)
    }

    /// The class's name: a built-in name in lower case, a user's name as given.
    pub fn name(&self) -> &str {
        match self {
            Class::Traction => "traction",
            Class::Outline => "outline",
            Class::Gathering => "gathering",
            Class::Ring => "ring",
            Class::Radial => "radial",
            Class::Inner => "inner",
            Class::Hexagon => "hexagon",
            Class::Canopy => "canopy",
            Class::Tie => "tie",
            Class::Stitch => "stitch",
            Class::Named(name) => name,
        }
    }

    /// Whether its members are ropes.
    pub fn is_rope(&self) -> bool {
        !matches!(self, Class::Canopy | Class::Tie | Class::Stitch)
    }

    /// Whether its members are meant to break.
    pub fn is_made_to_break(&self) -> bool {
        matches!(self, Class::Tie | Class::Stitch)
    }
}

impl fmt::Display for Class {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_class_of_ropes_is_found_by_its_name() {
        assert_eq!(Class::from_name("radial"), Some(Class::Radial));
        assert_eq!(Class::from_name(" Traction "), Some(Class::Traction));
        assert_eq!(Class::from_name("Edge cord"), Some(Class::Named("Edge cord".into())));
        assert_eq!(Class::from_name("hexagon").unwrap().to_string(), "hexagon");
    }

    #[test]
    fn classes_without_ropes_are_not_found_by_their_name() {
        for name in ["canopy", "Tie", " stitch"] {
            assert_eq!(Class::from_name(name), None, "{name}");
        }
    }

    #[test]
    fn classes_are_listed_from_the_traction_ropes_inwards() {
        assert!(Class::Traction < Class::Outline && Class::Outline < Class::Ring && Class::Ring < Class::Radial);
        assert!(Class::Canopy < Class::Named(String::new()));
    }
}
