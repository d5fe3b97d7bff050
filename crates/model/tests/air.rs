//! Air and wind of a scenario: the parts that the model makes of them, and the mistakes that it reports.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use netcast_dynamics::air::Attitude;
use netcast_dynamics::forces::body_drag::Shape;
use netcast_model::{Fall, Model};
use netcast_scenario::{Diagnostics, Document, Source, resolved_toml};

const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa" }
solve.duration = "2 s"
"#;

const SPACE: &str = r#"
web.space.side = "1 m"
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
payload.cylinder = {}
tractor.cylinder = {}
traction_rope = { length = "0.5 m", count = 2 }
solve.duration = "0.1 s"
"#;

/// The model of a scenario with `csv` as the file `wind.csv` beside it.
fn model_with(text: &str, csv: &str) -> Result<Model, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("wind.csv"), csv).unwrap();
    Model::new(&Document::parse(Source { name: "net.toml".into(), text: text.into() }, folder.path(), &[])?)
}

fn model(text: &str, more: &str) -> Model {
    model_with(&format!("{text}{more}"), "").unwrap_or_else(|wrong| panic!("{wrong}"))
}

/// The mistakes in the net, as lines without the name of the file.
fn wrong(more: &str, csv: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = model_with(&format!("{NET}{more}"), csv) else { panic!("nothing is wrong: {more}") };
    let help = |help: &Option<String>| help.as_ref().map_or(String::new(), |help| format!(" ({help})"));
    found.iter().map(|one| format!("{}: {}{}", one.path, one.message, help(&one.help))).collect()
}

#[test]
fn by_default_the_air_is_standard_at_sea_level_and_each_rope_drags_as_if_alone() {
    let net = model(NET, "[environment.air]");
    let air = net.system.environment().air.as_ref().unwrap();
    assert!((air.medium.density(0.0) - 1.225).abs() < 1e-12 && (air.medium.viscosity() / 1.7894e-5 - 1.0).abs() < 1e-4);
    assert_eq!((air.wind.at(50.0, 1.0), air.added_mass, net.system.loads().len()), (DVec3::ZERO, 0.0, 0));
    let rope = air.ropes[0].unwrap();
    assert_eq!((rope.diameter, rope.normal, rope.tangential, rope.solidity), (4e-3, None, 0.02, 0.0));
    let resolved = resolved_toml(&net.scenario);
    for line in ["altitude = \"0 m\"", "tangential_coefficient = 0.02", "sheet_coefficient = 1.17", "buoyancy = false"]
    {
        assert!(resolved.lines().any(|found| found == line), "{line} in\n{resolved}");
    }
    // without it there is none
    assert!(model(NET, "").system.environment().air.is_none());
}

#[test]
fn the_solidity_of_the_web_is_projected_rope_over_area_without_traction_ropes() {
    let more = "traction_rope.length = \"0.5 m\"\ntractor.particle.mass = 1\nenvironment.air.solidity";
    let net = model(NET, &format!("{more} = \"web\""));
    // ten ropes of 2 m over 4 m^2
    let solidity = 10.0 * 2.0 * 4e-3 / 4.0;
    let outline = net.air.as_ref().unwrap();
    assert!((outline.solidity.unwrap() - solidity).abs() < 1e-12, "{outline:?}");
    for (group, drag) in net.groups.iter().zip(&net.system.environment().air.as_ref().unwrap().ropes) {
        let expected = if group.class.name() == "traction" { 0.0 } else { solidity };
        assert!((drag.unwrap().solidity - expected).abs() < 1e-12, "{}", group.class.name());
    }
    let given = model(NET, &format!("{more} = 0.3"));
    assert_eq!(given.air.unwrap().solidity, Some(0.3));
    assert_eq!(outline.sizeless, 4);
}

