//! Failures of the machine: a full disk, a path that is no folder, too little memory. Each gives a message that names the
//! path or the key, and no incomplete file stays behind.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::workbench::{Ended, SMALL_NET, Workbench};

/// Runs a line of the shell in the folder of the workbench; `$NETCAST` is the program.
fn shell(workbench: &Workbench, line: &str) -> Ended {
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(workbench.path("")).env("NETCAST", env!("CARGO_BIN_EXE_netcast"));
    command.output().unwrap().into()
}

/// Asserts that `line` ends with this status and these words, and that it changes no file.
#[track_caller]
fn refused(workbench: &Workbench, line: &str, status: i32, said: &[&str]) -> Ended {
    let before = workbench.listing();
    let ended = shell(workbench, line);
    assert_eq!(ended.status, status, "{line}: {}{}", ended.stdout, ended.stderr);
    for words in said {
        assert!(ended.stderr.contains(words), "{line}: {words:?} is not said in:\n{}", ended.stderr);
    }
    let after = workbench.listing();
    let new: Vec<_> = after.keys().filter(|name| !before.contains_key(*name)).collect();
    assert!(after == before, "{line}: something was written: {new:?}");
    ended
}

/// A web of a million segments; it takes about 700 MB.
const LARGE: &str = "--set web.square.side='100 m' --set web.square.mesh='1 m' --set web.square.segments_per_mesh=50";

#[test]
fn a_file_where_a_folder_should_be_is_named() {
    let workbench = Workbench::with_net();
    for (out, said) in [
        ("net.toml", "net.toml is a file: results need a folder"),
        ("net.toml/deeper", "cannot make the folder net.toml/deeper: Not a directory"),
        ("net.toml/deeper/still", "cannot make the folder net.toml/deeper/still: Not a directory"),
    ] {
        refused(&workbench, &format!("$NETCAST run net.toml --out {out}"), 2, &[said]);
    }
}

#[test]
fn a_folder_where_a_file_should_be_is_named() {
    let workbench = Workbench::with_graph();
    fs::create_dir(workbench.path("folder")).unwrap();
    for command in ["run", "check", "stow"] {
        let line = format!("$NETCAST {command} folder");
        refused(&workbench, &line, 2, &["cannot read folder: Is a directory", "nothing was written"]);
        let line = format!("$NETCAST {command} net.toml --set web.graph.nodes=folder");
        refused(&workbench, &line, 2, &["web.graph.nodes: cannot read folder: Is a directory"]);
    }
}

#[test]
fn a_report_of_a_folder_without_results_says_what_is_missing() {
    let workbench = Workbench::with_net();
    fs::create_dir(workbench.path("empty")).unwrap();
    let said = ["cannot read empty/summary.json: No such file", "name a folder that `netcast run` wrote"];
    refused(&workbench, "$NETCAST report empty", 2, &said);
    refused(&workbench, "$NETCAST report empty --pictures", 2, &said);
    refused(&workbench, "$NETCAST report net.toml", 2, &["cannot read net.toml/summary.json: Not a directory"]);
    refused(&workbench, "$NETCAST report nowhere", 2, &["cannot read nowhere/summary.json: No such file"]);
}

/// Whether permissions do not bind this user, such as the superuser.
fn reads_everything(workbench: &Workbench) -> bool {
    fs::read(workbench.path("secret.toml")).is_ok()
}

