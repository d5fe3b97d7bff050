//! Every fault is reported with its place, what was expected and the most similar known key, and all are reported at
//! once.

mod common;

use common::{CONTRACT, parse};
use netcast_scenario::Diagnostics;
use proptest::prelude::*;

/// The scenario of `contract.toml` with one piece of text replaced.
fn with(from: &str, to: &str) -> String {
    assert_eq!(CONTRACT.matches(from).count(), 1, "{from}");
    CONTRACT.replacen(from, to, 1)
}

/// The faults of `text`, one a line.
fn wrong(text: &str, overrides: &[&str]) -> Vec<String> {
    match parse(text, overrides) {
        Ok(_) => Vec::new(),
        Err(Diagnostics(found)) => found.iter().map(ToString::to_string).collect(),
    }
}

/// The only fault of the scenario of `contract.toml` after a replacement.
fn fault_after(from: &str, to: &str) -> String {
    let found = wrong(&with(from, to), &[]);
    assert_eq!(found.len(), 1, "{found:#?}");
    found[0].clone()
}

#[test]
fn no_other_rope_can_have_the_name_of_the_default_rope() {
    let other = "[ropes.rope]\ndiameter = 0.01\ndensity = 1000\nelastic_modulus = \"1 GPa\"\n[traction_rope]";
    let message = fault_after("[traction_rope]", other);
    assert!(message.contains("ropes.rope: `rope` is the name of the default rope, [rope]"), "{message}");
}

#[test]
fn a_wrong_number_of_sides_is_reported_with_the_other_faults() {
    let net = "web.polygon = { sides = 25, side = 1, mesh = 0.2 }\nrope = { diameter = 0.01, material = \"no such\" }\n\
               solve.duration = 1\n";
    let found = wrong(net, &[]);
    assert!(found.iter().any(|message| message.contains("web.polygon.sides: expected a whole number")), "{found:#?}");
    assert!(found.iter().any(|message| message.contains("no such")), "{found:#?}");
}

/// Words of the field that are no keys of ours, units of two meanings, and angles that were meant in degrees.
#[test]
fn words_that_people_write_are_answered_with_ours() {
    let speed = "axial_speed = \"50 m/s\"";
    for (written, answer) in [
        ("speed = 50", "netcast calls it `axial_speed`"),
        ("angle = 1", "netcast calls it `elevation`"),
        ("direction = 1", "netcast calls it `azimuth`"),
        ("height = 2", "`environment.ground.height = \"-2 m\"`"),
        ("axial_speed = \"8 kn\"", "did you mean \"knots\"?"),
    ] {
        let told = fault_after(speed, written);
        assert!(told.contains(answer), "{written}: {told}");
    }
    assert!(fault_after("elevation = \"90 deg\"", "elevation = 45").contains("write \"45 deg\""));
    let bare = wrong(&CONTRACT.replace("azimuth = \"0 deg\"", "azimuth = 45"), &[]).join("\n");
    assert!(bare.contains("a bare number is in radians; write \"45 deg\""), "{bare}");
    let top = wrong(
        "bullet.mass = 1\nweb.square = { side = 1, mesh = 0.1 }\nsolve.duration = 1\n\
                     rope = { diameter = 0.01, material = \"UHMWPE\" }\ntractor.particle.weight = 1\n",
        &[],
    )
    .join("\n");
    for answer in ["netcast calls it `tractor`", "did you mean \"UHMWPE rope\"", "netcast calls it `mass`"] {
        assert!(top.contains(answer), "{answer}: {top}");
    }
    // forces in kilonewtons keep their hint
    let force = wrong("rope = { diameter = 0.01, material = \"nylon rope\", strength = \"8 kn\" }\n", &[]).join("\n");
    assert!(force.contains("did you mean \"kN\"?"), "{force}");
}

#[test]
fn a_wrong_dimension_is_named() {
    assert_eq!(
        fault_after("side = \"2.5 m\"", "side = \"2.5 kg\""),
        "net.toml:4:8: web.space.side: expected a length greater than 0 such as \"2.5 m\", found \"2.5 kg\", which is a mass"
    );
    assert_eq!(
        fault_after("axial_speed = \"50 m/s\"", "axial_speed = \"50 km\""),
        "net.toml:29:15: launch.axial_speed: expected a speed such as \"50 m/s\", found \"50 km\", which is a length"
    );
    assert!(fault_after("side = \"2.5 m\"", "side = \"2.5\"").ends_with("found \"2.5\", which has no unit"));
    assert!(fault_after("elevation = \"90 deg\"", "elevation = \"90\"").contains("expected an angle"));
}

