//! From what the user wrote to what is simulated: a [`Document`] becomes a [`Model`].
//!
//! ```text
//! drawing     the web's geometry, cut into segments
//! assignment  which rope each link has
//! material    ropes, canopies and bodies as stiffness, damping and mass
//! rope_law    laws of tension, and when a rope breaks
//! canopies    plates and sheets: their triangles, and what of them is rigid
//! stowing     where the nodes lie
//! prescribed  what is led into its container
//! packing     how densely, and how near each other
//! launch      how the tractors are thrown, as meant
//! scatter     and as chance has it
//! bodies      which of them are rigid bodies
//! release     what is let go of, and when
//! ties        what holds until it breaks
//! ground      what it starts from and lands on
//! air         what drags at it, what buoys it up
//! wind        how the air moves
//! exposure    what the air does to it, in figures
//! loads       what acts on the web
//! drives      what of it is moved, and how
//! stepping    how large a step may be, and whether the run will end
//! size        whether the machine has the memory
//! ```
//!
//! Everything that does not fit is reported at the place in the file that says so.

mod air;
mod assignment;
mod binding;
mod bodies;
mod canopies;
mod canopy_links;
mod drawing;
mod drives;
mod exposure;
mod ground;
mod launch;
mod loads;
mod material;
mod packing;
mod prescribed;
mod release;
mod rope_law;
mod scatter;
mod selection;
mod size;
mod stepping;
mod stowing;
mod ties;
mod wind;

pub use air::AirOutline;
pub use canopies::CutSheet;
pub use exposure::{Fall, RopesInAir};
pub use launch::{Throw, Thrown};
pub use material::{Group, Link, PlacedBody, Role};
pub use packing::Packing;
pub use stowing::node_id;

use glam::{DMat3, DQuat, DVec3};
use netcast_dynamics::air::wind::Wind;
use netcast_dynamics::body::Body;
use netcast_dynamics::energy::Ledger;
use netcast_dynamics::forces::law::RopeState;
use netcast_dynamics::forces::orbit::Orbit;
use netcast_dynamics::state::State;
use netcast_dynamics::statics::{Unsupported, unsupported};
use netcast_dynamics::system::{Environment, Segment, System, SystemParts};
use netcast_dynamics::time::step_size::{StepLimit, step_limit};
use netcast_webs::{Audit, Bill, CutWeb};

use binding::Bound;
use canopies::Canopies;
use drives::Drives;
use material::Member;
use netcast_scenario::body::Solid;
use netcast_scenario::diagnostic::{Diagnostic, Diagnostics};
use netcast_scenario::document::Document;
use netcast_scenario::scenario::Scenario;

/// A scenario ready to be simulated, with the names of its parts.
#[derive(Debug, Clone)]
pub struct Model {
    /// The scenario with everything written out that was chosen on the way.
    pub scenario: Scenario,
    /// What is simulated.
    pub system: System,
    /// The mass of it all, kg; in the system what is driven has none.
    pub mass: f64,
    /// Where it starts, world frame.
    pub state: State,
    /// The web as drawn and cut; node k of the system is node k of the web.
    pub cut: CutWeb,
    /// Its cells as closed loops of nodes; see [`CutWeb::cells`].
    pub cells: Vec<Vec<usize>>,
    /// Turns the launch frame (z along the launch axis) to the world.
    pub frame: DMat3,
    /// Link class and rope by the system's class number.
    pub groups: Vec<Group>,
    /// The tractors in order around the web; their nodes.
    pub tractors: Vec<usize>,
    /// Payloads, sensor and tractors where they sit.
    pub bodies: Vec<PlacedBody>,
    /// How each tractor is thrown, in the order of the corners, (tractors,); none where it is not.
    pub throws: Vec<Option<Throw>>,
    /// The canopies that are sheets, in order.
    pub sheets: Vec<CutSheet>,
    /// The bill of materials.
    pub bill: Bill,
    /// The state at the start, looked over.
    pub audit: Audit,
    /// What bounds the step.
    pub limit: StepLimit,
    /// What the air comes to; none where there is none.
    pub air: Option<AirOutline>,
    /// What was chosen or changed for the user, to be said.
    pub notes: Vec<String>,
    members: Vec<Member>,
}

