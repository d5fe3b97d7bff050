//! The pass over a block whose ropes drag: half of a segment's drag acts on each of its ends.
//!
//! Two loops with vectors, and one without between them for segments whose coefficient takes more than a square root: the
//! few that are slow, and all of a screen. Positions and velocities are those that tensions see.

use crate::air::Air;
use crate::forces::rope_drag::{PLAIN, RelativeFlow, RopeDrag, plain_coefficient};
use crate::lanes::{Components, sum, zeros};

/// The air at one time.
#[derive(Debug, Clone, Copy)]
pub(super) struct AirNow<'a> {
    pub air: &'a Air,
    /// Velocity added to the mean wind now, m/s.
    pub gust: [f64; 3],
}

impl<'a> AirNow<'a> {
    /// The air at `time`, s.
    pub fn at(air: &'a Air, time: f64) -> AirNow<'a> {
        AirNow { air, gust: air.wind.fluctuation.at(time).into() }
    }
}

/// The drag of the segments of a block.
#[derive(Debug, Clone)]
pub(super) struct Dragging {
    rope: RopeDrag,
    /// d L0 / 4 of each slot's segment, m^2; zero where there is none, or none any more.
    half_area: Vec<f64>,
    /// Half the drag of the segment *before* each slot, N: entry i + 1 belongs to segment i, entry 0 is zero.
    half: Components,
    /// The middle of each segment at the pass before, m.
    middle: Components,
    /// Mean wind at each segment, m/s.
    mean: Vec<f64>,
    /// Scratch: density, and the normal coefficient or before it the Reynolds number, of each segment.
    density: Vec<f64>,
    coefficient: Vec<f64>,
    /// Scratch: Reynolds number of each segment in the first loop, then its work on the air, J.
    scratch: Vec<f64>,
    /// Work of all segments on the air since the pass before, J.
    pub work: f64,
}

impl Dragging {
    /// Of segments with these rest lengths, m, (slots,); none where a slot has no segment.
    pub fn new(rope: RopeDrag, air: &Air, rest_length: &[Option<f64>]) -> Dragging {
        let filled = rest_length.len();
        let area = |rest_length: &Option<f64>| rest_length.map_or(0.0, |length| rope.half_area(length));
        let components = || zeros(filled);
        Dragging {
            rope,
            half_area: rest_length.iter().map(area).collect(),
            half: zeros(filled + 1),
            middle: components(),
            mean: vec![air.wind.mean.at(0.0); filled],
            density: vec![0.0; filled],
            coefficient: vec![0.0; filled],
            scratch: vec![0.0; filled],
            work: 0.0,
        }
    }

    /// A slot's share of the drag of its two segments, N.
    #[inline(always)]
    pub fn slot_force(&self, slot: usize) -> [f64; 3] {
        self.half.each_ref().map(|half| half[slot] + half[slot + 1])
    }

    /// Adds every slot's share to `force`, N, a value a slot for each of x, y, z.
    pub fn add_to(&self, force: &mut Components) {
        for (force, half) in force.iter_mut().zip(&self.half) {
            let n = force.len();
            let (before, after) = (&half[..n], &half[1..n + 1]);
            for i in 0..n {
                force[i] += before[i] + after[i];
            }
        }
    }

    /// Removes the segment of this slot.
    pub fn remove(&mut self, slot: usize) {
        self.half_area[slot] = 0.0;
    }

    /// The mean wind where segments are, if it is not the same everywhere; `x` has the places of nodes, m.
    pub fn find_wind(&mut self, x: &Components, air: &Air) {
        let z = &x[2];
        if air.wind.mean.values.len() > 1 {
            for (i, mean) in self.mean.iter_mut().enumerate() {
                *mean = air.wind.mean.at(0.5 * (z[i] + z[i + 1]));
            }
        }
    }

    /// Whether the normal coefficient follows from the Reynolds number.
    pub fn goes_by_reynolds(&self) -> bool {
        self.rope.normal.is_none()
    }

    /// Sets every normal coefficient to the one that is given.
    pub fn set_coefficient(&mut self) {
        self.coefficient.fill(self.rope.coefficient(0.0));
    }

    /// Finds the coefficients that vectors do not know, from Reynolds numbers: of slow segments, and all of a screen.
    pub fn find_others(&mut self) {
        let all = self.rope.in_screen();
        for (coefficient, &reynolds) in self.coefficient.iter_mut().zip(&self.scratch) {
            if all || reynolds < PLAIN {
                *coefficient = self.rope.coefficient(reynolds);
            }
        }
    }
}

/// The wind of a moment: its mean has one direction, and its gust is the same, for all segments.
#[derive(Clone, Copy)]
struct WindNow {
    /// Direction of the mean, a unit vector.
    direction: [f64; 3],
    /// Velocity added to the mean, m/s.
    gust: [f64; 3],
}

impl WindNow {
    #[inline(always)]
    fn of(AirNow { air, gust }: AirNow) -> WindNow {
        WindNow { direction: air.wind.direction.to_array(), gust }
    }

