//! The progress bar, on standard error if that is a terminal.

use std::fmt::Write;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use netcast::Progress;

use crate::screen::wait;

/// Number of steps of the bar: fine, so that the time left of a long run is known soon.
const MARKS: u64 = 1_000_000;

/// A bar that shows the simulated time and the time left.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar at its start; a `quiet` one stays hidden.
    pub fn new(quiet: bool) -> Bar {
        // indicatif draws nothing where standard error is no terminal
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(MARKS), target);
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}{left}");
        let style = style.expect("the template is well formed").with_key("left", time_left);
        bar.set_style(style);
        bar.enable_steady_tick(Duration::from_millis(200));
        Bar(bar)
    }

    /// Moves the bar to this progress.
    pub fn show(&self, progress: Progress) {
        let (share, message) = match progress {
            // the residual falls by about the same factor an iteration: its logarithm shows the share
            Progress::Relaxing { iterations, residual, tolerance } => (
                residual.min(1.0).ln() / tolerance.ln(),
                format!("equilibrium: {residual:.1e} out of balance after {iterations} iterations"),
            ),
            Progress::Running { time_s, end_s } => (time_s / end_s, format!("{time_s:.3} of {end_s:.3} s")),
        };
        self.0.set_position((MARKS as f64 * share) as u64);
        self.0.set_message(message);
    }

    /// Removes the bar.
    pub fn end(&self) {
        self.0.finish_and_clear();
    }
}

/// Writes the time left, once there is a rate to tell it by.
fn time_left(state: &ProgressState, out: &mut dyn Write) {
    if state.pos() > 0 && state.per_sec() > 0.0 {
        // a bar that cannot be drawn is no reason to stop a run
        let _ = write!(out, "  about {} left", wait(state.eta().as_secs_f64()));
    }
}
