//! Nets in motion: known motions, and laws that hold for any net.

mod nets;

mod air;
mod bent_beams;
mod bodies;
mod breaking;
mod effects;
mod free_flight;
mod ground;
mod launchers;
mod readable_and_fused_agree;
mod rope_laws;
mod second_order;
mod sheets;
mod step_limit;
mod waves;
