//! The pictures of a result folder: their contents, where parts lie in them, and the files of the folder afterwards.

use std::fs;
use std::path::Path;

use gif::{DecodeOptions, DisposalMethod, Repeat};
use glam::DVec3;
use netcast_report::{ReportError, write_pictures, write_report};
use netcast_results::{
    BodyKind, BodyMark, BodyShape, FieldsTopology, FieldsWriter, Group, Landmark, Landmarks, LinkClass, NamedRope,
};
use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Options, Tree};
use serde_json::{Value, json};
use tempfile::TempDir;

/// Tensions of the outline's four ropes, N, and the first and last colour of the map.
const TENSIONS: [f64; 4] = [1000.0, 0.0, 0.05, 1000.0];
const LOWEST: [u8; 3] = [0x19, 0x57, 0xd2];
const HIGHEST: [u8; 3] = [0xf6, 0x80, 0x01];
const INK: [u8; 3] = [0x1c, 0x21, 0x26];
const ACCENT: [u8; 3] = [0x0b, 0x5c, 0x8a];
const WHITE: [u8; 3] = [255; 3];

/// A square of four ropes, 2 m wide when flat, with tractors of 0.2 m at its corners. Its middle is their mean.
fn landmarks() -> Landmarks {
    let corners: Vec<usize> = (0..4).collect();
    let tractor = |node| BodyMark {
        kind: BodyKind::Tractor,
        node,
        shape: BodyShape::Cylinder { diameter_m: 0.2, height_m: 0.3 },
        rigid: None,
    };
    Landmarks {
        ground: None,
        axis: DVec3::Z,
        outline: corners.iter().map(|&corner| vec![corner]).collect(),
        reference_area: Some(4.0),
        flat_posture: 0.0,
        corners: corners.clone(),
        mouth: corners.iter().map(|&corner| vec![corner]).collect(),
        mouth_reach: vec![2.0_f64.sqrt(); 4],
        cells: Vec::new(),
        target_diameter: None,
        tractors: corners.clone(),
        centre: corners.clone(),
        points: vec![Landmark { name: "B".into(), nodes: corners, is_group: false, segments: vec![0] }],
        supports: Vec::new(),
        bottom: vec![0],
        classes: vec![LinkClass { name: "outline".into(), is_rope: true, strength: None }],
        ropes: vec![NamedRope { name: "rope".into(), strength: None, knot_reduction: None }],
        groups: vec![Group { class: 0, rope: Some(0) }],
        cloth_strength: None,
        canopies: Vec::new(),
        bodies: (0..4).map(tractor).collect(),
    }
}

fn write_page_numbers(folder: &Path, summary: &Value) {
    fs::write(folder.join("summary.json"), summary.to_string()).unwrap();
    fs::write(folder.join("manifest.json"), "{}").unwrap();
    let rows: String = (0..=60).map(|row| format!("{},{}\n", f64::from(row) * 0.01, f64::from(row).sin())).collect();
    fs::write(folder.join("history.csv"), format!("time_s,area_m2\n{rows}")).unwrap();
}

/// A result of the square net: `widths` gives its width in each frame over the flat width; frames are 10 ms apart.
fn folder(title: &str, widths: &[f64]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let summary = json!({
        "title": title,
        "opening": {"area_max_m2": 4.0, "area_max_time_s": 0.3, "effective_from_s": 0.265, "effective_to_s": 0.335},
        "points": {"tractor": {"peak_speed_m_s": 7.0, "peak_travel_time_s": 0.5}, "centre": {"starts_s": 0.08}},
        "posture": {"convex_from_s": 0.3},
        "stowed": {"closest_approach_m": 0.5, "closest_approach_at_m": [0.3, -0.2, 0.0]},
        "tension": {"max_n": 1500.0, "max_time_s": 0.1234, "max_where": "outline"}
    });
    write_page_numbers(folder.path(), &summary);
    write_fields(folder.path(), widths, None);
    landmarks().write(&folder.path().join("landmarks.json")).unwrap();
    folder
}

