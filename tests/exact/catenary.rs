//! A rope that hangs between two ends of equal height, against the elastic catenary (Irvine, Cable Structures, 1981).
//!
//! s is the unstretched length from one end, S the whole length, W the weight, H the horizontal and V = W/2 the vertical
//! reaction:
//!
//! ```text
//! x(s) = H s/EA + (H S/W) [asinh(V/H) - asinh((V - W s/S)/H)],                              x(S) = span gives H
//! z(s) = -(W s/EA) (V/W - s/(2S)) - (H S/W) [sqrt(1 + (V/H)^2) - sqrt(1 + ((V - W s/S)/H)^2)]
//! T(s) = sqrt(H^2 + (V - W s/S)^2)
//! ```
//!
//! A rope of N segments hangs in a polygon; its error falls with 1/N^2.

use crate::support::Run;

const SPAN: f64 = 2.0;
const LENGTH: f64 = 2.2;
const GRAVITY: f64 = 9.80665;
const MODULUS: f64 = 1e6;
const DENSITY: f64 = 1000.0;
const SECTION: f64 = 0.25 * std::f64::consts::PI * 0.01 * 0.01;

/// The elastic catenary of the constants above.
struct Catenary {
    weight: f64,
    horizontal: f64,
}

impl Catenary {
    fn new() -> Catenary {
        let weight = DENSITY * SECTION * LENGTH * GRAVITY;
        // the span grows with the horizontal reaction: bisection
        let (mut low, mut high) = (1e-3 * weight, 1e3 * weight);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let is_too_wide = Catenary { weight, horizontal: middle }.x(LENGTH) > SPAN;
            if is_too_wide { high = middle } else { low = middle }
        }
        Catenary { weight, horizontal: low }
    }

    /// Vertical part of the tension over the horizontal one.
    fn slope(&self, s: f64) -> f64 {
        self.weight * (0.5 - s / LENGTH) / self.horizontal
    }

    fn x(&self, s: f64) -> f64 {
        let parameter = self.horizontal * LENGTH / self.weight;
        self.horizontal * s / (MODULUS * SECTION)
            + parameter * (libm::asinh(self.slope(0.0)) - libm::asinh(self.slope(s)))
    }

    fn sag(&self, s: f64) -> f64 {
        let secant = |s: f64| libm::hypot(1.0, self.slope(s));
        let stretch = self.weight * s / (MODULUS * SECTION) * (0.5 - 0.5 * s / LENGTH);
        stretch + self.horizontal * LENGTH / self.weight * (secant(0.0) - secant(s))
    }

    fn tension(&self, s: f64) -> f64 {
        self.horizontal * libm::hypot(1.0, self.slope(s))
    }
}

/// Errors of the sag in the middle, m, and of the tension of the end segment, N, of a rope at rest.
fn errors(segments: usize) -> (f64, f64) {
    let scenario = format!(
        "rope = {{ diameter = \"10 mm\", density = {DENSITY}, elastic_modulus = {MODULUS} }}\n\
         environment = {{ gravity = {GRAVITY}, damping = \"8 1/s\" }}\n\
         solve = {{ duration = \"10 s\", segment_length = \"1 m\" }}\nrecord = {{ every = \"0.5 s\" }}\n"
    );
    let nodes = format!("id,x,y,z,fixed\nleft,0,0,0,1\nright,{SPAN},0,0,1\n");
    let run = Run::graph(&scenario, &nodes, &format!("a,b,rest_length,segments\nleft,right,{LENGTH},{segments}\n"));
    let last = run.fields.times.len() - 1;
    let lowest = run.fields.positions(last).iter().map(|x| x.z).fold(0.0, f64::min);
    // the end segment has the tension of the catenary at its middle
    let (tension, ends) = (run.fields.tensions(last)[0], 0.5 * LENGTH / segments as f64);

    let exact = Catenary::new();
    println!(
        "{segments:3} segments: sag {:.6} m, exact {:.6} m; tension of the end segment {tension:.6} N, exact {:.6} N",
        -lowest,
        exact.sag(0.5 * LENGTH),
        exact.tension(ends)
    );
    (-lowest - exact.sag(0.5 * LENGTH), tension - exact.tension(ends))
}

#[test]
fn sag_and_end_tension_of_a_hanging_rope_converge_at_second_order() {
    let errors: Vec<(f64, f64)> = [8, 16, 32].into_iter().map(errors).collect();
    for pair in errors.windows(2) {
        let [(sag, tension), (finer_sag, finer_tension)] = [pair[0], pair[1]];
        let ratios = (sag / finer_sag, tension / finer_tension);
        println!("errors fall by {:.3} (sag) and {:.3} (tension)", ratios.0, ratios.1);
        assert!((3.8..4.2).contains(&ratios.0) && (3.8..4.2).contains(&ratios.1), "{ratios:?}");
    }
    let exact = Catenary::new();
    let (sag, tension) = errors[2];
    assert!(sag.abs() < 2e-3 * exact.sag(0.5 * LENGTH) && tension.abs() < 2e-3 * exact.tension(0.0));
}
