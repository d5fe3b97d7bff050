//! `[[break_ties]]` and `[[stitches]]`: the segments that the model makes of them, and the mistakes that it reports.

mod common;

use common::parse;
use netcast_model::Model;
use netcast_scenario::{Diagnostics, resolved_toml};

/// A small flat net with its tractors at its corners.
const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "1 kg"
solve = { duration = "30 ms", segment_length = "0.25 m" }
"#;

fn model(added: &str) -> Result<Model, Diagnostics> {
    Model::new(&parse(&format!("{NET}{added}"), &[])?)
}

fn modelled(added: &str) -> Model {
    model(added).unwrap_or_else(|errors| panic!("{errors}"))
}

fn wrong(added: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = model(added) else { panic!("nothing is wrong with {added}") };
    found.iter().map(ToString::to_string).collect()
}

#[test]
fn ties_join_nodes_to_their_place_or_to_each_other_and_leave_the_web_unchanged() {
    let plain = modelled("");
    let tied = modelled(
        "[[break_ties]]\ncorners = true\nbreaking_load = \"100 N\"\n\
         [[break_ties]]\npairs = [[\"knot 2\", \"knot 3\"]]\nbreaking_load = \"30 N\"\nbreaking_strain = 0.05\nlength = 1\n",
    );
    let own = plain.system.segments().len();
    assert_eq!(&tied.system.segments()[..own], plain.system.segments());
    let ties = &tied.system.segments()[own..];
    assert_eq!((ties.len(), tied.system.mass().len()), (5, plain.system.mass().len() + 4));
    for (tie, &corner) in ties.iter().zip(&{
        let mut corners = tied.cut.web.corners.clone();
        corners.sort_unstable();
        corners
    }) {
        let [node, place] = tie.ends;
        assert_eq!((node, tied.state.position[place]), (corner, tied.state.position[corner]));
        assert!(tied.system.held()[place] && tied.system.mass()[place] == 0.0);
        assert_eq!((tie.rest_length, tie.breaking.load), (0.01, 100.0));
        assert!((tie.stiffness * 0.1 * 0.01 / 100.0 - 1.0).abs() < 1e-15);
    }
    assert_eq!((ties[4].rest_length, ties[4].stiffness, ties[4].breaking.load), (1.0, 600.0, 30.0));
    assert_eq!(tied.segment_label(own), "break tie 1 at web corner 3");
    assert_eq!(tied.segment_label(own + 4), "break tie 5 at knot 2 to knot 3");
    assert!(!tied.is_rope(own) && tied.groups[ties[0].group].class.name() == "tie");
    // ties add neither mass nor links
    assert_eq!(tied.bill, plain.bill);
    assert_eq!(tied.system.mass().iter().sum::<f64>(), plain.system.mass().iter().sum::<f64>());
    assert_eq!(tied.scenario.solve.step_fraction, plain.scenario.solve.step_fraction);
    assert_eq!(tied.links(), plain.links());
    // the resolved scenario keeps the ties
    let resolved = resolved_toml(&tied.scenario);
    assert!(resolved.contains("[[break_ties]]") && resolved.contains("breaking_strain = 0.1"), "{resolved}");
}

/// Ties and stitches have no drag.
#[test]
fn ties_do_not_change_the_solidity() {
    let air = "environment.air.solidity = \"web\"\nstow.scale.factor = 0.5\n";
    let (plain, tied) =
        (modelled(air), modelled(&format!("{air}break_ties = [{{ corners = true, breaking_load = 50 }}]\n")));
    let [plain, tied] = [plain, tied].map(|model| model.air.expect("there is air").drawn_solidity);
    assert!(plain.is_some() && plain == tied, "{plain:?} and {tied:?}");
}

#[test]
fn the_default_length_of_a_tie_is_its_span_in_the_stowed_web() {
    // shrunk to a quarter, the knots lie 0.125 m apart
    let tied = modelled(
        "stow.scale.factor = 0.25\nbreak_ties = [{ pairs = [[\"knot 2\", \"knot 3\"]], breaking_load = 20 }]\n",
    );
    let tie = tied.system.segments().last().unwrap();
    assert!((tie.rest_length - 0.125).abs() < 1e-12 && (tie.stiffness - 1600.0).abs() < 1e-9);
}

#[test]
fn stitches_join_folds_but_not_neighbours_along_a_rope() {
    let folds = "stow.layers = { container.box = { width = \"1 m\", breadth = \"0.6 m\", height = \"0.5 m\" } }\n";
    let row = |every: u32| {
        format!(
            "{folds}[[stitches]]\nclass = \"outline\"\nreach = \"80 mm\"\nevery = {every}\nbreaking_load = \"5 N\"\n"
        )
    };
    let (plain, all, half) = (modelled(folds), modelled(&row(1)), modelled(&row(2)));
    let own = plain.system.segments().len();
    let stitches = &all.system.segments()[own..];
    assert!(!stitches.is_empty() && half.system.segments().len() - own < stitches.len());
    for stitch in stitches {
        let [a, b] = stitch.ends.map(|end| all.state.position[end]);
        assert!(a.distance(b) <= 0.08, "{}", a.distance(b));
        // its neighbours along the rope are at most 0.25 m away
        let joined = |one: usize, other: usize| {
            plain.system.segments().iter().any(|s| s.ends == [one, other] || s.ends == [other, one])
        };
        assert!(!joined(stitch.ends[0], stitch.ends[1]));
    }
    assert_eq!(all.segment_label(own), "stitch 1 of row 1");
    assert_eq!(all.groups[stitches[0].group].class.name(), "stitch");
}

