//! Meshed sheets against theory: cylindrical bending, vibration of plates and membranes, wrinkling of a sheared sheet.

use glam::{DVec2, DVec3};
use nalgebra::{DMatrix, DVector};
use netcast::dynamics::forces::element::Element;
use netcast::dynamics::forces::hinge::{Hinge, flexural_rigidity};
use netcast::dynamics::forces::membrane::{Fabric, Membrane};
use netcast::dynamics::forces::tension_field::{Elasticity, Tautness};
use netcast::webs::{Sheet, hexagonal_sheet};

const E: f64 = 2e9;
const NU: f64 = 0.3;
const THICKNESS: f64 = 2e-3;
const DENSITY: f64 = 1400.0;

/// First eigenvalue of the Laplacian on the regular hexagon of side 1 with zero on the rim, see docs/theory/plate.md.
const HEXAGON: f64 = 7.155339;

fn fabric(compresses: bool) -> Fabric {
    Fabric { elasticity: Elasticity::isotropic(E, NU), thickness: THICKNESS, compresses, damping_time: 0.0 }
}

fn membranes(nodes: &[DVec2], triangles: &[[usize; 3]], fabric: &Fabric) -> Vec<Membrane> {
    triangles.iter().map(|&t| Membrane::new(t, t.map(|node| nodes[node]), fabric).unwrap()).collect()
}

fn hinges(sheet: &Sheet, rigidity: f64) -> Vec<Hinge> {
    sheet.hinges.iter().map(|&h| Hinge::new(h, h.map(|node| sheet.nodes[node]), rigidity, 0.0).unwrap()).collect()
}

fn add_forces<const N: usize>(elements: &[impl Element<N>], x: &[DVec3], force: &mut [DVec3]) {
    for element in elements {
        let nodes = element.nodes();
        let pull = element.pull(nodes.map(|node| x[node]), [DVec3::ZERO; N]);
        for (node, elastic) in nodes.into_iter().zip(pull.elastic) {
            force[node] += elastic;
        }
    }
}

/// Mass of each node, kg, (nodes,): a third of each of its triangles.
fn masses(sheet: &Sheet) -> Vec<f64> {
    let mut mass = vec![0.0; sheet.nodes.len()];
    for &[a, b, c] in &sheet.triangles {
        let area = 0.5 * (sheet.nodes[b] - sheet.nodes[a]).perp_dot(sheet.nodes[c] - sheet.nodes[a]);
        for node in [a, b, c] {
            mass[node] += DENSITY * THICKNESS * area / 3.0;
        }
    }
    mass
}

/// Lowest frequency, rad/s, of motion normal to the sheet if only the nodes `free` move.
fn first_frequency(mass: &[f64], free: &[usize], x: &[DVec3], forces: impl Fn(&[DVec3]) -> Vec<DVec3>) -> f64 {
    let mut x = x.to_vec();
    let h = 1e-7;
    let columns: Vec<Vec<DVec3>> = free
        .iter()
        .map(|&node| {
            x[node].z = h;
            let force = forces(&x);
            x[node].z = 0.0;
            force
        })
        .collect();
    let matrix = DMatrix::from_fn(free.len(), free.len(), |r, c| {
        let (a, b) = (free[r], free[c]);
        -0.5 * (columns[c][a].z + columns[r][b].z) / (h * (mass[a] * mass[b]).sqrt())
    });
    matrix.symmetric_eigenvalues().min().sqrt()
}

fn inside(sheet: &Sheet) -> Vec<usize> {
    (0..sheet.nodes.len()).filter(|node| !sheet.sides.iter().flatten().any(|on_rim| on_rim == node)).collect()
}