#[test]
fn a_value_out_of_range_is_reported_with_the_range() {
    let expected = "net.toml:4:8: web.space.side: expected a length greater than 0 such as \"2.5 m\", found";
    for (to, found) in [
        ("side = \"-2.5 m\"", "\"-2.5 m\""),
        ("side = \"0 m\"", "\"0 m\""),
        ("side = 0", "0.0"),
        ("side = -1", "-1.0"),
        ("side = nan", "NaN"),
        ("side = true", "true"),
        ("side = [1]", "an array"),
    ] {
        assert_eq!(fault_after("side = \"2.5 m\"", to), format!("{expected} {found}"));
    }
    // beyond the largest size of its kind, the message states that too
    for (to, found) in [("side = inf", "inf"), ("side = 2e6", "2000000.0")] {
        assert!(
            fault_after("side = \"2.5 m\"", to).ends_with(&format!("and at most 1e6 such as \"2.5 m\", found {found}"))
        );
    }
    assert!(fault_after("side = \"2.5 m\"", "side = \"NaN m\"").ends_with("it does not start with a number"));
    assert!(fault_after("elevation = \"90 deg\"", "elevation = \"91 deg\"").contains("at most 90 deg"));
    assert!(fault_after("count = 1", "count = 0").contains("expected a whole number of at least 1"));
    assert!(fault_after("count = 1", "count = -1").contains("expected a whole number of at least 1"));
    assert!(fault_after("count = 1", "count = 1.5").contains("expected a whole number"));
    assert!(fault_after("count = 1", "count = 99999999999").contains("found the number 99999999999"));
    assert!(fault_after("count = 1", "count = 99999999999999999999").contains("64 bits"));
    assert!(fault_after("radius = \"0.25 m\"", "depth = 1").contains("missing key `radius`"));
}

#[test]
fn an_unknown_key_is_reported_with_the_most_similar_key() {
    assert_eq!(
        fault_after("segment_length", "segment_lenght"),
        "net.toml:41:1: solve.segment_lenght: unknown key `segment_lenght` (did you mean `segment_length`? known here: \
         duration, static, segment_length, step_fraction, energy_tolerance, web_energy_tolerance, on_energy_error)"
    );
    // a misspelt required key is reported once, not also as missing
    assert!(fault_after("duration", "duraton").contains("did you mean `duration`?"));
    assert!(
        fault_after("[launch]", "[lunch]")
            .starts_with("net.toml:28:2: lunch: unknown key `lunch` (did you mean `launch`?")
    );
    // a key that belongs elsewhere
    let text = with("every = \"1 ms\"", "every = \"1 ms\"\nduration = 3");
    assert_eq!(
        wrong(&text, &[]),
        [
            "net.toml:45:1: record.duration: unknown key `duration` (it exists at environment.wind.gust.duration, solve.duration; \
             known here: every, fields_every)"
        ]
    );
}

#[test]
fn an_unknown_unit_is_reported_with_the_most_similar_unit() {
    assert!(fault_after("\"78 GPa\"", "\"78 gpa\"").ends_with("unknown unit \"gpa\", did you mean \"GPa\"?"));
    assert!(fault_after("\"1850 kg/m^3\"", "\"1850 kg/m3\"").ends_with("unknown unit \"m3\", did you mean \"m^3\"?"));
    assert!(fault_after("\"2.5 m\"", "\"2,5 m\"").ends_with("write the decimal point as \".\""));
}

#[test]
fn a_missing_key_is_reported_at_its_table() {
    assert_eq!(
        fault_after("density = \"1850 kg/m^3\"\n", ""),
        "net.toml:6:2: rope.density: missing key `density` (`density` is a density greater than 0 such as \"1850 kg/m^3\")"
    );
    let found = wrong("title = \"nothing\"\n", &[]);
    assert_eq!(found.len(), 3, "{found:#?}");
    assert_eq!(
        found[0],
        "net.toml:1:1: web: missing key `web` (write one of [web.traditional], [web.topological], [web.space], \
         [web.square], [web.polygon], [web.radial], [web.diamond], [web.graph])"
    );
    assert_eq!(wrong("", &[]).len(), 3);
}

