//! Drag of a rope: the normal part of the wind drags by itself, and the tangential part by itself.
//!
//! ```text
//! u = wind - v,   u_t = (u.t) t,   u_n = u - u_t               at the middle of a segment, t its direction
//! F = 1/2 rho d L0 (C_n |u_n| u_n + C_t |u_t| u_t)
//! ```
//!
//! The cross-flow principle (Hoerner, Fluid-Dynamic Drag, 1965, 3-11; Jones & Robinson 1947): it gives the drag
//! C_n sin^3 a + C_t cos^3 a and the lift (C_n sin a - C_t cos a) sin a cos a of a rope at an angle a to the flow. The
//! normal coefficient of a round rope by its Reynolds number Re = rho |u_n| d / mu (Choo & Casarella, J. Hydronautics 5,
//! 1971):
//!
//! ```text
//! 8 pi / (s Re) (1 - 0.87/s^2),  s = ln(8/Re) - 0.077215665        Re < 1
//! 1.45 + 8.55 Re^-0.9                                          1 <= Re < 30
//! 1.1 + 4 / sqrt(Re)                                          30 <= Re
//! ```
//!
//! measured up to Re = 2.33e5, where drag falls; beyond, as there. C_t is some 0.02, with reference to d L0 too. The
//! length is the rope's own: a slack rope between two nodes has not become shorter.
//!
//! The founding paper writes the same by turning each segment's axes (its eqs. (8), (13)-(15)); docs/theory/air.md shows
//! that both are one.

use glam::DVec3;

/// How a round rope drags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RopeDrag {
    /// Diameter, m.
    pub diameter: f64,
    /// Normal coefficient; by the Reynolds number where none is given.
    pub normal: Option<f64>,
    /// Tangential coefficient.
    pub tangential: f64,
    /// Factor on the normal drag for what the ropes of a screen do to each other; 1 for a rope alone. See [`screen_factor`].
    pub screen: f64,
}

/// How much more a rope drags in a screen of this solidity (projected area of ropes over area) than alone:
/// (2 - S) / (2 (1 - S)^2), for the flow between ropes is faster than the wind (Kristiansen & Faltinsen, J. Fluids Struct.
/// 34, 2012; there for a screen square to the stream, held to panels of S up to 0.5).
pub fn screen_factor(solidity: f64) -> f64 {
    (2.0 - solidity) / (2.0 * (1.0 - solidity) * (1.0 - solidity))
}

/// Reynolds number from which the normal coefficient needs no more than a square root.
const PLAIN: f64 = 30.0;

/// Normal coefficient of a round rope; any where `reynolds` is zero, as there is no force.
pub fn normal_coefficient(reynolds: f64) -> f64 {
    if reynolds >= PLAIN {
        plain_coefficient(reynolds)
    } else if reynolds >= 1.0 {
        1.45 + 8.55 * libm::pow(reynolds, -0.9)
    } else if reynolds > 0.0 {
        let s = libm::log(8.0 / reynolds) - 0.077_215_665;
        8.0 * std::f64::consts::PI / (s * reynolds) * (1.0 - 0.87 / (s * s))
    } else {
        0.0
    }
}

#[inline(always)]
fn plain_coefficient(reynolds: f64) -> f64 {
    1.1 + 4.0 / reynolds.sqrt()
}

