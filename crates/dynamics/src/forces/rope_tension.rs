//! Tension of a segment of rope: a spring and a damper in parallel that pull and never push.
//!
//! ```text
//! d  = L - L0                      stretch, m             L = |x_b - x_a|                        (11), (10)
//! d' = (x_b - x_a).(v_b - v_a)/L   rate of stretch, m/s                                          (12) times L0
//! T  = max(0, k d + c d')  where d > 0,  else 0           tension, N                             (9)
//! ```
//!
//! k = EA/L0 is the stiffness (N/m), c the damping (N s/m); see [`damping_from_time`] and [`damping_from_ratio`]. The
//! elastic energy is k d^2/2 where d > 0. What else the tension does is lost, and counted as work of the remaining
//! force, T - k d.
//!
//! Source: the founding paper's equations (9)-(12), the "concentrated mass damping spring model". The lower bound of
//! zero, which (9) leaves out, keeps a rope from pushing while it shortens fast. Valid for strains small enough that
//! k does not change, and for ropes that bend freely. T jumps by c d' where a rope tautens.
//!
//! **In steps of dt.** A step that crosses from slack to taut sees either no force or all of it, and the spring takes
//! k d (|d'| dt - d)/2 more or less than it stores: the energy that explicit methods win or lose at every such event.
//! Within |d'| dt of the crossing the spring therefore pulls with
//!
//! ```text
//! k d (1 + d / (|d'| dt)) / 2            0 < d < |d'| dt
//! ```
//!
//! which makes the work exact where d' is constant over two steps. It changes nothing as dt goes to 0, nor anywhere
//! else. Derivation and measurement: docs/theory/slack-taut.md.

/// Tension and force of a segment at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// Tension, N; what a strut pushes with is negative.
    pub tension: f64,
    /// Force on the segment's first node, N; its second node gets the opposite.
    pub force: [f64; 3],
    /// Length, m.
    pub length: f64,
    /// The part of the tension that is not the law's own, N: damping, and what the lower bound of zero takes away.
    pub dissipative: f64,
    /// Work that the law itself has lost since the forces before, J: a dashpot's.
    pub lost: f64,
}

impl Pull {
    /// The value before the first forces.
    pub const NONE: Pull = Pull { tension: 0.0, force: [0.0; 3], length: 0.0, dissipative: 0.0, lost: 0.0 };
}

/// Keeps 1/L finite where two nodes coincide; such a segment is slack and its direction is of no account.
const LEAST_LENGTH_SQUARED: f64 = 1e-200;

/// How a segment lies and moves along itself: (10) to (12).
#[derive(Debug, Clone, Copy)]
pub(crate) struct AxialMotion {
    span: [f64; 3],
    per_length: f64,
    /// Length, m.
    pub length: f64,
    /// Stretch, m.
    pub stretch: f64,
    /// Rate of stretch, m/s.
    pub stretch_rate: f64,
    /// Its change of length in a step, |d'| dt, m.
    pub swept: f64,
}

impl AxialMotion {
    /// `span` = x_b - x_a, m; `rate` = v_b - v_a, m/s; `dt` the step, s.
    #[inline(always)]
    pub fn new(span: [f64; 3], rate: [f64; 3], rest_length: f64, dt: f64) -> AxialMotion {
        let length_squared = span[0] * span[0] + span[1] * span[1] + span[2] * span[2];
        let bounded = if length_squared > LEAST_LENGTH_SQUARED { length_squared } else { LEAST_LENGTH_SQUARED };
        let length = bounded.sqrt();
        let per_length = 1.0 / length;
        let stretch = length - rest_length;
        let stretch_rate = (span[0] * rate[0] + span[1] * rate[1] + span[2] * rate[2]) * per_length;
        AxialMotion { span, per_length, length, stretch, stretch_rate, swept: stretch_rate.abs() * dt }
    }

    /// The pull of a rope whose law gives `elastic`, N, with a damper `damping`, N s/m, beside it: only where it is taut,
    /// and never a push.
    #[inline(always)]
    pub fn pulled(&self, taut: bool, elastic: f64, damping: f64) -> Pull {
        let total = elastic + damping * self.stretch_rate;
        let pulls = if total > 0.0 { total } else { 0.0 };
        self.with(if taut { pulls } else { 0.0 }, elastic)
    }

    /// The pull of a segment under `tension`, N, of which the law gives `elastic`.
    #[inline(always)]
    pub fn with(&self, tension: f64, elastic: f64) -> Pull {
        let along = tension * self.per_length;
        let force = [self.span[0] * along, self.span[1] * along, self.span[2] * along];
        Pull { tension, force, length: self.length, dissipative: tension - elastic, lost: 0.0 }
    }
}