#[test]
fn buoyancy_is_the_weight_of_the_displaced_medium() {
    let more = "environment.air = { density = \"1000 kg/m^3\", viscosity = \"1 mPa s\", added_mass = 1 }\n\
                tractor.sphere = { diameter = \"0.1 m\", mass = 2 }\n[[tractors]]\ncorner = 2\nparticle.mass = 3";
    let net = model(NET, more);
    assert_eq!(net.system.environment().air.as_ref().unwrap().added_mass, 1.0);
    let (rope, sphere) = (20.0 * PI * 4e-6, PI / 6.0 * 1e-3);
    let lift = net.system.loads().iter().map(|load| load.force).sum::<DVec3>() / (1000.0 * 9.80665);
    assert!((lift - DVec3::Z * (rope + 3.0 * sphere)).length() < 1e-15, "{lift}");
    let outline = net.air.unwrap();
    assert!((outline.web_buoyancy / (1000.0 * 9.80665 * rope) - 1.0).abs() < 1e-12);
    // held nodes get no load; then the same in air
    let held = model(NET, "environment.air = { density = 1000, viscosity = 0.001 }\nhold.corners = true");
    assert_eq!(held.system.loads().len(), net.system.loads().len() - 4);
    let bare = model(NET, "environment.air = { altitude = \"2 km\", buoyancy = true }");
    let lift: f64 = bare.system.loads().iter().map(|load| load.force.z).sum();
    assert!((lift / (1.0066 * 9.80665 * rope) - 1.0).abs() < 1e-3, "{lift}");
}

#[test]
fn every_kind_of_canopy_drags_as_triangles_and_hides_its_payload() {
    let hexagon = 1.5 * 3f64.sqrt() * 0.14 * 0.14;
    let kinds = [("links", "", 6), ("rigid", "", 6), ("membrane", ", fineness = 2", 24)];
    for (kind, more, triangles) in kinds {
        let text = format!(
            "canopy.{kind} = {{ side = \"0.14 m\", porosity = 0.25{more} }}\n[environment.air]\nbuoyancy = true"
        );
        let net = model(SPACE, &text);
        let (air, count) = (net.system.environment().air.as_ref().unwrap(), net.cut.web.canopies.len() as f64);
        assert_eq!(air.sheets.len() as f64, count * f64::from(triangles), "{kind}");
        let area: f64 = air.sheets.iter().map(|sheet| sheet.area).sum();
        assert!((area / (count * hexagon) - 1.0).abs() < 1e-12, "{kind}: {area}");
        assert!(air.sheets.iter().all(|sheet| (sheet.coefficient - 0.75 * 1.17).abs() < 1e-15));
        // only tractors are left
        let shape = Shape::Cylinder { diameter: 0.1, height: 0.2 };
        assert!(air.bodies.len() == 6 && air.bodies.iter().all(|body| body.shape == shape), "{kind}");
        let outline = net.air.as_ref().unwrap();
        assert_eq!(outline.hidden as f64, f64::from(net.bill.payloads as u32), "{kind}");
        // everything with a size displaces air
        let volume = (net.bill.ropes[0].length * PI * 2.25e-6)
            + count * hexagon * 0.01
            + net.bill.payloads as f64 * PI / 4.0 * 0.06 * 0.06 * 0.066
            + 6.0 * PI / 4.0 * 0.01 * 0.2;
        assert!((outline.buoyancy / (1.225 * 9.80665 * volume) - 1.0).abs() < 1e-9, "{kind}: {}", outline.buoyancy);
    }
}

#[test]
fn a_body_larger_than_its_rigid_canopy_turns_with_it() {
    // one side is much longer: the first principal axis has the largest moment and lies across that side
    let body = "[environment.air]\n[payload.box]\nwidth = \"0.6 m\"\ndepth = \"0.2 m\"\nheight = \"0.1 m\"";
    let text = SPACE.replace("payload.cylinder = {}\n", "");
    let rigid = model(&text, &format!("canopy.rigid.side = \"0.14 m\"\n{body}"));
    let drags = &rigid.system.environment().air.as_ref().unwrap().bodies;
    for drag in drags.iter().filter(|drag| matches!(drag.shape, Shape::Box(_))) {
        let (Attitude::Body(index), Shape::Box(sides)) = (drag.attitude, drag.shape) else { panic!("{drag:?}") };
        let turned = rigid.state.rotation[index].orientation * sides;
        assert!((turned.abs() - DVec3::new(0.6, 0.2, 0.1)).length() < 1e-6, "{turned}");
    }
    assert_eq!(drags.len(), 6 + rigid.bill.payloads);
    let links = model(&text, &format!("canopy.links.side = \"0.14 m\"\n{body}"));
    let drags = &links.system.environment().air.as_ref().unwrap().bodies;
    assert!(drags.iter().all(|drag| matches!(drag.attitude, Attitude::Fixed(_))));
    assert_eq!(drags.len(), 6 + rigid.bill.payloads);
}

