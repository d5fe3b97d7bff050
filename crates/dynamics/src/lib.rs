//! The simulator proper: lumped masses joined by ropes that pull and do not push, advanced in time.
//!
//! No files, no text, no views; SI units throughout, f64. The tour:
//!
//! * A [`System`](system::System) is the net as it is made: masses, segments, what surrounds it. It does not change.
//! * A [`State`](state::State) is all that does: positions and velocities.
//! * [`forces`] holds the physics, one effect a file.
//! * [`time`] holds the clock: [`time::readable`] is the step as one reads it, [`time::step`] the same bits, faster;
//!   [`step_size`] says how large a step may be. [`layout`] says how a net lies in memory for it.
//! * [`simulate`](simulate::simulate) runs a system from a state and shows every step to an
//!   [`Observer`](simulate::Observer).
//! * A [`Snapshot`](snapshot::Snapshot) is where a run stands; [`resume`](simulate::resume) goes on from one.
//! * [`energy`] keeps the ledger by which a run is judged.
//!
//! A mass on a rope, swinging:
//!
//! ```
//! use glam::DVec3;
//! use netcast_dynamics::forces::breaking::Breaking;
//! use netcast_dynamics::forces::law::Law;
//! use netcast_dynamics::simulate::{simulate, Frame, Live, Observer, Schedule};
//! use netcast_dynamics::state::State;
//! use netcast_dynamics::system::{Environment, Segment, SystemParts};
//! use netcast_dynamics::step_size::step_limit;
//!
//! let (stiffness, damping, breaking) = (1e5, 0.0, Breaking::NEVER);
//! let rope = Segment { ends: [0, 1], rest_length: 1.0, stiffness, damping, group: 0, breaking };
//! let system = SystemParts {
//!     mass: vec![0.0, 2.0],
//!     held: vec![true, false],
//!     tractor: vec![false, false],
//!     segments: vec![rope],
//!     laws: vec![Law::Linear],
//!     environment: Environment { gravity: DVec3::new(0.0, 0.0, -9.81), mass_damping: 0.0, ..Environment::default() },
//!     ..SystemParts::default()
//! }
//! .build()?;
//! let state = State { position: vec![DVec3::ZERO, DVec3::X], velocity: vec![DVec3::ZERO; 2], ..State::default() };
//!
//! struct Lowest(f64);
//! impl Observer for Lowest {
//!     fn step(&mut self, live: &Live) {
//!         self.0 = self.0.min(live.net.position(1).z);
//!     }
//!     fn record(&mut self, _: &Frame) {}
//! }
//! let mut lowest = Lowest(0.0);
//! let schedule = Schedule::new(1.0, 0.01, 0.3 * step_limit(&system).dt);
//! let outcome = simulate(&system, &state, &schedule, 1, &mut lowest);
//! assert!((lowest.0 + 1.0).abs() < 1e-2 && outcome.balance.closure() < 1e-3);
//! # Ok::<(), netcast_dynamics::system::SystemError>(())
//! ```

pub mod air;
pub mod body;
pub mod channel;
pub mod custom;
pub mod drive;
pub mod effects;
pub mod energy;
pub mod forces;
mod frame;
mod lanes;
pub mod launcher;
pub mod layout;
pub mod limits;
pub mod moving;
mod observe;
pub mod parts;
pub mod rope_state;
mod schedule;
pub mod simulate;
pub mod snapshot;
pub mod state;
pub mod statics;
pub mod step_size;
pub mod system;
pub mod team;
pub mod time;
