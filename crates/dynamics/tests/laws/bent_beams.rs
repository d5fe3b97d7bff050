//! Chains of bends against beam theory: deflections, their order of convergence, a large deflection.

use glam::DVec3;
use nalgebra::{DMatrix, DVector};
use netcast_dynamics::forces::bending::Bending;
use netcast_dynamics::forces::element::Element;

/// A beam of segments along x, as stiff against compression as against tension, loaded across in the plane x, y.
struct Beam {
    segment: f64,
    axial_stiffness: f64,
    bends: Vec<Bending>,
    /// Nodes; those that are `held` stay.
    position: Vec<DVec3>,
    held: Vec<bool>,
    load: Vec<DVec3>,
}

impl Beam {
    /// Held at both ends, or `built_in` at its first: then a node ahead of it is held, too, a very short segment away.
    fn new(length: f64, segments: usize, bending_stiffness: f64, axial_stiffness: f64, built_in: bool) -> Self {
        let segment = length / segments as f64;
        let short = 1e-6 * segment;
        let mut x: Vec<f64> = (0..=segments).map(|i| i as f64 * segment).collect();
        if built_in {
            x.insert(0, -short);
        }
        let bends = (1..x.len() - 1)
            .map(|i| {
                let lengths = [x[i] - x[i - 1], x[i + 1] - x[i]];
                Bending::new([i - 1, i, i + 1], lengths, bending_stiffness, 0.0).unwrap()
            })
            .collect();
        let mut held = vec![false; x.len()];
        held[0] = true;
        if built_in {
            held[1] = true;
        } else {
            held[segments] = true;
        }
        Self {
            segment,
            axial_stiffness,
            bends,
            load: vec![DVec3::ZERO; x.len()],
            position: x.into_iter().map(|x| DVec3::new(x, 0.0, 0.0)).collect(),
            held,
        }
    }

    fn forces(&self, x: &[DVec3], share: f64) -> Vec<DVec3> {
        let mut force: Vec<DVec3> = self.load.iter().map(|load| share * load).collect();
        for bend in &self.bends {
            let nodes = bend.nodes();
            let pull = bend.pull(nodes.map(|node| x[node]), [DVec3::ZERO; 3]);
            for (node, elastic) in nodes.into_iter().zip(pull.elastic) {
                force[node] += elastic;
            }
        }
        for i in (0..x.len() - 1).filter(|&i| !(self.held[i] && self.held[i + 1])) {
            let span = x[i + 1] - x[i];
            let strain = span.length() / self.segment - 1.0;
            let pull = self.axial_stiffness * strain * span.normalize();
            force[i] += pull;
            force[i + 1] -= pull;
        }
        force
    }

    /// Equilibrium under all of the load, reached in `steps` of it by Newton's method.
    fn settle(&self, steps: usize) -> Vec<DVec3> {
        let free: Vec<(usize, usize)> =
            (0..self.position.len()).filter(|&i| !self.held[i]).flat_map(|i| [(i, 0), (i, 1)]).collect();
        let mut x = self.position.clone();
        let pick = |forces: &[DVec3]| DVector::from_iterator(free.len(), free.iter().map(|&(i, axis)| forces[i][axis]));
        let h = 1e-7 * self.segment;
        for step in 1..=steps {
            let share = step as f64 / steps as f64;
            for _ in 0..12 {
                let mut stiffness = DMatrix::zeros(free.len(), free.len());
                for (column, &(i, axis)) in free.iter().enumerate() {
                    let at = x[i][axis];
                    x[i][axis] = at + h;
                    let ahead = pick(&self.forces(&x, share));
                    x[i][axis] = at - h;
                    let behind = pick(&self.forces(&x, share));
                    x[i][axis] = at;
                    stiffness.set_column(column, &((behind - ahead) / (2.0 * h)));
                }
                let change = stiffness.lu().solve(&pick(&self.forces(&x, share))).expect("a stable beam");
                for (&(i, axis), by) in free.iter().zip(&change) {
                    x[i][axis] += by;
                }
                if change.amax() < 1e-10 * self.segment {
                    break;
                }
            }
        }
        x
    }
}

/// Errors of deflections with 8, 16 and 32 segments fall fourfold each.
fn assert_second_order(exact: f64, deflection: impl Fn(usize) -> f64) {
    let errors = [8, 16, 32].map(|segments| (deflection(segments) / exact - 1.0).abs());
    assert!(errors[2] < 2e-3);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.05, "order {order}, errors {errors:?}");
    }
}

#[test]
fn a_cantilever_bends_by_p_l3_over_3_ei() {
    let (length, stiffness, load) = (2.0, 50.0, 1e-3);
    assert_second_order(load * length * length * length / (3.0 * stiffness), |segments| {
        let mut beam = Beam::new(length, segments, stiffness, 1e6, true);
        beam.load[segments + 1].y = -load;
        -beam.settle(1)[segments + 1].y
    });
}

#[test]
fn a_beam_on_two_supports_bends_by_p_l3_over_48_ei() {
    let (length, stiffness, load) = (2.0, 50.0, 1e-2);
    assert_second_order(load * length * length * length / (48.0 * stiffness), |segments| {
        let mut beam = Beam::new(length, segments, stiffness, 1e6, false);
        beam.load[segments / 2].y = -load;
        -beam.settle(1)[segments / 2].y
    });
}

/// Tip of a cantilever of 2 m, 0.1 x 0.1 m, 207 GPa, under 3 EI / L^2: EXUDYN's test of its ANCF cable element.
#[test]
fn a_cantilever_bent_far_ends_where_exudyns_does() {
    let (length, modulus, side): (f64, f64, f64) = (2.0, 207e9, 0.1);
    let stiffness = modulus * side.powi(4) / 12.0;
    let tip = |segments: usize| {
        let mut beam = Beam::new(length, segments, stiffness, modulus * side * side, true);
        beam.load[segments + 1].y = -3.0 * stiffness / (length * length);
        beam.settle(6)[segments + 1] - beam.position[segments + 1]
    };
    let tips = [10, 20, 40].map(tip);
    let exact = DVec3::new(-0.508537, -1.207240, 0.0);
    let errors = tips.map(|tip| tip.distance(exact));
    let extrapolated = (4.0 * tips[2] - tips[1]) / 3.0;
    assert!(errors[2] < 1e-3 * length);
    assert!(extrapolated.distance(exact) < 2e-5 * length, "{extrapolated}");
}
