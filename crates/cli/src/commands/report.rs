//! `netcast report`

use std::path::PathBuf;

use clap::Args;
use netcast::report::{ReportError, write_report};

use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::say;

/// Write report.html of a result folder anew
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast report results/square_net")]
pub struct Arguments {
    /// Result folder, as `netcast run` wrote it
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Carries it out.
pub fn run(arguments: &Arguments) -> Ended {
    let path = write_report(&arguments.folder).map_err(|error| match error {
        ReportError::Write { .. } => Complaint::Fault(error.to_string()),
        ReportError::Read { .. } => Complaint::Argument(format!("{error}; name a folder that `netcast run` wrote")),
        _ => Complaint::Argument(error.to_string()),
    })?;
    say!("wrote {}", path.display());
    Ok(())
}
