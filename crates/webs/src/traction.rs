//! Adds tractors to a web, on traction ropes that run outwards from its corners.

use crate::error::in_range;
use crate::{Class, Knot, Rope, Site, Web, WebError};

const MOST_PARALLEL: usize = 100;

impl Web {
    /// The web with a tractor at each corner, on `count` parallel ropes of this length, m. The ropes run from the
    /// corner straight away from the middle of the web. With a length of 0 the tractors are tied straight to the
    /// corners.
    ///
    /// Feature point A is the middle of the traction rope at the corner nearest to point C or, without a point C, at
    /// the first corner. A point A that the web already has stays.
    ///
    /// # Errors
    /// [`WebError::Argument`]: `length` or `count` is out of its range; [`WebError::NoCorners`],
    /// [`WebError::CornerInTheMiddle`], [`WebError::TractorsTwice`].
    pub fn with_traction(mut self, length: f64, count: usize) -> Result<Web, WebError> {
        if !(length >= 0.0 && length.is_finite()) {
            return Err(WebError::argument(
                "length",
                format!(
                    "the traction ropes' length must be zero (tractors tied straight to the corners) or positive, not \
                     {length} m"
                ),
            ));
        }
        in_range("count", "the number of parallel traction ropes", count, 1..=MOST_PARALLEL)?;
        if self.corners.is_empty() {
            return Err(WebError::NoCorners);
        }
        if !self.tractors.is_empty() {
            return Err(WebError::TractorsTwice);
        }
        if length == 0.0 {
            self.tractors = self.corners.clone();
            return Ok(self);
        }

        for number in 1..=self.corners.len() {
            let corner = self.corners[number - 1];
            let start = self.knots[corner].position;
            let outwards = (start - self.middle).with_z(0.0).try_normalize();
            let Some(outwards) = outwards else {
                return Err(WebError::CornerInTheMiddle { corner: self.knots[corner].label.clone() });
            };
            let tractor = self.knots.len();
            self.knots.push(Knot::new(format!("tractor {number}"), start + outwards * length));
            self.tractors.push(tractor);
            let first = self.ropes.len();
            self.ropes.extend((1..=count).map(|strand| Rope {
                a: corner,
                b: tractor,
                class: Class::Traction,
                label: match count {
                    1 => format!("traction rope {number}"),
                    _ => format!("traction rope {number} ({strand} of {count})"),
                },
                // the distance of the knots differs from this by rounding
                rest_length: Some(length),
                segments: None,
            }));
            self.traction.push((first..self.ropes.len()).collect());
        }
        let on_rope = Site::OnRope { rope: self.traction[self.feature_corner()][0], fraction: 0.5 };
        self.points.entry("A".into()).or_insert(on_rope);
        Ok(self)
    }

    /// The corner nearest to feature point C, as an index into the corners; the first without a point C.
    fn feature_corner(&self) -> usize {
        let Some(&point) = self.points.get("C") else { return 0 };
        let distance = |corner: usize| self.knots[self.corners[corner]].position.distance(self.position(point));
        (0..self.corners.len()).min_by(|&one, &other| distance(one).total_cmp(&distance(other))).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::error::refused;
    use crate::{space, square, topological, traditional};

    #[test]
    fn tractors_of_the_three_webs_span_32_476_square_metres() {
        for web in [traditional(2.5, 6).unwrap(), topological(2.5, 0.14).unwrap(), space(2.5, 0.14).unwrap()] {
            let web = web.with_traction(1.0355, 1).unwrap();
            let area = web.tractor_area().unwrap();
            assert!((area - 1.5 * 3.0_f64.sqrt() * 3.5355 * 3.5355).abs() < 1e-9);
            // 32.476 m^2 is for a length before it was rounded to 1.0355 m
            assert!((area - 32.476).abs() < 1e-3);
            assert!((web.rope_length_by_class()[&Class::Traction] - 6.0 * 1.0355).abs() < 1e-12);
            assert_eq!(web.check(), []);
        }
    }

    #[test]
    fn point_a_is_on_the_traction_rope_of_the_corner_at_90_degrees() {
        for web in [traditional(2.5, 6).unwrap(), topological(2.5, 0.14).unwrap(), space(2.5, 0.14).unwrap()] {
            let web = web.with_traction(1.0, 1).unwrap();
            assert!(web.position(web.points["A"]).distance(DVec3::new(0.0, 3.0, 0.0)) < 1e-12);
        }
    }

    #[test]
    fn parallel_ropes_share_both_knots() {
        let web = square(2.0, 0.5).unwrap().with_traction(2.0_f64.sqrt(), 3).unwrap();
        assert_eq!(web.tractors.len(), 4);
        assert_eq!(web.traction[1].len(), 3);
        for &rope in &web.traction[1] {
            assert_eq!((web.ropes[rope].a, web.ropes[rope].b), (web.corners[1], web.tractors[1]));
        }
        assert_eq!(web.ropes[web.traction[1][2]].label, "traction rope 2 (3 of 3)");
        assert!(web.knots[web.tractors[1]].position.distance(DVec3::new(-2.0, 2.0, 0.0)) < 1e-12);
        assert!((web.radius() - 2.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn with_a_length_of_0_tractors_are_tied_straight_to_the_corners() {
        let web = square(2.0, 1.0).unwrap().with_traction(0.0, 1).unwrap();
        assert_eq!(web.tractors, web.corners);
        assert!(web.traction.is_empty() && !web.points.contains_key("A"));
        assert!((web.tractor_area().unwrap() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn wrong_lengths_counts_and_second_tractors_are_refused() {
        let web = || square(2.0, 1.0).unwrap();
        assert_eq!(refused(web().with_traction(-1.0, 1)), Some("length"));
        assert_eq!(refused(web().with_traction(f64::NAN, 1)), Some("length"));
        assert_eq!(refused(web().with_traction(1.0, 0)), Some("count"));
        let twice = web().with_traction(1.0, 1).unwrap().with_traction(1.0, 1);
        assert_eq!(twice, Err(WebError::TractorsTwice));
    }
}
