//! Key figures of the air.

/// Key figures of the air, for reports.
#[derive(Debug, Clone, PartialEq)]
pub struct AirOutline {
    /// Largest speed at which anything is thrown or driven, m/s.
    pub launch_speed: f64,
    /// Solidity of the flat web: share of the area within its outline that ropes cover. None without an outline.
    pub drawn_solidity: Option<f64>,
    /// Solidity of the screen that the web's ropes drag as; none where each rope drags as if alone.
    pub solidity: Option<f64>,
    /// Number of bodies that a canopy hides.
    pub hidden: usize,
    /// Number of bodies without size that no canopy hides: they have no drag.
    pub sizeless: usize,
    /// Buoyancy of the whole net, N.
    pub buoyancy: f64,
    /// Buoyancy of the web without traction ropes and tractors, N.
    pub web_buoyancy: f64,
}
