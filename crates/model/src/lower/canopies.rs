//! Canopies as links, as rigid plates, or as sheets of triangles with rigid patches.

use glam::DVec3;
use netcast_dynamics::forces::element::ElementError;
use netcast_dynamics::forces::hinge::{Hinge, flexural_rigidity};
use netcast_dynamics::forces::membrane::{Fabric, Membrane};
use netcast_dynamics::forces::tension_field::Elasticity;
use netcast_scenario::{Canopy, CanopyMembrane, Damping, Diagnostics, Document, SheetBending};
use netcast_webs::{Class, CutWeb, Sheet, StiffPlate, hexagonal_sheet};

use super::binding::{Binding, Lump};
use super::canopy_links;
use super::canopy_parts::{Canopies, CutSheet};
use super::draft::Draft;
use super::material::{add_links, canopy_of, group_number};
use super::members::PlacedBody;
use super::places;

/// Makes the canopies: links, plates or sheets. Adds nodes to the web and the mass of the canopies to their nodes.
///
/// # Errors
/// A sheet whose mesh, tie radius or material is impossible.
pub fn make(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Some(canopy) = canopy_of(&draft.scenario, &draft.cut) else { return Ok(()) };
    let Draft { document, cut, groups, members, bodies, parts, .. } = draft;
    match &canopy {
        Canopy::Links(links) => {
            let made = canopy_links::members(links, canopy.mass_and_volume().0);
            add_links(cut, &made, group_number(groups, &Class::Canopy, None), members, &mut parts.mass);
        }
        Canopy::Rigid(plate) => {
            let lump = hexagonal_plate(canopy.mass_and_volume().0, canopy.side_m(), plate.thickness.si());
            draft.canopies = rigid(cut, lump);
        }
        Canopy::Membrane(sheet) => draft.canopies = sheets(document, sheet, bodies, cut, &mut parts.mass)?,
    }
    Ok(())
}

/// A regular hexagonal plate about the origin, in the plane of the web: `mass` in kg, `side` s and `thickness` t in m. Its
/// moments of inertia are m (5 s^2/24 + t^2/12) about axes in its plane and 5 m s^2/12 about its normal.
fn hexagonal_plate(mass: f64, side: f64, thickness: f64) -> Lump {
    let across = 5.0 / 24.0 * side * side + thickness * thickness / 12.0;
    Lump { place: DVec3::ZERO, mass, inertia: mass * DVec3::new(across, across, 5.0 / 12.0 * side * side) }
}

/// Makes each canopy one rigid body.
fn rigid(cut: &CutWeb, lump: Lump) -> Canopies {
    let mut canopies = Canopies::default();
    for (canopy, hexagon) in cut.web.canopies.iter().enumerate() {
        let nodes: Vec<usize> = [hexagon.hub].into_iter().chain(hexagon.rim).collect();
        canopies.plates.push(StiffPlate { canopy, nodes: nodes.clone() });
        canopies.bindings.push(Binding {
            canopy,
            label: format!("canopy {}", hexagon.number),
            nodes,
            lumps: vec![Lump { place: cut.nodes[hexagon.hub], ..lump }],
        });
    }
    canopies
}

/// Makes each canopy a sheet.
fn sheets(
    document: &Document,
    sheet: &CanopyMembrane,
    bodies: &[PlacedBody],
    cut: &mut CutWeb,
    mass: &mut Vec<f64>,
) -> Result<Canopies, Diagnostics> {
    let (side, tie_radius) = (sheet.side.si(), sheet.tie_radius.si());
    let wrong = |key: &str, message: String| document.diagnostic(&format!("canopy.membrane.{key}"), message);
    let mesh =
        hexagonal_sheet(side, sheet.fineness.get() as usize).map_err(|error| wrong("fineness", error.to_string()))?;
    let reach = bodies.iter().map(|body| body.solid.shape.radius_m()).fold(0.0, f64::max);
    if tie_radius > 0.0 && (2.0 * tie_radius >= side || tie_radius + reach >= side) {
        let message = format!(
            "the nodes bound within {tie_radius} m of a corner must stay apart from the next corner, {side} m away, and from \
             the body on the middle, {reach} m in radius"
        );
        return Err(wrong("tie_radius", message).into());
    }
    let mut canopies = Canopies::default();
    for canopy in 0..cut.web.canopies.len() {
        let nodes = mesh_nodes(&mesh, canopy, cut, mass);
        let on_hub = bodies.iter().find(|body| body.node == cut.web.canopies[canopy].hub);
        let bindings = patches(&mesh, &nodes, canopy, cut, on_hub.map(|body| body.solid.shape.radius_m()), tie_radius);
        if sheet.bending == SheetBending::Plate || !sheet.wrinkles || !bindings.is_empty() {
            canopies.plates.push(StiffPlate { canopy, nodes: nodes.clone() });
        }
        canopies.bindings.extend(bindings);
        let triangles = mesh.triangles.iter().map(|triangle| triangle.map(|node| nodes[node])).collect();
        canopies.sheets.push(CutSheet { nodes, triangles, corners: cut.web.canopies[canopy].rim });
    }
    add_elements(&mut canopies, sheet, &mesh, mass)
        .map_err(|error| document.diagnostic(places::of_sheet(&error), error.to_string()))?;
    Ok(canopies)
}

