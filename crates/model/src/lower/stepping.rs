//! The size of a step, the part that limits it, and whether the number of steps is affordable.

use netcast_dynamics::step_size::{StepLimit, Stiff};
use netcast_dynamics::system::{Segment, System};
use netcast_scenario::quantity::Number;
use netcast_scenario::{Diagnostics, Document, Scenario, Solve};
use netcast_webs::{Class, CutWeb};

use super::draft::Draft;
use super::drawing::two_digits;
use super::listed::NEARLY_ONE;
use super::members::{Group, Member};
use super::size::MOST_ROWS;

use crate::Model;

/// Largest share of the stability limit. A larger step resolves the waves in a segment too poorly for tensions to be read,
/// even if the energy balance closes.
const LARGEST_FRACTION: f64 = 0.6;

/// Intended closure over the tolerance. A net of 30,000 segments closes two and a half times worse than the fitted law.
const AIM: f64 = 0.35;

/// Least factor of a larger step that is worth a message.
const NOTABLE: f64 = 1.3;

/// Steps in which a gust rises and falls: fewer do not see its peak.
const STEPS_OF_A_GUST: f64 = 20.0;

/// The most steps of a run. A larger number is a typing error.
const MOST_STEPS: f64 = 1e12;

impl Model {
    /// The largest step, s: the share of the stability limit that the scenario asks for, or less where a gust is short.
    pub fn largest_dt(&self) -> f64 {
        largest_dt(&self.scenario, &self.limit)
    }

    /// Whether a gust bounds the step.
    fn is_bound_by_gust(&self) -> bool {
        gust_dt(&self.scenario) <= self.largest_dt()
    }

    /// The change that would allow a larger step, in words; none if nothing limits the step.
    pub fn step_lift(&self) -> Option<String> {
        if self.is_bound_by_gust() {
            return Some("a longer environment.wind.gust.duration".to_owned());
        }
        let StepLimit { dt, without_damping, elsewhere, stiffest, .. } = self.limit;
        if let Some(Stiff::Segment(segment)) = stiffest
            && let Some([one, other]) = self.nearly_one_knot(segment)
        {
            return Some(format!("knots {one} and {other} made one: they nearly coincide"));
        }
        let what = match stiffest? {
            Stiff::Segment(segment) => match &self.groups[self.system.segments()[segment].group].class {
                Class::Canopy => "canopies".to_owned(),
                Class::Tie => "break ties".to_owned(),
                Class::Stitch => "stitches".to_owned(),
                class => format!("{class} ropes"),
            },
            Stiff::Effect { name: "bending", .. } => "bending of ropes".to_owned(),
            Stiff::Effect { name: "sheet", .. } => "sheets".to_owned(),
            Stiff::Effect { name: "bending of a sheet", .. } => "bending of sheets".to_owned(),
            Stiff::Effect { name: "ground", .. } => return Some("a longer environment.ground.contact_time".to_owned()),
            Stiff::Effect { name: "drag", .. } => {
                return Some("heavier or thinner parts, a thinner medium, or less speed".to_owned());
            }
            Stiff::Effect { name, .. } => name.to_owned(),
        };
        let times = |allowed: f64| format!("{:.1} times the step", allowed / dt);
        Some(if without_damping > NOTABLE * dt {
            format!("less damping in the {what} (without any, {})", times(without_damping))
        } else if elsewhere.is_finite() && elsewhere > NOTABLE * dt {
            format!("softer, heavier or longer segments in the {what} (the rest allows {})", times(elsewhere))
        } else {
            "longer or softer segments (solve.segment_length)".to_owned()
        })
    }

    /// The two knots of a segment that is a whole rope, much shorter than segments are meant to be.
    fn nearly_one_knot(&self, segment: usize) -> Option<[&str; 2]> {
        let Segment { ends, rest_length, .. } = self.system.segments()[segment];
        let meant = self.scenario.solve.segment_length?.si();
        let knots = &self.cut.web.knots;
        let is_short = rest_length < NEARLY_ONE * meant && self.members[segment].is_rope();
        (is_short && ends.iter().all(|&end| end < knots.len())).then(|| ends.map(|end| &knots[end].name[..]))
    }

    /// The part of the net that limits the step, in words; none if nothing limits it.
    pub fn limited_by(&self) -> Option<String> {
        if self.is_bound_by_gust() {
            return Some("the gust of the wind".to_owned());
        }
        limited_by(&self.limit, &self.cut, &self.members)
    }
}

/// The largest step of a run, s.
pub fn largest_dt(scenario: &Scenario, limit: &StepLimit) -> f64 {
    let share = scenario.solve.step_fraction.map_or(1.0, |fraction| fraction.si());
    (share * limit.dt).min(gust_dt(scenario))
}

