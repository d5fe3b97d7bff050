//! `[assign]`: ropes for link classes, rings, single links and rows of a graph's file. The narrower assignment prevails.

mod common;

use std::collections::BTreeMap;

use common::parse;
use netcast_model::{Link, Model};
use netcast_scenario::{Diagnostics, Document};

const ROPES: &str = "\
[rope]
material = \"polyester rope\"
diameter = \"6 mm\"
[ropes.thick]
material = \"polyester rope\"
diameter = \"8 mm\"
[ropes.thin]
material = \"UHMWPE rope\"
diameter = \"3 mm\"
[solve]
duration = 0.1
";

fn model(web: &str, assign: &str) -> Model {
    let document = parse(&format!("{ROPES}{web}[assign]\n{assign}"), &[]).unwrap_or_else(|wrong| panic!("{wrong}"));
    Model::new(&document).unwrap_or_else(|wrong| panic!("{wrong}"))
}

fn refused(web: &str, assign: &str) -> Vec<String> {
    let document = parse(&format!("{ROPES}{web}[assign]\n{assign}"), &[]).unwrap_or_else(|wrong| panic!("{wrong}"));
    let Diagnostics(found) = Model::new(&document).unwrap_err();
    found.iter().map(ToString::to_string).collect()
}

/// Number of links of each rope.
fn counts(links: &[Link]) -> BTreeMap<&str, usize> {
    let mut counts = BTreeMap::new();
    for link in links {
        *counts.entry(link.rope.as_str()).or_insert(0) += 1;
    }
    counts
}

fn rope_of<'l>(links: &'l [Link], name: &str) -> &'l str {
    &links.iter().find(|link| link.name == name).unwrap_or_else(|| panic!("{name}")).rope
}

const SPACE: &str = "[web.space]\nside = 2.5\n[traction_rope]\nlength = 1\ncount = 2\n";

/// Hexagons of 6 and 12 double links round the middle; the third hexagon is the outline.
#[test]
fn rings_are_counted_from_the_middle() {
    for web in [SPACE, "[web.topological]\nside = 2.5\n"] {
        let model = model(web, "");
        let ring = |number| model.links().iter().filter(|link| link.ring == Some(number)).count();
        assert_eq!((ring(1), ring(2), ring(3)), (12, 24, 0), "{web}");
    }
}

#[test]
fn a_link_prevails_over_its_ring_and_a_ring_over_its_class() {
    let links = model(SPACE, "ring = \"thick\"\n\"ring 1\" = \"thin\"\n").links();
    assert_eq!(counts(&links), BTreeMap::from([("rope", 180 - 36 + 12), ("thick", 24), ("thin", 12)]));

    let one = links.iter().find(|link| link.ring == Some(1)).unwrap().name.clone();
    let links = model(SPACE, &format!("\"ring 1\" = \"thin\"\n{one:?} = \"thick\"\n")).links();
    assert_eq!(counts(&links), BTreeMap::from([("rope", 180 + 12 - 12), ("thick", 1), ("thin", 11)]));
    assert_eq!(rope_of(&links, &one), "thick");

    // both ropes of a link, both strands of a traction rope
    let both = one.split(", ").next().unwrap();
    let links = model(SPACE, &format!("{both:?} = \"thick\"\n\"traction rope 2\" = \"thin\"\n")).links();
    assert_eq!(counts(&links), BTreeMap::from([("rope", 180 + 12 - 4), ("thick", 2), ("thin", 2)]));
    assert_eq!(rope_of(&links, "traction rope 2 (2 of 2)"), "thin");
}

#[test]
fn a_link_has_the_mass_and_stiffness_of_its_assigned_rope() {
    let model = model("[web.square]\nside = 2\nmesh = 1\n[hold]\ncorners = true\n", "\"inner rope 2\" = \"thin\"\n");
    let kinds: Vec<(&str, f64)> = model.bill.ropes.iter().map(|kind| (&kind.name[..], kind.length)).collect();
    assert_eq!(kinds, [("rope", 11.0), ("thin", 1.0)]);
    let group = model.groups.iter().position(|group| group.rope.as_deref() == Some("thin")).unwrap();
    let area = 0.25 * std::f64::consts::PI * 9e-6;
    for segment in model.system.segments().iter().filter(|segment| segment.group == group) {
        let expected = 41.4e9 * area / segment.rest_length;
        assert!((segment.stiffness / expected - 1.0).abs() < 1e-12, "{} N/m, not {expected}", segment.stiffness);
    }
    assert_eq!(model.groups[group].strength, Some(5220.0));
}

