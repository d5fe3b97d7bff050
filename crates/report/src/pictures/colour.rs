//! The colours of tension: a colour map for light and dark pages, cut into bins.
//!
//! Rope tensions of one launch span five decades, from 1 N to a peak of 100 kN, so a linear scale would show one
//! colour. The limits of the bins are 1, 2, 5, 10, …: twelve colours cover four decades.

use super::series;

/// The colour map from low to high, blue to magenta to orange. Lightness rises in OKLCH, so that the colours differ for
/// every kind of colour vision and in grey. The contrast is at least 2.6 on white and on the page's dark card.
const STOPS: [[u8; 3]; 9] = [
    [0x19, 0x57, 0xd2],
    [0x5d, 0x51, 0xd9],
    [0x88, 0x4c, 0xd4],
    [0xac, 0x48, 0xc4],
    [0xca, 0x46, 0xab],
    [0xe3, 0x47, 0x8c],
    [0xf5, 0x50, 0x67],
    [0xff, 0x62, 0x37],
    [0xf6, 0x80, 0x01],
];

/// Number of bins of tension, one colour each.
pub(crate) const BINS: usize = 12;

/// A rope is slack below this tension, N: so small a value is the rounding error of a length.
pub(crate) const SLACK_BELOW: f64 = 1e-6;

/// The bins of tension that a set of pictures shares.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TensionScale {
    /// Limits of the bins, N, ascending.
    edges: [f64; BINS + 1],
}

impl TensionScale {
    /// The scale whose last bin holds `largest`, N.
    pub fn up_to(largest: f64) -> Self {
        let top = series::place_of(largest);
        Self { edges: std::array::from_fn(|bin| series::number(top - (BINS - bin) as i32)) }
    }

    /// The bin of a tension, N; none for a slack rope. Tensions beyond the limits are in the end bins.
    pub fn bin(&self, tension: f64) -> Option<usize> {
        let passed = self.edges[1..BINS].iter().filter(|&&edge| tension >= edge).count();
        (tension >= SLACK_BELOW).then_some(passed)
    }

    /// Limits of the bins, N, ascending.
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }
}

/// The colour of a bin, as red, green and blue.
pub(crate) fn bin_colour(bin: usize) -> [u8; 3] {
    // interpolate in whole numbers
    let (below, between) = (bin * (STOPS.len() - 1) / (BINS - 1), bin * (STOPS.len() - 1) % (BINS - 1));
    let above = (below + 1).min(STOPS.len() - 1);
    let mix = |channel: usize| {
        let (from, to) = (usize::from(STOPS[below][channel]), usize::from(STOPS[above][channel]));
        ((from * (BINS - 1 - between) + to * between + (BINS - 1) / 2) / (BINS - 1)) as u8
    };
    [mix(0), mix(1), mix(2)]
}

/// A colour as SVG writes it.
pub(crate) fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_belongs_to_the_bin_above_it() {
        let scale = TensionScale::up_to(97_338.9);
        let edges = [10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5];
        assert_eq!(scale.edges(), edges);
        assert_eq!(scale.bin(0.0), None);
        assert_eq!(scale.bin(-1.0), None);
        assert_eq!(scale.bin(f64::NAN), None);
        for (bin, &edge) in edges.iter().enumerate().take(BINS) {
            assert_eq!(scale.bin(edge), Some(bin));
            assert_eq!(scale.bin(edge * (1.0 - 1e-15)), Some(bin.saturating_sub(1)));
        }
        assert_eq!(scale.bin(1e5), Some(BINS - 1));
        assert_eq!(scale.bin(1e9), Some(BINS - 1));
        assert_eq!(scale.bin(1e-6), Some(0));
        assert_eq!(scale.bin(1e-9), None);
    }

    #[test]
    fn the_scale_ends_at_the_next_round_number() {
        let top = |largest: f64| TensionScale::up_to(largest).edges()[BINS];
        assert_eq!([top(1.0), top(1.01), top(2.5), top(500.0), top(131_993.0)], [1.0, 2.0, 5.0, 500.0, 200_000.0]);
        // a net without tension has a scale too
        assert!(top(0.0) > 0.0);
    }

    #[test]
    fn the_bins_begin_and_end_at_the_stops_and_neighbours_differ() {
        assert_eq!(bin_colour(0), STOPS[0]);
        assert_eq!(bin_colour(BINS - 1), STOPS[8]);
        for bin in 1..BINS {
            assert_ne!(bin_colour(bin), bin_colour(bin - 1));
        }
        assert_eq!(hex(bin_colour(0)), "#1957d2");
    }
}
