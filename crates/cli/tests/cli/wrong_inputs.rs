//! Wrong inputs: each ends with status 2 and a message with place and advice, and nothing is written.

use std::fs;

use crate::workbench::{GRAPH_NET, NODES, ROPES, SMALL_NET, Workbench};

/// Runs `net.toml`, asserts that it is refused and nothing is written, and returns the message.
fn refused(workbench: &Workbench) -> String {
    let before = workbench.listing();
    let ended = workbench.netcast(&["run", "net.toml"]);
    assert_eq!(ended.status, 2, "{}{}", ended.stdout, ended.stderr);
    assert_eq!(ended.stdout, "");
    assert!(workbench.listing() == before, "something was written");
    assert!(ended.stderr.trim_end().ends_with("nothing was written"), "{}", ended.stderr);
    // other commands refuse the scenario, too
    for command in ["check", "stow"] {
        assert_eq!(workbench.netcast(&[command, "net.toml"]).status, 2, "netcast {command}");
    }
    ended.stderr
}

/// Changes one passage of the small net and asserts that it is refused.
#[track_caller]
fn net_with(from: &str, to: &str) -> String {
    assert!(SMALL_NET.contains(from), "{from}");
    refused(&Workbench::new(&[("net.toml", &SMALL_NET.replacen(from, to, 1))]))
}

/// Changes one passage in a file of the graph net and asserts that it is refused.
#[track_caller]
fn graph_with(file: &str, from: &str, to: &str) -> String {
    let mut files =
        [("net.toml", GRAPH_NET.to_owned()), ("nodes.csv", NODES.to_owned()), ("ropes.csv", ROPES.to_owned())];
    let text = &mut files.iter_mut().find(|(name, _)| *name == file).unwrap().1;
    assert!(text.contains(from), "{from}");
    *text = text.replacen(from, to, 1);
    refused(&Workbench::new(&files.each_ref().map(|(name, text)| (*name, &text[..]))))
}

#[track_caller]
fn assert_says(message: &str, all: &[&str]) {
    for said in all {
        assert!(message.contains(said), "{said:?} is not said in:\n{message}");
    }
}

#[test]
fn all_mistakes_are_reported_at_once_with_place_and_nearest_key() {
    let text = SMALL_NET
        .replace("side = \"2 m\"", "side = \"2.5 kg\"")
        .replace("diameter", "diametre")
        .replace("[launch]", "[lunch]")
        .replace("every = \"5 ms\"", "every = \"0 ms\"");
    let message = refused(&Workbench::new(&[("net.toml", &text)]));
    assert_says(
        &message,
        &[
            "web.square.side: expected a length greater than 0 such as \"2.5 m\", found \"2.5 kg\", which is a mass",
            "--> net.toml:4:8",
            "--> net.toml:9:1",
            "did you mean `diameter`?",
            "--> net.toml:19:2",
            "did you mean `launch`?",
            "--> net.toml:27:9",
            "4 errors; nothing was written",
        ],
    );
}

#[test]
fn impossible_numbers_are_refused() {
    for (value, said) in [
        ("\"-3 mm\"", "greater than 0"),
        ("\"0 mm\"", "greater than 0"),
        ("-0.0", "greater than 0"),
        ("nan", "found NaN"),
        ("\"nan mm\"", "does not start with a number"),
        ("inf", "found inf"),
        ("\"1e999 m\"", "1e999 m"),
        ("\"3\"", "3"),
        ("\"3 mm thick\"", "thick"),
        ("true", "found"),
        ("[3]", "found"),
    ] {
        let message = net_with("\"3 mm\"", value);
        assert_says(&message, &["rope.diameter: expected a length", said, "--> net.toml:9:12"]);
    }
    assert_says(&net_with("factor = 0.25", "factor = 1.25"), &["greater than 0 and at most 1 such as", "found 1.25"]);
}

#[test]
fn a_missing_or_binary_scenario_is_named() {
    let workbench = Workbench::new(&[]);
    assert_says(&refused(&workbench), &["cannot read net.toml: No such file"]);
    fs::create_dir(workbench.path("net.toml")).unwrap();
    assert_says(&refused(&workbench), &["cannot read net.toml"]);
    let workbench = Workbench::new(&[]);
    fs::write(workbench.path("net.toml"), [0xff, 0xfe, 0x00]).unwrap();
    assert_says(&refused(&workbench), &["cannot read net.toml: it is not UTF-8 text"]);
    assert_says(&refused(&Workbench::new(&[("net.toml", "")])), &["missing key `web`", "[web.square]", "3 errors"]);
    assert_says(&net_with("[web.square]", "[web.square"), &["--> net.toml:3:"]);
}

