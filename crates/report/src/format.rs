//! Numbers as text: three significant digits, and units with a fitting prefix.

use netcast_results::{OPEN_SHARE, visible};

/// Three significant digits: `15.8`, `0.0123`, `51000`, and `1.20e-9` below 1e-4.
pub(crate) fn significant(value: f64) -> String {
    significant_to(value, 0)
}

/// As [`significant`], with `more` digits.
pub(crate) fn significant_to(value: f64, more: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { value.to_string() };
    }
    // round before taking the exponent: 9.996 becomes 10.0, not 10.00
    let rounded = format!("{value:.*e}", 2 + more);
    let exponent: i32 = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    if exponent < -4 {
        return rounded;
    }
    let rounded: f64 = rounded.parse().unwrap_or(value);
    let decimals = (2 + more as i32 - exponent).max(0) as usize;
    format!("{rounded:.decimals$}")
}

/// A number with fixed decimals; what rounds to zero has no sign.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}

/// A number that is above or below a limit, with as many more digits as tell it from the limit. `write` takes a number and
/// how many more digits it has.
pub(crate) fn beside(value: f64, limit: f64, write: fn(f64, usize) -> String) -> String {
    const MOST: usize = 13;
    let apart = (0..=MOST).find(|&more| write(value, more) != write(limit, more));
    write(value, apart.unwrap_or(0))
}

/// A share that must not exceed a limit: one that does never reads like the limit.
pub(crate) fn against(share: f64, limit: f64) -> String {
    if share > limit { beside(share, limit, percent_to) } else { percent(share) }
}

/// The share of the flat web's area that an area is; a share below [`OPEN_SHARE`] never reads like it.
pub(crate) fn share_of_flat(share: f64) -> String {
    if share < OPEN_SHARE { beside(share, OPEN_SHARE, percent_to) } else { percent(share) }
}

/// A length in metres; what is shorter than half a millimetre is `0 m`.
pub(crate) fn metres(length: f64) -> String {
    if is_seen(length) { format!("{} m", significant(length)) } else { "0 m".into() }
}

/// Whether a length, m, is told: half a millimetre of a flight is none.
pub(crate) fn is_seen(length: f64) -> bool {
    length.abs() >= 5e-4
}

/// A time to the millisecond: `0.131 s`.
pub(crate) fn time(seconds: f64) -> String {
    format!("{} s", fixed(seconds, 3))
}

/// A duration from nanoseconds to minutes: `1.27 µs`, `11.3 s`, `2 min 5 s`.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        // round first, or 119.6 s is 1 min 60 s
        s if s >= 59.95 => format!("{:.0} min {:.0} s", (s.round() / 60.0).floor(), s.round() % 60.0),
        s if s >= 1.0 || s == 0.0 => format!("{} s", significant(s)),
        s if s >= 1e-3 => format!("{} ms", significant(s * 1e3)),
        s if s >= 1e-6 => format!("{} µs", significant(s * 1e6)),
        s => format!("{} ns", significant(s * 1e9)),
    }
}

/// A ratio as percent, to two significant digits below ten: `97 %`, `0.05 %`.
pub(crate) fn percent(ratio: f64) -> String {
    percent_to(ratio, 0)
}

/// As [`percent`], with `more` digits.
pub(crate) fn percent_to(ratio: f64, more: usize) -> String {
    // no sign of a zero
    let percent = if ratio == 0.0 { 0.0 } else { 100.0 * ratio };
    let rounded = format!("{percent:.*e}", 1 + more);
    let exponent: i32 = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    if exponent >= 1 {
        return format!("{percent:.more$} %");
    }
    if exponent < -4 {
        return format!("{rounded} %");
    }
    // parsing drops trailing zeros
    format!("{} %", rounded.parse().unwrap_or(percent))
}

/// A unit with the prefix that suits the largest of a set of numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    /// Divisor from the base unit to this unit.
    pub divisor: f64,
    /// The unit with its prefix.
    pub unit: String,
}