#[test]
fn a_sheet_bent_to_a_cylinder_stores_half_its_rigidity_times_curvature_squared() {
    let (n, rigidity, curvature) = (16, 3.0, 0.4);
    let sheet = hexagonal_sheet(1.0, n).unwrap();
    let area = 1.5 * 3.0_f64.sqrt();
    let per_area = 0.5 * rigidity * curvature * curvature;
    for degrees in [0.0_f64, 90.0, 15.0, 40.0] {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let x: Vec<DVec3> = sheet
            .nodes
            .iter()
            .map(|p| {
                let (along, around) = (cos * p.x + sin * p.y, cos * p.y - sin * p.x);
                let angle = curvature * around;
                DVec3::new(along, libm::sin(angle) / curvature, (1.0 - libm::cos(angle)) / curvature)
            })
            .collect();
        let energy: f64 =
            hinges(&sheet, rigidity).iter().map(|h| h.elastic_energy(h.nodes().map(|node| x[node]))).sum();
        // outer edges have no hinge: 3 n of 9 n^2 edges are missing
        let expected = per_area * area * (1.0 - 1.0 / (3 * n) as f64);
        assert!((energy / expected - 1.0).abs() < 2e-3, "{degrees} degrees: {energy} J, expected {expected} J");
        assert!((energy / (per_area * area) - 1.0).abs() < 0.025);
    }
}

#[test]
fn a_dome_and_a_saddle_store_the_energy_of_a_plate_of_poisson_ratio_minus_a_third() {
    let (n, rigidity, curvature) = (8, 3.0, 1e-3);
    let sheet = hexagonal_sheet(1.0, n).unwrap();
    let covered = 1.5 * 3.0_f64.sqrt() * (1.0 - 1.0 / (3 * n) as f64);
    // curvatures along x and y and twist; the energy is D ((1 + nu) m^2 + (1 - nu) d^2)
    for ([xx, yy, xy], share) in
        [([1.0, 1.0, 0.0], 2.0 / 3.0), ([1.0, -1.0, 0.0], 4.0 / 3.0), ([0.0, 0.0, 1.0], 4.0 / 3.0)]
    {
        let height = |p: &DVec2| curvature * (0.5 * (xx * p.x * p.x + yy * p.y * p.y) + xy * p.x * p.y);
        let x: Vec<DVec3> = sheet.nodes.iter().map(|p| p.extend(height(p))).collect();
        let energy: f64 =
            hinges(&sheet, rigidity).iter().map(|h| h.elastic_energy(h.nodes().map(|node| x[node]))).sum();
        let expected = share * rigidity * curvature * curvature * covered;
        assert!((energy / expected - 1.0).abs() < 1e-5, "{energy} J, expected {expected} J");
    }
}

/// Relative error of the first frequency of a plate made of these hinges; `exact` in rad/s.
fn plate_error(sheet: &Sheet, hinges: &[Hinge], free: &[usize], exact: f64) -> f64 {
    let x: Vec<DVec3> = sheet.nodes.iter().map(|p| p.extend(0.0)).collect();
    let found = first_frequency(&masses(sheet), free, &x, |x| {
        let mut force = vec![DVec3::ZERO; x.len()];
        add_forces(hinges, x, &mut force);
        force
    });
    found / exact - 1.0
}

/// sqrt(D / (rho t)), m^2/s: the frequency of a plate over the eigenvalue of the Laplacian.
fn plate_speed() -> f64 {
    (flexural_rigidity(E, NU, THICKNESS) / (DENSITY * THICKNESS)).sqrt()
}

#[test]
fn a_simply_supported_hexagonal_plate_has_its_first_frequency() {
    let side = 0.5;
    let errors = [8, 16].map(|n| {
        let sheet = hexagonal_sheet(side, n).unwrap();
        let hinges = hinges(&sheet, flexural_rigidity(E, NU, THICKNESS));
        plate_error(&sheet, &hinges, &inside(&sheet), HEXAGON / (side * side) * plate_speed())
    });
    assert!(errors[1].abs() < 0.03, "{errors:?}");
    // first order: curvature grows without bound towards a corner of 120 degrees
    assert!((2.0 * errors[1] - errors[0]).abs() < 0.005, "{errors:?}");
}

