//! The templates of `netcast init`: scenarios with comments to start from.

/// A scenario to start from, with the files that it names.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// Its name in `netcast init NAME`.
    pub kind: &'static str,
    /// What it contains, in one line.
    pub summary: &'static str,
    /// The scenario.
    pub scenario: &'static str,
    /// Name and text of each file that it names.
    pub files: &'static [(&'static str, &'static str)],
}

/// All templates, the default first.
pub const TEMPLATES: &[Template] = &[
    Template {
        kind: "space",
        summary: "the space web with canopies and payloads, thrown by six tractors",
        scenario: include_str!("../templates/space.toml"),
        files: &[],
    },
    Template {
        kind: "traditional",
        summary: "a hexagon of square cells, thrown by six tractors",
        scenario: include_str!("../templates/traditional.toml"),
        files: &[],
    },
    Template {
        kind: "topological",
        summary: "the lattice of the space web with a hexagon of rope at every knot",
        scenario: include_str!("../templates/topological.toml"),
        files: &[],
    },
    Template {
        kind: "square",
        summary: "a square net thrown by four corner masses",
        scenario: include_str!("../templates/square.toml"),
        files: &[],
    },
    Template {
        kind: "polygon",
        summary: "a regular octagon of parallels and radials, thrown by eight tractors",
        scenario: include_str!("../templates/polygon.toml"),
        files: &[],
    },
    Template {
        kind: "radial",
        summary: "radials and rings around an open hub, like a spider's web, thrown by six tractors",
        scenario: include_str!("../templates/radial.toml"),
        files: &[],
    },
    Template {
        kind: "diamond",
        summary: "a net of rhombic meshes in a border, thrown by four corner masses",
        scenario: include_str!("../templates/diamond.toml"),
        files: &[],
    },
    Template {
        kind: "graph",
        summary: "any net, from two CSV files",
        scenario: include_str!("../templates/graph.toml"),
        files: &[
            ("nodes.csv", include_str!("../templates/nodes.csv")),
            ("ropes.csv", include_str!("../templates/ropes.csv")),
        ],
    },
    Template {
        kind: "held",
        summary: "a square net held at its corners, sagging under gravity",
        scenario: include_str!("../templates/held.toml"),
        files: &[],
    },
];

/// The template of this kind.
pub fn template(kind: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.kind == kind)
}
