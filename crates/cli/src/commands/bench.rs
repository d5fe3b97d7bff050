//! `netcast bench`

use clap::Args;
use netcast::bench::{MESHES, Measurement, is_shared, measure};

use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::{number, say};

/// Measure the speed of this machine at net simulation, and how near that is to the machine's limit
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast bench
  netcast bench --json > bench.json

An update is one segment advanced by one step. The limit is one unbroken rope of as many segments in the same run: the
same arithmetic on contiguous data, without knots, on one thread, times the threads. Square nets of four sizes are
measured, on one thread and, the larger ones, on all; then as many runs at once as there are threads. It takes about a
quarter of a minute a thread; let the machine do nothing else meanwhile.")]
pub struct Arguments {
    /// Threads to use at most [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,

    /// Print the measurements as JSON
    #[arg(long)]
    json: bool,
}

/// Runs `netcast bench`.
pub fn run(arguments: &Arguments) -> Ended {
    let all =
        arguments.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, |n| n.get()), usize::from);
    let mut cases: Vec<(usize, usize, usize)> = Vec::new();
    for meshes in MESHES {
        cases.push((meshes, 1, 1));
        if all > 1 {
            if is_shared(meshes).map_err(|error| Complaint::Fault(error.to_string()))? {
                cases.push((meshes, all, 1));
            }
            cases.push((meshes, all, all));
        }
    }
    if !arguments.json {
        say!("segments  threads  runs  million updates/s  ns an update  limit  of the limit  vectors");
    }
    let mut measured = Vec::new();
    for (meshes, threads, runs) in cases {
        let one = measure(meshes, threads, runs).map_err(|error| Complaint::Fault(error.to_string()))?;
        if !arguments.json {
            line(&one);
        }
        measured.push(one);
    }
    if arguments.json {
        say!("{}", serde_json::to_string_pretty(&measured).map_err(|error| Complaint::Fault(error.to_string()))?);
    }
    Ok(())
}

/// Prints one measurement as a row of the table.
fn line(one: &Measurement) {
    let millions = |rate: f64| number(1e-6 * rate, 3);
    say!(
        "{:>8}  {:>7}  {:>4}  {:>17}  {:>12}  {:>5}  {:>12.0} %  {:>4} bit",
        one.segments,
        one.threads,
        one.runs,
        millions(one.updates_per_s),
        number(1e9 * one.threads as f64 / one.updates_per_s, 3),
        millions(one.limit_updates_per_s),
        100.0 * one.fraction_of_limit,
        one.vector_bits
    );
}