impl Model {
    /// Makes the model of a scenario.
    ///
    /// # Errors
    /// Everything that does not fit, as far as it can be told at once, each with its place.
    pub fn new(document: &Document) -> Result<Model, Diagnostics> {
        let mut scenario = document.scenario.clone();
        let mut notes = document.library.notes();
        let mut cut = drawing::draw(document, &mut scenario, &mut notes)?;
        let frame = launch::frame(&scenario);
        // what can be wrong with a web once it is drawn, all at once
        let mut found = Vec::new();
        let materials = gather(material::materials(document, &mut cut, &scenario, &mut notes), &mut found);
        let no_canopies = Canopies::default();
        let canopies = materials.as_ref().map_or(&no_canopies, |made| &made.canopies);
        let mass = materials.as_ref().map_or(&[][..], |made| &made.mass);
        let stowed = gather(stowing::stow(document, &cut, &scenario, canopies, mass), &mut found);
        let position: Vec<DVec3> = stowed.iter().flat_map(|stowed| &stowed.positions).map(|&x| frame * x).collect();
        let loads = match &materials {
            Some(made) => gather(loads::loads(document, &cut, &scenario, &made.members, &made.groups), &mut found),
            None => None,
        };
        let drives = match position.is_empty() {
            false => {
                let named = Drives { table: "drive", drives: &scenario.drive, files: &document.paths };
                gather(named.resolve(document, &cut, &position), &mut found)
            }
            true => None,
        };
        let throws = gather(launch::throws(document, &cut, &scenario), &mut found);
        let held = gather(selection::held(document, &cut, &scenario, &canopies.bound), &mut found);
        let audit = match (&materials, &stowed) {
            (Some(materials), Some(stowed)) => {
                gather(stowing::audit(document, &cut, materials, &stowed.positions), &mut found)
            }
            _ => None,
        };
        let (Some(mut materials), Some(stowed), Some(loads), Some(drives), Some(mut throws), Some(held), Some(audit)) =
            (materials, stowed, loads, drives, throws, held, audit)
        else {
            return Err(Diagnostics::fail_if_any(found).expect_err("what is missing was found wrong"));
        };

        let mut tractor = vec![false; cut.nodes.len()];
        for &node in &cut.web.tractors {
            tractor[node] = true;
        }
        let gravity = scenario.environment.gravity.si();
        let mut parts = SystemParts {
            mass: materials.mass,
            held,
            tractor,
            segments: materials.members.iter().map(|m| m.segment).collect(),
            laws: materials.groups.iter().map(|group| group.law.clone()).collect(),
            bends: materials.bends,
            membranes: materials.canopies.membranes,
            hinges: materials.canopies.hinges,
            bodies: materials.canopies.bound.iter().map(|bound| bound.body.clone()).collect(),
            loads,
            drives,
            environment: Environment {
                // 0 - g, for the sign of a zero
                gravity: DVec3::new(0.0, 0.0, 0.0 - gravity),
                mass_damping: scenario.environment.damping.si(),
                ..Environment::default()
            },
            ..SystemParts::default()
        };
        let velocity = launch::own_velocities(document, &cut, frame);
        let turned = |bound: &Bound| {
            let orientation = DQuat::from_mat3(&(frame * stowed.turns[bound.canopy] * bound.axes)).normalize();
            bound.body.turning(orientation, DVec3::ZERO)
        };
        let rotation = materials.canopies.bound.iter().map(turned).collect();
        let mut state = State { position, velocity, rotation };
        let rigid = (&mut parts, &mut state);
        bodies::make_rigid(document, &cut, &scenario, &throws, &mut materials.bodies, rigid)?;
        let bodies = parts.bodies.clone();
        let centre_of = |knot: usize| {
            let body = bodies.iter().find(|body| body.ties.iter().any(|tie| tie.node == knot));
            body.map_or(knot, |body| body.centre)
        };
        drives::take_hold(document, &cut, &mut parts, &state.position)?;
        // what acts on a tractor acts on its middle
        for load in parts.loads.iter_mut().filter(|load| cut.web.tractors.contains(&load.node)) {
            load.node = centre_of(load.node);
        }
        notes.extend(stowed.settled);
        let tractors: Vec<usize> = cut.web.tractor_ring().into_iter().map(centre_of).collect();
        throws.iter_mut().flatten().for_each(|throw| throw.node = centre_of(throw.node));
        release::throw(&mut throws, &mut parts, &mut state);
        let turning = scenario.launch.as_ref().map_or(0.0, |launch| launch.spin.si());
        release::spin(turning * (frame * DVec3::Z), &parts, &mut state);
        release::hold_back(document, &cut, &scenario, &tractors, &mut notes, (&mut parts, &mut state))?;
        // what is tied holds for a while only
        let falls = !parts.held.contains(&true);
        let (members, groups) = (&mut materials.members, &mut materials.groups);
        ties::tie(document, &cut, &scenario, (members, groups), (&mut parts, &mut state))?;
        let mass = parts.mass.iter().sum();
        ground::lay(document, &cut, &mut scenario, &materials.bodies, (&mut parts, &state))?;
        let made = air::Made {
            cut: &cut,
            members: &materials.members,
            groups: &materials.groups,
            bodies: &materials.bodies,
            throws: &throws,
            triangles: &canopies::triangles(&materials.canopies.sheets, &cut),
            bound: &materials.canopies.bound,
        };
        let air = air::surround(document, &scenario, &made, (&mut parts, &state))?;
        parts.environment.orbit = scenario.environment.orbit.as_ref().map(|orbit| Orbit {
            mean_motion: orbit.mean_motion_rad_s(),
            radial: DVec3::Z,
            along: DVec3::X,
        });
        let system =
            parts.build().map_err(|error| Diagnostics::from(document.diagnostic("rope", error.to_string())))?;
        let limit = step_limit(&system);
        let chosen = stepping::step_fraction(&system, &materials.groups, &limit, &scenario.solve);
        scenario.solve.step_fraction.get_or_insert(netcast_scenario::quantity::Number::constant(chosen));
        stepping::affordable(document, &scenario, &limit, &cut, &materials.members)?;
        // the packing knows nothing of laws, nor of elements
        let ropes = RopeState::at_rest(&system, &state.position);
        let audit = Audit { stored_energy: Ledger::of(&system, &state, &ropes).elastic, ..audit };
        if scenario.solve.statics.is_some() && system.environment().orbit.is_some() {
            let message = "beside an orbit no equilibrium is looked for";
            return Err(document.diagnostic("solve.static", message).with_help("leave it out").into());
        }
        if scenario.solve.statics.is_some()
            && let Some(Unsupported { node, load }) = unsupported(&system, &state)
        {
            let message = format!(
                "there is no equilibrium: nothing holds the part of the web with {}, which bears {load:.4} N",
                cut.node_label(node)
            );
            let help = "hold it by [hold], or leave what bears on it out";
            return Err(document.diagnostic("solve.static", message).with_help(help).into());
        }
        let cells = cut.cells();
        if cells.is_empty() && scenario.measure.target_diameter.is_some() {
            notes.push(
                "the target's coverage is not measured: drawn flat, this web's ropes enclose no cells".to_owned(),
            );
        }
        notes.extend(launched_and_held(&system, &throws));
        notes.extend(exposure::notes(&scenario, air.as_ref(), falls));
        if let Some(note) = ill_begun(&system, &state) {
            notes.push(note);
        }
        Ok(Model {
            scenario,
            system,
            mass,
            state,
            frame,
            groups: materials.groups,
            tractors,
            bodies: materials.bodies,
            throws,
            bill: materials.bill,
            audit,
            limit,
            air,
            notes,
            members: materials.members,
            sheets: materials.canopies.sheets,
            cells,
            cut,
        })
    }

