//! The draft that the stages turn into a model.

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

/// The results of the stages so far. A stage reads the results of the stages that it needs and adds its own.
pub struct Draft<'d> {
    /// The scenario as it was read.
    pub document: &'d Document,
    /// The scenario; the stages fill in values that it left out.
    pub scenario: Scenario,
    /// Messages to the user about values that were chosen or changed.
    pub notes: Vec<String>,
    /// The web as drawn and cut.
    pub cut: CutWeb,
    /// Rotation from the launch frame to the world frame.
    pub frame: DMat3,
    /// The rope of each link, by its place in [`super::assignment::ropes`], (links,).
    pub kinds: Vec<usize>,
    /// Link class and rope of each class number of the system, (classes,).
    pub groups: Vec<Group>,
    /// The segments, each with the rope, canopy or thread that it belongs to.
    pub members: Vec<Member>,
    /// Elements and rigid bodies of canopies that are plates or sheets.
    pub canopies: Canopies,
    /// Payloads, sensor and tractors with their nodes.
    pub bodies: Vec<PlacedBody>,
    /// Positions of all nodes as stowed, launch frame, m, (nodes,).
    pub stowed: Vec<DVec3>,
    /// Rotation of each canopy from the flat to the stowed web, (canopies,).
    pub turns: Vec<DMat3>,
    /// How each tractor is thrown, in the order of the corners, (tractors,); none for a tractor that is not thrown.
    pub throws: Vec<Option<Throw>>,
    /// Nodes of the tractors in order around the web, (tractors,).
    pub tractors: Vec<usize>,
    /// Whether no node is held or driven.
    pub falls: bool,
    /// The parts of the system.
    pub parts: SystemParts,
    /// The state at the start, world frame.
    pub state: State,
    /// Total mass, kg.
    pub mass: f64,
    /// The bill of materials.
    pub bill: Option<Bill>,
    /// The audit of the packed web.
    pub audit: Option<Audit>,
    /// Key figures of the air; none without air.
    pub air: Option<AirOutline>,
    /// The system with the stability limit of its step.
    pub system: Option<(System, StepLimit)>,
    made: Vec<Stage>,
    faults: Vec<Diagnostic>,
}

impl<'d> Draft<'d> {
    /// Draws and cuts the web. Every stage needs it.
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

    /// Runs the stages in order. Skips a stage if one that it needs has failed.
    ///
    /// # Errors
    /// The mistakes that all stages found.
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

    /// Whether a stage has succeeded.
    pub fn has(&self, stage: Stage) -> bool {
        self.made.contains(&stage)
    }

    /// The model, after all stages have succeeded.
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
