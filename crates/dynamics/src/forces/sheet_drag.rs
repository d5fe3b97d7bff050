//! Drag of a triangle of sheet: a pressure from the component of the relative wind normal to it.
//!
//! ```text
//! F = 1/2 rho C (1 - porosity) A |u.n| (u.n) n        u = wind - v at the middle; n: normal; A: present area, m^2
//! ```
//!
//! C = 1.17 is the drag coefficient of a plate normal to the wind (Hoerner, Fluid-Dynamic Drag, 1965, 3-15); the user may
//! give another. Only the normal component acts, by the same cross-flow principle as for ropes. A plate at a small angle to
//! the wind has more lift than this law gives; the difference is neglected, since sheets tumble. Porosity is the open share of
//! the area; air that flows through the openings exerts no force.

use glam::DVec3;

/// Drag coefficient of a plate normal to the wind.
pub const PLATE: f64 = 1.17;

/// A triangle of sheet that has drag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetDrag {
    /// Its corners.
    pub nodes: [usize; 3],
    /// C (1 - porosity).
    pub coefficient: f64,
    /// Area at rest, m^2, for the bound of the step; the force uses the present area.
    pub area: f64,
}

/// Force on a triangle with corners at `x`, m, that move at `v`, m/s, in a `wind`, m/s: N; a third acts on each corner.
/// `density` in kg/m^3; `coefficient`: C (1 - porosity).
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
    fn a_plate_normal_to_the_wind_has_its_drag_coefficient_on_either_side() {
        let x = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let still = [DVec3::ZERO; 3];
        let force_on = |x, wind| force(x, still, wind, 1.2, PLATE);
        let expected = 0.5 * 1.2 * 1.17 * 0.5 * 100.0;
        assert!((force_on(x, 10.0 * DVec3::Z).z - expected).abs() < 1e-12);
        assert!((force_on([x[0], x[2], x[1]], 10.0 * DVec3::Z).z - expected).abs() < 1e-12);
        assert!((force_on(x, -10.0 * DVec3::Z).z + expected).abs() < 1e-12);
        // no force: wind along the sheet, a sheet that moves with the wind, a triangle without area
        assert_eq!(force_on(x, 10.0 * DVec3::X), DVec3::ZERO);
        assert_eq!(force(x, [DVec3::Z; 3], DVec3::Z, 1.2, PLATE), DVec3::ZERO);
        assert_eq!(force_on([DVec3::X; 3], DVec3::Z), DVec3::ZERO);
    }
}
