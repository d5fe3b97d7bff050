//! A canopy as twelve members that carry tension only: six spokes from its hub and six sides. It folds freely, like
//! cloth.
//!
//! The members are chosen so that the canopy, flat and pulled in its plane, is as stiff as its sheet. A triangular
//! lattice of springs k, each shared by two triangles, is an isotropic sheet of two-dimensional modulus Y =
//! 2k/sqrt(3) with a Poisson ratio of 1/3 (Seung and Nelson 1988). With Y = E t:
//!
//! ```text
//! spoke  k = sqrt(3)/2 E t        side (one triangle only)  k = sqrt(3)/4 E t
//! ```
//!
//! Each triangle puts a third of its mass on each of its corners. The hub then carries a third of the canopy, and each rim
//! node a ninth. Such a canopy is no plate: it has no bending stiffness and carries no compression.

use netcast_scenario::CanopyLinks;

/// sqrt(3)/2.
const HALF_ROOT_3: f64 = 0.866_025_403_784_438_6;

/// A canopy's members.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Members {
    /// Side of the hexagon, the length of every member, m.
    pub length: f64,
    /// Stiffness of a spoke, N/m.
    pub spoke_stiffness: f64,
    /// Stiffness of a side, N/m.
    pub side_stiffness: f64,
    /// Mass of a spoke, kg.
    pub spoke_mass: f64,
    /// Mass of a side, kg.
    pub side_mass: f64,
    /// Damping ratio of each.
    pub damping_ratio: f64,
}

/// The members of a canopy of this mass, kg.
pub fn members(canopy: &CanopyLinks, mass: f64) -> Members {
    let spoke_stiffness = HALF_ROOT_3 * canopy.elastic_modulus.si() * canopy.thickness.si();
    Members {
        length: canopy.side.si(),
        spoke_stiffness,
        side_stiffness: 0.5 * spoke_stiffness,
        // half of each mass goes to either end: m/3 on the hub and m/9 on each rim node
        spoke_mass: mass / 9.0,
        side_mass: mass / 18.0,
        damping_ratio: canopy.damping_ratio.si(),
    }
}
