//! `[rope.law.LAW]`: how the tension of a rope follows from its stretch; `[rope.breaking]`: when it breaks.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::interval::{NonNegative, Positive};
use crate::path::Path;
use crate::quantity::{Force, Number, Pressure, Time};
use crate::tables::ropes;
use crate::written::Written;

/// The law of a rope: one table, named after it. Left out: `linear`. The rope's damping works beside each of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RopeLaw {
    /// Tension in proportion to stretch, by the elastic modulus; the rope only pulls.
    Linear(LinearLaw),
    /// A second modulus beyond a strain. Elastic: it unloads along the same way.
    Bilinear(BilinearLaw),
    /// Tension against strain from a CSV file, with a path of its own for unloading if there is such a column. The elastic
    /// modulus then serves the damping alone.
    Table(TableLaw),
    /// Stiffer at first, relaxing to the elastic modulus with time: the standard linear solid.
    Viscoelastic(ViscoelasticLaw),
    /// Pulls and pushes: a bar hinged at its ends.
    Strut(StrutLaw),
}

impl Default for RopeLaw {
    fn default() -> Self {
        Self::Linear(LinearLaw {})
    }
}

/// `[rope.law.linear]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearLaw {}

/// `[rope.law.strut]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrutLaw {}

/// `[rope.law.bilinear]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BilinearLaw {
    /// Strain at the bend.
    pub strain: Number<NonNegative>,
    /// Modulus beyond it, Pa; larger or smaller than the elastic modulus.
    pub second_modulus: Pressure<Positive>,
}

/// `[rope.law.table]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableLaw {
    /// CSV file: columns strain and tension, N, from 0 up; optionally unloading, the tension in N on the way back from the
    /// last row. Relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: PathBuf,
}

/// `[rope.law.viscoelastic]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ViscoelasticLaw {
    /// Modulus at once, Pa; larger than the elastic modulus, to which it relaxes.
    pub instantaneous_modulus: Pressure<Positive>,
    /// Time in which what relaxes falls to 1/e at constant stretch, s.
    pub relaxation_time: Time<Positive>,
}

/// `[rope.breaking]`: the rope breaks, at a load, a strain or whichever comes first. Without this table it never does, and its
/// strength serves to state the margin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RopeBreaking {
    /// Breaking load, N. Segments at a knot or a splice break at what `knot_reduction` leaves of it. Left out: `strength`.
    pub load: Option<Force<Positive>>,
    /// Breaking strain. Left out: none.
    pub strain: Option<Number<Positive>>,
}

/// The file of a `[rope.law.table]`.
#[derive(Clone, Debug)]
pub struct LawFile {
    /// Strains.
    pub strain: Vec<f64>,
    /// Tensions, N.
    pub tension: Vec<f64>,
    /// Tensions on the way back, N, where there is such a column.
    pub unloading: Option<Vec<f64>>,
    table: CsvTable,
}

impl LawFile {
    /// Something wrong with a row, from 1.
    pub fn at_row(&self, row: usize, message: &str) -> Diagnostic {
        self.table.at_row(row, message)
    }
}

/// The files of `[rope.law.table]`, by the names that the scenario gives them.
pub type LawFiles = BTreeMap<PathBuf, LawFile>;

/// Reads the files of `[rope.law.table]`, each once however many ropes have it; those that can be read.
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
        let [strain, tension] = ["strain", "tension"].map(|column| cells.number(column));
        let unloading = if unloads { cells.number("unloading") } else { Some(0.0) };
        Some([strain?, tension?, unloading?])
    });
    if found.len() > before {
        return None;
    }
    let column = |index: usize| -> Vec<f64> { rows.iter().map(|row| row[index]).collect() };
    Some(LawFile { strain: column(0), tension: column(1), unloading: unloads.then(|| column(2)), table })
}
