//! Errors of commands: their text for the user and their exit status.

use std::io::Write;
use std::path::PathBuf;

use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use netcast::results::{ResultError, visible};
use netcast::scenario::{Diagnostic, Diagnostics, Location, Place};
use netcast::{Failure, RunError};

/// Why a command failed.
#[derive(Debug)]
pub enum Complaint {
    /// The scenario or the command line is wrong: status 2.
    Input(Diagnostics),
    /// A path, a name or another argument is wrong: status 2.
    Argument(String),
    /// The run failed; the results so far are kept: status 3.
    Failed {
        /// The cause.
        failure: Failure,
        /// The folder that holds the results so far.
        folder: PathBuf,
        /// The command that resumes the run; none if it cannot be resumed.
        resume: Option<String>,
    },
    /// A run could no longer write its results; those written before are kept: status 3.
    CutOff(String),
    /// Some of several runs failed; the results of all are kept: status 3.
    SomeFailed(Vec<(String, Failure)>, PathBuf),
    /// Results could not be written: status 1.
    Fault(String),
}

impl Complaint {
    /// The exit status.
    pub fn status(&self) -> u8 {
        match self {
            Complaint::Input(_) | Complaint::Argument(_) => 2,
            Complaint::Failed { .. } | Complaint::SomeFailed(..) | Complaint::CutOff(_) => 3,
            Complaint::Fault(_) => 1,
        }
    }

    /// Prints the error on standard error.
    pub fn show(&self) {
        // nobody reads a closed standard error
        let text = match self {
            // what is rendered has colours, and the renderer has dealt with the user's text
            Complaint::Input(_) => self.text(),
            _ => visible(&self.text()),
        };
        let _ = std::io::stderr().write_all(text.as_bytes());
    }

    /// The text of the error, with a line break at its end.
    fn text(&self) -> String {
        match self {
            Complaint::Input(diagnostics) => {
                let count = diagnostics.0.len();
                let all: String = diagnostics.0.iter().map(|diagnostic| render(diagnostic) + "\n\n").collect();
                format!("{all}{count} error{}; nothing was written\n", if count == 1 { "" } else { "s" })
            }
            Complaint::Failed { failure, folder, resume } => {
                let accept = accept(failure);
                let kept = format!("       what was computed is in {}\n", folder.display());
                let go_on = resume.iter().map(|command| format!("       go on with: {command}\n"));
                format!("error: the run failed: {failure}\n{accept}{kept}{}", go_on.collect::<String>())
            }
            Complaint::SomeFailed(failures, folder) => {
                let told = failures.iter().map(|(name, failure)| format!("error: {name} failed: {failure}\n"));
                let told: String = told.collect();
                let accept = failures.iter().map(|(_, failure)| accept(failure)).max().unwrap_or_default();
                let kept = format!("       what was computed is compared in {}", folder.display());
                format!("{told}{accept}{kept}\n")
            }
            Complaint::Argument(message) | Complaint::Fault(message) | Complaint::CutOff(message) => {
                format!("error: {message}\n")
            }
        }
    }
}

/// The line that names the option by which a failure is accepted; empty if there is none.
fn accept(failure: &Failure) -> &'static str {
    match failure {
        Failure::Unbalanced { .. } | Failure::Unresolved { .. } => {
            "       or accept it with --set solve.on_energy_error=flag\n"
        }
        Failure::Stopped(_) => "",
    }
}

impl From<Diagnostics> for Complaint {
    fn from(diagnostics: Diagnostics) -> Complaint {
        Complaint::Input(diagnostics)
    }
}

impl From<ResultError> for Complaint {
    fn from(error: ResultError) -> Complaint {
        match error {
            // the user can choose another folder or another command
            ResultError::TargetIsFile { .. }
            | ResultError::TargetNotOurs { .. }
            | ResultError::TargetUnwritable { .. }
            | ResultError::TargetHoldsCurrent { .. }
            | ResultError::DiskTooSmall { .. }
            | ResultError::InUse { .. }
            | ResultError::LeftBehind { .. }
            | ResultError::NothingToResume { .. }
            | ResultError::NotCheckpoint { .. }
            | ResultError::OtherProgram { .. }
            | ResultError::Changed { .. }
            | ResultError::Cut { .. }
            | ResultError::NotAFile { .. }
            // what was named to be read is missing or damaged
            | ResultError::Read { .. }
            | ResultError::Json { .. }
            | ResultError::Csv { .. }
            | ResultError::NotANumber { .. }
            | ResultError::Fields { .. }
            | ResultError::NotFields { .. } => Complaint::Argument(error.to_string()),
            _ => Complaint::Fault(error.to_string()),
        }
    }
}

impl From<RunError> for Complaint {
    fn from(error: RunError) -> Complaint {
        match error {
            RunError::Input(diagnostics) => diagnostics.into(),
            RunError::Result(error) => error.into(),
            RunError::Report(error) => Complaint::Fault(error.to_string()),
            RunError::OtherInputs { .. } => {
                Complaint::Argument(format!("{error}\n       run it with the same inputs, or without --resume"))
            }
            RunError::CutOff { .. } => Complaint::CutOff(error.to_string()),
        }
    }
}

/// The most bytes of a line of a file that is shown.
const LONGEST_LINE: usize = 500;

/// The text of a diagnostic in the style of rustc: file, line and column, the line itself, the help.
fn render(diagnostic: &Diagnostic) -> String {
    let title = if diagnostic.path.is_empty() {
        diagnostic.message.clone()
    } else {
        format!("{}: {}", diagnostic.path, diagnostic.message)
    };
    let mut group = Level::ERROR.primary_title(title).elements(Vec::<annotate_snippets::Element>::new());
    match &diagnostic.place {
        Some(Place::File { source, span }) => {
            let end = span.end.min(source.text.len());
            let span = span.start.min(end)..end;
            // a line too long to be read is not shown
            let (before, after) = source.text.split_at(span.start);
            let start = before.rfind('\n').map_or(0, |newline| newline + 1);
            let length = span.start - start + after.find('\n').unwrap_or(after.len());
            group = match diagnostic.location().filter(|_| length > LONGEST_LINE) {
                Some(Location { file, line, column }) => {
                    group.element(Origin::path(file).line(line).char_column(column))
                }
                None => group.element(
                    Snippet::source(source.text.as_str())
                        .path(source.name.as_str())
                        .annotation(AnnotationKind::Primary.span(span)),
                ),
            };
        }
        Some(Place::Override(text)) => group = group.element(Level::NOTE.message(format!("in --set {text}"))),
        None => {}
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let is_coloured = anstream::AutoStream::choice(&std::io::stderr()) != anstream::ColorChoice::Never;
    let renderer = if is_coloured { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group])
}
