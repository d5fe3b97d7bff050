//! The materials of a case: bill of materials, laws of ropes, and values from the library.

use std::collections::BTreeMap;

use netcast_dynamics::forces::bilinear::Bilinear;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::viscoelastic::Viscoelastic;
use netcast_model::Model;
use netcast_scenario::Document;
use netcast_scenario::library::library;
use netcast_webs::PACKED_FILL;
use serde::Serialize;

use crate::case::Case;

/// The bill of materials.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BillFacts {
    /// The kinds of rope in use.
    pub ropes: Vec<RopeFacts>,
    /// Length of rope of each link class, traction first.
    pub classes: Vec<ClassLength>,
    /// Number of knots, without those at tractors.
    pub knots: usize,
    /// Number of ropes from knot to knot.
    pub rope_count: usize,
    /// Number and mass of canopies.
    pub canopies: Counted,
    /// Number and mass of payloads and the sensor.
    pub payloads: Counted,
    /// Number and mass of tractors.
    pub tractors: Counted,
    /// Mass of the web without traction ropes and tractors, kg.
    pub web_mass_kg: f64,
    /// Mass of all that is thrown, kg.
    pub thrown_mass_kg: f64,
    /// Volume of the packed ropes, canopies and payloads, with the gaps between them, m^3.
    pub packed_volume_m3: f64,
    /// Solid share of the packed volume.
    pub packed_fill: f64,
    /// Area inside the outline of the flat web, m^2; none where it has no outline.
    pub area_m2: Option<f64>,
    /// Area of the tractors' polygon of the flat web, m^2; none where there are too few tractors.
    pub tractor_area_m2: Option<f64>,
}

/// The rope of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RopeFacts {
    /// Its name in the scenario.
    pub name: String,
    /// Its diameter, m.
    pub diameter_m: f64,
    /// Total length, m.
    pub length_m: f64,
    /// Total mass, kg.
    pub mass_kg: f64,
}

/// The rope of one link class.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClassLength {
    /// The class.
    pub class: String,
    /// Total length, m.
    pub length_m: f64,
}

/// Number and mass of parts of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Counted {
    /// Number of parts.
    pub count: usize,
    /// Total mass, kg.
    pub mass_kg: f64,
}

/// The law of a rope's tension, and the load and strain at which it breaks.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LawFacts {
    /// The rope's name in the scenario.
    pub rope: String,
    /// The law.
    pub law: LawKind,
    /// Load at which it breaks away from knots, N; none where no load breaks it.
    pub breaking_load_n: Option<f64>,
    /// Load at which it breaks at knots, N; none where knots do not weaken it, or no load breaks it.
    pub breaking_load_at_knots_n: Option<f64>,
    /// Strain at which it breaks; none where no strain breaks it.
    pub breaking_strain: Option<f64>,
}

/// The law by which tension follows from stretch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LawKind {
    /// Proportional to stretch.
    Linear,
    /// Two straight lines.
    Bilinear {
        /// Strain at which they meet.
        strain: f64,
        /// Modulus above this strain over the modulus below.
        second_modulus_ratio: f64,
    },
    /// A table.
    Table {
        /// Whether unloading follows another curve.
        has_hysteresis: bool,
    },
    /// A standard linear solid: a spring beside a relaxing branch.
    Viscoelastic {
        /// Instantaneous modulus over the modulus after a long time.
        instantaneous_ratio: f64,
        /// Relaxation time of the branch, s.
        relaxation_time_s: f64,
    },
    /// Proportional to stretch, in compression too.
    Strut,
}

/// A rope from knot to knot, with the name that `[assign]` knows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LinkFacts {
    /// Its name.
    pub name: String,
    /// Its link class.
    pub class: String,
    /// The number of its ring, from 1 in the middle; none where it is not of class `ring`.
    pub ring: Option<usize>,
    /// The name of its rope, `rope` for the default one.
    pub rope: String,
    /// Its rest length as drawn, m.
    pub length_m: f64,
}

/// The values of a scenario from the library of materials.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FromLibrary {
    /// The values, in the order of the scenario.
    pub values: Vec<LibraryValue>,
    /// The sources by their short names.
    pub sources: BTreeMap<String, String>,
}

