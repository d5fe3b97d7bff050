//! The table of quantities: what each number of `summary.json` is called, its unit, what is wanted of it, what it is.
//!
//! A section of the summary is declared by [`section!`], a row a number: the same row makes the field of the struct,
//! hence the key of the file, and the row of this table. The report's tables, the rows of a comparison, the check of
//! reported numbers and the list in `docs/theory/measures.md` are made from it.

use serde::{Deserialize, Serialize};

/// What a net designer wants of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Better {
    /// The less, the better.
    Lower,
    /// The more, the better.
    Higher,
}

/// What kind of value a quantity has; its unit follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// A time since the start, or the length of a spell.
    Time,
    /// A length of time that may be very short or long.
    Duration,
    /// A length.
    Length,
    /// A place, x, y and z in the world frame.
    Place,
    /// An area.
    Area,
    /// A speed.
    Speed,
    /// A velocity, x, y and z in the world frame.
    Velocity,
    /// An angle.
    Angle,
    /// An angular speed.
    AngularSpeed,
    /// A mass.
    Mass,
    /// A density.
    Density,
    /// A force.
    Force,
    /// A force over time.
    Impulse,
    /// An energy.
    Energy,
    /// A stress.
    Stress,
    /// A dynamic viscosity.
    Viscosity,
    /// A change of length over the length at rest.
    Strain,
    /// A part of a whole, read as percent.
    Share,
    /// A small error over what it is an error of.
    Error,
    /// One value over another of its kind.
    Ratio,
    /// How many there are.
    Count,
    /// A text.
    Text,
    /// Yes or no.
    Truth,
}

impl Dimension {
    /// The unit of its values, as a scenario writes it; empty for what has none.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Time | Self::Duration => "s",
            Self::Length | Self::Place => "m",
            Self::Area => "m^2",
            Self::Speed | Self::Velocity => "m/s",
            Self::Angle => "rad",
            Self::AngularSpeed => "rad/s",
            Self::Mass => "kg",
            Self::Density => "kg/m^3",
            Self::Force => "N",
            Self::Impulse => "N s",
            Self::Energy => "J",
            Self::Stress => "Pa",
            Self::Viscosity => "Pa s",
            Self::Strain | Self::Share | Self::Error | Self::Ratio | Self::Count | Self::Text | Self::Truth => "",
        }
    }
}

/// A row of the table: a number, a text or a truth of `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Path of the object that it stands in, with dots; `*` for any name, such as that of a point.
    pub parent: &'static str,
    /// Its key there.
    pub key: &'static str,
    /// What it is called; `{}` stands for the name at `*`.
    pub name: &'static str,
    /// What kind of value it has.
    pub dimension: Dimension,
    /// What is wanted of it; none where neither is better as such.
    pub better: Option<Better>,
    /// Whether it is one of those that a designer looks for first.
    pub headline: bool,
    /// Whether the report's tables show it; others are told in sentences or pictures.
    pub in_table: bool,
    /// Whether the key holds an object of such values by name.
    pub by_name: bool,
    /// What it is, in a sentence.
    definition: &'static str,
}

impl Quantity {
    pub(crate) const fn new(
        parent: &'static str,
        key: &'static str,
        name: &'static str,
        dimension: Dimension,
        definition: &'static str,
    ) -> Self {
        let (better, headline, in_table, by_name) = (None, false, true, false);
        Self { parent, key, name, dimension, better, headline, in_table, by_name, definition }
    }

    pub(crate) const fn lower(self) -> Self {
        Self { better: Some(Better::Lower), ..self }
    }

    pub(crate) const fn higher(self) -> Self {
        Self { better: Some(Better::Higher), ..self }
    }

    pub(crate) const fn headline(self) -> Self {
        Self { headline: true, ..self }
    }

    pub(crate) const fn not_in_table(self) -> Self {
        Self { in_table: false, ..self }
    }

    pub(crate) const fn by_name(self) -> Self {
        Self { by_name: true, ..self }
    }

    /// What it is, in a sentence or two.
    pub fn definition(&self) -> &'static str {
        self.definition.trim_start()
    }

    /// Its path in `summary.json`, with dots; `*` for any name.
    pub fn path(&self) -> String {
        let of_each = if self.by_name { ".*" } else { "" };
        let dot = if self.parent.is_empty() { "" } else { "." };
        format!("{}{dot}{}{of_each}", self.parent, self.key)
    }

    /// The section of the summary that it belongs to: the first key of its path.
    pub fn section(&self) -> &'static str {
        let path = if self.parent.is_empty() { self.key } else { self.parent };
        path.split_once('.').map_or(path, |(section, _)| section)
    }

    /// Its name for one of the things at `*`.
    pub fn name_of(&self, thing: &str) -> String {
        self.name.replace("{}", thing)
    }

    /// Its name where the things at `*` have a row each and it has a column.
    pub fn head(&self) -> String {
        let things = [", rope `{}`,", ", rope `{}`", ", {},", ", {}", " of {}"];
        things.iter().fold(self.name.to_owned(), |name, thing| name.replace(thing, ""))
    }
}

/// Declares a section of the summary: a struct with a field a quantity, in the order of the file, and its rows of the
/// table as `QUANTITIES`. A row is the definition, the field, the name, the dimension, and what else is to be said of it:
/// `lower` or `higher` is better, `headline`, `not_in_table`, `by_name`. Fields after `parts:` are sections of their own.
macro_rules! section {
    (
        $(#[doc = $about:literal])+
        $section:ident, $parent:literal {
            $(
                $(#[doc = $definition:literal])+
                $(#[serde($($serde:tt)+)])?
                $field:ident: $type:ty => $name:literal, $dimension:ident $(, $more:ident)*;
            )+
            $(parts: $( $(#[doc = $part_about:literal])+ $part:ident: $part_type:ty; )+)?
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
        #[serde(default)]
        pub struct $section {
            $( $(#[doc = $definition])+ $(#[serde($($serde)+)])? pub $field: $type, )+
            $( $( $(#[doc = $part_about])+ pub $part: $part_type, )+ )?
        }

        impl $section {
            /// Its rows of the table of quantities.
            pub const QUANTITIES: &'static [$crate::quantity::Quantity] = &[
                $(
                    $crate::quantity::Quantity::new(
                        $parent,
                        stringify!($field),
                        $name,
                        $crate::quantity::Dimension::$dimension,
                        concat!($($definition),+),
                    )
                    $(.$more())*,
                )+
            ];
        }
    };
}
pub(crate) use section;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_is_headed_by_the_name_without_the_thing() {
        let head = |name: &'static str| Quantity::new("a.*", "b", name, Dimension::Force, "").head();
        assert_eq!(head("Peak speed of {} at"), "Peak speed at");
        assert_eq!(head("Highest tension, {}"), "Highest tension");
        assert_eq!(head("Highest tension, rope `{}`, in"), "Highest tension in");
    }

    #[test]
    fn paths_name_the_section_and_what_is_held_by_name() {
        let one = Quantity::new("tension.by_class.*", "max_n", "", Dimension::Force, "");
        assert_eq!((one.path().as_str(), one.section()), ("tension.by_class.*.max_n", "tension"));
        let channel = Quantity::new("energy", "channels", "", Dimension::Energy, "").by_name();
        assert_eq!(channel.path(), "energy.channels.*");
        let clock = Quantity::new("", "wall_time_s", "", Dimension::Duration, "");
        assert_eq!((clock.path().as_str(), clock.section()), ("wall_time_s", "wall_time_s"));
    }
}
