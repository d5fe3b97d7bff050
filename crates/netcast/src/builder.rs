//! A case built in code: a scenario is written table by table, and then read as any other.

use std::path::PathBuf;

use netcast_scenario::path::{Path as KeyPath, Step};
use netcast_scenario::{Diagnostic, Diagnostics, Document, FileSource, Source};
use toml::{Table, Value};

use crate::case::{Case, IN_CODE};
use crate::sections::{Body, Launch, Rope, Stow, Web};

/// A case in the making. Each method sets a table or a key of the scenario; [`set`](Self::set) sets any other.
///
/// A number is SI, a text carries its unit. What is not set has the default of the scenario, and
/// [`build`](Self::build) checks it as `netcast check` checks a file: wrong values are told all at once, by their keys.
#[derive(Debug, Clone)]
pub struct CaseBuilder {
    scenario: Table,
    overrides: Vec<String>,
    folder: PathBuf,
    files: Vec<(PathBuf, String)>,
    found: Vec<Diagnostic>,
}

impl Case {
    /// Begins a case in code, with its web; everything else follows by the builder's methods.
    ///
    /// The builder has the names, the defaults and the checks of the scenario, because it writes one.
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

    /// Sets any value of the scenario by its path, such as `environment.air.altitude`; tables on the way are made.
    #[must_use]
    pub fn set(self, path: &str, value: impl Into<Value>) -> Self {
        self.put(KeyPath::parse(path), value.into())
    }

    /// Sets a value by names that may hold any character.
    fn set_named(self, table: &str, name: &str, value: impl Into<Value>) -> Self {
        self.put(KeyPath::default().key(table).key(name), value.into())
    }

    fn put(mut self, path: KeyPath, value: Value) -> Self {
        if let Err(reason) = put(&mut self.scenario, &path.0, value) {
            self.found.push(Diagnostic::new(path, reason, None));
        }
        self
    }

    /// The title of the results.
    #[must_use]
    pub fn title(self, title: &str) -> Self {
        self.set("title", title)
    }

    /// `[rope]`: what the web is tied from.
    #[must_use]
    pub fn rope(self, rope: Rope) -> Self {
        self.set("rope", rope)
    }

    /// `[ropes.NAME]`: another rope, for [`assign`](Self::assign) and [`Link::rope`](crate::Link::rope) to name.
    #[must_use]
    pub fn other_rope(self, name: &str, rope: Rope) -> Self {
        self.set_named("ropes", name, rope)
    }

    /// `[assign]`: the links of a class, such as `outline`, are made of another rope.
    #[must_use]
    pub fn assign(self, class: &str, rope: &str) -> Self {
        self.set_named("assign", class, rope)
    }

    /// `[payload.SHAPE]`: what each inner canopy of a space web carries.
    #[must_use]
    pub fn payload(self, payload: Body) -> Self {
        self.set("payload", payload)
    }

    /// `[sensor.SHAPE]`: what the centre canopy of a space web carries.
    #[must_use]
    pub fn sensor(self, sensor: Body) -> Self {
        self.set("sensor", sensor)
    }

    /// `[traction_rope]`: ropes of this length, m, between the web's corners and its tractors.
    #[must_use]
    pub fn traction_rope(self, length_m: impl Into<Value>) -> Self {
        self.set("traction_rope.length", length_m)
    }

    /// `[tractor.SHAPE]`: what pulls the web out, one at each corner.
    #[must_use]
    pub fn tractor(self, tractor: Body) -> Self {
        self.set("tractor", tractor)
    }

    /// `[stow.PATTERN]`: how the web is packed.
    #[must_use]
    pub fn stow(self, stow: Stow) -> Self {
        self.set("stow", stow)
    }

    /// `[launch]`: how the tractors are thrown.
    #[must_use]
    pub fn launch(self, launch: Launch) -> Self {
        self.set("launch", launch)
    }

    /// `[hold]`: the corners of the web stay put.
    #[must_use]
    pub fn hold_corners(self) -> Self {
        self.set("hold.corners", true)
    }

    /// `[points]`: a node of a graph is followed under this name.
    #[must_use]
    pub fn point(self, name: &str, node: &str) -> Self {
        self.set_named("points", name, node)
    }

    /// Gravity, m/s^2, downwards along z.
    #[must_use]
    pub fn gravity(self, gravity_m_s2: impl Into<Value>) -> Self {
        self.set("environment.gravity", gravity_m_s2)
    }

    /// Mass-proportional damping, 1/s.
    #[must_use]
    pub fn damping(self, damping_per_s: impl Into<Value>) -> Self {
        self.set("environment.damping", damping_per_s)
    }

    /// How long it is simulated, s.
    #[must_use]
    pub fn duration(self, duration_s: impl Into<Value>) -> Self {
        self.set("solve.duration", duration_s)
    }

    /// Length of the segments that ropes are cut into, m.
    #[must_use]
    pub fn segment_length(self, length_m: impl Into<Value>) -> Self {
        self.set("solve.segment_length", length_m)
    }

    /// Time between two records, s.
    #[must_use]
    pub fn record_every(self, time_s: impl Into<Value>) -> Self {
        self.set("record.every", time_s)
    }

    /// Overrides values of the scenario once it is written, each as `path=value`, as after `--set`.
    #[must_use]
    pub fn overrides(mut self, overrides: &[String]) -> Self {
        self.overrides.extend_from_slice(overrides);
        self
    }

    /// Gives the text of a file that the scenario names, in place of one on the disk.
    #[must_use]
    pub fn file(mut self, name: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        self.files.push((name.into(), text.into()));
        self
    }

    /// The folder that the paths of other files start from.
    #[must_use]
    pub fn folder(mut self, folder: impl Into<PathBuf>) -> Self {
        self.folder = folder.into();
        self
    }

    /// The scenario as TOML, as far as it was set: what `netcast run` would be given.
    pub fn to_toml(&self) -> String {
        toml::to_string(&self.scenario).expect("keys are strings and values are those of TOML")
    }

    /// Reads and checks it, and makes it ready to be simulated.
    ///
    /// # Errors
    /// Everything that is wrong with it, at once, each with its key; places are those in [`to_toml`](Self::to_toml).
    pub fn build(self) -> Result<Case, Diagnostics> {
        Diagnostics::fail_if_any(self.found.clone())?;
        let source = Source { name: IN_CODE.to_owned(), text: self.to_toml() };
        let mut files = FileSource::in_folder(&self.folder);
        self.files.into_iter().for_each(|(name, text)| files.give(name, text));
        Case::of(Document::parse_with(source, files, &self.overrides)?)
    }
}

/// Puts a value at the end of a path; tables on the way are made.
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
