//! The handful of numbers that a designer looks for first, at the head of the page.

use netcast_results::{OPEN_SHARE, Summary};

use crate::format::{against, escape, is_seen, metres, percent, share_of_flat, significant, time, with_prefix};
use crate::pictures::SLACK_BELOW;
use crate::words::{is_equilibrium, worst};

/// A number at the head of the page.
struct Tile {
    name: String,
    value: String,
    detail: String,
}

/// The tiles as HTML.
pub(crate) fn tiles(summary: &Summary) -> String {
    let told: [fn(&Summary) -> Option<Tile>; 8] = [area, open_time, place, tension, margin, tractors, balance, energy];
    let tile = |Tile { name, value, detail }: Tile| {
        let (value, detail) = (escape(&value), escape(&detail));
        format!("<div><dt>{name}</dt><dd>{value}<small>{detail}</small></dd></div>\n")
    };
    told.iter().filter_map(|told| told(summary)).map(tile).collect()
}

fn tile(name: &str, value: String, detail: Option<String>) -> Option<Tile> {
    Some(Tile { name: name.to_owned(), value, detail: detail.unwrap_or_default() })
}

/// The largest area over that of the flat web.
fn share(summary: &Summary) -> Option<f64> {
    let flat = summary.opening.reference_area_m2.filter(|flat| *flat > 0.0)?;
    Some(summary.opening.area_max_m2? / flat)
}

fn area(summary: &Summary) -> Option<Tile> {
    let name = if is_equilibrium(summary) { "area" } else { "largest area" };
    let area = summary.opening.area_max_m2?;
    let area = if area < 1e-4 { "0".into() } else { significant(area) };
    tile(name, format!("{area} m²"), share(summary).map(|share| format!("{} of flat", share_of_flat(share))))
}

fn open_time(summary: &Summary) -> Option<Tile> {
    let (opening, open) = (&summary.opening, percent(OPEN_SHARE));
    if is_equilibrium(summary) {
        return None;
    }
    match (opening.effective_from_s, opening.effective_duration_s) {
        (Some(from), Some(total)) => {
            tile(&format!("{open} open for"), time(total), Some(format!("from {}", time(from))))
        }
        _ if share(summary).is_some_and(|share| share < OPEN_SHARE) => {
            tile(&format!("{open} open"), "never".into(), None)
        }
        _ => None,
    }
}

/// Where the web is when it has opened.
fn place(summary: &Summary) -> Option<Tile> {
    let place = &summary.places.opening;
    let travel = place.travel_m.filter(|_| !is_equilibrium(summary) && summary.opening.effective_from_s.is_some())?;
    // none is told of a web that goes straight up
    let ground = place.ground_distance_m.filter(|distance| is_seen(*distance));
    let ground = ground.map(|distance| format!("{} over the ground", metres(distance)));
    let height = place.height_m.map(|height| {
        let side = if height < 0.0 && is_seen(height) { "below" } else { "above" };
        format!("{} {side} the muzzle", metres(height.abs()))
    });
    let told: Vec<String> = ["along the axis".to_owned()].into_iter().chain(ground).chain(height).collect();
    tile(&format!("{} open after", percent(OPEN_SHARE)), metres(travel), Some(told.join(", ")))
}

fn tension(summary: &Summary) -> Option<Tile> {
    let tension = &summary.tension;
    let max = Some(tension.max_n).filter(|max| max.is_finite())?;
    if max < SLACK_BELOW {
        return tile("highest tension", "0 N".into(), Some("all ropes are slack".into()));
    }
    let rope = tension.max_where.as_ref().map(|class| format!("{class} rope"));
    tile("highest tension", with_prefix(max, "N"), rope)
}

/// Strength over largest tension of the rope that comes nearest to breaking.
fn margin(summary: &Summary) -> Option<Tile> {
    let worst = worst(summary)?;
    tile("margin", worst.margin(), Some(format!("strength over tension, {}", worst.called())))
}

fn tractors(summary: &Summary) -> Option<Tile> {
    let tractor = summary.points.get("tractor").and_then(Option::as_ref)?;
    let travel = tractor.peak_travel_m.filter(|_| !is_equilibrium(summary))?;
    tile("tractors travel", metres(travel), None)
}

fn balance(summary: &Summary) -> Option<Tile> {
    let found = summary.statics.as_ref()?;
    let allowed = format!("{:.1e} allowed", found.tolerance);
    tile("forces balance to", format!("{:.1e}", found.residual_relative?), Some(allowed))
}

fn energy(summary: &Summary) -> Option<Tile> {
    let energy = &summary.energy;
    let closure = Some(energy.closure).filter(|closure| closure.is_finite() && !is_equilibrium(summary))?;
    let allowed = Some(energy.tolerance).filter(|tolerance| tolerance.is_finite());
    tile(
        "energy closes to",
        against(closure, energy.tolerance),
        allowed.map(|allowed| format!("{} allowed", percent(allowed))),
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn margin_and_place_of_opening_are_among_the_headline_figures() {
        let summary = serde_json::from_value(json!({
            "opening": {"area_max_m2": 15.0, "reference_area_m2": 16.0, "effective_from_s": 0.1, "effective_duration_s": 0.2},
            "places": {"opening": {"travel_m": 4.21, "ground_distance_m": 4.0, "height_m": -1.2}},
            "tension": {"max_n": 5e3, "by_rope": {"border": {"utilisation": 0.5}, "rope": {"utilisation": 0.1}}},
        }));
        let html = tiles(&summary.unwrap());
        assert!(html.contains("<dt>margin</dt><dd>2.00<small>strength over tension, rope border</small>"), "{html}");
        assert!(
            html.contains("<dd>4.21 m<small>along the axis, 4.00 m over the ground, 1.20 m below the muzzle</small>"),
            "{html}"
        );
    }

    #[test]
    fn a_web_that_never_opens_has_no_time_and_no_place_of_opening() {
        let opening = json!({"area_max_m2": 7.999, "reference_area_m2": 10.0, "effective_duration_s": 0.0});
        let html = tiles(&serde_json::from_value(json!({ "opening": opening })).unwrap());
        assert!(
            html.contains("<dd>never<") && html.contains("79.99 % of flat") && !html.contains("open after"),
            "{html}"
        );
    }
}
