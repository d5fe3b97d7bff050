//! Rules of the repository: imports between crates and modules, and the form of its documents.

mod architecture;
mod documents;
mod modules;