const SQUARE: &str = "[web.square]\nside = 2\nmesh = 0.5\n";

#[test]
fn an_unknown_name_is_reported_with_the_nearest_known_one() {
    let found = refused(SQUARE, "outlin = \"thick\"\n\"inner rope 99\" = \"thin\"\n");
    assert_eq!(found.len(), 2, "{found:#?}");
    assert!(found[0].contains("assign.outlin: this web has no link class \"outlin\", nor a ring or link of that name"));
    assert!(found[0].contains("did you mean \"outline\"? it has: outline, inner; `netcast check --links`"));
    assert!(found[1].contains("did you mean \"inner rope 9\"?"), "{}", found[1]);
    // a square net has no rings
    assert_eq!(refused(SQUARE, "\"ring 1\" = \"thick\"\n").len(), 1);
}

#[test]
fn a_note_tells_of_a_rope_that_no_link_is_made_of() {
    let notes = model(SQUARE, "outline = \"thick\"\n").notes;
    assert!(notes.contains(&"no link is made of [ropes.thin]".to_owned()), "{notes:?}");
    let is_told = |notes: &[String]| notes.iter().any(|note| note.starts_with("no link is made of"));
    assert!(!is_told(&model(SQUARE, "outline = \"thick\"\ninner = \"thin\"\n").notes));
    // the class is assigned, but each of its links has a rope of its own
    let notes = model(
        "[web.square]\nside = 1\nmesh = 1\n",
        "outline = \"thin\"\n\"outline rope 1\" = \"thick\"\n\
        \"outline rope 2\" = \"thick\"\n\"outline rope 3\" = \"thick\"\n\"outline rope 4\" = \"thick\"\n",
    )
    .notes;
    assert!(notes.contains(&"no link is made of [ropes.thin]".to_owned()), "{notes:?}");
}

/// Both scenarios of docs/materials.md, applied to a space web.
#[test]
fn the_documented_assignments_give_the_ropes_that_the_page_says() {
    let page = include_str!("../../../docs/materials.md");
    let blocks: Vec<&str> = page.split("```toml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    let [library, ropes] = blocks[..] else { panic!("{} scenarios", blocks.len()) };
    let frame = "[web.space]\nside = 2.5\n[traction_rope]\nlength = 1\n[solve]\nduration = 1\n";
    let read = |text: String| Model::new(&parse(&text, &[]).unwrap_or_else(|wrong| panic!("{wrong}"))).unwrap();
    assert!(read(format!("{frame}{library}")).notes.iter().any(|note| note.contains("[ropes.bridle]")));
    let rope = "[rope]\nmaterial = \"nylon rope\"\ndiameter = 0.005\n";
    let model = read(format!("{frame}{rope}{ropes}"));
    assert!(!model.notes.iter().any(|note| note.starts_with("no link")), "{:?}", model.notes);
    let counts = BTreeMap::from([("border", 36), ("thin", 12 + 2), ("spare", 2), ("rope", 180 + 6 - 52)]);
    assert_eq!(self::counts(&model.links()), counts);
}

#[test]
fn a_row_of_a_graph_prevails_over_everything() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("net.toml");
    std::fs::write(folder.path().join("nodes.csv"), "id,x,y,z\na,0,0,0\nb,1,0,0\nc,0,1,0\n").unwrap();
    std::fs::write(folder.path().join("ropes.csv"), "a,b,class,rope\na,b,edge,thin\nb,c,edge,\nc,a,edge,\n").unwrap();
    let graph = "[web.graph]\nnodes = \"nodes.csv\"\nropes = \"ropes.csv\"\n";
    let assign = "[assign]\nedge = \"thick\"\n\"edge rope 1\" = \"thick\"\n";
    std::fs::write(&file, format!("{ROPES}{graph}{assign}")).unwrap();
    let links = Model::new(&Document::read(&file, &[]).unwrap()).unwrap().links();
    let ropes: Vec<&str> = links.iter().map(|link| &link.rope[..]).collect();
    assert_eq!(ropes, ["thin", "thick", "thick"]);
}
