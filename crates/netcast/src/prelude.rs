//! The names that a program needs to build a net, run it and read its results.
//!
//! ```
//! use netcast::prelude::*;
//! ```

pub use crate::{Body, Case, CaseBuilder, Facts, Launch, Link, Node, Rope, Run, RunError, RunFrame, Stow, Web};
pub use glam::{DQuat, DVec3};
pub use netcast_dynamics::custom::CustomEffect;
pub use netcast_dynamics::simulate::{Frame, Live, Observer};
pub use netcast_results::{History, Summary};
pub use netcast_scenario::Diagnostics;
