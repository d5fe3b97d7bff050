//! What the schema cannot say of `[environment.air]` and `[environment.wind]`.

use crate::diagnostic::Diagnostic;
use crate::path::Path;
use crate::schema::keys_at;
use crate::tables::table_at;
use crate::written::Written;

/// Everything in the medium and the wind that does not fit the rest of it.
pub(crate) fn check(written: &Written, found: &mut Vec<Diagnostic>) {
    a_medium_is_dense_and_viscous(written, found);
    a_wind_blows_in_air(written, found);
    a_measured_wind_is_all_there_is(written, found);
}

fn a_medium_is_dense_and_viscous(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("environment.air");
    let Some(air) = table_at(written, "environment.air") else { return };
    match (air.get("density"), air.get("viscosity")) {
        (Some(_), None) => {
            let message = "missing key `viscosity`, as the density of the medium is given";
            let help = "water of 20 deg C has \"1 mPa s\", air of 15 deg C \"0.0179 mPa s\"";
            found.push(written.at_key(&path.key("density"), message).with_help(help));
        }
        (None, Some(_)) => {
            let message = "the viscosity of the standard atmosphere follows from its altitude";
            let help = "leave it out, or give `environment.air.density` too";
            found.push(written.at_key(&path.key("viscosity"), message).with_help(help));
        }
        _ => {}
    }
}

fn a_wind_blows_in_air(written: &Written, found: &mut Vec<Diagnostic>) {
    let wind = Path::parse("environment.wind");
    if written.tree.get(&wind).is_some() && written.tree.get(&Path::parse("environment.air")).is_none() {
        let message = "a wind acts by drag, and there is no air";
        found.push(written.at_key(&wind, message).with_help("add [environment.air]"));
    }
}

fn a_measured_wind_is_all_there_is(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("environment.wind");
    let Some(wind) = table_at(written, "environment.wind").filter(|wind| wind.get("series").is_some()) else { return };
    for key in keys_at("environment.wind") {
        if key != "series" && wind.get(key).is_some() {
            let message = format!("a measured wind is all there is: expected only one of `series` and `{key}`");
            found.push(written.at_key(&path.key(key), message));
        }
    }
}
