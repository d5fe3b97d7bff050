//! Packs a run into the page, which replays it in three dimensions.
//!
//! ```text
//!  Scene ──▶ thin  leaves out nodes inside ropes where there are too many ─┐
//!        └─▶ pack  whole numbers, differences in time, deflate           ◀─┴─▶ one element of base64
//! ```
//!
//! The element is text that the browser ignores until `data.js` inflates it with the browser's own functions.
//! `view.js` draws the net with WebGL 2, `signs.js` the ruler and the wind over it, `player.js` is the clock, `camera.js` the camera, `controls.js` the buttons
//! and `gestures.js` the keys and pointers.

mod pack;
mod thin;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use pack::{Sampling, pack};
use thin::Drawn;

use crate::results::Scene;

/// Size limit of all replays of a page, bytes of base64. A page of several designs divides it among them.
pub(crate) const BUDGET_BYTES: usize = 12_000_000;

/// Most segments of a replay: an ordinary graphics processor draws as many sixty times a second.
const MOST_SEGMENTS: usize = 40_000;

/// With fewer frames than this, slow motion looks interpolated: nodes inside ropes are then left out instead of frames.
const FRAMES_WORTH_KEEPING: usize = 120;

/// The script that defines `NetcastReplay` with `decode`, `View` and `Player`.
pub(crate) const SCRIPT: &str = concat!(
    "const NetcastReplay = (() => {\n\"use strict\";\n",
    include_str!("data.js"),
    include_str!("camera.js"),
    include_str!("shaders.js"),
    include_str!("labels.js"),
    include_str!("signs.js"),
    include_str!("meshes.js"),
    include_str!("view.js"),
    include_str!("gestures.js"),
    include_str!("controls.js"),
    include_str!("player.js"),
    "return { decode, View, Player };\n})();\n",
);

/// The CSS of views and controls. The variables of the surrounding page give the colours.
pub(crate) const STYLE: &str = include_str!("replay.css");

/// A run that is packed for the page.
pub(crate) struct Replay {
    /// The element for `NetcastReplay.decode`; empty where the run does not fit.
    pub element: String,
    /// A sentence on what is left out; none where the replay is complete.
    pub thinned: Option<String>,
}

/// Packs a run into an element with this id, of about `budget` bytes at most.
///
/// `wind` is the wind at the muzzle at the start, m/s, which the replay shows as an arrow.
///
/// A larger run loses frames first and then nodes inside ropes. The frames of the largest area and of the largest
/// tension always stay.
pub(crate) fn replay(scene: &Scene, id: &str, budget: usize, wind: Option<[f64; 3]>) -> Replay {
    let segments = scene.fields.topology.segments.len();
    let mut sampling = Sampling { frames: 1, nodes: segments.div_ceil(MOST_SEGMENTS).max(1) };
    let mut drawn = Drawn::of(scene, sampling.nodes);
    loop {
        let packed = STANDARD.encode(pack(scene, &drawn, sampling.frames, wind));
        if packed.len() <= budget {
            let element = format!("<script type=\"application/octet-stream;base64\" id=\"{id}\">{packed}</script>\n");
            return Replay { element, thinned: thinned(scene, sampling) };
        }
        let excess = packed.len().div_ceil(budget);
        let frames = scene.frames().div_ceil(sampling.frames * excess);
        // thin further only while that removes nodes, so that the loop ends
        let coarser = Drawn::of(scene, sampling.nodes + 1);
        if frames < FRAMES_WORTH_KEEPING && coarser.nodes.len() < drawn.nodes.len() {
            sampling.nodes += 1;
            drawn = coarser;
        } else if sampling.frames < scene.frames() {
            sampling.frames *= excess;
        } else {
            return Replay {
                element: String::new(),
                thinned: Some("The run is too large to be replayed here.".into()),
            };
        }
    }
}

/// The sentence on the frames and nodes that are left out.
fn thinned(scene: &Scene, sampling: Sampling) -> Option<String> {
    let frames =
        (sampling.frames > 1).then(|| format!("every {} of {} frames", ordinal(sampling.frames), scene.frames()));
    let nodes = (sampling.nodes > 1).then(|| format!("every {} node of a rope", ordinal(sampling.nodes)));
    let parts: Vec<String> = [frames, nodes].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("The replay holds {}.", parts.join(" and ")))
}