/// Writes the net at each frame; `tied_to` is a fixed point that the first corner is tied to.
fn write_fields(folder: &Path, widths: &[f64], tied_to: Option<DVec3>) {
    let tie = tied_to.map(|_| [0, 4]);
    let topology = FieldsTopology {
        nodes: 4 + usize::from(tie.is_some()),
        segments: [[0, 1], [1, 2], [2, 3], [3, 0]].into_iter().chain(tie).collect(),
        classes: [0; 4].into_iter().chain(tie.map(|_| 1)).collect(),
        triangles: Vec::new(),
        class_names: vec!["outline".into(), "tie".into()],
        labels: Vec::new(),
        bodies: Vec::new(),
    };
    let (nodes, tensions) = (topology.nodes, TENSIONS.into_iter().chain(tie.map(|_| 20.0)).collect::<Vec<f64>>());
    let mut fields = FieldsWriter::new(topology).unwrap();
    for (frame, width) in widths.iter().enumerate() {
        let corner = |x: f64, y: f64| DVec3::new(width * x, width * y, 0.1 * frame as f64);
        let corners = [corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)];
        let positions: Vec<DVec3> = corners.into_iter().chain(tied_to).collect();
        fields.push(frame as f64 * 0.01, &positions, &vec![DVec3::ZERO; nodes], &tensions, &[]).unwrap();
    }
    fields.finish(&folder.join("fields.vtkhdf")).unwrap();
}

/// Widths of a net that opens until 0.3 s and closes again.
fn opening() -> Vec<f64> {
    (0..=60).map(|frame| 1.0 - 0.03 * f64::from((frame - 30_i32).abs())).collect()
}

fn picture(folder: &TempDir, name: &str) -> Vec<u8> {
    fs::read(folder.path().join("pictures").join(name)).unwrap()
}

fn svg(folder: &TempDir, name: &str) -> String {
    String::from_utf8(picture(folder, name)).unwrap()
}

fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// The texts of a class, in the order of the file.
fn texts(svg: &str, class: &str) -> Vec<String> {
    let start = format!("<text class=\"{class}\"");
    let starts = svg.split(&start).skip(1);
    starts.map(|text| text.split_once('>').unwrap().1.split_once("</text>").unwrap().0.to_owned()).collect()
}

fn pixel(picture: &Pixmap, x: f64, y: f64) -> [u8; 3] {
    let pixel = picture.pixel(x as u32, y as u32).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()]
}

#[test]
fn every_picture_is_written_and_its_path_returned() {
    let folder = folder("A net", &opening());
    let written = write_pictures(folder.path()).unwrap();
    let pictures = folder.path().join("pictures");
    let mut names: Vec<String> =
        written.iter().map(|path| path.strip_prefix(&pictures).unwrap().to_str().unwrap().to_owned()).collect();
    names.sort();
    assert_eq!(names, names_in(&pictures));
    let expected = [
        "animation.gif",
        "clouds.png",
        "clouds.svg",
        "curve_areas.png",
        "curve_areas.svg",
        "postures.png",
        "postures.svg",
        "stowed.png",
        "stowed.svg",
    ];
    assert_eq!(names, expected);
    for name in names.iter().filter(|name| name.ends_with(".svg")) {
        let svg = svg(&folder, name);
        let tree = Tree::from_str(&svg, &Options::default()).unwrap();
        let png = Pixmap::decode_png(&picture(&folder, &name.replace(".svg", ".png"))).unwrap();
        let size = tree.size().to_int_size();
        assert_eq!((png.width(), png.height()), (2 * size.width(), 2 * size.height()), "{name}");
        // no variables: programs other than browsers do not resolve them
        assert!(!svg.contains("var("), "{name}");
    }
}

#[test]
fn a_known_net_is_drawn_at_its_projected_positions() {
    let folder = folder("A net", &[1.0]);
    write_pictures(folder.path()).unwrap();
    let png = Pixmap::decode_png(&picture(&folder, "stowed.png")).unwrap();
    // pictures of 440 px with margins of 20 px hold 2.2 m, tractors included; two pixels for each
    let px_per_m = 2.0 * 400.0 / 2.2;
    // the second picture, seen from ahead: x to the right, y up
    let (middle_x, middle_y) = (2.0 * (16.0 + 456.0 + 220.0), 2.0 * (44.0 + 222.0));
    let at = |x: f64, y: f64| pixel(&png, middle_x + px_per_m * x, middle_y - px_per_m * y);
    for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
        assert_eq!(at(x, y), INK, "a tractor is at {x}, {y}");
        assert_eq!(at(x * 0.94, y * 0.94), INK, "it has at least its true size");
        assert_eq!(at(x * 0.90, y * 0.90), at(0.5, 0.5), "it has at most its true size");
    }
    assert_eq!(at(0.0, 1.0), HIGHEST, "the rope from corner 0 to 1");
    assert_eq!(at(0.0, -1.0), LOWEST, "the rope from corner 2 to 3");
    assert_eq!(at(0.0, 1.05), WHITE);
    // a ring of 6 px where ropes come nearest
    let radius = 12.0 / px_per_m;
    assert_eq!([at(0.3 + radius, -0.2), at(0.3, -0.2 - radius)], [ACCENT; 2]);
    assert_eq!(at(0.3, -0.2), at(0.5, 0.5));
    // the net is fully open, so the outline is shaded
    assert_ne!(at(0.5, 0.5), WHITE);
    // from the side the net is a line
    let side = |x: f64, z: f64| pixel(&png, 2.0 * (16.0 + 220.0) + px_per_m * x, middle_y - px_per_m * z);
    assert_eq!(side(1.0, 0.05), INK);
    assert_eq!(side(0.5, 0.2), WHITE);
}

