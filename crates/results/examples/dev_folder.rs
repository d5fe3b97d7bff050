//! temporary
use glam::DVec3;
use netcast_results::summary::*;
use netcast_results::*;
use std::path::Path;

fn main() {
    let target = std::env::args().nth(1).unwrap();
    let folder = ResultFolder::create(Path::new(&target)).unwrap();
    let classes = ["traction", "outline", "ring", "radial", "inner"];
    let points = ["A", "B", "C", "D", "tractor"];
    let channels = ["kinetic", "kinetic_tractors", "elastic", "gravity", "rope_damping", "air_damping", "residual"];
    let mut history = History::new(history::columns(&points, &classes, &channels));
    let n = 40usize;
    let topology = FieldsTopology {
        nodes: n,
        segments: (0..n as u32 - 1).map(|i| [i, i + 1]).collect(),
        classes: (0..n as u32 - 1).map(|i| i % 5).collect(),
        class_names: classes.map(String::from).to_vec(),
        labels: points.iter().enumerate().map(|(i, p)| (i as u32 * 7, p.to_string())).collect(),
    };
    let mut writer = FieldsWriter::new(topology).unwrap();
    let mut seed = 1u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let bump = |t: f64, c: f64, w: f64| (-((t - c) / w).powi(2)).exp();
    let mut worst = (0.0, 0.0);
    for step in 0..=600 {
        let t = step as f64 * 1e-3;
        let travel = |r: f64, s: f64| s * (1.0 - (-(t - r).max(0.0) * 8.3).exp());
        let area = 15.8 * bump(t, 0.131, if t < 0.131 { 0.05 } else { 0.13 });
        let tens: Vec<f64> = (0..n - 1)
            .map(|i| {
                let class = i % 5;
                let peak = [51e3, 30e3, 18e3, 22e3, 9e3][class] * (0.7 + 0.3 * noise());
                let v = peak * bump(t, 0.15 - 0.012 * class as f64, 0.02) + 0.3 * peak * bump(t, 0.05, 0.02) * noise();
                if v < 1.0 { 0.0 } else { v }
            })
            .collect();
        let pos: Vec<DVec3> =
            (0..n).map(|i| DVec3::new(i as f64 * 0.1, noise(), travel(i as f64 * 1e-3, 5.0))).collect();
        let vel: Vec<DVec3> = (0..n).map(|_| DVec3::new(noise(), noise(), 40.0)).collect();
        let max = tens.iter().copied().fold(0.0, f64::max);
        if max > worst.0 {
            worst = (max, t);
        }
        let mut row = vec![
            Some(t),
            Some(area),
            Some(area * 1.02),
            Some(6.0 + 26.4 * bump(t, 0.16, 0.1)),
            Some(travel(0.06, 7.0)),
            Some(travel(0.01, 5.0)),
            Some(travel(0.0, 5.9)),
            Some(max),
        ];
        for (i, (r, s)) in [(0.004, 4.4), (0.06, 8.8), (0.02, 5.0), (0.04, 6.6), (0.0, 5.9)].into_iter().enumerate() {
            let x = pos[i * 7];
            let speed =
                if t < r { 0.0 } else { s * 8.3 * (-(t - r) * 8.3).exp() * (1.0 + 0.4 * bump(t, r + 0.03, 0.01)) };
            let tension = if i == 4 { None } else { Some(tens[i * 7]) };
            row.extend([Some(x.x), Some(x.y), Some(x.z)]);
            if i != 4 {
                row.push(Some(travel(r, s)));
            }
            row.extend([Some(speed), tension]);
        }
        for class in 0..5 {
            let of: Vec<f64> = tens.iter().skip(class).step_by(5).copied().collect();
            row.push(Some(of.iter().sum::<f64>() / of.len() as f64));
            row.push(Some(of.iter().copied().fold(0.0, f64::max)));
        }
        let e0 = 417e3;
        let d = (-2.0 * 8.3 * t).exp();
        let web = 60e3 * bump(t, 0.12, 0.06);
        let el = 9e3 * bump(t, 0.15, 0.02);
        let rd = 12e3 * (1.0 - (-t * 10.0).exp());
        let grav = 9e3 * (1.0 - (-t * 5.0).exp());
        let kt = (e0 * d - web - el).max(20e3);
        let residual = 200.0 * (1.0 - (-t * 9.0).exp()) + 10.0 * noise();
        row.extend([
            Some(web),
            Some(kt),
            Some(el),
            Some(grav),
            Some(rd),
            Some(e0 - web - kt - el - rd - grav),
            Some(residual),
        ]);
        history.push(row).unwrap();
        writer.push(t, &pos, &vel, &tens).unwrap();
    }
    history.write(&folder.path().join("history.csv")).unwrap();
    writer.finish(&folder.path().join("fields.vtkhdf")).unwrap();
    let mut s = Summary {
        title: "The space web, launched as in the paper".into(),
        netcast: "0.1.0".into(),
        wall_time_s: 11.3,
        finished: true,
        ..Default::default()
    };
    s.model =
        Model { nodes: 1893, segments: 2108, rope_length_m: 117.05, web_mass_kg: 57.67, tractor_mass_kg: Some(166.8) };
    s.step = Step { dt_s: 1.27e-6, count: 472441, limited_by: Some("segment 12 of traction rope 3".into()) };
    s.opening = Opening {
        area_max_m2: Some(15.8),
        area_max_time_s: Some(0.131),
        reference_area_m2: Some(16.238),
        vector_area_max_m2: Some(15.92),
        effective_from_s: Some(0.112),
        effective_to_s: Some(0.193),
        effective_duration_s: Some(0.081),
        tractor_area_max_m2: Some(32.4),
        tractor_area_max_time_s: Some(0.16),
    };
    for (i, (name, v, d, st)) in [
        ("A", 71.2, 4.4, 0.004),
        ("B", 112.4, 8.8, 0.061),
        ("C", 70.8, 5.0, 0.02),
        ("D", 92.0, 6.6, 0.043),
        ("tractor", 70.71, 5.9, 0.0008),
        ("corner", 70.1, 5.0, 0.01),
        ("centre", 101.0, 7.0, 0.058),
    ]
    .into_iter()
    .enumerate()
    {
        s.points.insert(
            name.into(),
            Some(PointExtremes {
                peak_speed_m_s: Some(v),
                peak_speed_time_s: Some(0.05 + 0.01 * i as f64),
                peak_travel_m: Some(d),
                peak_travel_time_s: Some(0.6),
                peak_height_m: Some(d),
                starts_s: Some(st),
            }),
        );
    }
    s.tension = Tension {
        max_n: worst.0,
        max_time_s: Some(worst.1),
        max_where: Some("traction".into()),
        bottom_max_n: Some(14.2e3),
        bottom_mean_n: Some(3.9e3),
        by_class: Default::default(),
    };
    for (c, m) in classes.into_iter().zip([51e3, 30e3, 18e3, 22e3, 9e3]) {
        s.tension.by_class.insert(
            c.into(),
            ClassTension { max_n: m, max_time_s: Some(0.15), margin: if c == "traction" { Some(1.84) } else { None } },
        );
    }
    s.posture = Posture { concave_from_s: Some(0.004), concave_to_s: Some(0.187), convex_from_s: Some(0.212) };
    s.energy = Energy {
        initial_j: 417e3,
        final_j: 52e3,
        closure: 5e-4,
        closure_web: Some(3.1e-3),
        channels: Default::default(),
        residual_j: 210.0,
        tolerance: 0.003,
    };
    for c in &channels[..6] {
        s.energy
            .channels
            .insert(c.to_string(), history.values(&format!("energy_{c}_j")).unwrap().last().unwrap().unwrap());
    }
    s.write(&folder.path().join("summary.json")).unwrap();
    std::fs::create_dir(folder.path().join("inputs")).unwrap();
    std::fs::write(folder.path().join("inputs/scenario.toml"), "title = 'x'\n").unwrap();
    let mut m = Manifest::new(manifest::hash_inputs(&folder.path().join("inputs")).unwrap(), Machine::this(), 1);
    m.wall_time_s = 11.3;
    m.write(&folder.path().join("manifest.json")).unwrap();
    println!("{}", folder.publish().unwrap().display());
}
