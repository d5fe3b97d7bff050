//! The scenario `contract.toml` is read with its values, defaults, overrides and tractors that differ.

mod common;

use common::{CONTRACT, parse};
use netcast_scenario::{Canopy, Damping, Shape, Solid, Stow, Stowage, Web};

#[test]
fn every_written_value_is_read() {
    let scenario = parse(CONTRACT, &[]).unwrap().scenario;
    assert_eq!(scenario.title, "The space web, launched as in the paper");
    let Web::Space(web) = &scenario.web else { panic!("{:?}", scenario.web) };
    assert_eq!(web.side.si(), 2.5);
    assert_eq!(scenario.rope.diameter.si(), 0.01);
    assert_eq!(scenario.rope.density.si(), 1850.0);
    assert_eq!(scenario.rope.elastic_modulus.si(), 78e9);
    assert_eq!(scenario.rope.damping(), Damping::Time(2e-6));
    assert_eq!(scenario.rope.pretension.si(), 0.0);
    let Some(Canopy::Links(canopy)) = &scenario.canopy else { panic!() };
    assert_eq!((canopy.side.si(), canopy.thickness.si(), canopy.density.si()), (0.14, 0.01, 2000.0));
    assert_eq!((canopy.elastic_modulus.si(), canopy.damping_ratio.si()), (90e9, 0.05));
    let traction_rope = scenario.traction_rope.as_ref().unwrap();
    assert_eq!((traction_rope.length.si(), traction_rope.count.get()), (1.0355, 1));
    let Some(Solid { shape: Shape::Cylinder { diameter_m, height_m }, mass_kg }) = scenario.tractor_solid(1) else {
        panic!()
    };
    assert_eq!((diameter_m, height_m), (0.1, 0.2));
    assert!((mass_kg - 27.80).abs() < 0.005);
    assert!((scenario.payload_solid().unwrap().mass_kg - 0.506).abs() < 0.0005);
    let Some(Stowage { pattern: Stow::Bag(bag), .. }) = &scenario.stow else { panic!() };
    assert_eq!((bag.radius.si(), bag.depth, bag.tractor_radius), (0.25, None, None));
    let launch = scenario.tractor_launch(6).unwrap();
    assert_eq!((launch.axial_speed.si(), launch.radial_speed.si()), (50.0, 50.0));
    assert_eq!((launch.elevation.si(), launch.azimuth.si()), (std::f64::consts::FRAC_PI_2, 0.0));
    assert_eq!((scenario.environment.gravity.si(), scenario.environment.damping.si()), (9.80665, 8.3));
    assert_eq!((scenario.solve.duration.unwrap().si(), scenario.solve.segment_length.unwrap().si()), (0.6, 0.1));
    assert_eq!((scenario.solve.energy_tolerance.si(), scenario.solve.web_energy_tolerance.si()), (0.003, 0.01));
    assert_eq!(scenario.record.every.si(), 0.001);
}

const LEAST: &str = "
[web.traditional]
side = 2.5
[rope]
diameter = 0.01
density = 1850
elastic_modulus = 78e9
[solve]
duration = 0.6
";

#[test]
fn keys_that_are_left_out_have_their_defaults() {
    let scenario = parse(LEAST, &[]).unwrap().scenario;
    assert_eq!(scenario.rope.damping(), Damping::Ratio(0.05));
    assert!(scenario.traction_rope.is_none() && scenario.tractor_solid(1).is_none());
    assert!(scenario.launch.is_none() && scenario.stow.is_none());
    assert_eq!((scenario.environment.gravity.si(), scenario.environment.damping.si()), (9.80665, 0.0));
    assert_eq!(scenario.solve.segment_length, None);
    assert_eq!(scenario.record.every.si(), 0.001);
}

#[test]
fn an_override_changes_the_scenario() {
    let overrides = ["launch.axial_speed=60 m/s", "solve.duration = \"300 ms\"", "stow={scale={factor=0.2}}"];
    let scenario = parse(CONTRACT, &overrides).unwrap().scenario;
    assert_eq!(scenario.launch.unwrap().axial_speed.si(), 60.0);
    assert_eq!(scenario.solve.duration.unwrap().si(), 0.3);
    assert!(matches!(scenario.stow.unwrap().pattern, Stow::Scale(scale) if scale.factor.si() == 0.2));
}

#[test]
fn an_entry_in_tractors_changes_only_the_keys_that_it_has() {
    let text = format!(
        "{CONTRACT}
[[tractors]]
corner = 2
axial_speed = \"40 m/s\"
[tractors.cylinder]
height = \"0.4 m\"
[[tractors]]
corner = 3
[tractors.particle]
mass = \"5 kg\"
"
    );
    let document = parse(&text, &["tractors.1.particle.mass=6 kg"]).unwrap();
    let scenario = document.scenario;
    let first = scenario.tractor_solid(1).unwrap().mass_kg;
    let second = scenario.tractor_solid(2).unwrap().mass_kg;
    assert!((second / first - 2.0).abs() < 1e-12);
    assert_eq!(scenario.tractor_solid(3), Some(Solid { shape: Shape::Particle { diameter_m: None }, mass_kg: 6.0 }));
    let launch = scenario.tractor_launch(2).unwrap();
    assert_eq!((launch.axial_speed.si(), launch.radial_speed.si()), (40.0, 50.0));
    assert_eq!(scenario.tractor_launch(1).unwrap().axial_speed.si(), 50.0);
}
