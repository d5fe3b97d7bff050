//! Drag and wind against closed forms and published formulas, from scenarios.
//!
//! Fall: a body under the drag 1/2 rho C A v^2 falls with v = v_t tanh(g t / v_t), v_t^2 = 2 m g / (rho C A). The founding
//! paper's rope, 10 mm and 1850 kg/m^3, level and with C_n 1.1, has v_t = 14.5 m/s.
//!
//! Towed cable: in a stream U, under drag and its weight w per length, a cable hangs straight at the critical angle a to the
//! stream, where the normal forces balance: 1/2 rho C_n d U^2 sin^2 a = w cos a (Glauert, ARC R&M 1592, 1934; Pode, DTMB 687,
//! 1951). With a weight at its end its shape solves
//!
//! ```text
//! T' = -f.t,    T p' = -f.n,    t = (cos p, sin p) from the end up, f = weight and drag per length
//! ```
//!
//! Net panel of solidity S, normal to the stream: its drag coefficient is 0.04 + (-0.04 + 0.33 S + 6.54 S^2 - 4.88 S^3) by
//! Loland (Current forces on and flow through fish farms, 1991, from the tests of Aarsnes, Rudi & Loland 1990), and
//! C S (2 - S) / (2 (1 - S)^2) by Kristiansen & Faltinsen (J. Fluids Struct. 34, 2012), with C of a cylinder at the Reynolds
//! number of the flow between the twines.

use std::f64::consts::PI;

use crate::support::{Run, assert_close};
use glam::DVec3;
use netcast::Document;
use netcast::scenario::Source;

const GRAVITY: f64 = 9.80665;
/// Density, kg/m^3, and viscosity, Pa s.
const AIR: (f64, f64) = (1.225, 1.79e-5);

fn run(text: &str) -> Run {
    let source = Source { name: "air.toml".into(), text: text.into() };
    Run::of(&Document::parse(source, std::path::Path::new(""), &[]).unwrap_or_else(|wrong| panic!("{wrong}")))
}

/// Asserts that at every record all nodes fall as a body under quadratic drag: v = v_t tanh(a t / v_t), with the terminal
/// speed v_t, m/s, and the `acceleration` a at the start, m/s^2.
#[track_caller]
fn assert_falls(run: &Run, terminal: f64, acceleration: f64) {
    for (frame, &time) in run.fields.times.iter().enumerate() {
        let expected = terminal * libm::tanh(acceleration * time / terminal);
        for v in run.fields.velocities(frame) {
            assert!((v.z + expected).abs() < 5e-3 * terminal, "{} instead of {expected} m/s at {time} s", -v.z);
        }
    }
    let reached = -run.fields.velocities(run.fields.times.len() - 1)[0].z;
    assert!(reached > 0.98 * terminal, "{reached} of {terminal} m/s");
}

/// The medium of all tests; ropes have this normal coefficient.
fn air(coefficient: f64) -> String {
    format!(
        "[environment.air]\ndensity = {}\nviscosity = {}\nbuoyancy = false\nnormal_coefficient = {coefficient}\n",
        AIR.0, AIR.1
    )
}

#[test]
fn a_level_rope_falls_at_the_terminal_speed_of_the_paper() {
    let scenario = format!(
        "rope = {{ diameter = 0.01, density = 1850, elastic_modulus = \"10 MPa\" }}\n\
         solve = {{ duration = 5, segment_length = 0.5, energy_tolerance = 1e-3 }}\nrecord.every = 0.5\n{}",
        air(1.1)
    );
    let run = Run::graph(&scenario, "id,x,y,z\na,0,0,0\nb,4,3,0\n", "a,b\na,b\n");
    let terminal = (1850.0 * PI / 4.0 * 0.01 * GRAVITY / (0.5 * AIR.0 * 1.1)).sqrt();
    assert!((terminal - 14.5).abs() < 0.05);
    assert_falls(&run, terminal, GRAVITY);
    // the energy lost to the air is the work of the drag
    let energy = &run.summary.energy;
    let lost = run.model.bill.total_mass() * GRAVITY * terminal * terminal / GRAVITY
        * libm::log(libm::cosh(GRAVITY * 5.0 / terminal));
    let kinetic = 0.5 * run.model.bill.total_mass() * (terminal * libm::tanh(GRAVITY * 5.0 / terminal)).powi(2);
    assert_close("energy lost to the air, J", energy.channels["air"], lost - kinetic, 2e-3);
}

