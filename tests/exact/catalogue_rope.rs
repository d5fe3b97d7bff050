//! A rope as its catalogue states it, by mass per length and axial stiffness: it weighs and stretches by these.

use crate::support::{Run, assert_close};

const GRAVITY: f64 = 9.80665;

/// 10 m of an 8 mm rope that hangs with 30 kg at its end. Returns its mass, kg, and its stretch, m.
fn hung(rope: &str) -> (f64, f64) {
    let scenario = format!(
        "rope = {{ diameter = \"8 mm\", {rope} }}\nsolve.static.tolerance = 1e-10\nsolve.segment_length = 0.25\n"
    );
    let run = Run::graph(&scenario, "id,x,y,z,mass,fixed\ntop,0,0,0,0,1\nend,0,0,-10,30,0\n", "a,b\ntop,end\n");
    let lowest = run.fields.positions(run.fields.times.len() - 1)[1].z;
    (run.model.bill.ropes[0].mass, -10.0 - lowest)
}

#[test]
fn a_rope_by_linear_density_and_axial_stiffness_weighs_and_stretches_as_stated() {
    // 4.4 kg in 100 m, 95 kN
    let (mass, stretch) = hung("linear_density = \"44 g/m\", axial_stiffness = \"95 kN\"");
    assert_close("mass, kg", mass, 0.44, 1e-14);
    // half of its own weight and the whole load
    let exact = (30.0 + 0.22) * GRAVITY * 10.0 / 95e3;
    println!("stretch {stretch:.9} m, exactly {exact:.9} m");
    assert_close("stretch, m", stretch, exact, 1e-7);
}

#[test]
fn a_rope_per_length_is_the_rope_over_its_nominal_section() {
    let section = 0.25 * std::f64::consts::PI * 0.008 * 0.008;
    let (density, modulus) = (0.044 / section, 95e3 / section);
    let one = hung("linear_density = 0.044, axial_stiffness = 95e3");
    for other in [
        format!("density = {density:?}, elastic_modulus = {modulus:?}"),
        format!("linear_density = \"44 kg/km\", elastic_modulus = {modulus:?}"),
        format!("density = {density:?}, axial_stiffness = \"0.095 MN\""),
    ] {
        let other = hung(&other);
        assert_close("mass, kg", other.0, one.0, 1e-12);
        assert_close("stretch, m", other.1, one.1, 1e-8);
    }
}

#[test]
fn two_values_for_one_property_of_a_rope_are_refused() {
    let both = "density = 900, linear_density = 0.044, axial_stiffness = 95e3";
    let refused = std::panic::catch_unwind(|| hung(both)).expect_err("it is refused");
    let told = refused.downcast_ref::<String>().expect("a text");
    assert!(told.contains("expected only one of `density` and `linear_density`"), "{told}");
}