#[test]
fn a_canopy_hides_a_particle_that_is_smaller_in_the_air() {
    let particles = |diameter: &str| {
        let net = model(
            &SPACE.replace("payload.cylinder = {}", &format!("payload.particle = {{ mass = 0.2{diameter} }}")),
            "canopy.links.side = \"0.14 m\"\n[environment.air]",
        );
        let outline = net.air.as_ref().unwrap();
        let told = net.notes.iter().any(|note| note.contains("no size"));
        let payloads = net.bill.payloads;
        (
            (outline.hidden, outline.sizeless),
            net.system.environment().air.as_ref().unwrap().bodies.len(),
            told,
            payloads,
        )
    };
    let (without, drags, told, payloads) = particles("");
    assert_eq!((without, drags, told), ((payloads, 0), 6, false));
    // the canopy reaches 0.121 m at least
    assert_eq!(particles(", diameter = 0.24").0, (payloads, 0));
    let (large, drags, ..) = particles(", diameter = 0.25");
    assert_eq!((large, drags), ((0, 0), 6 + payloads));
}

#[test]
fn a_tractor_drags_in_its_orientation_at_launch() {
    let launch = "[environment.air]\n[launch]\naxial_speed = \"30 m/s\"\nradial_speed = \"40 m/s\"";
    for (more, along) in [("", [0.8, 0.6]), ("\nattitude = \"axis\"", [0.0, 1.0])] {
        let net = model(NET, &format!("tractor.cylinder = {{}}\n{launch}{more}"));
        let air = net.system.environment().air.as_ref().unwrap();
        for drag in &air.bodies {
            let Attitude::Fixed(turn) = drag.attitude else { panic!("{drag:?}") };
            let axis = turn * DVec3::Z;
            assert!((axis.truncate().length() - along[0]).abs() < 1e-12 && (axis.z - along[1]).abs() < 1e-12, "{axis}");
        }
        assert_eq!(net.air.as_ref().unwrap().launch_speed, 50.0);
        assert_eq!(air.fastest, 3.0 * 50.0 + 30.0);
    }
    let tied = "tractor.cylinder = {}\ntraction_rope = { length = \"0.3 m\", tied_at = \"rear\" }\n";
    let net = model(NET, &format!("{tied}{launch}"));
    let bodies = &net.system.environment().air.as_ref().unwrap().bodies;
    assert!((0..4).all(|k| bodies[k].attitude == Attitude::Body(k) && bodies[k].node == net.system.bodies()[k].centre));
    // out of a tube: v^2 = 2 W / m, with half a segment of each rope at the corner
    let tube = "tractor.particle = { mass = \"0.4 kg\", diameter = \"80 mm\" }\n[environment.air]\n[launch.tube]\n\
                stroke = \"0.1 m\"\nforce_over_stroke = { at = [0, 0.1], force = [2000, 0] }";
    let net = model(NET, tube);
    let speed = net.air.unwrap().launch_speed;
    assert!((speed / 500f64.sqrt() - 1.0).abs() < 1e-3, "{speed}");
    let bodies = &net.system.environment().air.as_ref().unwrap().bodies;
    assert!(bodies.len() == 4 && bodies.iter().all(|body| body.shape == Shape::Sphere(0.08)));
}

