//! Apex, hang time, drift, touchdown and rest of the web, from the path of its centre of mass.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use super::spell::Spells;
use crate::summary::Flight;

/// The web hangs while its height is above this share of the apex height.
const HANGING: f64 = 0.95;

/// Largest distance from the last position at which the web counts as at rest, m.
const STILL: f64 = 0.05;

/// Follows the web's centre of mass.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FlightMeasures {
    /// At every record: time, s, centre of mass, m, and whether the web touches the ground.
    places: Vec<(f64, DVec3, bool)>,
}

impl FlightMeasures {
    /// Adds the centre of mass, m, at `time`, s, and whether the web touches the ground. Times ascend.
    pub fn add(&mut self, time: f64, place: DVec3, touches: bool) {
        if place.is_finite() {
            self.places.push((time, place, touches));
        }
    }

    /// Apex, longest spell within 5 % of the apex height, drift and landing. A web that never rises above the muzzle and above
    /// its start has no apex.
    pub fn finish(&self) -> Flight {
        let heights = || self.places.iter().map(|(time, place, _)| (*time, place.z));
        let higher = |one: (f64, f64), other: (f64, f64)| if other.1 > one.1 { other } else { one };
        let (Some((_, start)), Some((time, apex))) = (heights().next(), heights().reduce(higher)) else {
            return Flight::default();
        };
        let landed = self.landing(time);
        if apex <= 0.0 || apex <= start {
            return landed;
        }
        let mut spells = Spells::default();
        for (time, height) in heights() {
            spells.add(time, height - HANGING * apex);
        }
        let (hanging, _) = spells.finish();
        Flight {
            apex_height_m: Some(apex),
            apex_time_s: Some(time),
            hang_from_s: hanging.map(|(from, _)| from),
            hang_to_s: hanging.map(|(_, to)| to),
            hang_time_s: hanging.map(|(from, to)| to - from),
            still_up: hanging.map(|(_, to)| self.places.last().is_some_and(|&(last, ..)| to >= last)),
            ..landed
        }
    }

    /// Drift, touchdown after the time `apex`, s, and start of the rest.
    fn landing(&self, apex: f64) -> Flight {
        let [(_, start, _), .., (last, end, lies)] = self.places[..] else { return Flight::default() };
        // a web that lies on the ground at the start does not touch it yet at the first record
        let mut flying = self.places.iter().skip(1).skip_while(|(.., touches)| *touches);
        let touch = flying.find(|(time, _, touches)| *time > apex && *touches);
        let moves = self.places.iter().rposition(|(_, place, _)| place.distance(end) > STILL);
        let still = self.places.get(moves.map_or(0, |last| last + 1)).filter(|(time, ..)| lies && *time < last);
        let drift = (end - start).truncate();
        Flight {
            drift_m: Some(drift.length()),
            drift_azimuth_rad: (drift != DVec2::ZERO).then(|| libm::atan2(drift.y, drift.x)),
            touches_down_s: touch.map(|(time, ..)| *time),
            lies_from_s: still.map(|(time, ..)| *time),
            ..Flight::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stone_thrown_up_hangs_for_the_time_that_the_parabola_gives() {
        // z = v t - g t^2 / 2 stays above 95 % of v^2 / 2g for 2 v sqrt(0.05) / g
        let (speed, gravity): (f64, f64) = (10.0, 9.80665);
        let mut flight = FlightMeasures::default();
        for step in 0..=2000 {
            let time = step as f64 * 1e-3;
            flight.add(time, (speed * time - 0.5 * gravity * time * time) * DVec3::Z, false);
        }
        let flight = flight.finish();
        assert!((flight.hang_time_s.unwrap() - 2.0 * speed * 0.05_f64.sqrt() / gravity).abs() < 1e-5);
        assert!((flight.apex_height_m.unwrap() - speed * speed / (2.0 * gravity)).abs() < 1e-5);
        assert_eq!(flight.still_up, Some(false));
    }

    #[test]
    fn a_stone_in_a_wind_comes_down_and_lies_where_it_has_drifted_to() {
        let mut flight = FlightMeasures::default();
        for step in 0..=300 {
            let time = (f64::from(step) * 0.01).min(2.0);
            let place = DVec3::new(0.0, 3.0 * time, 9.81 * time - 0.5 * 9.81 * time * time);
            flight.add(f64::from(step) * 0.01, place, place.z <= 0.0);
        }
        let flight = flight.finish();
        // it touches the ground at the start too
        assert_eq!(
            (flight.touches_down_s, flight.lies_from_s.map(|from| (from * 100.0).round())),
            (Some(2.0), Some(200.0))
        );
        assert_eq!((flight.drift_m, flight.drift_azimuth_rad), (Some(6.0), Some(std::f64::consts::FRAC_PI_2)));
    }

    /// Measures of these places, m, and contacts with the ground, at one record a second.
    fn followed(records: impl IntoIterator<Item = (DVec3, bool)>) -> Flight {
        let mut flight = FlightMeasures::default();
        for (time, (place, touches)) in (0..).zip(records) {
            flight.add(f64::from(time), place, touches);
        }
        flight.finish()
    }

    #[test]
    fn a_web_that_starts_on_the_ground_has_no_touchdown() {
        // settles by less than 5 cm; the first record is from before it is pressed into the ground
        let lying = followed((0..5).map(|second| (DVec3::X - 1e-3 * f64::from(second) * DVec3::Z, second > 0)));
        assert_eq!((lying.touches_down_s, lying.lies_from_s), (None, Some(0.0)));
        let hanging = followed([(DVec3::ZERO, false); 5]);
        assert_eq!((hanging.touches_down_s, hanging.lies_from_s), (None, None));
        // dropped, it bounces once
        let heights = [(4.0, false), (3.0, false), (0.0, true), (0.5, false), (0.0, true), (0.0, true)];
        let dropped = followed(heights.map(|(height, touches)| (height * DVec3::Z, touches)));
        assert_eq!((dropped.touches_down_s, dropped.lies_from_s), (Some(2.0), Some(4.0)));
        // on the ground at the last record, and not yet at rest
        assert_eq!(followed(heights[..3].iter().map(|&(z, touches)| (z * DVec3::Z, touches))).lies_from_s, None);
    }

    #[test]
    fn a_web_that_only_rises_or_falls_has_no_drift_azimuth() {
        let drift = |to: DVec3| {
            let flight = followed([(DVec3::ZERO, false), (to, false)]);
            (flight.drift_m, flight.drift_azimuth_rad)
        };
        assert_eq!(drift(3.0 * DVec3::Z), (Some(0.0), None));
        assert_eq!(drift(DVec3::new(-2.0, 0.0, 3.0)), (Some(2.0), Some(std::f64::consts::PI)));
    }

    #[test]
    fn a_web_that_only_falls_has_no_apex_and_one_that_only_rises_is_still_up() {
        let along = |sign: f64| followed((0..10).map(|step| (sign * f64::from(step) * DVec3::Z, false)));
        assert_eq!(along(-1.0).apex_height_m, None);
        assert_eq!(along(1.0).still_up, Some(true));
        assert_eq!(FlightMeasures::default().finish(), Flight::default());
    }
}
