//! The nodes and ropes of a net that is built in code. They become the rows of the files of `[web.graph]`.

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
    /// A node with an id at x, y, z, m.
    pub fn at(id: impl Into<String>, position_m: [f64; 3]) -> Self {
        Self { id: id.into(), position_m, mass_kg: 0.0, is_fixed: false, velocity_m_s: [0.0; 3] }
    }

    /// Adds a mass, kg, to that of its ropes.
    #[must_use]
    pub fn mass(self, mass_kg: f64) -> Self {
        Self { mass_kg, ..self }
    }

    /// Fixes its position.
    #[must_use]
    pub fn fixed(self) -> Self {
        Self { is_fixed: true, ..self }
    }

    /// Sets its velocity at the start, m/s.
    #[must_use]
    pub fn velocity(self, velocity_m_s: [f64; 3]) -> Self {
        Self { velocity_m_s, ..self }
    }
}

impl Link {
    /// A rope between the nodes with the ids `a` and `b`. Its rest length is their distance.
    pub fn between(a: impl Into<String>, b: impl Into<String>) -> Self {
        Self {
            ends: [a.into(), b.into()],
            rope: None,
            class: None,
            rest_length_m: None,
            pretension_n: None,
            segments: None,
        }
    }

    /// Makes it of the other rope of the case with this name.
    #[must_use]
    pub fn rope(self, name: impl Into<String>) -> Self {
        Self { rope: Some(name.into()), ..self }
    }

    /// Sets its link class.
    #[must_use]
    pub fn class(self, class: impl Into<String>) -> Self {
        Self { class: Some(class.into()), ..self }
    }

    /// Sets its rest length, m; not beside a tension as drawn.
    #[must_use]
    pub fn rest_length(self, length_m: f64) -> Self {
        Self { rest_length_m: Some(length_m), ..self }
    }

    /// Sets its tension as drawn, N; not beside a rest length.
    #[must_use]
    pub fn pretension(self, tension_n: f64) -> Self {
        Self { pretension_n: Some(tension_n), ..self }
    }

    /// Sets the number of its segments.
    #[must_use]
    pub fn segments(self, count: u32) -> Self {
        Self { segments: Some(count), ..self }
    }
}

/// The nodes as the text of a CSV file. A number is the shortest decimal that reads back to the same bits.
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

/// A CSV cell, in quotes where it needs them.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.to_owned() }
}
