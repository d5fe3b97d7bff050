//! The scenario as a whole.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::body::{Body, BodyDefaults, Solid};
use crate::canopy::Canopy;
use crate::cover::Cover;
use crate::drive::Drive;
use crate::environment::Environment;
use crate::hold::Hold;
use crate::interval::Positive;
use crate::launch::Launch;
use crate::load::Load;
use crate::measure::Measure;
use crate::quantity::Length;
use crate::record::Record;
use crate::rope::Rope;
use crate::solve::Solve;
use crate::stow::Stowage;
use crate::tie::{BreakTie, Stitching};
use crate::tractor::{TractionRope, TractorOverride};
use crate::web::Web;

/// What is thrown, how, into what, and what is recorded. Values with a dimension are strings with a unit ("2.5 m");
/// bare numbers are SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Title of the results.
    #[serde(default)]
    pub title: String,
    /// The web.
    pub web: Web,
    /// The default rope.
    pub rope: Rope,
    /// Other ropes, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub ropes: BTreeMap<String, Rope>,
    /// Which of `ropes` a link class has, such as `traction = "NAME"`. Left out: the default rope.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub assign: BTreeMap<String, String>,
    /// The canopies of a space web. Left out: `[canopy.links]` with its defaults.
    pub canopy: Option<Canopy>,
    /// The payload on each canopy of a space web that lies inside the outline, the centre's apart. Left out: none.
    pub payload: Option<Body>,
    /// The sensor on the centre canopy of a space web. Left out: none.
    pub sensor: Option<Body>,
    /// The ropes between web and tractors. Left out: tractors are tied straight to the corners.
    pub traction_rope: Option<TractionRope>,
    /// The tractors, one a corner. Left out: none.
    pub tractor: Option<Body>,
    /// What is different about one tractor.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tractors: Vec<TractorOverride>,
    /// How the web is packed. Left out: it starts as drawn.
    pub stow: Option<Stowage>,
    /// How the tractors are thrown. Left out: nothing is launched.
    pub launch: Option<Launch>,
    /// What holds the web until it opens.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covers: Vec<Cover>,
    /// Threads that hold nodes where they are stowed, or to each other, until they break.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub break_ties: Vec<BreakTie>,
    /// Rows of threads that hold folds together until they rip.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stitches: Vec<Stitching>,
    /// Nodes that stay put.
    pub hold: Option<Hold>,
    /// Forces on the web, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub load: BTreeMap<String, Load>,
    /// What is moved along given paths, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drive: BTreeMap<String, Drive>,
    /// Feature points by name, as node ids: `B = "n91"`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub points: BTreeMap<String, String>,
    /// What surrounds the web.
    #[serde(default)]
    pub environment: Environment,
    /// How long, how fine, how exact.
    pub solve: Solve,
    /// What is kept.
    #[serde(default)]
    pub record: Record,
    /// What the web is measured against.
    #[serde(default)]
    pub measure: Measure,
}

impl Scenario {
    /// The payload on each inner canopy.
    pub fn payload_solid(&self) -> Option<Solid> {
        self.payload.as_ref().map(|body| body.solid(&BodyDefaults::PAYLOAD))
    }

    /// The sensor on the centre canopy.
    pub fn sensor_solid(&self) -> Option<Solid> {
        self.sensor.as_ref().map(|body| body.solid(&BodyDefaults::PAYLOAD))
    }

    /// The tractor at a corner, from 1: as `[tractor]` has it, changed by its entry in `[[tractors]]`.
    pub fn tractor_solid(&self, corner: u32) -> Option<Solid> {
        let own = self.tractor_override(corner).and_then(|tractor| tractor.body(self.tractor.as_ref()));
        own.as_ref().or(self.tractor.as_ref()).map(|body| body.solid(&BodyDefaults::TRACTOR))
    }

    /// How the tractor at a corner, from 1, is launched; none where nothing says so.
    pub fn tractor_launch(&self, corner: u32) -> Option<Launch> {
        match self.tractor_override(corner) {
            Some(tractor)
                if self.launch.is_some() || tractor.axial_speed.is_some() || tractor.radial_speed.is_some() =>
            {
                Some(self.launch.clone().unwrap_or_default().with(tractor))
            }
            _ => self.launch.clone(),
        }
    }

    /// What is different about the tractor at a corner, from 1.
    pub fn tractor_override(&self, corner: u32) -> Option<&TractorOverride> {
        self.tractors.iter().find(|tractor| tractor.corner.get() == corner)
    }

    /// Diameter of the thickest rope that is the default one or has links assigned to it, traction apart.
    fn thickest_rope(&self) -> Length<Positive> {
        let of_the_web = self.assign.iter().filter(|(links, _)| *links != "traction");
        let ropes = of_the_web.filter_map(|(_, name)| self.ropes.get(name));
        let diameters = ropes.map(|rope| rope.diameter);
        diameters.fold(self.rope.diameter, |one, other| if other.si() > one.si() { other } else { one })
    }

    /// Writes out every default that depends on what else is given.
    pub(crate) fn complete(&mut self) {
        self.web.complete();
        self.rope.complete();
        self.ropes.values_mut().for_each(Rope::complete);
        if matches!(self.web, Web::Space(_)) {
            self.canopy.get_or_insert_default();
        }
        if let Some(canopy) = &mut self.canopy {
            canopy.complete();
        }
        self.environment.complete();
        let thickest = self.thickest_rope();
        if let Some(stowage) = &mut self.stow {
            stowage.pattern.complete(thickest);
        }
        self.stitches.iter_mut().for_each(Stitching::complete);
        for body in [&mut self.payload, &mut self.sensor].into_iter().flatten() {
            body.complete(&BodyDefaults::PAYLOAD);
        }
        if let Some(body) = &mut self.tractor {
            body.complete(&BodyDefaults::TRACTOR);
        }
    }
}

/// The scenario as TOML with every default written out. Read again, it is the same scenario bit for bit.
pub fn resolved_toml(scenario: &Scenario) -> String {
    let mut complete = scenario.clone();
    complete.complete();
    toml::to_string(&complete).expect("scenario: keys are strings and values are those of TOML")
}
