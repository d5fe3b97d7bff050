//! Facts on the surroundings of a case: orbit, ground, air, wind, loads and drives.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use glam::DVec3;
use netcast_dynamics::air::Air;
use netcast_dynamics::forces::body_drag::Shape;
use netcast_model::{AirOutline, Model};
use serde::Serialize;

/// The orbit of the launcher.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitFacts {
    /// Mean motion, rad/s.
    pub mean_motion_rad_s: f64,
    /// Period, s.
    pub period_s: f64,
}

/// The ground.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundFacts {
    /// Height above the muzzle, m.
    pub height_m: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Speed after a bounce over the speed before it.
    pub restitution: f64,
    /// Speed of a typical impact, m/s.
    pub impact_speed_m_s: f64,
    /// Largest depth of that impact in the ground's spring, m.
    pub impact_depth_m: f64,
    /// Number of nodes that the ground can touch.
    pub nodes: usize,
    /// Number of points of rigid bodies that the ground can touch.
    pub body_points: usize,
}

/// Speed of a typical impact, m/s.
const IMPACT_SPEED: f64 = 20.0;

/// The medium, the wind, and the parts with drag.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AirFacts {
    /// Altitude in the standard atmosphere, m; none where the scenario gives density and viscosity.
    pub altitude_m: Option<f64>,
    /// Density at the muzzle, kg/m^3.
    pub density_kg_m3: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity_pa_s: f64,
    /// The wind; none where the medium is still.
    pub wind: Option<WindFacts>,
    /// Largest speed at the launch, m/s.
    pub launch_speed_m_s: f64,
    /// Ropes with drag, by name.
    pub ropes: Vec<RopeInAir>,
    /// Canopies with drag; none where there are none.
    pub canopies: Option<CanopiesInAir>,
    /// Bodies with and without drag.
    pub bodies: BodiesInAir,
    /// Solidity of the web as drawn: projected area of its ropes over the area within its outline; none without
    /// outline.
    pub drawn_solidity: Option<f64>,
    /// Solidity of the screen whose drag the ropes have; none where each rope has the drag of an isolated one.
    pub screen_solidity: Option<f64>,
    /// Buoyancy, N; 0 where it is left out.
    pub buoyancy_n: f64,
    /// The fall of the flat web without tractors; none without gravity.
    pub fall: Option<Fall>,
}

/// The wind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WindFacts {
    /// The mean wind; none where a measured series gives the wind.
    pub mean: Option<Wind>,
    /// Largest change by gusts and turbulence, or largest speed of a measured series, m/s.
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
    /// Azimuth that it blows towards, rad.
    pub towards_rad: f64,
}

/// Height above the ground at which weather services measure the wind, m.
const WEATHER_HEIGHT: f64 = 10.0;

/// Ropes of one name in the air, all with or all without the drag of a screen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RopeInAir {
    /// Their name.
    pub rope: String,
    /// Whether they have the drag of a screen.
    pub is_screen: bool,
    /// Diameter times total length, m^2.
    pub area_m2: f64,
    /// Reynolds number of the flow across them at the launch speed.
    pub reynolds: f64,
    /// Normal drag coefficient at that Reynolds number.
    pub normal_coefficient: f64,
}

/// Canopies in the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CanopiesInAir {
    /// Their area, m^2.
    pub area_m2: f64,
    /// Drag coefficient of a canopy normal to the wind.
    pub coefficient: f64,
}

/// Bodies in the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BodiesInAir {
    /// Number of bodies with drag.
    pub count: usize,
    /// Sum of their largest projected areas, m^2.
    pub area_max_m2: f64,
    /// Number of bodies without drag because a canopy hides them.
    pub hidden: usize,
    /// Number of bodies without drag because they have no size.
    pub sizeless: usize,
}

/// The fall of a web through the air.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fall {
    /// It reaches this speed, m/s.
    TerminalSpeedMS(f64),
    /// It does not fall: its weight is at most its buoyancy.
    Floats,
    /// It accelerates without limit: no part has drag.
    Unhindered,
}

/// Loads and drives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ActingFacts {
    /// Forces on nodes; none where there are none.
    pub loads: Option<Loads>,
    /// Nodes that are moved along given paths; none where there are none.
    pub drives: Option<Driven>,
}

/// Forces on nodes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Loads {
    /// Number of nodes.
    pub nodes: usize,
    /// Sum of the forces, world frame, N.
    pub force_n: [f64; 3],
    /// Number of forces that change in time.
    pub ramped: usize,
}

/// Nodes that are moved along given paths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Driven {
    /// Number of nodes.
    pub nodes: usize,
    /// Time at which the last path ends, s.
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
        impact_speed_m_s: IMPACT_SPEED,
        impact_depth_m: IMPACT_SPEED * asked.contact_time.si() / PI,
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
    // the largest projected area of a body, whatever its orientation
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
