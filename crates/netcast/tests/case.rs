//! A case in memory, a case in a folder and a case of the command are one case.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use netcast::prelude::*;
use netcast::results::read_fields;
use netcast::{RunOptions, Value};

/// A square net of 8 meshes, thrown for 30 ms.
fn net() -> CaseBuilder {
    Case::new(Web::square("4 m", "0.5 m").set("segments_per_mesh", 1))
        .title("A net")
        .rope(Rope::new("2 mm", "1440 kg/m^3", "70 GPa"))
        .tractor(Body::particle("0.5 kg"))
        .stow(Stow::scale(0.25))
        .launch(Launch::new("20 m/s", "10 m/s"))
        .duration("30 ms")
}

const SCENARIO: &str = r#"
title = "A net"
[web.square]
side = "4 m"
mesh = "0.5 m"
segments_per_mesh = 1
[rope]
diameter = "2 mm"
density = "1440 kg/m^3"
elastic_modulus = "70 GPa"
[tractor.particle]
mass = "0.5 kg"
[stow.scale]
factor = 0.25
[launch]
axial_speed = "20 m/s"
radial_speed = "10 m/s"
[solve]
duration = "30 ms"
"#;

/// Every file below a folder with its bytes, less what knows the clock.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else if name != "manifest.json" && name != "report.html" {
            found.insert(name, fs::read(&path).unwrap());
        }
    }
    if let Some(summary) = found.get_mut("summary.json") {
        let mut value: serde_json::Value = serde_json::from_slice(summary).unwrap();
        value["wall_time_s"] = 0.0.into();
        *summary = value.to_string().into_bytes();
    }
    found
}

#[test]
fn a_case_built_in_code_is_the_scenario_with_the_same_values_and_defaults() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("net.toml");
    fs::write(&file, SCENARIO).unwrap();
    let (built, read) = (net().build().unwrap(), Case::read(&file, &[]).unwrap());
    assert_eq!(built.scenario(), read.scenario());
    assert_eq!(built.facts(), read.facts());
    // a scenario as a value is the same case too, and so is one in SI
    assert_eq!(Case::from_scenario(read.scenario(), "").unwrap().scenario(), read.scenario());
    let in_si = Case::new(Web::square(4.0, 0.5).set("segments_per_mesh", 1))
        .title("A net")
        .rope(Rope::new(0.002, 1440.0, 70e9))
        .tractor(Body::particle(0.5))
        .stow(Stow::scale(0.25))
        .launch(Launch::new(20.0, 10.0))
        .duration(0.03);
    assert_eq!(in_si.build().unwrap().scenario(), read.scenario());
}

