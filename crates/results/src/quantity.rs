//! The table of quantities: name, unit, direction of better and definition of each number of `summary.json`.
//!
//! [`section!`] declares a section of the summary, with one row for each number. The row makes the field of the
//! struct, hence the key of the file, and the row of the table. The report's tables, the rows of a comparison, the
//! check of reported numbers and the list in `docs/theory/measures.md` are made from the table.

use serde::{Deserialize, Serialize};

/// The direction in which a quantity is better for a net designer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Better {
    /// A lower value is better.
    Lower,
    /// A higher value is better.
    Higher,
}

/// The kind of value of a quantity, which gives its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// A time since the start of the run, or the length of a spell.
    Time,
    /// A duration that may be very short or very long.
    Duration,
    /// A length.
    Length,
    /// A position: x, y and z in the world frame.
    Place,
    /// An area.
    Area,
    /// A speed.
    Speed,
    /// A velocity: x, y and z in the world frame.
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
    /// An impulse: the integral of a force over time.
    Impulse,
    /// An energy.
    Energy,
    /// A stress.
    Stress,
    /// A dynamic viscosity.
    Viscosity,
    /// A strain: change of length over rest length.
    Strain,
    /// A part of a whole, shown in percent.
    Share,
    /// A small relative error.
    Error,
    /// A ratio of two values of one kind.
    Ratio,
    /// A number of things.
    Count,
    /// A text.
    Text,
    /// Yes or no.
    Truth,
}

impl Dimension {
    /// The unit as a scenario writes it; empty for a dimension without a unit.
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

/// A row of the table of quantities: a number, a text or a yes-or-no of `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Path of the JSON object that holds it, with dots; `*` stands for any name, such as that of a point.
    pub parent: &'static str,
    /// Key in that object.
    pub key: &'static str,
    /// Name for the reader; `{}` stands for the name at `*`.
    pub name: &'static str,
    /// Kind of value, which gives the unit.
    pub dimension: Dimension,
    /// Direction of better; none where neither direction is better.
    pub better: Option<Better>,
    /// Whether a designer looks for it first.
    pub headline: bool,
    /// Whether the report's tables show it; the report gives the others in sentences or pictures.
    pub in_table: bool,
    /// Whether the key holds an object with one such value for each name.
    pub by_name: bool,
    /// Definition, in a sentence.
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

    /// Definition, in a sentence or two.
    pub fn definition(&self) -> &'static str {
        self.definition.trim_start()
    }

    /// Path in `summary.json`, with dots; `*` stands for any name.
    pub fn path(&self) -> String {
        let any_name = if self.by_name { ".*" } else { "" };
        let dot = if self.parent.is_empty() { "" } else { "." };
        format!("{}{dot}{}{any_name}", self.parent, self.key)
    }

    /// The section of the summary that holds it: the first key of its path.
    pub fn section(&self) -> &'static str {
        let path = if self.parent.is_empty() { self.key } else { self.parent };
        path.split_once('.').map_or(path, |(section, _)| section)
    }

    /// Name for the reader, with the name `thing` at `*`.
    pub fn name_of(&self, thing: &str) -> String {
        self.name.replace("{}", thing)
    }

    /// Heading of its column in a table with one row for each name at `*`.
    pub fn head(&self) -> String {
        let things = [", rope `{}`,", ", rope `{}`", ", {},", ", {}", " of {}"];
        things.iter().fold(self.name.to_owned(), |name, thing| name.replace(thing, ""))
    }
}

/// Declares a section of the summary: a struct with one field for each quantity, in the order of the file, and the
/// section's rows of the table as `QUANTITIES`. A row gives definition, field, type, name and dimension, then any of
/// `lower` or `higher` (the direction of better), `headline`, `not_in_table`, `by_name`. Fields after `parts:` are
/// sections of their own.
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
            /// Rows of this section in the table of quantities.
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
    fn the_head_of_a_column_is_the_name_without_the_placeholder() {
        let head = |name: &'static str| Quantity::new("a.*", "b", name, Dimension::Force, "").head();
        assert_eq!(head("Peak speed of {} at"), "Peak speed at");
        assert_eq!(head("Highest tension, {}"), "Highest tension");
        assert_eq!(head("Highest tension, rope `{}`, in"), "Highest tension in");
    }

    #[test]
    fn a_path_starts_with_its_section_and_has_a_star_for_each_name() {
        let one = Quantity::new("tension.by_class.*", "max_n", "", Dimension::Force, "");
        assert_eq!((one.path().as_str(), one.section()), ("tension.by_class.*.max_n", "tension"));
        let channel = Quantity::new("energy", "channels", "", Dimension::Energy, "").by_name();
        assert_eq!(channel.path(), "energy.channels.*");
        let clock = Quantity::new("", "wall_time_s", "", Dimension::Duration, "");
        assert_eq!((clock.path().as_str(), clock.section()), ("wall_time_s", "wall_time_s"));
    }
}
