//! The state of a law of tension.

/// State of a segment beside the positions of its nodes. Its law says what the two numbers are.
pub type Memory = [f64; 2];