#[test]
fn every_table_and_key_of_the_builder_is_one_of_the_scenario() {
    let rope = || Rope::new(0.002, 1440.0, 70e9);
    let webs = [
        Web::traditional(2.5),
        Web::topological(2.5),
        Web::space(2.5),
        Web::square(2.0, 0.5),
        Web::polygon(6, 4.0, 0.5),
        Web::radial(3.0, 8, 4),
        Web::diamond(0.2, 6, 6),
    ];
    for web in webs {
        let case = Case::new(web).rope(rope()).segment_length("0.25 m").duration("1 ms");
        case.build().unwrap_or_else(|error| panic!("{error}"));
    }
    let tractors =
        [Body::particle(0.5), Body::cylinder(0.05, 0.1), Body::sphere(0.05).mass(0.4), Body::cuboid(0.05, 0.05, 0.1)];
    let stows = [
        Stow::bag(0.3),
        Stow::zigzag(0.5, 1.0),
        Stow::star(0.5, 1.0),
        Stow::roll(0.5, 1.0),
        Stow::layers(0.5, 1.0),
        Stow::scale(0.5),
    ];
    for (tractor, stow) in tractors.into_iter().cycle().zip(stows) {
        let launch = Launch::new(20.0, 10.0).elevation("60 deg").azimuth("10 deg").spin("1 rad/s");
        let rope = rope().damping_time("2 us").strength("1 kN");
        let case = Case::new(Web::square(2.0, 0.5)).rope(rope).tractor(tractor).stow(stow).launch(launch);
        let case = case.traction_rope(1.0).gravity(0.0).damping(0.1).record_every("1 ms").duration("5 ms");
        let border = Rope::of("aramid rope", "4 mm").damping_ratio(0.1);
        let case = case.other_rope("border", border).assign("outline", "border");
        case.build().unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn wrong_values_are_told_all_at_once_by_their_keys() {
    let wrong = net()
        .rope(Rope::new("2 mm", "1440 kg", "70 GPa"))
        .stow(Stow::scale(3.0))
        .set("launch.axial_sped", "20 m/s")
        .duration("-1 s");
    let error = wrong.build().unwrap_err();
    let keys: Vec<&str> = error.0.iter().map(|diagnostic| &diagnostic.path[..]).collect();
    assert_eq!(keys, ["rope.density", "stow.scale.factor", "launch.axial_sped", "solve.duration"]);
    assert!(error.to_string().contains("did you mean `axial_speed`?"), "{error}");
    // a path through what is no table
    let error = net().set("title.text", "x").build().unwrap_err();
    assert_eq!(error.0[0].path, "title.text");
}

#[test]
fn a_net_given_node_by_node_needs_no_files() {
    let nodes = [Node::at("left", [0.0, 0.0, 0.0]).fixed(), Node::at("right", [1.0, 0.0, 0.0]).mass(2.0)];
    let rope = Link::between("left", "right").class("pendulum").segments(1);
    let case = Case::new(Web::graph(nodes, [rope])).rope(Rope::new(0.002, 1000.0, 1e9)).point("B", "right");
    let case = case.duration("0.3 s").record_every("10 ms").build().unwrap();
    let run = case.simulate().unwrap();
    // a pendulum let go level falls freely at first: g t^2 / 2 at t = 0.1 s, less what the turn of the rope takes
    let fall = run.history().values("B_z_m").unwrap().nth(10).unwrap().unwrap();
    assert!((fall + 0.5 * 9.80665 * 0.01).abs() < 2e-3, "{fall}");
    // the rows are checked as those of a file, and told by its name
    let error = Case::new(Web::graph([Node::at("a", [0.0; 3])], [Link::between("a", "b")]))
        .rope(Rope::new(0.002, 1000.0, 1e9))
        .duration(0.1)
        .build()
        .unwrap_err();
    assert!(error.to_string().contains("ropes.csv:2:"), "{error}");
    // and they go into the folder, which runs again
    let folder = tempfile::tempdir().unwrap();
    let written = run.write(folder.path().join("pendulum")).unwrap();
    let again = Case::read(written.join("inputs/scenario.toml"), &[]).unwrap().simulate().unwrap();
    assert_eq!(again.history(), run.history());
}

#[test]
fn all_that_is_said_of_a_node_or_a_rope_arrives() {
    let far = "b, the \"second\"";
    let nodes =
        [Node::at("a", [0.1, -2.0, 1e-7]).mass(3.0).velocity([4.0, 5.0, 6.0]), Node::at(far, [1.0, 0.0, 0.0]).fixed()];
    let rope = Link::between("a", far).rope("thick").class("mine").rest_length(1.5).segments(3);
    let taut = Link::between("a", far).pretension(2.5);
    let case = Case::new(Web::graph(nodes, [rope, taut])).rope(Rope::new(0.002, 1000.0, 1e9)).duration(0.01);
    let case = case.other_rope("thick", Rope::new(0.004, 1000.0, 1e9)).build().unwrap();
    let graph = case.document().files.graph.as_ref().unwrap();
    let (a, b, rope) = (&graph.nodes[0], &graph.nodes[1], &graph.ropes[0]);
    assert_eq!((&a.id[..], a.position_m, a.mass_kg), ("a", [0.1, -2.0, 1e-7], 3.0));
    assert_eq!((a.velocity_m_s, a.fixed, &b.id[..], b.fixed), ([4.0, 5.0, 6.0], false, far, true));
    assert_eq!((graph.ropes[1].pretension_n, graph.ropes[1].rest_length_m), (Some(2.5), None));
    assert_eq!((rope.a, rope.b, rope.rope.as_deref(), rope.rest_length_m), (0, 1, Some("thick"), Some(1.5)));
    assert_eq!((rope.class.as_ref().unwrap().name(), rope.segments.unwrap().get()), ("mine", 3));
}

#[test]
fn a_run_in_memory_has_the_bits_of_a_run_into_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let case = net().build().unwrap();
    let run = case.simulation().threads(1).run().unwrap();
    let ran = case.simulation().threads(2).run_to(folder.path().join("streamed")).unwrap();
    assert!(run.failure.is_none(), "{:?}", run.failure);
    assert_eq!(Summary { wall_time_s: 0.0, ..run.summary.clone() }, Summary { wall_time_s: 0.0, ..ran.summary });
    assert_eq!(*run.history(), History::read(&ran.folder.join("history.csv")).unwrap());
    assert_eq!(*run.fields(), read_fields(&ran.folder.join("fields.vtkhdf")).unwrap());
    // beside one a record, the frames of its moments
    let frames = run.frames().len();
    assert!((31..=35).contains(&frames), "{frames}");
    let last = run.frames().last().unwrap();
    assert_eq!((last.time_s, last.position_m), (0.03, run.fields().positions(frames - 1)));
    // and writes the same files, byte for byte
    let written = run.write(folder.path().join("written")).unwrap();
    assert_eq!(files(&written), files(&ran.folder));
    let manifest = |folder: &Path| netcast::results::Manifest::read(&folder.join("manifest.json")).unwrap();
    assert_eq!(manifest(&written).input_hash, manifest(&ran.folder).input_hash);
}

#[test]
fn a_run_in_memory_with_an_equilibrium_breaks_and_sparse_fields_has_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let overrides = ["record.fields_every=20 ms".to_owned(), "solve.duration=0.1".to_owned()];
    let case = Case::read(examples.join("11_tubes/tubes.toml"), &overrides).unwrap();
    let run = case.simulate().unwrap();
    let ran = case.simulation().run_to(folder.path().join("streamed")).unwrap();
    assert_eq!(run.failure, ran.failure);
    assert!(!run.summary.breaks.is_empty(), "its ties break");
    assert!(run.frames().len() < run.history().rows().len());
    let written = run.write(folder.path().join("written")).unwrap();
    assert_eq!(files(&written), files(&ran.folder));

    let case = Case::read(examples.join("05_hanging_net/hanging_net.toml"), &[]).unwrap();
    let ran = case.simulation().run_to(folder.path().join("hanging")).unwrap();
    let written = case.simulate().unwrap().write(folder.path().join("hanging_again")).unwrap();
    assert_eq!(files(&written), files(&ran.folder));
}

