//! An element: a force between a few nodes, such as a bend or a triangle of a sheet. Ropes have segments instead.
//!
//! Bending joins three nodes, a piece of sheet three, a hinge between two of them four. An element gives its forces at
//! one instant; [`crate::effects`] gathers its nodes, sums the forces, and counts the energy that they lose.

use glam::DVec3;

/// Forces of an element on its nodes at one instant, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementForces<const N: usize> {
    /// The part that derives from its elastic energy.
    pub elastic: [DVec3; N],
    /// The rest, whose work is lost.
    pub dissipative: [DVec3; N],
}

impl<const N: usize> ElementForces<N> {
    /// No force.
    pub const NONE: ElementForces<N> = ElementForces { elastic: [DVec3::ZERO; N], dissipative: [DVec3::ZERO; N] };
}

/// An element between `N` nodes.
pub trait Element<const N: usize>: Sync {
    /// Its nodes.
    fn nodes(&self) -> [usize; N];

    /// Forces on its nodes, which are at `x`, m, and move at `w`, m/s.
    fn pull(&self, x: [DVec3; N], w: [DVec3; N]) -> ElementForces<N>;

    /// Elastic energy, J, with its nodes at `x`, m.
    fn elastic_energy(&self, x: [DVec3; N]) -> f64;

    /// A bound on its stiffness, N/m, node by node: for any displacements u of its nodes the second derivative of its
    /// energy along u is at most the sum of 2 k |u|^2. A segment's is its k at each end.
    fn stiffness(&self) -> [f64; N];

    /// The same for its damping, N s/m.
    fn damping(&self) -> [f64; N];
}

/// A property of an element, as an error names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Property {
    /// Poisson ratio.
    PoissonRatio,
    /// Elastic modulus along the fibres.
    ModulusAlong,
    /// Elastic modulus across the fibres.
    ModulusAcross,
    /// Shear modulus.
    ShearModulus,
    /// Angle of the fibres.
    FibreAngle,
    /// Thickness.
    Thickness,
    /// Area at rest.
    RestArea,
    /// Area at rest on one side of a hinge.
    AreaLeft,
    /// Area at rest on the other side of a hinge.
    AreaRight,
    /// Length of an edge.
    Edge,
    /// Length at rest.
    RestLength,
    /// Flexural rigidity.
    FlexuralRigidity,
    /// Bending stiffness.
    BendingStiffness,
    /// Damping time.
    DampingTime,
}

impl Property {
    /// All of them.
    pub const ALL: [Property; 14] = [
        Property::PoissonRatio,
        Property::ModulusAlong,
        Property::ModulusAcross,
        Property::ShearModulus,
        Property::FibreAngle,
        Property::Thickness,
        Property::RestArea,
        Property::AreaLeft,
        Property::AreaRight,
        Property::Edge,
        Property::RestLength,
        Property::FlexuralRigidity,
        Property::BendingStiffness,
        Property::DampingTime,
    ];
}

impl std::fmt::Display for Property {
    /// In words, with its unit.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Property::PoissonRatio => "Poisson ratio",
            Property::ModulusAlong => "elastic modulus along the fibres, Pa,",
            Property::ModulusAcross => "elastic modulus across the fibres, Pa,",
            Property::ShearModulus => "shear modulus, Pa,",
            Property::FibreAngle => "fibre angle, rad,",
            Property::Thickness => "thickness, m,",
            Property::RestArea => "rest area, m^2,",
            Property::AreaLeft => "rest area, m^2, to the left of a hinge",
            Property::AreaRight => "rest area, m^2, to the right of a hinge",
            Property::Edge => "edge, m,",
            Property::RestLength => "rest length, m,",
            Property::FlexuralRigidity => "flexural rigidity, N m,",
            Property::BendingStiffness => "bending stiffness, N m^2,",
            Property::DampingTime => "damping time, s,",
        })
    }
}

/// Why an element cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ElementError {
    /// A property is out of range or not a number.
    #[error("an element has a {what} of {value}")]
    Property {
        /// Which property.
        what: Property,
        /// Its value.
        value: f64,
    },
    /// A node occurs twice.
    #[error("an element has node {node} twice")]
    Repeated {
        /// Which node.
        node: usize,
    },
}

/// The value, if `holds` and it is finite.
pub(super) fn checked(what: Property, value: f64, holds: bool) -> Result<f64, ElementError> {
    if holds && value.is_finite() { Ok(value) } else { Err(ElementError::Property { what, value }) }
}

/// The value, if it is positive.
pub(super) fn positive(what: Property, value: f64) -> Result<f64, ElementError> {
    checked(what, value, value > 0.0)
}

/// The value, if it is zero or positive.
pub(super) fn not_negative(what: Property, value: f64) -> Result<f64, ElementError> {
    checked(what, value, value >= 0.0)
}

/// The nodes, if each occurs once.
pub(super) fn distinct<const N: usize>(nodes: [usize; N]) -> Result<[usize; N], ElementError> {
    match nodes.iter().enumerate().find(|&(i, node)| nodes[..i].contains(node)) {
        Some((_, &node)) => Err(ElementError::Repeated { node }),
        None => Ok(nodes),
    }
}
