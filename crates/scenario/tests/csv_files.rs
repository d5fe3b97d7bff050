//! The CSV files of `[web.graph]` and `[stow.file]`: their values, and faults reported by line.

use std::num::NonZeroU32;

use netcast_scenario::{Diagnostics, Document};
use netcast_webs::Class;

const SCENARIO: &str = r#"[web.graph]
nodes = "nodes.csv"
ropes = "ropes.csv"
outline = ["n1", "n2", "n3"]
[points]
B = "n3"
[rope]
diameter = "3 mm"
density = 970
elastic_modulus = "5 GPa"
[ropes.thick]
diameter = "5 mm"
density = 970
elastic_modulus = "5 GPa"
[solve]
duration = 1
"#;

const NODES: &str = "id,x,y,z,mass,fixed,vx\nn1,0,0,0,,1,\nn2,1,0,0,0.5,0,2.5\nn3,0,1e0,-0.25,,,\n";
const ROPES: &str = "a,b,rope,class,rest_length,pretension,segments\nn1,n2,thick,outline,1.1,,4\nn2, n3,,,,20,\n";

fn read(scenario: &str, nodes: &str, ropes: &str) -> Result<Document, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("net.toml", scenario), ("nodes.csv", nodes), ("ropes.csv", ropes), ("stow.csv", nodes)] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    Document::read(&folder.path().join("net.toml"), &[])
}

/// The faults, as `file:line: message`.
fn wrong(scenario: &str, nodes: &str, ropes: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = read(scenario, nodes, ropes) else { panic!("nothing is wrong") };
    found
        .iter()
        .map(|one| {
            let at = one.location().unwrap();
            let file = std::path::Path::new(&at.file).file_name().unwrap().to_string_lossy().into_owned();
            let help = one.help.as_ref().map_or(String::new(), |help| format!(" ({help})"));
            format!("{file}:{}: {}{help}", at.line, one.message)
        })
        .collect()
}

#[test]
fn rows_are_read_with_their_defaults() {
    let graph = read(SCENARIO, NODES, ROPES).unwrap().files.graph.unwrap();
    assert_eq!(graph.nodes.len(), 3);
    assert_eq!((graph.nodes[0].fixed, graph.nodes[0].mass_kg, graph.nodes[0].line), (true, 0.0, 2));
    assert_eq!((graph.nodes[1].mass_kg, graph.nodes[1].velocity_m_s), (0.5, [2.5, 0.0, 0.0]));
    assert_eq!(graph.nodes[2].position_m, [0.0, 1.0, -0.25]);
    assert_eq!((graph.ropes[0].a, graph.ropes[0].b), (0, 1));
    assert_eq!((graph.ropes[0].rope.as_deref(), &graph.ropes[0].class), (Some("thick"), &Some(Class::Outline)));
    assert_eq!((graph.ropes[0].rest_length_m, graph.ropes[0].segments), (Some(1.1), NonZeroU32::new(4)));
    assert_eq!((graph.ropes[1].a, graph.ropes[1].b, graph.ropes[1].pretension_n), (1, 2, Some(20.0)));
    assert_eq!((&graph.ropes[1].rope, &graph.ropes[1].class, graph.ropes[1].line), (&None, &None, 3));
}

#[test]
fn windows_line_ends_blank_lines_and_a_byte_order_mark_are_accepted() {
    let nodes = format!("\u{feff}{}", NODES.replace('\n', "\r\n").replacen("\r\n", "\r\n\r\n", 1));
    let graph = read(SCENARIO, &nodes, ROPES).unwrap().files.graph.unwrap();
    assert_eq!((graph.nodes[0].id.as_str(), graph.nodes[0].line), ("n1", 3));
}

#[test]
fn every_faulty_row_is_reported_by_line_with_what_was_expected() {
    let nodes = "id,x,y,z,mass,fixed\nn1,0,0,0,,\n\nn2,1,zero,0,-1,yes\nn1,0,1,0,,\nn3,NaN,0,0,,\nn4,0,0,0\n";
    let ropes = "a,b,rope,segments\nn1,n2,thik,0\nn2,n22,,\nn3,n3,,1.5\n,n1,,\n";
    assert_eq!(
        wrong(SCENARIO, nodes, ropes),
        [
            "nodes.csv:4: y: expected a number, found \"zero\"",
            "nodes.csv:4: mass: expected a number of at least 0, found \"-1\"",
            "nodes.csv:4: fixed: expected 0 or 1, found \"yes\"",
            "nodes.csv:5: node \"n1\" is already in line 2",
            "nodes.csv:6: x: expected a number, found \"NaN\"",
            "nodes.csv:7: expected 6 values, found 4",
            "ropes.csv:2: unknown rope \"thik\" (did you mean \"thick\"?)",
            "ropes.csv:2: segments: expected a whole number of at least 1, found \"0\"",
            "ropes.csv:3: b: unknown node \"n22\" (did you mean \"n2\"?)",
            "ropes.csv:4: a rope needs two different ends",
            "ropes.csv:4: segments: expected a whole number of at least 1, found \"1.5\"",
            "ropes.csv:5: a: expected the id of a node, found nothing",
        ]
    );
}

