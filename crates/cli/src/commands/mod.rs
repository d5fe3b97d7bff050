//! One file a command.

pub mod bench;
pub mod check;
pub mod compare;
pub mod init;
pub mod report;
pub mod run;
pub mod schema;
pub mod stow;

use std::path::PathBuf;

use clap::Args;
use netcast::{Diagnostics, Document};

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
    /// Reads the scenario with its overrides.
    pub fn read(&self) -> Result<Document, Diagnostics> {
        Document::read(&self.scenario, &self.overrides)
    }
}
