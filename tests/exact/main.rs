//! Runs held against closed forms, published solutions and laws of conservation.

#[path = "../support/mod.rs"]
mod support;

mod air;
mod bent_rope;
mod breaking;
mod canopies;
mod catalogue_rope;
mod catenary;
mod flight;
mod folded_chain;
mod jerked_rope;
mod launch;
mod measures;
mod pendulum;
mod reactions;
mod ring;
mod sheets;
mod statics;
mod string;
mod taut_rope;
mod thrown_webs;
mod ties;
