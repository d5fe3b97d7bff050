//! [`Scenario`]: the sections of a scenario file, and the defaults that depend on several sections.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::body::{Body, BodyDefaults, Solid};
use crate::canopy::Canopy;
use crate::cover::Cover;
use crate::cut::Cut;
use crate::drive::Drive;
use crate::environment::Environment;
use crate::hold::Hold;
use crate::interval::Positive;
use crate::launch::{Launch, complete_tractor};
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

/// A scenario: the net, how it is thrown, what surrounds it and what is recorded. A value with a dimension is a
/// string with its unit, such as "2.5 m". A bare number is in SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Title of the results. Default: empty.
    #[serde(default)]
    pub title: String,
    /// The web, which is the net without tractors and traction ropes.
    pub web: Web,
    /// The default rope. A link is made of it unless `assign` gives its link class another rope.
    pub rope: Rope,
    /// Other ropes, by name. Default: none.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub ropes: BTreeMap<String, Rope>,
    /// The rope of a link class, such as `traction = "NAME"`, where NAME is one of `ropes`. Default: the default rope
    /// for every link class.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub assign: BTreeMap<String, String>,
    /// The canopies at the knots of a space web. Default: `[canopy.links]` with its defaults.
    pub canopy: Option<Canopy>,
    /// The payload on each canopy of a space web, except the centre canopy and those on the outline. Default: none.
    pub payload: Option<Body>,
    /// The sensor on the centre canopy of a space web. Default: none.
    pub sensor: Option<Body>,
    /// The ropes from the corners of the web to the tractors. Default: none; each tractor is tied straight to its
    /// corner.
    pub traction_rope: Option<TractionRope>,
    /// The tractors, one at each corner. Default: none.
    pub tractor: Option<Body>,
    /// The tractors that differ from `tractor`, one entry for each. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tractors: Vec<TractorOverride>,
    /// How the web is packed before the launch. Default: it is not packed and starts as drawn.
    pub stow: Option<Stowage>,
    /// How the tractors are thrown. Default: nothing is launched.
    pub launch: Option<Launch>,
    /// Covers that hold the web as it is stowed until they open. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covers: Vec<Cover>,
    /// Threads that hold nodes where they are stowed, or hold two nodes together, until they break. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub break_ties: Vec<BreakTie>,
    /// Rows of threads that hold folds of rope together until they rip. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stitches: Vec<Stitching>,
    /// Cuts through ropes at given times. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cuts: Vec<Cut>,
    /// Nodes that are fixed in place. Default: none.
    pub hold: Option<Hold>,
    /// Forces on the web, by name. Default: none.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub load: BTreeMap<String, Load>,
    /// Nodes that are moved along given paths, by name. Default: none.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drive: BTreeMap<String, Drive>,
    /// Feature points by name, as node ids: `B = "n91"`. Results follow each of them. They are added to the points
    /// that the kind of web has. Default: none.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub points: BTreeMap<String, String>,
    /// What surrounds the web: gravity, air, wind, ground, orbit.
    #[serde(default)]
    pub environment: Environment,
    /// What is solved: a run in time or an equilibrium, its segment length, time step and tolerances.
    pub solve: Solve,
    /// How often results are recorded.
    #[serde(default)]
    pub record: Record,
    /// What the web is measured against.
    #[serde(default)]
    pub measure: Measure,
}

impl Scenario {
    /// The payload on each inner canopy, with its defaults filled in.
    pub fn payload_solid(&self) -> Option<Solid> {
        self.payload.as_ref().map(|body| body.solid(&BodyDefaults::PAYLOAD))
    }

    /// The sensor on the centre canopy, with its defaults filled in.
    pub fn sensor_solid(&self) -> Option<Solid> {
        self.sensor.as_ref().map(|body| body.solid(&BodyDefaults::PAYLOAD))
    }

    /// The tractor at `corner`, counted from 1: that of `[tractor]`, changed by its entry in `[[tractors]]`. `None`
    /// where the corner has no tractor.
    pub fn tractor_solid(&self, corner: u32) -> Option<Solid> {
        let own = self.tractor_override(corner).and_then(|tractor| tractor.body(self.tractor.as_ref()));
        own.as_ref().or(self.tractor.as_ref()).map(|body| body.solid(&BodyDefaults::TRACTOR))
    }

    /// The launch of the tractor at `corner`, counted from 1. `None` where it is not launched.
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

    /// The entry in `[[tractors]]` for the tractor at `corner`, counted from 1.
    pub fn tractor_override(&self, corner: u32) -> Option<&TractorOverride> {
        self.tractors.iter().find(|tractor| tractor.corner.get() == corner)
    }

    /// The largest diameter, m, of the default rope and of all ropes that are assigned to links other than traction
    /// ropes.
    fn thickest_rope(&self) -> Length<Positive> {
        let assigned = self.assign.iter().filter(|(class, _)| *class != "traction");
        let ropes = assigned.filter_map(|(_, name)| self.ropes.get(name));
        let diameters = ropes.map(|rope| rope.diameter);
        diameters.fold(self.rope.diameter, |thickest, other| if other.si() > thickest.si() { other } else { thickest })
    }

    /// Fills in every default that depends on other keys.
    pub(crate) fn complete(&mut self) {
        self.web.complete();
        self.rope.complete();
        for rope in self.ropes.values_mut() {
            rope.complete();
        }
        if matches!(self.web, Web::Space(_)) {
            self.canopy.get_or_insert_default();
        }
        if let Some(canopy) = &mut self.canopy {
            canopy.complete();
        }
        for tractor in &mut self.tractors {
            complete_tractor(tractor, self.launch.as_ref());
        }
        if let Some(launch) = &mut self.launch {
            launch.complete();
        }
        self.environment.complete();
        let thickest = self.thickest_rope();
        if let Some(stowage) = &mut self.stow {
            stowage.pattern.complete(thickest);
        }
        for row in &mut self.stitches {
            row.complete();
        }
        for body in [&mut self.payload, &mut self.sensor].into_iter().flatten() {
            body.complete(&BodyDefaults::PAYLOAD);
        }
        if let Some(body) = &mut self.tractor {
            body.complete(&BodyDefaults::TRACTOR);
        }
    }
}

/// The scenario as TOML with every default written out. Reading it gives the same scenario bit for bit.
pub fn resolved_toml(scenario: &Scenario) -> String {
    let mut complete = scenario.clone();
    complete.complete();
    toml::to_string(&complete).expect("scenario: keys are strings and values are those of TOML")
}