impl RopeDrag {
    /// Force on a segment, N, that spans `span`, m, in a wind of `relative` to it, m/s. `rest_length` in m, `density` in
    /// kg/m^3, `viscosity` in Pa s.
    pub fn force(&self, span: DVec3, relative: DVec3, rest_length: f64, density: f64, viscosity: f64) -> DVec3 {
        let along = span.normalize_or_zero();
        let tangential = relative.dot(along) * along;
        let normal = relative - tangential;
        let across = normal.length();
        let coefficient =
            self.normal.unwrap_or_else(|| normal_coefficient(density * across * self.diameter / viscosity));
        let pressure = 0.5 * density * self.diameter * rest_length;
        pressure * (coefficient * across * normal + self.tangential * tangential.length() * tangential)
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;

    const AIR: (f64, f64) = (1.225, 1.7894e-5);

    #[test]
    fn the_coefficient_is_that_of_choo_and_casarella() {
        for (reynolds, coefficient) in [(0.1, 55.64), (10.0, 2.526), (100.0, 1.5), (1e4, 1.14)] {
            let found = normal_coefficient(reynolds);
            assert!((found / coefficient - 1.0).abs() < 0.02, "Re {reynolds}: {found}");
        }
        // its parts meet
        for (border, jump) in [(1.0, 0.02), (30.0, 0.02)] {
            let [below, above] = [0.999_999, 1.000_001].map(|share| normal_coefficient(share * border));
            assert!((above / below - 1.0).abs() < jump, "at Re {border}: {below} and {above}");
        }
    }

    #[test]
    fn an_inclined_rope_has_the_drag_and_lift_of_hoerner() {
        let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.022, screen: 1.0 };
        for degrees in [10.0, 30.0, 45.0, 70.0, 90.0] {
            let (sin, cos) = libm::sincos(f64::to_radians(degrees));
            let force = rope.force(2.0 * DVec3::new(cos, sin, 0.0), 20.0 * DVec3::X, 2.0, AIR.0, AIR.1);
            let unit = 0.5 * AIR.0 * 20.0 * 20.0 * 0.01 * 2.0;
            // his drag has 0.022 at any angle, which friction along the rope cannot give where it stands across
            let (drag, lift) = (1.1 * sin * sin * sin + 0.022 * cos * cos * cos, 1.1 * sin * sin * cos);
            assert!((force.x / unit - drag).abs() < 1e-12, "{degrees} deg: {}", force.x / unit);
            assert!((-force.y / unit - lift).abs() < 0.01, "{degrees} deg: {}", force.y / unit);
            assert!((force.x / unit - (1.1 * sin * sin * sin + 0.022)).abs() < 0.023);
        }
    }

    #[test]
    fn turned_axes_and_projections_give_the_same_force_and_the_same_mass() {
        // the founding paper's eq. (8): A takes the world's components to the segment's, whose third axis is tangent
        for i in 0..50 {
            let wobble = |k: f64| libm::sin(k * f64::from(i) + k);
            let ((sa, ca), (sb, cb)) = (libm::sincos(3.0 * wobble(1.7)), libm::sincos(3.0 * wobble(2.9)));
            let to_segment = DMat3::from_cols(
                DVec3::new(cb, -ca * sb, sa * sb),
                DVec3::new(sb, ca * cb, -sa * cb),
                DVec3::new(0.0, sa, ca),
            );
            let to_world = to_segment.transpose();
            let tangent = to_world * DVec3::Z;

            // forces, eqs. (13)-(15): each component in the segment's axes
            let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.02, screen: 1.0 };
            let relative = 30.0 * DVec3::new(wobble(0.3), wobble(4.1), wobble(5.3));
            let own = to_segment * relative;
            let across = own.truncate().length();
            let in_segment = DVec3::new(1.1 * across * own.x, 1.1 * across * own.y, 0.02 * own.z.abs() * own.z);
            let turned = 0.5 * AIR.0 * 0.01 * 0.4 * (to_world * in_segment);
            let projected = rope.force(0.5 * tangent, relative, 0.4, AIR.0, AIR.1);
            assert!((turned - projected).length() < 1e-12 * projected.length(), "{turned} and {projected}");

            // mass with the added mass g_a across the rope: A^T G A = (g + g_a) I - g_a t t^T
            let (g, added) = (0.058, 0.031);
            let turned = to_world * DMat3::from_diagonal(DVec3::new(g + added, g + added, g)) * to_segment;
            let outer = DMat3::from_cols(tangent * tangent.x, tangent * tangent.y, tangent * tangent.z);
            let projected = DMat3::from_diagonal(DVec3::splat(g + added)) - outer * added;
            assert!(turned.abs_diff_eq(projected, 1e-15));
        }
    }

    #[test]
    fn it_never_gives_energy_in_still_air() {
        let rope = RopeDrag { diameter: 0.004, normal: None, tangential: 0.02, screen: 1.0 };
        for i in 0..200 {
            let wobble = |k: f64| libm::sin(k * f64::from(i) + k);
            let (span, v) =
                (DVec3::new(wobble(1.3), wobble(2.1), wobble(0.7)), DVec3::new(wobble(3.3), wobble(5.0), 0.1));
            assert!(rope.force(span, -v, 1.0, AIR.0, AIR.1).dot(v) <= 0.0);
        }
    }

    #[test]
    fn a_level_rope_falls_at_the_speed_of_the_paper() {
        // 10 mm, 1850 kg/m^3, C_n 1.1: 14.5 m/s
        let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.0, screen: 1.0 };
        let weight = 1850.0 * std::f64::consts::PI * 0.01 * 0.01 / 4.0 * 9.80665;
        let drag = rope.force(DVec3::X, 14.5 * DVec3::Z, 1.0, 1.225, AIR.1).z;
        assert!((drag / weight - 1.0).abs() < 0.01, "{}", drag / weight);
    }
}