/// Counts what it is shown.
#[derive(Default)]
struct Counter {
    steps: u64,
    records: usize,
    snapshots: usize,
    largest: f64,
}

impl Observer for Counter {
    fn step(&mut self, live: &Live) {
        self.steps += 1;
        self.largest = self.largest.max(live.net.tension(0));
    }

    fn record(&mut self, _: &Frame) {
        self.records += 1;
    }

    fn wants_snapshot(&mut self) -> bool {
        self.records == 3
    }

    fn snapshot(&mut self, _: &netcast::dynamics::snapshot::Snapshot) {
        self.snapshots += 1;
    }
}

#[test]
fn an_observer_sees_every_step_and_changes_nothing() {
    let case = net().build().unwrap();
    let mut counter = Counter::default();
    let watched = case.simulation().observe(&mut counter).run().unwrap();
    assert_eq!((counter.steps, counter.records), (watched.summary.step.count, watched.history().rows().len()));
    assert_eq!(counter.snapshots, 1);
    assert!(counter.largest > 0.0);
    assert_eq!(watched.history(), case.simulate().unwrap().history());
}

/// Pulls one node with a force that does not change, and sees what it does.
#[derive(Debug, Clone)]
struct Puller(DVec3);

impl CustomEffect for Puller {
    fn name(&self) -> &str {
        "puller"
    }

    fn nodes(&self) -> Vec<usize> {
        vec![0]
    }

    fn act(&mut self, _time: f64, _: &dyn netcast::dynamics::moving::Net, force: &mut [DVec3]) {
        force[0] += self.0;
    }

    fn boxed_clone(&self) -> Box<dyn CustomEffect> {
        Box::new(self.clone())
    }
}

/// What the effects of the caller's own do to the first node at each record.
#[derive(Default)]
struct Felt(Vec<DVec3>);

impl Observer for Felt {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        self.0.extend(frame.net.forces_of("custom").map(|forces| forces.force[0]));
    }

    fn watches(&self) -> Vec<&'static str> {
        vec!["custom"]
    }
}

#[test]
fn a_force_of_the_callers_own_acts_in_a_case_and_an_observer_is_told_of_it() {
    let plain = net().build().unwrap();
    let pulled = plain.with_effect(Puller(DVec3::new(0.0, 0.0, -3.0))).unwrap();
    let mut felt = Felt::default();
    let run = pulled.simulation().observe(&mut felt).run().unwrap();
    assert_eq!(felt.0, vec![DVec3::new(0.0, 0.0, -3.0); run.history().rows().len()]);
    let plain = plain.simulate().unwrap();
    assert!(run.history().columns().iter().any(|column| column == "energy_custom_j"));
    assert!(!plain.history().columns().iter().any(|column| column == "energy_custom_j"));
    assert!(run.summary.energy.closure < 1e-3);
    // a node that the net does not have
    assert!(net().build().unwrap().with_effect(Elsewhere).is_err());
}

