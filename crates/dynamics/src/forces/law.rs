//! The law by which a segment pulls along itself: which there are, and what they share.
//!
//! | law | file | tension | memory | lost in |
//! |---|---|---|---|---|
//! | linear | [`rope_tension`] | k d | | rope_damping |
//! | bilinear | [`bilinear`](super::bilinear) | another stiffness beyond a strain | | rope_damping |
//! | tabulated | [`tabulated`](super::tabulated) | a table, unloading on a path of its own | largest strain | rope_hysteresis |
//! | viscoelastic | [`viscoelastic`](super::viscoelastic) | standard linear solid | dashpot | rope_damping |
//! | strut | [`strut`] | k d, and pushes | | rope_damping |
//!
//! Beside each works the damper c d' of [`rope_tension`]; all but the strut pull only where they are taut, and never
//! push. d is the stretch, m. A law belongs to a group, its stiffness k and damping c to each segment.

use std::sync::Arc;

use super::bilinear::Bilinear;
pub use super::memory::Memory;
use super::rope_tension::{self, AxialMotion, Pull};
use super::segment::Segment;
use super::strut;
use super::tabulated::Tabulated;
use super::viscoelastic::{Decay, Viscoelastic};

/// A law of tension against stretch.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Law {
    /// Tension in proportion to stretch.
    #[default]
    Linear,
    /// A second stiffness beyond a strain.
    Bilinear(Bilinear),
    /// A measured curve, and one for unloading where there is hysteresis.
    Tabulated(Arc<Tabulated>),
    /// Stiffer at first, relaxing with time.
    Viscoelastic(Viscoelastic),
    /// Pulls and pushes.
    Strut,
}

/// Rest length, stiffness and damping of a segment along its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axial {
    /// Length without tension, m.
    pub rest_length: f64,
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Damping c, N s/m.
    pub damping: f64,
}

impl Axial {
    /// No segment, or one that is broken: it is never taut.
    pub const GONE: Axial = Axial { rest_length: f64::MAX, stiffness: 0.0, damping: 0.0 };
}

impl From<&Segment> for Axial {
    fn from(s: &Segment) -> Axial {
        Axial { rest_length: s.rest_length, stiffness: s.stiffness, damping: s.damping }
    }
}

impl Law {
    /// Its parameters, and whether each is in range. Tables are checked when they are made.
    pub(crate) fn parameters(&self) -> Vec<(&'static str, f64, bool)> {
        match *self {
            Law::Linear | Law::Tabulated(_) | Law::Strut => Vec::new(),
            Law::Bilinear(Bilinear { strain, ratio }) => {
                vec![("strain at the bend", strain, strain >= 0.0), ("ratio of stiffnesses", ratio, ratio >= 0.0)]
            }
            Law::Viscoelastic(Viscoelastic { ratio, relaxation_time }) => vec![
                ("ratio of stiffnesses", ratio, ratio > 0.0),
                ("relaxation time, s", relaxation_time, relaxation_time > 0.0),
            ],
        }
    }

    /// The law under a lasting tension: relaxation is complete, and a table gives its loading curve.
    pub fn lasting(&self) -> Law {
        match self {
            Law::Linear | Law::Viscoelastic(_) => Law::Linear,
            Law::Bilinear(law) => Law::Bilinear(*law),
            Law::Tabulated(law) => Law::Tabulated(Arc::new(law.loading())),
            Law::Strut => Law::Strut,
        }
    }

    /// The largest stiffness against a small stretch that a segment can show, N/m: what bounds the step.
    pub fn largest_stiffness(&self, segment: &Axial) -> f64 {
        match self {
            Law::Linear | Law::Strut => segment.stiffness,
            Law::Bilinear(law) => law.largest_stiffness(segment.stiffness),
            Law::Tabulated(law) => law.largest_slope() / segment.rest_length,
            Law::Viscoelastic(law) => law.instantaneous_stiffness(segment.stiffness),
        }
    }

    /// The strain under a lasting tension, N, of a rope of axial stiffness `axial_stiffness` = k L0, N.
    pub fn strain_under(&self, tension: f64, axial_stiffness: f64) -> f64 {
        match self {
            Law::Linear | Law::Strut | Law::Viscoelastic(_) => tension / axial_stiffness,
            Law::Bilinear(law) => law.strain_under(tension, axial_stiffness),
            Law::Tabulated(law) => law.strain_under(tension),
        }
    }

    /// Whether the law has state: whether its tension depends on the past of a segment.
    pub fn remembers(&self) -> bool {
        match self {
            Law::Linear | Law::Bilinear(_) | Law::Strut => false,
            Law::Tabulated(law) => law.has_hysteresis(),
            Law::Viscoelastic(_) => true,
        }
    }

    /// Memory of a segment that has been held at `stretch`, m, until it no longer changes.
    pub fn at_rest(&self, stretch: f64) -> Memory {
        match self {
            Law::Viscoelastic(law) => law.at_rest(stretch),
            Law::Linear | Law::Bilinear(_) | Law::Tabulated(_) | Law::Strut => [0.0; 2],
        }
    }

    /// How memory relaxes in `elapsed` seconds.
    pub(crate) fn decay(&self, elapsed: f64) -> Decay {
        match self {
            Law::Viscoelastic(law) => law.decay(elapsed),
            Law::Linear | Law::Bilinear(_) | Law::Tabulated(_) | Law::Strut => Decay::NONE,
        }
    }

    /// Tension of a segment and its force on the nodes. `span` = x_b - x_a, m; `rate` = v_b - v_a, m/s; `dt` the step, s; `decay` is that of the
    /// time since the forces before.
    #[inline]
    pub(crate) fn pull(
        &self,
        span: [f64; 3],
        rate: [f64; 3],
        Axial { rest_length, stiffness, damping }: Axial,
        memory: &mut Memory,
        dt: f64,
        decay: &Decay,
    ) -> Pull {
        let along = AxialMotion::new(span, rate, rest_length, dt);
        let AxialMotion { stretch, swept, .. } = along;
        let taut = stretch > 0.0;
        match self {
            Law::Linear => rope_tension::pull(span, rate, rest_length, stiffness, damping, dt),
            Law::Bilinear(law) => along.pulled(taut, law.tension(stretch, swept, rest_length, stiffness), damping),
            Law::Tabulated(law) => along.pulled(taut, law.tension(stretch, swept, rest_length, memory), damping),
            Law::Viscoelastic(law) => law.pull(&along, stiffness, damping, memory, decay),
            Law::Strut => strut::pull(&along, stiffness, damping),
        }
    }

    /// Elastic energy of a segment at this stretch, m, in J: what unloading gives back.
    pub fn elastic_energy(&self, stretch: f64, segment: &Axial, memory: &Memory) -> f64 {
        let &Axial { rest_length, stiffness, .. } = segment;
        match self {
            Law::Linear => rope_tension::elastic_energy(stretch, stiffness),
            Law::Bilinear(law) => law.elastic_energy(stretch, rest_length, stiffness),
            Law::Tabulated(law) => law.elastic_energy(stretch, rest_length, memory),
            Law::Viscoelastic(law) => law.elastic_energy(stiffness, memory),
            Law::Strut => strut::elastic_energy(stretch, stiffness),
        }
    }

    /// Energy that a segment has lost to hysteresis so far, J.
    pub fn hysteresis(&self, segment: &Axial, memory: &Memory) -> f64 {
        match self {
            Law::Tabulated(law) => law.hysteresis(segment.rest_length, memory),
            Law::Linear | Law::Bilinear(_) | Law::Viscoelastic(_) | Law::Strut => 0.0,
        }
    }
}