    /// The launch axis, a unit vector in the world frame.
    pub fn axis(&self) -> DVec3 {
        self.frame * DVec3::Z
    }

    /// What a message calls a segment, such as "segment 12 of traction rope 3".
    pub fn segment_label(&self, segment: usize) -> String {
        self.members[segment].label(&self.cut)
    }

    /// What a message calls a node, such as "knot 12".
    pub fn node_label(&self, node: usize) -> String {
        match self.tied_to(node) {
            Some(knot) => format!("the centre of {}", self.cut.node_label(knot)),
            None if node < self.cut.nodes.len() => self.cut.node_label(node),
            None => "the place of a break tie".to_owned(),
        }
    }

    /// The knot that the rigid body with its centre at `node` is tied to.
    fn tied_to(&self, node: usize) -> Option<usize> {
        let body = self.system.bodies().iter().find(|body| body.centre == node)?;
        body.ties.first().map(|tie| tie.node)
    }

    /// The links of the web, as `[assign]` can name them.
    pub fn links(&self) -> Vec<Link> {
        material::links(&self.cut.web, &self.members, &self.groups)
    }

    /// Whether a segment is a piece of rope; members of canopies are not.
    pub fn is_rope(&self, segment: usize) -> bool {
        self.members[segment].is_rope()
    }

