//! Runs held against a second method of our own or against another program.

#[path = "../support/mod.rs"]
mod support;

mod hanging_net;
mod swinging_cable;
