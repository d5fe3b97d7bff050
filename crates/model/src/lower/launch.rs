//! The launch: velocities of a graph's nodes, and how each tractor is thrown.

use glam::{DMat3, DVec3};
use netcast_dynamics::launcher::{ForceCurve, Push};
use netcast_scenario::{Diagnostic, Diagnostics, Document, Launch, Scenario, Tube};
use netcast_webs::CutWeb;

use super::draft::Draft;
use super::scatter::Chance;
use super::throw::{Throw, Thrown, launch_frame};

/// Velocities of a graph's nodes by its file, world frame, m/s, (nodes,); zero for any other web.
pub fn own_velocities(document: &Document, cut: &CutWeb, frame: DMat3) -> Vec<DVec3> {
    let mut velocity = vec![DVec3::ZERO; cut.nodes.len()];
    for (node, row) in document.files.graph.iter().flat_map(|g| &g.nodes).enumerate() {
        velocity[node] = frame * DVec3::from_array(row.velocity_m_s);
    }
    velocity
}

/// Finds how each tractor is thrown: along the launch axis, and outwards in the direction of its corner.
///
/// # Errors
/// A tractor at a corner that the web lacks, a launch without tractors, settings that contradict each other.
pub fn throws(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, throws, .. } = draft;
    let (web, scenario) = (&cut.web, &*scenario);
    let mut found = Vec::new();
    for (index, tractor) in scenario.tractors.iter().enumerate() {
        let corner = tractor.corner.get() as usize;
        if corner > web.corners.len() {
            let message = format!("the web has {} corners, not {corner}", web.corners.len());
            found.push(document.diagnostic(&format!("tractors.{index}.corner"), message));
        }
    }
    let moves =
        |launch: &Launch| launch.axial_speed.si() != 0.0 || launch.radial_speed.si() != 0.0 || launch.tube.is_some();
    if web.tractors.is_empty() && scenario.launch.as_ref().is_some_and(moves) {
        let message = "nothing to launch: the scenario has no tractors";
        found.push(document.diagnostic("launch", message).with_help("add [tractor.particle] or [tractor.cylinder]"));
    }
    found.extend(contradictions(document, scenario));
    let tube = scenario.launch.as_ref().and_then(|launch| launch.tube.as_ref());
    let push = tube.and_then(|tube| push(document, tube).map_err(|diagnostic| found.push(diagnostic)).ok());
    Diagnostics::fail_if_any(found)?;

    let scatter = scenario.launch.as_ref().and_then(|launch| launch.scatter.as_ref());
    let throw = |index: usize| {
        let corner = index as u32 + 1;
        let launch = scenario.tractor_launch(corner)?;
        let chance = scatter.map_or(Chance::default(), |scatter| Chance::of(scatter, corner));
        let outwards = web.knots[web.corners[index]].position - web.middle;
        let radial = DVec3::new(outwards.x, outwards.y, 0.0).normalize_or_zero();
        let axis = launch_frame(&launch) * DVec3::Z;
        let own = scenario.tractor_override(corner).and_then(|tractor| tractor.delay);
        let delay = own.map_or(0.0, |delay| delay.si()) + chance.delay;
        let (direction, by) = match (&launch.tube, &push) {
            (Some(tube), Some(push)) => {
                let (sin, cos) = libm::sincos(tube.cant.si());
                let direction = chance.turned(launch_frame(&launch) * (sin * radial + cos * DVec3::Z));
                let push = scaled(push, (1.0 + chance.speed) * (1.0 + chance.speed));
                (direction, Thrown::From { stroke: tube.stroke.si(), push })
            }
            _ => {
                let in_frame = launch.radial_speed.si() * radial + launch.axial_speed.si() * DVec3::Z;
                let velocity = launch_frame(&launch) * in_frame;
                let velocity = if chance == Chance::default() {
                    velocity
                } else {
                    (1.0 + chance.speed) * velocity.length() * chance.turned(velocity.normalize_or_zero())
                };
                (velocity.try_normalize().unwrap_or(axis), Thrown::At(velocity))
            }
        };
        Some(Throw { corner, node: web.tractors[index], delay, direction, by, launcher: None })
    };
    *throws = (0..web.tractors.len()).map(throw).collect();
    if scatter.is_some_and(|scatter| scatter.delay.si() > 0.0) {
        // scatter can make a delay negative: the first launch is at time 0
        let earliest = throws.iter().flatten().map(|throw| throw.delay).fold(f64::INFINITY, f64::min);
        for throw in throws.iter_mut().flatten() {
            throw.delay -= earliest;
        }
    }
    Ok(())
}

