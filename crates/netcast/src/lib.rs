//! netcast simulates flexible nets that are thrown: a rope web lies folded in a launcher, a few heavy tractors pull it
//! out, and it unfolds and flies.
//!
//! # In fifteen lines
//!
//! This program builds a net, throws it, prints its largest area, and writes the result folder:
//!
//! ```
//! use netcast::prelude::*;
//!
//! let case = Case::new(Web::square("5 m", "1 m"))
//!     .rope(Rope::new("3 mm", "970 kg/m^3", "5 GPa"))
//!     .tractor(Body::particle("0.5 kg"))
//!     .stow(Stow::scale(0.25))
//!     .launch(Launch::new("25 m/s", "12 m/s"))
//!     .duration("0.1 s")
//!     .build()?;
//! let run = case.simulate()?;
//! println!("{:?} m^2", run.summary.opening.area_max_m2);
//! # let folder = tempfile::tempdir()?;
//! # let folder = folder.path().join("mine");
//! run.write(&folder)?;
//! # assert!(run.failure.is_none() && run.summary.opening.area_max_m2.is_some_and(|area| area > 1.0));
//! # assert!(folder.join("report.html").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A tour
//!
//! A **web** is the net that is thrown: ropes tied at knots, made from a few numbers or node by node. A number is SI, a
//! text carries its unit, and keys have the names of the scenario.
//!
//! ```
//! use netcast::prelude::*;
//!
//! let square = Web::square("5 m", "0.5 m").set("segments_per_mesh", 2);
//! let corners = [("a", 0.0, 0.0), ("b", 2.0, 0.0), ("c", 0.0, 2.0)];
//! let nodes = corners.map(|(id, x, y)| Node::at(id, [x, y, 0.0]));
//! let triangle = Web::graph(nodes, [Link::between("a", "b"), Link::between("b", "c"), Link::between("c", "a")]);
//! # let _ = square;
//! # let case = Case::new(triangle).rope(Rope::of("aramid rope", "2 mm")).duration(0.01).build()?;
//! # assert_eq!(case.links().len(), 3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A **case** is a web with its ropes, launch and surroundings, checked and ready to be simulated. It comes from a
//! scenario or from code. All mistakes in it are reported at once, under the keys of the scenario.
//!
//! ```
//! use netcast::prelude::*;
//!
//! let written = Case::read("../../examples/04_square_net/square_net.toml", &[])?;
//! assert_eq!(written.scenario().title, "A square net thrown by four corner masses");
//!
//! let wrong = Case::new(Web::square("5 m", "0.5 kg")).rope(Rope::new(2e-3, -970.0, 5e9)).duration("0.1 s");
//! let diagnostics = wrong.build().unwrap_err();
//! let keys: Vec<&str> = diagnostics.0.iter().map(|diagnostic| &diagnostic.path[..]).collect();
//! assert_eq!(keys, ["web.square.mesh", "rope.density"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The **facts** of a case are what `netcast check` prints: its materials, its state at the start, the cost of a run.
//!
//! ```
//! # use netcast::prelude::*;
//! let case = Case::new(Web::square(5.0, 1.0)).rope(Rope::new(3e-3, 970.0, 5e9)).duration(0.1).build()?;
//! let facts = case.facts();
//! let length_m: f64 = facts.bill.ropes.iter().map(|rope| rope.length_m).sum();
//! assert!((length_m - 2.0 * 6.0 * 5.0).abs() < 1e-9);
//! assert!(facts.cost.is_some_and(|cost| cost.dt_s <= cost.stable_dt_s));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A **run** is the result: a **summary** of numbers, a **history** with a row for each record time, and **frames** of
//! the whole net. [`Case::simulate`] keeps it in memory and writes nothing.
//!
//! ```
//! # use netcast::prelude::*;
//! # let net = Case::new(Web::square(5.0, 1.0)).rope(Rope::new(3e-3, 970.0, 5e9)).tractor(Body::particle(0.5));
//! # let case = net.stow(Stow::scale(0.25)).launch(Launch::new(25.0, 12.0)).duration(0.05).build()?;
//! let run = case.simulate()?;
//! let curve: Vec<(Option<f64>, Option<f64>)> =
//!     run.history().values("time_s").unwrap().zip(run.history().values("area_m2").unwrap()).collect();
//! assert!(curve.last() > curve.first());
//! for frame in run.frames() {
//!     let lowest_m = frame.position_m.iter().map(|position| position.z).fold(f64::INFINITY, f64::min);
//!     assert!(lowest_m.is_finite(), "at {} s", frame.time_s);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! An **observer** sees every step and every record of a [`Simulation`], which may also be stopped early.
//!
//! ```
//! # use netcast::prelude::*;
//! # let net = Case::new(Web::square(5.0, 1.0)).rope(Rope::new(3e-3, 970.0, 5e9)).tractor(Body::particle(0.5));
//! # let case = net.stow(Stow::scale(0.25)).launch(Launch::new(25.0, 12.0)).duration(0.05).build()?;
//! struct Peak(f64);
//!
//! impl Observer for Peak {
//!     fn step(&mut self, live: &Live) {
//!         self.0 = self.0.max(live.net.tension(0));
//!     }
//!     fn record(&mut self, _: &Frame) {}
//! }
//!
//! let mut peak = Peak(0.0);
//! let run = case.simulation().observe(&mut peak).stop_when(|frame| frame.time >= 0.02).run()?;
//! println!("largest tension of segment 0: {} N", peak.0);
//! # assert_eq!(run.frames().last().map(|frame| frame.time_s), Some(0.02));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! To **publish** a run is to write its result folder, as `netcast run` does. [`Run::write`] writes it after a run in
//! memory. [`Simulation::run_to`] writes it during the run, so that a crash loses little and the run can be resumed.
//!
//! ```
//! # use netcast::prelude::*;
//! # let net = Case::new(Web::square(5.0, 1.0)).rope(Rope::new(3e-3, 970.0, 5e9)).tractor(Body::particle(0.5));
//! # let case = net.stow(Stow::scale(0.25)).launch(Launch::new(25.0, 12.0)).duration(0.01).build()?;
//! # let results = tempfile::tempdir()?;
//! # let results = results.path();
//! let ran = case.simulation().threads(1).run_to(results.join("streamed"))?;
//! let written = case.simulate()?.write(results.join("written"))?;
//! let history = |folder: &std::path::Path| std::fs::read(folder.join("history.csv"));
//! assert_eq!(history(&ran.folder)?, history(&written)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Crates
//!
//! Each stage is a crate, re-exported here: [`webs`] makes nets, [`scenario`] reads the user's input, [`model`] builds
//! the system from it, [`dynamics`] simulates it, [`results`] holds and writes the results, [`report`] shows them.
//! ARCHITECTURE.md shows how they depend on each other.

pub mod bench;
mod builder;
mod case;
mod compare;
mod error;
pub mod facts;
mod inputs;
mod landmarks;
mod launched;
mod memory;
mod net;
pub mod prelude;
mod progress;
mod publish;
mod rest;
mod resume;
mod sections;
mod simulate;
mod summary;
mod values;
mod verdict;

pub use netcast_dynamics as dynamics;
pub use netcast_model as model;
pub use netcast_report as report;
pub use netcast_results as results;
pub use netcast_scenario as scenario;
pub use netcast_webs as webs;

pub use builder::CaseBuilder;
pub use case::Case;
pub use compare::{Compared, FEWEST, Lineup, MOST, compare};
pub use error::RunError;
pub use facts::Facts;
pub use memory::{Run, RunFrame};
pub use net::{Link, Node};
pub use netcast_model::Model;
pub use netcast_scenario::{Diagnostics, Document, Scenario};
pub use progress::Progress;
pub use publish::Ran;
pub use sections::{Body, Launch, Rope, Stow, Web};
pub use simulate::{RunOptions, Simulation};
pub use toml::{Table, Value};
pub use verdict::Failure;