impl Scale {
    /// The prefix for values up to `largest` in `base` units: k from a thousand, M from a million.
    pub(crate) fn fitting(largest: f64, base: &str) -> Self {
        let (divisor, prefix) = match largest.abs() {
            size if size >= 1e6 => (1e6, "M"),
            size if size >= 1e3 => (1e3, "k"),
            _ => (1.0, ""),
        };
        Self { divisor, unit: format!("{prefix}{base}") }
    }
}

/// A number with its unit and a fitting prefix: `51.0 kN`.
pub(crate) fn with_prefix(value: f64, base: &str) -> String {
    let scale = Scale::fitting(value, base);
    format!("{} {}", significant(value / scale.divisor), scale.unit)
}

/// A count with thin spaces between the thousands.
pub(crate) fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// Text escaped for HTML, within an element or a quoted attribute, with symbols for control characters.
pub(crate) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in visible(text).chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

/// A text of messages as HTML: escaped, with what stands between backquotes as code.
pub(crate) fn prose(text: &str) -> String {
    let escaped = escape(text);
    let mut parts: Vec<&str> = escaped.split('`').collect();
    // an odd backquote stands for itself
    let odd = if parts.len().is_multiple_of(2) { parts.pop() } else { None };
    let told = parts.iter().enumerate().map(|(place, part)| match place % 2 {
        1 => format!("<code>{part}</code>"),
        _ => (*part).to_owned(),
    });
    told.collect::<String>() + &odd.map(|rest| format!("`{rest}")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_any_size_have_three_significant_digits() {
        let cases = [
            (15.8321, "15.8"),
            (9.996, "10.0"),
            (0.012345, "0.0123"),
            (-112.44, "-112"),
            (51234.0, "51200"),
            (0.0, "0"),
            (99.97, "100"),
            (1.2e-9, "1.20e-9"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value), text);
        }
    }

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1\u{202f}000", "1\u{202f}234\u{202f}567"]);
    }

    #[test]
    fn units_fit_their_numbers() {
        assert_eq!(with_prefix(51_000.0, "N"), "51.0 kN");
        assert_eq!(with_prefix(-2.5e6, "J"), "-2.50 MJ");
        assert_eq!(with_prefix(12.0, "N"), "12.0 N");
        assert_eq!(duration(1.27e-6), "1.27 µs");
        assert_eq!([125.0, 119.6, 59.97].map(duration), ["2 min 5 s", "2 min 0 s", "1 min 0 s"]);
        assert_eq!(time(0.1314), "0.131 s");
        assert_eq!(percent(0.9731), "97 %");
        assert_eq!(percent(0.0005), "0.05 %");
        assert_eq!(percent(0.0314), "3.1 %");
        assert_eq!(percent(0.0999), "10 %");
        assert_eq!(percent(-3e-9), "-3.0e-7 %");
        assert_eq!(percent(0.0), "0 %");
    }

    #[test]
    fn what_rounds_to_zero_has_no_sign() {
        assert_eq!(
            [fixed(-0.001, 2), fixed(-0.0, 2), fixed(-0.006, 2), time(-1e-9)],
            ["0.00", "0.00", "-0.01", "0.000 s"]
        );
        assert_eq!([percent(-0.0), metres(-1e-5), metres(-0.5)], ["0 %", "0 m", "-0.500 m"]);
    }

    #[test]
    fn a_number_reads_unlike_the_limit_that_it_misses() {
        assert_eq!(share_of_flat(0.799), "79.9 %");
        assert_eq!([0.79999, 0.8, 0.8001, 0.5].map(share_of_flat), ["79.999 %", "80 %", "80 %", "50 %"]);
        assert_eq!(beside(0.0030004, 0.003, percent_to), "0.30004 %");
        assert_eq!(beside(0.9999, 1.0, significant_to), "0.9999");
        assert_eq!(beside(1.0, 1.0, significant_to), "1.00");
    }

    #[test]
    fn backquotes_become_code() {
        assert_eq!(prose("set `a<b` now"), "set <code>a&lt;b</code> now");
        assert_eq!(prose("a ` b"), "a ` b");
        assert_eq!(prose("`x` and ` y"), "<code>x</code> and ` y");
        assert_eq!(prose(""), "");
    }
}
