//! The `netcast` program. Each command has its own file and returns a result; `main` turns it into an exit status.
//!
//! 0: done. 1: a fault of netcast. 2: the input is wrong; nothing was written. 3: the run failed; its results are kept.

mod commands;
mod complaint;
mod progress;
mod screen;

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use commands::{bench, check, compare, init, report, run, schema, stow};
use complaint::Complaint;

/// Simulates flexible nets that are thrown.
#[derive(Parser)]
#[command(name = "netcast", version, after_help = FIRST_STEPS, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const FIRST_STEPS: &str = "\
First steps:
  netcast init                  write a commented scenario.toml to start from
  netcast check scenario.toml   check it; print its parts and the cost of a run
  netcast run scenario.toml     run it; write results and report.html to results/scenario/

Not there yet: export, import, verify, fit, study, intercept

Exit status:
  0  done
  1  a fault of netcast
  2  the input is wrong; nothing was written
  3  the run failed; what was computed is kept";

#[derive(Subcommand)]
enum Command {
    Run(run::Arguments),
    Compare(compare::Arguments),
    Check(check::Arguments),
    Init(init::Arguments),
    Stow(stow::Arguments),
    Report(report::Arguments),
    Bench(bench::Arguments),
    Schema(schema::Arguments),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let ended = match &cli.command {
        None => {
            // without a command: print the first steps
            let _ = Cli::command().print_help();
            return ExitCode::SUCCESS;
        }
        Some(Command::Run(arguments)) => run::run(arguments),
        Some(Command::Compare(arguments)) => compare::run(arguments),
        Some(Command::Check(arguments)) => check::run(arguments),
        Some(Command::Init(arguments)) => init::run(arguments),
        Some(Command::Stow(arguments)) => stow::run(arguments),
        Some(Command::Report(arguments)) => report::run(arguments),
        Some(Command::Bench(arguments)) => bench::run(arguments),
        Some(Command::Schema(arguments)) => schema::run(arguments),
    };
    match ended {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            complaint.show();
            ExitCode::from(complaint.status())
        }
    }
}

/// The result of a command.
type Ended = Result<(), Complaint>;
