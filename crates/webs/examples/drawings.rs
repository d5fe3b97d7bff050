//! Draws a flat web of every kind, for the pictures of docs/webs.md:
//!
//! ```sh
//! cargo run -p netcast-webs --example drawings -- docs/images
//! ```

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::{env, fs};

use glam::DVec3;
use netcast_webs::{Class, Diamond, Radial, Web, diamond, polygon, radial, space, square, topological, traditional};

/// Width of a picture and of its margin, px.
const SIZE: f64 = 340.0;
const MARGIN: f64 = 26.0;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(env::args().nth(1).ok_or("name the folder of the pictures")?);
    let spider = Radial { diameter: 5.0, radials: 12, rings: 6, hub_diameter: Some(0.6), corners: 6 };
    let fishing = Diamond { mesh: 0.5, hanging_ratio: 0.5, meshes_wide: 10, meshes_high: 6 };
    let webs = [
        ("traditional", traditional(2.5, 6)?),
        ("topological", topological(2.5, 0.14)?),
        ("space", space(2.5, 0.14)?),
        ("square", square(5.0, 0.5)?.with_gathering(2, 0.1)?),
        ("polygon", polygon(5, 2.5, 0.4)?),
        ("radial", radial(&spider)?),
        ("diamond", diamond(&fishing)?),
    ];
    for (name, web) in &webs {
        fs::write(folder.join(format!("web-{name}.svg")), picture(name, web)?)?;
    }
    Ok(())
}

/// The flat web: ropes coloured by class, corners as dots, feature points with their letters.
fn picture(name: &str, web: &Web) -> Result<String, Box<dyn Error>> {
    let scale = (0.5 * SIZE - MARGIN) / web.radius();
    let place = |p: DVec3| (0.5 * SIZE + scale * p.x, 0.5 * SIZE - scale * p.y);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIZE} {SIZE}\" width=\"{SIZE}\" height=\"{SIZE}\" \
         role=\"img\" aria-label=\"The {name} web\">\n<rect width=\"{SIZE}\" height=\"{SIZE}\" rx=\"8\" fill=\"#fff\"/>\n"
    );
    for canopy in &web.canopies {
        let rim = canopy.rim.map(|knot| place(web.knots[knot].position)).map(|(x, y)| format!("{x:.1},{y:.1}"));
        writeln!(svg, "<polygon points=\"{}\" fill=\"#2b6a94\" fill-opacity=\".3\"/>", rim.join(" "))?;
    }
    for class in web.rope_length_by_class().keys() {
        let (colour, width) = match class {
            Class::Outline => ("#26313a", 2.2),
            Class::Gathering => ("#c2571a", 1.6),
            Class::Ring => ("#2b6a94", 1.4),
            Class::Radial => ("#8a4f9e", 1.4),
            Class::Hexagon => ("#3c8a5a", 1.2),
            _ => ("#8796a1", 1.1),
        };
        // a little outside the outline, which would hide it
        let aside = if *class == Class::Gathering { 1.03 } else { 1.0 };
        let mut path = String::new();
        for rope in web.ropes.iter().filter(|rope| rope.class == *class) {
            let [(ax, ay), (bx, by)] = [rope.a, rope.b].map(|knot| place(web.knots[knot].position * aside));
            write!(path, "M{ax:.1} {ay:.1}L{bx:.1} {by:.1}")?;
        }
        writeln!(svg, "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>")?;
    }
    for &corner in &web.corners {
        let (x, y) = place(web.knots[corner].position);
        writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"#26313a\"/>")?;
    }
    for (name, &site) in &web.points {
        let (x, y) = place(web.position(site));
        writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"#c2571a\"/>")?;
        let (x, y) = (x + 5.0, y - 5.0);
        writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-family=\"DejaVu Sans,Verdana,sans-serif\" font-size=\"13\" \
             font-weight=\"bold\" fill=\"#c2571a\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\">{name}</text>"
        )?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
