//! The nodes and ropes of a net that is built in code: the rows of the files of `[web.graph]`.

use std::fmt::Write;

/// A node of a net built in code.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    id: String,
    position_m: [f64; 3],
    mass_kg: f64,
    is_fixed: bool,
    velocity_m_s: [f64; 3],
}

/// A rope between two nodes of a net built in code.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    ends: [String; 2],
    rope: Option<String>,
    class: Option<String>,
    rest_length_m: Option<f64>,
    pretension_n: Option<f64>,
    segments: Option<u32>,
}

impl Node {
    /// A node of this id at x, y, z, m.
    pub fn at(id: impl Into<String>, position_m: [f64; 3]) -> Self {
        Self { id: id.into(), position_m, mass_kg: 0.0, is_fixed: false, velocity_m_s: [0.0; 3] }
    }

    /// Ties a mass to it, kg, beside that of its ropes.
    #[must_use]
    pub fn mass(self, mass_kg: f64) -> Self {
        Self { mass_kg, ..self }
    }

    /// Lets it stay put.
    #[must_use]
    pub fn fixed(self) -> Self {
        Self { is_fixed: true, ..self }
    }

    /// Its velocity at the start, m/s.
    #[must_use]
    pub fn velocity(self, velocity_m_s: [f64; 3]) -> Self {
        Self { velocity_m_s, ..self }
    }
}

impl Link {
    /// A rope between the nodes of these ids, as long as they are apart.
    pub fn between(a: impl Into<String>, b: impl Into<String>) -> Self {
        let (rope, class, rest_length_m, pretension_n, segments) = Default::default();
        Self { ends: [a.into(), b.into()], rope, class, rest_length_m, pretension_n, segments }
    }

    /// Makes it of the rope of this name among the other ropes of the case.
    #[must_use]
    pub fn rope(self, name: impl Into<String>) -> Self {
        Self { rope: Some(name.into()), ..self }
    }

    /// Its link class.
    #[must_use]
    pub fn class(self, class: impl Into<String>) -> Self {
        Self { class: Some(class.into()), ..self }
    }

    /// Its length without tension, m.
    #[must_use]
    pub fn rest_length(self, length_m: f64) -> Self {
        Self { rest_length_m: Some(length_m), ..self }
    }

    /// Its tension as drawn, N.
    #[must_use]
    pub fn pretension(self, tension_n: f64) -> Self {
        Self { pretension_n: Some(tension_n), ..self }
    }

    /// Into how many segments it is cut.
    #[must_use]
    pub fn segments(self, count: u32) -> Self {
        Self { segments: Some(count), ..self }
    }
}

/// The nodes as the text of a CSV file; numbers are the shortest decimals that read back to the same bits.
pub(crate) fn csv_of_nodes(nodes: impl IntoIterator<Item = Node>) -> String {
    let mut text = "id,x,y,z,mass,fixed,vx,vy,vz\n".to_owned();
    for Node { id, position_m: [x, y, z], mass_kg, is_fixed, velocity_m_s: [vx, vy, vz] } in nodes {
        let (id, fixed) = (quoted(&id), u8::from(is_fixed));
        writeln!(text, "{id},{x:?},{y:?},{z:?},{mass_kg:?},{fixed},{vx:?},{vy:?},{vz:?}").expect("a text grows");
    }
    text
}

/// The ropes as the text of a CSV file.
pub(crate) fn csv_of_links(links: impl IntoIterator<Item = Link>) -> String {
    let mut text = "a,b,rope,class,rest_length,pretension,segments\n".to_owned();
    let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:?}"));
    for Link { ends: [a, b], rope, class, rest_length_m, pretension_n, segments } in links {
        let [rope, class] = [rope, class].map(|name| quoted(&name.unwrap_or_default()));
        let segments = segments.map_or(String::new(), |count| count.to_string());
        let (length, tension) = (number(rest_length_m), number(pretension_n));
        writeln!(text, "{},{},{rope},{class},{length},{tension},{segments}", quoted(&a), quoted(&b))
            .expect("a text grows");
    }
    text
}

/// A cell as CSV has it.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.to_owned() }
}
