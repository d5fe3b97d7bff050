//! The shipped examples, each run once: they end with their energy accounted for, the webs of the paper come out as it
//! reports, and all results have the bytes of the golden record.

#[path = "../support/mod.rs"]
mod support;

mod every;
mod golden;
mod paper;
mod runs;
