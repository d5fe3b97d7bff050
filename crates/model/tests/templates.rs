//! Templates become models, and the resolved scenario of a model gives the same model again.

use netcast_model::Model;
use netcast_scenario::init::TEMPLATES;
use netcast_scenario::{Document, Source, resolved_toml};

/// The resolved scenario of a model includes the values that the stages chose.
#[test]
fn the_resolved_scenario_gives_the_same_model() {
    let net = "web.square = { side = \"2 m\", mesh = \"0.5 m\" }\n\
               solve = { duration = \"0.1 s\", segment_length = \"0.25 m\" }\n\
               rope = { diameter = \"3 mm\", density = 1140, elastic_modulus = \"5 GPa\" }\n\
               tractor.particle.mass = 1\n";
    let wind =
        "[environment]\nair = {}\nwind = { speed = 5, power = {}, gust = { speed = 2, at = 0, duration = 1 } }\n";
    let folds = "stow.layers.container.box = { width = \"1 m\", breadth = \"0.6 m\", height = \"0.5 m\" }\n";
    let threads = "break_ties = [{ corners = true, breaking_load = 50 }]\n\
                   stitches = [{ pairs = [[\"knot 2\", \"knot 4\"]], length = 2, breaking_load = 5 }, \
                   { class = \"outline\", reach = 0.08, breaking_load = 5 }]\n";
    let led = |side: &str, corner: u32, by: f64| {
        let path = format!("[{{ time = 1, by = [{by}, {by}, 0] }}]");
        format!("drive.{side} = {{ nodes = [\"web corner {corner}\"], path = {path} }}\n")
    };
    let led = led("left", 3, 0.7) + &led("right", 1, -0.7);
    let cases = [
        "environment.orbit.altitude = \"600 km\"\n".to_owned(),
        "[environment]\ngravity = \"0 m/s^2\"\norbit.mean_motion = \"1e-3 rad/s\"\n".to_owned(),
        wind.to_owned(),
        format!("{wind}ground = {{}}\n"),
        "environment.wind.series.file = \"wind.csv\"\nenvironment.air = {}\nenvironment.ground = {}\n".to_owned(),
        "environment.ground.height = \"-2 m\"\n".to_owned(),
        format!("{folds}{threads}"),
        "stow.prescribed = { radius = \"0.3 m\", depth = \"0.4 m\" }\n".to_owned(),
        format!("[stow.prescribed]\nradius = \"0.9 m\"\n{led}"),
    ];
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("wind.csv"), "t,vx,vy,vz\n0,3,0,0\n1,5,0,0\n").unwrap();
    let model = |text: String| {
        let source = Source { name: "net.toml".into(), text: text.clone() };
        let model = Document::parse(source, folder.path(), &[]).and_then(|document| Model::new(&document));
        model.unwrap_or_else(|wrong| panic!("{wrong}\n{text}"))
    };
    for case in cases {
        let first = model(format!("{net}{case}"));
        let resolved = resolved_toml(&first.scenario);
        let again = model(resolved.clone());
        assert_eq!(again.scenario, first.scenario, "{case}");
        assert_eq!(again.state, first.state, "{case}");
        assert_eq!(resolved_toml(&again.scenario), resolved, "{case}");
    }
}

#[test]
fn no_template_lets_mass_damping_stand_for_air_in_a_long_fall() {
    for template in TEMPLATES {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in template.files {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let source = Source { name: template.kind.into(), text: template.scenario.into() };
        let model = Model::new(&Document::parse(source, folder.path(), &[]).unwrap()).unwrap();
        assert!(!model.notes.iter().any(|note| note.contains("no stand-in for air")), "{}", template.kind);
    }
}

/// The commented keys and tables of a template can be uncommented. Alternatives to other keys ("or ...") stand on lines of
/// their own.
#[test]
fn the_commented_keys_of_a_template_can_be_uncommented() {
    let in_place_of = |line: &str, keys: &[&str]| keys.iter().any(|key| line.starts_with(key));
    for (template, from_tubes) in TEMPLATES.iter().flat_map(|template| [(template, false), (template, true)]) {
        let taken_in = template.scenario.lines().filter_map(|line| match line.strip_prefix("# ") {
            _ if from_tubes && in_place_of(line, &["axial_speed", "radial_speed"]) => None,
            Some(tube) if tube.starts_with("tube = ") => from_tubes.then_some(tube),
            Some(room) if in_place_of(room, &["container", "spacing"]) => None,
            Some(table) if table.starts_with('[') => Some(table),
            Some(key) if key.split_once(" = ").is_some_and(|(key, _)| !key.contains(' ')) => Some(key),
            _ => Some(line),
        });
        let text: String = taken_in.map(|line| format!("{line}\n")).collect();
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in template.files {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let source = Source { name: template.kind.into(), text: text.clone() };
        let model = Document::parse(source, folder.path(), &[]).and_then(|document| Model::new(&document));
        model.unwrap_or_else(|wrong| panic!("{wrong}\n{text}"));
        assert!(text.contains("\nbreaking = ") && (text.contains("\n[[break_ties]]") || template.kind == "held"));
    }
}
