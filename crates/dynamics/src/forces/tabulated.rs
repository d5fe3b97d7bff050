//! A rope with tension tabulated over strain, and optionally another curve for unloading.
//!
//! ```text
//! T = F(e)              loading: strain e = d/L0 at or above the largest strain m so far        tension, N
//! T = F(e) h(e/m)       unloading from m, and reloading up to m
//! U = L0 integral of F(s) h(s/m) ds from 0 to e                elastic energy, J: the work that unloading returns
//! D = L0 integral of F(s) (1 - h(s/m)) ds from 0 to m          energy lost so far, J
//! ```
//!
//! F is linear between the rows of the table; beyond the last row it has the slope of the last two. h is the unloading tension
//! over the loading tension, linear between rows. It is a function of e/m, so that it applies to unloading from any m. Without
//! a column for unloading the rope is elastic and unloads along F. A rope with a permanent strain has rows whose unloading
//! tension is 0.
//!
//! U and D are both functions of e and m, so neither is found by difference, and
//!
//! ```text
//! D'(m) = L0 integral of F(s) h'(s/m) s/m^2 ds from 0 to m  >=  0         if h does not fall
//! ```
//!
//! for every shape of F: no rope returns more energy than was put in. (An unloading curve F(m) u(e/m) could return more where
//! F stiffens fast.) The law is pseudo-elastic: Ogden, Roxburgh, A pseudo-elastic model for the Mullins effect, Proc. R. Soc. A
//! 455, 1999, with the damage as a function of e/m. It is valid for one rate of loading: in a snatch a rope is stiffer than in
//! a quasi-static test. Reloading follows the unloading curve, so small cycles below m lose no energy.
//!
//! The slope jumps at each row, and the trapezoidal work of a step across a row would be wrong. So F is a sum of ramps that
//! begin at the rows, and each gets the correction that [`rope_tension`](super::rope_tension) applies to the ramp at 0.

use super::memory::Memory;
use super::rope_tension::ramp;

/// Tension tabulated over strain.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    /// F: tension, N, over strain.
    loading: PiecewiseLinear,
    /// h: unloading over loading tension, as a function of e/m; `None` for an elastic rope.
    left: Option<PiecewiseLinear>,
    /// Whether a run stops where a segment is stretched beyond the last row.
    stops: bool,
}

/// Why a table cannot be the law of a rope.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TableError {
    /// Columns differ in length, or there are fewer than two rows.
    #[error("expected two rows or more, and the same number of values in each column")]
    Shape,
    /// The first row does not have strain 0 and tension 0.
    #[error("expected strain 0 and tension 0 in the first row")]
    Start,
    /// A strain is not larger than the one before, or a tension is smaller.
    #[error("row {row}: expected a larger strain than in the row before, and no smaller tension")]
    Order {
        /// Which row, from 1.
        row: usize,
    },
    /// All tensions are 0.
    #[error("expected a tension greater than 0 in the last row")]
    Slack,
    /// Loading and unloading tension differ in the last row.
    #[error("expected the same loading and unloading tension in the last row, {expected} N, found {found} N")]
    Turn {
        /// The loading tension of the last row, N.
        expected: f64,
        /// Its unloading tension, N.
        found: f64,
    },
    /// Unloading would return energy that was not put in.
    #[error("row {row}: expected a ratio of unloading to loading tension no smaller than in the row before")]
    Share {
        /// Which row, from 1.
        row: usize,
    },
}

impl TableError {
    /// The row that is wrong, from 1; `None` if the error is not in one row.
    pub fn row(&self) -> Option<usize> {
        match self {
            TableError::Order { row } | TableError::Share { row } => Some(*row),
            TableError::Start => Some(1),
            TableError::Shape | TableError::Slack | TableError::Turn { .. } => None,
        }
    }
}

