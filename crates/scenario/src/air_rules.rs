//! Rules for `[environment.air]` and `[environment.wind]` that the schema cannot express.

use crate::diagnostic::Diagnostic;
use crate::path::Path;
use crate::schema::keys_at;
use crate::tables::table_at;
use crate::written::Written;

/// Adds every fault of the medium and the wind by these rules to `found`.
pub(crate) fn check(written: &Written, found: &mut Vec<Diagnostic>) {
    check_medium(written, found);
    check_wind_has_air(written, found);
    check_measured_wind(written, found);
}

fn check_medium(written: &Written, found: &mut Vec<Diagnostic>) {
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

fn check_wind_has_air(written: &Written, found: &mut Vec<Diagnostic>) {
    let wind = Path::parse("environment.wind");
    if written.tree.get(&wind).is_some() && written.tree.get(&Path::parse("environment.air")).is_none() {
        let message = "a wind acts by drag, and there is no air";
        found.push(written.at_key(&wind, message).with_help("add [environment.air]"));
    }
}

fn check_measured_wind(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("environment.wind");
    let Some(wind) = table_at(written, "environment.wind").filter(|wind| wind.get("series").is_some()) else { return };
    for key in keys_at("environment.wind") {
        if key != "series" && wind.get(key).is_some() {
            let message = format!("expected only one of `series` and `{key}`: a measured wind replaces all other keys");
            found.push(written.at_key(&path.key(key), message));
        }
    }
}