#[test]
fn a_mesh_that_does_not_divide_the_side_is_reported_with_one_that_does() {
    assert_says(
        &net_with("mesh = \"0.5 m\"", "mesh = \"0.3 m\""),
        &["--> net.toml:5:8", "0.333333 m or 0.285714 m would"],
    );
    assert_says(
        &net_with("mesh = \"0.5 m\"", "mesh = \"3 m\""),
        &["--> net.toml:5:8", "larger than the web's side of 2 m"],
    );
}

/// The mistakes were reported at `web.square.cells_per_side` and at `solve.segment_length`. A square net has neither key.
#[test]
fn too_fine_a_net_is_reported_at_the_key_that_makes_it_so() {
    assert_says(&net_with("mesh = \"0.5 m\"", "mesh = \"1 nm\""), &["web.square.mesh:", "--> net.toml:5:8"]);
    let message = net_with("segments_per_mesh = 2", "segments_per_mesh = 2000000000");
    assert_says(&message, &["web.square.segments_per_mesh:", "--> net.toml:6:21", "less than a hundredth"]);
}

#[test]
fn a_packing_that_stretches_ropes_is_refused() {
    let pretension =
        SMALL_NET.replace("\"5 GPa\"", "\"5 GPa\"\npretension = \"10 N\"").replace("factor = 0.25", "factor = 1.0");
    let message = refused(&Workbench::new(&[("net.toml", &pretension)]));
    // the strain of 10 N on 5 GPa and a 3 mm rope: 10 / (5e9 pi/4 9e-6) = 0.0283 %
    assert_says(
        &message,
        &["stow.scale:", "is stretched", "by 0.028 %", "pack it closer, or give the rope no pretension"],
    );

    let deep = "[stow.bag]\nradius = \"0.2 m\"\ndepth = \"9 m\"";
    let message = net_with("[stow.scale]\nfactor = 0.25", deep);
    assert_says(
        &message,
        &["stow.bag.depth:", "--> net.toml:18:9", "a bag 9 m deep would stretch", "it can be at most"],
    );
    // the offered depth works
    let offered = message.split("at most ").nth(1).unwrap().split(' ').next().unwrap();
    let rounded_down = offered.parse::<f64>().unwrap() - 1e-4;
    let net = SMALL_NET.replace("[stow.scale]\nfactor = 0.25", &deep.replace('9', &rounded_down.to_string()));
    Workbench::new(&[("net.toml", &net)]).succeed(&["stow", "net.toml"]);

    let message = net_with("[stow.scale]\nfactor = 0.25", "[stow.bag]\nradius = \"5 m\"");
    assert_says(&message, &["stow.bag.radius:", "at most the web's own"]);
}

/// The path of an unknown node was `hold.nodes.0` instead of `hold.nodes[0]`.
#[test]
fn names_of_nodes_corners_ropes_and_classes_are_checked() {
    let message = net_with("[launch]", "[hold]\nnodes = [\"nowhere\"]\n\n[launch]");
    assert_says(
        &message,
        &["hold.nodes[0]: unknown node \"nowhere\"", "--> net.toml:20:10", "lists the names of all nodes"],
    );
    let message = net_with("[launch]", "[[tractors]]\ncorner = 5\n\n[launch]");
    assert_says(&message, &["tractors[0].corner: the web has 4 corners, not 5", "--> net.toml:20:10"]);
    let thick = "[ropes.thick]\ndiameter = \"5 mm\"\ndensity = 1140\nelastic_modulus = \"5 GPa\"\n";
    let message = net_with("[launch]", &format!("{thick}[assign]\noutlin = \"thick\"\n\n[launch]"));
    assert_says(&message, &["this web has no link class \"outlin\"", "it has: outline, inner", "--> net.toml:24:10"]);
    let message = net_with("[launch]", &format!("{thick}[assign]\noutline = \"thik\"\n\n[launch]"));
    assert_says(&message, &["unknown rope \"thik\"", "did you mean \"thick\"?", "--> net.toml:24:11"]);
    assert_says(
        &graph_with("net.toml", "[launch]", "[hold]\nnodes = [\"midle\"]\n\n[launch]"),
        &["hold.nodes[0]: unknown node \"midle\"", "did you mean \"middle\"?", "--> net.toml:21:10"],
    );
}