#[test]
fn a_wind_has_its_direction_its_profile_and_its_gust() {
    let blown = |wind: &str| {
        let net = model(NET, &format!("[environment.air]\n[environment.wind]\n{wind}"));
        net.system.environment().air.clone().unwrap()
    };
    let close = |one: DVec3, other: DVec3| assert!(one.distance(other) < 1e-3, "{one} and {other}");
    let air = blown("speed = \"5 m/s\"\nazimuth = \"90 deg\"");
    close(air.wind.at(30.0, 1.0), DVec3::new(0.0, 5.0, 0.0));
    assert_eq!(air.fastest, 35.0);
    let power = "speed = \"5 m/s\"\nmuzzle_height = \"2 m\"\npower = { exponent = 0.2, reference_height = \"20 m\" }";
    close(blown(power).wind.at(18.0, 0.0), DVec3::X * 5.0);
    close(blown(power).wind.at(0.0, 0.0), DVec3::X * 5.0 * 0.1f64.powf(0.2));
    let log = "speed = \"5 m/s\"\nlogarithmic = { roughness = \"0.1 m\" }";
    close(blown(log).wind.at(10.0, 0.0), DVec3::X * 5.0);
    close(blown(log).wind.at(40.0, 0.0), DVec3::X * 5.0 * 400f64.ln() / 100f64.ln());
    close(blown(log).wind.at(0.05, 0.0), DVec3::ZERO);
    // a profile begins at the ground
    let over_ground = log.to_owned() + "\n[environment.ground]\nheight = \"-3 m\"";
    close(blown(&over_ground).wind.at(7.0, 0.0), DVec3::X * 5.0);
    let gust =
        "speed = \"5 m/s\"\ngust = { speed = \"4 m/s\", at = \"0.5 s\", duration = \"1 s\", azimuth = \"180 deg\" }";
    close(blown(gust).wind.at(3.0, 1.0), DVec3::X);
    close(blown(gust).wind.at(3.0, 1.6), DVec3::X * 5.0);
    // a gust without azimuth blows along the wind
    let gust = "speed = 0\nazimuth = \"-90 deg\"\ngust = { speed = \"4 m/s\", at = 0, duration = \"1 s\" }";
    close(blown(gust).wind.at(3.0, 0.75), DVec3::Y * -2.0);
}

#[test]
fn turbulence_has_its_variance_adds_to_the_gust_and_depends_on_its_seed() {
    let blown = |wind: &str| {
        let run = NET.replace("\"2 s\"", "\"100 s\"");
        let net =
            model(&run, &format!("record.every = 1\n[environment.air]\n[environment.wind]\nspeed = \"8 m/s\"\n{wind}"));
        net.system.environment().air.clone().unwrap().wind
    };
    let eddies = |kind: &str, how: &str| format!("turbulence.{kind} = {{ {how}, length_scale = \"3 m\" }}");
    for kind in ["von_karman", "dryden"] {
        let wind = blown(&eddies(kind, "deviation = \"1.2 m/s\""));
        let values = &wind.fluctuation.values;
        for k in 0..3 {
            let variance = values.iter().map(|v| v[k] * v[k]).sum::<f64>() / values.len() as f64;
            assert!((variance / 1.44 - 1.0).abs() < 0.15, "{kind} {k}: {variance}");
        }
        // isotropic: components are uncorrelated
        let product = values.iter().map(|v| v.x * v.z).sum::<f64>() / values.len() as f64;
        assert!(product.abs() < 0.2, "{product}");
        assert_eq!(wind, blown(&eddies(kind, "intensity = 0.15")));
        assert_ne!(wind, blown(&eddies(kind, "intensity = 0.15, seed = 1")));
        let gust = "\ngust = { speed = \"3 m/s\", at = \"2 s\", duration = \"2 s\" }";
        let both = blown(&format!("{}{gust}", eddies(kind, "intensity = 0.15")));
        for (time, speed) in [(1.0, 0.0), (2.5, 1.5), (3.0, 3.0), (5.0, 0.0)] {
            let added = both.at(0.0, time) - wind.at(0.0, time);
            assert!(added.distance(DVec3::X * speed) < 1e-3, "{time}: {added}");
        }
    }
}

