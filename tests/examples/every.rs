//! Every example runs at its default settings to its end, and its energy balance closes.

use std::fs;
use std::path::{Path, PathBuf};

use netcast::webs::Class;
use netcast::{Document, Model, Scenario};

use crate::runs;
use crate::support::examples;

/// An example: a folder with one scenario.
struct Example {
    name: String,
    folder: PathBuf,
    scenario: PathBuf,
}

fn all() -> Vec<Example> {
    let folders = fs::read_dir(examples()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    // a folder with reported.toml compares other examples and has no scenario of its own
    let runs = folders.filter(|folder| !folder.join("reported.toml").exists());
    let mut all: Vec<Example> = runs.map(|folder| Example::at(&folder)).collect();
    all.sort_by(|a, b| a.name.cmp(&b.name));
    assert!(!all.is_empty());
    all
}

impl Example {
    fn at(folder: &Path) -> Example {
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let scenarios: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
        assert_eq!(scenarios.len(), 1, "examples/{name} has not one .toml but {scenarios:?}");
        Example { name, folder: folder.to_owned(), scenario: scenarios[0].clone() }
    }

    fn read(&self) -> Document {
        Document::read(&self.scenario, &[]).unwrap_or_else(|errors| panic!("{errors}"))
    }

    /// Runs it and checks its results.
    fn check(&self) {
        let run = runs::example(&self.scenario);
        let (name, summary, model) = (&self.name, &run.ran.summary, &run.model);
        assert_eq!(run.ran.failure, None, "{name}");
        let energy = &summary.energy;
        println!("{name}: closure {:.2e}, of the web {:?}", energy.closure, energy.closure_web);
        assert!(energy.closure <= 0.003, "{name}: closure {}", energy.closure);
        let closure_web = energy.closure_web.unwrap_or_else(|| panic!("{name}: no closure of the web"));
        assert!(closure_web <= 0.01, "{name}: closure of the web {closure_web}");

        // the summary has the measures that the web allows
        let opening = &summary.opening;
        assert_eq!(opening.area_max_m2.is_some(), !model.cut.web.outline.is_empty(), "{name}: area");
        assert_eq!(opening.tractor_area_max_m2.is_some(), model.tractors.len() >= 3, "{name}: area of the tractors");
        assert_eq!(summary.points["tractor"].is_some(), !model.tractors.is_empty(), "{name}: tractors");
        for point in ["corner", "centre", "B"] {
            assert!(summary.points[point].is_some(), "{name}: {point}");
        }
        assert!(summary.tension.max_n > 0.0, "{name}: nothing is ever pulled");
        // a web cannot open beyond the flat one by more than its ropes stretch
        let share = opening.area_max_m2.unwrap() / opening.reference_area_m2.unwrap();
        assert!(share > 0.5 && share < 1.1, "{name} opens to {share} of the flat web");

        let times: Vec<f64> = run.history.values("time_s").unwrap().map(Option::unwrap).collect();
        assert_eq!(times[0], 0.0, "{name}");
        assert!(times.is_sorted_by(|a, b| a < b), "{name}: times do not ascend");
        let duration = model.scenario.solve.run_time().expect("an example runs in time");
        assert!((times.last().unwrap() - duration).abs() <= 1e-9 * duration, "{name} ends at {:?}", times.last());
    }
}

#[test]
fn every_example_runs_to_its_end_and_its_energy_balance_closes() {
    let all = all();
    // one thread each: no example waits for a longer one
    std::thread::scope(|scope| {
        let running: Vec<_> = all.iter().map(|example| (example, scope.spawn(|| example.check()))).collect();
        let failed: Vec<&str> =
            running.into_iter().filter_map(|(example, run)| run.join().is_err().then_some(&example.name[..])).collect();
        assert!(failed.is_empty(), "see above for {failed:?}");
    });
}

#[test]
fn the_net_shot_from_the_ground_drifts_with_the_wind_and_lands() {
    let run = runs::example(&examples().join("12_from_the_ground/from_the_ground.toml"));
    let (flight, channels) = (&run.ran.summary.flight, &run.ran.summary.energy.channels);
    let (touches, lies) = (flight.touches_down_s.unwrap(), flight.lies_from_s.unwrap());
    assert!(flight.apex_time_s.unwrap() < touches && touches < lies && lies < 3.4, "{flight:?}");
    // the shot is along x, the wind along y
    let downwind = flight.drift_m.unwrap() * flight.drift_azimuth_rad.unwrap().sin();
    assert!(downwind > 1.0, "{downwind} m downwind");
    assert!(channels["air"] > 0.0 && channels["ground_friction"] > 0.0, "{channels:?}");
}

#[test]
fn the_ties_of_the_net_from_tubes_break_and_its_ropes_do_not() {
    let run = runs::example(&examples().join("11_tubes/tubes.toml"));
    let ties = run.model.groups.iter().position(|group| group.class == Class::Tie).unwrap();
    let ties = run.model.system.segments().iter().filter(|segment| segment.group == ties).count();
    let breaks = &run.ran.summary.breaks;
    assert!(ties == 4 && breaks.len() == ties && breaks.iter().all(|one| one.released), "{breaks:?}");
}

#[test]
fn every_example_has_a_readme_that_says_how_to_run_it() {
    for example in all() {
        let readme = fs::read_to_string(example.folder.join("README.md"))
            .unwrap_or_else(|error| panic!("examples/{}/README.md: {error}", example.name));
        assert!(readme.starts_with("# "), "{}: the README has no title", example.name);
        let file = example.scenario.file_name().unwrap().to_string_lossy();
        let path = format!("examples/{}/{file}", example.name);
        assert!(readme.contains(&path), "{}: the README does not name {path}", example.name);
    }
}

/// Each file in the folder of an example is its README, its scenario, named by the scenario, or a script that the README names.
#[test]
fn no_example_has_an_unused_file() {
    for example in all() {
        let text = fs::read_to_string(&example.scenario).unwrap();
        for entry in fs::read_dir(&example.folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let readme = fs::read_to_string(example.folder.join("README.md")).unwrap_or_default();
            let is_script = name.ends_with(".sh") && readme.contains(&name);
            let is_known = name == "README.md" || path == example.scenario || is_script;
            assert!(is_known || text.contains(&name), "{}: {name}", example.name);
        }
    }
}

/// The three scenarios of the paper differ in their web only, so that their results can be compared.
#[test]
fn the_scenarios_of_the_paper_differ_in_the_web_only() {
    let read = |folder: &str| Example::at(&examples().join(folder)).read().scenario;
    let space = read("03_space_web");
    for folder in ["01_traditional_web", "02_topological_web"] {
        let other = Scenario {
            title: space.title.clone(),
            web: space.web.clone(),
            canopy: space.canopy.clone(),
            payload: space.payload.clone(),
            ..read(folder)
        };
        assert_eq!(other, space, "{folder}");
    }
}

/// The scenarios of the space web differ in the model of their canopies only.
#[test]
fn the_scenarios_of_the_space_web_differ_in_the_canopies_only() {
    let folder = examples().join("03_space_web");
    let space = Example::at(&folder).read().scenario;
    for file in ["rigid.toml", "plate.toml", "cloth.toml"] {
        let document = Document::read(&folder.join("canopies").join(file), &[]).unwrap_or_else(|e| panic!("{e}"));
        Model::new(&document).unwrap_or_else(|errors| panic!("{errors}"));
        let canopy = space.canopy.clone();
        assert_eq!(Scenario { title: space.title.clone(), canopy, ..document.scenario }, space, "{file}");
    }
}