/// The largest step that sees the gust of a scenario, s; infinite without one.
fn gust_dt(scenario: &Scenario) -> f64 {
    let gust = scenario.environment.wind.as_ref().and_then(|wind| wind.gust.as_ref());
    gust.map_or(f64::INFINITY, |gust| gust.duration.si() / STEPS_OF_A_GUST)
}

/// The default share of the stability limit: the energy balance closes within its tolerances, with room to spare.
///
/// The law was fitted to runs of a thrown net at several steps and damping ratios (docs/theory/step-size.md). The closure
/// grows with the power 3.5 of the share. At a quarter of the limit it is 0.69 % without damping and falls as
/// 1 / (1 + ratio / 0.0055); the closure of the web alone is 1.01 % and falls as 1 / (1 + ratio / 0.0123).
fn step_fraction(system: &System, groups: &[Group], limit: &StepLimit, solve: &Solve) -> f64 {
    let least = |s: &Segment| damping_ratio(s.damping, system.law(s).largest_stiffness(&s.into()), limit.dt);
    // ties and stitches have no damping, but they are few and break soon
    let lasting = system.segments().iter().filter(|s| !groups[s.group].class.is_made_to_break());
    let ratio = lasting.map(least).fold(f64::INFINITY, f64::min);
    let share = |asked: f64, undamped: f64, halved_at: f64| {
        let at_a_quarter = undamped / (1.0 + ratio / halved_at);
        0.25 * libm::pow(AIM * asked / at_a_quarter, 1.0 / 3.5)
    };
    let all = share(solve.energy_tolerance.si(), 0.0069, 0.0055);
    let web = share(solve.web_energy_tolerance.si(), 0.0101, 0.0123);
    two_digits(all.min(web).clamp(0.01, LARGEST_FRACTION))
}

/// Damping ratio of a segment from its `damping` c, N s/m, its `stiffness` k, N/m, and the stability limit `dt`, s, of a
/// rope of such segments. It solves c / (k dt) = 2 ratio (4 ratio + sqrt(16 ratio^2 + 1)).
fn damping_ratio(damping: f64, stiffness: f64, dt: f64) -> f64 {
    let at_limit = damping / (stiffness * dt);
    0.5 * at_limit / (1.0 + 4.0 * at_limit).sqrt()
}

/// Chooses the size of the step, if the scenario does not, and checks that the run is affordable.
///
/// # Errors
/// Too many records or too many steps.
pub fn choose(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, groups, members, system, .. } = draft;
    let Some((system, limit)) = system else { return Ok(()) };
    let chosen = step_fraction(system, groups, limit, &scenario.solve);
    scenario.solve.step_fraction.get_or_insert(Number::constant(chosen));
    require_affordable(document, scenario, limit, cut, members)
}

/// Checks the number of records and of steps.
fn require_affordable(
    document: &Document,
    scenario: &Scenario,
    limit: &StepLimit,
    cut: &CutWeb,
    members: &[Member],
) -> Result<(), Diagnostics> {
    let (duration, every) = (scenario.solve.run_time().unwrap_or(0.0), scenario.record.every.si());
    let largest_dt = largest_dt(scenario, limit);
    let steps = duration / largest_dt;
    let mut found = Vec::new();
    if duration / every > MOST_ROWS {
        let message = format!("{:.3e} records are too many; at most {MOST_ROWS:e} are allowed", duration / every);
        found.push(document.diagnostic("record.every", message).with_help("record less often, or for a shorter time"));
    }
    if steps > MOST_STEPS || steps.is_nan() {
        let what = limited_by(limit, cut, members).unwrap_or("the step".into());
        let message = format!("{steps:.3e} steps of {largest_dt:.3e} s are too many; {what} limits the step");
        found.push(document.diagnostic("solve.duration", message));
    }
    Diagnostics::fail_if_any(found)
}

/// The part of the net that limits the step, in words; none if nothing limits it.
fn limited_by(limit: &StepLimit, cut: &CutWeb, members: &[Member]) -> Option<String> {
    // the centre of a tractor is not a node of the drawn web
    let place = if limit.node < cut.nodes.len() { cut.node_label(limit.node) } else { "a rigid body".to_owned() };
    let at = |what: &str| format!("{what} at {place}");
    Some(match limit.stiffest? {
        Stiff::Segment(segment) => members[segment].label(cut),
        Stiff::Effect { name: "bending", .. } => at("the bending of a rope"),
        Stiff::Effect { name: "sheet", .. } => at("a sheet"),
        Stiff::Effect { name: "drag", .. } => at("the drag of the medium"),
        Stiff::Effect { name, .. } => at(&format!("the {name}")),
    })
}
