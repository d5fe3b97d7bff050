//! The stages that turn a [`Document`](netcast_scenario::Document) into a [`Model`](crate::Model). `STAGES` lists their
//! order and the stages that each one needs.
//!
//! A mistake is reported at its place in the file.

use Stage::*;
use netcast_scenario::Diagnostics;

mod air;
mod air_outline;
mod assignment;
mod bends;
mod binding;
mod bodies;
mod canopies;
mod canopy_links;
mod canopy_parts;
mod cuts;
mod draft;
mod drawing;
mod drives;
mod exposure;
mod ground;
mod launch;
mod listed;
mod loads;
pub(crate) mod material;
pub(crate) mod members;
mod notes;
mod packing;
mod places;
mod points;
mod prescribed;
mod proportions;
mod release;
mod rope_law;
mod scatter;
mod selection;
mod silences;
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

/// One stage of making a model from a drawn web.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    Points,
    Assignment,
    Laws,
    Ropes,
    Bends,
    Clamps,
    Cuts,
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

/// The work of a stage: it extends the draft, or reports mistakes.
type Make = fn(&mut Draft) -> Result<(), Diagnostics>;

/// The stages in their order, each with the stages that must have succeeded before. A stage that copes with the
/// incomplete work of another does not list it.
pub(crate) const STAGES: &[(Stage, &[Stage], Make)] = &[
    // the names of feature points
    (Points, &[], points::check),
    // which rope each link has
    (Assignment, &[], assignment::assign),
    // pairs of link class and rope, with the law of the rope
    (Laws, &[Assignment], material::groups),
    // ropes as segments with stiffness, damping and mass
    (Ropes, &[Laws], material::ropes),
    // where ropes resist bending
    (Bends, &[Ropes], bends::bend),
    // ropes that are cut at a time
    (Cuts, &[Ropes], cuts::cut),
    // payloads, sensor and tractors
    (Bodies, &[], material::place_bodies),
    // canopies as links, plates or sheets; adds nodes
    (Canopies, &[Ropes, Bodies], canopies::make),
    // masses of bodies and of a graph's nodes
    (Masses, &[Canopies], material::masses),
    // the bill of materials
    (Bill, &[Ropes, Bodies], material::list),
    // positions of the nodes; leading a web into a container needs masses
    (Stowing, &[], stowing::stow),
    // forces on the nodes
    (Loads, &[Ropes, Points], loads::load),
    // nodes that follow given paths
    (Drives, &[Stowing, Points], drives::drive),
    // how the tractors are thrown, with scatter
    (Throws, &[], launch::throws),
    // nodes that are held
    (Held, &[], selection::hold),
    // whether the packing stretches a rope or a sheet
    (Audit, &[Masses, Stowing], stowing::audit),
    // the parts of the system
    (Assembly, &[Masses, Stowing], system::assemble),
    // tractors as rigid bodies that ropes can turn; adds nodes
    (RigidBodies, &[Assembly, Throws, Held], bodies::make_rigid),
    // ends of ropes that keep their direction
    (Clamps, &[Ropes, Assembly], bends::clamp),
    // driven nodes count as held; a rigid body is driven at its centre
    (Hold, &[Assembly, Drives], drives::take_hold),
    // loads and throws of a tractor move to its centre
    (Centres, &[Assembly], bodies::act_on_centres),
    // velocities at the start, and launchers of tractors that start later
    (Launch, &[Centres], release::launch),
    // nodes that covers or a late sector hold back
    (Covers, &[Launch], release::hold_back),
    // break ties and stitches; adds nodes
    (Ties, &[Points, Launch], ties::tie),
    // the ground under all nodes and bodies
    (Ground, &[RigidBodies], ground::lay),
    // drag and buoyancy
    (Air, &[RigidBodies], air::surround),
    // the system, built from its parts and checked
    (System, &[Bends, Loads, Held, Hold, Covers, Ties, Ground, Air, Audit, Bill], system::build),
    // the size of the step, and whether the number of steps is affordable
    (Steps, &[System], stepping::choose),
    // whether the equilibrium exists that `solve.static` asks for
    (Statics, &[System], statics::check),
    // notes to the user
    (Notes, &[Steps], notes::add),
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
