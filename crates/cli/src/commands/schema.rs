//! `netcast schema`

use clap::Args;

use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::say;

/// Print the JSON Schema of the scenario, for editors
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast schema > netcast.schema.json

An editor with TOML support completes and checks a scenario that begins with
  #:schema ./netcast.schema.json")]
pub struct Arguments {}

/// Runs `netcast schema`.
pub fn run(_: &Arguments) -> Ended {
    let text = serde_json::to_string_pretty(netcast::scenario::schema());
    say!("{}", text.map_err(|error| Complaint::Fault(error.to_string()))?);
    Ok(())
}