/// max(0, x), and in steps of `swept` what makes the work of a spring that begins at 0 exact. Both in m, or alike.
#[inline(always)]
pub(crate) fn ramp(x: f64, swept: f64) -> f64 {
    // next to a slack-taut crossing the spring gives its mean over the step
    let mean = 0.5 * (x + x * (x / swept));
    let sprung = if x < swept { mean } else { x };
    if x > 0.0 { sprung } else { 0.0 }
}

/// The law. `span` = x_b - x_a, m; `rate` = v_b - v_a, m/s; `dt` the step, s.
///
/// Written without branches on purpose: the fused step runs it on several segments at a time.
#[inline(always)]
pub fn pull(span: [f64; 3], rate: [f64; 3], rest_length: f64, stiffness: f64, damping: f64, dt: f64) -> Pull {
    let along = AxialMotion::new(span, rate, rest_length, dt);
    along.pulled(along.stretch > 0.0, stiffness * ramp(along.stretch, along.swept), damping)
}

/// Elastic energy at `stretch`, m, in J.
pub fn elastic_energy(stretch: f64, stiffness: f64) -> f64 {
    if stretch > 0.0 { 0.5 * stiffness * stretch * stretch } else { 0.0 }
}

/// c = EA t / L0: internal damping of a material with damping time `time`, s. With it the damping of a rope does not
/// depend on how it is cut.
pub fn damping_from_time(axial_stiffness: f64, time: f64, rest_length: f64) -> f64 {
    axial_stiffness * time / rest_length
}

/// c = 2 ratio sqrt(k m), with k the segment's stiffness and m its mass: a fraction of a single segment's critical
/// damping, for numerical purposes.
pub fn damping_from_ratio(ratio: f64, stiffness: f64, mass: f64) -> f64 {
    2.0 * ratio * (stiffness * mass).sqrt()
}

/// Work of the dissipative force, J, from an earlier `length`, m, and force `dissipative`, N, to those of `now`: the
/// trapezoidal rule over the change of length.
#[inline(always)]
pub(crate) fn dissipative_work(length: f64, dissipative: f64, now: &Pull) -> f64 {
    0.5 * (dissipative + now.dissipative) * (now.length - length)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A segment along y of length `l`, whose far end moves away at `rate`.
    fn along_y(l: f64, rate: f64, rest_length: f64, stiffness: f64, damping: f64, dt: f64) -> Pull {
        pull([0.0, l, 0.0], [7.0, rate, 1.0], rest_length, stiffness, damping, dt)
    }

    #[test]
    fn a_taut_segment_pulls_with_spring_and_damper() {
        // 2.5 m long, 0.1 m stretched, stretching at 3 m/s: T = 100 * 0.1 + 2 * 3 = 16 N, of which 6 N are dissipative
        let p = along_y(2.5, 3.0, 2.4, 100.0, 2.0, 1e-3);
        assert!((p.tension - 16.0).abs() < 1e-12 && (p.dissipative - 6.0).abs() < 1e-12);
        assert!((p.force[1] - 16.0).abs() < 1e-12 && p.force[0] == 0.0);
    }

    #[test]
    fn it_never_pushes() {
        let slack = along_y(1.0, 50.0, 1.001, 1e6, 1e3, 1e-6);
        assert_eq!((slack.tension, slack.dissipative), (0.0, 0.0));
        // taut but shortening fast: no force, and the spring's 1000 N are dissipative
        let closing = along_y(1.0, -50.0, 0.999, 1e6, 1e3, 1e-6);
        assert_eq!(closing.tension, 0.0);
        assert!((closing.dissipative + 1000.0).abs() < 1e-6);
    }

    #[test]
    fn coinciding_nodes_are_slack_and_finite() {
        assert_eq!(pull([0.0; 3], [1.0, 2.0, 3.0], 0.1, 1e6, 1e3, 1e-6).force, [0.0; 3]);
    }

    #[test]
    fn work_is_exact_across_a_crossing_at_constant_rate() {
        // from 0.37 mm slack to taut in steps of 1 mm: the trapezoidal work of the tension is the energy stored
        let (k, dt, rate) = (1e4, 1e-3, 1.0);
        let tension = |stretch: f64| along_y(1.0 + stretch, rate, 1.0, k, 0.0, dt).tension;
        let (mut work, mut stretch) = (0.0, -0.00037);
        for _ in 0..6 {
            work += 0.5 * (tension(stretch) + tension(stretch + rate * dt)) * rate * dt;
            stretch += rate * dt;
        }
        let stored = elastic_energy(stretch, k);
        assert!((work / stored - 1.0).abs() < 1e-9, "{work} J of work, {stored} J stored");
    }
}
