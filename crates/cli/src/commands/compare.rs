//! `netcast compare`

use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use netcast::{Compared, Lineup, RunOptions, compare};
use serde_json::Value;

use super::stop_on_signal;
use crate::Ended;
use crate::complaint::Complaint;
use crate::progress::Bar;
use crate::screen::{number, say};

/// Compare designs side by side: run 2 to 12 of them, write one table and one report
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast compare ring.toml star.toml
  netcast compare results/ring star.toml --out results/ring-or-star
  netcast compare ring.toml star.toml --set launch.axial_speed=\"60 m/s\"
  netcast compare ring.toml --vary tractor.particle.mass=60g,120g,200g
  netcast compare ring.toml star.toml --reported test.toml

DIR then holds report.html, summary.json, summary.csv, and a result folder for each design, called like its file.

A file of reported numbers, from a paper or a test, in SI under the names of summary.json:
  source = \"Drop test of 12 May\"
  [ring]
  opening.area_max_time_s = 0.35

Ctrl-C stops the runs at their next records; they are compared as far as they came, and the exit status is 3.")]
pub struct Arguments {
    /// Scenarios (TOML) to run, or result folders of `netcast run`, which are read and not run again
    #[arg(value_name = "SCENARIO", required = true)]
    designs: Vec<PathBuf>,

    /// Folder for the comparison [default: results/comparison]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// File of reported numbers, such as measurements, to print beside the results
    #[arg(long, value_name = "FILE.toml")]
    reported: Option<PathBuf>,

    /// Override a value of every scenario, such as launch.axial_speed="60 m/s"; may be given more than once
    #[arg(long = "set", value_name = "PATH=VALUE")]
    overrides: Vec<String>,

    /// Compare variants of each scenario: one for each of these values, such as tractor.particle.mass=60g,120g; given more
    /// than once, one for each combination
    #[arg(long = "vary", value_name = "PATH=VALUE,VALUE")]
    varied: Vec<String>,

    /// Threads to use at most; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,

    /// No progress bar and no table on the screen
    #[arg(long)]
    quiet: bool,

    /// Print summary.json to standard output, and nothing else there
    #[arg(long)]
    json: bool,
}

/// Runs `netcast compare`.
pub fn run(arguments: &Arguments) -> Ended {
    let lineup =
        Lineup::read(&arguments.designs, &arguments.overrides, &arguments.varied, arguments.reported.as_deref())?;
    let target = arguments.out.clone().unwrap_or_else(|| PathBuf::from("results").join("comparison"));
    let mut options = RunOptions::default();
    if let Some(threads) = arguments.threads {
        options.threads = threads.into();
    }

    let stop = stop_on_signal()?;
    let bar = Bar::new(arguments.quiet);
    let interrupted = || stop.load(Ordering::Relaxed);
    let compared = compare(&lineup, &target, &options, &|progress| bar.show(progress), &interrupted);
    bar.end();
    let compared = compared?;

    if arguments.json {
        say!("{}", compared.comparison.to_json().trim_end());
    } else if !arguments.quiet {
        print_table(&compared);
    }
    if compared.failures.is_empty() { Ok(()) } else { Err(Complaint::SomeFailed(compared.failures, compared.folder)) }
}

/// Prints the headline quantities of all designs as a table, with the best of each row marked.
fn print_table(compared: &Compared) {
    let designs = &compared.comparison.designs;
    let head: Vec<String> = designs.iter().map(|design| design.name.clone()).collect();
    let mut lines = vec![("".to_owned(), head)];
    for row in compared.comparison.table.iter().filter(|row| row.headline) {
        let unit = if row.unit.is_empty() { String::new() } else { format!(", {}", row.unit) };
        let cell = |name: &String| {
            let value = match &row.values[name] {
                Value::Number(value) => value.as_f64().map_or("-".into(), |value| number(value, 4)),
                Value::String(text) => text.clone(),
                _ => "-".into(),
            };
            if row.best.contains(name) { format!("* {value}") } else { value }
        };
        lines.push((format!("{}{unit}", row.label), designs.iter().map(|design| cell(&design.name)).collect()));
    }
    let count = |text: &String| text.chars().count();
    let first = lines.iter().map(|(label, _)| count(label)).max().unwrap_or(0);
    let widths: Vec<usize> =
        (0..designs.len()).map(|i| lines.iter().map(|(_, cells)| count(&cells[i])).max().unwrap_or(0)).collect();
    for (label, cells) in &lines {
        let cells: String = cells.iter().zip(&widths).map(|(cell, &width)| format!("  {cell:>width$}")).collect();
        say!("{label:first$}{cells}");
    }
    let differ = match compared.comparison.differences.len() {
        1 => "1 input differs".to_owned(),
        count => format!("{count} inputs differ"),
    };
    say!("* best of the row; {differ}, see the report");
    say!("Open {}", compared.folder.join("report.html").display());
}
