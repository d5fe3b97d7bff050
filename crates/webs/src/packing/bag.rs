//! Packs a web into a bag: the rim is drawn in to a radius, the middle hangs below, and the tractors stand on top in
//! the muzzle's plane.
//!
//! ```text
//! r -> a r,   theta -> theta,   z = -gap - depth (1 - r / r_max),   a = radius / r_max
//! ```
//! Here r and theta are polar coordinates about the web's middle in its plane, and r_max is the web's radius. Two
//! points at the distance ds, with radii that differ by dr <= ds, are mapped to points at a distance of at most
//! sqrt(a^2 ds^2 + (depth dr / r_max)^2). No rope is thus stretched if radius^2 + depth^2 <= r_max^2.

use glam::DVec3;

use super::mouth::{Mouth, ROUNDING, size};
use super::{Imperfection, PackingError};
use crate::{CutWeb, Web};

/// Default depth of a bag as a share of the largest possible depth; ropes are then slack.
const DEFAULT_SHARE: f64 = 0.6;

/// Sizes of a bag; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bag {
    /// Radius of the packed web's rim: the circle of its farthest knot.
    pub radius: f64,
    /// Distance from the middle up to the rim; none: 0.6 of the largest possible depth.
    pub depth: Option<f64>,
    /// Where the tractors stand.
    pub mouth: Mouth,
}

impl Bag {
    /// A bag with this radius, m, and default values for the other sizes.
    pub fn of_radius(radius: f64) -> Bag {
        Bag { radius, depth: None, mouth: Mouth::default() }
    }

    pub(super) fn pack(
        &self,
        cut_web: &CutWeb,
        imperfection: Option<&Imperfection>,
    ) -> Result<Vec<DVec3>, PackingError> {
        let web = &cut_web.web;
        let shape = self.shape(web)?;
        let mut packed: Vec<DVec3> = cut_web.nodes.iter().map(|&node| shape.place(node - web.middle)).collect();
        if let Some(imperfection) = imperfection {
            imperfection.disturb(cut_web, &cut_web.is_web(), &mut packed);
        }
        self.mouth.close(cut_web, &mut packed, self.radius)?;
        Ok(packed)
    }

    fn shape(&self, web: &Web) -> Result<BagShape, PackingError> {
        let reach = web.radius();
        if !(self.radius > 0.0 && self.radius <= reach * (1.0 + ROUNDING)) {
            return Err(PackingError::Radius { radius: self.radius, limit: reach });
        }
        let limit = (reach * reach - self.radius * self.radius).max(0.0).sqrt();
        let depth = self.depth.unwrap_or(DEFAULT_SHARE * limit);
        size("depth", "depth", depth)?;
        if depth > limit * (1.0 + ROUNDING) {
            return Err(PackingError::Depth { depth, limit });
        }
        Ok(BagShape { radius: self.radius, depth, reach })
    }
}

/// The shape of a bag with its rim in the plane z = 0; lengths in m.
struct BagShape {
    radius: f64,
    depth: f64,
    /// Radius of the flat web.
    reach: f64,
}

