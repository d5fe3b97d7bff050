//! The bill of materials: the parts of a web, their masses, and the volume of the packed web.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use crate::{Class, Web};

/// Solid share of a packed web's volume: an assumption for rope laid in by hand. Parallel round rods can fill 0.91
/// (pi / sqrt(12)), rods at random much less.
pub const PACKED_FILL: f64 = 0.5;

/// A kind of rope.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeKind {
    /// Name.
    pub name: String,
    /// Diameter, m.
    pub diameter: f64,
    /// Mass per length, kg/m.
    pub mass_per_metre: f64,
}

/// A canopy or a payload as an item on the bill.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BillItem {
    /// Mass of one item, kg.
    pub mass: f64,
    /// Volume of one item, m^3; 0 where it is not known.
    pub volume: f64,
}

/// What a web's parts are made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// The kinds of rope, in the order of the bill, (kinds,).
    pub ropes: Vec<RopeKind>,
    /// The kind of each of the web's ropes, as an index into `ropes`, (ropes,).
    pub kind_of_rope: Vec<usize>,
    /// Rest length of each of the web's ropes, m, (ropes,).
    pub rest_lengths: Vec<f64>,
    /// A canopy without its payload.
    pub canopy: BillItem,
    /// A payload; some canopies carry one.
    pub payload: BillItem,
    /// Mass of each tractor, kg, (tractors,).
    pub tractor_masses: Vec<f64>,
}

/// A kind of rope on the bill.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeLine {
    /// Name.
    pub name: String,
    /// Diameter, m.
    pub diameter: f64,
    /// Total length, m.
    pub length: f64,
    /// Total mass, kg.
    pub mass: f64,
}

/// What a web is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Bill {
    /// Ropes by kind, without the kinds that are not used.
    pub ropes: Vec<RopeLine>,
    /// Length of rope in each class, m.
    pub length_by_class: BTreeMap<Class, f64>,
    /// Number of knots: places where ropes are tied, without tractors.
    pub knots: usize,
    /// Number of ropes, each from knot to knot.
    pub rope_count: usize,
    /// Number of canopies.
    pub canopies: usize,
    /// Number of payloads.
    pub payloads: usize,
    /// Number of tractors.
    pub tractors: usize,
    /// Mass of the web's ropes without the traction ropes, kg.
    pub web_rope_mass: f64,
    /// Mass of the traction ropes, kg.
    pub traction_mass: f64,
    /// Mass of the canopies, kg.
    pub canopy_mass: f64,
    /// Mass of the payloads, kg.
    pub payload_mass: f64,
    /// Mass of the tractors, kg.
    pub tractor_mass: f64,
    /// Solid volume of all ropes, m^3.
    pub rope_volume: f64,
    /// Volume of the packed web, m^3: the solid volume of ropes, canopies and payloads over [`PACKED_FILL`].
    pub packed_volume: f64,
}

impl Bill {
    /// Mass of the web without traction ropes and tractors, kg.
    pub fn web_mass(&self) -> f64 {
        self.web_rope_mass + self.canopy_mass + self.payload_mass
    }

    /// Mass of the web with traction ropes and tractors, kg.
    pub fn total_mass(&self) -> f64 {
        self.web_mass() + self.traction_mass + self.tractor_mass
    }
}

