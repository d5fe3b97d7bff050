//! The netcast command.
fn main() {}
