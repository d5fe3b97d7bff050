//! `[rope.law.LAW]`: how the tension of a rope follows from its stretch; `[rope.breaking]`: when it breaks.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Measured, unit};
use crate::interval::{NonNegative, Positive};
use crate::path::Path;
use crate::quantity::{Force, Number, Pressure, Time};
use crate::tables::ropes;
use crate::written::Written;

/// The law of a rope: one table, named after the law. The damping of the rope acts beside any law. Default: linear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RopeLaw {
    /// Tension is proportional to strain, by the elastic modulus. A rope never pushes.
    Linear(LinearLaw),
    /// A second modulus applies beyond a given strain. The law is elastic: loading and unloading follow the same
    /// curve.
    Bilinear(BilinearLaw),
    /// Tension against strain from a CSV file, with a separate curve for unloading if the file has that column. The
    /// elastic modulus is then used for the damping only.
    Table(TableLaw),
    /// Standard linear solid: the rope is stiffer at first and relaxes to the elastic modulus with time.
    Viscoelastic(ViscoelasticLaw),
    /// A bar hinged at its ends: it pulls and pushes.
    Strut(StrutLaw),
}

impl Default for RopeLaw {
    fn default() -> Self {
        Self::Linear(LinearLaw {})
    }
}

/// `[rope.law.linear]`: tension proportional to strain. It has no keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearLaw {}

/// `[rope.law.strut]`: a bar that pulls and pushes. It has no keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrutLaw {}

/// `[rope.law.bilinear]`: a second modulus beyond a given strain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BilinearLaw {
    /// Strain at which the modulus changes.
    pub strain: Number<NonNegative>,
    /// Modulus beyond that strain, Pa. It may be larger or smaller than the elastic modulus.
    pub second_modulus: Pressure<Positive>,
}

/// `[rope.law.table]`: tension against strain from a CSV file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableLaw {
    /// CSV file with columns strain and tension, N, starting at 0 and ascending. The optional column unloading is the
    /// tension, N, on the way back from the last row. The path is relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: PathBuf,
    /// What the tensions of the file are multiplied by, such as 3 for a rope of three of its strands. Default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<Number<Positive>>,
    /// What happens beyond the last row. Default: extend.
    #[serde(default, skip_serializing_if = "BeyondTable::is_default")]
    pub beyond: BeyondTable,
}

/// What happens to a rope that is stretched beyond the last row of its table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BeyondTable {
    /// The line of the last two rows goes on, and the results say how far the rope was stretched.
    #[default]
    Extend,
    /// The run stops there.
    Stop,
    /// The rope breaks there.
    Break,
}

impl BeyondTable {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// `[rope.law.viscoelastic]`: the standard linear solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ViscoelasticLaw {
    /// Modulus at the first instant, Pa. It is larger than the elastic modulus, to which it relaxes.
    pub instantaneous_modulus: Pressure<Positive>,
    /// Time in which the excess tension falls to 1/e at constant stretch, s.
    pub relaxation_time: Time<Positive>,
}

/// `[rope.breaking]`: the rope breaks at a load or at a strain, whichever comes first. Without this table the rope
/// never breaks, and its strength only serves to state the margin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RopeBreaking {
    /// Breaking load, N. Segments at a knot or a splice break at the share of it that `knot_reduction` leaves.
    /// Default: `strength`.
    pub load: Option<Force<Positive>>,
    /// Breaking strain. Default: none.
    pub strain: Option<Number<Positive>>,
}

/// The rows of the file of a `[rope.law.table]`.
#[derive(Clone, Debug)]
pub struct LawFile {
    /// Strains.
    pub strain: Vec<f64>,
    /// Tensions, N.
    pub tension: Vec<f64>,
    /// Tensions on the way back, N. `None` where the file has no such column.
    pub unloading: Option<Vec<f64>>,
    table: CsvTable,
}

impl LawFile {
    /// A diagnostic about a row, counted from 1.
    pub fn at_row(&self, row: usize, message: &str) -> Diagnostic {
        self.table.at_row(row, message)
    }
}

/// The files of `[rope.law.table]`, by their names in the scenario.
pub type LawFiles = BTreeMap<PathBuf, LawFile>;

/// Reads the files of `[rope.law.table]`, each once. A file that cannot be read is reported and left out.
pub(crate) fn read_law_files(written: &Written, found: &mut Vec<Diagnostic>) -> LawFiles {
    let mut read = LawFiles::new();
    let mut seen = BTreeSet::new();
    for rope in ropes(written) {
        let path = rope.key("law").key("table").key("file");
        let Some(file) = written.tree.get(&path).and_then(|node| node.value.as_text()) else { continue };
        if seen.insert(file) {
            read.extend(read_law_file(written, &path, found).map(|law| (PathBuf::from(file), law)));
        }
    }
    read
}

fn read_law_file(written: &Written, path: &Path, found: &mut Vec<Diagnostic>) -> Option<LawFile> {
    let mut table = CsvTable::read(written, &path.to_string(), &["strain", "tension"], &["unloading"], found)?;
    let unloads = table.has("unloading");
    let before = found.len();
    let rows = table.rows(found, |cells| {
        let [strain, tension] = [cells.number("strain", unit::One::KIND), cells.number("tension", unit::Newton::KIND)];
        let unloading = if unloads { cells.number("unloading", unit::Newton::KIND) } else { Some(0.0) };
        Some([strain?, tension?, unloading?])
    });
    if found.len() > before {
        return None;
    }
    let column = |index: usize| -> Vec<f64> { rows.iter().map(|row| row[index]).collect() };
    Some(LawFile { strain: column(0), tension: column(1), unloading: unloads.then(|| column(2)), table })
}