#[test]
fn a_simply_supported_triangular_plate_converges_to_its_first_frequency() {
    // a sixth of the hexagon: the eigenvalue of the Laplacian is 16 pi^2/3, and a corner of 60 degrees is not singular
    let side = 0.5;
    let pi = std::f64::consts::PI;
    let errors = [6, 12, 24].map(|n| {
        let mut sheet = hexagonal_sheet(side, n).unwrap();
        let far = |p: &DVec2| [p.y, 0.75_f64.sqrt() * p.x - 0.5 * p.y, 0.75_f64.sqrt() * (side - p.x) - 0.5 * p.y];
        let least = |node: usize| far(&sheet.nodes[node]).into_iter().fold(f64::INFINITY, f64::min);
        let free: Vec<usize> = (0..sheet.nodes.len()).filter(|&node| least(node) > 1e-9).collect();
        let hinges: Vec<[usize; 4]> =
            sheet.hinges.iter().copied().filter(|hinge| hinge.iter().all(|&node| least(node) > -1e-9)).collect();
        sheet.hinges = hinges;
        let hinges = self::hinges(&sheet, flexural_rigidity(E, NU, THICKNESS));
        plate_error(&sheet, &hinges, &free, 16.0 * pi * pi / (3.0 * side * side) * plate_speed())
    });
    assert!(errors[1].abs() < 0.03 && errors[2].abs() < 0.01, "{errors:?}");
    let order = (errors[1] / errors[2]).log2();
    assert!((order - 2.0).abs() < 0.2, "order {order}, errors {errors:?}");
}

#[test]
fn a_stretched_hexagonal_membrane_has_its_tension_and_its_first_frequency() {
    let (side, stretch) = (0.5, 1.01);
    let strain = 0.5 * (stretch * stretch - 1.0);
    let stress = E / (1.0 - NU) * strain;
    let exact = (stress / DENSITY * HEXAGON).sqrt() / side;
    let errors = [4, 8, 16].map(|n| {
        let sheet = hexagonal_sheet(side, n).unwrap();
        let membranes = membranes(&sheet.nodes, &sheet.triangles, &fabric(false));
        let x: Vec<DVec3> = sheet.nodes.iter().map(|p| stretch * p.extend(0.0)).collect();
        let forces = |x: &[DVec3]| {
            let mut force = vec![DVec3::ZERO; x.len()];
            add_forces(&membranes, x, &mut force);
            force
        };
        // inner nodes are in balance; the rim bears stretch * stress * thickness per length at rest
        let pull = stretch * stress * THICKNESS * side / n as f64;
        let mut balance = forces(&x);
        for (k, nodes) in sheet.sides.iter().enumerate() {
            let outward = DVec2::from_angle((60.0 * k as f64 + 30.0).to_radians()).extend(0.0);
            for pair in nodes.windows(2) {
                for &node in pair {
                    balance[node] += 0.5 * pull * outward;
                }
            }
        }
        assert!(balance.iter().all(|force| force.length() < 1e-9 * pull));
        first_frequency(&masses(&sheet), &inside(&sheet), &x, forces) / exact - 1.0
    });
    assert!(errors[1].abs() < 0.01 && errors[2].abs() < 0.003, "{errors:?}");
}

/// A sheet 6 m wide and 1 m high, held along its lower and its upper edge, free at its sides.
struct Panel {
    nodes: Vec<DVec2>,
    membranes: Vec<Membrane>,
}

impl Panel {
    const WIDTH: f64 = 6.0;

    fn new(cells: usize) -> Self {
        let (columns, spacing) = (6 * cells, 1.0 / cells as f64);
        let nodes: Vec<DVec2> = (0..=cells)
            .flat_map(|row| (0..=columns).map(move |column| spacing * DVec2::new(column as f64, row as f64)))
            .collect();
        let at = |column: usize, row: usize| row * (columns + 1) + column;
        let cell = |column: usize, row: usize| {
            let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
            // diagonals alternate, so that the mesh prefers no direction
            if (column + row).is_multiple_of(2) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        };
        let triangles: Vec<[usize; 3]> =
            (0..cells).flat_map(|row| (0..columns).flat_map(move |column| cell(column, row))).collect();
        let membranes = membranes(&nodes, &triangles, &fabric(false));
        Self { nodes, membranes }
    }