/// The bill of a web made of these parts.
///
/// # Panics
/// If an entry of `parts.kind_of_rope` is not an index into `parts.ropes`.
pub fn bill(web: &Web, parts: &Parts) -> Bill {
    let mut lines: Vec<RopeLine> = parts
        .ropes
        .iter()
        .map(|kind| RopeLine { name: kind.name.clone(), diameter: kind.diameter, length: 0.0, mass: 0.0 })
        .collect();
    let (mut web_rope_mass, mut traction_mass, mut rope_volume) = (0.0, 0.0, 0.0);
    let mut is_tied = vec![false; web.knots.len()];
    let mut length_by_class = BTreeMap::new();
    for ((rope, &kind), &length) in web.ropes.iter().zip(&parts.kind_of_rope).zip(&parts.rest_lengths) {
        *length_by_class.entry(rope.class.clone()).or_insert(0.0) += length;
        let RopeKind { diameter, mass_per_metre, .. } = parts.ropes[kind];
        lines[kind].length += length;
        lines[kind].mass += mass_per_metre * length;
        rope_volume += PI / 4.0 * diameter * diameter * length;
        let mass = if rope.class == Class::Traction { &mut traction_mass } else { &mut web_rope_mass };
        *mass += mass_per_metre * length;
        is_tied[rope.a] = true;
        is_tied[rope.b] = true;
    }
    lines.retain(|line| line.length > 0.0);
    if !web.traction.is_empty() {
        for &tractor in &web.tractors {
            is_tied[tractor] = false;
        }
    }

    let canopies = web.canopies.len();
    let payloads = web.canopies.iter().filter(|canopy| canopy.carries_payload).count();
    let solid_volume = rope_volume + canopies as f64 * parts.canopy.volume + payloads as f64 * parts.payload.volume;
    Bill {
        ropes: lines,
        length_by_class,
        knots: is_tied.iter().filter(|&&tied| tied).count(),
        rope_count: web.ropes.len(),
        canopies,
        payloads,
        tractors: web.tractors.len(),
        web_rope_mass,
        traction_mass,
        canopy_mass: canopies as f64 * parts.canopy.mass,
        payload_mass: payloads as f64 * parts.payload.mass,
        tractor_mass: parts.tractor_masses.iter().sum(),
        rope_volume,
        packed_volume: solid_volume / PACKED_FILL,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{space, square, topological, traditional};

    /// A rope of 10 mm diameter and 1850 kg/m^3.
    fn rope() -> RopeKind {
        RopeKind { name: "10 mm".into(), diameter: 0.01, mass_per_metre: PI / 4.0 * 1e-4 * 1850.0 }
    }

    /// The parts of a web with one kind of rope; canopies, payloads and tractors have no mass.
    fn of_one_rope(web: &Web) -> Parts {
        Parts {
            ropes: vec![rope()],
            kind_of_rope: vec![0; web.ropes.len()],
            rest_lengths: web.ropes.iter().map(|rope| web.rest_length(rope)).collect(),
            canopy: BillItem::default(),
            payload: BillItem::default(),
            tractor_masses: Vec::new(),
        }
    }

    #[test]
    fn the_three_webs_have_masses_of_13_74_and_19_89_and_56_77_kg() {
        for (name, web, expected) in [
            ("traditional", traditional(2.5, 6).unwrap(), 13.74),
            ("topological", topological(2.5, 0.14).unwrap(), 19.89),
            ("space", space(2.5, 0.14).unwrap(), 56.77),
        ] {
            let web = web.with_traction(1.0355, 1).unwrap();
            let mut parts = of_one_rope(&web);
            parts.canopy.mass = 1.018;
            parts.payload.mass = 0.506;
            parts.tractor_masses = vec![27.80; 6];
            let bill = bill(&web, &parts);
            assert!((bill.web_mass() - expected).abs() < 0.006, "{name}: {}", bill.web_mass());
            let others = 6.0 * (27.80 + 0.1453 * 1.0355);
            assert!((bill.total_mass() - bill.web_mass() - others).abs() < 1e-3);
        }
    }

    #[test]
    fn the_space_web_has_31_canopies_and_18_payloads() {
        let web = space(2.5, 0.14).unwrap();
        let bill = bill(&web, &of_one_rope(&web));
        assert_eq!((bill.canopies, bill.payloads, bill.rope_count), (31, 18, 180));
        // a canopy on the outline has four neighbours: ropes are tied to five of its corners, the outer one is bare
        assert_eq!(bill.knots, 19 * 6 + 12 * 5 + 6);
    }

    #[test]
    fn each_kind_of_rope_is_billed_on_its_own_line() {
        let web = square(2.0, 1.0).unwrap();
        let mut parts = of_one_rope(&web);
        parts.ropes.push(RopeKind { name: "thin".into(), diameter: 0.002, mass_per_metre: 0.005 });
        for (kind, rope) in parts.kind_of_rope.iter_mut().zip(&web.ropes) {
            *kind = usize::from(rope.class == Class::Inner);
        }
        let bill = bill(&web, &parts);
        let metres: Vec<(&str, f64)> = bill.ropes.iter().map(|line| (line.name.as_str(), line.length)).collect();
        assert_eq!(metres, [("10 mm", 8.0), ("thin", 4.0)]);
        assert!((bill.ropes[1].mass - 0.02).abs() < 1e-12);
        let volume = PI / 4.0 * (8.0 * 1e-4 + 4.0 * 4e-6);
        assert!((bill.rope_volume - volume).abs() < 1e-15);
        assert!((bill.packed_volume - 2.0 * volume).abs() < 1e-15);
        assert_eq!((bill.knots, bill.rope_count), (9, 12));
    }
}
