//! A gathering rope: the drawstring of a purse, a second rope along the outline.
//!
//! A real drawstring slides in rings. Here there is no contact: the rope is tied to every n-th knot of the outline, and
//! between two ties it is longer than the outline by a chosen share.

use crate::rope_list::RopeList;
use crate::{Class, Web, WebError};

impl Web {
    /// The web with a gathering rope round its outline. The rope is tied to the corners and between them to every
    /// `every`-th knot. Its rest length between two ties is their distance times (1 + `excess`). Class: gathering.
    ///
    /// # Errors
    /// [`WebError::Argument`]: `excess` is negative or not finite; `every` does not divide the number of meshes of a
    /// side; the outline does not begin at a corner, or a vertex of it has several knots.
    pub fn with_gathering(mut self, every: usize, excess: f64) -> Result<Web, WebError> {
        if !(excess >= 0.0 && excess.is_finite()) {
            let fault = format!("the excess of a gathering rope must be 0 or more, not {excess}");
            return Err(WebError::argument("excess", fault));
        }
        let knots = self.outline.len();
        let ties: Vec<usize> = self.outline.iter().step_by(every.max(1)).flatten().copied().collect();
        let is_even = knots.is_multiple_of(every) && self.outline.iter().all(|vertex| vertex.len() == 1);
        if !is_even || !self.corners.iter().all(|corner| ties.contains(corner)) {
            let meshes = knots / self.corners.len().max(1);
            return Err(WebError::argument(
                "every",
                format!(
                    "a gathering rope tied to every {every} knots would miss corners of the web: {every} does not divide \
                     the {meshes} meshes of a side"
                ),
            ));
        }
        let closed: Vec<usize> = ties.iter().chain(&ties[..1]).copied().collect();
        let mut ropes = RopeList::default();
        ropes.tie_along(&closed, Class::Gathering);
        let mut ropes = ropes.into_ropes();
        if excess > 0.0 {
            for rope in &mut ropes {
                rope.rest_length = Some(self.drawn_length(rope) * (1.0 + excess));
            }
        }
        self.ropes.extend(ropes);
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::error::refused;
    use crate::symmetry::{is_mirrored, is_turned};
    use crate::{Bag, Cutting, Pattern, cut, square, topological};

    #[test]
    fn a_rope_tied_to_every_second_knot_has_its_pieces_labels_and_length() {
        let plain = square(5.0, 0.5).unwrap();
        let web = plain.clone().with_gathering(2, 0.1).unwrap();
        let of = |class| web.ropes.iter().filter(|rope| rope.class == class).collect::<Vec<_>>();
        let pieces = of(Class::Gathering);
        assert_eq!((pieces.len(), pieces[0].label.as_str()), (20, "gathering rope 1"));
        assert!(pieces.iter().all(|rope| (web.drawn_length(rope) - 1.0).abs() < 1e-12));
        assert!((web.rope_length_by_class()[&Class::Gathering] - 22.0).abs() < 1e-12);
        // the rest of the web is unchanged
        assert_eq!((&web.knots, &web.ropes[..220], &web.points), (&plain.knots, &plain.ropes[..], &plain.points));
        assert_eq!(web.check(), []);
    }

    #[test]
    fn a_gathering_rope_adds_no_cells() {
        for (every, excess) in [(1, 0.0), (2, 0.3), (10, 0.0)] {
            let web = square(5.0, 0.5).unwrap().with_gathering(every, excess).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(0.25)).unwrap();
            assert_eq!(net.cells().len(), 100, "{every}");
        }
    }

    #[test]
    fn ties_that_miss_the_corners_are_refused() {
        let net = || square(5.0, 0.5).unwrap();
        for every in [0, 3, 4, 8, 20, 40] {
            assert_eq!(refused(net().with_gathering(every, 0.1)), Some("every"), "{every}");
        }
        let error = net().with_gathering(3, 0.1).unwrap_err().to_string();
        let expected = "a gathering rope tied to every 3 knots would miss corners of the web: 3 does not divide the 10 \
                        meshes of a side";
        assert_eq!(error, expected);
        for excess in [-0.1, f64::NAN, f64::INFINITY] {
            assert_eq!(refused(net().with_gathering(2, excess)), Some("excess"));
        }
        // a vertex of this outline has six knots
        assert!(topological(2.5, 0.14).unwrap().with_gathering(1, 0.1).is_err());
    }

    proptest! {
        #[test]
        fn a_gathering_rope_has_its_length_keeps_the_symmetry_and_is_not_stretched_in_a_bag(
            share in 1..6_usize, ties in 1..6_usize, excess in 0.0..0.5_f64,
        ) {
            let side = (share * ties) as f64;
            let web = square(side, 1.0).unwrap().with_gathering(share, excess).unwrap();
            let length = web.rope_length_by_class()[&Class::Gathering];
            prop_assert!((length - 4.0 * side * (1.0 + excess)).abs() < 1e-9);
            prop_assert!(is_turned(&web, 4) && is_mirrored(&web));
            let net = cut(&web, &Cutting::SegmentLength(0.3)).unwrap();
            let packed = Pattern::Bag(Bag::of_radius(0.2 * side)).pack(&net).unwrap();
            for segment in net.segments() {
                prop_assert!(packed[segment.a].distance(packed[segment.b]) <= segment.rest_length * (1.0 + 1e-12));
            }
        }
    }
}
