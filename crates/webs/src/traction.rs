//! Traction ropes: from the corners of a web outwards to its tractors.

use crate::error::in_range;
use crate::field::WebField;
use crate::{Class, Knot, Rope, Site, Web, WebError};

const MOST_PARALLEL: usize = 100;

impl Web {
    /// The web with its tractors: each on `count` parallel ropes of this length, m, that run from its corner straight
    /// away from the middle of the web. With no length the tractors are tied to the corners themselves.
    ///
    /// Feature point A is then the middle of the traction rope at the corner nearest to point C (the first corner
    /// without one), unless the web has an A already.
    ///
    /// # Errors
    /// [`WebError::TractionLength`], [`WebError::Count`], [`WebError::NoCorners`], [`WebError::CornerInTheMiddle`],
    /// [`WebError::TractorsTwice`].
    pub fn with_traction(mut self, length: f64, count: usize) -> Result<Web, WebError> {
        if !(length >= 0.0 && length.is_finite()) {
            return Err(WebError::TractionLength { value: length });
        }
        in_range(WebField::TractionCount, count, 1, MOST_PARALLEL)?;
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
                // exactly what the user asked for, not what rounding makes of it
                rest_length: Some(length),
                segments: None,
            }));
            self.traction.push((first..self.ropes.len()).collect());
        }
        let on_rope = Site::OnRope { rope: self.traction[self.feature_corner()][0], fraction: 0.5 };
        self.points.entry("A".into()).or_insert(on_rope);
        Ok(self)
    }

    /// The corner that the feature points belong to.
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
    use crate::{space, square, topological, traditional};

    #[test]
    fn tractors_of_the_three_webs_span_32_476_square_metres() {
        for web in [traditional(2.5, 6).unwrap(), topological(2.5, 0.14).unwrap(), space(2.5, 0.14).unwrap()] {
            let web = web.with_traction(1.0355, 1).unwrap();
            let area = web.tractor_area().unwrap();
            assert!((area - 1.5 * 3.0_f64.sqrt() * 3.5355 * 3.5355).abs() < 1e-9);
            // stated for a length that is rounded to 1.0355 m
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
    fn without_a_length_tractors_sit_on_the_corners() {
        let web = square(2.0, 1.0).unwrap().with_traction(0.0, 1).unwrap();
        assert_eq!(web.tractors, web.corners);
        assert!(web.traction.is_empty() && !web.points.contains_key("A"));
        assert!((web.tractor_area().unwrap() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn wrong_traction_is_refused() {
        let web = || square(2.0, 1.0).unwrap();
        assert!(matches!(web().with_traction(-1.0, 1), Err(WebError::TractionLength { .. })));
        assert!(matches!(web().with_traction(f64::NAN, 1), Err(WebError::TractionLength { .. })));
        assert!(matches!(web().with_traction(1.0, 0), Err(WebError::Count { .. })));
        let twice = web().with_traction(1.0, 1).unwrap().with_traction(1.0, 1);
        assert_eq!(twice, Err(WebError::TractorsTwice));
    }
}
