//! The designs of a comparison: scenarios to run, and existing result folders.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use netcast_model::Model;
use netcast_report::check_results;
use netcast_results::{Manifest, Quantity, SummaryFile, expected, folder, leaves, quantity_at};
use netcast_scenario::{Diagnostic, Diagnostics, Place};
use serde_json::Value as Json;

use super::reported::{Kind, KnownDesign, KnownQuantity, ReportedFile};
use super::vary::{Variant, joined, variants};
use crate::case::Case;
use crate::inputs::SCENARIO;

/// Least number of designs in a comparison.
pub const FEWEST: usize = 2;
/// Largest number of designs in a comparison: a person cannot tell more curves apart in one figure.
pub const MOST: usize = 12;

/// The designs of a comparison, read and checked.
#[derive(Debug)]
pub struct Lineup {
    pub(super) designs: Vec<Design>,
    pub(super) reported: Option<ReportedFile>,
}

/// A design with a unique name.
#[derive(Debug)]
pub(super) struct Design {
    pub name: String,
    pub origin: Origin,
}

/// Where a design's results come from.
#[derive(Debug)]
pub(super) enum Origin {
    /// A case to run.
    Scenario(Case),
    /// An existing result folder.
    Folder(PathBuf),
}

impl Lineup {
    /// Reads designs. Each is the file of a scenario, which takes the overrides as after `--set`, or a result folder,
    /// which stays as it is. Every scenario becomes a design for each combination of the varied values, `path=value,value`
    /// as after `--vary`. `reported` is a file of numbers from another source to compare with.
    ///
    /// # Errors
    /// [`Diagnostics`] with all mistakes in designs, overrides, varied and reported numbers.
    pub fn read(
        files: &[PathBuf],
        overrides: &[String],
        varied: &[String],
        reported: Option<&Path>,
    ) -> Result<Self, Diagnostics> {
        let variants =
            variants(varied, MOST).map_err(|faults| Diagnostics(faults.into_iter().map(mistake).collect()))?;
        let mut found = mistakes_of_set(files, overrides, &variants);
        let (designs, variant_of) = each_variant(files, &variants);
        let names = names(&designs, &variant_of);
        let read: Vec<Result<Origin, Diagnostics>> = designs
            .iter()
            .zip(&variant_of)
            .map(|(path, variant)| Origin::read(path, &[overrides, &variant.overrides].concat()))
            .collect();
        let reported = reported.and_then(|file| {
            let known = names.iter().zip(&read).map(|(name, origin)| {
                // a design that cannot be read may have any reported quantity
                KnownDesign { name: name.clone(), quantities: origin.as_ref().ok().and_then(Origin::quantities) }
            });
            ReportedFile::read(file, &known.collect::<Vec<_>>()).map_err(|faults| found.extend(faults)).ok()
        });
        let mut origins = Vec::new();
        let scenarios = designs.iter().filter(|path| !path.is_dir()).count();
        let mut overridden: Vec<(Diagnostic, Vec<String>)> = Vec::new();
        for (name, origin) in names.iter().zip(read) {
            match origin {
                Ok(origin) => origins.push(origin),
                Err(faults) => {
                    for fault in faults.0 {
                        match (&fault.place, overridden.iter_mut().find(|(known, _)| *known == fault)) {
                            (Some(Place::Override(_)), Some((_, names))) => names.push(name.clone()),
                            (Some(Place::Override(_)), None) => overridden.push((fault, vec![name.clone()])),
                            _ => found.push(fault),
                        }
                    }
                }
            }
        }
        // all designs share the overrides: report a mistake once, with the names where only some designs have it
        found.extend(overridden.into_iter().map(|(fault, names)| {
            if names.len() == scenarios {
                fault
            } else {
                Diagnostic { message: format!("{} (for {})", fault.message, names.join(", ")), ..fault }
            }
        }));
        Diagnostics::fail_if_any(found)?;
        let designs = names.into_iter().zip(origins).map(|(name, origin)| Design { name, origin }).collect();
        Ok(Self { designs, reported })
    }

    /// The names of the designs, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.designs.iter().map(|design| &design.name[..])
    }
}

impl Origin {
    fn read(path: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        if path.is_dir() {
            return result_folder(path).map_err(|reason| mistake(format!("{}: {reason}", path.display())).into());
        }
        Ok(Self::Scenario(Case::read(path, overrides)?))
    }

