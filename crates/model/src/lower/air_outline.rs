//! What the air comes to.

/// What the air comes to, for those who look at it.
#[derive(Debug, Clone, PartialEq)]
pub struct AirOutline {
    /// Fastest that anything is thrown, m/s.
    pub launch_speed: f64,
    /// Share that the web's ropes take of the area within its outline as drawn; none where it has no outline.
    pub drawn_solidity: Option<f64>,
    /// The solidity by which the drag of its ropes is that of a screen; none where each drags as if alone.
    pub solidity: Option<f64>,
    /// Bodies that a canopy hides.
    pub hidden: usize,
    /// Bodies without size that no canopy hides: nothing drags at them.
    pub sizeless: usize,
    /// Upward force of the medium on all that it buoys up, N.
    pub buoyancy: f64,
    /// Of that, on the web without traction ropes and tractors.
    pub web_buoyancy: f64,
}
