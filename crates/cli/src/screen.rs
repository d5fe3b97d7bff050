//! What commands print for people: columns of names and values.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write};

use netcast::Model;

/// Prints a line for the user, as `println!` does. A reader that has gone, such as `head`, is no error.
macro_rules! say {
    ($($told:tt)*) => { $crate::screen::print_line(format_args!($($told)*)) };
}
pub(crate) use say;

/// Prints a line to standard output; ends the program where it cannot be written, unless that is because nobody reads.
pub fn print_line(line: Arguments) {
    if let Err(error) = writeln!(std::io::stdout(), "{line}")
        && error.kind() != ErrorKind::BrokenPipe
    {
        eprintln!("error: cannot write to standard output: {error}");
        std::process::exit(1);
    }
}

/// Prints rows of a name and a value, names in one column.
pub fn rows(rows: &[(String, String)]) {
    let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, value) in rows {
        say!("  {name:width$}  {value}");
    }
}

/// A number with `digits` significant digits, without an exponent where it is readable without.
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

/// The audit of the state at the start.
pub fn audit(model: &Model) {
    let audit = &model.audit;
    let stretch = audit.longest.map(|longest| {
        let label = model.segment_label(longest.segment);
        let share = 100.0 * longest.stretch;
        match share {
            s if s > 1e-7 => format!("{label} is stretched by {} %", number(s, 3)),
            s if s > -1e-7 => format!("none; {label} just reaches its rest length"),
            s => format!("none; {label} comes nearest, {} % short of its rest length", number(-s, 3)),
        }
    });
    say!("State at the start");
    rows(&[
        ("longest stretch".into(), stretch.unwrap_or_else(|| "there are no segments".into())),
        ("stored energy".into(), format!("{} J", number(audit.stored_energy, 4))),
        (
            "packed size".into(),
            format!("radius {} m, height {} m", number(audit.packed_radius, 4), number(audit.packed_height, 4)),
        ),
    ]);
}

/// How densely the web is packed, and how near its ropes come to each other.
pub fn packing(model: &Model) {
    let packing = model.packing();
    let density = packing
        .density
        .zip(packing.solid_fraction)
        .map(|(density, solid)| format!("{} kg/m^3, {} % of it solid", number(density, 4), number(100.0 * solid, 3)));
    let (closest, touching) = match packing.closeness {
        None => ("not looked for: too many ropes lie near each other".to_owned(), None),
        Some(found) => (
            found.closest.map_or("all ropes are tied together".to_owned(), |closest| {
                let labels = closest.segments.map(|segment| model.segment_label(segment)).join(" and ");
                format!("{} m, {labels}", number(closest.distance, 3))
            }),
            Some(format!("{} pairs of segments, of ropes that share no knot", found.touching)),
        ),
    };
    let told = [
        ("density", density.or(Some("the web lies flat".to_owned()))),
        ("closest approach", Some(closest)),
        ("nearer than a diameter", touching),
    ];
    say!("How it is packed");
    let told = told.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
    rows(&told.collect::<Vec<_>>());
}

/// What was chosen or changed for the user.
pub fn notes(model: &Model) {
    for note in &model.notes {
        say!("note: {note}");
    }
}
