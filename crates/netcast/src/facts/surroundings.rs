//! What surrounds a case and acts on it: orbit, ground, air, wind, loads and drives.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use glam::DVec3;
use netcast_dynamics::air::Air;
use netcast_dynamics::forces::body_drag::Shape;
use netcast_model::{AirOutline, Model};
use serde::Serialize;

/// The orbit that a case flies beside.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitFacts {
    /// Mean motion, rad/s.
    pub mean_motion_rad_s: f64,
    /// Period, s.
    pub period_s: f64,
}

/// What a case starts from and lands on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundFacts {
    /// Height above the muzzle, m.
    pub height_m: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Speed after a bounce over speed before it.
    pub restitution: f64,
    /// Speed of an impact, m/s,
    pub impact_speed_m_s: f64,
    /// and how far that sinks in at most, m.
    pub impact_depth_m: f64,
    /// Nodes that it can touch.
    pub nodes: usize,
    /// Points on rigid bodies that it can touch.
    pub body_points: usize,
}

/// A speed that things come down at, m/s.
const IMPACT: f64 = 20.0;

/// The medium, the wind, and what drags.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AirFacts {
    /// Altitude in the standard atmosphere, m; none where the medium is given by its values.
    pub altitude_m: Option<f64>,
    /// Density at the muzzle, kg/m^3.
    pub density_kg_m3: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity_pa_s: f64,
    /// How it moves; none where it is still.
    pub wind: Option<WindFacts>,
    /// Fastest that anything is thrown, m/s.
    pub launch_speed_m_s: f64,
    /// Ropes that drag, by name.
    pub ropes: Vec<RopeInAir>,
    /// Canopies that drag.
    pub canopies: Option<CanopiesInAir>,
    /// Bodies, and what drags of them.
    pub bodies: BodiesInAir,
    /// Share that the web's ropes take of the area within its outline as drawn; none where it has no outline.
    pub drawn_solidity: Option<f64>,
    /// The solidity by which the drag of ropes is that of a screen; none where each drags as if alone.
    pub screen_solidity: Option<f64>,
    /// Upward force of the medium, N; 0 where it buoys up nothing.
    pub buoyancy_n: f64,
    /// How the web falls, flat and without tractors; none where there is no gravity.
    pub fall: Option<Fall>,
}

/// How the medium moves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WindFacts {
    /// Its mean; none where it is a measured series.
    pub mean: Option<Wind>,
    /// By how much gusts and turbulence change it at most, or how fast a measured series is at most, m/s.
    pub change_max_m_s: f64,
    /// Whether there are gusts or turbulence.
    pub is_gusty: bool,
}

/// The mean of the wind.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Wind {
    /// At the muzzle, m/s.
    pub at_muzzle_m_s: f64,
    /// 10 m above the ground, m/s.
    pub at_10_m_m_s: f64,
    /// The way it blows, anticlockwise from x, rad.
    pub towards_rad: f64,
}

/// Height above the ground at which weather services tell the wind, m.
const WEATHER_HEIGHT: f64 = 10.0;

/// Ropes of one name in the air; those of a screen apart from others.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RopeInAir {
    /// Their rope.
    pub rope: String,
    /// Whether they drag as those of a screen.
    pub is_screen: bool,
    /// Their diameter times their length, m^2.
    pub area_m2: f64,
    /// Reynolds number across them at the launch speed.
    pub reynolds: f64,
    /// Normal drag coefficient there.
    pub normal_coefficient: f64,
}

/// Canopies in the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CanopiesInAir {
    /// Their area, m^2.
    pub area_m2: f64,
    /// Drag coefficient square to the wind.
    pub coefficient: f64,
}

/// Bodies in the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BodiesInAir {
    /// How many drag.
    pub count: usize,
    /// The largest face of each, in all, m^2.
    pub area_max_m2: f64,
    /// How many a canopy hides.
    pub hidden: usize,
    /// How many have no size.
    pub sizeless: usize,
}

/// How a web falls through the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fall {
    /// It comes to this speed, m/s.
    TerminalSpeedMS(f64),
    /// It does not fall: it is no heavier than what it displaces.
    Floats,
    /// Ever faster: nothing of it drags.
    Unhindered,
}

/// Loads and drives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ActingFacts {
    /// Forces on nodes.
    pub loads: Option<Loads>,
    /// Nodes that are moved along given paths.
    pub drives: Option<Driven>,
}

/// Forces on nodes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Loads {
    /// How many nodes.
    pub nodes: usize,
    /// Their sum, world frame, N.
    pub force_n: [f64; 3],
    /// How many are brought up in time.
    pub ramped: usize,
}

/// Nodes that are moved along given paths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Driven {
    /// How many.
    pub nodes: usize,
    /// When the last of them has come to the end of its path, s.
    pub until_s: f64,
}