    /// The wind of speed `mean`, m/s, relative to the middle of a segment whose ends move at `u` and `v`, m/s.
    #[inline(always)]
    fn relative(&self, mean: f64, u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| (self.direction[k] * mean + self.gust[k]) - 0.5 * (u[k] + v[k]))
    }
}

/// Density and Reynolds number of every segment, and its normal coefficient as if it were not slow.
#[inline(always)]
pub(super) fn meet_pass(x: &Components, w: &Components, dragging: &mut Dragging, now: AirNow) {
    let Dragging { rope, mean, density, coefficient, scratch, .. } = dragging;
    let (wind, medium) = (WindNow::of(now), &now.air.medium);
    let per_viscosity = rope.diameter / medium.viscosity();
    let by_reynolds = rope.normal.is_none();
    let n = mean.len();
    let (mean, density, coefficient, reynolds) =
        (&mean[..n], &mut density[..n], &mut coefficient[..n], &mut scratch[..n]);
    let ([x, y, z], [u, v, w]) = (x, w);
    let (x0, y0, z0, x1, y1, z1) = (&x[..n], &y[..n], &z[..n], &x[1..n + 1], &y[1..n + 1], &z[1..n + 1]);
    let (u0, v0, w0, u1, v1, w1) = (&u[..n], &v[..n], &w[..n], &u[1..n + 1], &v[1..n + 1], &w[1..n + 1]);
    for i in 0..n {
        density[i] = medium.density(0.5 * (z0[i] + z1[i]));
        if by_reynolds {
            let span = [x1[i] - x0[i], y1[i] - y0[i], z1[i] - z0[i]];
            let relative = wind.relative(mean[i], [u0[i], v0[i], w0[i]], [u1[i], v1[i], w1[i]]);
            reynolds[i] = density[i] * RelativeFlow::new(span, relative).across * per_viscosity;
            coefficient[i] = plain_coefficient(reynolds[i]);
        }
    }
}

/// Drag of every segment, and what it does on its way.
#[inline(always)]
pub(super) fn drag_pass(x: &Components, w: &Components, dragging: &mut Dragging, now: AirNow) {
    let Dragging { rope, half_area, half, middle, mean, density, coefficient, scratch, .. } = dragging;
    let [hx, hy, hz] = half;
    let [mx, my, mz] = middle;
    drag_each(
        [&x[0], &x[1], &x[2]],
        [&w[0], &w[1], &w[2]],
        [half_area, mean, density, coefficient],
        Uniform { wind: WindNow::of(now), tangential: rope.tangential },
        [&mut hx[1..], &mut hy[1..], &mut hz[1..]],
        [mx, my, mz],
        scratch,
    );
    dragging.work = sum(&dragging.scratch);
}

/// What is the same for all segments of a block.
struct Uniform {
    wind: WindNow,
    /// Tangential coefficient.
    tangential: f64,
}

/// The loop of [`drag_pass`].
#[inline(always)]
fn drag_each(
    [x, y, z]: [&[f64]; 3],
    [u, v, w]: [&[f64]; 3],
    [half_area, mean, density, coefficient]: [&[f64]; 4],
    Uniform { wind, tangential }: Uniform,
    [hx, hy, hz]: [&mut [f64]; 3],
    [mx, my, mz]: [&mut [f64]; 3],
    work: &mut [f64],
) {
    let n = work.len();
    let (x0, y0, z0, x1, y1, z1) = (&x[..n], &y[..n], &z[..n], &x[1..n + 1], &y[1..n + 1], &z[1..n + 1]);
    let (u0, v0, w0, u1, v1, w1) = (&u[..n], &v[..n], &w[..n], &u[1..n + 1], &v[1..n + 1], &w[1..n + 1]);
    let (half_area, mean) = (&half_area[..n], &mean[..n]);
    let (density, coefficient) = (&density[..n], &coefficient[..n]);
    let (hx, hy, hz, mx, my, mz) = (&mut hx[..n], &mut hy[..n], &mut hz[..n], &mut mx[..n], &mut my[..n], &mut mz[..n]);
    for i in 0..n {
        let span = [x1[i] - x0[i], y1[i] - y0[i], z1[i] - z0[i]];
        let relative = wind.relative(mean[i], [u0[i], v0[i], w0[i]], [u1[i], v1[i], w1[i]]);
        let half = RelativeFlow::new(span, relative).force(coefficient[i], tangential, density[i] * half_area[i]);
        let middle = [0.5 * (x0[i] + x1[i]), 0.5 * (y0[i] + y1[i]), 0.5 * (z0[i] + z1[i])];
        work[i] = -((hx[i] + half[0]) * (middle[0] - mx[i])
            + (hy[i] + half[1]) * (middle[1] - my[i])
            + (hz[i] + half[2]) * (middle[2] - mz[i]));
        (hx[i], hy[i], hz[i]) = (half[0], half[1], half[2]);
        (mx[i], my[i], mz[i]) = (middle[0], middle[1], middle[2]);
    }
}