#[test]
fn the_name_of_a_table_chooses_the_variant() {
    assert!(
        fault_after("[web.space]", "[web.spce]")
            .starts_with("net.toml:3:6: web.spce: unknown key `spce` (did you mean `space`?")
    );
    assert!(
        fault_after("[web.space]", "[web]\ntype = \"space\"\n[web.space]")
            .contains("web.type: unknown key `type` (the kind is the name of a table: write [web.space])")
    );
    let text = with("[web.space] ", "[web] #").replace("side = \"2.5 m\"\n", "");
    assert!(wrong(&text, &[])[0].starts_with("net.toml:3:2: web: expected one of [web.traditional],"));
    assert!(
        fault_after(
            "[stow.bag]               # also: scale, zigzag, star, roll, layers, prescribed, file\nradius = \"0.25 m\"",
            "[stow]"
        )
        .ends_with(
            "stow: expected one of [stow.scale], [stow.bag], [stow.zigzag], [stow.star], [stow.roll], [stow.layers], \
             [stow.prescribed], [stow.file], found an empty table"
        )
    );
    let two = with("[stow.bag]", "[stow.scale]\nfactor = 0.5\n[stow.bag]");
    let found = wrong(&two, &[]);
    assert_eq!(found.len(), 1);
    assert!(
        found[0].starts_with("net.toml:27:7: stow.bag: expected only one of these tables, found `scale` and `bag`"),
        "{found:?}"
    );
    let text = with("title =", "web = \"space\"\ntitle =").replace("[web.space]", "[other]");
    assert!(wrong(&text, &[])[0].starts_with("net.toml:1:7: web: expected one of [web.traditional],"));
}

#[test]
fn a_key_of_a_later_version_is_reported_as_such() {
    for (from, to, path) in
        [("[record]", "[contact.target]\n[record]", "contact"), ("[record]", "[targets.sphere]\n[record]", "targets")]
    {
        let message = fault_after(from, to);
        assert!(message.ends_with(&format!("`{path}` is not available in this version yet")), "{message}");
    }
}

#[test]
fn two_keys_for_the_same_thing_are_refused() {
    assert_eq!(
        fault_after("# damping_ratio = 0.05 ", "damping_ratio = 0.05 #"),
        "net.toml:11:1: rope.damping_ratio: expected only one of `damping_time` and `damping_ratio`"
    );
    assert!(
        fault_after("density = \"17700 kg/m^3\"", "density = \"17700 kg/m^3\"\nmass = 3")
            .contains("expected only one of `density` and `mass`")
    );
    let text = with("[web.space]", "[web.square]\nmesh = 0.5\nsegments_per_mesh = 2");
    let found = wrong(&text, &[]);
    assert!(
        found.iter().any(|line| line.contains("web.square.segments_per_mesh` and `solve.segment_length")),
        "{found:#?}"
    );
    assert!(found.iter().any(|line| line.contains("only a space web has a canopy")), "{found:#?}");
}

#[test]
fn unknown_ropes_and_repeated_corners_are_reported() {
    let text = format!(
        "{CONTRACT}\n[ropes.thick]\ndiameter = 0.02\ndensity = 1850\nelastic_modulus = 78e9\n[assign]\ntraction = \"thik\"\n"
    );
    assert_eq!(wrong(&text, &[]), ["net.toml:51:12: assign.traction: unknown rope \"thik\" (did you mean \"thick\"?)"]);
    let text = format!("{CONTRACT}\n[[tractors]]\ncorner = 2\n[[tractors]]\ncorner = 2\n");
    assert_eq!(
        wrong(&text, &[]),
        ["net.toml:49:10: tractors[1].corner: corner 2 already has an entry in [[tractors]]"]
    );
}

#[test]
fn all_faults_are_reported_at_once_in_the_order_of_the_file() {
    let text = with("side = \"2.5 m\"", "side = \"2.5 kg\"")
        .replace("every = \"1 ms\"", "every = \"-1 ms\"")
        .replace("[launch]", "[launch]\nspeed = 3")
        .replace("count = 1 ", "count = \"one\" ");
    let paths: Vec<String> = match parse(&text, &["solve.duration=0", "nonsense=1"]) {
        Err(Diagnostics(found)) => found.into_iter().map(|one| one.path).collect(),
        Ok(_) => panic!(),
    };
    assert_eq!(
        paths,
        ["web.space.side", "traction_rope.count", "launch.speed", "record.every", "solve.duration", "nonsense"]
    );
}

