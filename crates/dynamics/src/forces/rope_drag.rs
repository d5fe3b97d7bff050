//! Drag of a rope: the normal and the tangential component of the wind act independently.
//!
//! ```text
//! u = wind - v,   u_t = (u.t) t,   u_n = u - u_t               at the middle of a segment; t: its direction
//! F = 1/2 rho d L0 (C_n |u_n| u_n + C_t |u_t| u_t)
//! ```
//!
//! This is the cross-flow principle (Hoerner, Fluid-Dynamic Drag, 1965, 3-11; Jones & Robinson 1947). A rope at an angle a
//! to the flow has the drag coefficient C_n sin^3 a + C_t cos^3 a and the lift coefficient (C_n sin a - C_t cos a) sin a cos a.
//! The normal coefficient of a round rope depends on its Reynolds number Re = rho |u_n| d / mu (Choo & Casarella,
//! J. Hydronautics 5, 1971):
//!
//! ```text
//! 8 pi / (s Re) (1 - 0.87/s^2),  s = ln(8/Re) - 0.077215665        Re < 1
//! 1.45 + 8.55 Re^-0.9                                          1 <= Re < 30
//! 1.1 + 4 / sqrt(Re)                                          30 <= Re
//! ```
//!
//! It was measured up to Re = 2.33e5, where drag falls; the last line is used beyond too. C_t is about 0.02, also with
//! reference to d L0. The length is the rest length, since a slack rope is longer than the distance between its nodes.
//!
//! The founding paper writes the same law in the axes of each segment (its eqs. (8), (13)-(15)); docs/theory/air.md shows
//! that both agree.

use glam::DVec3;

/// Diameter and drag coefficients of a round rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RopeDrag {
    /// Diameter, m.
    pub diameter: f64,
    /// Normal coefficient; `None`: it follows from the Reynolds number.
    pub normal: Option<f64>,
    /// Tangential coefficient.
    pub tangential: f64,
    /// Solidity of the screen to which the rope belongs, projected area of ropes over area; 0 for a single rope. See
    /// [`screen_factor`].
    pub solidity: f64,
}

/// Drag of a rope in a screen over the drag of a single rope: (2 - S) / (2 (1 - S)^2), since the flow between ropes is faster
/// than the wind. S is the `solidity`, projected area of ropes over area. (Kristiansen & Faltinsen, J. Fluids Struct. 34,
/// 2012, for a screen normal to the stream; compared there with measured panels of S up to 0.5.)
pub fn screen_factor(solidity: f64) -> f64 {
    (2.0 - solidity) / (2.0 * (1.0 - solidity) * (1.0 - solidity))
}

/// Reynolds number from which [`plain_coefficient`] holds, which needs no more than a square root.
pub(crate) const PLAIN: f64 = 30.0;

/// Least and largest Reynolds number for which [`twine_coefficient`] was fitted.
const TWINE: (f64, f64) = (31.6, 1e4);

/// Normal coefficient of a smooth twine in a screen, over the Reynolds number of the flow between twines (Kristiansen &
/// Faltinsen 2012, a fit to measured cylinders). Below Re = 10^1.5 it is that of a single rope, with a step of less than
/// 3 %. Above 1e4, where the fit soon breaks down, it is the value at 1e4.
pub fn twine_coefficient(reynolds: f64) -> f64 {
    const POWERS: [f64; 8] =
        [-78.466_75, 254.738_73, -327.886_4, 223.645_77, -87.922_34, 20.007_69, -2.448_94, 0.124_79];
    if reynolds < TWINE.0 {
        return normal_coefficient(reynolds);
    }
    let log = libm::log10(if reynolds < TWINE.1 { reynolds } else { TWINE.1 });
    POWERS.iter().rev().fold(0.0, |sum, power| sum * log + power)
}

/// Normal coefficient of a single round rope. At `reynolds` 0 it is 0, as there is no force.
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
pub(crate) fn plain_coefficient(reynolds: f64) -> f64 {
    1.1 + 4.0 / reynolds.sqrt()
}

/// The wind relative to a segment, m/s: its components across and along the segment, and their magnitudes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RelativeFlow {
    normal: [f64; 3],
    pub across: f64,
    tangential: [f64; 3],
    along: f64,
}

/// Keeps a division finite where two nodes coincide, m^2; all wind is across such a segment.
const LEAST_LENGTH_SQUARED: f64 = 1e-200;

