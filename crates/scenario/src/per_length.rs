//! Ropes by linear density and axial stiffness, as catalogues state them: both over the nominal section are the density and
//! the elastic modulus that the rest of the program knows.

use std::f64::consts::PI;

use crate::dimension::{Measured, unit};
use crate::interval::{Positive, Within};
use crate::quantity::Quantity;
use crate::tree::{Node, Table, Tree, Value};

/// Puts density and modulus in the place of what is given per length, in `[rope]` and each of `[ropes]`. What cannot be read
/// stays: the check of the schema reports it.
pub(crate) fn over_section(tree: &mut Tree) {
    let Value::Table(root) = &mut tree.root.value else { return };
    for entry in &mut root.0 {
        match (&entry.key[..], &mut entry.node.value) {
            ("rope", Value::Table(rope)) => convert(rope),
            ("ropes", Value::Table(ropes)) => {
                for entry in &mut ropes.0 {
                    if let Value::Table(rope) = &mut entry.node.value {
                        convert(rope);
                    }
                }
            }
            _ => {}
        }
    }
}

/// Reads a value, in SI.
type Read = fn(&Node) -> Option<f64>;

fn convert(rope: &mut Table) {
    let Some(diameter) = rope.get("diameter").and_then(read::<unit::Metre, Positive>) else { return };
    let section = 0.25 * PI * diameter * diameter;
    let per_length: [(&str, &str, Read); 2] = [
        ("linear_density", "density", read::<unit::KilogramPerMetre, Positive>),
        ("axial_stiffness", "elastic_modulus", read::<unit::Newton, Positive>),
    ];
    for (given, meant, read) in per_length {
        if rope.get(meant).is_some() {
            continue;
        }
        if let Some(entry) = rope.0.iter_mut().find(|entry| entry.key == given)
            && let Some(value) = read(&entry.node)
        {
            // the place in the file stays
            entry.key = meant.into();
            entry.node.value = Value::Float(value / section);
        }
    }
}

/// The value of a quantity, in SI; none where the node holds no such quantity.
pub(crate) fn read<U: Measured, I: Within>(node: &Node) -> Option<f64> {
    let read = match &node.value {
        Value::String(text) => Quantity::<U, I>::from_text(text),
        Value::Float(si) => Quantity::from_si(*si),
        Value::Integer(si) => Quantity::from_si(*si as f64),
        _ => return None,
    };
    read.ok().map(|quantity| quantity.si())
}