#[test]
fn a_launch_without_tractors_is_refused() {
    let message = net_with("[tractor.particle]\nmass = \"0.3 kg\"\n", "");
    assert_says(&message, &["launch: nothing to launch", "--> net.toml:17:2", "add [tractor.particle]"]);
}

#[test]
fn an_empty_graph_is_reported_once() {
    let message = graph_with("nodes.csv", &NODES["id,x,y,z\n".len()..], "");
    assert_says(&message, &["web.graph.nodes: no nodes", "--> nodes.csv:1:1", "1 error;"]);
    let message = graph_with("ropes.csv", &ROPES["a,b,class\n".len()..], "");
    assert_says(&message, &["web.graph.ropes: no ropes", "--> ropes.csv:1:1", "1 error;"]);
    assert_says(&graph_with("nodes.csv", NODES, ""), &["missing column `id`, expected the columns id,x,y,z"]);
}

#[test]
fn a_web_in_pieces_is_refused_with_a_knot_of_two_of_them() {
    let files = [
        ("net.toml", GRAPH_NET.to_owned()),
        ("nodes.csv", format!("{NODES}far,9,9,0\nout,9,8,0\n")),
        ("ropes.csv", format!("{ROPES}far,out,inner\n")),
    ];
    let message = refused(&Workbench::new(&files.each_ref().map(|(name, text)| (*name, &text[..]))));
    assert_says(&message, &["the web is in 2 pieces", "nothing joins", "n1", "far"]);
}

#[test]
fn a_missing_file_is_reported_at_its_key() {
    let message = graph_with("net.toml", "\"nodes.csv\"", "\"nods.csv\"");
    assert_says(&message, &["web.graph.nodes: cannot read nods.csv: No such file", "--> net.toml:4:9"]);
}

#[test]
fn wrong_rows_are_reported_with_line_and_column() {
    let nodes =
        NODES.replace("n2,-1,1,0", "n2,-1,one,0").replace("n4,1,-1,0", "n4,1,-1").replace("middle,0", "middle,nan");
    let ropes = ROPES.replace("n2,n3", "n2,n2").replace("n4,middle", "n9,middle");
    let workbench = Workbench::new(&[("net.toml", GRAPH_NET), ("nodes.csv", &nodes), ("ropes.csv", &ropes)]);
    assert_says(
        &refused(&workbench),
        &[
            "y: expected a number, found \"one\"",
            "--> nodes.csv:3:7",
            "expected 4 values, found 3",
            "--> nodes.csv:5:1",
            "x: expected a number, found \"nan\"",
            "--> nodes.csv:6:8",
            "a rope needs two different ends",
            "--> ropes.csv:3:1",
            "a: unknown node \"n9\"",
            "--> ropes.csv:9:1",
        ],
    );
}

#[test]
fn contradictions_within_a_graph_are_reported() {
    assert_says(
        &graph_with("nodes.csv", "n2,-1,1,0", "n1,-1,1,0"),
        &["node \"n1\" is already in line 2", "--> nodes.csv:3:1"],
    );
    assert_says(&graph_with("nodes.csv", "n2,-1,1,0", "n2,1,1,0"), &["has no length", "at the same place", "line 2"]);
    let message = graph_with("net.toml", "outline = [\"n1\", \"n2\"", "outline = [\"n1\", \"n1\"");
    assert_says(&message, &["web.graph.outline: node \"n1\" is named twice", "--> net.toml:6:11"]);
    let message = graph_with("net.toml", "outline = [\"n1\", \"n2\", \"n3\", \"n4\"]", "outline = [\"n1\"]");
    assert_says(&message, &["an outline needs at least 3 knots, not 1"]);
    assert_says(
        &graph_with("net.toml", "corners = [\"n1\"", "corners = [\"m1\""),
        &["web.graph.corners[0]: unknown node \"m1\""],
    );
}