#[test]
fn a_level_rope_sinks_in_water_with_buoyancy_and_added_mass() {
    let (rope, water, coefficient) = (1850.0, 1000.0, 1.1);
    let run = Run::graph(
        &format!(
            "rope = {{ diameter = 0.01, density = {rope}, elastic_modulus = \"10 MPa\" }}\n\
             solve = {{ duration = 0.5, segment_length = 0.5 }}\nrecord.every = 0.025\n[environment.air]\n\
             density = {water}\nviscosity = 0.001\nnormal_coefficient = {coefficient}\nadded_mass = 1\n"
        ),
        "id,x,y,z\na,0,0,0\nb,4,3,0\n",
        "a,b\na,b\n",
    );
    let terminal = ((rope - water) * PI / 4.0 * 0.01 * GRAVITY / (0.5 * water * coefficient)).sqrt();
    assert_falls(&run, terminal, (rope - water) / (rope + water) * GRAVITY);
}

#[test]
fn every_kind_of_canopy_falls_at_the_terminal_speed_of_its_cloth() {
    let (thickness, density, porosity) = (0.5e-3, 1200.0, 0.1);
    let terminal = (density * thickness * GRAVITY / (0.5 * AIR.0 * 1.17 * (1.0 - porosity))).sqrt();
    // ropes get the coefficient with which they fall just as fast
    let coefficient = 1440.0 * PI / 4.0 * 3e-3 * GRAVITY / (0.5 * AIR.0 * terminal * terminal);
    for (kind, more) in
        [("links", "elastic_modulus = \"10 MPa\""), ("rigid", ""), ("membrane", "elastic_modulus = \"10 MPa\"")]
    {
        let scenario = format!(
            "web.space.side = \"1 m\"\nrope = {{ diameter = 0.003, density = 1440, elastic_modulus = \"10 MPa\" }}\n\
             solve = {{ duration = 2, segment_length = 0.2 }}\nrecord.every = 0.5\n\
             [canopy.{kind}]\nthickness = {thickness}\ndensity = {density}\nporosity = {porosity}\n{more}\n{}",
            air(coefficient)
        );
        assert_falls(&run(&scenario), terminal, GRAVITY);
    }
}

/// Asserts that a tractor of 0.5 kg falls with this drag coefficient, a function of its speed, and this diameter, m.
#[track_caller]
fn assert_tractor_falls(tractor: &str, coefficient: impl Fn(f64) -> f64, diameter: f64) {
    let scenario = format!(
        "web.graph = {{ nodes = \"nodes.csv\", ropes = \"ropes.csv\", corners = [\"a\"] }}\n\
         rope = {{ diameter = 0.001, density = 1000, elastic_modulus = \"10 MPa\", damping_ratio = 1 }}\n\
         tractor.{tractor}\nsolve = {{ duration = 9, segment_length = 0.25 }}\nrecord.every = 1\n{}\
         tangential_coefficient = 0\n",
        air(0.0)
    );
    let run = Run::graph(&scenario, "id,x,y,z\na,0,0,0\nb,0,0,-0.25\n", "a,b\na,b\n");
    // the rope below has weight but no drag
    let weight = run.model.bill.total_mass() * GRAVITY;
    let pressure = 0.5 * AIR.0 * PI / 4.0 * diameter * diameter;
    let terminal = (0..50).fold(10.0, |speed, _| (weight / (pressure * coefficient(speed))).sqrt());
    assert_falls(&run, terminal, GRAVITY);
}

