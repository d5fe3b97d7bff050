//! Pressure of the wind on a piece of sheet: by the part of the relative wind that is normal to it.
//!
//! ```text
//! F = 1/2 rho C (1 - porosity) A |u.n| (u.n) n        u = wind - v at the middle, n the normal, A the area as it is now
//! ```
//!
//! C = 1.17 of a plate square to the wind (Hoerner, Fluid-Dynamic Drag, 1965, 3-15), or as given. That only the normal
//! part counts is the same cross-flow principle as for ropes; a plate at a small angle has more lift than that, which is
//! of no account for what tumbles. The porosity is the open share of the area: the air that passes through it is taken
//! to press on nothing.

use glam::DVec3;

/// Coefficient of a plate square to the wind.
pub const PLATE: f64 = 1.17;

/// A triangle of sheet that drags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetDrag {
    /// Its corners.
    pub nodes: [usize; 3],
    /// Coefficient with the porosity taken off.
    pub coefficient: f64,
    /// Area at rest, m^2: for the bound on the step; the force is that of the area as it is.
    pub area: f64,
}

/// Force on a triangle with corners at `x`, m, that move at `v`, m/s, in a `wind`, m/s: N, a third of it on each corner.
/// `density` in kg/m^3; `coefficient` with the porosity taken off.
pub fn force(x: [DVec3; 3], v: [DVec3; 3], wind: DVec3, density: f64, coefficient: f64) -> DVec3 {
    let twice_area = (x[1] - x[0]).cross(x[2] - x[0]);
    let area = 0.5 * twice_area.length();
    let normal = twice_area.normalize_or_zero();
    let speed = (wind - (v[0] + v[1] + v[2]) / 3.0).dot(normal);
    0.5 * density * coefficient * area * speed.abs() * speed * normal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plate_square_to_the_wind_drags_with_its_coefficient_whichever_way_it_is_seen() {
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let still = [DVec3::ZERO; 3];
        let force_on = |x, wind| force(x, still, wind, 1.2, PLATE);
        let expected = 0.5 * 1.2 * 1.17 * 0.5 * 100.0;
        assert!((force_on(x, 10.0 * DVec3::Z).z - expected).abs() < 1e-12);
        assert!((force_on([x[0], x[2], x[1]], 10.0 * DVec3::Z).z - expected).abs() < 1e-12);
        assert!((force_on(x, -10.0 * DVec3::Z).z + expected).abs() < 1e-12);
        // a wind along it, a sheet that moves with it, one that has no area
        assert_eq!(force_on(x, 10.0 * DVec3::X), DVec3::ZERO);
        assert_eq!(force(x, [DVec3::Z; 3], DVec3::Z, 1.2, PLATE), DVec3::ZERO);
        assert_eq!(force_on([DVec3::X; 3], DVec3::Z), DVec3::ZERO);
    }
}
