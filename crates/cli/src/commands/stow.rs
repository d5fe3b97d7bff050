//! `netcast stow`

use std::path::PathBuf;

use clap::Args;
use netcast::model::node_id;
use netcast::scenario::{StowedNode, write_stow};

use super::ScenarioArguments;
use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::{notes, packing, say, start};

/// Pack a web and print the audit of its stowed state: longest stretch, stored energy, packed size,
/// density, least distance between ropes
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast stow examples/04_square_net/square_net.toml
  netcast stow net.toml --set stow.bag.radius=\"20 cm\"
  netcast stow net.toml --json
  netcast stow net.toml --write stowed.csv      for [stow.file], after changes of your own")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,

    /// Write the position of every node, in the launch frame: columns id, x, y, z, in m
    #[arg(long, value_name = "FILE.csv")]
    write: Option<PathBuf>,

    /// Print the audit as JSON, and nothing else
    #[arg(long)]
    json: bool,
}

/// Runs `netcast stow`.
pub fn run(arguments: &Arguments) -> Ended {
    let case = arguments.scenario.case()?;
    let (facts, packed) = (case.facts(), case.packing());
    if arguments.json {
        let json = serde_json::json!({ "notes": facts.notes, "start": facts.start, "packing": packed });
        say!("{json:#}");
    } else {
        notes(&facts.notes);
        start(&facts.start);
        packing(&packed);
    }
    if let Some(path) = &arguments.write {
        let model = case.model();
        let to_launch_frame = model.frame.transpose();
        let nodes =
            model.state.position.iter().enumerate().map(|(node, &x)| StowedNode {
                id: node_id(&model.cut, node),
                position_m: (to_launch_frame * x).into(),
            });
        write_stow(path, nodes)
            .map_err(|error| Complaint::Argument(format!("cannot write {}: {error}", path.display())))?;
        if !arguments.json {
            say!("wrote {}", path.display());
        }
    }
    Ok(())
}
