//! `netcast check`

mod air;
mod cost;
mod launch;
mod materials;
mod surroundings;

use clap::Args;
use netcast::Facts;

use super::ScenarioArguments;
use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::{long_wait, notes, say, start};

/// Check a scenario without running it; print its bill of materials, step size and cost
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast check examples/04_square_net/square_net.toml
  netcast check net.toml --set solve.segment_length=\"5 cm\"
  netcast check net.toml --links                 the names that [assign] may give a rope to
  netcast check net.toml --json                  the same as values, in SI, for a script; docs/facts.md has their names")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,

    /// List every link with its class, ring, rope and length
    #[arg(long)]
    links: bool,

    /// Print the facts as JSON, and nothing else
    #[arg(long)]
    json: bool,
}

/// Runs `netcast check`.
pub fn run(arguments: &Arguments) -> Ended {
    let case = arguments.scenario.case()?;
    let mut facts = case.facts();
    facts.cost = facts.cost.map(|cost| cost.with_step_time(case.step_time_s()));
    let links = arguments.links.then(|| case.links());
    if arguments.json {
        let mut json = serde_json::to_value(&facts).map_err(|error| Complaint::Fault(error.to_string()))?;
        if let Some(links) = links {
            json["links"] = serde_json::to_value(links).map_err(|error| Complaint::Fault(error.to_string()))?;
        }
        say!("{json:#}");
        return Ok(());
    }
    show(&facts, links.as_deref());
    Ok(())
}

/// Prints the facts; `links` only if they were asked for.
fn show(facts: &Facts, links: Option<&[netcast::facts::LinkFacts]>) {
    if !facts.title.is_empty() {
        say!("{}", facts.title);
    }
    notes(&facts.notes);
    materials::bill(&facts.bill);
    materials::laws(&facts.laws);
    if let Some(links) = links {
        materials::links(links);
    }
    if let Some(library) = &facts.library {
        materials::from_library(library);
    }
    launch::bodies(&facts.bodies);
    launch::launch(facts);
    launch::ties(&facts.ties);
    if let Some(orbit) = &facts.orbit {
        surroundings::orbit(orbit);
    }
    if let Some(ground) = &facts.ground {
        surroundings::ground(ground);
    }
    if let Some(facts) = &facts.air {
        air::air(facts);
    }
    start(&facts.start);
    surroundings::acting(&facts.acting);
    if let Some(equilibrium) = &facts.equilibrium {
        cost::equilibrium(equilibrium);
    }
    if let Some(facts) = &facts.cost {
        cost::cost(facts);
        if let Some(warning) = facts.one_core_s.and_then(long_wait) {
            say!("warning: {warning}");
        }
    }
}
