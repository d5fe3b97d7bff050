//! Help, first steps and wrong command lines.

use std::path::Path;

use crate::workbench::{Ended, Workbench};

const COMMANDS: [&str; 8] = ["run", "compare", "check", "init", "stow", "report", "bench", "schema"];

#[test]
fn without_a_command_netcast_prints_the_first_steps() {
    let ended = Workbench::new(&[]).succeed(&[]);
    for said in ["thrown", "First steps", "netcast init", "netcast check scenario.toml", "netcast run scenario.toml"] {
        assert!(ended.stdout.contains(said), "{said}: {}", ended.stdout);
    }
    for command in COMMANDS {
        assert!(ended.stdout.contains(&format!("\n  {command} ")), "{command}: {}", ended.stdout);
    }
    assert_eq!(ended.stderr, "");
}

#[test]
fn the_first_steps_work_as_printed() {
    let workbench = Workbench::new(&[]);
    workbench.succeed(&["init"]);
    workbench.succeed(&["check", "scenario.toml"]);
    workbench.succeed(&["run", "scenario.toml", "--set", "solve.duration=1 ms"]);
    assert!(workbench.path("results/scenario/report.html").is_file());
}

#[test]
fn every_command_has_help_with_examples_and_long_names() {
    let workbench = Workbench::new(&[]);
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for command in COMMANDS {
        let help = workbench.succeed(&[command, "--help"]).stdout;
        let examples = help.split("Examples:").nth(1).unwrap_or_else(|| panic!("{help}"));
        assert!(examples.contains(&format!("\n  netcast {command}")), "{help}");
        // shipped files that the examples name exist
        for word in examples.split_whitespace().filter(|word| word.starts_with("examples/")) {
            assert!(repository.join(word).is_file(), "`netcast {command} --help` names {word}");
        }
        let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with('-') && !line.starts_with("- "));
        for line in lines {
            assert!(line.starts_with("--") || line.starts_with("-h, --help"), "an option without a long name: {line}");
        }
    }
    let run = workbench.succeed(&["run", "--help"]).stdout;
    for option in ["--set <", "--out <", "--threads <", "--quiet", "--json"] {
        assert!(run.contains(option), "{option}: {run}");
    }
}

#[test]
fn a_wrong_command_line_ends_with_status_2_and_writes_nothing() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    for (arguments, said) in [
        (&["chck", "net.toml"][..], "'check'"),
        (&["run"], "<SCENARIO>"),
        (&["run", "net.toml", "--thread", "2"], "'--threads'"),
        (&["run", "net.toml", "--threads", "0"], "0 is not in 1.."),
        (&["run", "net.toml", "--threads", "many"], "'many'"),
        (&["run", "net.toml", "more.toml"], "more.toml"),
        (&["init", "sqare"], "square"),
        (&["report"], "<DIR>"),
    ] {
        let ended = workbench.netcast(arguments);
        assert_eq!(ended.status, 2, "{arguments:?}");
        assert!(ended.stderr.contains(said), "{arguments:?}: {}", ended.stderr);
        assert_eq!(ended.stdout, "");
    }
    assert!(workbench.listing() == before, "something was written");
}

#[test]
fn the_version_is_that_of_the_package() {
    let ended = Workbench::new(&[]).succeed(&["--version"]);
    assert_eq!(ended.stdout, format!("netcast {}\n", env!("CARGO_PKG_VERSION")));
}

/// `netcast schema | head -1` ended in a panic.
#[test]
fn a_closed_pipe_is_not_an_error() {
    let workbench = Workbench::with_net();
    for arguments in [&["schema"][..], &["check", "net.toml"], &["run", "net.toml", "--json"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let ended: Ended = workbench.command(arguments).stdout(writer).output().unwrap().into();
        assert_eq!((ended.status, &ended.stderr[..]), (0, ""), "{arguments:?}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_reported() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended: Ended = Workbench::new(&[]).command(&["schema"]).stdout(full).output().unwrap().into();
    assert_eq!(ended.status, 1);
    assert!(ended.stderr.contains("cannot write to standard output"), "{}", ended.stderr);
}