/// Along the wind, for one seed; held against the published spectra.
#[test]
fn ten_minutes_of_turbulence_have_its_variance_and_its_spectrum() {
    let (speed, scale, deviation) = (8.0, 20.0, 1.2);
    let time = scale / speed;
    let level = 4.0 * deviation * deviation * time;
    let von_karman = |f: f64| level / (1.0 + 70.8 * (f * time).powi(2)).powf(5.0 / 6.0);
    let dryden = |f: f64| level / (1.0 + (2.0 * PI * f * time).powi(2));
    let spectra: [(&str, &dyn Fn(f64) -> f64); 2] = [("von_karman", &von_karman), ("dryden", &dryden)];
    for (kind, spectrum) in spectra {
        let run = NET.replace("\"2 s\"", "\"600 s\"");
        let eddies = format!("turbulence.{kind} = {{ deviation = {deviation}, length_scale = {scale}, seed = 7 }}");
        let wind = format!("record.every = 1\n[environment.air]\n[environment.wind]\nspeed = {speed}\n{eddies}");
        let net = model(&run, &wind);
        let series = &net.system.environment().air.as_ref().unwrap().wind.fluctuation;
        for k in 0..3 {
            let variance = series.values.iter().map(|v| v[k] * v[k]).sum::<f64>() / series.values.len() as f64;
            let ratio = variance / (deviation * deviation);
            assert!((ratio - 1.0).abs() < 0.1, "{kind} {k}: {ratio} of the variance");
        }
        // energy between two frequencies by a discrete Fourier transform; every tenth value suffices
        let values: Vec<f64> = series.values.iter().step_by(10).map(|v| v.x).collect();
        let (count, [low, high]) = (values.len() as f64, [0.2, 0.6]);
        let lasts = count * 10.0 * series.spacing;
        let found: f64 = ((low * lasts) as usize..(high * lasts) as usize)
            .map(|line| {
                let rate = 2.0 * PI * line as f64 / count;
                let wave = |(i, v): (usize, &f64)| DVec2::from_angle(rate * i as f64) * *v;
                2.0 * values.iter().enumerate().map(wave).sum::<DVec2>().length_squared() / (count * count)
            })
            .sum();
        let expected: f64 = (0..400).map(|i| spectrum(low + (f64::from(i) + 0.5) * 1e-3) * 1e-3).sum();
        assert!(
            (found / expected - 1.0).abs() < 0.1,
            "{kind}: {} of the energy from {low} to {high} Hz",
            found / expected
        );
    }
}

#[test]
fn a_measured_wind_is_interpolated_between_its_rows() {
    let csv = "t,vx,vy,vz\n-1,2,0,0\n0,4,1,0\n0.5,0,1,0.5\n2,3,1,0\n";
    let text = format!("{NET}[environment.air]\n[environment.wind.series]\nfile = \"wind.csv\"");
    let net = model_with(&text, csv).unwrap();
    let wind = &net.system.environment().air.as_ref().unwrap().wind;
    for (time, expected) in
        [(0.0, [4.0, 1.0, 0.0]), (0.25, [2.0, 1.0, 0.25]), (1.25, [1.5, 1.0, 0.25]), (9.0, [3.0, 1.0, 0.0])]
    {
        assert!(wind.at(7.0, time).distance(DVec3::from_array(expected)) < 1e-9, "{time}: {}", wind.at(7.0, time));
    }
    let files: Vec<String> = net.scenario.files().iter().map(|file| file.display().to_string()).collect();
    assert_eq!(files, ["wind.csv"]);
}

