//! Runs that are killed or interrupted and then resumed.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::workbench::{Ended, SMALL_NET, Workbench};

/// A net whose run is long enough to be killed at many points.
fn with_longer_net() -> Workbench {
    let net = SMALL_NET.replace("duration = \"50 ms\"", "duration = \"1 s\"").replace("5 ms", "2 ms");
    let net = net.replace("segments_per_mesh = 2", "segments_per_mesh = 6") + "\n";
    Workbench::new(&[("net.toml", &net)])
}

const RUN: [&str; 5] = ["run", "net.toml", "--quiet", "--checkpoint-every", "20 ms"];

fn start(workbench: &Workbench, more: &[&str]) -> Child {
    let arguments = [&RUN[..], more].concat();
    workbench.command(&arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn signal(child: &Child, name: &str) {
    // a process that has ended cannot be signalled
    let _ = Command::new("kill").args([name, &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
}

/// Waits until a run has written `file` or has ended well.
fn wait_for(workbench: &Workbench, child: &mut Child, file: &str) {
    while !workbench.path(file).exists() {
        if let Some(status) = child.try_wait().unwrap() {
            assert!(workbench.path(file).exists() || status.success(), "{status} before there was a {file}");
            return;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[track_caller]
fn assert_same(workbench: &Workbench, of: &str) {
    let bytes = |folder: &str, file: &str| fs::read(workbench.path(folder).join(file)).unwrap();
    for file in ["history.csv", "fields.vtkhdf"] {
        assert!(bytes("whole", file) == bytes("results/net", file), "{of}: {file} differs");
    }
    let summary = |folder: &str| {
        let mut summary = workbench.summary(folder);
        summary["wall_time_s"] = 0.into();
        summary
    };
    assert_eq!(summary("whole"), summary("results/net"), "{of}");
}

#[test]
#[cfg(unix)]
fn a_run_killed_at_any_point_is_readable_and_resumes_to_the_same_bytes() {
    let workbench = with_longer_net();
    let clock = Instant::now();
    workbench.succeed(&["run", "net.toml", "--quiet", "--out", "whole"]);
    let (whole, points) = (clock.elapsed(), 12);
    let mut readable = 0;
    for point in 1..=points {
        let mut child = start(&workbench, &[]);
        std::thread::sleep(whole * point / points);
        signal(&child, "-KILL");
        child.wait().unwrap();

        if workbench.path("results/net.running/fields.part").exists() {
            let report = workbench.netcast(&["report", "results/net.running"]);
            assert_eq!(report.status, 0, "{}{}", report.stdout, report.stderr);
            readable += 1;
            if workbench.path("results/net.running/checkpoint").exists() {
                let anew = workbench.netcast(&RUN);
                assert_eq!(anew.status, 2, "{}", anew.stderr);
                assert!(anew.stderr.contains("go on with it by --resume"), "{}", anew.stderr);
            }
        }
        if workbench.path("results/net.running").exists() {
            workbench.succeed(&[&RUN[..], &["--resume"]].concat());
        } else if !workbench.path("results/net").exists() {
            // it was killed before it began
            workbench.succeed(&RUN);
        }
        assert_same(&workbench, &format!("killed at {point} of {points}"));
        assert_eq!(fs::read_dir(workbench.path("results")).unwrap().count(), 1, "nothing is left beside the result");
        fs::remove_dir_all(workbench.path("results")).unwrap();
    }
    assert!(readable >= 5, "{readable} of {points} could be read");
}

#[test]
#[cfg(unix)]
fn a_run_killed_several_times_resumes_to_the_same_bytes() {
    let workbench = with_longer_net();
    workbench.succeed(&["run", "net.toml", "--quiet", "--out", "whole"]);
    let mut child = start(&workbench, &[]);
    for _ in 0..4 {
        wait_for(&workbench, &mut child, "results/net.running/checkpoint");
        std::thread::sleep(Duration::from_millis(30));
        signal(&child, "-KILL");
        child.wait().unwrap();
        if !workbench.path("results/net.running").exists() {
            break;
        }
        child = start(&workbench, &["--resume"]);
    }
    let _ = child.wait().unwrap();
    assert_same(&workbench, "killed again and again");
}

#[test]
#[cfg(unix)]
fn an_interrupted_run_prints_the_command_that_resumes_it() {
    for name in ["-INT", "-TERM"] {
        let workbench = with_longer_net();
        workbench.succeed(&["run", "net.toml", "--quiet", "--out", "whole"]);
        let mut child = start(&workbench, &[]);
        wait_for(&workbench, &mut child, "results/net.running/history.csv");
        signal(&child, name);
        let ended: Ended = child.wait_with_output().unwrap().into();
        assert_eq!(ended.status, 3, "{name}: {}", ended.stderr);
        let command = ended.stderr.split("go on with: netcast ").nth(1).unwrap_or_else(|| panic!("{}", ended.stderr));
        assert_eq!(command.trim_end(), "run net.toml --resume");
        assert_eq!(workbench.summary("results/net")["finished"], false);

        let arguments: Vec<&str> = command.split_whitespace().chain(["--quiet"]).collect();
        workbench.succeed(&arguments);
        assert_same(&workbench, name);
        assert_eq!(fs::read_dir(workbench.path("results")).unwrap().count(), 1);
    }
}

#[test]
fn a_second_run_into_the_same_folder_is_refused() {
    let workbench = with_longer_net();
    let mut child = start(&workbench, &["--set", "solve.duration=500 s"]);
    wait_for(&workbench, &mut child, "results/net.running/history.csv");
    for second in [&["run", "net.toml"][..], &["run", "net.toml", "--resume"], &["report", "results/net.running"]] {
        let ended = workbench.netcast(second);
        assert_eq!(ended.status, 2, "{second:?}: {}", ended.stderr);
        assert!(ended.stderr.contains("is being written by another run"), "{}", ended.stderr);
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn without_a_checkpoint_resume_is_refused_and_nothing_is_written() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    let ended = workbench.netcast(&["run", "net.toml", "--resume"]);
    assert_eq!(ended.status, 2, "{}", ended.stderr);
    assert!(ended.stderr.contains("there is nothing to resume"), "{}", ended.stderr);
    assert!(workbench.listing() == before, "something was written");

    workbench.succeed(&["run", "net.toml", "--quiet"]);
    let before = workbench.listing();
    let ended = workbench.netcast(&["run", "net.toml", "--resume"]);
    assert_eq!(ended.status, 2, "{}", ended.stderr);
    assert!(ended.stderr.contains("holds no checkpoint"), "{}", ended.stderr);
    assert!(workbench.listing() == before, "something was written");
}

#[test]
fn a_time_between_checkpoints_has_a_unit_of_time() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet", "--checkpoint-every", "0"]);
    for wrong in ["5 kg", "-1 s", "soon"] {
        let ended = workbench.netcast(&["run", "net.toml", &format!("--checkpoint-every={wrong}")]);
        assert_eq!(ended.status, 2, "{}", ended.stderr);
        assert!(ended.stderr.contains("--checkpoint-every"), "{}", ended.stderr);
    }
}
