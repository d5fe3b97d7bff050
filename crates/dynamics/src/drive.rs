//! Driven nodes: moved along given paths, whatever pulls at them. A body whose centre of mass is driven turns as what
//! pulls at its ties would have it.

use glam::DVec3;

/// A node's path: straight and at constant speed from one point to the next; it rests before the first and after the
/// last.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Which node; it is held, and moved by this alone.
    pub node: usize,
    /// Times, s, ascending, and positions, m; at least one.
    pub path: Vec<(f64, DVec3)>,
}

impl Drive {
    /// Where it is at `time`, s.
    pub fn at(&self, time: f64) -> DVec3 {
        let after = self.path.partition_point(|&(t, _)| t <= time);
        let last = self.path.len() - 1;
        match after {
            0 => self.path[0].1,
            after if after > last => self.path[last].1,
            after => {
                let ((t0, x0), (t1, x1)) = (self.path[after - 1], self.path[after]);
                x0 + ((time - t0) / (t1 - t0)) * (x1 - x0)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_straight_between_its_points_and_rests_beyond() {
        let drive = Drive { node: 0, path: vec![(1.0, DVec3::ZERO), (2.0, DVec3::X), (4.0, 5.0 * DVec3::X)] };
        let x = |time| drive.at(time).x;
        assert_eq!([x(0.0), x(1.0), x(1.5), x(2.0), x(3.0), x(4.0), x(9.0)], [0.0, 0.0, 0.5, 1.0, 3.0, 5.0, 5.0]);
    }
}
