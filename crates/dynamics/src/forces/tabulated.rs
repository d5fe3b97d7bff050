//! A rope whose tension is read from a table of strain, with a path of its own for unloading.
//!
//! ```text
//! T = F(e)              loading: e = d/L0 at or beyond the largest strain m so far        tension, N
//! T = F(e) h(e/m)       unloading from m, and loading again up to it
//! U = L0 integral of F(s) h(s/m) ds from 0 to e      elastic energy, what unloading gives back, J
//! D = L0 integral of F(s) (1 - h(s/m)) ds from 0 to m                 lost so far, J
//! ```
//!
//! F is straight between the rows of the table and goes on beyond its last row as before it. h is the share of the tension
//! that is left on the way back: the table's unloading column over its tensions, straight between rows, and scaled to wherever
//! a rope turns round. Without that column the rope is elastic and unloads along F. What a rope keeps of its stretch
//! stands in the table as rows whose unloading tension is 0.
//!
//! Both U and D are functions of e and m, so neither is found by difference, and
//!
//! ```text
//! D'(m) = L0 integral of F(s) h'(s/m) s/m^2 ds from 0 to m  >=  0         if h does not fall
//! ```
//!
//! whatever the shape of F: no rope gives back more than was put in. (A path scaled as a whole, F(m) u(e/m), would where F
//! stiffens fast.) The law is a pseudo-elastic one: Ogden, Roxburgh, A pseudo-elastic model for the Mullins effect, Proc. R.
//! Soc. A 455, 1999, with the damage as a function of e/m. Valid for one rate of loading: the curve of a quasi-static test is
//! soft for a snatch. Loading again follows the unloading path, so small cycles below m lose nothing.
//!
//! At a row the slope jumps, and within a step of it the trapezoidal work of the scheme would be wrong by that kink: each row
//! is a ramp that begins there, and gets the correction that [`rope_tension`](super::rope_tension) gives the ramp at 0.

use super::memory::Memory;
use super::rope_tension::ramp;

/// A law read from a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    /// F: tension, N, against strain.
    loading: Curve,
    /// h: share of the tension that is left, against the share of the strain at the turn.
    left: Option<Curve>,
}

/// Why a table is no law.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TableError {
    /// Columns differ in length, or there are not two rows.
    #[error("expected two rows or more, and as many values in each column")]
    Shape,
    /// The first row is not the rope at rest.
    #[error("expected the first row to be the rope at rest: no strain, no tension")]
    Start,
    /// A strain does not exceed the one before, or a tension falls.
    #[error("row {row}: expected strains that grow and tensions that do not fall")]
    Order {
        /// Which row, from 1.
        row: usize,
    },
    /// The rope never pulls.
    #[error("expected a tension greater than 0 in the last row")]
    Slack,
    /// Unloading begins elsewhere than where loading ends.
    #[error("expected unloading to begin at the tension of the last row, {expected} N, found {found} N")]
    Turn {
        /// The tension of the last row, N.
        expected: f64,
        /// Its unloading tension, N.
        found: f64,
    },
    /// Unloading would give back energy that was not put in.
    #[error("row {row}: expected unloading over loading tension not to fall from row to row")]
    Share {
        /// Which row, from 1.
        row: usize,
    },
}

impl TableError {
    /// The row that is wrong, from 1, where it is one.
    pub fn row(&self) -> Option<usize> {
        match self {
            TableError::Order { row } | TableError::Share { row } => Some(*row),
            TableError::Start => Some(1),
            TableError::Shape | TableError::Slack | TableError::Turn { .. } => None,
        }
    }
}

impl Tabulated {
    /// A law from rows of strain and tension, N, and where there is hysteresis the tension, N, on the way back from the last
    /// row.
    ///
    /// # Errors
    /// [`TableError`] where the columns describe no rope.
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
        Ok(Tabulated { loading: Curve::new(strain.to_vec(), tension.to_vec()), left })
    }

    /// The same without a path of its own for unloading.
    pub fn loading(&self) -> Tabulated {
        Tabulated { loading: self.loading.clone(), left: None }
    }

    /// Whether it unloads on a path of its own.
    pub fn has_hysteresis(&self) -> bool {
        self.left.is_some()
    }

    /// A bound on the change of tension with strain on any path, N.
    pub fn largest_slope(&self) -> f64 {
        let Curve { x, y, slope } = &self.loading;
        let most = |slopes: &[f64]| slopes.iter().copied().fold(0.0, f64::max);
        // (F h)' = F' h + F h'/m, with h at most 1 and F/m at most F/e: that at a row, or far beyond the last
        let secant = x.iter().zip(y).skip(1).map(|(x, y)| y / x).chain(slope.last().copied()).fold(0.0, f64::max);
        most(slope) + self.left.as_ref().map_or(0.0, |h| secant * most(&h.slope))
    }

    /// The strain at which loading comes to `tension`, N.
    pub fn strain_under(&self, tension: f64) -> f64 {
        let Curve { x, y, slope } = &self.loading;
        let row = y[1..slope.len()].partition_point(|&below| below < tension);
        if tension > 0.0 { x[row] + (tension - y[row]) / slope[row] } else { 0.0 }
    }

    /// Tension at a stretch of a segment that changes its length by `swept` in a step, N; lengths in m. Memory: the
    /// largest strain so far.
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

    /// Integral of the unloading path from `largest`, from no strain to `strain`, N.
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

/// h of a table.
fn left(strain: &[f64], tension: &[f64], back: &[f64]) -> Result<Curve, TableError> {
    let last = strain.len() - 1;
    if back[last] != tension[last] {
        return Err(TableError::Turn { expected: tension[last], found: back[last] });
    }
    // where there is no tension there is no share: that of the first row with one
    let pulls = tension.iter().position(|tension| *tension > 0.0).unwrap_or(last);
    let share: Vec<f64> = (0..=last).map(|i| back[i.max(pulls)] / tension[i.max(pulls)]).collect();
    let falls = |i: &usize| share[*i].is_nan() || share[*i] < if *i > 0 { share[*i - 1] } else { 0.0 };
    match (0..=last).find(falls) {
        Some(row) => Err(TableError::Share { row: row + 1 }),
        None => Ok(Curve::new(strain.iter().map(|at| at / strain[last]).collect(), share)),
    }
}

/// Integral from 0 to `end` of what is quadratic between `ends`, which ascend from 0: Simpson's rule.
fn integral(ends: impl Iterator<Item = f64>, end: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut from) = (0.0, 0.0);
    for to in ends.filter(|to| *to < end).chain([end]) {
        sum += (to - from) / 6.0 * (value(from) + 4.0 * value(0.5 * (from + to)) + value(to));
        from = to;
    }
    sum
}

/// Straight lines between points, from x = 0 on; the last line without end.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Of the line that begins at each point but the last.
    slope: Vec<f64>,
}

impl Curve {
    fn new(x: Vec<f64>, y: Vec<f64>) -> Curve {
        let slope = (1..x.len()).map(|i| (y[i] - y[i - 1]) / (x[i] - x[i - 1])).collect();
        Curve { x, y, slope }
    }

    /// The line at `x` >= 0.
    fn line(&self, x: f64) -> usize {
        self.x[1..self.slope.len()].partition_point(|&start| start <= x)
    }

    fn at(&self, x: f64) -> f64 {
        let i = self.line(x);
        self.y[i] + self.slope[i] * (x - self.x[i])
    }

    /// What the points that lie within `swept` below `x` take from the value there times some `factor` of each.
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
