//! A comparison as one HTML page that works offline: replays on one clock, results, differing inputs, overlaid curves.
//!
//! ```text
//!  summary.json of the comparison ──▶ tables   differences and results ─┐
//!  history.csv of each design     ──▶ figures  one curve for each       ├─▶ report.html
//!  fields.vtkhdf of each design   ──▶ replay   all on one clock        ─┘
//! ```
//!
//! A design has the same colour, dash and place everywhere.

mod figures;
mod tables;

use std::fs;
use std::path::{Path, PathBuf};

use netcast_results::comparison::Design;
use netcast_results::{Comparison, Manifest, folder, read_json};
use serde_json::json;

use figures::{Overlay, overlays};
use tables::{all_quantities, differences, headlines};

use crate::ReportError;
use crate::format::{escape, prose};
use crate::page::{CHARTS, Section, contents, fill, library, paper_points, provenance, wind};
use crate::replay::{self, replay};
use crate::results::Results;

const TEMPLATE: &str = include_str!("compare.html");
const STYLE: &str = concat!(include_str!("../page/page.css"), include_str!("compare.css"));
const SCRIPT: &str = include_str!("compare.js");

/// What stands above the table of results.
const BEST: &str = "<p class=\"lead\"><span aria-hidden=\"true\">★</span> best of the row, where lower \
    <span class=\"wanted\">↓</span> or higher <span class=\"wanted\">↑</span> is better; values that read alike share it.</p>\n";

/// What stands above the replays.
const STEP: &str = "<p class=\"lead\">All replays have one clock, one camera, and the same scales of length and tension.</p>\n\
    <noscript><p>The replay needs JavaScript.</p></noscript>\n";

/// What stands above the curves.
const CURVES: &str = "<noscript><p>The curves need JavaScript; their numbers are in the history.csv of each design's folder.\
    </p></noscript>\n<p class=\"hint screen\">Press or drag in a figure to move the replays; its toolbar zooms into a stretch \
    of time.</p>\n";

/// Writes `report.html` into the folder of a comparison from its `summary.json` and `manifest.json` and the result
/// folders of its designs, and returns its path.
///
/// # Errors
/// [`ReportError`] names the file that is missing, malformed or cannot be written.
pub fn write_comparison(comparison_dir: &Path) -> Result<PathBuf, ReportError> {
    let comparison: Comparison = read_json(&comparison_dir.join(folder::SUMMARY))?;
    let manifest = Manifest::read(&comparison_dir.join(folder::MANIFEST))?;
    let designs = &comparison.designs;
    let mut overlay = Overlay::default();
    let mut replays = String::new();
    let mut notes = Vec::new();
    let mut paper = None;
    for (index, design) in designs.iter().enumerate() {
        // read one design at a time: the fields of a dozen do not fit in memory together
        let results = Results::read(&comparison_dir.join(&design.folder))?;
        overlay.add(index, &results);
        paper = paper.or_else(|| paper_points(&results));
        let name = &design.name;
        match &results.scene {
            Some(scene) => {
                let budget = replay::BUDGET_BYTES / designs.len();
                let packed = replay(scene, &format!("replay-{index}"), budget, wind(results.summary()));
                replays += &packed.element;
                notes.extend(packed.thinned.map(|thinned| format!("{name}: {thinned}")));
            }
            None => {
                notes.push(format!("{name}: its folder holds no fields or landmarks, so it cannot be replayed."));
            }
        }
    }
    notes.extend(paper);
    let page = Page { comparison: &comparison, manifest: &manifest, replays, notes };
    let path = comparison_dir.join(folder::REPORT);
    fs::write(&path, page.html(&overlay)).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    Ok(path)
}

/// The contents of the page, besides the figures.
struct Page<'c> {
    comparison: &'c Comparison,
    manifest: &'c Manifest,
    /// Elements that hold the packed runs.
    replays: String,
    /// What the replays leave out, and designs without a replay.
    notes: Vec<String>,
}

