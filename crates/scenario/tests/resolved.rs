//! A resolved scenario states every default and reads back bit for bit.

mod common;

use common::{CONTRACT, parse};
use netcast_scenario::init::TEMPLATES;
use netcast_scenario::{Document, resolved_toml};
use proptest::prelude::*;

#[test]
fn every_default_is_written_out() {
    let without_canopy = CONTRACT.replace("[canopy.links]", "#");
    let resolved = resolved_toml(&parse(&without_canopy, &[]).unwrap().scenario);
    for line in [
        "side = \"2.5 m\"",
        "pretension = \"0 N\"",
        "damping_time = \"2e-6 s\"",
        "thickness = \"0.01 m\"",
        "energy_tolerance = 0.003",
        "web_energy_tolerance = 0.01",
        "on_energy_error = \"stop\"",
        "elevation = \"1.5707963267948966 rad\"",
        "density = \"2710 kg/m^3\"",
        "[canopy.links]",
    ] {
        assert!(resolved.lines().any(|found| found == line), "{line} in\n{resolved}");
    }
}

#[test]
fn every_template_reads_back_the_same() {
    for template in TEMPLATES {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("scenario.toml");
        for (name, text) in template.files {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        std::fs::write(&file, template.scenario).unwrap();
        let document = Document::read(&file, &[]).unwrap_or_else(|wrong| panic!("{}: {wrong}", template.kind));
        let resolved = resolved_toml(&document.scenario);
        std::fs::write(&file, &resolved).unwrap();
        let again = Document::read(&file, &[]).unwrap_or_else(|wrong| panic!("{}: {wrong}\n{resolved}", template.kind));
        assert_eq!(again.scenario, document.scenario, "{}", template.kind);
        assert_eq!(resolved_toml(&again.scenario), resolved);
        assert_eq!(document.files.graph.is_some(), template.kind == "graph");
    }
}

fn positive() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter_map("positive and no larger than anything may be", |value| {
        let value = value.abs();
        (value > 0.0 && value <= 1e5).then_some(value)
    })
}

proptest! {
    #[test]
    fn any_scenario_reads_back_bit_for_bit(
        side in positive(), diameter in positive(), modulus in positive(), duration in positive(),
        ratio in prop::option::of(positive()), depth in prop::option::of(positive()),
        azimuth in any::<f64>().prop_filter("an angle", |value| value.abs() <= 1e4),
        factor in 1e-300f64..1.0, corner in 1u32..7, mass in positive(), title in "\\PC{0,20}",
        name in "[a-zA-Z0-9 .µ-]{0,8}",
    ) {
        let title = toml::Value::from(title);
        let name = format!("{name:?}");
        let ratio = ratio.map_or(String::new(), |ratio| format!("damping_ratio = {ratio:?}"));
        let stow = depth.map_or(format!("[stow.scale]\nfactor = {factor:?}"), |depth| {
            format!("[stow.bag]\nradius = {mass:?}\ndepth = {depth:?}")
        });
        let text = format!("title = {title}\n[web.square]\nside = \"{side:?} m\"\nmesh = {side:?}\n\
            [rope]\ndiameter = \"{diameter:?} m\"\ndensity = 970\nelastic_modulus = {modulus:?}\n{ratio}\n\
            [ropes]\nx = {{diameter = 1, density = 2, elastic_modulus = 3}}\n[assign]\n{key} = \"x\"\n\
            [tractor.cylinder]\n[[tractors]]\ncorner = {corner}\n[tractors.particle]\nmass = {mass:?}\n\
            {stow}\n[launch]\nazimuth = \"{azimuth:?} rad\"\n[solve]\nduration = {duration:?}\n", key = name);
        let document = parse(&text, &[]).map_err(|wrong| TestCaseError::fail(format!("{wrong}\n{text}")))?;
        let resolved = resolved_toml(&document.scenario);
        let again = parse(&resolved, &[]).map_err(|wrong| TestCaseError::fail(format!("{wrong}\n{resolved}")))?;
        prop_assert_eq!(&again.scenario, &document.scenario);
        prop_assert_eq!(again.scenario.launch.unwrap().azimuth.si().to_bits(), azimuth.to_bits());
        prop_assert_eq!(again.scenario.rope.diameter.si().to_bits(), diameter.to_bits());
        prop_assert_eq!(again.scenario.rope.elastic_modulus.si().to_bits(), modulus.to_bits());
    }
}
