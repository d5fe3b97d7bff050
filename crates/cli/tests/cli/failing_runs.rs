//! Runs that fail: status 3, the results so far are kept, and the message says what to do.

use crate::workbench::{Ended, Workbench};

/// Undamped ropes at a step near the stability limit: energy grows at every slack-taut event until it overflows.
const DIVERGES: [&str; 4] = ["--set", "rope.damping_ratio=0", "--set", "solve.step_fraction=0.99"];

/// A step that is too large for the energy balance but still stable.
const MISSES_BALANCE: [&str; 4] = ["--set", "solve.step_fraction=0.99", "--set", "solve.energy_tolerance=1e-5"];

fn run(workbench: &Workbench, more: &[&str]) -> Ended {
    let arguments: Vec<&str> = ["run", "net.toml"].iter().chain(more).copied().collect();
    workbench.netcast(&arguments)
}

/// The override that a message offers.
fn offered(message: &str) -> &str {
    let override_ = message.split("--set ").nth(1).unwrap_or_else(|| panic!("{message}"));
    override_.split_whitespace().next().unwrap()
}

#[track_caller]
fn assert_readable(workbench: &Workbench, folder: &str) {
    for file in ["summary.json", "history.csv", "fields.vtkhdf", "report.html", "manifest.json", "inputs/scenario.toml"]
    {
        assert!(workbench.path(folder).join(file).is_file(), "{file}");
    }
    let history = workbench.read(&format!("{folder}/history.csv"));
    for cell in history.lines().skip(1).flat_map(|line| line.split(',')) {
        assert!(cell.is_empty() || cell.parse::<f64>().is_ok_and(f64::is_finite), "{cell:?}");
    }
    workbench.succeed(&["report", folder]);
}

/// The run ended with status 1, "a number under `opening` of the summary is not finite", and kept nothing.
#[test]
fn a_diverging_run_keeps_its_results_and_says_what_to_do() {
    let workbench = Workbench::with_net();
    let long = ["--set", "solve.duration=0.6 s", "--set", "record.every=20 ms"];
    let ended = run(&workbench, &[&DIVERGES[..], &long].concat());
    assert_eq!(ended.status, 3, "{}", ended.stderr);
    assert!(ended.stderr.contains("the run failed"), "{}", ended.stderr);
    assert!(ended.stderr.contains("what was computed is in"), "{}", ended.stderr);
    assert!(ended.stdout.contains("The run stopped before its end"), "{}", ended.stdout);
    assert_readable(&workbench, "results/net");
    let summary = workbench.summary("results/net");
    assert_eq!(summary["finished"], false);
    assert!(!summary["warnings"].as_array().unwrap().is_empty());

    // the offered step resolves the motion
    let better = run(&workbench, &["--set", "rope.damping_ratio=0", "--set", offered(&ended.stderr), "--quiet"]);
    assert_eq!(workbench.summary("results/net")["finished"], true, "{}", better.stderr);
}

#[test]
fn a_run_that_misses_its_energy_balance_fails_and_its_advice_works() {
    let workbench = Workbench::with_net();
    let ended = run(&workbench, &MISSES_BALANCE);
    assert_eq!(ended.status, 3, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains("the energy balance misses its tolerance"), "{}", ended.stderr);
    assert!(ended.stderr.contains("or accept it with --set solve.on_energy_error=flag"), "{}", ended.stderr);
    assert!(ended.stdout.contains("do not trust these numbers"), "{}", ended.stdout);
    // the message comes once, at the end
    assert!(!ended.stdout.contains("misses its tolerance"), "{}", ended.stdout);
    assert_readable(&workbench, "results/net");

    let mended = run(&workbench, &[&MISSES_BALANCE[..], &["--quiet", "--set", offered(&ended.stderr)]].concat());
    assert_eq!(mended.status, 0, "{}", mended.stderr);
}

