//! `[assign]`: the rope of each link of the web.
//!
//! A rope is given to a link class (`traction`), to a ring (`ring 2`, counted from the middle) or to a single link by
//! the name that messages use (`radial link 24-29, rope 1`; `radial link 24-29` is both its ropes). The narrower
//! assignment prevails. A row of a graph's file that names its rope prevails over all assignments. `netcast check --links`
//! lists the names.

use netcast_scenario::path::Path;
use netcast_scenario::{Diagnostic, Diagnostics, Document, Rope, RopeRow, Scenario, nearest};
use netcast_webs::{Class, Pieces, Rope as Link, Web};

use super::draft::Draft;

/// The name of the default rope.
const DEFAULT: &str = "rope";

/// The ropes of a scenario with their names, the default one last.
pub fn ropes(scenario: &Scenario) -> Vec<(&str, &Rope)> {
    let named = scenario.ropes.iter().map(|(name, rope)| (&name[..], rope));
    named.chain([(DEFAULT, &scenario.rope)]).collect()
}

/// The table of a rope, by its name.
pub fn table_of(name: &str) -> Path {
    match name {
        DEFAULT => Path::default().key(DEFAULT),
        name => Path::default().key("ropes").key(name),
    }
}

/// The file rows of a graph's ropes, in the order of its links; empty for any other web.
pub fn rows(document: &Document) -> &[RopeRow] {
    document.files.graph.as_ref().map_or(&[][..], |graph| &graph.ropes)
}

/// Gives each of the web's links its rope.
///
/// # Errors
/// Names in `[assign]` that the web does not have.
pub fn assign(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, notes, kinds, .. } = draft;
    let (web, rows, known) = (&cut.web, rows(document), ropes(scenario));
    let rings = rings(web);
    let names: Vec<[Option<String>; 3]> = web.ropes.iter().zip(&rings).map(|(link, ring)| names(link, *ring)).collect();
    unknown_names(document, scenario, web, &names)?;
    *kinds = web
        .ropes
        .iter()
        .zip(&names)
        .enumerate()
        .map(|(i, (link, names))| {
            let assigned = |name: &str| scenario.assign.get(name).map(|rope| &rope[..]);
            let of_row = rows.get(i).and_then(|row| row.rope.as_deref());
            let name = of_row
                .or_else(|| assigned(&link.label))
                .or_else(|| names.iter().flatten().find_map(|name| assigned(name)));
            let found = name.and_then(|name| known.iter().position(|(known, _)| *known == name));
            found.unwrap_or(known.len() - 1)
        })
        .collect();
    let idle = (0..scenario.ropes.len()).filter(|kind| !kinds.contains(kind));
    notes.extend(idle.map(|kind| format!("no link is made of [ropes.{}]", known[kind].0)));
    Ok(())
}

/// The names that a link shares with others, the narrowest first: its double link, its ring, its class.
fn names(link: &Link, ring: Option<usize>) -> [Option<String>; 3] {
    // "radial link 24-29, rope 1", "traction rope 2 (1 of 3)"
    let shared = link.label.find(", ").or_else(|| link.label.find(" ("));
    [
        shared.map(|end| link.label[..end].to_owned()),
        ring.map(|number| format!("ring {number}")),
        Some(link.class.name().to_owned()),
    ]
}

/// Reports names in `[assign]` that the web does not have.
fn unknown_names(
    document: &Document,
    scenario: &Scenario,
    web: &Web,
    names: &[[Option<String>; 3]],
) -> Result<(), Diagnostics> {
    let mut found = Vec::new();
    for name in scenario.assign.keys() {
        if named(web, names, name).next().is_none() {
            let path = Path::default().key("assign").key(name);
            found.push(unknown_link(document, &path, web, names, name));
        }
    }
    Diagnostics::fail_if_any(found)
}

/// The links that a name stands for: of one link, of a double link, of a ring or of a class.
fn named<'n>(web: &'n Web, names: &'n [[Option<String>; 3]], name: &'n str) -> impl Iterator<Item = usize> + 'n {
    let is_named = move |(link, others): (&Link, &[Option<String>; 3])| {
        link.label == name || others.iter().flatten().any(|other| other == name)
    };
    web.ropes.iter().zip(names).enumerate().filter(move |(_, link)| is_named(*link)).map(|(index, _)| index)
}

/// The links that `name` stands for at `path`, ascending.
///
/// # Errors
/// A name that the web does not have.
pub fn links_named(document: &Document, path: &Path, web: &Web, name: &str) -> Result<Vec<usize>, Diagnostic> {
    let names: Vec<_> = web.ropes.iter().zip(rings(web)).map(|(link, ring)| names(link, ring)).collect();
    let links: Vec<usize> = named(web, &names, name).collect();
    if links.is_empty() { Err(unknown_link(document, path, web, &names, name)) } else { Ok(links) }
}

/// The diagnostic that the web has no link, ring or class of a name, with the nearest name as help.
fn unknown_link(document: &Document, path: &Path, web: &Web, names: &[[Option<String>; 3]], name: &str) -> Diagnostic {
    let mut classes: Vec<&Class> = web.ropes.iter().map(|link| &link.class).collect();
    classes.sort();
    classes.dedup();
    let classes: Vec<&str> = classes.into_iter().map(Class::name).collect();
    let known = names.iter().flatten().flatten().map(String::as_str);
    let near = nearest(name, classes.iter().copied().chain(known).chain(web.ropes.iter().map(|l| &l.label[..])));
    let near = near.map_or(String::new(), |near| format!("did you mean {near:?}? "));
    let message = format!("this web has no link class {name:?}, nor a ring or link of that name");
    let help = format!("{near}it has: {}; `netcast check --links` lists every link", classes.join(", "));
    document.written.at_value(path, message).with_help(help)
}

/// The ring number of each link, from 1 in the middle, (links,); none for links of other classes. A ring is a connected
/// set of links of class `ring`; a canopy or a hexagon of rope counts as one knot.
pub fn rings(web: &Web) -> Vec<Option<usize>> {
    let mut pieces = Pieces::new(web.knots.len());
    for link in web.ropes.iter().filter(|link| matches!(link.class, Class::Ring | Class::Hexagon)) {
        pieces.join(link.a, link.b);
    }
    for canopy in &web.canopies {
        for &knot in &canopy.rim {
            pieces.join(canopy.hub, knot);
        }
    }
    // rings are sorted by the distance of their nearest knot; equal distances keep the order of the web
    let distance = |link: &Link| {
        let from_middle = |knot: usize| web.knots[knot].position.distance(web.middle);
        from_middle(link.a).min(from_middle(link.b))
    };
    let mut nearest_of: Vec<(usize, f64)> = Vec::new();
    let ring_of: Vec<Option<usize>> = web
        .ropes
        .iter()
        .map(|link| {
            let ring = (link.class == Class::Ring).then(|| pieces.root(link.a))?;
            match nearest_of.iter_mut().find(|(known, _)| *known == ring) {
                Some((_, nearest)) => *nearest = nearest.min(distance(link)),
                None => nearest_of.push((ring, distance(link))),
            }
            Some(ring)
        })
        .collect();
    nearest_of.sort_by(|(_, one), (_, other)| one.total_cmp(other));
    let number = |ring: usize| nearest_of.iter().position(|(known, _)| *known == ring).map(|place| place + 1);
    ring_of.into_iter().map(|ring| ring.and_then(number)).collect()
}
