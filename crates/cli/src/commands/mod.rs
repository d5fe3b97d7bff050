//! The commands, one file each.

pub mod bench;
pub mod check;
pub mod compare;
pub mod init;
pub mod report;
pub mod run;
pub mod schema;
pub mod stow;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use netcast::{Case, Diagnostics};

use crate::complaint::Complaint;

/// A flag that Ctrl-C or `kill` sets, so that the run stops at the next record. A second signal ends the program at once.
///
/// # Errors
/// A system that does not let the program listen for signals.
pub fn stop_on_signal() -> Result<Arc<AtomicBool>, Complaint> {
    let stop = Arc::new(AtomicBool::new(false));
    let on_signal = stop.clone();
    let handled = ctrlc::set_handler(move || {
        // a second Ctrl-C does not wait for the next record
        if on_signal.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    handled.map_err(|error| Complaint::Fault(format!("cannot listen for Ctrl-C: {error}")))?;
    Ok(stop)
}

/// A scenario on the command line.
#[derive(Args)]
pub struct ScenarioArguments {
    /// Scenario file (TOML)
    #[arg(value_name = "SCENARIO")]
    pub scenario: PathBuf,

    /// Override a value of the scenario, such as launch.axial_speed="60 m/s"; may be given more than once
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub overrides: Vec<String>,
}

impl ScenarioArguments {
    /// Reads the scenario with its overrides and makes its model.
    ///
    /// # Errors
    /// All mistakes in the scenario.
    pub fn case(&self) -> Result<Case, Diagnostics> {
        Case::read(&self.scenario, &self.overrides)
    }
}
