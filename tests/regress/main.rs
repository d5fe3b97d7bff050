//! What must not come back or be lost: restarts, damaged files, hostile input, runs that diverge.

#[path = "../support/mod.rs"]
mod support;

mod compare;
mod diverging_run;
mod fuzz_corpus;
mod resume;
mod truncated;
