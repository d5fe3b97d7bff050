//! Faults that were once there: in restarts, damaged files, hostile input, diverging runs and comparisons.

#[path = "../support/mod.rs"]
mod support;

mod compare;
mod diverging_run;
mod fuzz_corpus;
mod lengths;
mod out_of_range;
mod records;
mod resume;
mod silences;
mod truncated;
mod verdicts;
