//! `[[cuts]]`: ropes that are cut at a time.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative};
use crate::quantity::{Number, Time};

/// A cut through a rope at a given time, whatever its tension: one segment of it is gone from then on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cut {
    /// The link that is cut, by the names of `[assign]`: of one link, or of a class or a ring, of which every link is cut.
    pub link: String,
    /// Time of the cut, s.
    pub time: Time<NonNegative>,
    /// Where along the link, as a share of its length from the node that its row names first. Default: 0.5.
    #[serde(default = "middle")]
    pub at: Number<Fraction>,
}

const fn middle() -> Number<Fraction> {
    Number::constant(0.5)
}
