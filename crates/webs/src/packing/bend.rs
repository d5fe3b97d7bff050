//! Bends of a sheet, a plane or a stack of layers: laid back and forth, or rolled up.
//!
//! A sheet of layers is described by s along it and the offset o from its middle layer, |o| <= reach, o growing to the
//! left of s. A bend maps (s, o) to a plane. Along a straight piece the map is a rigid motion. Along an arc of radius R
//! a point keeps its distance r = R -+ o from the centre, and the arc is passed at ds = (R + reach) d(angle): the
//! outermost layer keeps its length, the inner ones are slack. So the derivative along s has the length
//! r / (R + reach) <= 1, that along o the length 1, and the two are normal to each other: no two points of the sheet,
//! a convex set, come to lie farther apart than they were.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};

/// A sheet laid back and forth: straight legs, each `pitch` beside the last, joined by half circles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Serpentine {
    /// Length of the straight part of a leg, m.
    leg: f64,
    /// Distance between the middle layers of neighbouring legs, m.
    pitch: f64,
    /// Largest distance of a layer from the middle one, m.
    reach: f64,
    /// Number of legs.
    legs: f64,
}

impl Serpentine {
    /// A serpentine that lays a sheet of this length within `span` along its legs, as far as bends of its own
    /// thickness leave room for it. A sheet that is no longer than `span` has one leg.
    pub fn within(span: f64, length: f64, pitch: f64, reach: f64) -> Serpentine {
        if length <= span {
            return Serpentine { leg: length, pitch, reach, legs: 1.0 };
        }
        let leg = (span - pitch - 2.0 * reach).max(0.0);
        let bend = PI * (0.5 * pitch + reach);
        Serpentine { leg, pitch, reach, legs: ((length + bend) / (leg + bend)).ceil() }
    }

    /// `legs` legs of length `leg`, m, in a single layer.
    pub fn of(legs: f64, leg: f64, pitch: f64) -> Serpentine {
        Serpentine { leg, pitch, reach: 0.0, legs }
    }

    /// Number of legs.
    pub fn legs(&self) -> f64 {
        self.legs
    }

    /// Length of the sheet along the serpentine, m.
    pub fn length(&self) -> f64 {
        self.legs * self.leg + (self.legs - 1.0) * self.bend()
    }

    fn bend(&self) -> f64 {
        PI * (0.5 * self.pitch + self.reach)
    }

    /// Position of a point of the sheet, m: x along the legs, y across them, both from the beginning of the middle
    /// layer.
    pub fn place(&self, s: f64, offset: f64) -> DVec2 {
        let period = self.leg + self.bend();
        let number = (s / period).floor().clamp(0.0, self.legs - 1.0);
        let along = s - number * period;
        let is_outward = number % 2.0 == 0.0;
        let (sign, start) = if is_outward { (1.0, 0.0) } else { (-1.0, self.leg) };
        let middle = number * self.pitch;
        if along <= self.leg || number == self.legs - 1.0 {
            return dvec2(start + sign * along, middle + sign * offset);
        }
        let angle = (along - self.leg) / (0.5 * self.pitch + self.reach);
        let radius = 0.5 * self.pitch - sign * offset;
        let end = start + sign * self.leg;
        dvec2(end + sign * radius * libm::sin(angle), middle + 0.5 * self.pitch - radius * libm::cos(angle))
    }
}

/// A sheet rolled up from its middle, both halves together: two spirals of half circles that are each other's image
/// under half a turn. Neighbouring windings lie `pitch` apart. The k-th half circle of a half has the radius
/// (k - 1/2) `pitch`; its centre is `pitch` / 2 beside the middle, on alternate sides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Roll {
    /// Distance between the middle layers of neighbouring windings, m.
    pub pitch: f64,
    /// Largest distance of a layer from the middle one, m.
    pub reach: f64,
}

impl Roll {
    /// Position of a point of the sheet, m; s counts from its middle, which stays at the origin.
    pub fn place(&self, s: f64, offset: f64) -> DVec2 {
        if s < 0.0 { -self.half(-s, -offset) } else { self.half(s, offset) }
    }

    fn half(&self, s: f64, offset: f64) -> DVec2 {
        // k half circles take pi (pitch k^2 / 2 + reach k)
        let taken = |k: f64| PI * (0.5 * self.pitch * k + self.reach) * k;
        let root = (self.reach * self.reach + 2.0 * self.pitch * s / PI).sqrt();
        let mut before = ((root - self.reach) / self.pitch).floor().max(0.0);
        if taken(before) > s {
            before -= 1.0; // rounding
        }
        let sign = if before % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let middle = (before + 0.5) * self.pitch;
        let angle = (s - taken(before)) / (middle + self.reach);
        let radius = middle - offset;
        sign * dvec2(radius * libm::sin(angle), 0.5 * self.pitch - radius * libm::cos(angle))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_serpentine_of_three_legs() {
        let bend = PI * 0.5;
        let laid = Serpentine::within(5.0, 12.0 + 2.0 * bend, 1.0, 0.0);
        assert_eq!(laid.legs(), 3.0);
        assert!((laid.length() - 12.0 - 2.0 * bend).abs() < 1e-12);
        let near = |s: f64, x: f64, y: f64| assert!(laid.place(s, 0.0).distance(dvec2(x, y)) < 1e-12, "{s}");
        near(0.0, 0.0, 0.0);
        near(4.0, 4.0, 0.0);
        near(4.0 + 0.5 * bend, 4.5, 0.5);
        near(4.0 + bend, 4.0, 1.0);
        near(8.0 + 1.5 * bend, -0.5, 1.5);
        near(8.0 + 2.0 * bend, 0.0, 2.0);
        near(12.0 + 2.0 * bend, 4.0, 2.0);
    }

    #[test]
    fn a_roll_passes_its_middle_line_once_a_pitch() {
        let roll = Roll { pitch: 0.2, reach: 0.07 };
        let mut taken = 0.0;
        for k in 0..20 {
            let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
            let (here, there) = (roll.place(taken, 0.0), roll.place(-taken, 0.0));
            assert!(here.distance(dvec2(0.0, sign * 0.2 * f64::from(k))) < 1e-12, "{k}: {here}");
            assert!(there.distance(-here) < 1e-12);
            taken += PI * (0.2 * (f64::from(k) + 0.5) + 0.07);
        }
    }

    proptest! {
        #[test]
        fn neither_bend_moves_two_points_of_a_sheet_apart(
            span in 0.01..2.0_f64, pitch in 0.01..0.5_f64, thin in 0.0..1.0_f64,
            one in (0.0..1.0_f64, -1.0..1.0_f64), other in (0.0..1.0_f64, -1.0..1.0_f64), near in any::<bool>(),
        ) {
            let (length, reach) = (5.0, 0.5 * pitch * thin);
            let other = if near { (one.0 + 0.01 * other.0, one.1) } else { other };
            let [a, b] = [one, other].map(|(s, o)| dvec2(s * length, o * reach));
            let serpentine = Serpentine::within(span, length, pitch, reach);
            let roll = Roll { pitch, reach };
            let apart = a.distance(b) + 1e-12;
            prop_assert!(serpentine.place(a.x, a.y).distance(serpentine.place(b.x, b.y)) <= apart);
            let place = |p: DVec2| roll.place(p.x - 2.0, p.y);
            prop_assert!(place(a).distance(place(b)) <= apart);
        }
    }
}