impl Page<'_> {
    fn html(&self, overlay: &Overlay) -> String {
        let designs = &self.comparison.designs;
        let figures = overlays(overlay);
        let charts: String = figures.iter().map(|figure| figure.frame()).collect();
        let sections = self.sections(charts);
        let data = json!({
            "designs": designs.iter().map(|design| &design.name).collect::<Vec<_>>(),
            "dashes": DASHES.map(|dash| dash.replace(' ', ",").replace("none", "solid")),
            "figures": figures.iter().map(|figure| figure.json(designs)).collect::<Vec<_>>(),
        });
        fill(
            TEMPLATE,
            &[
                ("title", escape(&self.comparison.title)),
                ("style", STYLE.into()),
                ("replay-style", replay::STYLE.into()),
                ("designs", designs.iter().enumerate().map(|(index, design)| card(index, design)).collect()),
                ("failures", self.failures()),
                ("contents", contents(&sections)),
                ("sections", sections.iter().map(Section::html).collect()),
                ("provenance", provenance(&self.comparison.netcast, self.manifest)),
                // no `<` may stand within a script element
                ("data", data.to_string().replace('<', "\\u003c")),
                ("replays", self.replays.clone()),
                ("library", library()),
                ("scripts", [replay::SCRIPT, CHARTS].concat()),
                ("script", SCRIPT.into()),
            ],
        )
    }

    /// The sections in their order; one without a body is left out.
    fn sections(&self, charts: String) -> Vec<Section> {
        let results = headlines(self.comparison);
        let results = if results.is_empty() { results } else { format!("{BEST}{}{results}", self.source()) };
        let charts =
            if charts.is_empty() { charts } else { format!("{CURVES}<div class=\"charts\">\n{charts}</div>\n") };
        let all = [
            Section::new("replay", "Replays in step", self.replays_in_step()),
            Section::new("came-out", "Results", results),
            Section::new("differences", "What differs in the inputs", differences(self.comparison)),
            Section::new("figures", "Curves", charts),
            Section::new("quantities", "All quantities", all_quantities(self.comparison)),
        ];
        all.into_iter().filter(|section| !section.body.is_empty()).collect()
    }

    /// The stages of all designs and their common controls.
    fn replays_in_step(&self) -> String {
        let designs = &self.comparison.designs;
        let stages: String = designs.iter().enumerate().map(|(index, design)| stage(index, design)).collect();
        let notes: String = self.notes.iter().map(|note| format!("<p>{}</p>\n", prose(note))).collect();
        let columns = columns(designs.len());
        format!(
            "{STEP}<div class=\"stages\" style=\"--columns: {columns}\">\n{stages}</div>\n\
             <div id=\"replay-controls\"></div>\n{notes}"
        )
    }

    /// The designs that failed or stopped early, each with the reason.
    fn failures(&self) -> String {
        let told: String = self
            .comparison
            .designs
            .iter()
            .filter_map(|design| {
                let name = escape(&design.name);
                let why = match (&design.failure, design.finished) {
                    (Some(failure), _) => prose(failure),
                    (None, false) => "its run stopped before its end".into(),
                    (None, true) => return None,
                };
                Some(format!("<li><b>{name}</b>: {why}. It is shown up to there and never marked best.</li>\n"))
            })
            .collect();
        if told.is_empty() { told } else { format!("<aside class=\"warnings\"><h2>Mind</h2><ul>{told}</ul></aside>") }
    }

    fn source(&self) -> String {
        match &self.comparison.reported {
            Some(source) => format!(
                "<p>Reported: {}. The percentage is the deviation of the design's own number from the reported one.</p>",
                prose(source)
            ),
            None => String::new(),
        }
    }
}

/// A design at the head of the page, with a link to its own report.
fn card(index: usize, design: &Design) -> String {
    let (name, title) = (escape(&design.name), escape(&design.title));
    let state = match (design.finished, &design.failure) {
        (true, None) => "",
        (false, _) => "<span class=\"state stopped\">stopped early</span>",
        (true, Some(_)) => "<span class=\"state stopped\">failed</span>",
    };
    let others = design.warnings.iter().filter(|warning| Some(*warning) != design.failure.as_ref());
    let warnings: String = others.map(|warning| format!("<li>{}</li>", prose(warning))).collect();
    let warnings = if warnings.is_empty() { warnings } else { format!("<ul>{warnings}</ul>") };
    let link = format!("{}/{}", percent_encoded(&design.folder), folder::REPORT);
    format!(
        "<li>{}<div><b>{name}</b>{state}<span>{title}</span>{warnings}\
         <a href=\"{link}\">its own report</a></div></li>\n",
        swatch(index)
    )
}

/// The columns that so many views stand in: four are two by two.
fn columns(views: usize) -> usize {
    match views {
        0..=3 => views.max(1),
        4 => 2,
        5 | 6 | 9 => 3,
        _ => 4,
    }
}

/// The HTML element that a design is replayed in.
fn stage(index: usize, design: &Design) -> String {
    let name = escape(&design.name);
    format!(
        "<figure class=\"stage\"><figcaption>{}<b>{name}</b></figcaption><div class=\"view\" id=\"view-{index}\" \
         data-design=\"{index}\" aria-label=\"Replay of {name}\"></div></figure>\n",
        swatch(index)
    )
}

/// A line in a design's colour and dash, as its curves are drawn.
pub(crate) fn swatch(index: usize) -> String {
    format!(
        "<svg class=\"swatch\" viewBox=\"0 0 34 10\" aria-hidden=\"true\"><line x1=\"1\" y1=\"5\" x2=\"33\" y2=\"5\" \
         style=\"stroke: var(--curve-{index})\" stroke-dasharray=\"{}\"/></svg>",
        DASHES[index % DASHES.len()]
    )
}

/// Dash patterns of the curves of successive designs, in SVG; `compare.css` has the same for the keys of figures.
const DASHES: [&str; 4] = ["none", "9 4", "3 3", "11 3 3 3"];

/// A folder's name encoded for a URL.
fn percent_encoded(name: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.' | b'~');
    name.bytes()
        .map(|byte| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_characters_of_a_folder_name_are_percent_encoded() {
        assert_eq!(percent_encoded("space_web-2.5"), "space_web-2.5");
        assert_eq!(percent_encoded("a \"b\"/µ"), "a%20%22b%22%2F%C2%B5");
    }
}
