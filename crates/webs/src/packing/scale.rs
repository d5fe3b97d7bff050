//! Scales a flat web about its middle. Rest lengths stay, so that every rope is slack by the same share of its length.

use glam::DVec3;

use super::PackingError;
use crate::CutWeb;

/// The factor of a scaled web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Distances in the packed web over distances in the flat web: more than 0, at most 1.
    pub factor: f64,
}

impl Scale {
    pub(super) fn pack(&self, cut_web: &CutWeb) -> Result<Vec<DVec3>, PackingError> {
        if !(self.factor > 0.0 && self.factor <= 1.0) {
            return Err(PackingError::Factor(self.factor));
        }
        let middle = cut_web.web.middle;
        Ok(cut_web.nodes.iter().map(|&node| middle + (node - middle) * self.factor).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cutting, cut, square};

    #[test]
    fn distances_shrink_by_the_factor() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        let packed = Scale { factor: 0.25 }.pack(&net).unwrap();
        for segment in net.segments() {
            let length = packed[segment.a].distance(packed[segment.b]);
            assert!((length - 0.25 * segment.rest_length).abs() < 1e-15);
        }
        assert_eq!(Scale { factor: 1.0 }.pack(&net).unwrap(), net.nodes);
    }

    #[test]
    fn factors_not_above_0_or_above_1_are_refused() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        for factor in [0.0, -0.5, 1.1, f64::NAN] {
            assert!(matches!(Scale { factor }.pack(&net), Err(PackingError::Factor(_))));
        }
    }
}
