//! `netcast run`

use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use netcast::RunOptions;
use netcast::results::CheckpointEvery;
use netcast::scenario::interval::NonNegative;
use netcast::scenario::quantity::Time;

use super::{ScenarioArguments, stop_on_signal};
use crate::Ended;
use crate::complaint::Complaint;
use crate::progress::Bar;
use crate::screen::{long_wait, say};

/// Run a scenario; write results to a folder and print a summary
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast run examples/04_square_net/square_net.toml
  netcast run net.toml --out results/faster --set launch.axial_speed=\"60 m/s\"
  netcast run net.toml --json --quiet > summary.json
  netcast run net.toml --resume                  go on from where it was interrupted, or the machine went down

While it runs, its history and fields grow in DIR.running. Ctrl-C stops the run at its next record; what was computed is
kept in DIR, and the exit status is 3.")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,

    /// Folder for the results [default: results/<scenario file's stem>]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Threads to use at most; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,

    /// Resume an interrupted run of the same scenario; results equal those of an uninterrupted run
    #[arg(long)]
    resume: bool,

    /// Simulated time from one checkpoint to the next, such as "50 ms"; 0: none [default: every 30 s on the clock]
    #[arg(long, value_name = "TIME", value_parser = checkpoint_every)]
    checkpoint_every: Option<CheckpointEvery>,

    /// No progress bar and no summary on the screen
    #[arg(long)]
    quiet: bool,

    /// Print summary.json to standard output, and nothing else there
    #[arg(long)]
    json: bool,
}

/// Runs `netcast run`.
pub fn run(arguments: &Arguments) -> Ended {
    let case = arguments.scenario.case()?;
    let target = arguments.out.clone().unwrap_or_else(|| {
        let stem = arguments.scenario.scenario.file_stem().unwrap_or("scenario".as_ref());
        PathBuf::from("results").join(stem)
    });
    let mut options = RunOptions { resume: arguments.resume, ..RunOptions::default() };
    if let Some(every) = arguments.checkpoint_every {
        options.checkpoint_every = every;
    }
    if let Some(threads) = arguments.threads {
        options.threads = threads.into();
    }

    let stop = stop_on_signal()?;
    let updates = case.schedule().count as f64 * case.model().system.segments().len() as f64;
    if !arguments.quiet
        && updates > UPDATES_IN_AN_HOUR
        && let Some(warning) = case.expected_time_s().and_then(long_wait)
    {
        eprintln!("warning: {warning}");
    }
    let bar = Bar::new(arguments.quiet);
    let simulation = case.simulation().options(options).progress(|progress| bar.show(progress));
    let ran = simulation.interrupt_when(|| stop.load(Ordering::Relaxed)).run_to(&target);
    bar.end();
    let ran = ran?;

    let summary = ran.summary.to_json().map_err(Complaint::from)?;
    if arguments.json {
        say!("{}", summary.trim_end());
    } else if !arguments.quiet {
        print_summary(&ran)?;
    }
    match ran.failure {
        Some(failure) => {
            let resume = ran.can_resume.then(|| arguments.resume_command());
            Err(Complaint::Failed { failure, folder: ran.folder, resume })
        }
        None => Ok(()),
    }
}

/// Segments times steps that every machine computes in less than an hour: such a run starts at once.
const UPDATES_IN_AN_HOUR: f64 = 1e9;

/// Reads a time between checkpoints; 0 means no checkpoints.
///
/// # Errors
/// A text that is not a time of at least 0.
fn checkpoint_every(text: &str) -> Result<CheckpointEvery, String> {
    let time = match text {
        "0" => 0.0,
        _ => Time::<NonNegative>::from_text(text).map_err(|error| error.to_string())?.si(),
    };
    Ok(if time == 0.0 { CheckpointEvery::Never } else { CheckpointEvery::Simulated(time) })
}

impl Arguments {
    /// The command that resumes this run.
    fn resume_command(&self) -> String {
        let path = |path: &PathBuf| quoted(&path.to_string_lossy());
        let mut command = format!("netcast run {}", path(&self.scenario.scenario));
        for set in &self.scenario.overrides {
            command += &format!(" --set {}", quoted(set));
        }
        if let Some(out) = &self.out {
            command += &format!(" --out {}", path(out));
        }
        command + " --resume"
    }
}

/// `word`, quoted for a shell where it needs quotes.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/._-=+:,@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// Prints the title, the summary in words, warnings, and the steps of a run.
fn print_summary(ran: &netcast::Ran) -> Ended {
    if !ran.summary.title.is_empty() {
        say!("{}", ran.summary.title);
    }
    for sentence in netcast::report::words(&ran.summary) {
        say!("  {sentence}");
    }
    // a failure is printed last, on standard error
    let failure = ran.failure.as_ref().map(|failure| failure.to_string());
    for warning in ran.summary.warnings.iter().filter(|warning| Some(*warning) != failure.as_ref()) {
        say!("  note: {warning}");
    }
    let (step, clock) = (&ran.summary.step, ran.summary.wall_time_s);
    if let (0, Some(found)) = (step.count, &ran.summary.statics) {
        say!("  {} segments, {} iterations; {clock:.2} s on the clock.", ran.summary.model.segments, found.iterations);
        say!("  Open {}", ran.folder.join("report.html").display());
        return Ok(());
    }
    let limit = step.limited_by.as_ref().map_or(String::new(), |place| format!(", limited by {place}"));
    let lift = step.lifted_by.as_ref().map_or(String::new(), |lift| format!("; larger with {lift}"));
    say!(
        "  {} segments, {} steps of {:.3} us{limit}{lift}; {clock:.2} s on the clock.",
        ran.summary.model.segments,
        step.count,
        1e6 * step.dt_s
    );
    say!("  Open {}", ran.folder.join("report.html").display());
    Ok(())
}
