//! The order of the repository: which crate and which module imports which, and its documents.

mod architecture;
mod documents;
mod modules;
