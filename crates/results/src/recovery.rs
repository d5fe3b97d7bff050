//! Recovery of the files of a run that was cut off: rows and frames up to the last complete one.

use std::fs::{self, OpenOptions};
use std::path::Path;

use serde_json::json;

use crate::journal::read_journal;
use crate::{Manifest, ResultError, folder, running};

/// Makes the files of an unfinished run in `folder` readable, and returns a sentence for each loss. The history is cut
/// after its last complete row, `fields.vtkhdf` is made from the complete frames of `fields.part`, and a summary says
/// that the run did not end. A complete result is left unchanged, with no sentences. The run can still go on.
///
/// # Errors
/// [`ResultError::InUse`] if the run has not stopped; else a file that cannot be read or written.
pub fn recover(folder: &Path) -> Result<Vec<String>, ResultError> {
    // never touch a folder that netcast did not write
    if !Manifest::marks(folder) {
        return Ok(Vec::new());
    }
    let is_whole = [folder::SUMMARY, folder::FIELDS].iter().all(|name| folder.join(name).exists());
    folder::require_files(folder, is_whole)?;
    if running::is_busy(folder)? {
        return Err(ResultError::InUse { path: folder.to_path_buf() });
    }
    let mut losses = Vec::new();
    losses.extend(cut_history(&folder.join(folder::HISTORY))?);
    if folder.join(folder::FIELDS_PART).exists() && !is_whole {
        losses.extend(make_fields(folder)?);
    }
    if !folder.join(folder::SUMMARY).exists() {
        losses.push("there is no summary: the run was cut off before its end".to_owned());
        write_summary(folder, &losses)?;
    }
    Ok(losses)
}

/// Cuts the history after its last complete line; returns a sentence if bytes were lost.
fn cut_history(path: &Path) -> Result<Option<String>, ResultError> {
    // the result of a comparison has histories only in the folders of its designs
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

/// Makes `fields.vtkhdf` from `fields.part`; returns a sentence if bytes were lost.
fn make_fields(folder: &Path) -> Result<Option<String>, ResultError> {
    let (fields, lost) = read_journal(&folder.join(folder::FIELDS_PART))?;
    let upto =
        fields.times().last().map_or("no frame is left".to_owned(), |time| format!("frames up to {time} s kept"));
    // no sync is needed: `fields.part` stays
    fields.finish(&folder.join(folder::FIELDS))?;
    Ok((lost > 0).then(|| format!("{}: the last {lost} bytes are no whole frame; {upto}", folder::FIELDS_PART)))
}

/// Writes a summary for a run that died before it wrote its own. It has no measured numbers: those are in the
/// checkpoint, for a run that goes on.
fn write_summary(folder: &Path, losses: &[String]) -> Result<(), ResultError> {
    let summary = json!({
        "title": "",
        "netcast": env!("CARGO_PKG_VERSION"),
        "wall_time_s": null,
        "finished": false,
        "warnings": losses,
    });
    let text = serde_json::to_string_pretty(&summary).expect("string keys and plain data") + "\n";
    let path = folder.join(folder::SUMMARY);
    fs::write(&path, &text).map_err(ResultError::write(&path))
}
