//! The library of materials: ropes and cloths by name, as in `material = "nylon rope"`. `materials.toml` has their
//! values, sources and scatter. Values of a rope are measured on ropes, which are softer and weaker than their
//! fibres.

mod fill;

pub use fill::{FromLibrary, Taken};
pub(crate) use fill::{cloth_names, fill, rope_names};

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::interval::{Positive, UpToOne};
use crate::quantity::{Density, Number, Pressure};

/// The library of materials.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Library {
    /// Sources by their short names: author or maker, title, year, place.
    pub sources: BTreeMap<String, String>,
    /// Fibres, as yarns.
    pub fibres: BTreeMap<String, Fibre>,
    /// Ropes by name, for `material` of a rope.
    pub ropes: BTreeMap<String, RopeMaterial>,
    /// Cloths by name, for `material` of a canopy.
    pub cloths: BTreeMap<String, ClothMaterial>,
}

impl Library {
    /// The summary of a rope or a cloth. Empty for an unknown name.
    pub fn summary(&self, material: &str) -> &str {
        let rope = self.ropes.get(material).map(|rope| &rope.summary);
        rope.or(self.cloths.get(material).map(|cloth| &cloth.summary)).map_or("", String::as_str)
    }
}

/// A value with its sources.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, bound = "Q: serde::de::DeserializeOwned")]
pub struct Value<Q> {
    /// The value.
    pub value: Q,
    /// The area that it is stated for. Values that belong to no area leave it out.
    #[serde(default)]
    pub per: Per,
    /// Short names of its sources.
    pub sources: Vec<String>,
    /// The range of other values.
    pub scatter: Option<Scatter<Q>>,
    /// A remark for the user.
    pub note: Option<String>,
}

/// The least and the largest value that was found.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, bound = "Q: serde::de::DeserializeOwned")]
pub struct Scatter<Q> {
    /// The least.
    pub from: Q,
    /// The largest.
    pub to: Q,
    /// Short names of their sources.
    pub sources: Vec<String>,
}

/// The area that a rope's value is stated for; d is the nominal diameter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
pub enum Per {
    /// The nominal section, pi d^2 / 4. Scenarios use it.
    #[default]
    #[serde(rename = "nominal section")]
    NominalSection,
    /// d^2. Catalogues use it.
    #[serde(rename = "diameter squared")]
    DiameterSquared,
}

impl Per {
    /// The factor that converts a value to the nominal section.
    pub fn to_nominal_section(self) -> f64 {
        match self {
            Self::NominalSection => 1.0,
            Self::DiameterSquared => 4.0 / PI,
        }
    }
}

/// A fibre, measured as a yarn. Its modulus and strength are stated over density: 1 N/tex is 10^6 N m/kg.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fibre {
    /// A description.
    pub summary: String,
    /// Density, kg/m^3.
    pub density: Value<Density<Positive>>,
    /// Elastic modulus over density, N/tex.
    pub modulus_n_tex: Value<Number<Positive>>,
    /// Strength over density, N/tex.
    pub tenacity_n_tex: Value<Number<Positive>>,
    /// Strain at break.
    pub elongation_at_break: Value<Number<UpToOne>>,
}

impl Fibre {
    /// Elastic modulus, Pa.
    pub fn elastic_modulus(&self) -> f64 {
        1e6 * self.modulus_n_tex.value.si() * self.density.value.si()
    }

    /// Strength, Pa.
    pub fn strength(&self) -> f64 {
        1e6 * self.tenacity_n_tex.value.si() * self.density.value.si()
    }
}

/// A kind of rope. It has either `elastic_modulus` or `stiffness`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RopeMaterial {
    /// A description with its construction.
    pub summary: String,
    /// Its fibre.
    pub fibre: String,
    /// Mass per length over the area, kg/m^3.
    pub density: Value<Density<Positive>>,
    /// Axial stiffness EA over the area, Pa.
    pub elastic_modulus: Option<Value<Pressure<Positive>>>,
    /// Axial stiffness EA over the breaking load.
    pub stiffness: Option<Value<Number<Positive>>>,
    /// Breaking load over the area, Pa.
    pub strength: Value<Pressure<Positive>>,
}

impl RopeMaterial {
    /// Mass per length over the nominal section, kg/m^3. It is rounded to three digits, which is finer than the
    /// scatter of ropes.
    pub fn nominal_density(&self) -> f64 {
        three_digits(self.density.per.to_nominal_section() * self.density.value.si())
    }

    /// Axial stiffness over the nominal section, Pa.
    pub fn nominal_elastic_modulus(&self) -> f64 {
        let direct = self.elastic_modulus.as_ref().map(|e| e.per.to_nominal_section() * e.value.si());
        let by_strength = self.stiffness.as_ref().map(|k| k.value.si() * self.stress_at_break());
        three_digits(direct.or(by_strength).unwrap_or(f64::NAN))
    }

    /// Breaking load, N, of a rope of the given diameter, m.
    pub fn breaking_load(&self, diameter: f64) -> f64 {
        three_digits(self.stress_at_break() * 0.25 * PI * diameter * diameter)
    }

    /// Breaking load over the nominal section, Pa.
    pub fn stress_at_break(&self) -> f64 {
        self.strength.per.to_nominal_section() * self.strength.value.si()
    }

    /// Short names of the sources of its modulus.
    pub fn modulus_sources(&self) -> &[String] {
        let direct = self.elastic_modulus.as_ref().map(|e| &e.sources);
        direct.or(self.stiffness.as_ref().map(|k| &k.sources)).map_or(&[], Vec::as_slice)
    }
}

/// A cloth, modelled as solid fibre: its thickness is mass per area over the density of the fibre.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClothMaterial {
    /// A description.
    pub summary: String,
    /// Its fibre, whose density it has.
    pub fibre: String,
    /// The share of the fibre along each of its two directions. The crimp of the yarns, which makes a cloth softer, is
    /// neglected.
    pub share: Number<UpToOne>,
}

impl ClothMaterial {
    /// Elastic modulus of the cloth along its yarns, Pa. It is an upper bound.
    pub fn elastic_modulus(&self, fibre: &Fibre) -> f64 {
        three_digits(self.share.si() * fibre.elastic_modulus())
    }
}

/// The library of materials, read once.
pub fn library() -> &'static Library {
    static LIBRARY: LazyLock<Library> =
        LazyLock::new(|| toml::from_str(include_str!("materials.toml")).expect("materials.toml: a test reads it"));
    &LIBRARY
}

/// A value to three significant digits.
fn three_digits(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
