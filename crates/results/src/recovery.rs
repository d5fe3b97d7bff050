//! What a run left that was cut off, made readable: rows and frames up to the last whole one.

use std::fs::{self, OpenOptions};
use std::path::Path;

use serde_json::json;

use crate::journal::read_journal;
use crate::{Manifest, ResultError, folder, running};

/// Makes the result in `folder` readable as far as it goes, and says in sentences what was lost: the history ends with
/// its last whole row, `fields.vtkhdf` is made from the whole frames of `fields.part`, and there is a summary that says
/// that the run did not end. A whole result is left as it is, and nothing is said. A run can still go on from here.
///
/// # Errors
/// [`ResultError::InUse`] where the run is at work, or what cannot be read or written.
pub fn recover(folder: &Path) -> Result<Vec<String>, ResultError> {
    // what is not ours is left alone
    if !Manifest::marks(folder) {
        return Ok(Vec::new());
    }
    if running::is_busy(folder)? {
        return Err(ResultError::InUse { path: folder.to_path_buf() });
    }
    let mut told = Vec::new();
    told.extend(cut_history(&folder.join(folder::HISTORY))?);
    if folder.join(folder::FIELDS_PART).exists() {
        told.extend(make_fields(folder)?);
    }
    if !folder.join(folder::SUMMARY).exists() {
        told.push("there is no summary: the run was cut off before its end".to_owned());
        write_summary(folder, &told)?;
    }
    Ok(told)
}

/// Cuts off what follows the last line that has its end.
fn cut_history(path: &Path) -> Result<Option<String>, ResultError> {
    // the history of a comparison is that of its designs
    if !path.exists() {
        return Ok(None);
    }
    let text = fs::read(path).map_err(ResultError::read(path))?;
    let whole = text.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    let lost = text.len() - whole;
    if whole == 0 {
        let what = "it was cut off before its first row".to_owned();
        return Err(ResultError::Cut { path: path.to_path_buf(), what });
    }
    if lost == 0 {
        return Ok(None);
    }
    let cut = OpenOptions::new().write(true).open(path).and_then(|file| file.set_len(whole as u64));
    cut.map_err(ResultError::write(path))?;
    let rows = text[..whole].iter().filter(|&&byte| byte == b'\n').count() - 1;
    Ok(Some(format!("{}: the last {lost} bytes are no whole row; {rows} rows kept", folder::HISTORY)))
}

fn make_fields(folder: &Path) -> Result<Option<String>, ResultError> {
    let (fields, lost) = read_journal(&folder.join(folder::FIELDS_PART))?;
    let upto =
        fields.times().last().map_or("no frame is left".to_owned(), |time| format!("frames up to {time} s kept"));
    // not synced: what it is made from stays
    fields.finish(&folder.join(folder::FIELDS))?;
    Ok((lost > 0).then(|| format!("{}: the last {lost} bytes are no whole frame; {upto}", folder::FIELDS_PART)))
}

/// The summary of a run that did not live to write its own. What it measured at every step is in its checkpoint, for
/// the run that goes on; here is only what can be said for certain.
fn write_summary(folder: &Path, told: &[String]) -> Result<(), ResultError> {
    let summary = json!({
        "title": "",
        "netcast": env!("CARGO_PKG_VERSION"),
        "wall_time_s": null,
        "finished": false,
        "warnings": told,
    });
    let text = serde_json::to_string_pretty(&summary).expect("string keys and plain data") + "\n";
    let path = folder.join(folder::SUMMARY);
    fs::write(&path, &text).map_err(ResultError::write(&path))
}
