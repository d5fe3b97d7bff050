//! Puts words, tables and figures into one HTML file that fetches nothing.
//!
//! `page.html` is the template and `page.css` its style for screen and paper. `charts.js` draws the figures, the
//! replay's scripts draw the net, and `page.js` links the two. The charting library is plotly.js from the `plotly`
//! crate.

use netcast_results::{Manifest, OPEN_SHARE, Summary};
use plotly::Plot;
use serde_json::Value;

use crate::figures::{Figure, figures};
use crate::format::{duration, escape, percent, significant, time, with_prefix};
use crate::pictures::{clouds_html, page_style, postures_html, stowed_html};
use crate::replay::{self, BUDGET_BYTES, replay};
use crate::results::Results;
use crate::tables::{stowed, tables};
use crate::words::{is_equilibrium, words};

const TEMPLATE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
pub(crate) const CHARTS: &str = include_str!("charts.js");
const SCRIPT: &str = include_str!("page.js");

const NO_SCENE: &str = "<p class=\"hint\">There is nothing to replay: a replay needs fields.vtkhdf with at least one \
    frame, and landmarks.json. This folder does not hold both.</p>\n";

/// The whole page.
pub(crate) fn html(results: &Results) -> String {
    let summary = results.summary();
    // an equilibrium has a single record, which makes no curve
    let figures = if is_equilibrium(summary) { Vec::new() } else { figures(results) };
    let title = results.title();
    fill(
        TEMPLATE,
        &[
            ("title", escape(&title)),
            ("style", format!("{STYLE}{}{}", replay::STYLE, page_style())),
            ("state", state(summary)),
            ("warnings", warnings(summary)),
            ("tiles", tiles(summary)),
            ("replay", replay_section(results)),
            ("words", list_items(&words(summary))),
            ("postures", section("postures", "Postures", &postures_html(results))),
            ("clouds", section("clouds", "Tensions", &clouds_html(results))),
            ("stowed", section("stowed", "The stowed state", &(stowed_html(results) + &stowed(&results.file)))),
            ("inputs", section("inputs", "Inputs", &inputs(results))),
            ("figures", figures.iter().map(|figure| figure_frame(figure.title, figure.note, figure.id)).collect()),
            ("tables", tables(&results.file)),
            ("provenance", provenance(&summary.netcast, &results.manifest)),
            ("data", data(&figures)),
            ("scripts", format!("{}{CHARTS}", replay::SCRIPT)),
            ("library", library()),
            ("script", SCRIPT.into()),
        ],
    )
}

/// The template with each `{{name}}` replaced by its part. Parts are not searched again, so a title may hold braces.
///
/// # Panics
/// Where the template has an unknown name or unclosed braces.
pub(crate) fn fill(template: &str, parts: &[(&str, String)]) -> String {
    let mut page = String::with_capacity(template.len() + parts.iter().map(|(_, part)| part.len()).sum::<usize>());
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        let (name, after) = after.split_once("}}").expect("the template closes its braces");
        let (_, part) = parts.iter().find(|(known, _)| *known == name).expect("the template names known parts");
        page.push_str(before);
        page.push_str(part);
        rest = after;
    }
    page + rest
}

/// A section of the page with a heading; empty text where `body` is empty.
fn section(class: &str, title: &str, body: &str) -> String {
    if body.is_empty() {
        return String::new();
    }
    format!("<section class=\"{class}\">\n<h2>{title}</h2>\n{body}</section>\n")
}

/// The section of the replay: its element, and the packed run.
fn replay_section(results: &Results) -> String {
    let Some(scene) = &results.scene else { return section("replay", "Replay", NO_SCENE) };
    let replay = replay(scene, "replay-data", BUDGET_BYTES);
    let thinned = replay.thinned.map(|note| format!("<p class=\"hint\">{}</p>\n", escape(&note))).unwrap_or_default();
    if replay.element.is_empty() {
        return section("replay", "Replay", &thinned);
    }
    let stage = "<div class=\"replay-stage\"><div class=\"replay-card\"><div id=\"replay-view\"></div>\
        <div id=\"replay-controls\"></div></div></div>\n";
    section("replay", "Replay", &format!("{stage}{thinned}{}", replay.element))
}

/// The resolved scenario; empty text where the folder lacks it.
fn inputs(results: &Results) -> String {
    if results.scenario.is_empty() {
        return String::new();
    }
    format!(
        "<details><summary>The scenario with all defaults filled in</summary>\n<pre>{}</pre></details>\n",
        escape(&results.scenario)
    )
}

fn state(summary: &Summary) -> String {
    if summary.finished { String::new() } else { "<span class=\"state stopped\">stopped early</span>".into() }
}

fn warnings(summary: &Summary) -> String {
    if summary.warnings.is_empty() {
        return String::new();
    }
    format!("<aside class=\"warnings\"><h2>Mind</h2><ul>{}</ul></aside>", list_items(&summary.warnings))
}

fn list_items(lines: &[String]) -> String {
    lines.iter().map(|line| format!("<li>{}</li>\n", escape(line))).collect()
}

