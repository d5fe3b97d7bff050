//! `netcast init`

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use netcast::scenario::init::{TEMPLATES, template};

use crate::Ended;
use crate::complaint::Complaint;
use crate::screen::say;

/// Write a commented scenario to start from
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast init                    the space web, to scenario.toml
  netcast init square --out square.toml
  netcast init graph --out nets/mine.toml")]
pub struct Arguments {
    /// The kind of scenario to write
    #[arg(value_name = "KIND", default_value = "space", value_parser = kinds())]
    kind: String,

    /// File to write; the files that the scenario names are written beside it
    #[arg(long, value_name = "FILE", default_value = "scenario.toml")]
    out: PathBuf,
}

/// The kinds of scenario, for the command line.
fn kinds() -> clap::builder::PossibleValuesParser {
    let kinds = TEMPLATES.iter().map(|t| clap::builder::PossibleValue::new(t.kind).help(t.summary));
    kinds.collect::<Vec<_>>().into()
}

/// Runs `netcast init`.
pub fn run(arguments: &Arguments) -> Ended {
    let template = template(&arguments.kind).expect("clap lets only known kinds through");
    let folder = arguments.out.parent().unwrap_or("".as_ref());
    if !folder.as_os_str().is_empty() {
        std::fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;
    }
    let beside = template.files.iter().map(|(name, text)| (folder.join(name), *text));
    let files: Vec<_> = [(arguments.out.clone(), template.scenario)].into_iter().chain(beside).collect();
    // write all files or none
    if let Some((taken, _)) = files.iter().find(|(path, _)| path.exists()) {
        return Err(Complaint::Argument(format!("{} exists already; choose another name with --out", taken.display())));
    }
    for (path, text) in &files {
        let file = OpenOptions::new().write(true).create_new(true).open(path);
        file.and_then(|mut file| file.write_all(text.as_bytes())).map_err(|error| cannot_write(path, &error))?;
        say!("wrote {}", path.display());
    }
    say!("next: netcast run {}", arguments.out.display());
    Ok(())
}

/// The error of a path that cannot be written.
fn cannot_write(path: &Path, error: &std::io::Error) -> Complaint {
    let message = format!("cannot write {}: {error}", path.display());
    match error.kind() {
        ErrorKind::AlreadyExists | ErrorKind::NotFound | ErrorKind::NotADirectory | ErrorKind::PermissionDenied => {
            Complaint::Argument(message)
        }
        _ => Complaint::Fault(message),
    }
}
