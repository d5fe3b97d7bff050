//! The shipped examples, each run once: their energy balance closes, the webs of the paper agree with its numbers, and all
//! results have the bytes of the golden record.

#[path = "../support/mod.rs"]
mod support;

mod every;
mod golden;
mod paper;
mod runs;
