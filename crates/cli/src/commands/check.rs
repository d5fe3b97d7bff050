//! `netcast check`

mod air;
mod ground;
mod orbit;

use std::time::{Duration, Instant};

use clap::Args;
use netcast::dynamics::forces::bilinear::Bilinear;
use netcast::dynamics::forces::breaking::Breaking;
use netcast::dynamics::forces::law::Law;
use netcast::dynamics::forces::viscoelastic::Viscoelastic;
use netcast::dynamics::time::step::Stepper;
use netcast::model::Thrown;
use netcast::scenario::library::library;
use netcast::webs::{Class, PACKED_FILL};
use netcast::{Document, Model, schedule};

use super::ScenarioArguments;
use crate::Ended;
use crate::screen::{audit, notes, number, rows, say};

/// Read and check a scenario; print its bill of materials, step size and cost. Runs nothing
#[derive(Args)]
#[command(after_help = "\
Examples:
  netcast check examples/04_square_net/square_net.toml
  netcast check net.toml --set solve.segment_length=\"5 cm\"
  netcast check net.toml --links                 the names that [assign] may give a rope to")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,

    /// List every link with its class, ring, rope and length
    #[arg(long)]
    links: bool,
}

/// Carries it out.
pub fn run(arguments: &Arguments) -> Ended {
    let document = arguments.scenario.read()?;
    let model = Model::new(&document)?;
    if !model.scenario.title.is_empty() {
        say!("{}", model.scenario.title);
    }
    notes(&model);
    bill(&model);
    laws(&model);
    if arguments.links {
        links(&model);
    }
    from_library(&document);
    bodies(&model);
    launch(&model);
    ties(&model);
    orbit::orbit(&model);
    ground::ground(&model);
    air::air(&model);
    audit(&model);
    acting(&model);
    cost(&model);
    Ok(())
}

/// What it is made of.
fn bill(model: &Model) {
    let bill = &model.bill;
    say!("Bill of materials");
    let mut lines = Vec::new();
    for rope in &bill.ropes {
        lines.push((
            format!("{} {} mm", rope.name, number(1e3 * rope.diameter, 3)),
            format!("{} m, {} kg", number(rope.length, 5), number(rope.mass, 4)),
        ));
    }
    for (class, length) in &bill.length_by_class {
        lines.push((format!("  of which {class}"), format!("{} m", number(*length, 5))));
    }
    lines.push(("knots, ropes".into(), format!("{}, {}", bill.knots, bill.rope_count)));
    let counted = [
        ("canopies", bill.canopies, bill.canopy_mass),
        ("payloads", bill.payloads, bill.payload_mass),
        ("tractors", bill.tractors, bill.tractor_mass),
    ];
    for (name, count, mass) in counted.into_iter().filter(|(_, count, _)| *count > 0) {
        lines.push((name.into(), format!("{count}, {} kg", number(mass, 4))));
    }
    lines.push(("web without traction ropes".into(), format!("{} kg", number(bill.web_mass(), 4))));
    lines.push(("thrown in all".into(), format!("{} kg", number(model.mass, 4))));
    lines.push((
        "packed volume".into(),
        format!("{} litres, {} % of it solid", number(1e3 * bill.packed_volume, 3), number(100.0 * PACKED_FILL, 2)),
    ));
    if let Some(area) = model.cut.web.reference_area() {
        lines.push(("area inside the outline".into(), format!("{} m^2 flat", number(area, 5))));
    }
    if let Some(area) = model.cut.web.tractor_area() {
        lines.push(("area of the tractors' polygon".into(), format!("{} m^2 flat", number(area, 5))));
    }
    rows(&lines);
}

