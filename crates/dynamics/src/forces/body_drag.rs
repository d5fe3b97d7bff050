//! Drag of a body by its shape and its attitude to the wind.
//!
//! ```text
//! sphere     1/2 rho C A |u| u,                        C = 24/Re + 6/(1 + sqrt Re) + 0.4
//! cylinder   1/2 rho (C_a A |u_a| u_a + C_c d h |u_c| u_c),   along its axis and across it, each by itself
//! box        1/2 rho sum over its axes C A_k |u_k| u_k,       C = 1.07 of a cube's face
//! ```
//!
//! The sphere: White, Viscous Fluid Flow, 1991, eq. (3-225), below the drag crisis at Re = 2e5. The cylinder: C_a and C_c
//! by its height over its diameter, White, Fluid Mechanics, 2011, table 7.3, between whose entries one interpolates; the
//! cross-flow principle for attitudes between. The force acts on the centre: a body is not turned by the wind.

use glam::DVec3;

/// Shape of a body in the wind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A sphere of this diameter, m.
    Sphere(f64),
    /// A cylinder along its third axis.
    Cylinder {
        /// Diameter, m.
        diameter: f64,
        /// Height, m.
        height: f64,
    },
    /// A box of these sides along its axes, m.
    Box(DVec3),
}

/// Height over diameter, and the drag coefficient of a cylinder along its axis (reference: its end).
const ALONG: [(f64, f64); 5] = [(0.5, 1.15), (1.0, 0.90), (2.0, 0.85), (4.0, 0.87), (8.0, 0.99)];
/// The same across its axis (reference: diameter times height).
const ACROSS: [(f64, f64); 7] =
    [(1.0, 0.64), (2.0, 0.68), (3.0, 0.72), (5.0, 0.74), (10.0, 0.82), (20.0, 0.91), (40.0, 0.98)];
/// Coefficient of a cube's face.
const FACE: f64 = 1.07;

impl Shape {
    /// Force, N, in a wind of `relative` to it, m/s, along its own axes. `density` in kg/m^3, `viscosity` in Pa s.
    pub fn force(&self, relative: DVec3, density: f64, viscosity: f64) -> DVec3 {
        let quarter_pi = std::f64::consts::FRAC_PI_4;
        match *self {
            Shape::Sphere(diameter) => {
                let speed = relative.length();
                let reynolds = density * speed * diameter / viscosity;
                if reynolds == 0.0 {
                    return DVec3::ZERO;
                }
                let coefficient = 24.0 / reynolds + 6.0 / (1.0 + reynolds.sqrt()) + 0.4;
                0.5 * density * coefficient * quarter_pi * diameter * diameter * speed * relative
            }
            Shape::Cylinder { diameter, height } => {
                let slenderness = height / diameter;
                let along = between(&ALONG, slenderness) * quarter_pi * diameter * diameter;
                let across = between(&ACROSS, slenderness) * diameter * height;
                let (axial, lateral) = (DVec3::Z * relative.z, DVec3::new(relative.x, relative.y, 0.0));
                0.5 * density * (along * axial.length() * axial + across * lateral.length() * lateral)
            }
            Shape::Box(sides) => {
                let faces = DVec3::new(sides.y * sides.z, sides.z * sides.x, sides.x * sides.y);
                0.5 * density * FACE * faces * relative.abs() * relative
            }
        }
    }
}

/// Straight lines between the entries of a table, constant beyond.
fn between(table: &[(f64, f64)], at: f64) -> f64 {
    let after = table.partition_point(|&(x, _)| x <= at);
    match after {
        0 => table[0].1,
        after if after == table.len() => table[after - 1].1,
        after => {
            let ((x0, y0), (x1, y1)) = (table[after - 1], table[after]);
            y0 + (y1 - y0) * (at - x0) / (x1 - x0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AIR: (f64, f64) = (1.225, 1.7894e-5);

    #[test]
    fn a_slow_sphere_drags_as_stokes_says_and_a_fast_one_as_newton() {
        let (d, v) = (1e-4, 1e-3);
        let stokes = 3.0 * std::f64::consts::PI * AIR.1 * d * v;
        let slow = Shape::Sphere(d).force(v * DVec3::X, AIR.0, AIR.1).x;
        // 6/(1 + sqrt Re) is a tenth of a per cent and more of 24/Re from Re = 0.005 on
        assert!((slow / stokes - 1.0).abs() < 5e-3, "{}", slow / stokes);
        let fast = Shape::Sphere(0.1).force(15.0 * DVec3::Y, AIR.0, AIR.1).y;
        let coefficient = fast / (0.5 * AIR.0 * 225.0 * std::f64::consts::FRAC_PI_4 * 0.01);
        // 0.42 at Re 1e5
        assert!((coefficient - 0.42).abs() < 0.01, "{coefficient}");
        assert_eq!(Shape::Sphere(0.1).force(DVec3::ZERO, AIR.0, AIR.1), DVec3::ZERO);
    }

    #[test]
    fn a_cylinder_drags_by_its_attitude() {
        // the paper's tractor, 0.1 m by 0.2 m
        let shape = Shape::Cylinder { diameter: 0.1, height: 0.2 };
        let unit = 0.5 * AIR.0 * 400.0;
        let along = shape.force(20.0 * DVec3::Z, AIR.0, AIR.1);
        assert!((along.z / unit - 0.85 * std::f64::consts::FRAC_PI_4 * 0.01).abs() < 1e-12 && along.x == 0.0);
        let across = shape.force(20.0 * DVec3::Y, AIR.0, AIR.1);
        assert!((across.y / unit - 0.68 * 0.02).abs() < 1e-12);
        // whatever its attitude it takes energy away
        for i in 0..100 {
            let wobble = |k: f64| libm::sin(k * f64::from(i) + k);
            let u = DVec3::new(wobble(1.1), wobble(2.3), wobble(3.7));
            for shape in [shape, Shape::Sphere(0.2), Shape::Box(DVec3::new(0.1, 0.2, 0.3))] {
                assert!(shape.force(u, AIR.0, AIR.1).dot(u) >= 0.0);
            }
        }
    }
}
