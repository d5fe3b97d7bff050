//! `[rope.law.LAW]` and `[rope.breaking]`: the laws of the system, and the mistakes that are reported.

use netcast_dynamics::forces::bilinear::Bilinear;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::viscoelastic::Viscoelastic;
use netcast_dynamics::system::Segment;
use netcast_model::Model;
use netcast_scenario::{Diagnostics, Document};

const NET: &str = "web.square = { side = 1, mesh = 0.5, segments_per_mesh = 3 }\nsolve.duration = 0.1\n";
const ROPE: &str = "[rope]\ndiameter = \"2 mm\"\ndensity = 1000\nelastic_modulus = \"1 GPa\"\n";
const BELT: &str = "strain,tension,unloading\n0,0,0\n0.02,100,10\n0.1,1000,1000\n";
/// Axial stiffness of the rope, N.
const AXIAL: f64 = 1e9 * 0.25e-6 * 4.0 * std::f64::consts::PI;

fn model(more: &str, belt: &str) -> Result<Model, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("net.toml", &format!("{NET}{ROPE}{more}")[..]), ("belt.csv", belt)] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    Model::new(&Document::read(&folder.path().join("net.toml"), &[])?)
}

fn made(more: &str) -> Model {
    model(more, BELT).unwrap_or_else(|wrong| panic!("{wrong}"))
}

/// The mistakes, as `file:line: path: message (help)`.
fn wrong(more: &str, belt: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = model(more, belt) else { panic!("nothing is wrong") };
    let told = found.iter().map(|one| {
        let at = one.location().unwrap();
        let file = std::path::Path::new(&at.file).file_name().unwrap().to_string_lossy().into_owned();
        let help = one.help.as_ref().map_or(String::new(), |help| format!(" ({help})"));
        format!("{file}:{}: {}: {}{help}", at.line, one.path, one.message)
    });
    told.collect()
}

#[test]
fn each_table_gives_the_law_of_its_name() {
    let laws = |more: &str| made(more).system.laws().to_vec();
    let linear = vec![Law::Linear; 2];
    assert_eq!([laws(""), laws("law.linear = {}\n")], [linear.clone(), linear]);
    assert_eq!(laws("law.strut = {}\n")[0], Law::Strut);
    assert_eq!(
        laws("law.bilinear = { strain = \"2 %\", second_modulus = \"4 GPa\" }\n")[0],
        Law::Bilinear(Bilinear { strain: 0.02, ratio: 4.0 })
    );
    assert_eq!(
        laws("law.viscoelastic = { instantaneous_modulus = \"2.5 GPa\", relaxation_time = \"10 ms\" }\n")[0],
        Law::Viscoelastic(Viscoelastic { ratio: 1.5, relaxation_time: 0.01 })
    );
    let [Law::Tabulated(table), _] = &laws("law.table.file = \"belt.csv\"\n")[..] else { panic!("no table") };
    assert!(table.has_hysteresis() && table.strain_under(550.0) == 0.06);
}

#[test]
fn each_link_class_has_the_law_of_its_rope() {
    let more = "[ropes.belt]\ndiameter = \"2 mm\"\ndensity = 1000\nelastic_modulus = \"1 GPa\"\n\
        law.table.file = \"belt.csv\"\n[assign]\noutline = \"belt\"\n";
    let model = made(more);
    for (group, law) in model.groups.iter().zip(model.system.laws()) {
        assert_eq!(group.class.name() == "outline", matches!(law, Law::Tabulated(_)), "{group:?}");
    }
}

/// Pretension shortens a rope by the strain of its law. The stored energy is that of the law, too.
#[test]
fn pretension_gives_the_strain_and_the_energy_of_the_law() {
    let straight = 500.0 / AXIAL;
    let bent = 0.1 + (500.0 - 0.1 * AXIAL) / (4.0 * AXIAL);
    // strain, and the energy of a metre where it is a closed form
    let cases = [
        ("", straight, Some(250.0 * straight)),
        (
            "law.bilinear = { strain = 0.1, second_modulus = \"4 GPa\" }\n",
            bent,
            Some(0.005 * AXIAL + 0.5 * (0.1 * AXIAL + 500.0) * (bent - 0.1)),
        ),
        ("law.table.file = \"belt.csv\"\n", 0.02 + 0.08 * 400.0 / 900.0, None),
        (
            "law.viscoelastic = { instantaneous_modulus = \"2 GPa\", relaxation_time = 1 }\n",
            straight,
            Some(250.0 * straight),
        ),
    ];
    for (law, strain, energy) in cases {
        let model = made(&format!("pretension = \"500 N\"\n{law}"));
        let Segment { rest_length, .. } = model.system.segments()[0];
        assert!((0.5 / 3.0 / rest_length - 1.0 - strain).abs() < 1e-12, "{law}: {rest_length} m");
        // twelve sides of meshes
        let length = 6.0 / (1.0 + strain);
        if let Some(energy) = energy {
            assert!((model.audit.stored_energy / (length * energy) - 1.0).abs() < 1e-12, "{law}");
        }
    }
}