#[test]
#[cfg(unix)]
fn a_path_without_permission_is_named() {
    use std::os::unix::fs::PermissionsExt;

    let workbench = Workbench::with_net();
    fs::write(workbench.path("secret.toml"), SMALL_NET).unwrap();
    fs::create_dir(workbench.path("locked")).unwrap();
    fs::set_permissions(workbench.path("secret.toml"), fs::Permissions::from_mode(0o000)).unwrap();
    fs::set_permissions(workbench.path("locked"), fs::Permissions::from_mode(0o555)).unwrap();
    if reads_everything(&workbench) {
        println!("skipped: permissions do not bind this user");
        return;
    }
    let ended = workbench.netcast(&["run", "secret.toml"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("cannot read secret.toml: Permission denied"), "{}", ended.stderr);
    let ended = workbench.netcast(&["run", "net.toml", "--out", "locked/results"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("cannot make the folder locked/results: Permission denied"), "{}", ended.stderr);
    assert_eq!(fs::read_dir(workbench.path("locked")).unwrap().count(), 0);
}

/// The device was read until the system killed the program.
#[test]
#[cfg(unix)]
fn an_endless_device_is_refused() {
    let workbench = Workbench::with_graph();
    refused(&workbench, "$NETCAST check /dev/zero", 2, &["cannot read /dev/zero: it has more than 64 MB"]);
    let line = "ulimit -v 600000; $NETCAST check net.toml --set web.graph.nodes=/dev/zero";
    refused(&workbench, line, 2, &["web.graph.nodes: cannot read /dev/zero: it has more than"]);
}

#[test]
#[cfg(unix)]
fn a_scenario_can_come_from_a_pipe() {
    let ended = shell(&Workbench::with_net(), "cat net.toml | $NETCAST check /dev/stdin");
    assert_eq!(ended.status, 0, "{}", ended.stderr);
}

/// Asserts that a run that could not write says why, leaves nothing under the name of the result, and either leaves
/// nothing at all or keeps the results so far in a folder that the message names.
#[track_caller]
fn assert_cut_off(workbench: &Workbench, ended: &Ended, results: &str, why: &str) {
    let message = &ended.stderr;
    assert!(message.starts_with("error: cannot ") && message.contains(why), "{message}");
    assert!(!workbench.path(results).exists(), "half a result: {message}");
    let parent = workbench.path(results).parent().unwrap().to_owned();
    let left: Vec<_> = fs::read_dir(parent).into_iter().flatten().map(|entry| entry.unwrap().path()).collect();
    match ended.status {
        1 | 2 => assert!(left.is_empty(), "{left:?} stays behind: {message}"),
        3 => {
            let kept = message.split("what was computed is in ").nth(1).unwrap_or_else(|| panic!("{message}"));
            let kept = Path::new(kept.lines().next().unwrap());
            assert_eq!(left, [fs::canonicalize(kept).unwrap()], "{message}");
        }
        other => panic!("status {other}: {message}"),
    }
}

/// A limit on the size of a file stands in for a full disk where none can be mounted.
#[test]
#[cfg(unix)]
fn a_limit_on_the_size_of_files_is_reported() {
    for blocks in [0, 1, 8, 64, 512] {
        let workbench = Workbench::with_net();
        // blocks of 512 bytes; the signal at the limit is ignored, else it would end the program
        let ended = shell(&workbench, &format!("trap '' XFSZ; ulimit -f {blocks}; $NETCAST run net.toml --quiet"));
        assert_cut_off(&workbench, &ended, "results/net", "File too large");
    }
}

/// A small file system, unmounted on drop. There is none if this user may not mount one.
struct FullDisk<'a>(&'a Path);

impl<'a> FullDisk<'a> {
    fn mount(folder: &'a Path, kib: usize) -> Option<Self> {
        fs::create_dir_all(folder).unwrap();
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", &format!("size={kib}k"), "tmpfs"]).arg(folder);
        mount.output().is_ok_and(|output| output.status.success()).then_some(Self(folder))
    }
}

impl Drop for FullDisk<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0).status();
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_reported() {
    let workbench = Workbench::with_net();
    let folder = workbench.path("disk");
    let mut refused = 0;
    for kib in [4, 32, 64, 256] {
        let Some(_disk) = FullDisk::mount(&folder, kib) else {
            println!("skipped: this user may not mount a file system");
            return;
        };
        let ended = workbench.netcast(&["run", "net.toml", "--quiet", "--out", "disk/results"]);
        if ended.status == 2 {
            assert!(ended.stderr.contains("and its disk has 0 MB to give: record less often"), "{}", ended.stderr);
            assert!(!workbench.path("disk/results").exists());
            refused += 1;
        } else {
            assert_cut_off(&workbench, &ended, "disk/results", "No space left on device");
        }
    }
    assert!((1..4).contains(&refused), "{refused} runs were refused beforehand");
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_an_error() {
    let workbench = Workbench::with_net();
    for command in ["schema", "check net.toml", "run net.toml --json --out results"] {
        let ended = shell(&workbench, &format!("$NETCAST {command} > /dev/full"));
        assert_eq!(ended.status, 1, "{command}: {}", ended.stderr);
        assert!(ended.stderr.contains("cannot write to standard output: No space left"), "{}", ended.stderr);
    }
    // the result itself was complete by then
    assert!(workbench.path("results/summary.json").is_file());
}

/// The system killed such a run half way, or it ended in "memory allocation failed".
#[test]
#[cfg(target_os = "linux")]
fn a_web_that_is_too_large_for_this_machine_is_refused_before_it_is_made() {
    let workbench = Workbench::with_net();
    for command in ["check", "run", "stow"] {
        refused(
            &workbench,
            &format!("ulimit -v 500000; $NETCAST {command} net.toml {LARGE}"),
            2,
            &[
                "web.square.segments_per_mesh: 1010000 segments in 20200 ropes between 10201 knots take about",
                "MB of memory, and this machine has",
                "MB to give",
                "in --set web.square.segments_per_mesh=50",
                "cut it into longer segments, or run it where there is more memory",
            ],
        );
    }
}

#[test]
#[cfg(target_os = "linux")]
fn records_that_are_too_many_for_this_machine_are_refused_before_the_run() {
    let line = "ulimit -v 200000; $NETCAST run net.toml --set record.every='1 us'";
    let said = [
        "record.every: 80 segments in 40 ropes between 25 knots recorded 50001 times take about 546 MB of memory",
        "record less often",
    ];
    refused(&Workbench::with_net(), line, 2, &said);
}

#[test]
#[cfg(target_os = "linux")]
fn a_graph_that_is_too_large_for_this_machine_is_refused_before_it_is_drawn() {
    use std::fmt::Write;

    const NODES: usize = 100_000;
    let mut nodes = String::from("id,x,y,z\n");
    let mut ropes = String::from("a,b\n");
    for node in 0..NODES {
        writeln!(nodes, "{node},{node},0,0").unwrap();
        writeln!(ropes, "{node},{}", (node + 1) % NODES).unwrap();
    }
    let net = crate::workbench::GRAPH_NET
        .replace("outline = [\"n1\", \"n2\", \"n3\", \"n4\"]\n", "")
        .replace("corners = [\"n1\", \"n2\", \"n3\", \"n4\"]\n", "")
        .replace("[tractor.particle]\nmass = \"0.3 kg\"\n", "")
        .replace("[launch]\naxial_speed = \"20 m/s\"\nradial_speed = \"10 m/s\"\n", "");
    let workbench = Workbench::new(&[("net.toml", &net), ("nodes.csv", &nodes), ("ropes.csv", &ropes)]);
    let said = ["web.graph.ropes: 100000 segments in 100000 ropes between 100000 knots take about 160 MB of memory"];
    refused(&workbench, "ulimit -v 180000; $NETCAST check net.toml", 2, &said);
    // the table of nodes alone is too large
    let said = ["web.graph.nodes: cannot read nodes.csv: it has more than 1 MB"];
    refused(&workbench, "ulimit -v 36000; $NETCAST check net.toml", 2, &said);
}

/// A run reaches its end under the tightest limit at which it is not refused.
#[test]
#[cfg(target_os = "linux")]
fn a_run_takes_no_more_memory_than_is_estimated() {
    let workbench = Workbench::with_net();
    let short = "--set solve.duration='0.1 ms' --set record.every='20 us' --set solve.on_energy_error=flag --threads 1";
    for large in [
        "--set web.square.side='60 m' --set web.square.segments_per_mesh=1",
        "--set web.square.side='20 m' --set web.square.mesh='1 m' --set web.square.segments_per_mesh=50",
    ] {
        let under = |mib: usize| {
            let limit = format!("ulimit -v {}", mib << 10);
            shell(&workbench, &format!("{limit}; $NETCAST run net.toml --quiet {large} {short}"))
        };
        let ended = (40..400).step_by(10).map(|mib| (mib, under(mib))).find(|(_, ended)| ended.status != 2);
        let (mib, ended) = ended.expect("some limit is wide enough");
        println!("{mib} MiB: {large}");
        assert_eq!(ended.status, 0, "{mib} MiB: {}", ended.stderr);
    }
}
