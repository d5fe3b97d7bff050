//! Builds a case in code: the builder writes a scenario table by table, and `build` reads it like any other.

use std::path::PathBuf;

use netcast_scenario::path::{Path as KeyPath, Step};
use netcast_scenario::{Diagnostic, Diagnostics, Document, FileSource, Source};
use toml::{Table, Value};

use crate::case::{Case, IN_CODE};
use crate::sections::{Body, Launch, Rope, Stow, Web};

/// Builds a [`Case`]. Each method sets a table or a key of the scenario; [`set`](Self::set) sets any other.
///
/// A number is SI, a text carries its unit. A key that is not set has the default of the scenario.
/// [`build`](Self::build) checks the case as `netcast check` checks a file, and reports all wrong values at once.
#[derive(Debug, Clone)]
pub struct CaseBuilder {
    scenario: Table,
    overrides: Vec<String>,
    folder: PathBuf,
    files: Vec<(PathBuf, String)>,
    /// Mistakes in the paths given to `set`.
    found: Vec<Diagnostic>,
}

impl Case {
    /// Begins a case in code with its web; the builder's methods add the rest.
    ///
    /// The builder writes a scenario, so it has the scenario's names, defaults and checks.
    #[expect(clippy::new_ret_no_self, reason = "a case begins with its web and ends with `build`")]
    pub fn new(web: Web) -> CaseBuilder {
        CaseBuilder::new(web)
    }
}

impl CaseBuilder {
    fn new(web: Web) -> Self {
        let (web, files) = web.into_parts();
        let files = files.into_iter().map(|(name, text)| (name.into(), text)).collect();
        Self {
            scenario: Table::from_iter([("web".to_owned(), web)]),
            overrides: Vec::new(),
            folder: PathBuf::new(),
            files,
            found: Vec::new(),
        }
    }

    /// Sets any value of the scenario by its path, such as `environment.air.altitude`. It adds missing tables.
    #[must_use]
    pub fn set(self, path: &str, value: impl Into<Value>) -> Self {
        self.put(KeyPath::parse(path), value.into())
    }

    /// Sets a value of a table under a name that may hold any character.
    fn set_named(self, table: &str, name: &str, value: impl Into<Value>) -> Self {
        self.put(KeyPath::default().key(table).key(name), value.into())
    }

    fn put(mut self, path: KeyPath, value: Value) -> Self {
        if let Err(reason) = put(&mut self.scenario, &path.0, value) {
            self.found.push(Diagnostic::new(path, reason, None));
        }
        self
    }

    /// Sets the title of the results.
    #[must_use]
    pub fn title(self, title: &str) -> Self {
        self.set("title", title)
    }

    /// `[rope]`: sets the rope of the web.
    #[must_use]
    pub fn rope(self, rope: Rope) -> Self {
        self.set("rope", rope)
    }

    /// `[ropes.NAME]`: adds a rope that [`assign`](Self::assign) and [`Link::rope`](crate::Link::rope) can name.
    #[must_use]
    pub fn other_rope(self, name: &str, rope: Rope) -> Self {
        self.set_named("ropes", name, rope)
    }

    /// `[assign]`: makes the links of a class, such as `outline`, of another rope.
    #[must_use]
    pub fn assign(self, class: &str, rope: &str) -> Self {
        self.set_named("assign", class, rope)
    }

    /// `[payload.SHAPE]`: sets the body that each inner canopy of a space web carries.
    #[must_use]
    pub fn payload(self, payload: Body) -> Self {
        self.set("payload", payload)
    }

    /// `[sensor.SHAPE]`: sets the body that the centre canopy of a space web carries.
    #[must_use]
    pub fn sensor(self, sensor: Body) -> Self {
        self.set("sensor", sensor)
    }

    /// `[traction_rope]`: sets the length, m, of the ropes between the web's corners and its tractors.
    #[must_use]
    pub fn traction_rope(self, length_m: impl Into<Value>) -> Self {
        self.set("traction_rope.length", length_m)
    }