impl Tabulated {
    /// The law of a table: `strain`, `tension` under loading, N, and for a rope with hysteresis `unloading`, the tension, N,
    /// on the way back from the last row. Shapes (rows,).
    ///
    /// # Errors
    /// [`TableError`] if the columns cannot be the law of a rope.
    pub fn new(strain: &[f64], tension: &[f64], unloading: Option<&[f64]>) -> Result<Tabulated, TableError> {
        if strain.len() < 2 || [tension.len(), unloading.map_or(strain.len(), <[f64]>::len)] != [strain.len(); 2] {
            return Err(TableError::Shape);
        }
        if strain[0] != 0.0 || tension[0] != 0.0 || unloading.is_some_and(|back| back[0] != 0.0) {
            return Err(TableError::Start);
        }
        let sound = |i: usize| strain[i] > strain[i - 1] && tension[i] >= tension[i - 1];
        let finite = |i: usize| strain[i].is_finite() && tension[i].is_finite();
        if let Some(row) = (1..strain.len()).find(|&i| !(sound(i) && finite(i))) {
            return Err(TableError::Order { row: row + 1 });
        }
        if tension[tension.len() - 1] == 0.0 {
            return Err(TableError::Slack);
        }
        let left = unloading.map(|back| left(strain, tension, back)).transpose()?;
        Ok(Tabulated { loading: PiecewiseLinear::new(strain.to_vec(), tension.to_vec()), left, stops: false })
    }

    /// The same law, with which a run stops where a segment breaks at [`Tabulated::last_strain`].
    pub fn stopping(self) -> Tabulated {
        Tabulated { stops: true, ..self }
    }

    /// Whether a run stops where a segment is stretched beyond the last row.
    pub fn stops(&self) -> bool {
        self.stops
    }

    /// The strain of the last row.
    pub fn last_strain(&self) -> f64 {
        *self.loading.x.last().expect("a table has rows")
    }

    /// The elastic law with the same loading curve.
    pub fn loading(&self) -> Tabulated {
        Tabulated { loading: self.loading.clone(), left: None, stops: self.stops }
    }

    /// Whether unloading follows another curve than loading.
    pub fn has_hysteresis(&self) -> bool {
        self.left.is_some()
    }

    /// An upper bound of the slope of tension over strain, loading or unloading, N.
    pub fn largest_slope(&self) -> f64 {
        let PiecewiseLinear { x, y, slope } = &self.loading;
        let most = |slopes: &[f64]| slopes.iter().copied().fold(0.0, f64::max);
        // (F h)' = F' h + F h'/m, with h at most 1 and F/m at most F/e, whose maximum is at a row or far beyond the last
        let secant = x.iter().zip(y).skip(1).map(|(x, y)| y / x).chain(slope.last().copied()).fold(0.0, f64::max);
        most(slope) + self.left.as_ref().map_or(0.0, |h| secant * most(&h.slope))
    }

    /// The strain under loading at `tension`, N.
    pub fn strain_under(&self, tension: f64) -> f64 {
        let PiecewiseLinear { x, y, slope } = &self.loading;
        let row = y[1..slope.len()].partition_point(|&below| below < tension);
        if tension > 0.0 { x[row] + (tension - y[row]) / slope[row] } else { 0.0 }
    }

    /// Tension, N, of a segment at `stretch`, m, whose length changes by `swept`, m, in a step. `memory`: the largest strain
    /// so far, which is updated.
    pub(crate) fn tension(&self, stretch: f64, swept: f64, rest_length: f64, memory: &mut Memory) -> f64 {
        let (strain, swept) = (stretch / rest_length, swept / rest_length);
        let largest = memory[0];
        match &self.left {
            _ if strain <= 0.0 => 0.0,
            Some(left) if strain < largest => {
                let of_rows = self.loading.kinks(strain, swept, |row| left.at(row / largest));
                let scaled = |share: f64| self.loading.at(share * largest);
                let of_shares = left.kinks(strain / largest, swept / largest, scaled);
                self.loading.at(strain) * left.at(strain / largest) - of_rows - of_shares
            }
            _ => {
                if self.left.is_some() {
                    memory[0] = largest.max(strain);
                }
                self.loading.at(strain) - self.loading.kinks(strain, swept, |_| 1.0)
            }
        }
    }

