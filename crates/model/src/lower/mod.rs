//! From what the user wrote to what is simulated: a [`Document`](netcast_scenario::Document) becomes a
//! [`Model`](crate::Model), stage by stage. `STAGES` has their order and what each of them needs.
//!
//! Everything that does not fit is reported at the place in the file that says so.

use Stage::*;
use netcast_scenario::Diagnostics;

mod air;
mod air_outline;
mod assignment;
mod binding;
mod bodies;
mod canopies;
mod canopy_links;
mod canopy_parts;
mod draft;
mod drawing;
mod drives;
mod exposure;
mod ground;
mod launch;
mod loads;
pub(crate) mod material;
pub(crate) mod members;
mod notes;
mod packing;
mod places;
mod points;
mod prescribed;
mod release;
mod rope_law;
mod scatter;
mod selection;
mod size;
mod statics;
mod stepping;
mod stowing;
mod system;
mod throw;
mod ties;
mod wind;

pub use air_outline::AirOutline;
pub use canopy_parts::CutSheet;
pub(crate) use draft::Draft;
pub use exposure::{Fall, RopesInAir};
pub use members::{Group, Link, PlacedBody, Role};
pub use packing::Packing;
pub use stowing::node_id;
pub use throw::{Throw, Thrown};

/// A step on the way to a model, once the web is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    Points,
    Assignment,
    Laws,
    Ropes,
    Bends,
    Bodies,
    Canopies,
    Masses,
    Bill,
    Stowing,
    Loads,
    Drives,
    Throws,
    Held,
    Audit,
    Assembly,
    RigidBodies,
    Hold,
    Centres,
    Launch,
    Covers,
    Ties,
    Ground,
    Air,
    System,
    Steps,
    Statics,
    Notes,
}

/// What a stage does: adds to the draft, or says what does not fit.
type Make = fn(&mut Draft) -> Result<(), Diagnostics>;

/// The stages in their order, each with those that it cannot do without. A stage that reads what another may have left
/// incomplete, and makes do with it, does not need that.
pub(crate) const STAGES: &[(Stage, &[Stage], Make)] = &[
    // the names of feature points
    (Points, &[], points::check),
    // which rope each link has
    (Assignment, &[], assignment::assign),
    // link classes with their ropes, and the laws of these
    (Laws, &[Assignment], material::groups),
    // ropes as segments with stiffness, damping and mass
    (Ropes, &[Laws], material::ropes),
    // where ropes resist bending
    (Bends, &[Assignment], material::bends),
    // what sits on the web
    (Bodies, &[], material::place_bodies),
    // links, plates and sheets, and what of them is rigid; adds nodes
    (Canopies, &[Ropes, Bodies], canopies::make),
    // what weighs on the nodes beside ropes and canopies
    (Masses, &[Canopies], material::masses),
    // the bill of materials
    (Bill, &[Assignment, Bodies], material::list),
    // where the nodes lie; without masses, nothing is led into a container
    (Stowing, &[], stowing::stow),
    // forces on the nodes
    (Loads, &[Ropes, Points], loads::load),
    // what is moved along paths
    (Drives, &[Stowing, Points], drives::drive),
    // how the tractors are thrown, as meant and as chance has it
    (Throws, &[], launch::throws),
    // what stays put
    (Held, &[], selection::hold),
    // whether the packing stretches anything
    (Audit, &[Masses, Stowing], stowing::audit),
    // all of that as the parts of a system
    (Assembly, &[Masses, Stowing], system::assemble),
    // tractors that ropes can turn; adds nodes
    (RigidBodies, &[Assembly, Throws, Held], bodies::make_rigid),
    // what is driven is held, a rigid body at its centre
    (Hold, &[Assembly, Drives], drives::take_hold),
    // what acts on a tractor acts on its centre
    (Centres, &[Assembly], bodies::act_on_centres),
    // velocities, and launchers of those that start later
    (Launch, &[Centres], release::launch),
    // what covers and a late sector hold back
    (Covers, &[Launch], release::hold_back),
    // ties and stitches, between nodes that do not both rest; adds nodes
    (Ties, &[Points, Launch], ties::tie),
    // the ground under all nodes and bodies
    (Ground, &[RigidBodies], ground::lay),
    // what drags at all of it, and buoys it up
    (Air, &[RigidBodies], air::surround),
    // the parts, checked against each other
    (System, &[Bends, Loads, Held, Hold, Covers, Ties, Ground, Air, Audit, Bill], system::build),
    // how large a step may be, and whether the run will end
    (Steps, &[System], stepping::choose),
    // whether there is an equilibrium, where one is looked for
    (Statics, &[System], statics::check),
    // what may not have been expected
    (Notes, &[System], notes::add),
];

#[cfg(test)]
mod tests {
    use super::STAGES;

    #[test]
    fn every_stage_comes_once_and_after_those_that_it_needs() {
        for (place, (stage, needs, _)) in STAGES.iter().enumerate() {
            let before = &STAGES[..place];
            assert!(!before.iter().any(|(other, ..)| other == stage), "{stage:?}");
            for need in *needs {
                assert!(before.iter().any(|(other, ..)| other == need), "{stage:?} needs {need:?}");
            }
        }
    }
}