    /// `[tractor.SHAPE]`: adds a tractor at each corner.
    #[must_use]
    pub fn tractor(self, tractor: Body) -> Self {
        self.set("tractor", tractor)
    }

    /// `[stow.PATTERN]`: sets how the web is packed.
    #[must_use]
    pub fn stow(self, stow: Stow) -> Self {
        self.set("stow", stow)
    }

    /// `[launch]`: sets how the tractors are thrown.
    #[must_use]
    pub fn launch(self, launch: Launch) -> Self {
        self.set("launch", launch)
    }

    /// `[hold]`: fixes the corners of the web.
    #[must_use]
    pub fn hold_corners(self) -> Self {
        self.set("hold.corners", true)
    }

    /// `[points]`: measures a node of a graph under this name.
    #[must_use]
    pub fn point(self, name: &str, node: &str) -> Self {
        self.set_named("points", name, node)
    }

    /// Sets gravity, m/s^2, downwards along z.
    #[must_use]
    pub fn gravity(self, gravity_m_s2: impl Into<Value>) -> Self {
        self.set("environment.gravity", gravity_m_s2)
    }

    /// Sets the mass-proportional damping, 1/s.
    #[must_use]
    pub fn damping(self, damping_per_s: impl Into<Value>) -> Self {
        self.set("environment.damping", damping_per_s)
    }

    /// Sets the simulated time, s.
    #[must_use]
    pub fn duration(self, duration_s: impl Into<Value>) -> Self {
        self.set("solve.duration", duration_s)
    }

    /// Sets the length of the segments that ropes are cut into, m.
    #[must_use]
    pub fn segment_length(self, length_m: impl Into<Value>) -> Self {
        self.set("solve.segment_length", length_m)
    }

    /// Sets the time between two records, s.
    #[must_use]
    pub fn record_every(self, time_s: impl Into<Value>) -> Self {
        self.set("record.every", time_s)
    }

    /// Adds overrides of the finished scenario, each `path=value`, as after `--set`.
    #[must_use]
    pub fn overrides(mut self, overrides: &[String]) -> Self {
        self.overrides.extend_from_slice(overrides);
        self
    }

    /// Gives the text of a file that the scenario names, instead of reading it from the disk.
    #[must_use]
    pub fn file(mut self, name: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        self.files.push((name.into(), text.into()));
        self
    }

    /// Sets the folder that paths of other files are relative to.
    #[must_use]
    pub fn folder(mut self, folder: impl Into<PathBuf>) -> Self {
        self.folder = folder.into();
        self
    }

    /// The scenario as TOML, without defaults and overrides.
    pub fn to_toml(&self) -> String {
        toml::to_string(&self.scenario).expect("keys are strings and values are those of TOML")
    }

    /// Reads and checks the scenario, and builds the case.
    ///
    /// # Errors
    /// [`Diagnostics`] with all mistakes, each with its key; places in the file are those in
    /// [`to_toml`](Self::to_toml).
    pub fn build(self) -> Result<Case, Diagnostics> {
        Diagnostics::fail_if_any(self.found.clone())?;
        let source = Source { name: IN_CODE.to_owned(), text: self.to_toml() };
        let mut files = FileSource::in_folder(&self.folder);
        for (name, text) in self.files {
            files.give(name, text);
        }
        Case::of(Document::parse_with(source, files, &self.overrides)?)
    }
}

/// Sets the value at a path and adds missing tables.
///
/// # Errors
/// A message where the path is empty, has an index, or leads through a value that is not a table.
fn put(table: &mut Table, path: &[Step], value: Value) -> Result<(), String> {
    let [step, rest @ ..] = path else { return Err("expected a path, such as `launch.axial_speed`".to_owned()) };
    let Step::Key(key) = step else { return Err("expected keys, found an index".to_owned()) };
    if rest.is_empty() {
        table.insert(key.clone(), value);
        return Ok(());
    }
    match table.entry(key.clone()).or_insert_with(|| Value::Table(Table::new())) {
        Value::Table(inner) => put(inner, rest, value),
        other => Err(format!("`{key}` is {other}, which has no keys")),
    }
}