#[test]
fn a_reserved_name_is_refused_as_a_link_class() {
    let kept = |line: usize, name: &str| {
        format!(
            "ropes.csv:{line}: the link class {name:?} is reserved for parts that are not ropes (choose another name)"
        )
    };
    let ropes = "a,b,class\nn1,n2,Tie\nn2,n3,stitch\nn3,n1,canopy\nn1,n2,tension\nn2,n3,a/b\n";
    let found = wrong(SCENARIO, NODES, ropes);
    assert_eq!(found[..3], [kept(2, "Tie"), kept(3, "stitch"), kept(4, "canopy")]);
    assert_eq!(found.len(), 5, "{found:?}");
    assert!(found[3].starts_with("ropes.csv:5: the link class \"tension\" is reserved"));
    assert!(found[4].starts_with("ropes.csv:6: the link class \"a/b\" has other characters"), "{}", found[4]);
}

#[test]
fn the_header_is_checked() {
    assert_eq!(
        wrong(SCENARIO, "id,x,y,mas\nn1,0,0,1\n", ROPES),
        [
            "nodes.csv:1: unknown column \"mas\", expected the columns id,x,y,z,mass,fixed,vx,vy,vz (did you mean `mass`?)",
            "nodes.csv:1: missing column `z`, expected the columns id,x,y,z,mass,fixed,vx,vy,vz",
        ]
    );
    assert!(wrong(SCENARIO, "id,x,y,z,x\nn1,0,0,1,0\n", ROPES)[0].contains("column `x` appears twice"));
}

#[test]
fn an_empty_web_and_missing_files_are_faults() {
    // reported once, and not again for every id of a node
    assert_eq!(wrong(SCENARIO, "id,x,y,z\n", ROPES), ["nodes.csv:1: no nodes"]);
    assert!(wrong(SCENARIO, NODES, "a,b\n").contains(&"ropes.csv:1: no ropes".to_string()));
    assert!(wrong(SCENARIO, "", "")[0].contains("missing column"));
    let found = wrong(&SCENARIO.replace("\"nodes.csv\"", "\"nods.csv\""), NODES, ROPES);
    assert!(found.len() == 1 && found[0].starts_with("net.toml:2: cannot read "), "{found:?}");
}

#[test]
fn nodes_that_the_scenario_names_must_exist() {
    let scenario = SCENARIO.replace("\"n1\", ", "\"m1\", ").replace("B = \"n3\"", "B = \"n33\"");
    assert_eq!(
        wrong(&scenario, NODES, ROPES),
        [
            "net.toml:4: unknown node \"m1\" (did you mean \"n1\"?)",
            "net.toml:6: unknown node \"n33\" (did you mean \"n3\"?)"
        ]
    );
}

#[test]
fn faults_of_the_scenario_and_of_its_files_come_together() {
    let found = wrong(&SCENARIO.replace("duration = 1", "duration = 0"), NODES, "a,b\nn1,n9\n");
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn more_than_twenty_faults_are_counted() {
    let rows: String = (0..100).map(|row| format!("n{row},a,0,0\n")).collect();
    let found = wrong(SCENARIO, &format!("id,x,y,z\n{rows}"), ROPES);
    assert_eq!(found.iter().filter(|line| line.contains("expected a number")).count(), 20);
    assert!(found.iter().any(|line| line.ends_with("and 80 more faults")));
}

#[test]
fn a_stowed_web_is_read_from_its_file() {
    let scenario = format!("{SCENARIO}\n[stow.file]\npath = \"stow.csv\"\n");
    let nodes = "id,x,y,z\nn1,0,0,0\nn2,0.1,0,0\nn3,0,0.1,-0.25\n";
    let stowed = read(&scenario, nodes, ROPES).unwrap().files.stowed.unwrap();
    assert_eq!((stowed[2].id.as_str(), stowed[2].position_m), ("n3", [0.0, 0.1, -0.25]));
}

#[test]
fn a_scenario_lists_its_files() {
    let scenario = read(SCENARIO, NODES, ROPES).unwrap().scenario;
    let names: Vec<_> = scenario.files().iter().map(|path| path.display().to_string()).collect();
    assert_eq!(names, ["nodes.csv", "ropes.csv"]);
}

/// Each of a million columns was once compared with all columns before it, which took hours.
#[test]
fn more_than_twenty_unknown_columns_are_counted() {
    let header: String = (0..50).map(|column| format!(",c{column}")).collect();
    let found = wrong(SCENARIO, &format!("id,x,y,z{header}\n"), ROPES);
    assert_eq!(found.iter().filter(|line| line.contains("unknown column")).count(), 20);
    assert_eq!(found.last().unwrap(), "nodes.csv:1: and 30 more columns like these");
}

/// A row with line ends in its cells is one row, and the next row is reported by its own line.
#[test]
fn lines_are_counted_through_quotes() {
    let nodes = "id,x,y,z\n\"n\n1\",0,0,0\n\nn2,zero,0,0\n";
    let found = wrong(SCENARIO, nodes, ROPES);
    assert_eq!(found[0], "nodes.csv:5: x: expected a number, found \"zero\"");
}

/// At 1e15 m a node that moved at 1 m/s stayed where it was, and the balance closed to 0 %.
#[test]
fn a_coordinate_that_no_step_can_change_is_refused() {
    let found = wrong(SCENARIO, &NODES.replace("n2,1,0,0", "n2,1e15,0,0"), ROPES);
    assert!(found.iter().any(|one| one.starts_with("nodes.csv:3: x: expected") && one.contains("1e6")), "{found:#?}");
    let found = wrong(&SCENARIO.replace("diameter = \"3 mm\"", "diameter = \"1e308 m\""), NODES, ROPES);
    assert!(found.iter().any(|one| one.contains("at most 1e6")), "{found:#?}");
}