/// A value from the library of materials.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LibraryValue {
    /// Its table in the scenario, such as `ropes.border`.
    pub table: String,
    /// The material's name.
    pub material: String,
    /// The description of the material.
    pub summary: String,
    /// The value's key.
    pub key: String,
    /// The value with its unit, as in a scenario.
    pub value: String,
    /// Short names of its sources.
    pub sources: Vec<String>,
}

impl Case {
    /// The links of the web with the names that `[assign]` knows, in the order of the web.
    pub fn links(&self) -> Vec<LinkFacts> {
        let links = self.model().links().into_iter();
        links
            .map(|link| LinkFacts {
                name: link.name,
                class: link.class.to_string(),
                ring: link.ring,
                rope: link.rope,
                length_m: link.length,
            })
            .collect()
    }
}

pub(super) fn bill(model: &Model) -> BillFacts {
    let bill = &model.bill;
    let rope = |rope: &netcast_webs::RopeLine| RopeFacts {
        name: rope.name.clone(),
        diameter_m: rope.diameter,
        length_m: rope.length,
        mass_kg: rope.mass,
    };
    let class = |(class, &length_m): (&netcast_webs::Class, &f64)| ClassLength { class: class.to_string(), length_m };
    BillFacts {
        ropes: bill.ropes.iter().map(rope).collect(),
        classes: bill.length_by_class.iter().map(class).collect(),
        knots: bill.knots,
        rope_count: bill.rope_count,
        canopies: Counted { count: bill.canopies, mass_kg: bill.canopy_mass },
        payloads: Counted { count: bill.payloads, mass_kg: bill.payload_mass },
        tractors: Counted { count: bill.tractors, mass_kg: bill.tractor_mass },
        web_mass_kg: bill.web_mass(),
        thrown_mass_kg: model.mass,
        packed_volume_m3: bill.packed_volume,
        packed_fill: PACKED_FILL,
        area_m2: model.cut.web.reference_area(),
        tractor_area_m2: model.cut.web.tractor_area(),
    }
}

/// The laws of the ropes, without repetition.
pub(super) fn laws(model: &Model) -> Vec<LawFacts> {
    let mut laws: Vec<LawFacts> = Vec::new();
    for group in &model.groups {
        let Some(rope) = &group.rope else { continue };
        let reduction = group.knot_reduction.unwrap_or(0.0);
        let load = Some(group.breaking.load).filter(|load| load.is_finite());
        let law = LawFacts {
            rope: rope.clone(),
            law: kind(&group.law),
            breaking_load_n: load,
            breaking_load_at_knots_n: load.filter(|_| reduction > 0.0).map(|load| (1.0 - reduction) * load),
            breaking_strain: Some(group.breaking.strain).filter(|strain| strain.is_finite()),
        };
        if !laws.contains(&law) {
            laws.push(law);
        }
    }
    laws
}

fn kind(law: &Law) -> LawKind {
    match law {
        Law::Linear => LawKind::Linear,
        &Law::Bilinear(Bilinear { strain, ratio }) => LawKind::Bilinear { strain, second_modulus_ratio: ratio },
        Law::Tabulated(law) => LawKind::Table { has_hysteresis: law.has_hysteresis() },
        &Law::Viscoelastic(Viscoelastic { ratio, relaxation_time }) => {
            LawKind::Viscoelastic { instantaneous_ratio: 1.0 + ratio, relaxation_time_s: relaxation_time }
        }
        Law::Strut => LawKind::Strut,
    }
}

/// The values from the library; none where there are none.
pub(super) fn from_library(document: &Document) -> Option<FromLibrary> {
    let taken = &document.library.taken;
    if taken.is_empty() {
        return None;
    }
    let value = |taken: &netcast_scenario::library::Taken| LibraryValue {
        table: taken.table.clone(),
        material: taken.material.clone(),
        summary: library().summary(&taken.material).to_owned(),
        key: taken.key.to_owned(),
        value: taken.value.clone(),
        sources: taken.sources.clone(),
    };
    let is_named = |source: &str| taken.iter().any(|taken| taken.sources.iter().any(|name| name == source));
    let named = library().sources.iter().filter(|(name, _)| is_named(name));
    Some(FromLibrary {
        values: taken.iter().map(value).collect(),
        sources: named.map(|(name, source)| (name.clone(), source.clone())).collect(),
    })
}