/// The fixed end of a tie stays behind when the net flies away.
#[test]
fn ties_are_not_drawn_and_their_fixed_ends_do_not_widen_pictures() {
    let (free, tied) = (folder("A net", &[0.2, 0.6, 1.0]), folder("A net", &[0.2, 0.6, 1.0]));
    write_fields(tied.path(), &[0.2, 0.6, 1.0], Some(DVec3::new(30.0, 0.0, -9.0)));
    let mut landmarks = landmarks();
    landmarks.classes.push(LinkClass { name: "tie".into(), is_rope: false, strength: None });
    landmarks.groups.push(Group { class: 1, rope: None });
    landmarks.write(&tied.path().join("landmarks.json")).unwrap();
    for folder in [&free, &tied] {
        write_pictures(folder.path()).unwrap();
    }
    for name in names_in(&free.path().join("pictures")) {
        assert_eq!(picture(&free, &name), picture(&tied, &name), "{name}");
    }

    fs::write(tied.path().join("history.csv"), "time_s,outline_max_n,tie_max_n\n0,5,9\n1,6,\n").unwrap();
    let page = fs::read_to_string(write_report(tied.path()).unwrap()).unwrap();
    let (_, figures) = page.split_once("id=\"figure-data\">").unwrap();
    let figures: Value = serde_json::from_str(figures.split_once("</script>").unwrap().0).unwrap();
    let names = |id: &str| {
        let figure = figures.as_array().unwrap().iter().find(|figure| figure["id"] == id).unwrap();
        figure["curves"].as_array().unwrap().iter().map(|curve| curve["name"].clone()).collect::<Vec<Value>>()
    };
    assert_eq!((names("class-tensions"), names("thread-tensions")), (vec![json!("outline")], vec![json!("tie")]));
}

#[test]
fn postures_are_eight_named_moments_in_order_of_time() {
    let folder = folder("A net", &opening());
    write_pictures(folder.path()).unwrap();
    let svg = svg(&folder, "postures.svg");
    let names = [
        "stowed",
        "the middle sets off",
        "opening",
        "80 % open",
        "largest area",
        "80 % open until here",
        "tractors at their farthest",
        "at the end",
    ];
    assert_eq!(texts(&svg, "name"), names);
    let captions: Vec<String> = texts(&svg, "soft").into_iter().filter(|text| text.contains("flat ·")).collect();
    // `80 % open` names the first and the last frame of that interval; `opening` fills the widest gap
    let times = ["0.000", "0.080", "0.170", "0.270", "0.300", "0.330", "0.500", "0.600"];
    assert_eq!(captions.iter().map(|caption| &caption[..5]).collect::<Vec<_>>(), times);
    assert!(
        captions[0].replace('\u{a0}', " ").starts_with("0.000 s · 1 % of flat · middle at 0.00 m"),
        "{}",
        captions[0]
    );
    // shaded while at least 80 % open
    assert_eq!(svg.matches("class=\"open\"").count(), 3);
}