    /// The quantities that the design's summary has, or will have after the run; none where the summary cannot be read.
    fn quantities(&self) -> Option<Vec<KnownQuantity>> {
        match self {
            Self::Folder(path) => {
                let summary = SummaryFile::read(path).ok()?;
                let known = |(path, value): (String, &Json)| {
                    let kind = match value {
                        Json::String(_) => Kind::Text,
                        Json::Number(_) => Kind::Number,
                        // a null value has the kind that the table of quantities gives it, if any
                        _ => quantity_at(&path).map_or(Kind::Unknown, |(quantity, _)| Kind::of(quantity.dimension)),
                    };
                    KnownQuantity { path, kind }
                };
                Some(leaves(&summary.values).into_iter().map(known).collect())
            }
            Self::Scenario(case) => {
                let all = expected(case.landmarks(), |section| has_section(case.model(), section));
                let known =
                    |(path, quantity): (String, &Quantity)| KnownQuantity { path, kind: Kind::of(quantity.dimension) };
                Some(all.into_iter().map(known).collect())
            }
        }
    }
}

/// Whether the summary of a run of `model` has a section.
fn has_section(model: &Model, section: &str) -> bool {
    match section {
        "target" => model.scenario.measure.target_diameter.is_some(),
        "air" => model.system.environment().air.is_some(),
        "canopies" => !model.system.membranes().is_empty(),
        "launch" => model.scenario.launch.is_some() || model.throws.iter().any(Option::is_some),
        "static" => model.scenario.solve.statics.is_some(),
        _ => true,
    }
}

/// The designs of these files, and the variant that each is.
fn each_variant(files: &[PathBuf], variants: &[Variant]) -> (Vec<PathBuf>, Vec<Variant>) {
    let as_it_is = [Variant::default()];
    let of_file = |path: &PathBuf| {
        let variants = if path.is_dir() { &as_it_is } else { variants };
        variants.iter().map(|variant| (path.clone(), variant.clone())).collect::<Vec<_>>()
    };
    files.iter().flat_map(of_file).unzip()
}

/// A mistake without a place in a file.
fn mistake(message: String) -> Diagnostic {
    Diagnostic::new("", message, None)
}

/// Mistakes in the choice of designs: too few, too many, repeated, or none that an override applies to.
fn mistakes_of_set(designs: &[PathBuf], overrides: &[String], variants: &[Variant]) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let count = each_variant(designs, variants).0.len();
    if !(FEWEST..=MOST).contains(&count) {
        let message = format!("expected {FEWEST} to {MOST} designs to compare, found {count}");
        let help = "name more, or vary a value of one: --vary tractor.particle.mass=60g,120g";
        found.push(mistake(message).with_help_if((count < FEWEST).then(|| help.to_owned())));
    }
    let paths: Vec<PathBuf> = designs.iter().map(|path| resolved(path)).collect();
    for (index, path) in designs.iter().enumerate() {
        if paths[..index].contains(&paths[index]) {
            found.push(mistake(format!("{} is named twice", path.display())));
        }
    }
    if !overrides.is_empty() && !designs.is_empty() && designs.iter().all(|path| path.is_dir()) {
        found.push(mistake("--set has no effect: all designs are result folders, which are not run again".into()));
    }
    if variants.len() > 1 && !designs.is_empty() && designs.iter().all(|path| path.is_dir()) {
        found.push(mistake("--vary has no effect: all designs are result folders, which are not run again".into()));
    }
    found
}

/// Checks that a folder is a result of `netcast run` with all files that a comparison needs.
///
/// # Errors
/// The reason, as a clause after the folder's name.
fn result_folder(path: &Path) -> Result<Origin, String> {
    if !Manifest::marks(path) {
        return Err("expected a scenario or a result folder that netcast wrote".into());
    }
    folder::require_files(path, true).map_err(|error| error.to_string())?;
    let summary = SummaryFile::read(path).map_err(|error| error.to_string())?;
    if summary.is_of_comparison() {
        return Err("it is a comparison; name the folders of designs in it".into());
    }
    for needed in [PathBuf::from(folder::HISTORY), Path::new(folder::INPUTS).join(SCENARIO)] {
        if !path.join(&needed).is_file() {
            return Err(format!("it has no {}", needed.display()));
        }
    }
    // whatever the page would fail on is wrong before anything runs
    check_results(path).map_err(|error| error.to_string())?;
    Ok(Origin::Folder(path.to_owned()))
}