#[test]
fn a_fault_of_an_override_shows_the_override() {
    assert_eq!(
        wrong(CONTRACT, &["launch.axal_speed=60 m/s"]),
        [
            "--set launch.axal_speed=60 m/s: launch.axal_speed: unknown key `axal_speed` (did you mean `axial_speed`? known \
          here: axial_speed, radial_speed, spread, elevation, azimuth, spin, attitude, tube, scatter)"
        ]
    );
    assert!(
        wrong(CONTRACT, &["launch.axial_speed=60 kg"])[0]
            .starts_with("--set launch.axial_speed=60 kg: launch.axial_speed:")
    );
    assert!(wrong(CONTRACT, &["tractors.0.axial_speed=60"])[0].contains("tractors"));
    assert_eq!(
        wrong(CONTRACT, &["title"]),
        ["--set title: expected path=value, such as launch.axial_speed=\"60 m/s\""]
    );
}

#[test]
fn text_that_is_not_toml_is_reported_at_its_place() {
    let found = wrong(&with("[web.space]", "[web.space"), &[]);
    assert!(found[0].starts_with("net.toml:3:"), "{found:#?}");
    let found = wrong(&with("count = 1 ", "count = 1\ncount = 2 "), &[]);
    assert!(found[0].starts_with("net.toml:19:1: duplicate key"), "{found:#?}");
    let found = wrong(&with("duration = \"0.6 s\"", "duration = 0.6 s"), &[]);
    assert!(found[0].starts_with("net.toml:40:"), "{found:#?}");
}

#[test]
fn a_missing_scenario_is_reported_by_name() {
    let Err(Diagnostics(found)) = netcast_scenario::Document::read("no/such.toml".as_ref(), &[]) else { panic!() };
    assert!(found[0].message.starts_with("cannot read no/such.toml: "));
    assert_eq!(found[0].location(), None);
}

#[test]
fn a_later_stage_can_report_a_fault_at_its_place() {
    let document = parse(CONTRACT, &["solve.duration=0.7"]).unwrap();
    let text = format!("{CONTRACT}\n[[tractors]]\ncorner = 2\n");
    let found = parse(&text, &[]).unwrap().diagnostic("tractors.0.corner", "");
    assert_eq!((found.path.as_str(), found.location().unwrap().line), ("tractors[0].corner", 47));
    let place = |path: &str| document.diagnostic(path, "").location().map(|at| (at.line, at.column));
    assert_eq!(place("stow.bag.radius"), Some((26, 10)));
    assert_eq!(place("stow.bag.depth"), Some((25, 7)));
    assert_eq!(place("solve.duration"), None);
}

#[test]
fn deep_nesting_is_refused_without_a_crash() {
    for text in ["[".repeat(100_000), format!("a = {}", "[".repeat(100_000)), format!("{}a = 1", "a.".repeat(100_000))]
    {
        assert!(parse(&text, &[]).is_err());
    }
    assert!(parse(CONTRACT, &[&format!("{}a=1", "a.".repeat(100_000))]).is_err());
}

proptest! {
    #[test]
    fn random_text_never_panics(text in "\\PC*", set in "\\PC*") {
        if let Err(found) = parse(&text, &[&set]) {
            prop_assert!(!found.to_string().is_empty());
        }
    }

    #[test]
    fn a_damaged_scenario_never_panics(start in 0usize..1500, length in 0usize..40, patch in "[\\[\\]={}\"'.a-z0-9\n -]{0,20}") {
        let start = start.min(CONTRACT.len());
        let end = (start + length).min(CONTRACT.len());
        let text = format!("{}{patch}{}", &CONTRACT[..start], &CONTRACT[end..]);
        if let Err(Diagnostics(found)) = parse(&text, &[]) {
            for diagnostic in found {
                let at = diagnostic.location().unwrap();
                prop_assert!(at.line >= 1 && at.line <= text.matches('\n').count() + 1);
            }
        }
    }
}

/// A file of another kind was once reported line by line, in a time that grew with the square of its length.
#[test]
fn faults_of_a_file_of_another_kind_are_counted() {
    let table: String = (0..5000).map(|row| format!("n{row},0,0,0\n")).collect();
    let found = wrong(&table, &[]);
    assert_eq!(found.len(), 21);
    assert_eq!(found[20], "net.toml:5001:1: and 4980 more lines that are not TOML");

    let settings: String = (0..5000).map(|key| format!("key_{key} = {key}\n")).collect();
    let found = wrong(&settings, &[]);
    assert_eq!(found.iter().filter(|line| line.contains("unknown key")).count(), 100);
    // the three required keys are missing as well
    assert_eq!(found.last().unwrap(), "net.toml:5001:1: and 4903 more faults");
}