    pub(crate) fn elastic_energy(&self, stretch: f64, rest_length: f64, &[largest, _]: &Memory) -> f64 {
        let strain = stretch / rest_length;
        if strain > 0.0 { rest_length * self.given_back(strain, largest.max(strain)) } else { 0.0 }
    }

    pub(crate) fn hysteresis(&self, rest_length: f64, &[largest, _]: &Memory) -> f64 {
        if largest == 0.0 {
            return 0.0;
        }
        let put_in = integral(self.loading.x.iter().copied(), largest, |strain| self.loading.at(strain));
        rest_length * (put_in - self.given_back(largest, largest))
    }

    /// Integral of the unloading curve from `largest`, from 0 to `strain`, N.
    fn given_back(&self, strain: f64, largest: f64) -> f64 {
        let rows = self.loading.x.iter().copied();
        match &self.left {
            None => integral(rows, strain, |strain| self.loading.at(strain)),
            Some(left) => {
                let mut ends: Vec<f64> = rows.chain(left.x.iter().map(|share| share * largest)).collect();
                ends.sort_by(f64::total_cmp);
                integral(ends.into_iter(), strain, |strain| self.loading.at(strain) * left.at(strain / largest))
            }
        }
    }
}

/// The curve h of a table.
fn left(strain: &[f64], tension: &[f64], back: &[f64]) -> Result<PiecewiseLinear, TableError> {
    let last = strain.len() - 1;
    if back[last] != tension[last] {
        return Err(TableError::Turn { expected: tension[last], found: back[last] });
    }
    // where the loading tension is 0 the ratio is not defined: take that of the first row with tension
    let pulls = tension.iter().position(|tension| *tension > 0.0).unwrap_or(last);
    let share: Vec<f64> = (0..=last).map(|i| back[i.max(pulls)] / tension[i.max(pulls)]).collect();
    let falls = |i: &usize| share[*i].is_nan() || share[*i] < if *i > 0 { share[*i - 1] } else { 0.0 };
    match (0..=last).find(falls) {
        Some(row) => Err(TableError::Share { row: row + 1 }),
        None => Ok(PiecewiseLinear::new(strain.iter().map(|at| at / strain[last]).collect(), share)),
    }
}

/// Integral of `value` from 0 to `end` by Simpson's rule; `value` is quadratic between `ends`, which ascend from 0.
fn integral(ends: impl Iterator<Item = f64>, end: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut from) = (0.0, 0.0);
    for to in ends.filter(|to| *to < end).chain([end]) {
        sum += (to - from) / 6.0 * (value(from) + 4.0 * value(0.5 * (from + to)) + value(to));
        from = to;
    }
    sum
}

/// A piecewise linear function from x = 0 on; the last line is extended.
#[derive(Debug, Clone, PartialEq)]
struct PiecewiseLinear {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Slope of the line from each point to the next.
    slope: Vec<f64>,
}

impl PiecewiseLinear {
    fn new(x: Vec<f64>, y: Vec<f64>) -> PiecewiseLinear {
        let slope = (1..x.len()).map(|i| (y[i] - y[i - 1]) / (x[i] - x[i - 1])).collect();
        PiecewiseLinear { x, y, slope }
    }

    /// The index of the line at `x` >= 0.
    fn line(&self, x: f64) -> usize {
        self.x[1..self.slope.len()].partition_point(|&start| start <= x)
    }

    fn at(&self, x: f64) -> f64 {
        let i = self.line(x);
        self.y[i] + self.slope[i] * (x - self.x[i])
    }

