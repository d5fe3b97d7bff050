//! How long the web hangs in the air: the spell about its apex.

use serde::{Deserialize, Serialize};

use crate::spell::Spells;
use crate::summary::Flight;

/// Share of its greatest height above which the web counts as hanging.
const HANGING: f64 = 0.95;

/// Follows the height of the web's centre of mass.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FlightMeasures {
    heights: Vec<(f64, f64)>,
}

impl FlightMeasures {
    /// The height above the muzzle, m, at a record time, s; times ascend.
    pub fn add(&mut self, time: f64, height: f64) {
        if height.is_finite() {
            self.heights.push((time, height));
        }
    }

    /// The apex and the longest spell within 5 % of it. A web that never gets above the muzzle and above where it
    /// started has none.
    pub fn finish(&self) -> Flight {
        let higher = |one: (f64, f64), other: (f64, f64)| if other.1 > one.1 { other } else { one };
        let (Some(&(_, start)), Some((time, apex))) =
            (self.heights.first(), self.heights.iter().copied().reduce(higher))
        else {
            return Flight::default();
        };
        if apex <= 0.0 || apex <= start {
            return Flight::default();
        }
        let mut spells = Spells::default();
        for &(time, height) in &self.heights {
            spells.add(time, height - HANGING * apex);
        }
        let (hanging, _) = spells.finish();
        Flight {
            apex_height_m: Some(apex),
            apex_time_s: Some(time),
            hang_from_s: hanging.map(|(from, _)| from),
            hang_to_s: hanging.map(|(_, to)| to),
            hang_time_s: hanging.map(|(from, to)| to - from),
            still_up: hanging.map(|(_, to)| self.heights.last().is_some_and(|&(last, _)| to >= last)),
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
            flight.add(time, speed * time - 0.5 * gravity * time * time);
        }
        let flight = flight.finish();
        assert!((flight.hang_time_s.unwrap() - 2.0 * speed * 0.05_f64.sqrt() / gravity).abs() < 1e-5);
        assert!((flight.apex_height_m.unwrap() - speed * speed / (2.0 * gravity)).abs() < 1e-5);
        assert_eq!(flight.still_up, Some(false));
    }

    #[test]
    fn what_only_falls_has_no_apex_and_what_only_rises_is_still_up() {
        let followed = |sign: f64| {
            let mut flight = FlightMeasures::default();
            (0..10).for_each(|step| flight.add(step as f64, sign * step as f64));
            flight.finish()
        };
        assert_eq!(followed(-1.0), Flight::default());
        assert_eq!(followed(1.0).still_up, Some(true));
        assert_eq!(FlightMeasures::default().finish(), Flight::default());
    }
}
