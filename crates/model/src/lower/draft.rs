//! A model in the making.

use glam::{DMat3, DVec3};
use netcast_dynamics::state::State;
use netcast_dynamics::step_size::StepLimit;
use netcast_dynamics::system::{System, SystemParts};
use netcast_scenario::{Diagnostic, Diagnostics, Document, Scenario};
use netcast_webs::{Audit, Bill, CutWeb};

use super::air_outline::AirOutline;
use super::canopy_parts::Canopies;
use super::members::{Group, Member, PlacedBody};
use super::throw::{Throw, frame};
use super::{STAGES, Stage, drawing};
use crate::Model;

/// What the stages have made so far. A stage reads what the stages that it needs have made, and adds its own.
pub struct Draft<'d> {
    /// The scenario as it was read.
    pub document: &'d Document,
    /// The same with what is chosen on the way.
    pub scenario: Scenario,
    /// What was chosen or changed for the user, to be said.
    pub notes: Vec<String>,
    /// The web as drawn and cut.
    pub cut: CutWeb,
    /// Turns the launch frame to the world.
    pub frame: DMat3,
    /// The rope of each link, by its place in [`super::assignment::ropes`], (links,).
    pub kinds: Vec<usize>,
    /// Link class and rope by the system's class number.
    pub groups: Vec<Group>,
    /// The segments and what each is a part of.
    pub members: Vec<Member>,
    /// What the canopies are beside links.
    pub canopies: Canopies,
    /// Payloads, sensor and tractors where they sit.
    pub bodies: Vec<PlacedBody>,
    /// Positions of all nodes in the launch frame, as stowed, m.
    pub stowed: Vec<DVec3>,
    /// How each canopy is turned against the flat web, (canopies,).
    pub turns: Vec<DMat3>,
    /// How each tractor is thrown, in the order of the corners, (tractors,).
    pub throws: Vec<Option<Throw>>,
    /// The tractors in order around the web; their nodes.
    pub tractors: Vec<usize>,
    /// Whether nothing of the web is held or driven.
    pub falls: bool,
    /// What the system is made from.
    pub parts: SystemParts,
    /// Where it starts, world frame.
    pub state: State,
    /// Its mass, kg.
    pub mass: f64,
    /// The bill of materials.
    pub bill: Option<Bill>,
    /// The state at the start, looked over.
    pub audit: Option<Audit>,
    /// What the air comes to; none where there is none.
    pub air: Option<AirOutline>,
    /// The system with what bounds its step.
    pub system: Option<(System, StepLimit)>,
    made: Vec<Stage>,
    faults: Vec<Diagnostic>,
}

impl<'d> Draft<'d> {
    /// The web, drawn and cut; nothing can be made without it.
    ///
    /// # Errors
    /// A web that cannot be drawn, or is too large.
    pub fn new(document: &'d Document) -> Result<Self, Diagnostics> {
        let mut scenario = document.scenario.clone();
        let mut notes = document.library.notes();
        let cut = drawing::draw(document, &mut scenario, &mut notes)?;
        Ok(Draft {
            document,
            notes,
            frame: frame(&scenario),
            turns: vec![DMat3::IDENTITY; cut.web.canopies.len()],
            scenario,
            cut,
            kinds: Vec::new(),
            groups: Vec::new(),
            members: Vec::new(),
            canopies: Canopies::default(),
            bodies: Vec::new(),
            stowed: Vec::new(),
            falls: false,
            throws: Vec::new(),
            tractors: Vec::new(),
            parts: SystemParts::default(),
            state: State::default(),
            mass: 0.0,
            bill: None,
            audit: None,
            air: None,
            system: None,
            made: Vec::new(),
            faults: Vec::new(),
        })
    }

    /// Runs the stages in order. One that needs what could not be made is skipped; the faults of all others are collected.
    ///
    /// # Errors
    /// Everything that is wrong.
    pub fn run(mut self) -> Result<Self, Diagnostics> {
        for (stage, needs, make) in STAGES {
            if !needs.iter().all(|need| self.has(*need)) {
                continue;
            }
            match make(&mut self) {
                Ok(()) => self.made.push(*stage),
                Err(Diagnostics(wrong)) => self.faults.extend(wrong),
            }
        }
        Diagnostics::fail_if_any(std::mem::take(&mut self.faults))?;
        Ok(self)
    }

    /// Whether a stage has done its work without a fault.
    pub fn has(&self, stage: Stage) -> bool {
        self.made.contains(&stage)
    }

    /// The model, once all stages have done their work.
    pub fn finish(self) -> Model {
        let made = "a draft without faults is complete";
        let (system, limit) = self.system.expect(made);
        Model {
            cells: self.cut.cells(),
            scenario: self.scenario,
            system,
            mass: self.mass,
            state: self.state,
            frame: self.frame,
            groups: self.groups,
            tractors: self.tractors,
            bodies: self.bodies,
            throws: self.throws,
            bill: self.bill.expect(made),
            audit: self.audit.expect(made),
            limit,
            air: self.air,
            notes: self.notes,
            members: self.members,
            sheets: self.canopies.sheets,
            cut: self.cut,
        }
    }
}
