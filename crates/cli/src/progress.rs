//! The progress bar: on standard error, where that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use netcast::Progress;

/// Steps of the bar from start to end.
const MARKS: u64 = 1000;

/// A bar that shows the time simulated and the time left; hidden where `quiet` or where nobody sees it.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar at its start.
    pub fn new(quiet: bool) -> Bar {
        // indicatif draws nothing where standard error is no terminal
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(MARKS), target);
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left");
        bar.set_style(style.expect("the template is well formed"));
        bar.enable_steady_tick(Duration::from_millis(200));
        Bar(bar)
    }

    /// Moves the bar.
    pub fn tell(&self, progress: Progress) {
        let (share, message) = match progress {
            // residuals fall by about the same factor again and again
            Progress::Relaxing { iterations, residual, tolerance } => (
                residual.min(1.0).ln() / tolerance.ln(),
                format!("equilibrium: {residual:.1e} out of balance after {iterations} iterations"),
            ),
            Progress::Running { time_s, end_s } => (time_s / end_s, format!("{time_s:.3} of {end_s:.3} s")),
        };
        self.0.set_position((MARKS as f64 * share) as u64);
        self.0.set_message(message);
    }

    /// Takes the bar away.
    pub fn end(&self) {
        self.0.finish_and_clear();
    }
}
