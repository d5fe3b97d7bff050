//! Tests that every element must pass: its elastic force is the exact gradient of its energy, its dissipative force
//! takes energy and does not resist rigid motion, and its bounds hold.

use glam::DVec3;
use nalgebra::DMatrix;

use super::element::Element;

fn total<const N: usize>(forces: [DVec3; N]) -> DVec3 {
    forces.iter().copied().sum()
}

fn moment<const N: usize>(x: [DVec3; N], forces: [DVec3; N]) -> DVec3 {
    x.iter().zip(forces).map(|(x, f)| x.cross(f)).sum()
}

fn work<const N: usize>(forces: [DVec3; N], w: [DVec3; N]) -> f64 {
    forces.iter().zip(w).map(|(f, w)| f.dot(w)).sum()
}

/// Elastic forces are minus the gradient of the energy, to `tolerance` of `scale`, N; steps of `h`, m, or a hundredth of
/// it: across a kink of the force a difference is off by its step times the jump of the slope.
pub fn force_is_the_gradient<const N: usize>(
    element: &impl Element<N>,
    x: [DVec3; N],
    h: f64,
    scale: f64,
    tolerance: f64,
) {
    let force = element.pull(x, [DVec3::ZERO; N]).elastic;
    for i in 0..N {
        for axis in 0..3 {
            let moved = |by: f64| {
                let mut y = x;
                y[i][axis] += by;
                element.elastic_energy(y)
            };
            let slopes =
                [h, 0.01 * h].map(|h| (8.0 * (moved(h) - moved(-h)) - (moved(2.0 * h) - moved(-2.0 * h))) / (12.0 * h));
            let miss = slopes.map(|slope| (force[i][axis] + slope).abs() / scale);
            let best = miss[0].min(miss[1]);
            assert!(best < tolerance, "node {i}, axis {axis}: {} N, gradients {slopes:?} N", force[i][axis]);
        }
    }
}

/// No net force, no net moment; the dissipative part takes energy and leaves rigid motion alone.
pub fn forces_are_internal<const N: usize>(element: &impl Element<N>, x: [DVec3; N], w: [DVec3; N]) {
    let forces = element.pull(x, w);
    for part in [forces.elastic, forces.dissipative] {
        let size: f64 = part.iter().map(|f| f.length()).sum();
        let reach = x.iter().map(|x| x.length()).fold(0.0, f64::max);
        assert!(total(part).length() <= 1e-12 * size);
        assert!(moment(x, part).length() <= 1e-12 * size * reach);
    }
    let most: f64 = forces.dissipative.iter().zip(w).map(|(f, w)| f.length() * w.length()).sum();
    assert!(
        work(forces.dissipative, w) <= 1e-12 * most,
        "the dissipative force does {} W",
        work(forces.dissipative, w)
    );

    let (shift, spin) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(0.7, 1.9, -1.3));
    let rigid = element.pull(x, x.map(|x| shift + spin.cross(x)));
    let speed = w.iter().map(|w| w.length()).sum::<f64>() / shift.length();
    let usual: f64 = forces.dissipative.iter().map(|f| f.length()).sum::<f64>() / speed.max(1e-300);
    let left: f64 = rigid.dissipative.iter().map(|f| f.length()).sum();
    let coefficient: f64 = element.damping().iter().sum();
    assert!(left <= 1e-11 * (usual + coefficient * shift.length()), "{left} N against rigid motion");
}

/// Forces turn with the element, and its energy does not change.
pub fn turns_with_its_nodes<const N: usize>(element: &impl Element<N>, x: [DVec3; N], w: [DVec3; N]) {
    let turn = glam::DQuat::from_xyzw(0.5, -0.1, 0.7, 0.5).normalize();
    let shift = DVec3::new(4.0, 5.0, -6.0);
    let here = element.pull(x, w);
    let there = element.pull(x.map(|x| turn * x + shift), w.map(|w| turn * w));
    let (e, f) = (element.elastic_energy(x), element.elastic_energy(x.map(|x| turn * x + shift)));
    let scale: f64 = element.stiffness().iter().sum::<f64>();
    assert!((e - f).abs() <= 1e-12 * scale, "{e} J turned into {f} J");
    for i in 0..N {
        let damped: f64 = element.damping().iter().sum();
        assert!((turn * here.elastic[i]).distance(there.elastic[i]) <= 1e-12 * scale);
        assert!((turn * here.dissipative[i]).distance(there.dissipative[i]) <= 1e-11 * damped * w[i].length().max(1.0));
    }
}

/// Largest x* H x / sum of 2 k_i |x_i|^2 at `x`, H by differences of the force over `h`, m.
pub fn used_bound<const N: usize>(element: &impl Element<N>, x: [DVec3; N], h: f64) -> f64 {
    let k = element.stiffness();
    largest(k, |i, axis| {
        let force = |by: f64| {
            let mut y = x;
            y[i][axis] += by;
            element.pull(y, [DVec3::ZERO; N]).elastic
        };
        let (ahead, behind) = (force(h), force(-h));
        std::array::from_fn(|j| (behind[j] - ahead[j]) / (2.0 * h))
    })
}

/// The same for the damping.
pub fn used_damping_bound<const N: usize>(element: &impl Element<N>, x: [DVec3; N]) -> f64 {
    largest(element.damping(), |i, axis| {
        let mut w = [DVec3::ZERO; N];
        w[i][axis] = 1.0;
        element.pull(x, w).dissipative.map(|f| -f)
    })
}

fn largest<const N: usize>(bound: [f64; N], column: impl Fn(usize, usize) -> [DVec3; N]) -> f64 {
    let columns: Vec<[DVec3; N]> = (0..3 * N).map(|c| column(c / 3, c % 3)).collect();
    let matrix = DMatrix::from_fn(3 * N, 3 * N, |r, c| {
        let symmetric = 0.5 * (columns[c][r / 3][r % 3] + columns[r][c / 3][c % 3]);
        symmetric / (2.0 * (bound[r / 3] * bound[c / 3]).sqrt())
    });
    matrix.symmetric_eigenvalues().max()
}
