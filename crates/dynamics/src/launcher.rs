//! Launchers: each holds a node, and throws it at a given time.
//!
//! A launcher either keeps its node where it is and then lets go of it at a given velocity, or guides it along a tube
//! under a given force; in the tube it moves along a straight line only. Its node may be the centre of a rigid
//! body, which then keeps its attitude, or its spin about it, until it is free. docs/theory/launch.md.

use glam::DVec3;

/// A launcher of one node.
#[derive(Debug, Clone, PartialEq)]
pub struct Launcher {
    /// Which node; a body's centre, or a free node.
    pub node: usize,
    /// When it acts, s: until then the node stays where it is.
    pub at: f64,
    /// How it throws.
    pub by: Means,
}

/// How a launcher throws.
#[derive(Debug, Clone, PartialEq)]
pub enum Means {
    /// It lets go at this velocity, m/s, world frame.
    Velocity(DVec3),
    /// It pushes along a tube.
    Tube(Tube),
}

/// A straight tube.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// Where the node starts, m.
    pub breech: DVec3,
    /// Which way it is guided, a unit vector in the world frame.
    pub direction: DVec3,
    /// How far, m.
    pub stroke: f64,
    /// The force that pushes it.
    pub push: Push,
}

/// A force along a tube, N.
#[derive(Debug, Clone, PartialEq)]
pub enum Push {
    /// Over the way that the node has gone, m.
    OverStroke(ForceCurve),
    /// Over the time since the launcher began to act, s.
    OverTime(ForceCurve),
}

/// A force, N, over travel, m, or time, s: linear between the given points, constant before the first and after the last.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceCurve(pub Vec<(f64, f64)>);

impl ForceCurve {
    /// Its value at `x`.
    pub fn at(&self, x: f64) -> f64 {
        let points = &self.0;
        match points.partition_point(|&(at, _)| at <= x) {
            0 => points[0].1,
            after if after == points.len() => points[after - 1].1,
            after => {
                let ((x0, y0), (x1, y1)) = (points[after - 1], points[after]);
                y0 + (x - x0) / (x1 - x0) * (y1 - y0)
            }
        }
    }

    /// Its steepest slope, up or down.
    pub fn steepest(&self) -> f64 {
        let slopes = self.0.windows(2).map(|pair| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs());
        slopes.fold(0.0, f64::max)
    }

    /// Whether it has points, finite and in order, none of them below zero.
    fn is_force(&self) -> bool {
        let in_order = self.0.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let finite = self.0.iter().all(|(x, y)| x.is_finite() && y.is_finite() && *y >= 0.0);
        !self.0.is_empty() && in_order && finite
    }
}

impl Push {
    /// The force after a way of `way` metres and a time of `time` seconds, N.
    pub fn at(&self, way: f64, time: f64) -> f64 {
        match self {
            Push::OverStroke(curve) => curve.at(way),
            Push::OverTime(curve) => curve.at(time),
        }
    }

    /// The work over a way of `stroke` metres, J; none where that depends on what is pushed.
    pub fn work(&self, stroke: f64) -> Option<f64> {
        let Push::OverStroke(curve) = self else { return None };
        let corners = curve.0.iter().map(|&(way, _)| way).filter(|&way| way > 0.0 && way < stroke);
        let ways: Vec<f64> = std::iter::once(0.0).chain(corners).chain([stroke]).collect();
        Some(ways.windows(2).map(|w| 0.5 * (curve.at(w[0]) + curve.at(w[1])) * (w[1] - w[0])).sum())
    }

    fn curve(&self) -> &ForceCurve {
        let (Push::OverStroke(curve) | Push::OverTime(curve)) = self;
        curve
    }
}

impl Launcher {
    /// The reason why it cannot be used, if there is one.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        let is_right = match &self.by {
            Means::Velocity(velocity) => velocity.is_finite() && self.at > 0.0,
            Means::Tube(Tube { breech, direction, stroke, push }) => {
                let finite = breech.is_finite() && direction.is_normalized();
                finite && *stroke > 0.0 && stroke.is_finite() && push.curve().is_force() && self.at >= 0.0
            }
        };
        (!(is_right && self.at.is_finite())).then_some("is launched before the start, or by no force along no line")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_straight_between_its_points_and_constant_beyond() {
        let curve = ForceCurve(vec![(1.0, 4.0), (2.0, 6.0), (4.0, 0.0)]);
        let found = [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 9.0].map(|x| curve.at(x));
        assert_eq!(found, [4.0, 4.0, 5.0, 6.0, 3.0, 0.0, 0.0]);
        assert_eq!(curve.steepest(), 3.0);
        assert_eq!(ForceCurve(vec![(0.0, 5.0)]).at(7.0), 5.0);
        // 4, then from 4 to 6, then from 6 to 3
        assert_eq!(Push::OverStroke(curve).work(3.0), Some(4.0 + 5.0 + 4.5));
    }
}
