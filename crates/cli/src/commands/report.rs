//! `netcast report`

use std::path::PathBuf;

use clap::Args;
use netcast::report::{ReportError, write_pictures, write_report};
use netcast::results::recover;

use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::say;

/// Write the report.html of a result folder again, and pictures if asked
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast report results/square_net
  netcast report results/square_net --pictures   figures for a paper, without a browser")]
pub struct Arguments {
    /// Result folder, as `netcast run` wrote it
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Also write DIR/pictures/: postures, rope tensions, the stowed state and every curve as SVG and PNG, and the
    /// launch as animation.gif
    #[arg(long)]
    pictures: bool,
}

/// Runs `netcast report`.
pub fn run(arguments: &Arguments) -> Ended {
    // an interrupted run is read up to its last record
    for lost in recover(&arguments.folder)? {
        say!("note: {lost}");
    }
    // pictures can lack their input: made first, their refusal leaves nothing written
    let pictures = if arguments.pictures { write_pictures(&arguments.folder).map_err(complaint)? } else { Vec::new() };
    let page = write_report(&arguments.folder).map_err(complaint)?;
    for path in [page].into_iter().chain(pictures) {
        say!("wrote {}", path.display());
    }
    Ok(())
}

fn complaint(error: ReportError) -> Complaint {
    match error {
        ReportError::Write { .. } => Complaint::Fault(error.to_string()),
        ReportError::Read { .. } => Complaint::Argument(format!("{error}; name a folder that `netcast run` wrote")),
        _ => Complaint::Argument(error.to_string()),
    }
}
