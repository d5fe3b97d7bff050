//! The key in the scenario that an error of another crate is about.

use netcast_dynamics::forces::element::{ElementError, Property};
use netcast_scenario::{Stow, Web};

/// The key of an argument by which the web is drawn. Most arguments have the name of their key.
pub fn of_web(argument: &str, web: &Web) -> String {
    let key = match (argument, web) {
        ("side", Web::Polygon(polygon)) if polygon.side.is_none() => "diameter",
        ("hanging_ratio", Web::Diamond(net)) if net.hanging_ratio.is_none() => "angle",
        ("every", _) => "gathering.every",
        ("excess", _) => "gathering.excess",
        // the canopies follow from the web: only its side can make room for them
        ("canopy_side", _) => "side",
        (argument, _) => argument,
    };
    format!("{}.{key}", web.table())
}

/// The key of an argument of a packing.
pub fn of_packing(argument: &str, stow: &Stow) -> String {
    let key = match argument {
        "positions" => "path",
        "paths" => "drive",
        argument => argument,
    };
    format!("{}.{key}", stow.table())
}

/// The key of a property of a sheet.
pub fn of_sheet(error: &ElementError) -> &'static str {
    match error {
        ElementError::Repeated { .. } => "canopy.membrane.fineness",
        ElementError::Property { what, .. } => of_property(*what),
    }
}

fn of_property(property: Property) -> &'static str {
    match property {
        Property::PoissonRatio => "canopy.membrane.poisson_ratio",
        Property::ModulusAlong => "canopy.membrane.elastic_modulus",
        Property::ModulusAcross => "canopy.membrane.elastic_modulus_across",
        Property::ShearModulus => "canopy.membrane.shear_modulus",
        Property::FibreAngle => "canopy.membrane.fibre_angle",
        Property::Thickness | Property::FlexuralRigidity | Property::BendingStiffness => "canopy.membrane.thickness",
        Property::DampingTime => "canopy.membrane.damping_time",
        Property::RestArea | Property::AreaLeft | Property::AreaRight | Property::Edge | Property::RestLength => {
            "canopy.membrane.side"
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use netcast_scenario::init::TEMPLATES;
    use netcast_scenario::schema::find_key;
    use netcast_scenario::{Document, Source, schema};

    use super::*;

    /// Whether the schema of a scenario has a key at `path`.
    fn has_key(path: &str) -> bool {
        let (_, key) = path.rsplit_once('.').expect("a path has a table");
        find_key(schema(), key).iter().any(|known| known == path)
    }

    fn document(text: &str, folder: &Path) -> Document {
        let source = Source { name: "net.toml".into(), text: text.into() };
        Document::parse(source, folder, &[]).unwrap_or_else(|wrong| panic!("{wrong}"))
    }

    #[test]
    fn every_argument_of_a_web_has_a_key_in_the_table_of_some_kind() {
        let folder = tempfile::tempdir().unwrap();
        let webs: Vec<Web> = TEMPLATES
            .iter()
            .map(|template| {
                for (name, text) in template.files {
                    std::fs::write(folder.path().join(name), text).unwrap();
                }
                document(template.scenario, folder.path()).scenario.web
            })
            .collect();
        // the arguments of the drawing functions of netcast-webs
        let arguments = [
            "side",
            "diameter",
            "hub_diameter",
            "mesh",
            "sides",
            "radials",
            "rings",
            "corners",
            "meshes_wide",
            "meshes_high",
            "cells_per_side",
            "hanging_ratio",
            "every",
            "excess",
            "canopy_side",
            "hexagon_side",
        ];
        for argument in arguments {
            let places: Vec<String> = webs.iter().map(|web| of_web(argument, web)).collect();
            assert!(places.iter().any(|path| has_key(path)), "{argument}: {places:?}");
        }
    }

    #[test]
    fn every_argument_of_a_packing_has_a_key_in_the_table_of_some_pattern() {
        let net = "web.square = { side = 2, mesh = 1 }\nsolve.duration = 1\n\
                   rope = { diameter = 0.001, density = 970, elastic_modulus = 1e9 }\n";
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("net.csv"), "id,x,y,z\n").unwrap();
        let patterns = [
            "scale.factor = 0.5",
            "bag.radius = 0.1",
            "prescribed.radius = 0.1",
            "file.path = \"net.csv\"",
            "roll.container.cylinder = { radius = 1, height = 1 }",
        ];
        let stows = patterns.map(|pattern| {
            document(&format!("{net}stow.{pattern}\n"), folder.path()).scenario.stow.expect("it is stowed").pattern
        });
        let arguments =
            ["factor", "radius", "depth", "tractor_radius", "tractor_gap", "container", "positions", "paths"];
        for argument in arguments {
            let places = stows.each_ref().map(|stow| of_packing(argument, stow));
            assert!(places.iter().any(|path| has_key(path)), "{argument}: {places:?}");
        }
    }

    #[test]
    fn every_property_of_a_sheet_has_a_key() {
        for property in Property::ALL {
            assert!(has_key(of_property(property)), "{property:?}");
        }
        assert!(has_key(of_sheet(&ElementError::Repeated { node: 0 })));
    }
}