#[test]
fn a_large_error_of_the_energy_balance_stops_the_run_at_once() {
    let workbench = Workbench::with_net();
    let ended = run(&workbench, &MISSES_BALANCE);
    let whole =
        run(&workbench, &[&MISSES_BALANCE[..], &["--set", "solve.on_energy_error=flag", "--out", "whole"]].concat());
    assert_eq!(whole.status, 0, "{}", whole.stderr);
    let (stopped, whole) = (workbench.summary("results/net"), workbench.summary("whole"));
    assert_eq!((&stopped["finished"], &whole["finished"]), (&false.into(), &true.into()));
    let step = stopped["step"]["count"].as_u64().unwrap();
    assert!(step < whole["step"]["count"].as_u64().unwrap(), "{step}");
    // the message names the step and the segment
    assert!(ended.stderr.contains(&format!("at step {step} at ")), "{}", ended.stderr);
    assert!(ended.stderr.contains("where segment ") && ended.stderr.contains("pulls hardest"), "{}", ended.stderr);
    // the records before it are those of the run that went on
    let (stopped, whole) = (workbench.read("results/net/history.csv"), workbench.read("whole/history.csv"));
    assert!(stopped.lines().count() > 2 && whole.starts_with(&stopped));
}

#[test]
fn a_small_error_of_the_energy_balance_is_judged_at_the_end() {
    let workbench = Workbench::with_net();
    run(&workbench, &[&MISSES_BALANCE[..], &["--set", "solve.on_energy_error=flag"]].concat());
    let closure = workbench.summary("results/net")["energy"]["closure"].as_f64().unwrap();
    let asked = format!("solve.energy_tolerance={}", closure / 1.5);
    let ended = run(&workbench, &[MISSES_BALANCE[0], MISSES_BALANCE[1], "--set", &asked]);
    assert_eq!(ended.status, 3, "{}", ended.stderr);
    // the run reached its end
    assert_eq!(workbench.summary("results/net")["finished"], true);
}

#[test]
fn a_step_that_does_not_resolve_the_motion_is_reported() {
    // almost without stiffness, a step may be as long as a record interval, in which the net flies many times its length
    let workbench = Workbench::with_net();
    let limp = ["--set", "rope.elastic_modulus=1 Pa", "--set", "record.every=50 ms"];
    let ended = run(&workbench, &limp);
    assert_eq!(ended.status, 3, "{}", ended.stderr);
    assert!(ended.stderr.contains("the step does not resolve the motion: segment "), "{}", ended.stderr);
    let flagged = run(&workbench, &[&limp[..], &["--set", "solve.on_energy_error=flag"]].concat());
    assert!(flagged.stdout.contains("note: step "), "{}{}", flagged.stdout, flagged.stderr);
}

#[test]
fn a_scenario_can_ask_to_flag_a_missed_energy_balance() {
    let workbench = Workbench::with_net();
    let ended = run(&workbench, &[&MISSES_BALANCE[..], &["--set", "solve.on_energy_error=flag"]].concat());
    assert_eq!(ended.status, 0, "{}", ended.stderr);
    assert!(ended.stdout.contains("note: the energy balance misses its tolerance"), "{}", ended.stdout);
    let summary = workbench.summary("results/net");
    let warnings = summary["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|w| w.as_str().unwrap().contains("misses its tolerance")), "{warnings:?}");
}

#[test]
fn json_of_a_failed_run_is_its_summary() {
    let workbench = Workbench::with_net();
    let ended = run(&workbench, &[&MISSES_BALANCE[..], &["--json"]].concat());
    assert_eq!(ended.status, 3);
    assert_eq!(ended.stdout, workbench.read("results/net/summary.json"));
}

/// SIGTERM left a hidden folder behind, and no result.
#[test]
#[cfg(unix)]
fn an_interrupted_or_terminated_run_keeps_its_results() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    for signal in ["-INT", "-TERM"] {
        let workbench = Workbench::with_net();
        let mut command = workbench.command(&["run", "net.toml", "--set", "solve.duration=500 s"]);
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // the program listens for signals before it makes its folder
        let patience = Instant::now() + Duration::from_secs(60);
        while !workbench.path("results").exists() {
            assert!(Instant::now() < patience, "no run begins");
            std::thread::sleep(Duration::from_millis(10));
        }
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
        let ended: Ended = child.wait_with_output().unwrap().into();
        assert_eq!(ended.status, 3, "{signal}: {}", ended.stderr);
        assert!(ended.stderr.contains("interrupted at"), "{signal}: {}", ended.stderr);
        assert_eq!(workbench.summary("results/net")["finished"], false);
        assert_readable(&workbench, "results/net");
        assert_eq!(
            std::fs::read_dir(workbench.path("results")).unwrap().count(),
            1,
            "nothing is left beside the result"
        );
    }
}
