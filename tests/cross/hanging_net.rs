//! The hanging net, at rest after a run and by `[solve.static]`, against a second method: the minimum of the potential energy
//! of lumped masses and tension-only springs, found by Newton's method. The net is built here from its dimensions.

use crate::support::Run;
use glam::{DMat3, DVec3};
use nalgebra::{DMatrix, DVector};

const SIDE: f64 = 2.0;
const MESHES: usize = 8;
const MESH: f64 = SIDE / MESHES as f64;
const SECTION: f64 = 0.25 * std::f64::consts::PI * 0.004 * 0.004;
const AXIAL_STIFFNESS: f64 = 50e6 * SECTION;
const MASS_PER_METRE: f64 = 1140.0 * SECTION;
const GRAVITY: f64 = 9.80665;

/// Knots on a square grid, row by row, and the springs between neighbours.
struct Grid {
    free: Vec<Option<usize>>,
    weight: Vec<f64>,
    springs: Vec<[usize; 2]>,
}

impl Grid {
    fn new() -> Grid {
        let n = MESHES + 1;
        let is_corner = |i: usize, j: usize| i.is_multiple_of(MESHES) && j.is_multiple_of(MESHES);
        let (mut free, mut count) = (vec![None; n * n], 0);
        let mut springs = Vec::new();
        for j in 0..n {
            for i in 0..n {
                if !is_corner(i, j) {
                    free[j * n + i] = Some(count);
                    count += 1;
                }
                if i + 1 < n {
                    springs.push([j * n + i, j * n + i + 1]);
                }
                if j + 1 < n {
                    springs.push([j * n + i, (j + 1) * n + i]);
                }
            }
        }
        let mut weight = vec![0.0; n * n];
        for knot in springs.iter().flatten() {
            weight[*knot] += 0.5 * MASS_PER_METRE * MESH * GRAVITY;
        }
        Grid { free, weight, springs }
    }

    /// Potential energy, its gradient and its curvature at the positions `x`.
    fn energy(&self, x: &[DVec3]) -> (f64, DVector<f64>, DMatrix<f64>) {
        let size = 3 * self.free.iter().flatten().count();
        let (mut gradient, mut curvature) = (DVector::zeros(size), DMatrix::zeros(size, size));
        let mut energy: f64 = x.iter().zip(&self.weight).map(|(x, w)| w * x.z).sum();
        for (knot, place) in self.free.iter().enumerate() {
            if let Some(p) = place {
                gradient[3 * p + 2] += self.weight[knot];
            }
        }
        let stiffness = AXIAL_STIFFNESS / MESH;
        for &[a, b] in &self.springs {
            let (span, length) = (x[b] - x[a], (x[b] - x[a]).length());
            let stretch = length - MESH;
            if stretch <= 0.0 {
                continue;
            }
            let (along, tension) = (span / length, stiffness * stretch);
            energy += 0.5 * tension * stretch;
            let outer = DMat3::from_cols(along * along.x, along * along.y, along * along.z);
            let block = outer * (stiffness - tension / length) + DMat3::IDENTITY * (tension / length);
            for (end, sign) in [(a, -1.0), (b, 1.0)] {
                let Some(p) = self.free[end] else { continue };
                for k in 0..3 {
                    gradient[3 * p + k] += sign * tension * along[k];
                }
                for (other, other_sign) in [(a, -1.0), (b, 1.0)] {
                    let Some(q) = self.free[other] else { continue };
                    for (k, l) in (0..9).map(|kl| (kl / 3, kl % 3)) {
                        curvature[(3 * p + k, 3 * q + l)] += sign * other_sign * block.col(l)[k];
                    }
                }
            }
        }
        (energy, gradient, curvature)
    }

    fn moved(&self, x: &[DVec3], way: &DVector<f64>) -> Vec<DVec3> {
        let shift = |p: usize| DVec3::new(way[3 * p], way[3 * p + 1], way[3 * p + 2]);
        x.iter().zip(&self.free).map(|(x, place)| place.map_or(*x, |p| *x + shift(p))).collect()
    }

    /// Positions of the knots in equilibrium, m. Newton's method, damped after Levenberg if a step would not lower the
    /// energy.
    fn rest(&self) -> Vec<DVec3> {
        let n = MESHES + 1;
        let at = |i: usize| i as f64 * MESH - 0.5 * SIDE;
        let mut x: Vec<DVec3> = (0..n * n).map(|k| DVec3::new(at(k % n), at(k / n), 0.0)).collect();
        let mut damping = AXIAL_STIFFNESS;
        for _ in 0..500 {
            let (energy, gradient, curvature) = self.energy(&x);
            if gradient.amax() < 1e-12 {
                return x;
            }
            let size = gradient.len();
            loop {
                let matrix = &curvature + DMatrix::identity(size, size) * damping;
                let way = matrix.cholesky().expect("a positive definite matrix").solve(&(-&gradient));
                let next = self.moved(&x, &way);
                let (lower, steeper, _) = self.energy(&next);
                if lower < energy || steeper.amax() < gradient.amax() {
                    (x, damping) = (next, (0.2 * damping).max(1e-9));
                    break;
                }
                damping *= 10.0;
            }
        }
        panic!("no equilibrium found");
    }
}

#[test]
fn the_hanging_net_comes_to_rest_in_its_static_equilibrium() {
    let run = Run::example("05_hanging_net/hanging_net.toml", &["solve.duration=12 s", "record.every=0.5 s"]);
    let last = run.fields.times.len() - 1;
    let exact = Grid::new().rest();

    // with one segment a mesh all nodes are knots, in the same order as here
    let found = run.fields.positions(last);
    assert_eq!(found.len(), exact.len());
    let fastest = run.fields.velocities(last).iter().map(|v| v.length()).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for (found, exact) in found.iter().zip(&exact).filter(|(_, exact)| exact.z != 0.0) {
        worst = worst.max((found.z / exact.z - 1.0).abs());
    }
    let middle = exact.len() / 2;
    println!(
        "sag of the middle {:.6} m, static {:.6} m; knots within {worst:.1e} of their sag; fastest {fastest:.1e} m/s",
        -found[middle].z, -exact[middle].z
    );
    assert!(worst < 1e-3, "{worst}");
    assert!(exact[middle].z < -0.05, "the net does not sag");
}

#[test]
fn dynamic_relaxation_finds_the_equilibrium_of_newtons_method() {
    let run = Run::example("05_hanging_net/hanging_net.toml", &["solve.static={tolerance=1e-9}"]);
    let exact = Grid::new().rest();
    let misses = run.fields.positions(0).iter().zip(&exact).map(|(found, exact)| found.distance(*exact));
    let worst = misses.fold(0.0, f64::max);
    let found = run.summary.statics.as_ref().expect("an equilibrium");
    println!(
        "{} iterations, residual {:.1e}: knots within {worst:.1e} m, sag {:.6} m",
        found.iterations,
        found.residual_relative.unwrap(),
        -exact[exact.len() / 2].z
    );
    assert!(worst < 1e-6, "{worst}");
}
