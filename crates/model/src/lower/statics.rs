//! Whether a web has an equilibrium, where one is looked for.

use netcast_dynamics::statics::{Unsupported, unsupported};
use netcast_scenario::Diagnostics;

use super::draft::Draft;

/// Checks that something holds every part of the web that bears a load.
pub fn check(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Some((system, _)) = draft.system.as_ref().filter(|_| draft.scenario.solve.statics.is_some()) else {
        return Ok(());
    };
    if system.environment().orbit.is_some() {
        let message = "beside an orbit no equilibrium is looked for";
        return Err(draft.document.diagnostic("solve.static", message).with_help("leave it out").into());
    }
    let Some(Unsupported { node, load }) = unsupported(system, &draft.state) else { return Ok(()) };
    let message = format!(
        "there is no equilibrium: nothing holds the part of the web with {}, which bears {load:.4} N",
        draft.cut.node_label(node)
    );
    let help = "hold it by [hold], or leave what bears on it out";
    Err(draft.document.diagnostic("solve.static", message).with_help(help).into())
}