/// Reports settings of a launch that exclude each other.
fn contradictions(document: &Document, scenario: &Scenario) -> Vec<Diagnostic> {
    let Some(launch) = &scenario.launch else { return Vec::new() };
    let own = |key: &str, is_given: fn(&netcast_scenario::TractorOverride) -> bool| {
        let tractors = scenario.tractors.iter().enumerate().filter(|(_, tractor)| is_given(tractor));
        tractors.map(|(index, _)| format!("tractors.{index}.{key}")).collect::<Vec<_>>()
    };
    let mut found = Vec::new();
    if launch.tube.is_some() {
        let common = [("axial_speed", launch.axial_speed), ("radial_speed", launch.radial_speed)];
        let common = common.into_iter().filter(|(_, speed)| speed.si() != 0.0);
        let mut given: Vec<String> = common.map(|(key, _)| format!("launch.{key}")).collect();
        given.extend(own("axial_speed", |tractor| tractor.axial_speed.is_some_and(|speed| speed.si() != 0.0)));
        given.extend(own("radial_speed", |tractor| tractor.radial_speed.is_some_and(|speed| speed.si() != 0.0)));
        found.extend(given.iter().map(|path| {
            let message = "the speed of a tractor in a tube follows from the force on it";
            let help = "leave it out, or [launch.tube]; `launch.tube.cant` turns the tubes outwards";
            document.diagnostic(path, message).with_help(help)
        }));
    }
    if launch.spin.si() != 0.0 {
        let scatters = launch.scatter.as_ref().is_some_and(|scatter| scatter.delay.si() > 0.0);
        let parts = [("launch.tube", launch.tube.is_some()), ("launch.scatter.delay", scatters)];
        let mut given: Vec<String> = parts.into_iter().filter(|part| part.1).map(|part| part.0.to_owned()).collect();
        given.extend(own("delay", |tractor| tractor.delay.is_some_and(|delay| delay.si() > 0.0)));
        given.extend((!scenario.covers.is_empty()).then(|| "covers".to_owned()));
        let imperfection = scenario.stow.as_ref().and_then(|stowage| stowage.imperfection.as_ref());
        let is_late = imperfection.is_some_and(|imperfect| imperfect.late_sector.is_some());
        given.extend(is_late.then(|| "stow.imperfection.late_sector".to_owned()));
        found.extend(given.iter().map(|path| {
            let message = "a spinning web is launched at once, and from no tube";
            document.diagnostic(path, message).with_help("leave it out, or `launch.spin`")
        }));
    }
    found
}

/// The force on a tractor in its tube.
fn push(document: &Document, tube: &Tube) -> Result<Push, Diagnostic> {
    let points = |key: &str, at: Option<Vec<f64>>, force: Option<Vec<f64>>| {
        let path = format!("launch.tube.{key}");
        let points: Vec<(f64, f64)> = match (at, force, &document.files.push) {
            (Some(at), Some(force), _) if at.len() == force.len() && !at.is_empty() => {
                at.into_iter().zip(force).collect()
            }
            (Some(at), Some(force), _) => {
                let message =
                    format!("expected one force a point, found {} points and {} forces", at.len(), force.len());
                return Err(document.diagnostic(&path, message));
            }
            (_, _, Some(rows)) => rows.iter().map(|row| (row.at, row.force_n)).collect(),
            _ => return Err(document.diagnostic(&path, "a force is given at points, or in a file")),
        };
        if points.windows(2).all(|pair| pair[0].0 < pair[1].0) {
            Ok(ForceCurve(points))
        } else {
            Err(document.diagnostic(&format!("{path}.at"), "expected increasing values"))
        }
    };
    let forces = |force: &Option<Vec<netcast_scenario::quantity::Force<_>>>| {
        force.as_ref().map(|force| force.iter().map(|force| force.si()).collect())
    };
    match (&tube.force_over_stroke, &tube.force_over_time) {
        (Some(over), _) => {
            let at = over.at.as_ref().map(|at| at.iter().map(|way| way.si()).collect());
            points("force_over_stroke", at, forces(&over.force)).map(Push::OverStroke)
        }
        (None, Some(over)) => {
            let at = over.at.as_ref().map(|at| at.iter().map(|time| time.si()).collect());
            points("force_over_time", at, forces(&over.force)).map(Push::OverTime)
        }
        (None, None) => Err(document.diagnostic("launch.tube", "a tube needs a force")),
    }
}

/// The force times `factor`.
fn scaled(push: &Push, factor: f64) -> Push {
    let scaled = |curve: &ForceCurve| ForceCurve(curve.0.iter().map(|&(at, force)| (at, factor * force)).collect());
    match push {
        Push::OverStroke(curve) => Push::OverStroke(scaled(curve)),
        Push::OverTime(curve) => Push::OverTime(scaled(curve)),
    }
}