/// A unique name for each design: that of its file or folder, and of its variant; of that alone where one file is varied.
/// Equal names are preceded by the name of the parent folder, and if they are still equal followed by a number.
fn names(designs: &[PathBuf], variants: &[Variant]) -> Vec<String> {
    let is_one_file = designs.iter().all(|path| *path == designs[0]) && designs.len() > 1;
    let own = |path: &PathBuf| {
        let name =
            if path.is_dir() { resolved(path).file_name().map(Into::into) } else { path.file_stem().map(Into::into) };
        name.unwrap_or_else(|| PathBuf::from("design")).to_string_lossy().into_owned()
    };
    let own: Vec<String> = designs.iter().map(own).collect();
    let paths: Vec<PathBuf> = designs.iter().map(|path| resolved(path)).collect();
    let distinguished = paths.iter().zip(&own).map(|(path, name)| {
        // compare in lower case, since some file systems ignore case; `mistakes_of_set` reports equal paths
        let is_same = |(other, other_name): (&PathBuf, &String)| {
            other != path && other_name.to_lowercase() == name.to_lowercase()
        };
        let parent = path.parent().and_then(Path::file_name).map(|parent| parent.to_string_lossy().into_owned());
        match parent.filter(|_| paths.iter().zip(&own).any(is_same)) {
            Some(parent) => format!("{}_{name}", parent.trim_start_matches('.')),
            None => name.clone(),
        }
    });
    // the folder of a design must not have the name of a file of the comparison
    let mut taken: BTreeSet<String> = folder::OURS.iter().map(|name| (*name).to_owned()).collect();
    distinguished
        .zip(variants)
        .map(|(file, variant)| if is_one_file { variant.name.clone() } else { joined(&file, &variant.name) })
        .map(|name| {
            let numbered = (1..).map(|count| if count == 1 { name.clone() } else { format!("{name}_{count}") });
            let free = numbered.into_iter().find(|name| taken.insert(name.to_lowercase()));
            free.expect("numbers do not run out")
        })
        .collect()
}

/// The absolute path, with links resolved where it exists.
fn resolved(path: &Path) -> PathBuf {
    fs::canonicalize(path).or_else(|_| std::path::absolute(path)).unwrap_or_else(|_| path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(paths: &[&str]) -> Vec<String> {
        let paths: Vec<PathBuf> = paths.iter().map(PathBuf::from).collect();
        names(&paths, &vec![Variant::default(); paths.len()])
    }

    #[test]
    fn equal_file_names_are_made_unique() {
        assert_eq!(named(&["nets/ring.toml", "nets/star.toml"]), ["ring", "star"]);
        assert_eq!(
            named(&["/x/ring/net.toml", "/x/star/net.toml", "/x/other.toml"]),
            ["ring_net", "star_net", "other"]
        );
        assert_eq!(named(&["/x/ring/net.toml", "/y/ring/Net.toml"]), ["ring_net", "ring_Net_2"]);
        // a folder of that name would hide a file of the comparison
        assert_eq!(named(&["/x/summary.json.toml", "/x/b.toml"]), ["summary.json_2", "b"]);
    }

    #[test]
    fn all_mistakes_in_the_designs_are_reported_at_once() {
        let error = Lineup::read(&["no_such_net.toml".into()], &[], &[], None).unwrap_err().to_string();
        assert!(error.contains("expected 2 to 12 designs to compare, found 1"), "{error}");
        assert!(error.contains("cannot read no_such_net.toml"), "{error}");
        let many: Vec<PathBuf> = (0..13).map(|_| "no_such_net.toml".into()).collect();
        let error = Lineup::read(&many, &[], &[], None).unwrap_err().to_string();
        assert!(error.contains("found 13") && error.contains("no_such_net.toml is named twice"), "{error}");
    }

    #[test]
    fn reported_quantities_are_checked_against_those_of_the_run() {
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let designs =
            ["10_catch_fence/catch_fence.toml", "04_square_net/square_net.toml"].map(|path| examples.join(path));
        let folder = tempfile::tempdir().unwrap();
        let reported = folder.path().join("reported.toml");
        let read = |text: &str| {
            fs::write(&reported, format!("source = \"a test\"\n{text}")).unwrap();
            Lineup::read(&designs, &[], &[], Some(&reported)).map(|_| ()).map_err(|faults| faults.to_string())
        };
        // quantities that only a whole run fills
        read(
            "[square_net]\nmouth.tilt_max_open_rad = 0.1\nflight.hang_time_s = 1\nstowed.packed_radius_m = 0.1\n\
             points.B.peak_speed_m_s = 3\nlaunch.spin_rad_s = 0\n[catch_fence]\nstatic.residual_n = 1e-6\n",
        )
        .unwrap();
        let faults = read(
            "[square_net]\nmouth.tilt_max_open = 0.1\ntension.max_where = 3\nstatic.iterations = 9\n\
             tension.by_class.no_such_class.max_n = 1\n",
        )
        .unwrap_err();
        for fault in [
            "`mouth.tilt_max_open` is no quantity of its summary.json",
            "did you mean `mouth.tilt_max_open_rad`?",
            "square_net.tension.max_where: expected a text",
            "`static.iterations` is no quantity",
            "`tension.by_class.no_such_class.max_n` is no quantity",
        ] {
            assert!(faults.contains(fault), "{fault}\n{faults}");
        }
    }
}
