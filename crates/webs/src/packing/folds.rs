//! The patterns that fold a web twice, back and forth along y and then along x: `zigzag` along lines, `layers` and
//! `roll`. [`super::bend`] proves that they stretch no rope.
//!
//! ```text
//! (x, y) --first fold, of y--> (x, along the legs, across the legs) --second fold, of x and the whole stack--> packed
//! ```

use glam::{DVec2, DVec3, dvec3};

use super::Container;
use super::bend::{Roll, Serpentine};

/// Directions of the legs of the two folds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Legs {
    /// First fold: along the launch axis, with its bends at the top and at the bottom. Second fold: across the axis.
    Upright,
    /// Both folds: across the axis, in flat layers.
    Flat,
    /// First fold: along the launch axis. Instead of a second fold, the stack is rolled up about the axis from its
    /// middle.
    Rolled,
}

/// The map that folds a rectangle from `least` to `most`, m, into a container, with layers `spacing` apart, m.
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
    // the second fold treats the stack of layers as one thick sheet
    let pitch = first.legs() * spacing;
    let reach = 0.5 * (pitch - spacing);
    let second = Serpentine::within(width, size.x, pitch, reach);
    let roll = Roll { pitch, reach };
    move |point| {
        // the folds may be longer than the web, which then lies in their middle
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