    /// The correction at `x` for the kinks at points within `swept` below it, each times the `factor` at its point.
    fn kinks(&self, x: f64, swept: f64, factor: impl Fn(f64) -> f64) -> f64 {
        let near = (0..=self.line(x)).rev().take_while(|&i| x - self.x[i] < swept);
        let kink = |i: usize| {
            let (beyond, turn) = (x - self.x[i], self.slope[i] - if i > 0 { self.slope[i - 1] } else { 0.0 });
            turn * (beyond - ramp(beyond, swept)) * factor(self.x[i])
        };
        near.map(kink).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A belt that stiffens, and comes back softly: all to 1 kN at 10 %.
    fn belt() -> Tabulated {
        Tabulated::new(&[0.0, 0.05, 0.1], &[0.0, 300.0, 1000.0], Some(&[0.0, 60.0, 1000.0])).unwrap()
    }

    /// A rope that settles without tension first, and keeps a fifth of its stretch.
    fn settling() -> Tabulated {
        let (strain, tension) = ([0.0, 0.01, 0.02, 0.05, 0.1], [0.0, 0.0, 10.0, 900.0, 1000.0]);
        Tabulated::new(&strain, &tension, Some(&[0.0, 0.0, 0.0, 300.0, 1000.0])).unwrap()
    }

    /// Work done on a segment 2 m long that is led through these strains in steps of `sweep`, J; memory and strain at the
    /// end.
    fn led(law: &Tabulated, turns: &[f64], sweep: f64) -> (f64, Memory, f64) {
        let (length, mut memory) = (2.0, [0.0; 2]);
        let (mut strain, mut tension, mut work) = (0.0, 0.0, 0.0);
        for &turn in turns {
            while strain != turn {
                let next = if turn > strain { turn.min(strain + sweep) } else { turn.max(strain - sweep) };
                let now = law.tension(next * length, sweep * length, length, &mut memory);
                work += 0.5 * (tension + now) * (next - strain) * length;
                (strain, tension) = (next, now);
            }
        }
        (work, memory, strain)
    }

    #[test]
    fn a_loop_loses_the_area_between_its_paths() {
        // loading: 0.05 * 300/2 + 0.05 * (300 + 1000)/2 = 40 N. Unloading: h is 0.2 to the first row, then grows to 1; 0.05 *
        // 60/2 = 1.5 N, then by Simpson 0.05/6 * (60 + 4 * 650 * 0.6 + 1000) = 21.8333 N. The rest, times 2 m
        let lost = 2.0 * (40.0 - 1.5 - 0.05 / 6.0 * 2620.0);
        let (work, memory, _) = led(&belt(), &[0.1, 0.0], 1e-4);
        assert!((belt().hysteresis(2.0, &memory) / lost - 1.0).abs() < 1e-12);
        assert!((work / lost - 1.0).abs() < 1e-5, "{work} J, exact {lost} J");
        assert_eq!(belt().elastic_energy(0.0, 2.0, &memory), 0.0);
    }

    #[test]
    fn work_is_what_is_stored_and_what_is_lost_on_any_way() {
        let ways = [&[0.03][..], &[0.08, 0.06], &[0.08, 0.02, 0.05, 0.01], &[0.04, 0.0, 0.09, 0.03], &[0.2, 0.1]];
        for (law, turns) in [belt(), settling()].iter().flat_map(|law| ways.map(|turns| (law, turns))) {
            let (work, memory, strain) = led(law, turns, 1e-5);
            let (stored, lost) = (law.elastic_energy(strain * 2.0, 2.0, &memory), law.hysteresis(2.0, &memory));
            assert!(((stored + lost) / work - 1.0).abs() < 2e-6, "{turns:?}: {work} J, {stored} J, {lost} J");
        }
    }

    #[test]
    fn what_is_lost_never_falls() {
        for law in [belt(), settling()] {
            let lost: Vec<f64> = (1..400).map(|i| law.hysteresis(1.0, &[0.0005 * f64::from(i), 0.0])).collect();
            assert!(lost.windows(2).all(|pair| pair[1] >= pair[0]), "{lost:?}");
        }
    }

    #[test]
    fn steps_across_rows_do_exact_work() {
        let elastic = Tabulated::new(&[0.0, 0.01, 0.02, 0.05], &[0.0, 10.0, 200.0, 300.0], None).unwrap();
        // from slack, in steps as long as the distance between rows, wherever they fall
        for start in [-0.0013, -0.004, -0.0081] {
            let (sweep, mut strain, mut work) = (0.0093, start, 0.0);
            let tension = |strain: f64| elastic.tension(strain, sweep, 1.0, &mut [0.0; 2]);
            for _ in 0..9 {
                work += 0.5 * (tension(strain) + tension(strain + sweep)) * sweep;
                strain += sweep;
            }
            let stored = elastic.elastic_energy(strain, 1.0, &[0.0; 2]);
            assert!((work / stored - 1.0).abs() < 1e-12, "{work} J of work, {stored} J stored");
        }
    }

    #[test]
    fn slopes_and_strains_are_the_tables() {
        // the bound is above the steepest that can be found: just below a turn from 10 % or beyond
        let turn = |m: f64| {
            (belt().tension(m, 0.0, 1.0, &mut [m, 0.0]) - belt().tension(m - 1e-7, 0.0, 1.0, &mut [m, 0.0])) / 1e-7
        };
        for m in [0.02, 0.05, 0.1, 0.3, 3.0] {
            assert!(turn(m) <= belt().largest_slope(), "{} N at {m}", turn(m));
        }
        assert!(turn(3.0) > 0.95 * belt().largest_slope());
        for (tension, strain) in [(0.0, 0.0), (150.0, 0.025), (300.0, 0.05), (650.0, 0.075), (1700.0, 0.15)] {
            assert!((belt().strain_under(tension) - strain).abs() < 1e-15);
        }
        assert_eq!(settling().strain_under(5.0), 0.015);
    }

    #[test]
    fn what_is_no_rope_is_refused() {
        let refused = |strain: &[f64], tension: &[f64], back| Tabulated::new(strain, tension, back).unwrap_err();
        assert_eq!(refused(&[0.0], &[0.0], None), TableError::Shape);
        assert_eq!(refused(&[0.0, 0.1], &[0.0, 2.0], Some(&[0.0])), TableError::Shape);
        assert_eq!(refused(&[0.0, 0.1], &[1.0, 2.0], None), TableError::Start);
        assert_eq!(refused(&[0.0, 0.1], &[0.0, 2.0], Some(&[0.5, 2.0])), TableError::Start);
        assert_eq!(refused(&[0.0, 0.1, 0.1], &[0.0, 2.0, 3.0], None), TableError::Order { row: 3 });
        assert_eq!(refused(&[0.0, 0.1, 0.2], &[0.0, 2.0, 1.0], None), TableError::Order { row: 3 });
        assert_eq!(refused(&[0.0, 0.1], &[0.0, f64::NAN], None), TableError::Order { row: 2 });
        assert_eq!(refused(&[0.0, 0.1], &[0.0, 0.0], None), TableError::Slack);
        let turn = TableError::Turn { expected: 2.0, found: 1.0 };
        assert_eq!(refused(&[0.0, 0.1], &[0.0, 2.0], Some(&[0.0, 1.0])), turn);
        // half the tension is left at a third of the stretch, and a quarter at two thirds
        let back: Option<&[f64]> = Some(&[0.0, 5.0, 5.0, 30.0]);
        assert_eq!(refused(&[0.0, 0.1, 0.2, 0.3], &[0.0, 10.0, 20.0, 30.0], back), TableError::Share { row: 3 });
        let more: Option<&[f64]> = Some(&[0.0, 15.0, 20.0]);
        assert_eq!(refused(&[0.0, 0.1, 0.2], &[0.0, 10.0, 20.0], more), TableError::Share { row: 3 });
    }
}