    /// The tractors that are rigid bodies, in the order of the corners; none for the others.
    pub fn tractors_by_corner(&self) -> Vec<Option<(Solid, &Body)>> {
        let at = |knot: &usize| {
            let is_it = |placed: &&PlacedBody| {
                placed.role == Role::Tractor && placed.rigid.is_some() && self.tied_to(placed.node) == Some(*knot)
            };
            let placed = self.bodies.iter().find(is_it)?;
            Some((placed.solid, &self.system.bodies()[placed.rigid?]))
        };
        self.cut.web.tractors.iter().map(at).collect()
    }

    /// The segments of rope that meet at some node of `nodes`, or at what is tied to a body there.
    pub fn ropes_at(&self, nodes: &[usize]) -> Vec<usize> {
        let nodes: Vec<usize> = nodes.iter().map(|&node| self.tied_to(node).unwrap_or(node)).collect();
        let meets = |s: &Segment| s.ends.iter().any(|end| nodes.contains(end));
        let segments = self.system.segments().iter().enumerate();
        segments.filter(|(i, s)| self.is_rope(*i) && meets(s)).map(|(i, _)| i).collect()
    }

    /// Feature points by name with their nodes.
    pub fn points(&self) -> Vec<(String, usize)> {
        self.cut.web.points.iter().map(|(name, &site)| (name.clone(), self.cut.node_of(site))).collect()
    }
}

/// What came out, or none with what is wrong added to `found`.
fn gather<T>(result: Result<T, Diagnostics>, found: &mut Vec<Diagnostic>) -> Option<T> {
    result.map_err(|Diagnostics(wrong)| found.extend(wrong)).ok()
}

/// Tractors that are thrown and stay put.
fn launched_and_held(system: &System, throws: &[Option<Throw>]) -> Option<String> {
    let is_both = |throw: &&Throw| system.held()[throw.node] && throw.by != Thrown::At(DVec3::ZERO);
    let (count, all) = (throws.iter().flatten().filter(is_both).count(), throws.len());
    (count > 0).then(|| format!("{count} of {all} tractors are held by [hold] or [drive]: they are not launched"))
}

/// A net at rest that nothing moves.
fn ill_begun(system: &System, state: &State) -> Option<String> {
    let still = state.velocity.iter().all(|v| *v == DVec3::ZERO) && system.launchers().is_empty();
    let unloaded = system.environment().gravity == DVec3::ZERO && system.loads().is_empty();
    let calm = system.environment().air.as_ref().is_none_or(|air| air.wind == Wind::none());
    let slack = system.segments().iter().all(|s| {
        let [a, b] = s.ends;
        (state.position[b] - state.position[a]).length() <= s.rest_length
    });
    let weightless = system.environment().orbit.is_none();
    (still && unloaded && weightless && calm && slack && system.drives().is_empty())
        .then(|| "nothing moves: there is no launch, no gravity and no tension at the start".to_owned())
}