#[test]
fn a_cylinder_and_a_sphere_have_published_drag_coefficients() {
    // White 2011, table 7.3: flow along the axis, height over diameter 2
    assert_tractor_falls("cylinder = { mass = 0.5, diameter = 0.1, height = 0.2 }", |_| 0.85, 0.1);
    // White 1991, by the Reynolds number; it hardly changes the coefficient during the fall
    let sphere = |speed: f64| {
        let reynolds = AIR.0 * speed * 0.2 / AIR.1;
        24.0 / reynolds + 6.0 / (1.0 + reynolds.sqrt()) + 0.4
    };
    assert_tractor_falls("sphere = { mass = 0.5, diameter = 0.2 }", sphere, 0.2);
    assert_tractor_falls("particle = { mass = 0.5, diameter = 0.2 }", sphere, 0.2);
}

/// Nodes, from the free end up, of a cable at rest. It is held at its upper end in a stream along x, m/s, and has a mass,
/// kg, at its free end; `solve` runs it to its end or asks for its equilibrium.
fn towed(stream: f64, end_mass: f64, modulus: &str, solve: &str) -> Vec<DVec3> {
    let scenario = format!(
        "rope = {{ diameter = {DIAMETER}, density = {DENSITY}, elastic_modulus = \"{modulus}\" }}\n\
         solve = {{ segment_length = 0.1, {solve} }}\nrecord.every = 1\n\
         environment.wind.speed = {stream}\n{}tangential_coefficient = {TANGENTIAL}\n",
        air(NORMAL)
    );
    let nodes = format!("id,x,y,z,fixed,mass\ntop,0,0,0,1,0\nend,0,0,-{LENGTH},0,{end_mass}\n");
    let run = Run::graph(&scenario, &nodes, "a,b\nend,top\n");
    let x = run.fields.positions(run.fields.times.len() - 1);
    // the run lists both knots, then the inner nodes from the end to the top
    let mut along = vec![x[1]];
    along.extend(&x[2..]);
    along.push(x[0]);
    along
}

const LENGTH: f64 = 5.0;
const DIAMETER: f64 = 0.004;
const DENSITY: f64 = 1140.0;
const NORMAL: f64 = 1.2;
const TANGENTIAL: f64 = 0.03;

/// Weight of a metre, N.
fn weight() -> f64 {
    DENSITY * PI / 4.0 * DIAMETER * DIAMETER * GRAVITY
}

/// In faster streams the free end flutters and never comes to rest.
#[test]
fn a_towed_cable_hangs_straight_at_the_critical_angle() {
    for stream in [3.0, 4.0, 5.0] {
        let ratio = weight() / (AIR.0 * NORMAL * DIAMETER * stream * stream);
        let cos = -ratio + (ratio * ratio + 1.0).sqrt();
        for pair in towed(stream, 0.0, "10 MPa", "duration = 20").windows(2) {
            let along = (pair[0] - pair[1]).normalize();
            let off = libm::acos(along.x.clamp(-1.0, 1.0)) - libm::acos(cos);
            assert!(off.abs() < 2e-3, "{stream} m/s: off by {off} rad at {}", pair[0]);
        }
    }
}

