//! Sentences of random summaries: none contradicts another or a number of the summary.

use proptest::prelude::*;
use serde_json::{Value, json};

use super::*;
use crate::format::significant;

/// A number up to 1.5 times a limit, very near to the limit, or next to nothing.
fn about(limit: f64) -> impl Strategy<Value = f64> {
    let near = (1i32..9, any::<bool>()).prop_map(move |(place, above)| {
        let off = 10f64.powi(-place);
        limit * if above { 1.0 + off } else { 1.0 - off }
    });
    let small = (0i32..25).prop_map(move |place| limit * 10f64.powi(-place));
    prop_oneof![0.0..1.5 * limit, near, small, Just(0.0), Just(limit)]
}

fn perhaps(strategy: impl Strategy<Value = f64>) -> impl Strategy<Value = Option<f64>> {
    proptest::option::weighted(0.8, strategy)
}

/// Begin and end of a spell within a second, which may be very short, and the time of all spells.
fn spell() -> impl Strategy<Value = [f64; 3]> {
    (about(0.5), about(0.4), about(0.05)).prop_map(|(from, long, more)| [from, from + long, long + more])
}

/// The sections on opening, target, posture and flight.
fn shape() -> impl Strategy<Value = Value> {
    let spells = (spell(), spell(), spell(), spell());
    (about(0.8), 1e-3..100.0, about(0.99), spells, perhaps(about(0.02)), any::<bool>(), about(1.0)).prop_map(
        |(share, flat, coverage, (open, covered, concave, hang), apex, still_up, height)| {
            let open = (share >= netcast_results::OPEN_SHARE).then_some(open);
            let covered = (coverage >= 0.99).then_some(covered);
            let of = |spell: Option<[f64; 3]>, part: usize| spell.map(|spell| spell[part]);
            json!({
                "opening": {"area_max_m2": share * flat, "area_max_time_s": 0.3, "reference_area_m2": flat,
                    "effective_from_s": of(open, 0), "effective_to_s": of(open, 1), "effective_duration_s": of(open, 2),
                    "tractor_area_max_m2": flat * coverage},
                "places": {"opening": {"travel_m": height, "ground_distance_m": height, "height_m": 0.01 - height}},
                "target": {"diameter_m": 1.5, "coverage_max": coverage.min(1.0), "coverage_max_time_s": 0.3,
                    "covered_from_s": of(covered, 0), "covered_to_s": of(covered, 1), "covered_duration_s": of(covered, 2)},
                "posture": {"concave_from_s": concave[0], "concave_to_s": concave[1]},
                "mouth": {"tilt_max_open_rad": 0.1 * coverage, "asymmetry_max_open": 0.1 * share},
                "flight": {"apex_height_m": apex, "apex_time_s": hang[0], "hang_time_s": hang[1] - hang[0],
                    "still_up": still_up, "drift_m": height, "touches_down_s": 3.0},
            })
        },
    )
}

/// The sections on tensions, points and energy.
fn loads() -> impl Strategy<Value = Value> {
    let speeds = (about(100.0), about(100.0), about(100.0));
    (about(1e4), perhaps(about(1.0)), speeds, about(3e-3), perhaps(about(0.05)), about(5.0)).prop_map(
        |(tension, used, (a, b, c), closure, web, travel)| {
            let point = |speed: f64| json!({"peak_speed_m_s": speed, "peak_speed_time_s": 0.1});
            json!({
                "tension": {"max_n": tension, "max_time_s": 0.1, "max_where": "ring", "bottom_max_n": 0.5 * tension,
                    "bottom_mean_n": 0.1 * tension, "by_rope": {"rope": {"utilisation": used}}},
                "points": {"A": point(a), "B": point(b), "C": point(c), "tractor": {"peak_travel_m": travel}},
                "energy": {"closure": closure, "tolerance": 3e-3, "closure_web": web, "tolerance_web": 0.05,
                    "initial_j": 1e3, "channels": {"air": closure - 1e-3}},
                "air": {"density_kg_m3": 1.2, "wind_m_s": [0.0, 0.0, 0.0], "wind_change_max_m_s": 0.0},
            })
        },
    )
}

fn summaries() -> impl Strategy<Value = Summary> {
    (shape(), loads()).prop_map(|(mut shape, loads)| {
        let (all, more) = (shape.as_object_mut().unwrap(), loads.as_object().unwrap().clone());
        all.extend(more);
        serde_json::from_value(shape).unwrap()
    })
}

