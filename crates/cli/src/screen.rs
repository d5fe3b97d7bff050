//! Text output of the commands: rows of names and values.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write};

use netcast::facts::{PackingFacts, StartFacts};
use netcast::results::visible;

/// Prints a line for the user, as `println!` does. A closed pipe, such as after `head`, is not an error.
macro_rules! say {
    ($($told:tt)*) => { $crate::screen::print_line(format_args!($($told)*)) };
}
pub(crate) use say;

/// Prints a line to standard output, with symbols for control characters in it. A closed pipe is ignored; any other failure ends the program.
pub fn print_line(line: Arguments) {
    if let Err(error) = writeln!(std::io::stdout(), "{}", visible(&line.to_string()))
        && error.kind() != ErrorKind::BrokenPipe
    {
        eprintln!("error: cannot write to standard output: {error}");
        std::process::exit(1);
    }
}

/// Prints rows of a name and a value. The names form a column.
pub fn rows(rows: &[(String, String)]) {
    let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, value) in rows {
        say!("  {name:width$}  {value}");
    }
}

/// A number with `digits` significant digits. It has an exponent below 1e-4 and from 1e7 on.
pub fn number(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&magnitude) {
        return format!("{value:.*e}", digits.saturating_sub(1));
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    format!("{value:.decimals$}")
}

/// A time of waiting in words, to two digits: `0.079 s`, `12 min`, `3.7 days`.
pub fn wait(seconds: f64) -> String {
    const UNITS: [(f64, &str); 4] = [(365.25 * 86400.0, "years"), (86400.0, "days"), (3600.0, "h"), (60.0, "min")];
    // from two of a unit on
    let (unit, name) = UNITS.into_iter().find(|(unit, _)| seconds >= 2.0 * unit).unwrap_or((1.0, "s"));
    format!("{} {name}", number(seconds / unit, 2))
}

/// A run that takes longer than this, s, is warned of.
pub const LONG_WAIT_S: f64 = 3600.0;

/// What is said of a run that takes so long, s; none of a short one.
pub fn long_wait(seconds: f64) -> Option<String> {
    (seconds > LONG_WAIT_S).then(|| {
        format!(
            "this run takes about {} on one core of this machine; `netcast check` says what bounds its step",
            wait(seconds)
        )
    })
}

/// Prints the longest stretch, the stored energy and the packed size at the start.
pub fn start(start: &StartFacts) {
    let stretch = start.longest_stretch.zip(start.longest_stretch_where.as_ref()).map(|(stretch, label)| {
        let share = 100.0 * stretch;
        if share > 1e-7 {
            format!("{label} is stretched by {} %", number(share, 3))
        } else if share > -1e-7 {
            format!("none; {label} just reaches its rest length")
        } else {
            format!("none; {label} comes nearest, {} % short of its rest length", number(-share, 3))
        }
    });
    let (radius, height) = (number(start.packed_radius_m, 4), number(start.packed_height_m, 4));
    say!("State at the start");
    rows(&[
        ("longest stretch".into(), stretch.unwrap_or_else(|| "there are no segments".into())),
        ("stored energy".into(), format!("{} J", number(start.stored_energy_j, 4))),
        ("packed size".into(), format!("radius {radius} m, height {height} m")),
    ]);
}

/// Prints the density of the packed web and the smallest distance between its ropes.
pub fn packing(packing: &PackingFacts) {
    let density = packing
        .density_kg_m3
        .zip(packing.solid_fraction)
        .map(|(density, solid)| format!("{} kg/m^3, {} % of it solid", number(density, 4), number(100.0 * solid, 3)));
    let closest = match &packing.closest {
        _ if !packing.is_compared => "not computed: too many ropes lie near each other".to_owned(),
        None => "all ropes are tied together".to_owned(),
        Some(closest) => format!("{} m, {}", number(closest.distance_m, 3), closest.segments.join(" and ")),
    };
    let touching =
        packing.nearer_than_a_diameter.map(|count| format!("{count} pairs of segments, of ropes that share no knot"));
    let told = [
        ("density", density.or(Some("the web lies flat".to_owned()))),
        ("closest approach", Some(closest)),
        ("nearer than a diameter", touching),
    ];
    say!("Packing");
    let told = told.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
    rows(&told.collect::<Vec<_>>());
}

/// Prints the notes: values that netcast chose or changed for the user.
pub fn notes(notes: &[String]) {
    for note in notes {
        say!("note: {note}");
    }
}
