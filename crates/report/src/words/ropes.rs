//! Tensions of ropes, and what breaks or lets go.

use netcast_results::Summary;
use netcast_results::summary::BrokenSegment;

use super::phrases::{article, at};
use crate::format::{beside, percent, percent_to, significant_to, with_prefix};
use crate::pictures::SLACK_BELOW;

/// A use of the strength below this is not worth a margin.
const LEAST_USE: f64 = 1e-4;

/// Whether a tension, N, is more than the rounding error of a length.
fn is_taut(tension: f64) -> bool {
    tension >= SLACK_BELOW
}

pub(super) fn hardest_pull(summary: &Summary) -> Option<String> {
    let tension = &summary.tension;
    // a file that does not tell the tension has no number here
    let max = Some(tension.max_n).filter(|max| max.is_finite())?;
    if !is_taut(max) {
        return Some("No rope is ever taut.".into());
    }
    let class = tension.max_where.as_ref();
    let rope = class.map(|class| format!(" is {} {class} rope", article(class))).unwrap_or(" bears".into());
    let colon = if class.is_some() { ":" } else { "" };
    Some(format!("The hardest pulled rope{rope}{colon} {}{}.", with_prefix(max, "N"), at(tension.max_time_s)))
}

/// What broke, in the order of time: what was made to, or what was not.
fn breaks(summary: &Summary, released: bool) -> Vec<&BrokenSegment> {
    summary.breaks.iter().filter(|one| one.released == released).collect()
}

/// Where, when and under what something broke.
fn break_in_words(one: &BrokenSegment) -> String {
    format!("{}{}, under {}", one.place, at(Some(one.time_s)), with_prefix(one.tension_n, "N"))
}

pub(super) fn broken(summary: &Summary) -> Option<String> {
    let breaks = breaks(summary, false);
    let first = break_in_words(breaks.first()?);
    Some(match breaks.len() {
        1 => format!("Something breaks: {first}."),
        more => format!("{more} segments break, the first of them {first}."),
    })
}

/// Ropes that were cut.
pub(super) fn cut(summary: &Summary) -> Option<String> {
    let cuts: Vec<String> = summary.breaks.iter().filter(|one| one.cut).map(break_in_words).collect();
    Some(match cuts.len() {
        0 => return None,
        1 => format!("One rope is cut: {}.", cuts[0]),
        more => format!("{more} ropes are cut, the first of them {}.", cuts[0]),
    })
}

/// Break ties and stitches.
pub(super) fn let_go(summary: &Summary) -> Option<String> {
    let ties: Vec<&BrokenSegment> = breaks(summary, true).into_iter().filter(|one| !one.cut).collect();
    let (first, last) = (break_in_words(ties.first()?), break_in_words(ties.last()?));
    let (one, several) = match ["tie", "stitch"].map(|class| ties.iter().all(|tie| tie.class == class)) {
        [true, _] => ("tie", "ties"),
        [_, true] => ("stitch", "stitches"),
        _ => ("thread", "ties and stitches"),
    };
    Some(match ties.len() {
        1 => format!("One {one} lets go: {first}."),
        more => format!("{more} {several} let go, the first of them {first}, the last {last}."),
    })
}

/// The rope that comes nearest to breaking.
pub(crate) struct Worst<'s> {
    /// Its name in the scenario.
    pub name: &'s str,
    /// Its largest tension over its strength.
    pub utilisation: f64,
    /// The link class in which that occurs.
    pub class: Option<&'s str>,
    /// The share of the strength that knots take.
    knots: Option<f64>,
}

/// The rope that comes nearest to breaking, of those whose strength is given and which are ever taut.
pub(crate) fn worst(summary: &Summary) -> Option<Worst<'_>> {
    let used = summary.tension.by_rope.iter().filter_map(|(name, rope)| Some((name, rope, rope.utilisation?)));
    let (name, rope, utilisation) = used.max_by(|(_, _, a), (_, _, b)| a.total_cmp(b)).filter(|(_, _, u)| *u > 0.0)?;
    let is_slack = summary.tension.max_n.is_finite() && !is_taut(summary.tension.max_n);
    let knots = rope.knot_reduction.filter(|share| *share > 0.0);
    (!is_slack).then_some(Worst { name, utilisation, class: rope.max_where.as_deref(), knots })
}

impl Worst<'_> {
    /// Strength over largest tension; one beside 1 tells on which side it is.
    pub fn margin(&self) -> String {
        beside(1.0 / self.utilisation, 1.0, significant_to)
    }

    /// Its name as it reads in a sentence.
    pub fn called(&self) -> String {
        match self.name {
            "rope" => "the default rope".to_owned(),
            name => format!("rope {name}"),
        }
    }
}

pub(super) fn worst_rope(summary: &Summary) -> Option<String> {
    let worst = worst(summary)?;
    if worst.utilisation < LEAST_USE {
        return Some(format!("No rope bears {} of its strength.", percent(LEAST_USE)));
    }
    let class = worst.class.map(|class| format!(", in {} {class} rope", article(class))).unwrap_or_default();
    let left = match worst.knots {
        Some(share) => format!("of the strength that knots leave it ({} less)", percent(share)),
        None => "of its strength".into(),
    };
    let broke = !breaks(summary, false).is_empty();
    let (used, margin) = (beside(worst.utilisation, 1.0, percent_to), worst.margin());
    let holds = worst.utilisation <= 1.0 || broke;
    let so = if holds { format!("a margin of {margin}") } else { format!("it would break (margin {margin})") };
    let name = worst.called();
    let (first, rest) = name.split_at(1);
    Some(format!("{}{rest} is worst off: {used} {left}{class}; {so}.", first.to_uppercase()))
}

pub(super) fn bottom_pull(summary: &Summary) -> Option<String> {
    let tension = &summary.tension;
    let max = tension.bottom_max_n?;
    if !is_taut(max) {
        return Some("The bottom ropes, which meet point B, stay slack.".into());
    }
    let mean = tension.bottom_mean_n.filter(|mean| is_taut(*mean));
    let mean = mean.map(|mean| format!(", {} on average while the web opens", with_prefix(mean, "N")));
    Some(format!(
        "The bottom ropes, which meet point B, bear up to {}{}.",
        with_prefix(max, "N"),
        mean.unwrap_or_default()
    ))
}