/// The numbers of a sentence that stand before a word or mark, in order.
fn before(told: &str, unit: &str) -> Vec<f64> {
    let parts: Vec<&str> = told.split(unit).collect();
    let last = |part: &str| part.rsplit([' ', '(', '\u{a0}']).next()?.parse().ok();
    parts[..parts.len() - 1].iter().filter_map(|part| last(part)).collect()
}

fn find<'w>(words: &'w [String], part: &str) -> Option<&'w str> {
    words.iter().find(|told| told.contains(part)).map(String::as_str)
}

/// What contradicts itself or a number of the summary; none where all is well.
fn contradiction(summary: &Summary, words: &[String]) -> Option<String> {
    let wrong = |is_wrong: bool, told: &str| is_wrong.then(|| told.to_owned());
    let minus_zero = words.iter().find(|told| {
        let mut tokens = told.split_whitespace();
        tokens.any(|token| token.starts_with('-') && token.parse().is_ok_and(|number: f64| number == 0.0))
    });
    let opened = find(words, " of the flat web)").and_then(|told| before(told, " % of the flat web)").pop());
    let is_open = find(words, "t least 80 %").is_some();
    let never = find(words, "Never reaches");
    let opening = [
        opened.and_then(|opened| wrong(opened >= 80.0 && never.is_some(), "opens and never opens")),
        opened.and_then(|opened| wrong(opened < 80.0 && is_open, "is open below 80 %")),
        wrong(never.is_some() && is_open, "never and at least"),
        wrong(never.is_some() && find(words, "While it is open").is_some(), "is never open and leans"),
        wrong(find(words, "does not open").is_some() && (is_open || opened.is_some()), "does not open but opens"),
    ];
    let spells = words.iter().filter(|told| told.contains(" from ") && told.contains(" to ")).find(|told| {
        let seconds = before(told, " s");
        let [from, to, ..] = seconds[..] else { return false };
        let length = seconds.get(2).filter(|_| told.contains(", for ") && !told.contains("less than"));
        from >= to || length.is_some_and(|length| (to - from - length).abs() > 1.1e-3)
    });
    let none = words.iter().find(|told| {
        told.contains("for 0.000 s") || told.contains(" 0 N") || told.contains("e-1") && !told.contains("energy")
    });
    let worst = find(words, "worst off").and_then(|told| {
        let used = before(told, " % of its strength")[0];
        let margin: f64 =
            told.rsplit("margin ").next()?.trim_start_matches("of ").trim_end_matches([')', '.']).parse().ok()?;
        let breaks = told.contains("would break");
        wrong(breaks != (used > 100.0) || breaks != (margin < 1.0), told)
    });
    let rises = find(words, "rises to").and_then(|told| {
        let (height, when) = (before(told, " m ")[0], before(told, " s ")[0]);
        wrong(height < 0.01 || when <= 0.0, told)
    });
    let covered =
        find(words, "never wholly covered").and_then(|told| wrong(before(told, " % of it")[0] >= 100.0, told));
    let energy = words.iter().find(|told| {
        let missed = told.contains("more than is allowed");
        let web = summary.energy.closure_web.is_some_and(|web| web > summary.energy.tolerance_web);
        missed && !web && told.contains("off by 0.3 %")
    });
    let fastest = find(words, "fastest").and_then(|told| {
        let told_speed = before(told, " m/s")[0];
        let speeds = summary.points.iter().filter(|(name, _)| name.len() == 1);
        let speeds = speeds.filter_map(|(name, point)| Some((name, point.as_ref()?.peak_speed_m_s?)));
        let shown = |speed: f64| significant(speed).parse::<f64>().unwrap();
        let is_named = |name: &str| told.split([' ', ',']).any(|word| word == name);
        let mut wrongs = speeds
            .filter(|(name, speed)| shown(*speed) > told_speed || (shown(*speed) == told_speed) != is_named(name));
        wrong(wrongs.next().is_some(), told)
    });
    let single = [minus_zero, spells, none, energy].map(|told| told.cloned());
    opening.into_iter().chain(single).chain([worst, rises, covered, fastest]).flatten().next()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_sentence_contradicts_another_or_a_number(summary in summaries()) {
        let words = words(&summary);
        prop_assert_eq!(contradiction(&summary, &words), None, "{:#?}", words);
    }
}
