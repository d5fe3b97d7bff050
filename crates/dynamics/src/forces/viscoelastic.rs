//! A viscoelastic rope: the standard linear solid, in tension only. Its tension relaxes while its length is constant.
//!
//! ```text
//! T  = k e + q                      tension, N: a spring k parallel to a spring k1 in series with a dashpot
//! q  = k1 (e - v)                   tension of that branch, N;  v: stretch of the dashpot, m
//! v' = q/(k1 tau) = (e - v)/tau     tau: relaxation time, s
//! e  = max(d, g v)                  stretch of the material, m;  d: distance of the ends less rest length, m;  g = k1/(k + k1)
//! U  = k e^2/2 + k1 (e - v)^2/2     elastic energy, J;  power lost: q v', W
//! ```
//!
//! Under a constant stretch the stiffness falls from k + k1 to k: k(t) = k + k1 exp(-t/tau). k = EA/L0 is the long-term
//! stiffness. (Zener, Elasticity and Anelasticity of Metals, 1948; Ferry, Viscoelastic Properties of Polymers, 1980,
//! chapter 1.) The law has one relaxation time: it loses too little energy at rates far above or below 1/tau.
//!
//! **In tension only.** T = (k + k1)(e - g v), so a rope with a stretched dashpot goes slack at d = g v and not at 0. A slack
//! rope, d < g v, has the stretch e = g v and recovers: v' = -v (1 - g)/tau. T e' = U' + q v' holds in both states, so the
//! law makes no energy.
//!
//! **In steps of D.** If e is linear in time over the step, the branch is integrated exactly (Simo, Hughes, Computational
//! Inelasticity, 1998, chapter 10):
//!
//! ```text
//! v+ = v + (1 - a)(e - v) + (1 - b)(e+ - e)       a = exp(-D/tau),  b = (1 - a) tau/D
//! v+ = v exp(-(1 - g) D/tau)                      slack
//! ```
//!
//! The energy lost is (q + q+)/2 (v+ - v), which closes the energy balance to rounding while the rope is taut. In the step in
//! which the rope becomes taut, its spring k + k1 gets the correction of [`rope_tension`](super::rope_tension).

use super::memory::Memory;
use super::rope_tension::{AxialMotion, Pull, ramp};

/// The parameters of the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscoelastic {
    /// Stiffness that relaxes over the long-term stiffness, k1/k; positive.
    pub ratio: f64,
    /// Relaxation time tau at constant stretch, s; positive.
    pub relaxation_time: f64,
}

/// Coefficients of the dashpot's stretch over one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decay {
    /// 1 - a: coefficient of e - v.
    taut: f64,
    /// 1 - b: coefficient of e+ - e.
    change: f64,
    /// exp(-(1 - g) D/tau): v+ over v of a slack rope.
    slack: f64,
}

impl Decay {
    /// Those of a step of 0 s.
    pub const NONE: Decay = Decay { taut: 0.0, change: 0.0, slack: 1.0 };
}

impl Viscoelastic {
    /// g: stretch at which the rope goes slack, over the stretch of its dashpot.
    fn slack_share(&self) -> f64 {
        self.ratio / (1.0 + self.ratio)
    }

    pub(crate) fn decay(&self, elapsed: f64) -> Decay {
        if elapsed == 0.0 {
            return Decay::NONE;
        }
        let share = elapsed / self.relaxation_time;
        let taut = -libm::expm1(-share);
        Decay { taut, change: 1.0 - taut / share, slack: libm::exp(-(1.0 - self.slack_share()) * share) }
    }

    /// Memory of a rope at rest: stretch v of the dashpot and stretch e of the material at the last forces, m.
    pub(crate) fn at_rest(&self, stretch: f64) -> Memory {
        [stretch.max(0.0); 2]
    }

    pub(super) fn pull(
        &self,
        along: &AxialMotion,
        stiffness: f64,
        damping: f64,
        memory: &mut Memory,
        decay: &Decay,
    ) -> Pull {
        let (share, branch) = (self.slack_share(), self.ratio * stiffness);
        let [v, e] = *memory;
        let drawn = v + decay.taut * (e - v) + decay.change * (along.stretch - e);
        let now = if along.stretch > share * drawn { drawn } else { v * decay.slack };
        let slack_at = share * now;
        let taut = along.stretch > slack_at;
        *memory = [now, if taut { along.stretch } else { slack_at }];
        let lost = 0.5 * branch * ((e - v) + (memory[1] - now)) * (now - v);
        let elastic = self.instantaneous_stiffness(stiffness) * ramp(along.stretch - slack_at, along.swept);
        Pull { lost, ..along.pulled(taut, elastic, damping) }
    }

