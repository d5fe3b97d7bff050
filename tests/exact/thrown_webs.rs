//! Webs that are drawn from sizes alone, thrown from every stowing pattern: each opens and its energy balance closes.

use crate::support::Run;

const STOWED: [&str; 7] = [
    "stow={bag={radius=\"0.5 m\"}}",
    "stow={scale={factor=0.25}}",
    "stow={zigzag={container={cylinder={radius=0.4,height=0.6}}},imperfection={scatter=\"5 mm\",twist=\"10 deg\"}}",
    "stow={zigzag={along=\"lines\",container={box={width=0.6,breadth=0.6,height=0.6}}}}",
    "stow={star={container={cylinder={radius=0.4,height=0.6}}}}",
    "stow={roll={container={cylinder={radius=0.4,height=0.6}}}}",
    "stow={layers={container={cylinder={radius=0.4,height=0.6}}}}",
];

/// Throws the template of a kind of web from every packing and asserts that it opens and its energy balance closes.
#[track_caller]
fn assert_opens(kind: &str, of_the_web: &[&str]) {
    for stow in STOWED {
        let overrides = [&[stow], of_the_web].concat();
        let summary = Run::example(&format!("../crates/scenario/templates/{kind}.toml"), &overrides).summary;
        assert!(summary.finished && summary.energy.closure <= 0.003, "{kind}, {stow}: {}", summary.energy.closure);
        let (most, flat) = (summary.opening.area_max_m2.unwrap(), summary.opening.reference_area_m2.unwrap());
        println!("{kind}, {stow}: {:.3} of {flat} m^2, closure {:.2e}", most / flat, summary.energy.closure);
        // without traction ropes a folded web has its tractors inside; only folds along rings are symmetric
        let least = if stow.contains("bag") || stow.contains("scale") { 0.8 } else { 0.6 };
        assert!(most > least * flat && most < 1.05 * flat, "{kind}, {stow}: opens to {most} of {flat} m^2");
        for (class, tension) in &summary.tension.by_class {
            assert!(tension.max_n > 0.0, "{kind}, {stow}: no {class} rope is ever pulled");
        }
    }
}

#[test]
fn a_polygon_opens() {
    assert_opens("polygon", &[]);
}

#[test]
fn a_radial_web_opens_with_a_hub_and_without() {
    assert_opens("radial", &[]);
    assert_opens("radial", &["web.radial={diameter=5,radials=8,rings=5}"]);
}

#[test]
fn a_diamond_net_opens() {
    assert_opens("diamond", &[]);
}

#[test]
fn a_square_net_opens_with_its_drawstring() {
    assert_opens("square", &["web.square.gathering={every=2,excess=0.1}", "tractor.particle.mass=1"]);
}