/// The shortest ways along the ropes of a drawn web from a node to all others, m, (nodes,), by Bellman's method (1958):
/// relaxed until nothing changes.
fn ways(model: &Model, from: usize) -> Vec<f64> {
    let mut ways = vec![f64::INFINITY; model.cut.nodes.len()];
    ways[from] = 0.0;
    loop {
        let before = ways.clone();
        for s in model.cut.segments() {
            ways[s.a] = ways[s.a].min(ways[s.b] + s.rest_length);
            ways[s.b] = ways[s.b].min(ways[s.a] + s.rest_length);
        }
        if ways == before {
            return ways;
        }
    }
}

#[test]
fn a_stitch_joins_the_nearest_node_of_another_fold_that_the_row_has_not_passed() {
    const REACH: f64 = 0.08;
    let fine = NET.replace("\"0.25 m\"", "\"50 mm\"");
    let folds = "stow.layers = { container.box = { width = \"1 m\", breadth = \"0.6 m\", height = \"0.5 m\" } }\n";
    let row = format!("stitches = [{{ class = \"outline\", reach = {REACH}, breaking_load = 5 }}]\n");
    let model = Model::new(&parse(&format!("{fine}{folds}{row}"), &[]).unwrap()).unwrap();
    let mut walked = Vec::new();
    for (rope, _) in model.cut.web.ropes.iter().enumerate().filter(|(_, rope)| rope.class.name() == "outline") {
        walked.extend(model.cut.nodes_of(rope));
    }
    let at = |node: usize| walked.iter().position(|&other| other == node);
    let (mut stitched, mut near_but_joined) = (0, 0);
    for stitch in model.system.segments().iter().filter(|s| model.groups[s.group].class.name() == "stitch") {
        let [node, other] = stitch.ends;
        let ways = ways(&model, node);
        assert!(ways[other] > 2.0 * REACH, "{} m of rope", ways[other]);
        assert!(at(other).is_none_or(|place| place > at(node).unwrap()), "it goes back");
        let far = |other: usize| model.state.position[node].distance(model.state.position[other]);
        // the nearest node in another fold among those that the row has not passed
        let free = (0..ways.len()).filter(|&other| at(other).is_none_or(|place| place > at(node).unwrap()));
        let nearest = free.filter(|&other| ways[other] > 2.0 * REACH).map(far).fold(f64::INFINITY, f64::min);
        assert_eq!(far(other), nearest);
        near_but_joined += (0..ways.len()).filter(|&n| n != node && far(n) < nearest && ways[n] <= 2.0 * REACH).count();
        stitched += 1;
    }
    assert!(stitched > 20 && near_but_joined > 0, "{stitched}, {near_but_joined}");
}

#[test]
fn mistakes_are_reported_at_their_place() {
    let tie = |keys: &str| wrong(&format!("break_ties = [{{ breaking_load = 20, {keys} }}]\n"));
    let row = |keys: &str| wrong(&format!("stitches = [{{ breaking_load = 20, {keys} }}]\n"));
    let cases = [
        (tie("corners = false"), "break_ties[0]: no node is named for this tie"),
        (tie("nodes = [\"knot 99\"]"), "break_ties[0].nodes[0]: unknown node \"knot 99\""),
        (tie("pairs = [[\"knot 2\", \"knot 99\"]]"), "break_ties[0].pairs[0][1]: unknown node \"knot 99\""),
        (tie("pairs = [[\"knot 2\", \"knot 2\"]]"), "break_ties[0].pairs[0]: a node cannot be tied to itself"),
        (tie("pairs = [[\"knot 2\"]]"), "break_ties[0].pairs[0]: expected 2 values, found 1"),
        (tie("pairs = [[\"knot 2\", \"knot 3\"]], length = 0.4"), "break_ties[0]: its ends lie 0.5000 m apart"),
        (row("reach = 1"), "stitches[0].class: missing key `class`"),
        (row("class = \"ring\", reach = 1"), "stitches[0].class: no rope is of the link class \"ring\""),
        (row("class = \"outline\", reach = 0.01"), "stitches[0].reach: no stitch is made"),
        (row("pairs = [[\"knot 2\", \"knot 99\"]]"), "stitches[0].pairs[0][1]: unknown node \"knot 99\""),
        (row("pairs = [[\"knot 2\", \"knot 3\"]], class = \"outline\""), "expected only one of `pairs` and `class`"),
        (
            row("pairs = [[\"knot 2\", \"knot 3\"]], reach = 1"),
            "stitches[0].reach: expected only one of `pairs` and `reach`",
        ),
        (
            row("pairs = [[\"knot 2\", \"knot 3\"]], every = 2"),
            "stitches[0].every: expected only one of `pairs` and `every`",
        ),
        (row("pairs = []"), "stitches[0].pairs: no nodes are named"),
        (
            wrong("hold.corners = true\nbreak_ties = [{ corners = true, breaking_load = 20 }]\n"),
            "is held already: nothing pulls at this tie",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.iter().any(|told| told.contains(expected)), "{expected}: {found:?}");
    }
    // both mistakes at once
    assert_eq!(tie("nodes = [\"knot 98\"], pairs = [[\"knot 2\", \"knot 99\"]]").len(), 2);
}