/// An effect on a node that is not there.
#[derive(Debug, Clone)]
struct Elsewhere;

impl CustomEffect for Elsewhere {
    fn name(&self) -> &str {
        "elsewhere"
    }

    fn nodes(&self) -> Vec<usize> {
        vec![usize::MAX]
    }

    fn act(&mut self, _: f64, _: &dyn netcast::dynamics::moving::Net, _: &mut [DVec3]) {}

    fn boxed_clone(&self) -> Box<dyn CustomEffect> {
        Box::new(self.clone())
    }
}

#[test]
fn a_run_stops_at_the_record_that_it_is_told_to() {
    let folder = tempfile::tempdir().unwrap();
    let case = net().build().unwrap();
    let run = case.simulation().stop_when(|frame| frame.time >= 0.01).run().unwrap();
    assert_eq!(run.frames().last().unwrap().time_s, 0.01);
    assert!(!run.summary.finished && run.failure.is_some());
    let asked = std::sync::atomic::AtomicUsize::new(0);
    let counted = || asked.fetch_add(1, std::sync::atomic::Ordering::Relaxed) >= 4;
    assert_eq!(case.simulation().interrupt_when(counted).run().unwrap().history().rows().len(), 5);
    // a run into a folder that was stopped goes on to the bits of one that was not
    let target = folder.path().join("net");
    let ran = case.simulation().stop_when(|frame| frame.time >= 0.01).run_to(&target).unwrap();
    assert!(ran.can_resume);
    let options = RunOptions { resume: true, ..RunOptions::default() };
    let resumed = case.simulation().options(options).run_to(&target).unwrap();
    assert!(resumed.failure.is_none(), "{:?}", resumed.failure);
    let whole = case.simulate().unwrap().write(folder.path().join("whole")).unwrap();
    assert_eq!(files(&whole), files(&target));
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<PathBuf> {
    let mut names: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    names
}

#[test]
fn a_run_in_memory_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("net.toml");
    fs::write(&file, SCENARIO).unwrap();
    let watched = || [folder.path(), Path::new("."), Path::new("..")].map(names);
    let before = watched();
    let run = Case::read(&file, &[]).unwrap().simulate().unwrap();
    assert!(run.failure.is_none());
    assert_eq!(watched(), before);
}

#[test]
fn facts_are_those_of_the_model() {
    let case = net().stow(Stow::scale(0.25)).set("environment.air.altitude", "0 m").build().unwrap();
    let facts = case.facts();
    // 2 * 9 ropes of 4 m, each through 9 knots; rho pi d^2 / 4 of mass a metre
    let bill = &facts.bill;
    assert!((bill.ropes.iter().map(|rope| rope.length_m).sum::<f64>() - 72.0).abs() < 1e-9, "{bill:?}");
    assert_eq!((bill.knots, bill.rope_count, bill.tractors.count), (81, 144, 4));
    assert!((bill.web_mass_kg - 72.0 * 1440.0 * std::f64::consts::PI * 1e-6).abs() < 1e-9);
    assert!((bill.thrown_mass_kg - bill.web_mass_kg - 4.0 * 0.5).abs() < 1e-12, "{bill:?}");
    assert!((bill.area_m2.unwrap() - 16.0).abs() < 1e-9);
    assert!((facts.start.longest_stretch.unwrap() + 0.75).abs() < 1e-9, "{:?}", facts.start);
    let air = facts.air.unwrap();
    assert!((air.density_kg_m3 - 1.225).abs() < 1e-6);
    assert_eq!(air.launch_speed_m_s, 500.0_f64.sqrt());
    let cost = facts.cost.unwrap();
    assert_eq!((cost.nodes, cost.segments, cost.records), (81, 144, 31));
    assert_eq!(cost.segment_updates, cost.steps as f64 * 144.0);
    let timed = cost.clone().with_step_time(1e-3);
    assert_eq!(timed.one_core_s, Some(cost.steps as f64 * 1e-3));
}

#[test]
fn any_value_can_be_set_by_its_path() {
    let case = net().set("tractors", vec![override_of_corner(2)]).build().unwrap();
    assert_eq!(case.scenario().tractors[0].corner.get(), 2);
    let case = net().overrides(&["solve.duration=40 ms".to_owned()]).build().unwrap();
    assert_eq!(case.schedule().end, 0.04);
}

/// A table of `[[tractors]]`.
fn override_of_corner(corner: i64) -> Value {
    let mut table = netcast::Table::new();
    table.insert("corner".into(), corner.into());
    table.insert("axial_speed".into(), "5 m/s".into());
    Value::Table(table)
}
