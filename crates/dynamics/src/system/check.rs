//! That a system's parts fit each other, and have values that can be computed with.

use super::{Environment, SystemError, SystemParts};
use crate::effects;
use crate::forces::breaking::Breaking;

impl SystemParts {
    /// The first thing that is out of range, if there is one.
    pub(super) fn check(&self) -> Result<(), SystemError> {
        let nodes = self.mass.len();
        if nodes == 0 {
            return Err(SystemError::Empty);
        }
        for (what, found) in [("held", self.held.len()), ("tractor", self.tractor.len())] {
            if found != nodes {
                return Err(SystemError::Shape { what, found, expected: nodes });
            }
        }
        effects::check(self)?;
        let mut carried = vec![false; nodes];
        for tie in self.bodies.iter().flat_map(|body| &body.ties) {
            carried[tie.node] = true;
        }
        for (node, &mass) in self.mass.iter().enumerate() {
            let enough = if carried[node] {
                mass == 0.0
            } else if self.held[node] {
                mass >= 0.0
            } else {
                mass > 0.0
            };
            if !(enough && mass.is_finite()) {
                return Err(SystemError::Mass { node, mass });
            }
        }
        for (segment, s) in self.segments.iter().enumerate() {
            let [a, b] = s.ends;
            if a == b || a >= nodes || b >= nodes {
                return Err(SystemError::Ends { segment, ends: s.ends, nodes });
            }
            let checks = [
                ("rest length, m", s.rest_length, s.rest_length > 0.0),
                ("stiffness, N/m", s.stiffness, s.stiffness > 0.0),
                ("damping, N s/m", s.damping, s.damping >= 0.0),
                ("group", s.group as f64, s.group < self.laws.len()),
            ];
            for (what, value, holds) in checks {
                if !(holds && value.is_finite()) {
                    return Err(SystemError::Property { segment, what, value });
                }
            }
            let Breaking { load, strain, cut_at } = s.breaking;
            // infinite: it never breaks
            let most = [
                ("breaking load, N", load, load > 0.0),
                ("breaking strain", strain, strain > 0.0),
                ("time of the cut, s", cut_at, cut_at >= 0.0),
            ];
            if let Some((what, value, _)) = most.into_iter().find(|(_, _, holds)| !holds) {
                return Err(SystemError::Property { segment, what, value });
            }
        }
        for (group, law) in self.laws.iter().enumerate() {
            let wrong = law.parameters().into_iter().find(|(_, value, holds)| !(*holds && value.is_finite()));
            if let Some((what, value, _)) = wrong {
                return Err(SystemError::Law { group, what, value });
            }
        }
        let Environment { gravity, mass_damping, .. } = self.environment;
        if !gravity.is_finite() {
            return Err(SystemError::Environment { what: "gravity, m/s^2", value: gravity.length() });
        }
        if !(mass_damping >= 0.0 && mass_damping.is_finite()) {
            return Err(SystemError::Environment { what: "damping, 1/s", value: mass_damping });
        }
        Ok(())
    }
}
