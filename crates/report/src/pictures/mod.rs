//! Draws pictures of a net as SVG, PNG and GIF files.
//!
//! ```text
//!  Scene ─▶ strands  ropes as few polylines ─┐
//!           camera   viewing directions      ├─▶ net_picture ─▶ sheet ─▶ SVG in the page, SVG file
//!           colour   tension in twelve bins ─┘                    │            │
//!  summary ─▶ key_frames  which frames ────────────▶ sheets ──────┘         raster ─▶ PNG
//!  history ─▶ curves ─▶ SVG file ──────────────────────────────────────┘   └─▶ animation ─▶ GIF
//! ```
//!
//! `files` writes all files.

mod animation;
mod body_outline;
mod camera;
mod colour;
mod curves;
mod files;
mod key_frames;
mod net_picture;
mod raster;
mod series;
mod sheet;
mod sheets;
mod strands;
mod svg_text;
mod theme;

pub(crate) use colour::SLACK_BELOW;
pub use files::write_pictures;
pub(crate) use key_frames::tension_scale;
pub(crate) use sheets::{clouds_html, postures_html, stowed_html};
pub(crate) use theme::page_style;