#[test]
fn a_towed_cable_with_a_weight_at_its_end_solves_its_equilibrium_equation() {
    let (stream, end_mass) = (10.0, 0.05);
    // the derivatives of x, z, tension and angle of the tangent from the free end up, integrated by Runge and Kutta
    let slope = |[_, _, tension, angle]: [f64; 4]| {
        let (sin, cos) = libm::sincos(angle);
        let (along, across) = (stream * cos, -stream * sin);
        let pressure = 0.5 * AIR.0 * DIAMETER;
        let f_t = pressure * TANGENTIAL * along * along.abs() - weight() * sin;
        let f_n = pressure * NORMAL * across * across.abs() - weight() * cos;
        [cos, sin, -f_t, -f_n / tension]
    };
    const STEPS: usize = 5000;
    let ds = LENGTH / STEPS as f64;
    let mut at = [0.0, 0.0, end_mass * GRAVITY, PI / 2.0];
    let mut shape = vec![at];
    for _ in 0..STEPS {
        let moved = |by: [f64; 4], share: f64| std::array::from_fn(|k| at[k] + share * ds * by[k]);
        let a = slope(at);
        let b = slope(moved(a, 0.5));
        let c = slope(moved(b, 0.5));
        let d = slope(moved(c, 1.0));
        at = std::array::from_fn(|k| at[k] + ds / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
        shape.push(at);
    }
    let found = towed(stream, end_mass, "100 GPa", "static = { tolerance = 1e-7 }");
    let top = shape[STEPS];
    let mut worst = 0.0f64;
    for (node, x) in found.iter().enumerate() {
        let expected = shape[node * STEPS / (found.len() - 1)];
        let expected = DVec3::new(expected[0] - top[0], 0.0, expected[1] - top[1]);
        worst = worst.max(x.distance(expected));
    }
    println!("end at {} of {}, off by at most {worst} m", found[0], DVec3::new(-top[0], 0.0, -top[1]));
    assert!(worst < 1e-4 * LENGTH, "{worst}");
    // the shape is not a straight line
    let middle = found[found.len() / 2];
    assert!(middle.distance(0.5 * found[0]) > 0.02 * LENGTH);
}

/// Drag coefficient of a net panel, 1 m by 1 m, solidity 0.2, that a stream of 5 m/s normal to it carries away.
fn panel_coefficient() -> f64 {
    let (stream, time, twine, density) = (5.0, 0.02, 0.2 / 42.0, 1140.0);
    let run = run(&format!(
        "web.square = {{ side = 1, mesh = 0.05, segments_per_mesh = 1 }}\n\
         rope = {{ diameter = {twine}, density = {density}, elastic_modulus = \"10 MPa\" }}\n\
         launch.elevation = 0\nsolve.duration = {time}\nrecord.every = {time}\n\
         [environment]\ngravity = 0\nwind.speed = {stream}\n[environment.air]\nsolidity = \"web\"\n"
    ));
    assert_close("solidity", run.model.air.as_ref().unwrap().solidity.unwrap(), 0.2, 1e-9);
    let mass = run.model.bill.total_mass();
    let speed = (2.0 * run.last("energy_kinetic_j") / mass).sqrt();
    // m v' = k (U - v)^2
    let k = mass * speed / (time * stream * (stream - speed));
    k / (0.5 * 1.225)
}

#[test]
fn a_net_panel_has_a_published_drag_coefficient() {
    let s: f64 = 0.2;
    let loland = 0.04 + (-0.04 + 0.33 * s + 6.54 * s * s - 4.88 * s * s * s);
    // their coefficient of a cylinder, a polynomial in the logarithm of the Reynolds number between the twines
    let reynolds = 1.225 * 5.0 * (0.2 / 42.0) / (1.7894e-5 * (1.0 - s));
    let powers = [-78.46675, 254.73873, -327.8864, 223.64577, -87.92234, 20.00769, -2.44894, 0.12479];
    let cylinder = powers.iter().rev().fold(0.0, |sum, c| sum * libm::log10(reynolds) + c);
    let kristiansen_faltinsen = cylinder * s * (2.0 - s) / (2.0 * (1.0 - s) * (1.0 - s));
    let aarsnes = 0.04 + (-0.04 + s - 1.24 * s * s + 13.7 * s * s * s);
    let found = panel_coefficient();
    println!("{found:.4}; {aarsnes:.4}, {loland:.4}, {kristiansen_faltinsen:.4}");
    // the panel has begun to move at the end of the run: the relative speed is less than that of the stream
    assert_close("Kristiansen & Faltinsen", found, kristiansen_faltinsen, 0.01);
    assert!(found > aarsnes && found < loland, "{found} between {aarsnes} and {loland}");
}