/// The nodes of a canopy's mesh, (nodes,), in its order. Adds those that are not knots.
fn mesh_nodes(mesh: &Sheet, canopy: usize, cut: &mut CutWeb, mass: &mut Vec<f64>) -> Vec<usize> {
    let hexagon = cut.web.canopies[canopy].clone();
    let middle = cut.nodes[hexagon.hub];
    let mut node = |(index, place): (usize, &glam::DVec2)| {
        if index == mesh.middle {
            return hexagon.hub;
        }
        if let Some(corner) = mesh.corners.iter().position(|&corner| corner == index) {
            return hexagon.rim[corner];
        }
        mass.push(0.0);
        cut.add_node(canopy, middle + place.extend(0.0), format!("node {index} of canopy {}", hexagon.number))
    };
    mesh.nodes.iter().enumerate().map(&mut node).collect()
}

/// The rigid patches of a canopy: the nodes about each corner, and the nodes under the body on its hub, `on_hub` m in
/// radius. A single node needs no binding.
fn patches(
    mesh: &Sheet,
    nodes: &[usize],
    canopy: usize,
    cut: &CutWeb,
    on_hub: Option<f64>,
    tie_radius: f64,
) -> Vec<Binding> {
    let number = cut.web.canopies[canopy].number;
    let about = |at: usize, radius: f64| -> Vec<usize> {
        // rounding must not exclude a node on the circle
        let is_near = |&index: &usize| mesh.nodes[index].distance(mesh.nodes[at]) <= radius * (1.0 + 1e-9);
        (0..nodes.len()).filter(is_near).map(|index| nodes[index]).collect()
    };
    let corners = mesh.corners.iter().enumerate();
    let corners = corners.map(|(k, &at)| (format!("tie {} of canopy {number}", k + 1), about(at, tie_radius)));
    let middle = on_hub.map(|radius| (format!("what canopy {number} carries"), about(mesh.middle, radius)));
    let patches = corners.chain(middle).filter(|(_, nodes)| nodes.len() > 1);
    patches.map(|(label, nodes)| Binding { canopy, label, nodes, lumps: Vec::new() }).collect()
}

/// Adds the elements of all sheets, and their mass to the nodes. An element inside a rigid patch is left out.
fn add_elements(
    canopies: &mut Canopies,
    sheet: &CanopyMembrane,
    mesh: &Sheet,
    mass: &mut [f64],
) -> Result<(), ElementError> {
    let Canopies { sheets, membranes, hinges, bindings, .. } = canopies;
    let mut patch = vec![None; mass.len()];
    for (index, binding) in bindings.iter().enumerate() {
        for &node in &binding.nodes {
            patch[node] = Some(index);
        }
    }
    let is_rigid = |nodes: &[usize]| patch[nodes[0]].is_some() && nodes.iter().all(|&n| patch[n] == patch[nodes[0]]);

    let (elasticity, modulus) = elasticity(sheet);
    let thickness = sheet.thickness.si();
    let spacing = sheet.side.si() / f64::from(sheet.fineness.get());
    let damping_time = match sheet.damping() {
        Damping::Time(time) => time,
        Damping::Ratio(ratio) => 2.0 * ratio * spacing * (sheet.density.si() / modulus).sqrt(),
    };
    let fabric = Fabric { elasticity, thickness, compresses: !sheet.wrinkles, damping_time };
    // an orthotropic sheet has nu12 nu21 where an isotropic one has nu^2
    let poisson = elasticity.poisson_ratio * (elasticity.moduli[1] / elasticity.moduli[0]).sqrt();
    let rigidity = flexural_rigidity(modulus, poisson, thickness);
    let triangle_mass = Canopy::Membrane(sheet.clone()).mass_and_volume().0 / mesh.triangles.len() as f64;
    for sheet_nodes in sheets {
        for (triangle, nodes) in mesh.triangles.iter().zip(&sheet_nodes.triangles) {
            for &node in nodes {
                mass[node] += triangle_mass / 3.0;
            }
            if !is_rigid(nodes) {
                membranes.push(Membrane::new(*nodes, triangle.map(|node| mesh.nodes[node]), &fabric)?);
            }
        }
        if sheet.bending == SheetBending::Plate {
            for hinge in &mesh.hinges {
                let nodes = hinge.map(|node| sheet_nodes.nodes[node]);
                if !is_rigid(&nodes) {
                    hinges.push(Hinge::new(nodes, hinge.map(|node| mesh.nodes[node]), rigidity, damping_time)?);
                }
            }
        }
    }
    Ok(())
}

/// In-plane elasticity of a sheet, and the geometric mean of its two elastic moduli, Pa.
fn elasticity(sheet: &CanopyMembrane) -> (Elasticity, f64) {
    let along = sheet.elastic_modulus.si();
    let across = sheet.elastic_modulus_across.map_or(along, |modulus| modulus.si());
    let mean = if across == along { along } else { (along * across).sqrt() };
    let poisson_ratio = sheet.poisson_ratio.si();
    let shear = sheet.shear_modulus.map_or(mean / (2.0 * (1.0 + poisson_ratio)), |modulus| modulus.si());
    let fibre_angle = sheet.fibre_angle.si();
    (Elasticity { moduli: [along, across], poisson_ratio, shear_modulus: shear, fibre_angle }, mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Held against the six triangles of the hexagon.
    #[test]
    fn a_hexagonal_plate_has_the_inertia_of_its_triangles() {
        let lump = hexagonal_plate(2.0, 0.3, 0.0);
        // a triangle with a corner in the middle and the others at a and b: m/6 (a.a + b.b + a.b) about the middle
        let polar = 2.0 * (0.09 + 0.09 + 0.045) / 6.0;
        assert!((lump.inertia.z - polar).abs() < 1e-15);
        assert!((lump.inertia.x + lump.inertia.y - polar).abs() < 1e-15);
    }
}