    fn forces(&self, x: &[DVec3]) -> Vec<DVec3> {
        let mut force = vec![DVec3::ZERO; x.len()];
        add_forces(&self.membranes, x, &mut force);
        force
    }

    /// Positions in equilibrium, m, after the upper edge is raised and moved along. Newton's method; a small multiple of the
    /// identity keeps its matrix regular.
    fn shear(&self, raise: f64, along: f64) -> Vec<DVec3> {
        let mut x: Vec<DVec3> =
            self.nodes.iter().map(|p| DVec3::new(p.x + along * p.y, p.y * (1.0 + raise), 0.0)).collect();
        let free: Vec<(usize, usize)> = (0..x.len())
            .filter(|&i| self.nodes[i].y > 0.0 && self.nodes[i].y < 1.0)
            .flat_map(|i| [(i, 0), (i, 1)])
            .collect();
        let pick = |forces: &[DVec3]| DVector::from_iterator(free.len(), free.iter().map(|&(i, axis)| forces[i][axis]));
        let (h, floor) = (1e-7, 1e-3 * E * THICKNESS);
        for _ in 0..60 {
            let mut stiffness = floor * DMatrix::identity(free.len(), free.len());
            for (column, &(i, axis)) in free.iter().enumerate() {
                let at = x[i][axis];
                x[i][axis] = at + h;
                let ahead = pick(&self.forces(&x));
                x[i][axis] = at - h;
                let behind = pick(&self.forces(&x));
                x[i][axis] = at;
                let slope: DVector<f64> = (behind - ahead) / (2.0 * h);
                stiffness.column_mut(column).axpy(1.0, &slope, 1.0);
            }
            let force = pick(&self.forces(&x));
            if force.amax() < 1e-9 * E * THICKNESS {
                return x;
            }
            let change = stiffness.lu().solve(&force).expect("regular");
            for (&(i, axis), by) in free.iter().zip(&change) {
                x[i][axis] += by;
            }
        }
        panic!("no equilibrium");
    }

    /// State, principal stresses, Pa, and their direction, degrees, of the triangles near the middle.
    fn middle(&self, x: &[DVec3]) -> Vec<(Tautness, [f64; 2], f64)> {
        let far_in = |m: &&Membrane| m.nodes().iter().all(|&i| (self.nodes[i].x - 0.5 * Self::WIDTH).abs() < 0.55);
        self.membranes
            .iter()
            .filter(far_in)
            .map(|m| {
                let stress = m.stress(m.nodes().map(|node| x[node]));
                let (values, angle) = stress.principal();
                (stress.tautness, values, angle.to_degrees())
            })
            .collect()
    }
}

#[test]
fn a_sheared_panel_wrinkles_at_45_degrees() {
    let (panel, shear) = (Panel::new(4), 0.004);
    let x = panel.shear(0.0, shear);
    for (state, [first, second], degrees) in panel.middle(&x) {
        assert_eq!(state, Tautness::Wrinkled);
        assert!(second.abs() < 1e-9 * first && (degrees - 45.0).abs() < 1.0, "{degrees} degrees");
        assert!((first / (0.5 * E * shear) - 1.0).abs() < 0.03, "{first} Pa");
    }
}

#[test]
fn a_raised_panel_wrinkles_at_the_shear_where_its_second_stress_is_zero() {
    // strain e across a wide panel: stresses nu E' e and E' e; with the shear G c the second one reaches zero where
    // (G c)^2 = nu (E' e)^2, c = 2 e sqrt(nu) / (1 - nu)
    let (panel, strain) = (Panel::new(4), 0.002);
    let critical = 2.0 * strain * NU.sqrt() / (1.0 - NU);
    let taut = |share: f64| {
        let x = panel.shear(strain, share * critical);
        let middle = panel.middle(&x);
        middle.iter().filter(|(state, ..)| *state == Tautness::Taut).count() as f64 / middle.len() as f64
    };
    let (below, above) = (taut(0.95), taut(1.05));
    assert!(below == 1.0 && above == 0.0, "{below} of the middle is taut below, {above} above");
}
