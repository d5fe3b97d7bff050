//! The patterns that lay a web back and forth over its whole length, first one way and then the other: `zigzag` along
//! lines, `layers` and `roll`; see [`super::bend`] for why that stretches nothing.
//!
//! ```text
//! (x, y) --first fold--> (along its legs, across them, x) --second fold, of the whole stack--> packed
//! ```

use glam::{DVec2, DVec3, dvec3};

use super::Container;
use super::bend::{Roll, Serpentine};

/// The directions of the legs of both folds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Legs {
    /// First fold: along the launch axis, so that it bends at the top and at the bottom. Second fold: across the axis.
    Upright,
    /// Both folds: across the axis, flat layers on one another.
    Flat,
    /// First fold: along the launch axis. The band that it makes is rolled up about the axis from its middle.
    Rolled,
}

/// Folds a rectangle from `least` to `most`, m, into a container; layers lie `spacing` apart, m.
pub(super) fn fold(
    legs: Legs,
    least: DVec2,
    most: DVec2,
    container: &Container,
    spacing: f64,
) -> impl Fn(DVec2) -> DVec3 + use<> {
    let size = most - least;
    let [width, breadth] = container.rectangle();
    let span = if legs == Legs::Flat { breadth } else { container.height() };
    let first = Serpentine::within(span, size.y, spacing, 0.0);
    // the stack of its layers is the sheet of the second fold
    let pitch = first.legs() * spacing;
    let reach = 0.5 * (pitch - spacing);
    let second = Serpentine::within(width, size.x, pitch, reach);
    let roll = Roll { pitch, reach };
    move |point| {
        // the web in the middle of what the folds can take
        let from_middle = point - 0.5 * (least + most);
        let stacked = first.place(from_middle.y + 0.5 * first.length(), 0.0);
        let offset = stacked.y - reach;
        let laid = match legs {
            Legs::Rolled => roll.place(from_middle.x, offset),
            _ => second.place(from_middle.x + 0.5 * second.length(), offset),
        };
        match legs {
            Legs::Flat => dvec3(laid.x, stacked.x, laid.y),
            Legs::Upright | Legs::Rolled => dvec3(laid.x, laid.y, stacked.x),
        }
    }
}