#[test]
fn a_rope_breaks_at_the_load_and_strain_of_the_scenario() {
    let of_all = |more: &str| made(more).system.segments().iter().map(|s| s.breaking).collect::<Vec<Breaking>>();
    let never = Breaking::NEVER;
    assert!(of_all("strength = \"1 kN\"\n").iter().all(|b| *b == never), "a strength alone states margins");
    let at = |load: f64, strain: f64| Breaking { load, strain, ..Breaking::NEVER };
    let cases = [
        ("strength = \"1 kN\"\nbreaking = {}\n", at(1e3, f64::INFINITY)),
        ("strength = \"1 kN\"\nbreaking.load = \"2 kN\"\n", at(2e3, f64::INFINITY)),
        ("breaking.strain = \"3 %\"\n", at(f64::INFINITY, 0.03)),
        ("material = \"polyester rope\"\nbreaking.load = 7\n", at(7.0, f64::INFINITY)),
    ];
    for (more, expected) in cases {
        assert!(of_all(more).iter().all(|b| *b == expected), "{more}");
    }
    // each of the twelve ropes has three segments, of which the outer two meet knots
    let knotted = of_all("strength = \"1 kN\"\nknot_reduction = 0.4\nbreaking = {}\n");
    let loads: Vec<f64> = knotted.iter().map(|b| b.load).collect();
    assert_eq!(loads.iter().filter(|load| **load == 600.0).count(), 24);
    assert_eq!(loads.iter().filter(|load| **load == 1000.0).count(), 12);
}

#[test]
fn mistakes_are_reported_at_their_place() {
    let told = |more: &str| wrong(more, BELT);
    assert_eq!(
        told("breaking = {}\n"),
        ["net.toml:7: rope.breaking: expected a load or a strain at which this rope breaks, found none \
          (give `rope.strength`, `rope.breaking.load` or `rope.breaking.strain`)"]
    );
    assert_eq!(
        told("law.viscoelastic = { instantaneous_modulus = \"1 GPa\", relaxation_time = 1 }\n"),
        [
            "net.toml:7: rope.law.viscoelastic.instantaneous_modulus: expected more than the elastic modulus, 1000000000 \
          Pa, to which it relaxes"
        ]
    );
    let unknown = &told("law.bilinera = {}\n")[0];
    assert!(unknown.contains("did you mean `bilinear`?"), "{unknown}");
    let two = &told("law = { linear = {}, strut = {} }\n")[0];
    assert!(two.contains("expected only one of these tables, found `linear` and `strut`"), "{two}");
    assert!(told("law.table.file = \"belts.csv\"\n")[0].contains("cannot read"));
    let stowed = &told("law.strut = {}\n[stow.scale]\nfactor = 0.5\n")[0];
    assert!(stowed.contains("compresses struts: segment 1 of") && stowed.contains("by 50.000 %"), "{stowed}");
}

#[test]
fn a_wrong_table_is_reported_at_its_row() {
    let told = |belt: &str| wrong("law.table.file = \"belt.csv\"\n", belt);
    let table = "rope.law.table.file";
    for (belt, expected) in [
        (
            "strain,tension\n0,0\n0.1,5\n0.1,7\n",
            "4: {}: row 3: expected a larger strain than in the row before, and no smaller tension",
        ),
        ("strain,tension\n0.1,5\n0.2,7\n", "2: {}: expected strain 0 and tension 0 in the first row"),
        ("strain,tension\n0,0\n0.1,x\n", "3: {}: tension: expected a number, found \"x\""),
        ("strain,tension,unloading\n0,0,0\n0.1,5,\n", "3: {}: unloading: expected a number, found nothing"),
        ("strain,force\n0,0\n", "1: {}: unknown column \"force\", expected the columns strain,tension,unloading"),
        ("strain,tension\n0,0\n", "1: {}: expected two rows or more, and the same number of values in each column"),
        (
            "strain,tension,unloading\n0,0,0\n0.1,10,9\n0.2,20,2\n0.3,30,30\n",
            "4: {}: row 3: expected a ratio of unloading to loading tension no smaller than in the row before",
        ),
        (
            "strain,tension,unloading\n0,0,0\n0.1,10,9\n",
            "1: {}: expected the same loading and unloading tension in the last row, 10 N, found 9 N",
        ),
    ] {
        assert_eq!(told(belt)[0], format!("belt.csv:{}", expected.replace("{}", table)));
    }
    // a curve that ends level never exceeds that tension
    let level =
        wrong("pretension = \"20 N\"\nlaw.table.file = \"belt.csv\"\n", "strain,tension\n0,0\n0.1,10\n0.2,10\n");
    assert_eq!(level, ["net.toml:7: rope.pretension: the law of this rope never reaches 20 N"]);
}
