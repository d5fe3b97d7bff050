//! Checks that a web has the equilibrium that `solve.static` asks for.

use netcast_dynamics::statics::{Unsupported, unsupported};
use netcast_scenario::Diagnostics;

use super::draft::Draft;

/// Checks that every loaded part of the web is held.
///
/// # Errors
/// An orbit, or a loaded part that nothing holds.
pub fn check(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Some((system, _)) = draft.system.as_ref().filter(|_| draft.scenario.solve.statics.is_some()) else {
        return Ok(());
    };
    if system.environment().orbit.is_some() {
        let message = "in an orbit there is no equilibrium to find";
        return Err(draft.document.diagnostic("solve.static", message).with_help("leave it out").into());
    }
    let Some(Unsupported { node, load }) = unsupported(system, &draft.state) else { return Ok(()) };
    let message = format!(
        "there is no equilibrium: nothing holds the part of the web with {}, which bears {load:.4} N",
        draft.cut.node_label(node)
    );
    let help = "hold it by [hold], or remove the load on it";
    Err(draft.document.diagnostic("solve.static", message).with_help(help).into())
}
