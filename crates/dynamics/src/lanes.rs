//! Sums and maxima over slots in a fixed order, whatever the width of the machine's vectors.

/// Number of interleaved parts of a sum, whatever the width of the machine's vectors.
pub(crate) const LANES: usize = 8;

/// The parts of a sum in a fixed order.
#[inline(always)]
pub(crate) fn sum_lanes(lanes: [f64; LANES]) -> f64 {
    ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]))
}

/// One value a slot for each of x, y, z.
pub(crate) type Components = [Vec<f64>; 3];

/// Zeros in `length` slots.
pub(crate) fn zeros(length: usize) -> Components {
    std::array::from_fn(|_| vec![0.0; length])
}

/// Sum over a block, in [`LANES`] interleaved parts.
#[inline(always)]
pub(crate) fn sum(values: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for group in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] += group[l];
        }
    }
    sum_lanes(lanes)
}

/// Largest of a block; at least zero.
#[inline(always)]
pub(crate) fn max(values: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for group in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] = if group[l] > lanes[l] { group[l] } else { lanes[l] };
        }
    }
    lanes.into_iter().fold(0.0, f64::max)
}