#[test]
fn notes_warn_of_damping_beside_air_of_particles_without_size_and_of_a_still_net() {
    let notes = |more: &str| model(NET, more).notes.join("\n");
    let damped = |more: &str| notes(&format!("environment.damping = \"8.3 1/s\"\n{more}"));
    assert!(damped("[environment.air]").contains("comes on top of the drag of the air"));
    assert!(damped("[environment.air]\n[environment.wind]\nspeed = 3").contains("acts against the world"));
    assert!(damped("").contains("nothing fall faster than 1.182 m/s"), "{}", damped(""));
    assert!(!damped("hold.corners = true").contains("nothing fall"), "what is held does not fall");
    assert!(damped("break_ties = [{ corners = true, breaking_load = 50 }]").contains("nothing fall"));
    assert!(!notes("environment.damping = \"2 1/s\"").contains("fall"));
    assert!(notes("tractor.particle.mass = 1\n[environment.air]").contains("4 particles have no size"));
    let still = "stow.scale.factor = 0.9\nenvironment.gravity = 0\n[environment.air]\n";
    assert!(
        notes(still).contains("nothing moves")
            && !notes(&format!("{still}[environment.wind]\nspeed = 1")).contains("nothing moves")
    );
}

#[test]
fn the_terminal_speed_balances_weight_and_drag() {
    let net = model(NET, "environment.air = { normal_coefficient = 1.1 }");
    // m g / (1/2 rho C d L): a section of 4 mm and 1140 kg/m^3
    let expected = (1140.0 * PI / 4.0 * 4e-3 * 9.80665 / (0.5 * 1.225 * 1.1)).sqrt();
    let Some(Fall::At(speed)) = net.fall() else { panic!("it does not fall") };
    assert!((speed / expected - 1.0).abs() < 1e-9, "{speed} and {expected}");
    let ropes = net.ropes_in_air();
    assert!(ropes.len() == 1 && (ropes[0].area - 20.0 * 4e-3).abs() < 1e-12 && ropes[0].normal == 1.1);
    // payloads larger than their canopies: boxes that drag with their lower side
    let payloads = "payload.box = { width = 0.5, depth = 0.4, height = 0.3, mass = 1.5 }";
    let text = SPACE.replace("payload.cylinder = {}", payloads);
    let air = "canopy.links = { side = \"0.14 m\" }\nenvironment.air = { normal_coefficient = 1.1 }";
    let net = model(&text, air);
    let (count, canopies) = (net.bill.payloads as f64, net.bill.canopies as f64);
    let ropes = net.bill.web_rope_mass / (1440.0 * PI / 4.0 * 3e-3);
    let area = 1.1 * ropes + 1.17 * canopies * 1.5 * 3f64.sqrt() * 0.14 * 0.14 + 1.07 * count * 0.5 * 0.4;
    let expected = (net.bill.web_mass() * 9.80665 / (0.5 * 1.225 * area)).sqrt();
    let Some(Fall::At(speed)) = net.fall() else { panic!("it does not fall") };
    assert!((speed / expected - 1.0).abs() < 1e-9, "{speed} and {expected}");
    // a rope less dense than water
    let afloat = NET.replace("1140", "970");
    let afloat = model(&afloat, "environment.air = { density = 1000, viscosity = \"1 mPa s\" }");
    assert_eq!(afloat.fall(), Some(Fall::Floats));
    let smooth = model(NET, "environment.air = { normal_coefficient = 0 }");
    assert_eq!(smooth.fall(), Some(Fall::Unhindered));
    assert_eq!(model(NET, "").fall(), None);
}

#[test]
fn mistakes_about_the_air_are_reported_at_their_place() {
    let told = |more: &str, expected: &str| assert_eq!(wrong(more, ""), [expected], "{more}");
    told(
        "[environment.wind]\nspeed = 3",
        "environment.wind: a wind acts by drag, and there is no air (add [environment.air])",
    );
    told(
        "environment.air = { altitude = 100, density = 1000, viscosity = 0.001 }",
        "environment.air.density: expected only one of `altitude` and `density`",
    );
    told(
        "environment.air.density = 1000",
        "environment.air.density: missing key `viscosity`, as the density of the medium is given (water of 20 deg C has \"1 mPa \
         s\", air of 15 deg C \"0.0179 mPa s\")",
    );
    told(
        "environment.air.viscosity = \"1.8e-5 Pa s\"",
        "environment.air.viscosity: the viscosity of the standard atmosphere follows from its altitude (leave it out, or give \
         `environment.air.density` too)",
    );
    told(
        "environment.air = { density = 1000, viscosity = \"1 Pa\" }",
        "environment.air.viscosity: expected a viscosity greater than 0 such as \"0.018 mPa s\", found \"1 Pa\", which is a \
         pressure or elastic modulus",
    );
    told(
        "environment.air.altitude = \"12 km\"",
        "environment.air.altitude: expected a length of at least -1000 and at most 11000 such as \"2.5 m\", found \"12 km\"",
    );
    told(
        "environment.air.solidity = 0.8",
        "environment.air.solidity: expected a number of at least 0 and at most 0.7 such as 0.5, found 0.8 (or write \"web\")",
    );
    told(
        "environment.air.solidity = \"net\"",
        "environment.air.solidity: expected a number of at least 0 and at most 0.7 such as 0.5, found \"net\": it does not start \
         with a number (or write \"web\")",
    );
}