#[test]
fn a_net_that_opens_again_is_not_said_to_close() {
    // it closes from 0.3 s to 0.36 s and opens again
    let again = |frame: i32| {
        if frame < 36 { 1.0 - 0.03 * f64::from((frame - 30).abs()) } else { 0.82 + 0.007 * f64::from(frame - 36) }
    };
    let folder = folder("A net", &(0..=60).map(again).collect::<Vec<f64>>());
    // without other moments the sheet is filled with frames between
    write_page_numbers(folder.path(), &json!({"opening": {"area_max_m2": 4.0, "area_max_time_s": 0.3}}));
    write_pictures(folder.path()).unwrap();
    let svg = svg(&folder, "postures.svg");
    let names = texts(&svg, "name");
    let shares = texts(&svg, "soft").into_iter().filter(|text| text.contains("of\u{a0}flat"));
    let shares: Vec<f64> = shares.map(|text| text.split(['\u{a0}', ' ']).nth(3).unwrap().parse().unwrap()).collect();
    assert_eq!(shares.len(), names.len());
    let rises = |name: &str| match name {
        "closing" => Some(false),
        "opening" | "opening again" => Some(true),
        _ => None,
    };
    for (place, name) in names.iter().enumerate() {
        let says = rises(name);
        assert!(says.is_none_or(|rises| rises == (shares[place] > shares[place - 1])), "{names:?} {shares:?}");
    }
    assert!(names.iter().any(|name| name == "opening again"), "{names:?} {shares:?}");
}

#[test]
fn clouds_state_their_highest_tension_and_the_peak_between_frames() {
    let folder = folder("A net", &opening());
    write_pictures(folder.path()).unwrap();
    let svg = svg(&folder, "clouds.svg");
    assert_eq!(texts(&svg, "name").len(), 6);
    assert_eq!(svg.matches("up\u{a0}to\u{a0}1.00\u{a0}kN").count(), 6);
    // each rope keeps its colour in all pictures, and the slack rope has that of slack
    assert_eq!(svg.matches("<path stroke=\"#f68001\"").count(), 6);
    assert_eq!(svg.matches("<path stroke=\"#1957d2\"").count(), 6);
    assert_eq!(svg.matches("<g class=\"ropes\"><path stroke-width").count(), 6);
    assert!(
        svg.contains("The highest tension of the run, 1.50 kN in a rope of class outline, fell between two frames")
    );
}

#[test]
fn the_animation_repeats_without_end_and_has_one_palette() {
    let folder = folder("A net", &opening());
    write_pictures(folder.path()).unwrap();
    let gif = picture(&folder, "animation.gif");
    let mut decoder = DecodeOptions::new().read_info(&gif[..]).unwrap();
    assert_eq!((decoder.width(), decoder.height()), (640, 480));
    assert_eq!(decoder.repeat(), Repeat::Infinite);
    let palette = decoder.global_palette().unwrap().to_vec();
    let (mut frames, mut screen) = (0, vec![0_u8; 640 * 480]);
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert!(frame.palette.is_none() && frame.dispose == DisposalMethod::Keep && frame.delay == 5);
        for (row, pixels) in frame.buffer.chunks(frame.width.into()).enumerate() {
            let start = (usize::from(frame.top) + row) * 640 + usize::from(frame.left);
            screen[start..start + pixels.len()].copy_from_slice(pixels);
        }
        frames += 1;
        let colour = |index: u8| &palette[3 * usize::from(index)..][..3];
        assert_eq!(colour(screen[0]), WHITE);
        assert!(screen.iter().any(|&index| colour(index) == HIGHEST), "frame {frames} shows the hardest pulled rope");
    }
    assert_eq!(frames, 61);
}

#[test]
fn an_animation_has_at_most_120_frames() {
    let folder = folder("A net", &vec![0.5; 400]);
    write_pictures(folder.path()).unwrap();
    let gif = picture(&folder, "animation.gif");
    let mut decoder = DecodeOptions::new().read_info(&gif[..]).unwrap();
    let mut frames = 0;
    while decoder.read_next_frame().unwrap().is_some() {
        frames += 1;
    }
    assert_eq!(frames, 120);
}

#[test]
fn the_same_result_gives_the_same_bytes() {
    let folders = [folder("A net", &opening()), folder("A net", &opening())];
    for folder in &folders {
        write_pictures(folder.path()).unwrap();
    }
    for name in names_in(&folders[0].path().join("pictures")) {
        assert!(picture(&folders[0], &name) == picture(&folders[1], &name), "{name} differs");
    }
}

#[test]
fn older_pictures_are_replaced_as_a_whole() {
    let folder = folder("A net", &[0.2, 1.0]);
    let pictures = folder.path().join("pictures");
    fs::create_dir(&pictures).unwrap();
    fs::write(pictures.join("curve_of_an_older_version.svg"), "").unwrap();
    let before = names_in(folder.path());
    write_pictures(folder.path()).unwrap();
    assert!(!pictures.join("curve_of_an_older_version.svg").exists());
    assert_eq!(names_in(folder.path()), before, "no temporary folder is left");
}

