//! Nodes that are led along paths. The law is [`crate::drive`].

use super::contract::{Effect, Forces, Net, Now};
use super::traced::TracedWork;
use crate::channel::Channel;
use crate::moving::Moving;
use crate::parts::{PartKind, SystemError, SystemParts};

/// Drives in motion. A relaxation leaves them where their paths begin.
#[derive(Debug, Clone)]
pub(super) struct Drives {
    /// Force on each driven node, followed for its work.
    traced: Vec<TracedWork>,
    /// How each of them moves.
    moving: Vec<Moving>,
}

impl Effect for Drives {
    const NAME: &'static str = "drive";
    const CHANNELS: &'static [Channel] = &[Channel::Drive];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let traced = || vec![TracedWork::default(); parts.drives.len()];
        (!parts.drives.is_empty()).then(|| Drives { traced: traced(), moving: Vec::new() })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        for (index, drive) in parts.drives.iter().enumerate() {
            let ascending = drive.path.windows(2).all(|pair| pair[0].0 < pair[1].0);
            let finite = drive.path.iter().all(|(time, place)| time.is_finite() && place.is_finite());
            let is_held = parts.held.get(drive.node).is_some_and(|held| *held);
            if !is_held || drive.path.is_empty() || !(ascending && finite) {
                let why = "is not held, or whose path does not go forward in time";
                return Err(SystemError::attached(PartKind::Drive, index, drive.node, why));
            }
        }
        Ok(())
    }

    /// It moves its nodes and exerts no force on them.
    fn nodes(_: &SystemParts, _: &mut dyn FnMut(usize)) {}

    fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        for (drive, traced) in now.parts.drives.iter().zip(&mut self.traced) {
            let pull = net.with_ropes(drive.node, out.force[drive.node]);
            out.work[Channel::Drive] += traced.work(pull, net.node(drive.node).x);
        }
    }

    fn placed(&mut self, parts: &SystemParts, node: &dyn Fn(usize) -> Moving) {
        self.moving = parts.drives.iter().map(|drive| node(drive.node)).collect();
    }

    fn moved(&mut self, now: &Now, _: &dyn Fn(usize) -> Moving, out: &mut Forces) {
        for (drive, driven) in now.parts.drives.iter().zip(&mut self.moving) {
            let x = drive.at(now.time);
            let v = (x - driven.x) / now.factors.dt;
            *driven = Moving { x, v, w: 1.5 * v - 0.5 * driven.v };
            out.carried.push((drive.node, *driven));
        }
    }
}