/// The handful of numbers that a designer looks for first.
fn tiles(summary: &Summary) -> String {
    let Summary { opening, tension, energy, .. } = summary;
    let at_rest = is_equilibrium(summary);
    let area = opening.area_max_m2;
    let share = area.zip(opening.reference_area_m2).map(|(area, flat)| percent(area / flat));
    let tractor = summary.points.get("tractor").and_then(Option::as_ref);
    let is_known = |value: &f64| value.is_finite();
    let tension_max = Some(tension.max_n).filter(is_known);
    let open = format!("{} open for", percent(OPEN_SHARE));
    let tiles = [
        (
            if at_rest { "area" } else { "largest area" },
            area.map(|area| format!("{} m²", significant(area))),
            share.map(|s| format!("{s} of flat")),
        ),
        (
            &open,
            opening.effective_duration_s.filter(|_| !at_rest).map(time),
            opening.effective_from_s.map(|from| format!("from {}", time(from))),
        ),
        (
            "highest tension",
            tension_max.map(|force| with_prefix(force, "N")),
            tension.max_where.as_ref().map(|class| format!("{class} rope")),
        ),
        (
            "tractors travel",
            tractor
                .and_then(|tractor| tractor.peak_travel_m)
                .filter(|_| !at_rest)
                .map(|travel| format!("{} m", significant(travel))),
            None,
        ),
        (
            "forces balance to",
            summary.statics.as_ref().and_then(|found| found.residual_relative).map(|share| format!("{share:.1e}")),
            summary.statics.as_ref().map(|found| format!("{:.1e} allowed", found.tolerance)),
        ),
        (
            "energy closes to",
            Some(energy.closure).filter(is_known).filter(|_| !at_rest).map(percent),
            Some(energy.tolerance).filter(is_known).map(|tolerance| format!("{} allowed", percent(tolerance))),
        ),
    ];
    tiles
        .into_iter()
        .filter_map(|(name, value, detail)| {
            let (value, detail) = (escape(&value?), escape(&detail.unwrap_or_default()));
            Some(format!("<div><dt>{name}</dt><dd>{value}<small>{detail}</small></dd></div>\n"))
        })
        .collect()
}

/// The HTML element that a figure is drawn in.
pub(crate) fn figure_frame(title: &str, note: &str, id: &str) -> String {
    format!(
        "<figure><figcaption><h3>{}</h3><p>{}</p></figcaption>\
         <div class=\"chart\"><div class=\"plot\" id=\"{id}\"></div></div><div class=\"key\"></div></figure>\n",
        escape(title),
        escape(note)
    )
}

pub(crate) fn provenance(netcast: &str, manifest: &Manifest) -> String {
    let known = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
    let short = |hash: &str| hash.chars().take(12).collect::<String>();
    let machine = &manifest.machine;
    let facts = [
        ("netcast", known(netcast).or(known(&manifest.version))),
        ("revision", manifest.revision.as_deref().map(short)),
        ("inputs", known(&short(&manifest.input_hash))),
        ("started", known(&manifest.started)),
        ("computed in", Some(manifest.wall_time_s).filter(|clock| *clock > 0.0).map(duration)),
        ("threads", Some(manifest.threads).filter(|threads| *threads > 0).map(|threads| threads.to_string())),
        ("on", machine.cpu.clone()),
        ("system", known(&machine.os).map(|os| format!("{os} {}", machine.arch))),
        ("seed", manifest.seed.map(|seed| seed.to_string())),
    ];
    facts
        .into_iter()
        .filter_map(|(name, value)| Some(format!("<div><dt>{name}</dt><dd>{}</dd></div>\n", escape(&value?))))
        .collect()
}

/// The figures as JSON for a script element, which must not contain `<`.
fn data(figures: &[Figure]) -> String {
    Value::Array(figures.iter().map(Figure::json).collect()).to_string().replace('<', "\\u003c")
}

/// plotly.js as an element that `charts.js` runs once the page is shown. MathJax, which the crate appends, is left out.
pub(crate) fn library() -> String {
    const START: &str = "<script type=\"text/javascript\">";
    const END: &str = "</script>";
    let sources = Plot::offline_js_sources();
    let (_, sources) = sources.split_once(START).expect("the crate embeds the library as a script");
    let (library, _) = sources.split_once(END).expect("a script ends");
    format!("<script type=\"text/plain\" id=\"library\">{library}{END}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_within_a_part_are_not_filled() {
        let parts = [("title", "{{words}} & {{".to_owned()), ("words", "none".to_owned())];
        assert_eq!(fill("<h1>{{title}}</h1>{{words}}", &parts), "<h1>{{words}} & {{</h1>none");
    }

    #[test]
    fn the_library_is_one_script() {
        let library = library();
        assert!(library.contains("plotly.js v"));
        assert_eq!(library.matches("<script").count() - library.matches("\"<script").count(), 1);
        assert!(library.len() < 5_000_000, "{} bytes: more than plotly.js alone", library.len());
    }
}
