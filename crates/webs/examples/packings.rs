//! Draws a web packed by every pattern, from the side and along the launch axis, for the pictures of docs/packing.md:
//!
//! ```sh
//! cargo run -p netcast-webs --example packings -- docs/images
//! ```

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::{env, fs};

use glam::{DVec2, DVec3, dvec2};
use netcast_webs::{Bag, Class, Container, CutWeb, Cutting, Folded, Folding, Mouth, Pattern, Prescribed, cut, polygon};

/// Width of one view and height of a picture, px; then the margin, px.
const SIZE: [f64; 2] = [300.0, 330.0];
const MARGIN: f64 = 16.0;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(env::args().nth(1).ok_or("name the folder of the pictures")?);
    let web = polygon(6, 2.5, 0.5)?.with_traction(1.0, 1)?;
    let net = cut(&web, &Cutting::SegmentLength(0.05))?;
    let container = Container::Cylinder { radius: 0.3, height: 0.6 };
    let mouth = Mouth { tractor_radius: None, tractor_gap: None };
    let folded = |folding| Pattern::Folded(Folded { folding, container, spacing: 0.005, mouth });
    let patterns = [
        ("bag", Pattern::Bag(Bag { radius: 0.3, depth: Some(0.6), mouth })),
        ("zigzag-rings", folded(Folding::Rings)),
        ("zigzag-lines", folded(Folding::Lines)),
        ("star", folded(Folding::Star { arms: None })),
        ("roll", folded(Folding::Roll)),
        ("layers", folded(Folding::Layers)),
    ];
    let mut packed = Vec::new();
    for (name, pattern) in patterns {
        packed.push((name, pattern.pack(&net)?));
    }
    packed.push(("prescribed", prescribed(&net, mouth).pack(&net, None)?.0));
    for (name, packed) in packed {
        fs::write(folder.join(format!("packing-{name}.svg")), picture(name, &net, &packed)?)?;
    }
    Ok(())
}

/// The default of `[stow.prescribed]`: the outline is drawn in to a ring.
fn prescribed(net: &CutWeb, mouth: Mouth) -> Prescribed {
    Prescribed {
        radius: 0.3,
        depth: Some(0.6),
        paths: Vec::new(),
        time: 1.0,
        gravity: 9.80665,
        damping: 5.0,
        rest: 1e-4,
        longest: 20.0,
        mass: vec![1.0; net.nodes.len()],
        plates: Vec::new(),
        mouth,
    }
}

/// Two views at one scale: from the side with the launch axis up, and along the launch axis.
fn picture(name: &str, net: &CutWeb, packed: &[DVec3]) -> Result<String, Box<dyn Error>> {
    let [width, height] = SIZE;
    let lowest = packed.iter().map(|place| place.z).fold(0.0, f64::min);
    let scale = (height - 2.0 * MARGIN) / -lowest;
    let side = |p: DVec3| dvec2(0.5 * width + scale * p.x, MARGIN - scale * p.z);
    let ahead = |p: DVec3| dvec2(1.5 * width + scale * p.x, 0.5 * height - scale * p.y);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {height}\" width=\"{0}\" height=\"{height}\" \
         role=\"img\" aria-label=\"A web packed by {name}, from the side and from ahead\">\n\
         <rect width=\"{0}\" height=\"{height}\" rx=\"8\" fill=\"#fff\"/>\n",
        2.0 * width
    );
    let views: [&dyn Fn(DVec3) -> DVec2; 2] = [&side, &ahead];
    for view in views {
        for (is_traction, colour, stroke) in [(true, "#c2571a", 1.2), (false, "#2b6a94", 0.6)] {
            let mut path = String::new();
            for (rope, drawn) in net.web.ropes.iter().enumerate() {
                if (drawn.class == Class::Traction) != is_traction {
                    continue;
                }
                for (place, node) in net.nodes_of(rope).into_iter().enumerate() {
                    let at = view(packed[node]);
                    write!(path, "{}{:.1} {:.1}", if place == 0 { 'M' } else { 'L' }, at.x, at.y)?;
                }
            }
            writeln!(svg, "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{stroke}\"/>")?;
        }
        for &tractor in &net.web.tractors {
            let at = view(packed[tractor]);
            writeln!(svg, "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4\" fill=\"#26313a\"/>", at.x, at.y)?;
        }
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
