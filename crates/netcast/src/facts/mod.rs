//! The facts of a case that are known before a run: its materials, its state at the start, the cost of a run.
//!
//! `netcast check` shows these values as text, and `netcast check --json` prints them as JSON.

mod cost;
mod launch;
mod materials;
mod start;
mod surroundings;

use serde::Serialize;

use crate::case::Case;

pub use cost::{Cost, Count, Equilibrium};
pub use launch::{BodyFacts, Pushed, ThrowFacts, Tied};
pub use materials::{
    BillFacts, ClassLength, Counted, FromLibrary, LawFacts, LawKind, LibraryValue, LinkFacts, RopeFacts,
};
pub use start::{Closest, PackingFacts, StartFacts};
pub use surroundings::{
    ActingFacts, AirFacts, BodiesInAir, CanopiesInAir, Driven, Fall, GroundFacts, Loads, OrbitFacts, RopeInAir, Wind,
    WindFacts,
};

/// The facts of a case that are known before a run. All values are SI; a name carries its unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Facts {
    /// Title of the results.
    pub title: String,
    /// Choices and changes that the model made for the user.
    pub notes: Vec<String>,
    /// The bill of materials.
    pub bill: BillFacts,
    /// The law of each rope and its breaking limits, without repetition.
    pub laws: Vec<LawFacts>,
    /// The values from the library of materials; none where there are none.
    pub library: Option<FromLibrary>,
    /// The tractors that are rigid bodies.
    pub bodies: Vec<BodyFacts>,
    /// Spin of all that is launched about the launch axis, rad/s; none where it is 0.
    pub spin_rad_s: Option<f64>,
    /// The throw of each tractor.
    pub throws: Vec<ThrowFacts>,
    /// Whether all tractors have the speeds of `[launch]`, without tube, scatter or `[[tractors]]`; true without a
    /// launch.
    pub is_plain_launch: bool,
    /// The threads that hold the web until they break.
    pub ties: Vec<Tied>,
    /// The orbit of the launcher; none where the scenario has none.
    pub orbit: Option<OrbitFacts>,
    /// The ground; none where the scenario has none.
    pub ground: Option<GroundFacts>,
    /// The medium, the wind, and the parts with drag; none without air.
    pub air: Option<AirFacts>,
    /// The audit of the state at the start.
    pub start: StartFacts,
    /// Loads and drives.
    pub acting: ActingFacts,
    /// The search for an equilibrium; none where the scenario asks for none.
    pub equilibrium: Option<Equilibrium>,
    /// The cost of the run in time; none where the scenario asks for an equilibrium alone.
    pub cost: Option<Cost>,
}

impl Case {
    /// The facts of the case that are known before a run. It simulates nothing and takes little time.
    pub fn facts(&self) -> Facts {
        let model = self.model();
        let scenario = self.scenario();
        let launch = scenario.launch.as_ref();
        let is_plain = |launch: &netcast_scenario::Launch| {
            launch.tube.is_none() && launch.scatter.is_none() && scenario.tractors.is_empty()
        };
        Facts {
            title: scenario.title.clone(),
            notes: model.notes.clone(),
            bill: materials::bill(model),
            laws: materials::laws(model),
            library: materials::from_library(self.document()),
            bodies: launch::bodies(model),
            spin_rad_s: launch.map(|launch| launch.spin.si()).filter(|&spin| spin != 0.0),
            throws: launch::throws(model),
            is_plain_launch: launch.is_none_or(is_plain),
            ties: launch::ties(model),
            orbit: surroundings::orbit(model),
            ground: surroundings::ground(model),
            air: surroundings::air(model),
            start: start::start(model),
            acting: surroundings::acting(model),
            equilibrium: cost::equilibrium(model),
            cost: cost::cost(self),
        }
    }
}