    pub(crate) fn elastic_energy(&self, stiffness: f64, &[v, e]: &Memory) -> f64 {
        0.5 * stiffness * (e * e + self.ratio * (e - v) * (e - v))
    }

    /// k + k1, N/m.
    pub(crate) fn instantaneous_stiffness(&self, stiffness: f64) -> f64 {
        stiffness * (1.0 + self.ratio)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const K: f64 = 1e3;
    const LAW: Viscoelastic = Viscoelastic { ratio: 3.0, relaxation_time: 0.2 };

    /// Tensions, N, energy lost, J, and memory of a rope 1 m long that takes these stretches, m, in steps of `dt`, s, from
    /// rest. Its ends are at rest in each step, so there is no correction where it becomes taut.
    fn led(stretches: &[f64], dt: f64) -> (Vec<f64>, f64, Memory) {
        let (mut memory, mut lost, decay) = (LAW.at_rest(0.0), 0.0, LAW.decay(dt));
        let tension = |&stretch: &f64| {
            let along = AxialMotion::new([1.0 + stretch, 0.0, 0.0], [0.0; 3], 1.0, dt);
            let pull = LAW.pull(&along, K, 0.0, &mut memory, &decay);
            lost += pull.lost;
            pull.tension
        };
        (stretches.iter().map(tension).collect(), lost, memory)
    }

    #[test]
    fn under_a_constant_stretch_the_tension_relaxes_as_the_closed_form() {
        let dt = 0.01;
        let (tensions, _, _) = led(&[0.05; 200], dt);
        let first = tensions[0];
        for (step, tension) in tensions.iter().enumerate() {
            // the first step stretches the rope; then k(t) = k + k1 exp(-t/tau), scaled by the share of k1 left after it
            let left = (first / 0.05 - K) / (LAW.ratio * K);
            let exact = 0.05 * K * (1.0 + LAW.ratio * left * libm::exp(-(step as f64) * dt / LAW.relaxation_time));
            assert!((tension / exact - 1.0).abs() < 1e-12, "step {step}: {tension} N, exact {exact} N");
        }
        assert!((tensions[199] / (0.05 * K) - 1.0).abs() < 2e-4);
    }

    #[test]
    fn a_steady_pull_follows_the_closed_form_at_any_step() {
        // T = k r t + k1 r tau (1 - exp(-t/tau))
        for dt in [1e-3, 0.02, 0.4] {
            let rate = 0.1;
            let stretches: Vec<f64> = (1..=5).map(|step| rate * dt * f64::from(step)).collect();
            for (step, tension) in led(&stretches, dt).0.into_iter().enumerate() {
                let t = dt * (step + 1) as f64;
                let relaxing = LAW.relaxation_time * -libm::expm1(-t / LAW.relaxation_time);
                let exact = K * rate * (t + LAW.ratio * relaxing);
                assert!((tension / exact - 1.0).abs() < 1e-12, "{dt} s, step {step}: {tension} N, exact {exact} N");
            }
        }
    }

    #[test]
    fn a_cycle_loses_what_was_put_in_and_a_slack_rope_recovers() {
        let dt = 1e-4;
        let stretch = |step: usize| 0.05 * (std::f64::consts::PI * step as f64 / 4000.0).sin();
        // out, back to nothing, and on into slackness
        let stretches: Vec<f64> = (1..=8000).map(stretch).collect();
        let (tensions, lost, memory) = led(&stretches, dt);
        let mut work = 0.0;
        for i in 1..8000 {
            work += 0.5 * (tensions[i] + tensions[i - 1]) * (stretches[i] - stretches[i - 1]);
        }
        let left = LAW.elastic_energy(K, &memory);
        let slack_from = tensions.iter().position(|t| *t == 0.0).expect("it goes slack");
        assert!(stretches[slack_from] > 0.005, "slack only at {} m", stretches[slack_from]);
        assert!(tensions.iter().all(|t| *t >= 0.0) && lost > 0.3 * work);
        assert!(((lost + left) / work - 1.0).abs() < 1e-5, "{work} J in, {lost} J lost, {left} J left");
    }

    #[test]
    fn without_time_nothing_changes() {
        let (_, _, memory) = led(&[0.01, 0.05, 0.049, 0.02], 0.07);
        for stretch in [0.02, 0.001, -0.3] {
            let along = AxialMotion::new([1.0 + stretch, 0.0, 0.0], [0.3, 0.0, 0.0], 1.0, 1e-3);
            let mut again = memory;
            let first = LAW.pull(&along, K, 0.0, &mut again, &Decay::NONE);
            let kept = again;
            let second = LAW.pull(&along, K, 0.0, &mut again, &Decay::NONE);
            assert_eq!((first, kept), (second, again));
        }
    }
}
