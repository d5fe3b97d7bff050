//! netcast simulates flexible nets that are thrown: rope webs folded into a launcher, pulled out by a few heavy
//! tractors, unfolding and flying.
//!
//! A run in three lines, from a scenario to its summary:
//!
//! ```no_run
//! use netcast::{Document, RunOptions, run};
//!
//! let document = Document::read("examples/04_square_net/square_net.toml".as_ref(), &[])?;
//! let ran = run(&document, "results/square_net".as_ref(), &RunOptions::default(), &mut |_| {}, &|| false)?;
//! println!("opens to {:?} m^2", ran.summary.opening.area_max_m2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Each stage is a crate of its own, re-exported here: [`webs`] is what is made, [`scenario`] what the user writes,
//! [`model`] what that means, [`dynamics`] the simulator, [`results`] what comes out, [`report`] what one looks at.
//! ARCHITECTURE.md has the picture.

pub mod bench;
mod compare;
mod inputs;
mod landmarks;
mod launched;
mod rest;
mod run;
mod values;

pub use netcast_dynamics as dynamics;
pub use netcast_model as model;
pub use netcast_report as report;
pub use netcast_results as results;
pub use netcast_scenario as scenario;
pub use netcast_webs as webs;

pub use compare::{Compared, FEWEST, Lineup, MOST, compare};
pub use landmarks::landmarks;
pub use netcast_model::Model;
pub use netcast_scenario::{Diagnostics, Document, Scenario};
pub use run::{Failure, Progress, Ran, RunError, RunOptions, run, schedule};