#[test]
fn a_stow_file_must_name_every_knot_and_no_other() {
    let stowed = GRAPH_NET.replace("[stow.scale]\nfactor = 0.5", "[stow.file]\npath = \"stowed.csv\"");
    let with = |rows: &str| {
        let files = [("net.toml", &stowed[..]), ("nodes.csv", NODES), ("ropes.csv", ROPES), ("stowed.csv", rows)];
        refused(&Workbench::new(&files))
    };
    assert_says(&with("id,x,y,z\nn1,0,0,0\n"), &["stow.file.path:", "some knots have no position", "n2", "middle"]);
    assert_says(&with(&format!("{NODES}midle,0,0,0\n")), &["line 7", "\"midle\"", "did you mean \"middle\"?"]);
    let far = NODES.replace("n1,1,1,0", "n1,2,2,0");
    assert_says(&with(&far), &["stow.file:", "is stretched"]);
}

/// A class called "tension" doubled a column and ended with status 1; one called "canopy" was left out of the largest
/// tension.
#[test]
fn names_reserved_in_the_results_are_refused() {
    let message = graph_with("ropes.csv", "n1,middle,radial", "n1,middle,tension");
    assert_says(&message, &["the link class \"tension\" is reserved for the largest tension", "ropes.csv:6:11"]);
    let message = graph_with("ropes.csv", "n1,middle,radial", "n1,middle,Canopy");
    assert_says(&message, &["the link class \"Canopy\" is reserved for parts that are not ropes", "ropes.csv:6:11"]);
    let message = graph_with("net.toml", "[rope]", "[points]\ntractor = \"n1\"\n\"a,b\" = \"n2\"\n\n[rope]");
    assert_says(&message, &["\"tractor\" is followed in every run already", "\"a,b\" has other characters"]);
}

/// Both runs were started. One was killed for lack of memory, the number of steps of the other overflowed.
#[test]
fn a_run_that_would_never_end_is_refused() {
    let message = net_with("every = \"5 ms\"", "every = 1e-12");
    assert_says(&message, &["record.every: 5.000e10 records are too many", "--> net.toml:27:9"]);
    let message = net_with("duration = \"50 ms\"", "duration = \"1e9 s\"");
    assert_says(&message, &["solve.duration: ", "steps of", "are too many", "limits the step"]);
}

#[test]
fn mistakes_found_in_the_drawn_web_are_reported_at_once() {
    let text = SMALL_NET.replace("factor = 0.25", "factor = 1.0").replace("[rope]", "[rope]\npretension = \"5 N\"")
        + "\n[assign]\nring = \"thin\"\n\n[ropes.thin]\ndiameter = \"3 mm\"\ndensity = 1140\nelastic_modulus = \"5 GPa\"\n\
           \n[hold]\nnodes = [\"n77\"]\n\n[[tractors]]\ncorner = 9\nparticle = { mass = 1 }\n";
    assert_says(
        &refused(&Workbench::new(&[("net.toml", &text)])),
        &["no link class \"ring\"", "unknown node \"n77\"", "the web has 4 corners, not 9", "3 errors"],
    );
}

/// Nine errors once told of one separator, none of which named it.
#[test]
fn a_csv_file_in_another_form_throughout_gets_one_message() {
    for (separator, name) in [(";", "semicolons"), ("\t", "tabs")] {
        let message = graph_with("nodes.csv", NODES, &NODES.replace(',', separator));
        assert_says(&message, &[name, "nodes.csv:1:1", "separate them by commas", "1 error;"]);
    }
    let message = graph_with("nodes.csv", NODES, &NODES.replacen("id,x,y,z", "ID,X,Y,Z", 1));
    assert_says(&message, &["small letters", "`ID`", "and 3 more", "1 error;"]);
    let short = NODES.trim_end().rsplit_once(',').unwrap().0;
    let message = graph_with("nodes.csv", NODES.trim_end(), short);
    assert_says(&message, &["values, found", "1 error;"]);
}

#[test]
fn a_cell_of_megabytes_is_cut_to_a_line() {
    let cell = "7".repeat(2_000_000) + "x";
    let (before, after) = NODES.trim_end().rsplit_once(',').unwrap();
    let message = graph_with("nodes.csv", after, &cell);
    assert!(message.len() < 2_000 && message.contains('…'), "{} bytes of {before}", message.len());
}

/// It passed the check, and the column of the history was of the point.
#[test]
fn a_point_named_like_a_column_of_every_run_is_refused() {
    let message = graph_with("net.toml", "[solve]", "[points]\nmass_centre = \"middle\"\n[solve]");
    assert_says(&message, &["`mass_centre_travel_m`", "points.mass_centre", "net.toml:", "choose another name"]);
}
