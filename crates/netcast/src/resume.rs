//! Folder and checkpoint of an earlier run, checked before the run is resumed.

use std::path::Path;

use netcast_results::{Checkpoint, ResultFolder, folder};

use crate::error::RunError;
use crate::inputs::Inputs;

/// The folder of the resumed run, and its checkpoint: `None` if the run died before writing one. It then starts again.
///
/// # Errors
/// [`RunError::OtherInputs`] if the earlier run had other inputs, or those of [`ResultFolder::resuming`].
pub(crate) fn left_behind(
    target: &Path,
    inputs: &Inputs,
    input_hash: &str,
) -> Result<(ResultFolder, Option<Checkpoint<'static>>), RunError> {
    let read = |left: &Path| Checkpoint::read(&left.join(folder::CHECKPOINT));
    let folder = ResultFolder::resuming(target, |left| match read(left)? {
        (_, hash) if hash == input_hash => Ok(()),
        _ => Err(RunError::OtherInputs { folder: left.to_path_buf(), differences: inputs.differences(left) }),
    })?;
    let has_checkpoint = folder.path().join(folder::CHECKPOINT).exists();
    let checkpoint = if has_checkpoint { Some(read(folder.path())?.0) } else { None };
    Ok((folder, checkpoint))
}