pub(super) fn orbit(model: &Model) -> Option<OrbitFacts> {
    let orbit = model.system.environment().orbit.as_ref()?;
    Some(OrbitFacts { mean_motion_rad_s: orbit.mean_motion, period_s: TAU / orbit.mean_motion })
}

pub(super) fn ground(model: &Model) -> Option<GroundFacts> {
    let ground = model.system.environment().ground.as_ref()?;
    let asked = model.scenario.environment.ground.as_ref()?;
    Some(GroundFacts {
        height_m: ground.height,
        friction: ground.friction,
        restitution: asked.restitution.si(),
        impact_speed_m_s: IMPACT,
        impact_depth_m: IMPACT * asked.contact_time.si() / PI,
        nodes: ground.nodes.len(),
        body_points: ground.hulls.len(),
    })
}

pub(super) fn air(model: &Model) -> Option<AirFacts> {
    let air = model.system.environment().air.as_ref()?;
    let outline = model.air.as_ref()?;
    let rope = |rope: netcast_model::RopesInAir| RopeInAir {
        rope: rope.rope,
        is_screen: rope.screened,
        area_m2: rope.area,
        reynolds: rope.reynolds,
        normal_coefficient: rope.normal,
    };
    let asked = model.scenario.environment.air.as_ref();
    let falls = model.system.environment().gravity != DVec3::ZERO;
    Some(AirFacts {
        altitude_m: asked.and_then(|air| air.altitude).map(|altitude| altitude.si()),
        density_kg_m3: air.medium.density(0.0),
        viscosity_pa_s: air.medium.viscosity(),
        wind: wind(model, air),
        launch_speed_m_s: outline.launch_speed,
        ropes: model.ropes_in_air().into_iter().map(rope).collect(),
        canopies: canopies(air),
        bodies: bodies(air, outline),
        drawn_solidity: outline.drawn_solidity,
        screen_solidity: outline.solidity,
        buoyancy_n: outline.buoyancy,
        fall: model.fall().filter(|_| falls).map(|fall| match fall {
            netcast_model::Fall::At(speed) => Fall::TerminalSpeedMS(speed),
            netcast_model::Fall::Floats => Fall::Floats,
            netcast_model::Fall::Unhindered => Fall::Unhindered,
        }),
    })
}

fn wind(model: &Model, air: &Air) -> Option<WindFacts> {
    let asked = model.scenario.environment.wind.as_ref()?;
    let fluctuation = air.wind.fluctuation.values.iter();
    let change_max_m_s = fluctuation.map(|velocity| velocity.length()).fold(0.0, f64::max);
    let up = WEATHER_HEIGHT - asked.muzzle_height.map_or(0.0, |height| height.si());
    let mean = asked.series.is_none().then(|| Wind {
        at_muzzle_m_s: air.wind.mean.at(0.0),
        at_10_m_m_s: air.wind.mean.at(up),
        towards_rad: asked.azimuth.map_or(0.0, |azimuth| azimuth.si()),
    });
    Some(WindFacts { mean, change_max_m_s, is_gusty: asked.gust.is_some() || asked.turbulence.is_some() })
}

fn canopies(air: &Air) -> Option<CanopiesInAir> {
    let coefficient = air.sheets.first()?.coefficient;
    Some(CanopiesInAir { area_m2: air.sheets.iter().map(|sheet| sheet.area).sum(), coefficient })
}

fn bodies(air: &Air, outline: &AirOutline) -> BodiesInAir {
    // the largest face of each, which it may turn to the wind or not
    let face = |shape: &Shape| match *shape {
        Shape::Sphere(diameter) => FRAC_PI_4 * diameter * diameter,
        Shape::Cylinder { diameter, height } => diameter * height.max(FRAC_PI_4 * diameter),
        Shape::Box(sides) => sides.element_product() / sides.min_element(),
    };
    BodiesInAir {
        count: air.bodies.len(),
        area_max_m2: air.bodies.iter().map(|body| face(&body.shape)).sum(),
        hidden: outline.hidden,
        sizeless: outline.sizeless,
    }
}

pub(super) fn acting(model: &Model) -> ActingFacts {
    let (loads, drives) = (model.system.loads(), model.system.drives());
    let sum = |axis: usize| loads.iter().map(|load| load.force[axis]).sum();
    let ends = drives.iter().filter_map(|drive| drive.path.last()).map(|&(time, _)| time);
    ActingFacts {
        loads: (!loads.is_empty()).then(|| Loads {
            nodes: loads.len(),
            force_n: [0, 1, 2].map(sum),
            ramped: loads.iter().filter(|load| !load.is_steady()).count(),
        }),
        drives: ends.reduce(f64::max).map(|until_s| Driven { nodes: drives.len(), until_s }),
    }
}
