//! A temporary folder, and commands that run in it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// A small net, thrown for a twentieth of a second.
pub const SMALL_NET: &str = r#"title = "A small net"

[web.square]
side = "2 m"
mesh = "0.5 m"
segments_per_mesh = 2

[rope]
diameter = "3 mm"
density = "1140 kg/m^3"
elastic_modulus = "5 GPa"

[tractor.particle]
mass = "0.3 kg"

[stow.scale]
factor = 0.25

[launch]
axial_speed = "20 m/s"
radial_speed = "10 m/s"

[solve]
duration = "50 ms"

[record]
every = "5 ms"
"#;

/// A graph net of four ropes round a square and four to its middle.
pub const GRAPH_NET: &str = r#"title = "A graph net"

[web.graph]
nodes = "nodes.csv"
ropes = "ropes.csv"
outline = ["n1", "n2", "n3", "n4"]
corners = ["n1", "n2", "n3", "n4"]

[rope]
diameter = "3 mm"
density = "1140 kg/m^3"
elastic_modulus = "5 GPa"

[tractor.particle]
mass = "0.3 kg"

[stow.scale]
factor = 0.5

[launch]
axial_speed = "20 m/s"
radial_speed = "10 m/s"

[solve]
duration = "50 ms"
segment_length = "0.2 m"

[record]
every = "5 ms"
"#;

/// The nodes of [`GRAPH_NET`].
pub const NODES: &str = "id,x,y,z\nn1,1,1,0\nn2,-1,1,0\nn3,-1,-1,0\nn4,1,-1,0\nmiddle,0,0,0\n";

/// The ropes of [`GRAPH_NET`].
pub const ROPES: &str = "a,b,class\nn1,n2,outline\nn2,n3,outline\nn3,n4,outline\nn4,n1,outline\n\
                         n1,middle,radial\nn2,middle,radial\nn3,middle,radial\nn4,middle,radial\n";

/// A folder of its own for a test, with files to start from.
pub struct Workbench(TempDir);

/// How a command ended.
#[derive(Debug)]
pub struct Ended {
    /// Its exit status.
    pub status: i32,
    /// Its standard output.
    pub stdout: String,
    /// Its standard error.
    pub stderr: String,
}

impl Workbench {
    /// A folder with these files, by name and text.
    pub fn new(files: &[(&str, &str)]) -> Workbench {
        let workbench = Workbench(TempDir::new().unwrap());
        for (name, text) in files {
            fs::write(workbench.path(name), text).unwrap();
        }
        workbench
    }

    /// A folder with the small net as `net.toml`.
    pub fn with_net() -> Workbench {
        Workbench::new(&[("net.toml", SMALL_NET)])
    }

    /// A folder with the graph net as `net.toml`, and its files.
    pub fn with_graph() -> Workbench {
        Workbench::new(&[("net.toml", GRAPH_NET), ("nodes.csv", NODES), ("ropes.csv", ROPES)])
    }

    /// A path in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A command that runs in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_netcast"));
        command.args(arguments).current_dir(self.0.path());
        command
    }

    /// Runs `netcast` with these arguments in the folder.
    pub fn netcast(&self, arguments: &[&str]) -> Ended {
        self.command(arguments).output().unwrap().into()
    }

    /// Runs `netcast` with these arguments and asserts status 0.
    pub fn succeed(&self, arguments: &[&str]) -> Ended {
        let ended = self.netcast(arguments);
        assert_eq!(ended.status, 0, "{arguments:?}: {}", ended.stderr);
        ended
    }

    /// Every file and folder below this one; see [`listing`].
    pub fn listing(&self) -> BTreeMap<String, Vec<u8>> {
        listing(self.0.path())
    }

    /// The text of a file.
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// A summary.json.
    pub fn summary(&self, folder: &str) -> serde_json::Value {
        serde_json::from_str(&self.read(&format!("{folder}/summary.json"))).unwrap()
    }
}

impl From<Output> for Ended {
    fn from(output: Output) -> Ended {
        Ended {
            status: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// Every file and folder below `folder` by its relative path, with its bytes; a folder has none.
pub fn listing(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fn walk(root: &Path, folder: &Path, found: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
            if path.is_dir() {
                found.insert(format!("{name}/"), Vec::new());
                walk(root, &path, found);
            } else {
                found.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    let mut found = BTreeMap::new();
    walk(folder, folder, &mut found);
    found
}
