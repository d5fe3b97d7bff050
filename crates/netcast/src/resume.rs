//! What an earlier run left, and whether it can go on.

use std::path::Path;

use netcast_results::{Checkpoint, ResultFolder, folder};

use crate::error::RunError;
use crate::inputs::Inputs;

/// The folder of the run that goes on, and its checkpoint; no checkpoint where that run died before its first, and this
/// one begins at the start.
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
