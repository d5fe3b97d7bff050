//! The part of `netcast check` about materials.

use netcast::facts::{BillFacts, FromLibrary, LawFacts, LawKind, LinkFacts};

use crate::screen::{number, rows, say};

/// Prints the bill of materials.
pub fn bill(bill: &BillFacts) {
    say!("Bill of materials");
    let mut lines = Vec::new();
    for rope in &bill.ropes {
        lines.push((
            format!("{} {} mm", rope.name, number(1e3 * rope.diameter_m, 3)),
            format!("{} m, {} kg", number(rope.length_m, 5), number(rope.mass_kg, 4)),
        ));
    }
    for class in &bill.classes {
        lines.push((format!("  of which {}", class.class), format!("{} m", number(class.length_m, 5))));
    }
    lines.push(("knots, ropes".into(), format!("{}, {}", bill.knots, bill.rope_count)));
    let counted = [("canopies", bill.canopies), ("payloads", bill.payloads), ("tractors", bill.tractors)];
    for (name, counted) in counted.into_iter().filter(|(_, counted)| counted.count > 0) {
        lines.push((name.into(), format!("{}, {} kg", counted.count, number(counted.mass_kg, 4))));
    }
    lines.push(("web without traction ropes".into(), format!("{} kg", number(bill.web_mass_kg, 4))));
    lines.push(("total thrown mass".into(), format!("{} kg", number(bill.thrown_mass_kg, 4))));
    let litres = number(1e3 * bill.packed_volume_m3, 3);
    let solid = number(100.0 * bill.packed_fill, 2);
    lines.push(("packed volume".into(), format!("{litres} litres, {solid} % of it solid")));
    if let Some(area) = bill.area_m2 {
        lines.push(("area inside the outline".into(), format!("{} m^2 flat", number(area, 5))));
    }
    if let Some(area) = bill.tractor_area_m2 {
        lines.push(("area of the tractors' polygon".into(), format!("{} m^2 flat", number(area, 5))));
    }
    rows(&lines);
}

/// Prints the law of each rope and its breaking load and strain.
pub fn laws(laws: &[LawFacts]) {
    say!("Laws of ropes");
    let mut lines: Vec<(String, String)> = Vec::new();
    for law in laws {
        let load = law.breaking_load_n.map(|load| match law.breaking_load_at_knots_n {
            Some(at_knots) => format!("{} N, at knots {} N", number(load, 4), number(at_knots, 4)),
            None => format!("{} N", number(load, 4)),
        });
        let strain = law.breaking_strain.map(|strain| format!("{} % strain", number(100.0 * strain, 4)));
        let limits: Vec<String> = [load, strain].into_iter().flatten().collect();
        let breaks =
            if limits.is_empty() { "never breaks".into() } else { format!("breaks at {}", limits.join(" or ")) };
        let line = (law.rope.clone(), format!("{}; {breaks}", in_words(&law.law)));
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    rows(&lines);
}

/// A law in words.
fn in_words(law: &LawKind) -> String {
    let times = |ratio: f64| format!("{} times the modulus", number(ratio, 4));
    match *law {
        LawKind::Linear => "linear".into(),
        LawKind::Bilinear { strain, second_modulus_ratio } => {
            format!("bilinear, {} beyond {} % strain", times(second_modulus_ratio), number(100.0 * strain, 4))
        }
        LawKind::Table { has_hysteresis: true } => "from a table, with hysteresis".into(),
        LawKind::Table { has_hysteresis: false } => "from a table".into(),
        LawKind::Viscoelastic { instantaneous_ratio, relaxation_time_s } => {
            let ms = number(1e3 * relaxation_time_s, 4);
            format!("viscoelastic, {} at once, relaxing in {ms} ms", times(instantaneous_ratio))
        }
        LawKind::Strut => "a strut: pulls and pushes".into(),
    }
}

/// Prints the links by the names that `[assign]` accepts.
pub fn links(links: &[LinkFacts]) {
    say!("Links");
    let described = links.iter().map(|link| {
        let ring = link.ring.map_or(String::new(), |ring| format!(", ring {ring}"));
        (link.name.clone(), format!("{}{ring}, of {}, {} m", link.class, link.rope, number(link.length_m, 4)))
    });
    rows(&described.collect::<Vec<_>>());
}

/// Prints the values that come from the library, with their sources.
pub fn from_library(library: &FromLibrary) {
    say!("From the library of materials");
    let mut lines: Vec<(String, String)> = Vec::new();
    for one in &library.values {
        let summary = (one.table.clone(), format!("{}: {}", one.material, one.summary));
        if !lines.contains(&summary) {
            lines.push(summary);
        }
        lines.push((format!("  {}", one.key), format!("{} ({})", one.value, one.sources.join(", "))));
    }
    lines.extend(library.sources.iter().map(|(name, source)| (format!("source {name}"), source.clone())));
    rows(&lines);
}
