//! What is known of a case before it is run: what it is made of, how it starts, what a run of it costs.
//!
//! The screen of `netcast check` is made from these values, and `netcast check --json` prints them.

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

/// What is known of a case before it is run. Everything is in SI; a name carries its unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Facts {
    /// Title of the results.
    pub title: String,
    /// What was chosen or changed for the user.
    pub notes: Vec<String>,
    /// What it is made of.
    pub bill: BillFacts,
    /// By which law each rope pulls, and at what it breaks; a line for each that differs.
    pub laws: Vec<LawFacts>,
    /// The values that it has from the library of materials; none where it has none.
    pub library: Option<FromLibrary>,
    /// The tractors that ropes can turn.
    pub bodies: Vec<BodyFacts>,
    /// How fast all that is launched turns about the launch axis, rad/s.
    pub spin_rad_s: Option<f64>,
    /// How each tractor is thrown.
    pub throws: Vec<ThrowFacts>,
    /// Whether `[launch]` throws all tractors alike, by one speed, without tube or chance; also where there is none.
    pub is_plain_launch: bool,
    /// What holds the web until it breaks.
    pub ties: Vec<Tied>,
    /// The orbit that it flies beside.
    pub orbit: Option<OrbitFacts>,
    /// What it starts from and lands on.
    pub ground: Option<GroundFacts>,
    /// The medium, the wind, and what drags.
    pub air: Option<AirFacts>,
    /// The state at the start, looked over.
    pub start: StartFacts,
    /// Loads and drives.
    pub acting: ActingFacts,
    /// The equilibrium that is looked for.
    pub equilibrium: Option<Equilibrium>,
    /// What a run in time costs; none where there is only an equilibrium to find.
    pub cost: Option<Cost>,
}

impl Case {
    /// What is known of the case before it is run. Takes no time to speak of; nothing is simulated.
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