#[test]
fn mistakes_about_the_wind_are_reported_at_their_place() {
    let blown = |wind: &str, csv: &str, expected: &str| {
        let more = format!("[environment.air]\n[environment.wind]\n{wind}");
        assert_eq!(wrong(&more, csv), [expected], "{more}");
    };
    blown("", "", "environment.wind.speed: missing key `speed` (`speed` is a speed of at least 0 such as \"50 m/s\")");
    blown(
        "speed = 3\npower = {}\nlogarithmic = {}",
        "",
        "environment.wind.logarithmic: expected only one of `power` and `logarithmic`",
    );
    blown(
        "speed = 3\nlogarithmic.roughness = 20",
        "",
        "environment.wind.logarithmic.roughness: expected less than the reference height, 10 m, where the wind has its speed",
    );
    blown(
        "speed = 3\nturbulence = { dryden = { intensity = 0.1, length_scale = 10 }, von_karman = { intensity = 0.1, length_scale = 10 } }",
        "",
        "environment.wind.turbulence.von_karman: expected only one of these tables, found `dryden` and `von_karman` (an override can \
         replace the whole table: --set 'environment.wind.turbulence={von_karman = {...}}')",
    );
    blown(
        "speed = 3\nturbulence.dryden = { intensity = 0.1, deviation = 1, length_scale = 10 }",
        "",
        "environment.wind.turbulence.dryden.deviation: expected only one of `deviation` and `intensity`",
    );
    blown(
        "speed = 0\nturbulence.dryden = { deviation = 1, length_scale = 10 }",
        "",
        "environment.wind.turbulence.dryden: turbulence is carried along by the wind, whose speed is 0 (give \
         `environment.wind.speed`)",
    );
    blown(
        "speed = 20\nturbulence.dryden = { deviation = 1, length_scale = 3 }",
        "",
        "environment.wind.turbulence.dryden.length_scale: eddies of 3 m pass faster than the tables resolve: expected at least \
         4 m",
    );
    blown(
        "series.file = \"wind.csv\"\nspeed = 3",
        "t,vx,vy,vz\n0,1,2,3\n",
        "environment.wind.speed: expected only one of `series` and `speed`: a measured wind replaces all other keys",
    );
    blown(
        "series.file = \"wind.csv\"\nmuzzle_height = 3",
        "t,vx,vy,vz\n0,1,2,3\n",
        "environment.wind.muzzle_height: expected only one of `series` and `muzzle_height`: a measured wind replaces all other keys",
    );
    blown(
        "series.file = \"wind.csv\"",
        "t,vx,vy,vz\n0,1,2,3\n1,1,2,3\n1,1,2,3\n",
        "environment.wind.series.file: t: expected a time after that of the line before",
    );
    blown(
        "series.file = \"wind.csv\"",
        "t,vx,vy,vz\n0,1,2,3\n0.0000001,1,2,3\n1,1,2,3\n",
        "environment.wind.series.file: the times of its rows are too uneven for a table of 1e6 entries (leave out rows that lie \
         close together, or space them evenly)",
    );
    blown("series.file = \"wind.csv\"", "t,vx,vy,vz\n", "environment.wind.series.file: the file has no rows");
}
