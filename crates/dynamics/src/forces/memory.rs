//! What a law of tension may keep from step to step.

/// What a segment remembers of its past beyond where its nodes are. Its law says what the numbers are.
pub type Memory = [f64; 2];
