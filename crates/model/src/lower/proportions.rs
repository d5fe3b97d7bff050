//! Notes on sizes and masses out of all proportion: most are slips of a unit.

use netcast_scenario::{Scenario, Web};
use netcast_webs::Bill;

/// A diameter, m, that no rope of a thrown net has.
const THICK: f64 = 0.5;

/// A mass of the web over that of all tractors with which these do not pull it out.
const HEAVY: f64 = 100.0;

/// The notes on a scenario with this bill of materials. `is_thrown` says whether a tractor is thrown.
pub fn notes(scenario: &Scenario, bill: Option<&Bill>, is_thrown: bool) -> Vec<String> {
    let all = scenario.ropes.iter().map(|(name, rope)| (format!("rope `{name}`"), rope));
    let ropes = [("the default rope".to_owned(), &scenario.rope)].into_iter().chain(all);
    let diameters: Vec<(String, f64)> = ropes.map(|(name, rope)| (name, rope.diameter.si())).collect();
    let mut notes: Vec<String> = diameters.iter().filter_map(|(name, diameter)| too_thick(name, *diameter)).collect();
    if let Some(mesh) = mesh(&scenario.web) {
        notes.extend(diameters.iter().filter_map(|(name, diameter)| fills_its_mesh(name, *diameter, mesh)));
    }
    if let Some(bill) = bill.filter(|bill| is_thrown && bill.tractors > 0) {
        notes.extend(too_heavy(bill.web_mass(), bill.tractor_mass));
    }
    notes
}

/// Width of the meshes of a web, m; none where they differ.
fn mesh(web: &Web) -> Option<f64> {
    match web {
        Web::Square(web) => Some(web.mesh.si()),
        Web::Polygon(web) => Some(web.mesh.si()),
        Web::Diamond(web) => Some(web.mesh.si()),
        Web::Traditional(web) => Some(web.side.si() / f64::from(web.cells_per_side.get())),
        Web::Topological(_) | Web::Space(_) | Web::Radial(_) | Web::Graph(_) => None,
    }
}

fn too_thick(name: &str, diameter: f64) -> Option<String> {
    (diameter > THICK).then(|| format!("{name} is {diameter} m thick: is its diameter in the unit that was meant?"))
}

fn fills_its_mesh(name: &str, diameter: f64, mesh: f64) -> Option<String> {
    (diameter >= mesh)
        .then(|| format!("{name} is {diameter} m thick and the meshes are {mesh} m wide: ropes fill them"))
}

fn too_heavy(web: f64, tractors: f64) -> Option<String> {
    (web > HEAVY * tractors).then(|| {
        format!(
            "the web has {web:.3} kg, {:.0} times the {tractors:.3} kg of its tractors, which hardly pull it out",
            web / tractors
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rope of 1.5 m for one of 1.5 mm made a web of 174 t without a word.
    #[test]
    fn sizes_and_masses_out_of_all_proportion_are_told() {
        assert_eq!(too_thick("the default rope", 0.0015), None);
        assert!(too_thick("the default rope", 1.5).unwrap().starts_with("the default rope is 1.5 m thick"));
        assert_eq!(fills_its_mesh("rope `thin`", 0.002, 0.12), None);
        assert!(fills_its_mesh("rope `thin`", 0.12, 0.12).is_some());
        assert_eq!(too_heavy(10.0, 0.24), None);
        assert!(too_heavy(174e3, 0.24).unwrap().contains("725000 times"));
    }
}
