//! The tables of a scenario, built in code.
//!
//! A number is SI, a text carries its unit: `5.0` and `"5 m"` mean the same. Keys have the scenario's names and
//! defaults. Nothing is checked here: `build` checks the whole case.

use toml::{Table, Value};

use crate::net::{Link, Node, csv_of_links, csv_of_nodes};

/// A table of a scenario; with a variant, such as `square` in `[web.square]`, it lies within a table of that name.
#[derive(Debug, Clone, PartialEq)]
struct Section {
    variant: Option<&'static str>,
    keys: Table,
}

impl Section {
    fn new(variant: Option<&'static str>) -> Self {
        Self { variant, keys: Table::new() }
    }

    fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.keys.insert(key.to_owned(), value.into());
        self
    }

    fn into_value(self) -> Value {
        match self.variant {
            Some(variant) => Value::Table(Table::from_iter([(variant.to_owned(), Value::Table(self.keys))])),
            None => Value::Table(self.keys),
        }
    }
}

/// Defines a type for a table, so that a rope cannot be passed as a launch.
macro_rules! section {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name(Section);

        impl $name {
            /// Sets a key of this table by its name in the scenario: a number in SI, or a text with its unit.
            #[must_use]
            pub fn set(self, key: &str, value: impl Into<Value>) -> Self {
                Self(self.0.with(key, value))
            }
        }

        impl From<$name> for Value {
            fn from(section: $name) -> Value {
                section.0.into_value()
            }
        }
    };
}

/// `[web.KIND]` built in code: the net that is thrown, with the nodes and ropes of a graph.
#[derive(Debug, Clone, PartialEq)]
pub struct Web {
    section: Section,
    files: Vec<(&'static str, String)>,
}

section! {
    /// `[rope]` or `[ropes.NAME]`, built in code: a rope of the web.
    Rope
}

section! {
    /// `[tractor.SHAPE]`, `[payload.SHAPE]` or `[sensor.SHAPE]`, built in code: a solid body.
    Body
}

section! {
    /// `[stow.PATTERN]`, built in code: how the web is packed.
    Stow
}

section! {
    /// `[launch]`, built in code: how the tractors are thrown.
    Launch
}

/// The files of a graph, as its scenario names them.
const NODES: &str = "nodes.csv";
const ROPES: &str = "ropes.csv";

impl Web {
    fn kind(kind: &'static str) -> Self {
        Self { section: Section::new(Some(kind)), files: Vec::new() }
    }

    /// Sets a key of this table by its name in the scenario: a number in SI, or a text with its unit.
    #[must_use]
    pub fn set(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.section = self.section.with(key, value);
        self
    }

    /// A hexagon with this side, m, filled with square cells of rope.
    pub fn traditional(side_m: impl Into<Value>) -> Self {
        Self::kind("traditional").set("side", side_m)
    }

    /// A hexagon with this side, m, and a closed hexagon of rope at every knot.
    pub fn topological(side_m: impl Into<Value>) -> Self {
        Self::kind("topological").set("side", side_m)
    }

    /// A hexagon with this side, m, double links, and a canopy at every knot but the corners.
    pub fn space(side_m: impl Into<Value>) -> Self {
        Self::kind("space").set("side", side_m)
    }

    /// A square net with this side and this mesh side, m.
    pub fn square(side_m: impl Into<Value>, mesh_m: impl Into<Value>) -> Self {
        Self::kind("square").set("side", side_m).set("mesh", mesh_m)
    }

    /// A regular polygon with `sides` sides in a circle of this diameter, m, filled with radials and with parallels of
    /// its sides at the distance `mesh_m`.
    pub fn polygon(sides: u32, diameter_m: impl Into<Value>, mesh_m: impl Into<Value>) -> Self {
        Self::kind("polygon").set("sides", sides).set("diameter", diameter_m).set("mesh", mesh_m)
    }

    /// A circle of this diameter, m, filled with radials and rings.
    pub fn radial(diameter_m: impl Into<Value>, radials: u32, rings: u32) -> Self {
        Self::kind("radial").set("diameter", diameter_m).set("radials", radials).set("rings", rings)
    }

    /// A net of rhombic meshes with this side, m, in a rectangular border. It is `meshes_wide` by `meshes_high` meshes.
    pub fn diamond(mesh_m: impl Into<Value>, meshes_wide: u32, meshes_high: u32) -> Self {
        Self::kind("diamond").set("mesh", mesh_m).set("meshes_wide", meshes_wide).set("meshes_high", meshes_high)
    }

    /// Any net, given by its nodes and the ropes between them. They become the files `nodes.csv` and `ropes.csv` of the
    /// scenario; messages name these files.
    pub fn graph(nodes: impl IntoIterator<Item = Node>, ropes: impl IntoIterator<Item = Link>) -> Self {
        let files = vec![(NODES, csv_of_nodes(nodes)), (ROPES, csv_of_links(ropes))];
        Self { files, ..Self::kind("graph").set("nodes", NODES).set("ropes", ROPES) }
    }