fn ordinal(number: usize) -> String {
    let ending = match (number % 10, number % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{number}{ending}")
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::ZlibDecoder;
    use glam::{DQuat, DVec3};
    use netcast_results::{
        BodyKind, BodyMark, BodyShape, FieldsTopology, FieldsWriter, Group, Landmark, Landmarks, LinkClass, NamedRope,
        folder,
    };
    use serde_json::Value;

    use super::*;
    use crate::results::Results;

    const SEGMENTS: usize = 600;
    const FRAMES: usize = 400;
    /// The frame of the largest tension.
    const HARDEST_FRAME: usize = 137;

    /// The motion of a rope whose nodes move without a pattern. Each of its two classes has 300 segments.
    fn position(frame: usize, node: usize) -> DVec3 {
        let (t, s) = (frame as f64 * 1e-3, node as f64);
        DVec3::new((3.0 * t + s).sin() + 0.01 * s, (5.0 * t + s * s).cos(), 40.0 * t + (7.0 * t * s).sin())
    }

    fn tension(frame: usize, segment: usize) -> f64 {
        match (frame, segment) {
            (HARDEST_FRAME, 5) => 5e4,
            _ if (frame + segment).is_multiple_of(3) => 0.0,
            _ => 0.7 * ((frame * 31 + segment * 17) % 997) as f64 + 0.6,
        }
    }

    fn turned(frame: usize) -> DQuat {
        DQuat::from_rotation_x(0.1 * frame as f64) * DQuat::from_rotation_z(0.3)
    }

    fn scene() -> Scene {
        let landmarks = Landmarks {
            ground: None,
            axis: DVec3::Z,
            outline: vec![vec![0], vec![200], vec![400]],
            reference_area: Some(4.0),
            flat_posture: 0.0,
            corners: vec![0],
            mouth: Vec::new(),
            mouth_reach: Vec::new(),
            cells: Vec::new(),
            target_diameter: None,
            tractors: vec![SEGMENTS],
            centre: vec![300],
            points: vec![Landmark { name: "B".into(), nodes: vec![77], is_group: false, segments: vec![77] }],
            supports: Vec::new(),
            bottom: Vec::new(),
            classes: ["one", "other"]
                .map(|name| LinkClass { name: name.into(), is_rope: true, strength: None })
                .to_vec(),
            ropes: vec![NamedRope { name: "rope".into(), strength: None, knot_reduction: None }],
            groups: [0, 1].map(|class| Group { class, rope: Some(0) }).to_vec(),
            canopies: Vec::new(),
            cloth_strength: None,
            bodies: vec![BodyMark {
                kind: BodyKind::Tractor,
                node: 77,
                shape: BodyShape::Box { size_m: [0.1, 0.2, 0.3] },
                rigid: Some(0),
            }],
        };
        let mut fields = FieldsWriter::new(FieldsTopology {
            nodes: SEGMENTS + 1,
            segments: (0..SEGMENTS as u32).map(|node| [node, node + 1]).collect(),
            classes: (0..SEGMENTS as u32).map(|segment| segment / 300).collect(),
            triangles: Vec::new(),
            class_names: vec!["one".into(), "other".into()],
            labels: Vec::new(),
            bodies: vec![77],
        })
        .unwrap();
        for frame in 0..FRAMES {
            let positions: Vec<DVec3> = (0..=SEGMENTS).map(|node| position(frame, node)).collect();
            let tensions: Vec<f64> = (0..SEGMENTS).map(|segment| tension(frame, segment)).collect();
            fields
                .push(frame as f64 * 1e-3, &positions, &vec![DVec3::ZERO; SEGMENTS + 1], &tensions, &[turned(frame)])
                .unwrap();
        }
        let dir = tempfile::tempdir().unwrap();
        let within = |name: &str| dir.path().join(name);
        fields.finish(&within(folder::FIELDS)).unwrap();
        landmarks.write(&within(folder::LANDMARKS)).unwrap();
        std::fs::write(within(folder::SUMMARY), "{}").unwrap();
        std::fs::write(within(folder::MANIFEST), "{}").unwrap();
        std::fs::write(within(folder::HISTORY), "time_s\n").unwrap();
        Results::read(dir.path()).unwrap().scene.expect("the folder has fields and landmarks")
    }

    /// The decoded element: JSON, ends of the segments, positions, m, and codes of tensions by frame.
    struct Unpacked {
        meanings: Value,
        ends: Vec<u32>,
        positions: Vec<Vec<DVec3>>,
        tensions: Vec<Vec<u8>>,
    }

    fn unpacked(replay: &Replay) -> Unpacked {
        let text = replay.element.split_once('>').unwrap().1.split_once('<').unwrap().0;
        let mut bytes = Vec::new();
        ZlibDecoder::new(&STANDARD.decode(text).unwrap()[..]).read_to_end(&mut bytes).unwrap();
        let mut rest = &bytes[..];
        let mut take = |count: usize| {
            let (taken, after) = rest.split_at(count);
            rest = after;
            taken
        };
        let length = u32::from_le_bytes(take(4).try_into().unwrap()) as usize;
        assert_eq!(length % 4, 0, "the ends of segments are read as numbers of four bytes");
        let meanings: Value = serde_json::from_slice(take(length)).unwrap();
        let count = |name: &str| meanings[name].as_u64().unwrap() as usize;
        let (frames, nodes, segments) = (count("frames"), count("nodes"), count("segments"));
        let ends = take(8 * segments).chunks(4).map(|end| u32::from_le_bytes(end.try_into().unwrap())).collect();
        take(segments);
        let (low, high) = (take(3 * nodes * frames), take(3 * nodes * frames));
        let origin: Vec<f64> = meanings["origin_m"].as_array().unwrap().iter().map(|m| m.as_f64().unwrap()).collect();
        let mut steps: Vec<Vec<i32>> = Vec::new();
        for frame in 0..frames {
            let codes = (3 * nodes * frame..).take(3 * nodes).map(|at| i32::from(low[at]) + 256 * i32::from(high[at]));
            let expected = |at: usize| match frame {
                0 => 0,
                1 => steps[0][at],
                _ => 2 * steps[frame - 1][at] - steps[frame - 2][at],
            };
            let unfolded = |code: i32| if code % 2 == 0 { code / 2 } else { -(code + 1) / 2 };
            let row = codes.enumerate().map(|(at, code)| (expected(at) + unfolded(code)).rem_euclid(1 << 16)).collect();
            steps.push(row);
        }
        let place = |row: &[i32], node: usize| {
            let along =
                |axis: usize| origin[axis] + meanings["step_m"].as_f64().unwrap() * f64::from(row[axis * nodes + node]);
            DVec3::new(along(0), along(1), along(2))
        };
        let positions = steps.iter().map(|row| (0..nodes).map(|node| place(row, node)).collect()).collect();
        let tensions = (0..frames).map(|_| take(segments).to_vec()).collect();
        assert!(rest.is_empty());
        Unpacked { meanings, ends, positions, tensions }
    }

    #[test]
    fn an_unpacked_replay_equals_the_run_to_within_its_rounding() {
        let replay = replay(&scene(), "run", BUDGET_BYTES, None);
        assert_eq!(replay.thinned, None);
        assert!(replay.element.starts_with("<script type=\"application/octet-stream;base64\" id=\"run\">"));
        let Unpacked { meanings, ends, positions, tensions } = unpacked(&replay);
        let step = meanings["step_m"].as_f64().unwrap();
        // the run is less than 20 m long, so a step is at most a third of a millimetre
        assert!(step < 20.0 / 65535.0);
        assert_eq!((positions.len(), ends[..4].to_vec()), (FRAMES, vec![0, 1, 1, 2]));
        let largest = meanings["tension_max_n"].as_f64().unwrap();
        assert_eq!(largest, 5e4);
        for frame in 0..FRAMES {
            for node in 0..=SEGMENTS {
                let off = (positions[frame][node] - position(frame, node)).abs().max_element();
                assert!(off <= 0.5001 * step, "node {node} of frame {frame} is {off} m off");
            }
            for segment in 0..SEGMENTS {
                let code = f64::from(tensions[frame][segment]);
                let expected = tension(frame, segment);
                let shown = if code == 0.0 { 0.0 } else { largest * 10_f64.powf(5.0 * (code - 254.0) / 253.0) };
                assert!((shown - expected).abs() <= 0.024 * expected, "{shown} N for {expected} N");
            }
        }
        assert_eq!(meanings["points"], serde_json::json!([{"name": "B", "nodes": [77]}]));
        let body = &meanings["bodies"][0];
        assert_eq!((&body["shape"], &body["size_m"]), (&"box".into(), &serde_json::json!([0.1, 0.2, 0.3])));
        let parts: Vec<f64> = body["turned"].as_array().unwrap().iter().map(|part| part.as_f64().unwrap()).collect();
        assert_eq!(parts.len(), 4 * FRAMES);
        for (frame, parts) in parts.chunks(4).enumerate() {
            assert!(DQuat::from_slice(parts).normalize().angle_between(turned(frame)) < 2e-4, "frame {frame}");
        }
    }

    #[test]
    fn nodes_without_ropes_or_meanings_are_listed_as_aside() {
        let Scene { fields, mut landmarks, .. } = scene();
        landmarks.classes[1].is_rope = false;
        let meanings = unpacked(&replay(&Scene::new(fields, landmarks), "run", BUDGET_BYTES, None)).meanings;
        // the ropes end at node 300; of the nodes beyond, the outline and the tractor have a meaning
        let aside: Vec<usize> = (301..SEGMENTS).filter(|&node| node != 400).collect();
        assert_eq!(meanings["aside"], serde_json::json!(aside));
    }

    #[test]
    fn a_small_budget_leaves_out_frames_but_not_that_of_the_largest_tension() {
        let whole = replay(&scene(), "run", BUDGET_BYTES, None).element.len();
        let replay = replay(&scene(), "run", 2 * whole / 5, None);
        assert!(replay.element.len() < 2 * whole / 5 + 100);
        assert_eq!(replay.thinned.as_deref(), Some("The replay holds every 3rd of 400 frames."));
        let unpacked = unpacked(&replay);
        let times: Vec<f64> =
            unpacked.meanings["times_s"].as_array().unwrap().iter().map(|t| t.as_f64().unwrap()).collect();
        let hardest = times.iter().position(|&time| time == HARDEST_FRAME as f64 * 1e-3);
        let hardest = hardest.expect("the frame of the largest tension stays");
        assert_eq!(unpacked.tensions[hardest][5], 254);
        assert_eq!(times.last(), Some(&0.399));
    }

    #[test]
    fn a_smaller_budget_leaves_out_nodes_inside_ropes() {
        let scene = scene();
        let whole = replay(&scene, "run", BUDGET_BYTES, None).element.len();
        let replay = replay(&scene, "run", whole / 10, None);
        assert!(replay.element.len() < whole / 10 + 100);
        let thinned = replay.thinned.as_deref().unwrap();
        assert!(thinned.contains("frames and every ") && thinned.ends_with(" node of a rope."), "{thinned}");
        let unpacked = unpacked(&replay);
        // B has kept its position
        let place = unpacked.meanings["points"][0]["nodes"][0].as_u64().unwrap() as usize;
        assert!((unpacked.positions[0][place] - position(0, 77)).length() < 1e-3);
        assert!(unpacked.positions[0].len() < SEGMENTS && unpacked.ends.len() == 2 * (unpacked.positions[0].len() - 1));
    }

    #[test]
    fn a_budget_too_small_for_any_replay_gives_none() {
        let replay = replay(&scene(), "run", 100, None);
        assert_eq!((replay.element.as_str(), replay.thinned.is_some()), ("", true));
    }

    #[test]
    fn ordinals_have_their_english_endings() {
        let places = [1, 2, 3, 4, 11, 12, 22, 101, 113].map(ordinal);
        assert_eq!(places, ["1st", "2nd", "3rd", "4th", "11th", "12th", "22nd", "101st", "113th"]);
    }
}
