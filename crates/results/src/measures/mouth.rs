//! The mouth of the web: how it leans and how evenly its corners stand.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::geometry::mean;
use crate::landmarks::Landmarks;

/// Share of the flat web's area below which the mouth faces nowhere in particular.
const FACES_NOWHERE: f64 = 0.01;

/// The mouth at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct MouthStance {
    /// Angle between the outline's vector area and the launch axis, rad: 0 where the mouth faces along the axis, pi/2
    /// where it stands edge on. None while the outline is nearly closed.
    pub tilt: Option<f64>,
    /// How unevenly the corners stand: with q the distance of a corner from the mean of all corners as seen along the
    /// axis, over the same in the flat web, (largest q - smallest q) / mean q. 0 where they all stand out alike.
    pub asymmetry: Option<f64>,
}

impl MouthStance {
    /// The mouth at `position`s.
    pub fn new(landmarks: &Landmarks, position: impl Fn(usize) -> DVec3) -> MouthStance {
        MouthStance { tilt: tilt(landmarks, &position), asymmetry: asymmetry(landmarks, &position) }
    }
}

fn tilt(landmarks: &Landmarks, position: impl Fn(usize) -> DVec3) -> Option<f64> {
    let area = landmarks.outline_area(position)?;
    let faces = area.length() > FACES_NOWHERE * landmarks.reference_area?;
    // which of the two sides faces forwards makes no difference
    faces.then(|| libm::atan2(area.cross(landmarks.axis).length(), area.dot(landmarks.axis).abs()))
}

fn asymmetry(landmarks: &Landmarks, position: impl Fn(usize) -> DVec3) -> Option<f64> {
    let places: Vec<DVec3> = landmarks.mouth.iter().map(|nodes| mean(nodes, &position)).collect();
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    let reach = |place: &DVec3| (place - middle).reject_from_normalized(landmarks.axis).length();
    let flat = &landmarks.mouth_reach;
    if places.len() < 2 || flat.iter().any(|&flat| flat <= 0.0) {
        return None;
    }
    let ratios: Vec<f64> = places.iter().zip(flat).map(|(place, flat)| reach(place) / flat).collect();
    let average = ratios.iter().sum::<f64>() / ratios.len() as f64;
    let (least, most) = (ratios.iter().copied().fold(f64::MAX, f64::min), ratios.iter().copied().fold(0.0, f64::max));
    (average > 0.0).then(|| (most - least) / average)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of 2 m with its corners as outline and mouth, seen along z.
    fn square() -> (Landmarks, [DVec3; 4]) {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        let each: Vec<Vec<usize>> = (0..4).map(|corner| vec![corner]).collect();
        let landmarks = Landmarks {
            axis: DVec3::Z,
            outline: each.clone(),
            reference_area: Some(4.0),
            mouth: each,
            mouth_reach: vec![2.0_f64.sqrt(); 4],
            ..Landmarks::default()
        };
        (landmarks, corners)
    }

    #[test]
    fn a_square_turned_about_an_edge_is_tilted_by_that_angle() {
        let (landmarks, corners) = square();
        for angle in [0.0, 0.2, 1.2, 2.9] {
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            let turn = |r: DVec3| DVec3::new(r.x, cosine * r.y, sine * r.y) + DVec3::new(5.0, -3.0, 8.0);
            let mouth = MouthStance::new(&landmarks, |corner| turn(corners[corner]));
            // a mouth that looks backwards is tilted as one that looks forwards
            let expected = f64::min(angle, std::f64::consts::PI - angle);
            assert!((mouth.tilt.unwrap() - expected).abs() < 1e-12, "{:?} for {angle}", mouth.tilt);
        }
    }

    #[test]
    fn a_mouth_that_opens_alike_on_all_sides_is_symmetric_and_one_lame_corner_shows() {
        let (landmarks, corners) = square();
        let scaled = MouthStance::new(&landmarks, |corner| 0.3 * corners[corner] + DVec3::new(7.0, 0.0, 1.0));
        assert!(scaled.asymmetry.unwrap() < 1e-12);

        // one corner at half its reach: the mean moves by an eighth of the diagonal's half towards the opposite one
        let lame = MouthStance::new(&landmarks, |corner| if corner == 0 { 0.5 * corners[0] } else { corners[corner] });
        let reach = |x: f64, y: f64| f64::hypot(x + 0.125, y + 0.125);
        let reaches = [reach(0.5, 0.5), reach(-1.0, 1.0), reach(-1.0, -1.0), reach(1.0, -1.0)];
        let average = reaches.iter().sum::<f64>() / 4.0;
        let (least, most) = (reaches.into_iter().fold(9.0, f64::min), reaches.into_iter().fold(0.0, f64::max));
        assert!((lame.asymmetry.unwrap() - (most - least) / average).abs() < 1e-12);
        assert!(lame.asymmetry.unwrap() > 0.4);
    }

    #[test]
    fn a_closed_mouth_faces_nowhere() {
        let (landmarks, corners) = square();
        let mouth = MouthStance::new(&landmarks, |corner| 0.05 * corners[corner]);
        assert_eq!(mouth.tilt, None);
        assert_eq!(MouthStance::new(&landmarks, |_| DVec3::ZERO).asymmetry, None);
    }
}