    /// Its table, and names and texts of the files that the table names.
    pub(crate) fn into_parts(self) -> (Value, Vec<(&'static str, String)>) {
        (self.section.into_value(), self.files)
    }
}

impl Rope {
    /// A rope of this diameter, m, density over its nominal section, kg/m^3, and elastic modulus on it, Pa.
    pub fn new(
        diameter_m: impl Into<Value>,
        density_kg_m3: impl Into<Value>,
        elastic_modulus_pa: impl Into<Value>,
    ) -> Self {
        let rope = Self(Section::new(None)).set("diameter", diameter_m);
        rope.set("density", density_kg_m3).set("elastic_modulus", elastic_modulus_pa)
    }

    /// A rope with this diameter, m, of a material of the library.
    pub fn of(material: &str, diameter_m: impl Into<Value>) -> Self {
        Self(Section::new(None)).set("material", material).set("diameter", diameter_m)
    }

    /// Sets its damping ratio.
    #[must_use]
    pub fn damping_ratio(self, ratio: impl Into<Value>) -> Self {
        self.set("damping_ratio", ratio)
    }

    /// Sets its damping by a time, s: the damping stress is elastic modulus times this time times strain rate.
    #[must_use]
    pub fn damping_time(self, time_s: impl Into<Value>) -> Self {
        self.set("damping_time", time_s)
    }

    /// Sets its strength, N. The margin is strength over tension.
    #[must_use]
    pub fn strength(self, load_n: impl Into<Value>) -> Self {
        self.set("strength", load_n)
    }

    /// Sets its tension as the web is drawn, N.
    #[must_use]
    pub fn pretension(self, tension_n: impl Into<Value>) -> Self {
        self.set("pretension", tension_n)
    }
}

impl Body {
    /// A body of this mass, kg, without size.
    pub fn particle(mass_kg: impl Into<Value>) -> Self {
        Self(Section::new(Some("particle"))).set("mass", mass_kg)
    }

    /// A solid cylinder of this diameter and height, m.
    pub fn cylinder(diameter_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self(Section::new(Some("cylinder"))).set("diameter", diameter_m).set("height", height_m)
    }

    /// A solid sphere of this diameter, m.
    pub fn sphere(diameter_m: impl Into<Value>) -> Self {
        Self(Section::new(Some("sphere"))).set("diameter", diameter_m)
    }

    /// A solid box of this width, depth and height along its axes x, y, z, m.
    pub fn cuboid(width_m: impl Into<Value>, depth_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self(Section::new(Some("box"))).set("width", width_m).set("depth", depth_m).set("height", height_m)
    }

    /// Sets its mass, kg, instead of its density.
    #[must_use]
    pub fn mass(self, mass_kg: impl Into<Value>) -> Self {
        self.set("mass", mass_kg)
    }
}

impl Stow {
    /// The flat web scaled by this factor about its centre.
    pub fn scale(factor: impl Into<Value>) -> Self {
        Self(Section::new(Some("scale"))).set("factor", factor)
    }

    /// The web gathered into a bag of this radius, m.
    pub fn bag(radius_m: impl Into<Value>) -> Self {
        Self(Section::new(Some("bag"))).set("radius", radius_m)
    }

    /// An accordion in a cylinder of this radius and height, m.
    pub fn zigzag(radius_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self::folded("zigzag", radius_m, height_m)
    }

    /// Radial folds wound round the middle, in a cylinder of this radius and height, m.
    pub fn star(radius_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self::folded("star", radius_m, height_m)
    }

    /// A band of upright layers, rolled up, in a cylinder of this radius and height, m.
    pub fn roll(radius_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self::folded("roll", radius_m, height_m)
    }

    /// A stack of flat layers, in a cylinder of this radius and height, m.
    pub fn layers(radius_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        Self::folded("layers", radius_m, height_m)
    }

    fn folded(pattern: &'static str, radius_m: impl Into<Value>, height_m: impl Into<Value>) -> Self {
        let cylinder = Section::new(Some("cylinder")).with("radius", radius_m).with("height", height_m);
        Self(Section::new(Some(pattern))).set("container", cylinder.into_value())
    }
}

impl Launch {
    /// Throws the tractors at these speeds along the launch axis and away from it, m/s.
    pub fn new(axial_speed_m_s: impl Into<Value>, radial_speed_m_s: impl Into<Value>) -> Self {
        Self(Section::new(None)).set("axial_speed", axial_speed_m_s).set("radial_speed", radial_speed_m_s)
    }

    /// Sets the elevation of the launch axis above the horizontal, rad.
    #[must_use]
    pub fn elevation(self, elevation_rad: impl Into<Value>) -> Self {
        self.set("elevation", elevation_rad)
    }

    /// Sets the azimuth of the launch axis, anticlockwise from x, rad.
    #[must_use]
    pub fn azimuth(self, azimuth_rad: impl Into<Value>) -> Self {
        self.set("azimuth", azimuth_rad)
    }

    /// Sets the spin of all that is launched about the launch axis, rad/s.
    #[must_use]
    pub fn spin(self, spin_rad_s: impl Into<Value>) -> Self {
        self.set("spin", spin_rad_s)
    }
}
