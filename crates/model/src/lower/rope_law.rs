//! The law of a rope, and the load and strain at which it breaks.

use std::sync::Arc;

use netcast_dynamics::forces::bilinear::Bilinear;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::tabulated::{TableError, Tabulated};
use netcast_dynamics::forces::viscoelastic::Viscoelastic;
use netcast_scenario::path::Path;
use netcast_scenario::{BeyondTable, BilinearLaw, Diagnostics, Document, Rope, RopeLaw, ViscoelasticLaw};

use super::members::section;

/// The law of the rope whose table is at `path`.
///
/// # Errors
/// Moduli that contradict each other, a wrong table, a pretension that the law never reaches.
pub fn law(document: &Document, path: &Path, rope: &Rope) -> Result<Law, Diagnostics> {
    let modulus = rope.elastic_modulus.si();
    let law = match &rope.law {
        RopeLaw::Linear(_) => Law::Linear,
        RopeLaw::Bilinear(BilinearLaw { strain, second_modulus }) => {
            Law::Bilinear(Bilinear { strain: strain.si(), ratio: second_modulus.si() / modulus })
        }
        RopeLaw::Table(table) => {
            let file = document.files.laws.get(&table.file).expect("a document has read the tables of its ropes");
            let scale = table.scale.map_or(1.0, |scale| scale.si());
            let scaled = |tension: &Vec<f64>| tension.iter().map(|tension| scale * tension).collect::<Vec<f64>>();
            let (tension, unloading) = (scaled(&file.tension), file.unloading.as_ref().map(scaled));
            let law = Tabulated::new(&file.strain, &tension, unloading.as_deref());
            let wrong = |error: TableError| file.at_row(error.row().unwrap_or(0), &error.to_string());
            let law = law.map_err(wrong)?;
            Law::Tabulated(Arc::new(if table.beyond == BeyondTable::Stop { law.stopping() } else { law }))
        }
        RopeLaw::Viscoelastic(ViscoelasticLaw { instantaneous_modulus, relaxation_time }) => {
            let (at_once, relaxation_time) = (instantaneous_modulus.si(), relaxation_time.si());
            if at_once <= modulus {
                let message = format!("expected more than the elastic modulus, {modulus} Pa, to which it relaxes");
                let place = path.key("law").key("viscoelastic").key("instantaneous_modulus");
                return Err(document.diagnostic(&place.to_string(), message).into());
            }
            Law::Viscoelastic(Viscoelastic { ratio: at_once / modulus - 1.0, relaxation_time })
        }
        RopeLaw::Strut(_) => Law::Strut,
    };
    let pretension = rope.pretension.si();
    if law.strain_under(pretension, modulus * section(rope)).is_finite() {
        Ok(law)
    } else {
        let message = format!("the law of this rope never reaches {pretension} N");
        Err(document.diagnostic(&path.key("pretension").to_string(), message).into())
    }
}

/// Load, N, and strain at which a segment of `rope` breaks; `knotted` says that it ends at a knot. A rope whose table says so
/// breaks, or stops the run, at the last row of its `law`.
pub fn breaking(rope: &Rope, law: &Law, knotted: bool) -> Breaking {
    let end_of_table = match (&rope.law, law) {
        (RopeLaw::Table(table), Law::Tabulated(law)) if table.beyond != BeyondTable::Extend => law.last_strain(),
        _ => f64::INFINITY,
    };
    let left = rope.knot_reduction.filter(|_| knotted).map_or(1.0, |share| 1.0 - share.si());
    let asked = rope.breaking;
    let load = asked.and_then(|breaking| breaking.load).map_or(f64::INFINITY, |load| left * load.si());
    let strain = asked.and_then(|breaking| breaking.strain).map_or(f64::INFINITY, |strain| strain.si());
    Breaking { load, strain: strain.min(end_of_table), ..Breaking::NEVER }
}