/// By which law each rope pulls, and at what it breaks.
fn laws(model: &Model) {
    say!("Laws of ropes");
    let mut lines: Vec<(String, String)> = Vec::new();
    for group in &model.groups {
        let Some(name) = &group.rope else { continue };
        let reduction = group.knot_reduction.unwrap_or(0.0);
        let load = |load: f64| match reduction > 0.0 {
            true => format!("{} N, at knots {} N", number(load, 4), number((1.0 - reduction) * load, 4)),
            false => format!("{} N", number(load, 4)),
        };
        let Breaking { load: most, strain } = group.breaking;
        let strain = Some(strain).filter(|strain| strain.is_finite());
        let limits = [
            Some(most).filter(|most| most.is_finite()).map(load),
            strain.map(|strain| format!("{} % strain", number(100.0 * strain, 4))),
        ];
        let limits: Vec<String> = limits.into_iter().flatten().collect();
        let breaks =
            if limits.is_empty() { "never breaks".into() } else { format!("breaks at {}", limits.join(" or ")) };
        let line = (name.clone(), format!("{}; {breaks}", in_words(&group.law)));
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    rows(&lines);
}

fn in_words(law: &Law) -> String {
    let times = |ratio: f64| format!("{} times the modulus", number(ratio, 4));
    match law {
        Law::Linear => "linear".into(),
        Law::Bilinear(Bilinear { strain, ratio }) => {
            format!("bilinear, {} beyond {} % strain", times(*ratio), number(100.0 * strain, 4))
        }
        Law::Tabulated(law) if law.has_hysteresis() => "from a table, with hysteresis".into(),
        Law::Tabulated(_) => "from a table".into(),
        Law::Viscoelastic(Viscoelastic { ratio, relaxation_time }) => {
            let ms = number(1e3 * relaxation_time, 4);
            format!("viscoelastic, {} at once, relaxing in {ms} ms", times(1.0 + ratio))
        }
        Law::Strut => "a strut: pulls and pushes".into(),
    }
}

/// What `[assign]` may name.
fn links(model: &Model) {
    say!("Links");
    let described = model.links().into_iter().map(|link| {
        let ring = link.ring.map_or(String::new(), |ring| format!(", ring {ring}"));
        (link.name, format!("{}{ring}, of {}, {} m", link.class, link.rope, number(link.length, 4)))
    });
    rows(&described.collect::<Vec<_>>());
}

/// Bodies that ropes can turn.
fn bodies(model: &Model) {
    let mut lines: Vec<(String, Vec<u32>)> = Vec::new();
    for (throw, corner) in model.tractors_by_corner().into_iter().zip(1u32..) {
        let Some((solid, body)) = throw else { continue };
        let [x, y, z] = body.inertia.to_array().map(|moment| number(moment, 3));
        let arm = body.ties[0].arm.to_array().map(|along| number(1e3 * along, 3)).join(", ");
        let mass = number(solid.mass_kg, 4);
        let told = format!("{mass} kg, inertia {x}, {y}, {z} kg m^2, tied at {arm} mm from its centre");
        match lines.iter_mut().find(|(known, _)| *known == told) {
            Some((_, corners)) => corners.push(corner),
            None => lines.push((told, vec![corner])),
        }
    }
    if lines.is_empty() {
        return;
    }
    say!("Rigid bodies");
    rows(&lines.into_iter().map(|(told, corners)| (named(&corners), told)).collect::<Vec<_>>());
}

/// The tractors at some corners.
fn named(corners: &[u32]) -> String {
    let numbers: Vec<String> = corners.iter().map(u32::to_string).collect();
    format!("tractor {}", numbers.join(", "))
}

/// How tractors are launched, where that is more than a speed for all.
fn launch(model: &Model) {
    let scenario = &model.scenario;
    let Some(launch) = &scenario.launch else { return };
    let mut lines = Vec::new();
    if launch.spin.si() != 0.0 {
        lines.push(("spin".into(), format!("{} rad/s about the launch axis", number(launch.spin.si(), 4))));
    }
    let is_plain = launch.tube.is_none() && launch.scatter.is_none() && scenario.tractors.is_empty();
    for throw in model.throws.iter().flatten().filter(|_| !is_plain) {
        let angle = throw.angle_to(model.axis()).to_degrees();
        let by = match &throw.by {
            Thrown::At(velocity) => format!("{} m/s", number(velocity.length(), 4)),
            Thrown::From { stroke, push } => {
                let work = push.work(*stroke).map(|work| format!(", {} J", number(work, 4)));
                format!("a tube of {} m{}", number(*stroke, 4), work.unwrap_or_default())
            }
        };
        let delay = if throw.delay > 0.0 { format!(", after {} ms", number(1e3 * throw.delay, 4)) } else { "".into() };
        lines.push((named(&[throw.corner]), format!("{by} at {} deg from the axis{delay}", number(angle, 4))));
    }
    if !lines.is_empty() {
        say!("Launch");
        rows(&lines);
    }
}

/// What holds the web until it breaks.
fn ties(model: &Model) {
    let mut lines = Vec::new();
    for (class, group) in model.groups.iter().enumerate().filter(|(_, group)| group.class.is_made_to_break()) {
        let loads = model.system.segments().iter().filter(|s| s.class == class).map(|s| s.breaking.load);
        let (count, most) = (loads.clone().count(), loads.fold(0.0, f64::max));
        let least = group.breaking.load;
        let load = match least == most {
            true => format!("{} N", number(least, 4)),
            false => format!("{} to {} N", number(least, 4), number(most, 4)),
        };
        let name = if group.class == Class::Tie { "break ties" } else { "stitches" };
        lines.push((name.into(), format!("{count}, let go at {load}; they weigh nothing")));
    }
    if !lines.is_empty() {
        say!("Held until it breaks");
        rows(&lines);
    }
}

/// Which values are the library's, and whose they are.
fn from_library(document: &Document) {
    let taken = &document.library.taken;
    if taken.is_empty() {
        return;
    }
    say!("From the library of materials");
    let mut lines: Vec<(String, String)> = Vec::new();
    for one in taken {
        let summary = (one.table.clone(), format!("{}: {}", one.material, library().summary(&one.material)));
        if !lines.contains(&summary) {
            lines.push(summary);
        }
        lines.push((format!("  {}", one.key), format!("{} ({})", one.value, one.sources.join(", "))));
    }
    let is_named = |source: &str| taken.iter().any(|one| one.sources.iter().any(|name| name == source));
    let named = library().sources.iter().filter(|(name, _)| is_named(name));
    lines.extend(named.map(|(name, source)| (format!("source {name}"), source.clone())));
    rows(&lines);
}

/// Loads and drives.
fn acting(model: &Model) {
    let (loads, drives) = (model.system.loads(), model.system.drives());
    let mut lines = Vec::new();
    if !loads.is_empty() {
        let sum = |axis: usize| number(loads.iter().map(|load| load.force[axis]).sum(), 4);
        let [x, y, z] = [0, 1, 2].map(sum);
        let ramped = loads.iter().filter(|load| !load.is_steady()).count();
        let ramped = if ramped > 0 { format!(", {ramped} of them brought up in time") } else { String::new() };
        lines.push(("loads".into(), format!("{} on nodes, {x}, {y}, {z} N in all{ramped}", loads.len())));
    }
    if let Some(end) = drives.iter().filter_map(|drive| drive.path.last()).map(|&(time, _)| time).reduce(f64::max) {
        lines.push(("drives".into(), format!("{} nodes moved, the last until {} s", drives.len(), number(end, 4))));
    }
    if !lines.is_empty() {
        say!("What acts on it");
        rows(&lines);
    }
}

/// Steps, segments, time and room.
fn cost(model: &Model) {
    if let Some(wanted) = model.scenario.solve.statics {
        let (nodes, segments) = (model.system.mass().len(), model.system.segments().len());
        say!("Equilibrium");
        let allowed = format!("at most {} of {nodes} nodes and {segments} segments", wanted.max_iterations);
        rows(&[("iterations".into(), allowed), ("forces balance to".into(), format!("{:e}", wanted.tolerance.si()))]);
        if model.scenario.solve.run_time().is_none() {
            return;
        }
    }
    let schedule = schedule(model);
    let (nodes, segments) = (model.system.mass().len(), model.system.segments().len());
    let limit = model.limited_by().unwrap_or("nothing".into());
    let fraction = model.largest_dt() / model.limit.dt;
    let records = schedule.count / schedule.steps_per_record + 1;
    let elements = [
        ("bends", model.system.bends().len()),
        ("triangles", model.system.membranes().len()),
        ("hinges", model.system.hinges().len()),
        ("rigid bodies", model.system.bodies().len()),
    ];
    let elements = elements.into_iter().filter(|(_, count)| *count > 0);
    let elements: String = elements.map(|(name, count)| format!(", {count} {name}")).collect();
    let frame = (nodes * 6 + segments + model.system.membranes().len()) * size_of::<f64>();
    let seconds = schedule.count as f64 * step_time(model, schedule.dt);
    say!("Cost");
    rows(&[
        ("model".into(), format!("{nodes} nodes, {segments} segments{elements}")),
        (
            "step".into(),
            format!(
                "{} us, at most {} % of the stable {} us, which {limit} sets",
                number(1e6 * schedule.dt, 4),
                number(100.0 * fraction, 3),
                number(1e6 * model.limit.dt, 4)
            ),
        ),
        ("a larger step would take".into(), model.step_lift().unwrap_or_else(|| "nothing".into())),
        ("steps".into(), format!("{} for {} s", schedule.count, number(schedule.time(schedule.count), 4))),
        (
            "segment updates".into(),
            format!(
                "{}, about {} s on one core of this machine",
                number(schedule.count as f64 * segments as f64, 3),
                number(seconds, 2)
            ),
        ),
        ("records".into(), format!("{records}, about {} MB", number(1e-6 * (records as f64) * frame as f64, 2))),
    ]);
}

/// Time of a step on this machine, s, from as many as fit into a moment.
fn step_time(model: &Model, dt: f64) -> f64 {
    const MOMENT: Duration = Duration::from_millis(50);
    let mut net = Stepper::new(&model.system, &model.state, dt, 1);
    let (clock, mut steps) = (Instant::now(), 0);
    while steps < 200 && clock.elapsed() < MOMENT {
        net.step();
        steps += 1;
    }
    clock.elapsed().as_secs_f64() / f64::from(steps)
}