impl RelativeFlow {
    /// `span`: vector from one end of the segment to the other, m. `relative`: wind relative to it, m/s.
    #[inline(always)]
    pub fn new(span: [f64; 3], relative: [f64; 3]) -> RelativeFlow {
        let square = dot(span, span);
        let bounded = if square > LEAST_LENGTH_SQUARED { square } else { LEAST_LENGTH_SQUARED };
        let share = dot(relative, span) / bounded;
        let tangential = [share * span[0], share * span[1], share * span[2]];
        let normal = [relative[0] - tangential[0], relative[1] - tangential[1], relative[2] - tangential[2]];
        RelativeFlow {
            normal,
            across: dot(normal, normal).sqrt(),
            tangential,
            along: dot(tangential, tangential).sqrt(),
        }
    }

    /// Force, N, on a segment with 1/2 rho d L0 = `per_pressure`, kg/m.
    #[inline(always)]
    pub fn force(&self, normal_coefficient: f64, tangential_coefficient: f64, per_pressure: f64) -> [f64; 3] {
        let normal = per_pressure * (normal_coefficient * self.across);
        let tangential = per_pressure * (tangential_coefficient * self.along);
        std::array::from_fn(|k| normal * self.normal[k] + tangential * self.tangential[k])
    }
}

#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl RopeDrag {
    /// Normal coefficient, the factor of the screen included, at the Reynolds number of a single rope.
    pub fn coefficient(&self, reynolds: f64) -> f64 {
        match (self.normal, self.in_screen()) {
            (Some(normal), _) => screen_factor(self.solidity) * normal,
            (None, false) => normal_coefficient(reynolds),
            (None, true) => screen_factor(self.solidity) * twine_coefficient(reynolds / (1.0 - self.solidity)),
        }
    }

    /// Whether the rope belongs to a screen.
    pub(crate) fn in_screen(&self) -> bool {
        self.solidity > 0.0
    }

    /// The area d L0 / 4, m^2, of a segment of this rest length, m. Times the density it is half of 1/2 rho d L0, since half
    /// of the drag acts on each end.
    pub(crate) fn half_area(&self, rest_length: f64) -> f64 {
        0.25 * self.diameter * rest_length
    }

    /// Force on a segment, N, that spans `span`, m, in a wind of `relative` to it, m/s. `rest_length` in m, `density` in
    /// kg/m^3, `viscosity` in Pa s.
    pub fn force(&self, span: DVec3, relative: DVec3, rest_length: f64, density: f64, viscosity: f64) -> DVec3 {
        2.0 * self.half_force(span, relative, rest_length, density, viscosity)
    }

    /// Half of it.
    pub(crate) fn half_force(
        &self,
        span: DVec3,
        relative: DVec3,
        rest_length: f64,
        density: f64,
        viscosity: f64,
    ) -> DVec3 {
        let met = RelativeFlow::new(span.into(), relative.into());
        let coefficient = self.coefficient(density * met.across * (self.diameter / viscosity));
        met.force(coefficient, self.tangential, density * self.half_area(rest_length)).into()
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
    fn a_screen_drags_as_published() {
        // C_D = C S (2 - S) / (2 (1 - S)^2), and as Aarsnes (1990) and Loland (1991) have it
        for solidity in [0.15, 0.2, 0.25, 0.3] {
            let rope = RopeDrag { diameter: 0.002, normal: None, tangential: 0.0, solidity };
            let found = solidity * rope.coefficient(1500.0);
            let s = solidity;
            let aarsnes = 0.04 + (-0.04 + s - 1.24 * s * s + 13.7 * s * s * s);
            let loland = 0.04 + (-0.04 + 0.33 * s + 6.54 * s * s - 4.88 * s * s * s);
            let (low, high) = (aarsnes.min(loland), aarsnes.max(loland));
            println!("{s}: {found:.3}, {aarsnes:.3}, {loland:.3}");
            let spread = if s == 0.2 { 0.0 } else { 0.12 };
            assert!(found > (1.0 - spread) * low && found < (1.0 + spread) * high, "{s}: {found}, {low} to {high}");
        }
        // the fit meets the rope alone where it begins, and is held where it ends
        assert!((twine_coefficient(31.7) / normal_coefficient(31.5) - 1.0).abs() < 0.03);
        assert_eq!(twine_coefficient(1e4), twine_coefficient(1e6));
    }

    #[test]
    fn an_inclined_rope_has_the_drag_and_lift_of_hoerner() {
        let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.022, solidity: 0.0 };
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
            let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.02, solidity: 0.0 };
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
        let rope = RopeDrag { diameter: 0.004, normal: None, tangential: 0.02, solidity: 0.0 };
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
        let rope = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.0, solidity: 0.0 };
        let weight = 1850.0 * std::f64::consts::PI * 0.01 * 0.01 / 4.0 * 9.80665;
        let drag = rope.force(DVec3::X, 14.5 * DVec3::Z, 1.0, 1.225, AIR.1).z;
        assert!((drag / weight - 1.0).abs() < 0.01, "{}", drag / weight);
    }
}
