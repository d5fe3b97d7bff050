//! The names that a program needs which builds a net, runs it and looks at what came out.
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