#[test]
fn without_fields_the_error_names_what_is_missing_and_older_pictures_stay() {
    for (missing, message) in
        [("fields.vtkhdf", "fields.vtkhdf is missing"), ("landmarks.json", "landmarks.json is missing")]
    {
        let folder = folder("A net", &[0.2, 1.0]);
        write_pictures(folder.path()).unwrap();
        fs::remove_file(folder.path().join(missing)).unwrap();
        let before = names_in(folder.path());
        let error = write_pictures(folder.path()).unwrap_err();
        assert!(matches!(error, ReportError::NoFields { .. }) && error.to_string().contains(message), "{error}");
        assert_eq!(names_in(folder.path()), before);
        assert!(!picture(&folder, "postures.svg").is_empty());
    }
    let folder = folder("A net", &[]);
    let error = write_pictures(folder.path()).unwrap_err();
    assert!(error.to_string().contains("holds no frame"), "{error}");
}

#[test]
fn markup_and_control_characters_in_a_title_leave_the_svg_valid() {
    let folder = folder("</svg><script>&\u{1}\u{7f} ä \"net\"", &[0.2, 1.0]);
    write_pictures(folder.path()).unwrap();
    let svg = svg(&folder, "postures.svg");
    assert!(!svg.contains("<script>"));
    Tree::from_str(&svg, &Options::default()).unwrap();
}

/// A result of a square net with `meshes` meshes along a side and `pieces` segments in a mesh side.
fn large_net(meshes: usize, pieces: usize) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write_page_numbers(folder.path(), &json!({"title": "Large"}));
    let knots = meshes + 1;
    let mut points: Vec<DVec3> =
        (0..knots * knots).map(|knot| DVec3::new((knot % knots) as f64, (knot / knots) as f64, 0.0)).collect();
    let mut segments = Vec::new();
    let across = (0..knots * knots).filter(|knot| knot % knots < meshes).map(|knot| (knot, knot + 1));
    let along = (0..knots * meshes).map(|knot| (knot, knot + knots));
    for (from, to) in across.chain(along) {
        let mut last = from;
        for piece in 1..=pieces {
            let next = if piece == pieces { to } else { points.len() };
            if piece < pieces {
                points.push(points[from].lerp(points[to], piece as f64 / pieces as f64));
            }
            segments.push([last as u32, next as u32]);
            last = next;
        }
    }
    let tensions: Vec<f64> = (0..segments.len()).map(|segment| 1.07_f64.powi((segment * 7 % 200) as i32)).collect();
    let topology = FieldsTopology {
        nodes: points.len(),
        classes: vec![0; segments.len()],
        segments,
        triangles: Vec::new(),
        class_names: vec!["outline".into()],
        labels: Vec::new(),
        bodies: Vec::new(),
    };
    let mut fields = FieldsWriter::new(topology).unwrap();
    let still = vec![DVec3::ZERO; points.len()];
    for frame in 0..8 {
        let wave = |point: &DVec3| *point + DVec3::Z * (0.3 * point.x + f64::from(frame)).sin();
        fields.push(f64::from(frame), &points.iter().map(wave).collect::<Vec<_>>(), &still, &tensions, &[]).unwrap();
    }
    fields.finish(&folder.path().join("fields.vtkhdf")).unwrap();
    let bare = Landmarks { outline: Vec::new(), bodies: Vec::new(), points: Vec::new(), ..landmarks() };
    bare.write(&folder.path().join("landmarks.json")).unwrap();
    folder
}

#[test]
fn pictures_of_thirty_thousand_segments_stay_small() {
    // 30,800 segments; without the nodes inside ropes, 6,160 remain
    let folder = large_net(55, 5);
    write_pictures(folder.path()).unwrap();
    let postures = svg(&folder, "postures.svg");
    assert_eq!(texts(&postures, "name").len(), 8);
    assert!(postures.contains("Drawn without some of the nodes inside ropes"));
    // 14 bytes for each rope in each picture, although few neighbours share a tension
    assert!(postures.len() < 700_000, "{} bytes", postures.len());
    assert!(picture(&folder, "animation.gif").len() < 6_000_000);
}

#[test]
fn a_net_below_the_limit_is_drawn_with_all_nodes() {
    let folder = large_net(20, 5);
    write_pictures(folder.path()).unwrap();
    assert!(!svg(&folder, "postures.svg").contains("Drawn without"));
}