impl BagShape {
    /// Place in the bag of a point of the flat web, given relative to its middle, m.
    fn place(&self, point: DVec3) -> DVec3 {
        let flat = point.truncate();
        (flat * (self.radius / self.reach)).extend(-self.depth * (1.0 - flat.length() / self.reach))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::packing::longest_stretch;
    use crate::samples::SAMPLES;
    use crate::{Cutting, cut, space, square, traditional};

    fn paper_web() -> CutWeb {
        let web = space(2.5, 0.14).unwrap().with_traction(1.0355, 1).unwrap();
        cut(&web, &Cutting::SegmentLength(0.1)).unwrap()
    }

    #[test]
    fn rim_middle_and_tractors_lie_where_the_bag_says() {
        let net = paper_web();
        let bag =
            Bag { radius: 0.25, depth: Some(1.0), mouth: Mouth { tractor_radius: Some(0.4), tractor_gap: Some(0.5) } };
        let packed = bag.pack(&net, None).unwrap();
        let corner = packed[net.web.corners[1]];
        assert!(corner.distance(DVec3::new(0.0, 0.25, -0.5)) < 1e-12);
        assert!(packed[net.web.centre[0]].distance(DVec3::new(0.0, 0.0, -1.5)) < 1e-12);
        assert!(packed[net.web.tractors[1]].distance(DVec3::new(0.0, 0.4, 0.0)) < 1e-12);
        // a traction rope: ten equal steps from corner to tractor
        let nodes = net.nodes_of(net.web.traction[1][0]);
        for pair in nodes.windows(2) {
            let step = packed[pair[1]] - packed[pair[0]];
            assert!(step.distance(DVec3::new(0.0, 0.015, 0.05)) < 1e-12);
        }
    }

    #[test]
    fn the_default_depth_and_gap_are_0_6_of_the_largest() {
        let net = paper_web();
        let packed = Bag::of_radius(0.25).pack(&net, None).unwrap();
        assert!((packed[net.web.corners[0]].z + 0.6 * 1.0355).abs() < 1e-12);
        let depth = 0.6 * (2.5_f64 * 2.5 - 0.25 * 0.25).sqrt();
        assert!((packed[net.web.centre[0]].z + 0.6 * 1.0355 + depth).abs() < 1e-12);
        assert!(longest_stretch(&net, &packed) < 0.0);
    }

    #[test]
    fn at_the_largest_depth_a_radial_rope_is_straight_and_a_larger_depth_is_refused() {
        let net = cut(&traditional(2.5, 6).unwrap(), &Cutting::SegmentLength(0.1)).unwrap();
        // largest depth: sqrt(2.5^2 - 1.5^2) m = 2 m
        let bag = |depth| Bag { depth: Some(depth), ..Bag::of_radius(1.5) }.pack(&net, None);
        let longest = longest_stretch(&net, &bag(2.0).unwrap());
        assert!(longest.abs() < 1e-12, "{longest}");
        match bag(2.001) {
            Err(PackingError::Depth { limit, .. }) => assert!((limit - 2.0).abs() < 1e-12),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn at_the_largest_gap_the_traction_ropes_are_straight_and_a_larger_gap_is_refused() {
        let net = paper_web();
        let bag = |gap| {
            Bag { mouth: Mouth { tractor_radius: Some(0.75), tractor_gap: Some(gap) }, ..Bag::of_radius(0.25) }
                .pack(&net, None)
        };
        let largest = (1.0355_f64 * 1.0355 - 0.25).sqrt();
        assert!(longest_stretch(&net, &bag(largest).unwrap()).abs() < 1e-12);
        match bag(largest + 0.01) {
            Err(PackingError::Gap { limit, .. }) => assert!((limit - largest).abs() < 1e-12),
            other => panic!("{other:?}"),
        }
        let wide = Bag { mouth: Mouth { tractor_radius: Some(1.5), tractor_gap: None }, ..Bag::of_radius(0.25) };
        assert!(matches!(wide.pack(&net, None), Err(PackingError::TractorOutOfReach { .. })));
    }

    #[test]
    fn without_traction_ropes_tractors_lie_at_the_corners() {
        let web = square(2.0, 0.5).unwrap().with_traction(0.0, 1).unwrap();
        let net = cut(&web, &Cutting::SegmentLength(0.25)).unwrap();
        let packed = Bag::of_radius(0.2).pack(&net, None).unwrap();
        for &tractor in &net.web.tractors {
            assert!(packed[tractor].z.abs() < 1e-12);
            assert!((packed[tractor].length() - 0.2).abs() < 1e-12);
        }
    }

    #[test]
    fn sizes_out_of_their_ranges_are_refused() {
        let net = paper_web();
        let bag = Bag::of_radius(0.25);
        for radius in [0.0, -1.0, 2.6, f64::NAN] {
            assert!(matches!(Bag::of_radius(radius).pack(&net, None), Err(PackingError::Radius { .. })));
        }
        let sizes = [
            (Bag { depth: Some(-1.0), ..bag }, "depth"),
            (Bag { mouth: Mouth { tractor_radius: Some(f64::NAN), tractor_gap: None }, ..bag }, "tractor_radius"),
            (Bag { mouth: Mouth { tractor_radius: None, tractor_gap: Some(-0.1) }, ..bag }, "tractor_gap"),
        ];
        for (bag, argument) in sizes {
            let error = bag.pack(&net, None).unwrap_err();
            assert!(matches!(error, PackingError::Size { .. }));
            assert_eq!(error.argument(), argument);
        }
    }

    proptest! {
        #[test]
        fn no_bag_within_its_limits_stretches_any_rope(
            kind in 0..SAMPLES.len(),
            radius_share in 0.02..1.0_f64,
            depth_share in 0.0..1.0_f64,
            segment_length in 0.05..1.0_f64,
            tractor_share in 0.0..1.0_f64,
        ) {
            let web = SAMPLES[kind]().with_traction(1.2, 1).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(segment_length)).unwrap();
            let radius = radius_share * web.radius();
            let depth = depth_share * (web.radius().powi(2) - radius * radius).sqrt();
            let tractor_radius = Some(radius + (2.0 * tractor_share - 1.0) * radius.min(1.1));
            let bag = Bag { radius, depth: Some(depth), mouth: Mouth { tractor_radius, tractor_gap: None } };
            let packed = bag.pack(&net, None).unwrap();
            prop_assert!(longest_stretch(&net, &packed) < 1e-12);
        }
    }
}
