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
        self.0.set_position((MARKS as f64 * progress.time_s / progress.end_s) as u64);
        self.0.set_message(format!("{:.3} of {:.3} s", progress.time_s, progress.end_s));
    }

    /// Takes the bar away.
    pub fn end(&self) {
        self.0.finish_and_clear();
    }
}
