//! The container of a prescribed packing: a tube about the launch axis, with a wall that closes in while nodes are
//! driven.

use std::f64::consts::PI;

use glam::DVec3;

/// An upright tube about the launch axis with its mouth in the plane z = 0. Lengths in m, times in s.
pub(super) struct Tube {
    /// Radius of the wall at time 0.
    pub first_radius: f64,
    /// Radius of the wall from `closing_time` on.
    pub radius: f64,
    /// Time at which the wall has closed in; 0: closed from the start.
    pub closing_time: f64,
    /// Distance from the floor up to z = 0; none: there is no floor.
    pub depth: Option<f64>,
}

impl Tube {
    /// Radius of the wall at a time, s, in m. The speed of the wall is half a sine wave in time.
    pub fn radius_at(&self, time: f64) -> f64 {
        let Self { first_radius, radius, closing_time, .. } = *self;
        let share = if closing_time > 0.0 { 0.5 * (1.0 - libm::cos(PI * (time / closing_time).min(1.0))) } else { 1.0 };
        first_radius + share * (radius - first_radius)
    }

    /// Moves a place, m, to the nearest point inside a wall of this radius, m, and above the floor.
    pub fn push_inside(&self, wall: f64, place: &mut DVec3) {
        let away = place.truncate().length();
        if away > wall {
            (place.x, place.y) = (place.x * wall / away, place.y * wall / away);
        }
        if let Some(depth) = self.depth {
            place.z = place.z.max(-depth);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUBE: Tube = Tube { first_radius: 2.0, radius: 0.5, closing_time: 3.0, depth: Some(1.0) };

    #[test]
    fn the_wall_is_half_closed_at_half_time_and_then_stays_closed() {
        assert_eq!(TUBE.radius_at(0.0), 2.0);
        assert!((TUBE.radius_at(1.5) - 1.25).abs() < 1e-12);
        assert_eq!((TUBE.radius_at(3.0), TUBE.radius_at(7.0)), (0.5, 0.5));
        assert_eq!(Tube { closing_time: 0.0, ..TUBE }.radius_at(0.0), 0.5);
    }

    #[test]
    fn a_node_outside_moves_to_the_nearest_point_of_wall_and_floor() {
        let pushed = |x: f64, y: f64, z: f64, tube: &Tube| {
            let mut place = DVec3::new(x, y, z);
            tube.push_inside(0.5, &mut place);
            place
        };
        assert!(pushed(3.0, 4.0, -2.0, &TUBE).distance(DVec3::new(0.3, 0.4, -1.0)) < 1e-15);
        assert_eq!(pushed(0.3, 0.1, 2.0, &TUBE), DVec3::new(0.3, 0.1, 2.0));
        assert_eq!(pushed(0.0, 0.0, -9.0, &Tube { depth: None, ..TUBE }).z, -9.0);
    }
}
