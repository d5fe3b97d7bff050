//! Writes the folder of pictures under a temporary name and renames it when it is complete.

use std::path::{Path, PathBuf};
use std::{fs, io, process};

use netcast_results::{Comparison, SummaryFile, folder, read_json};

use super::{animation, curves, raster, sheets};
use crate::ReportError;
use crate::figures::figures;
use crate::results::Results;

/// Pixels of a PNG for each pixel of its SVG, for sharp prints.
const ZOOM: f32 = 2.0;

/// Writes the pictures of a result folder into its folder `pictures` and returns their paths: `postures`, `clouds` (of
/// tension), `stowed` and each curve as SVG and PNG, and `animation.gif`. They replace all older pictures. The same
/// result gives the same bytes.
///
/// # Errors
/// [`ReportError`] names the file that is missing, malformed or cannot be written; [`ReportError::NoFields`] where the
/// result holds no frames or no landmarks, [`ReportError::Comparison`] where it is that of a comparison. Older pictures
/// then stay.
pub fn write_pictures(result_dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    if SummaryFile::read(result_dir)?.is_of_comparison() {
        let comparison: Comparison = read_json(&result_dir.join(folder::SUMMARY))?;
        let designs = comparison.designs.into_iter().map(|design| design.folder).collect();
        return Err(ReportError::Comparison { folder: result_dir.to_path_buf(), designs });
    }
    let results = Results::read(result_dir)?;
    let scene = results.scene.as_ref().ok_or_else(|| no_fields(result_dir))?;
    let title = results.title();

    let new_pictures = NewPictures::create(result_dir)?;
    let mut names = Vec::new();
    let mut write = |name: String, bytes: &[u8]| {
        let path = new_pictures.path.join(&name);
        names.push(name);
        fs::write(&path, bytes).map_err(|source| ReportError::Write { path, source })
    };
    let sheets = [
        ("postures", sheets::postures(&results, scene).svg(&title)),
        ("clouds", sheets::clouds(&results, scene).svg(&title)),
        ("stowed", sheets::stowed(&results, scene).svg(&title)),
    ];
    let figures = figures(&results);
    let curves = figures.iter().map(|figure| (format!("curve_{}", figure.id), curves::svg(figure)));
    for (name, svg) in sheets.map(|(name, svg)| (name.to_owned(), svg)).into_iter().chain(curves) {
        write(format!("{name}.svg"), svg.as_bytes())?;
        write(format!("{name}.png"), &raster::png(&svg, ZOOM))?;
    }
    write("animation.gif".into(), &animation::gif(scene, &title))?;
    new_pictures.swap_in()?;
    let pictures = result_dir.join(folder::PICTURES);
    Ok(names.into_iter().map(|name| pictures.join(name)).collect())
}

fn no_fields(result_dir: &Path) -> ReportError {
    let missing = match [folder::FIELDS, folder::LANDMARKS].map(|name| result_dir.join(name).exists()) {
        [false, _] => "fields.vtkhdf is missing",
        [_, false] => "landmarks.json is missing",
        [true, true] => "fields.vtkhdf holds no frame",
    };
    ReportError::NoFields { folder: result_dir.to_path_buf(), missing }
}

/// A hidden temporary folder beside `pictures`. Dropping it before [`Self::swap_in`] deletes it.
struct NewPictures {
    path: PathBuf,
    target: PathBuf,
}

impl NewPictures {
    fn create(result_dir: &Path) -> Result<Self, ReportError> {
        let beside = |role: &str| result_dir.join(format!(".{}.{role}-{}", folder::PICTURES, process::id()));
        let new = Self { path: beside("new"), target: result_dir.join(folder::PICTURES) };
        let made = remove(&new.path).and_then(|()| fs::create_dir(&new.path));
        made.map_err(|source| ReportError::Write { path: new.path.clone(), source })?;
        Ok(new)
    }

    /// Puts the new folder in the place of the old one.
    fn swap_in(self) -> Result<(), ReportError> {
        let old = self.path.with_extension(format!("old-{}", process::id()));
        let swapped = match fs::rename(&self.target, &old) {
            Ok(()) => fs::rename(&self.path, &self.target).or_else(|error| {
                // restore the old pictures; if that fails too, they stay complete under the hidden name
                fs::rename(&old, &self.target)?;
                Err(error)
            }),
            Err(error) if error.kind() == io::ErrorKind::NotFound => fs::rename(&self.path, &self.target),
            Err(error) => Err(error),
        };
        let done = swapped.and_then(|()| remove(&old));
        done.map_err(|source| ReportError::Write { path: self.target.clone(), source })
    }
}

impl Drop for NewPictures {
    fn drop(&mut self) {
        // after the swap the folder is gone; a destructor cannot report a failure
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// Removes a folder if it exists.
fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_dir_all(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}
