//! Puts words, tables and figures into one HTML file that fetches nothing.
//!
//! `page.html` is the template and `page.css` its style for screen and paper. `charts.js` draws the figures, the
//! replay's scripts draw the net, and `page.js` links the two. The charting library is plotly.js from the `plotly`
//! crate.

mod tiles;

use netcast_results::{Manifest, Summary};
use plotly::Plot;
use serde_json::Value;

use crate::figures::{Figure, figures};
use crate::format::{duration, escape, prose};
use crate::pictures::{clouds_html, page_style, postures_html, stowed_html};
use crate::replay::{self, BUDGET_BYTES, replay};
use crate::results::Results;
use crate::tables::{stowed, tables};
use crate::words::{is_equilibrium, words};
use tiles::tiles;

const TEMPLATE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
pub(crate) const CHARTS: &str = include_str!("charts.js");
const SCRIPT: &str = include_str!("page.js");

const NO_SCENE: &str = "<p class=\"hint\">There is nothing to replay: a replay needs fields.vtkhdf with at least one \
    frame, and landmarks.json. This folder does not hold both.</p>\n";

/// What stands above the curves.
const CURVES: &str = "<noscript><p>The curves need JavaScript; their numbers are in history.csv beside this page.</p></noscript>\n\
    <p class=\"hint screen\">Press or drag in a figure to move the replay; its toolbar zooms into a stretch of time.</p>\n";

/// The whole page.
pub(crate) fn html(results: &Results) -> String {
    let summary = results.summary();
    // an equilibrium has a single record, which makes no curve
    let figures = if is_equilibrium(summary) { Vec::new() } else { figures(results) };
    let title = results.title();
    let sections = sections(results, &figures);
    fill(
        TEMPLATE,
        &[
            ("title", escape(&title)),
            ("style", format!("{STYLE}{}{}", replay::STYLE, page_style())),
            ("state", state(summary)),
            ("warnings", warnings(summary)),
            ("tiles", tiles(summary)),
            ("contents", contents(&sections)),
            ("sections", sections.iter().map(Section::html).collect()),
            ("provenance", provenance(&summary.netcast, &results.manifest)),
            ("data", data(&figures)),
            ("scripts", format!("{}{CHARTS}", replay::SCRIPT)),
            ("library", library()),
            ("script", SCRIPT.into()),
        ],
    )
}

/// The sections of the page in their order; one without a body is left out.
fn sections(results: &Results, figures: &[Figure]) -> Vec<Section> {
    let summary = results.summary();
    let told = words(summary);
    let has_replay = results.scene.is_some();
    // said where the points first appear: at the replay, which paper lacks, or else at the sentences
    let note = |class: &str| {
        let note = paper_points(results).map(|note| format!("<p class=\"hint below{class}\">{note}</p>\n"));
        note.unwrap_or_default()
    };
    let (at_replay, at_words) = if has_replay { (note(""), note(" on-paper")) } else { (String::new(), note("")) };
    let told = if told.is_empty() { String::new() } else { format!("<ul>\n{}</ul>\n{at_words}", list_items(&told)) };
    let charts: String = figures.iter().map(|figure| figure_frame(figure.title, figure.note, figure.id)).collect();
    let charts = if charts.is_empty() { charts } else { format!("{CURVES}<div class=\"charts\">\n{charts}</div>\n") };
    let numbers = tables(&results.file);
    let numbers = if numbers.is_empty() { numbers } else { format!("<div class=\"tables\">\n{numbers}</div>\n") };
    let all = [
        Section::new("replay", "Replay", replay_body(results) + &at_replay),
        Section::new("words", "What happened", told),
        Section::new("postures", "Postures", postures_html(results)),
        Section::new("figures", "Curves", charts),
        Section::new("clouds", "Tensions", clouds_html(results)),
        Section::new("numbers", "Numbers", numbers),
        Section::new("stowed", "The stowed state", stowed_html(results) + &stowed(&results.file)),
        Section::new("inputs", "Inputs", inputs(results)),
    ];
    all.into_iter().filter(|section| !section.body.is_empty()).collect()
}

/// A section of a page, listed in its contents.
pub(crate) struct Section {
    /// Its class and, after `part-`, its id.
    name: &'static str,
    title: &'static str,
    pub body: String,
}

impl Section {
    pub(crate) fn new(name: &'static str, title: &'static str, body: String) -> Self {
        Self { name, title, body }
    }

    pub(crate) fn html(&self) -> String {
        let Self { name, title, body } = self;
        format!("<section class=\"{name}\" id=\"part-{name}\">\n<h2>{title}</h2>\n{body}</section>\n")
    }
}

/// The table of contents.
pub(crate) fn contents(sections: &[Section]) -> String {
    let entry = |section: &Section| format!("<li><a href=\"#part-{}\">{}</a></li>\n", section.name, section.title);
    let entries: String = sections.iter().map(entry).collect();
    format!("<nav class=\"contents\" aria-label=\"Contents\">\n<ul>\n{entries}</ul>\n</nav>\n")
}

/// The points of the paper by name and place.
const PAPER_POINTS: [(&str, &str); 4] = [
    ("A", "A the middle of the traction rope nearest to C"),
    ("B", "B in the middle of the web"),
    ("C", "C at a corner"),
    ("D", "D between B and C"),
];

/// What the letters of the feature points mean; none where the web has none of them or its points are the user's own.
pub(crate) fn paper_points(results: &Results) -> Option<String> {
    let is_own = results.scenario.contains("[web.graph");
    let points = &results.summary().points;
    let known: Vec<_> =
        PAPER_POINTS.iter().filter(|(name, _)| points.get(*name).is_some_and(Option::is_some)).collect();
    if is_own || known.len() < 2 {
        return None;
    }
    let list = |texts: Vec<&str>| {
        let (last, before) = texts.split_last().expect("two points or more");
        format!("{} and {last}", before.join(", "))
    };
    let names = list(known.iter().map(|(name, _)| *name).collect());
    let places: Vec<&str> = known.iter().map(|(_, place)| *place).collect();
    Some(format!("{names} are the feature points of the paper that these webs come from: {}.", places.join(", ")))
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

/// The replay: its element, and the packed run.
fn replay_body(results: &Results) -> String {
    let Some(scene) = &results.scene else { return NO_SCENE.into() };
    let replay = replay(scene, "replay-data", BUDGET_BYTES, wind(results.summary()));
    let thinned =
        replay.thinned.map(|note| format!("<p class=\"hint below\">{}</p>\n", escape(&note))).unwrap_or_default();
    if replay.element.is_empty() {
        return thinned;
    }
    let stage = "<div class=\"replay-stage\"><div class=\"replay-card\"><div id=\"replay-view\"></div>\
        <div id=\"replay-controls\"></div></div></div>\n";
    format!("{stage}{thinned}{}", replay.element)
}

/// The wind at the muzzle at the start, m/s; none where it is still.
pub(crate) fn wind(summary: &Summary) -> Option<[f64; 3]> {
    let wind = summary.air.as_ref()?.wind_m_s;
    wind.iter().any(|along| *along != 0.0).then_some(wind)
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
    lines.iter().map(|line| format!("<li>{}</li>\n", prose(line))).collect()
}

/// The HTML element that a figure is drawn in.
pub(crate) fn figure_frame(title: &str, note: &str, id: &str) -> String {
    format!(
        "<figure><figcaption><h3>{}</h3><p>{}</p></figcaption>\
         <div class=\"chart\"><div class=\"plot\" id=\"{id}\"></div></div><div class=\"key\"></div></figure>\n",
        escape(title),
        prose(note)
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
