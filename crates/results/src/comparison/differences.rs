//! Inputs that differ between designs.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::Entrant;
use super::table::merged;

/// The input that names a design; it is not compared.
const TITLE: &str = "title";

/// An input that is not the same in all designs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Difference {
    /// Path in the scenario.
    pub path: String,
    /// Value in each design, as written; null if the design does not have the input.
    pub values: Map<String, Value>,
}

/// All inputs that differ, in the order of the scenarios.
pub(super) fn differences(entrants: &[Entrant]) -> Vec<Difference> {
    let paths = merged(entrants.iter().map(|entrant| entrant.inputs.iter().map(|(path, _)| path.as_str())));
    let value = |entrant: &Entrant, path: &str| {
        let input = entrant.inputs.iter().find(|(known, _)| known == path);
        input.map_or(Value::Null, |(_, value)| value.clone())
    };
    let all = paths.into_iter().filter(|path| *path != TITLE).map(|path| Difference {
        path: path.to_owned(),
        values: entrants.iter().map(|entrant| (entrant.name.clone(), value(entrant, path))).collect(),
    });
    all.filter(|difference| {
        let mut values = difference.values.values();
        values.next().is_some_and(|first| values.any(|other| other != first))
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::summary::SummaryFile;

    fn entrant(name: &str, inputs: &[(&str, Value)]) -> Entrant {
        let inputs = inputs.iter().map(|(path, value)| (path.to_string(), value.clone())).collect();
        Entrant { name: name.into(), summary: SummaryFile::default(), inputs, failure: None }
    }

    #[test]
    fn only_differing_inputs_are_listed_and_a_missing_input_is_null() {
        let entrants = [
            entrant(
                "a",
                &[("title", json!("A")), ("web.space.side", json!("2.5 m")), ("rope.diameter", json!("10 mm"))],
            ),
            entrant(
                "b",
                &[("title", json!("B")), ("web.square.side", json!("2.5 m")), ("rope.diameter", json!("10 mm"))],
            ),
            entrant("c", &[("web.space.side", json!("2 m")), ("rope.diameter", json!("10 mm"))]),
        ];
        let found: Vec<(String, Value)> =
            differences(&entrants).into_iter().map(|d| (d.path, Value::Object(d.values))).collect();
        assert_eq!(
            found,
            [
                ("web.space.side".to_owned(), json!({"a": "2.5 m", "b": null, "c": "2 m"})),
                ("web.square.side".to_owned(), json!({"a": null, "b": "2.5 m", "c": null})),
            ]
        );
    }

    #[test]
    fn equal_inputs_have_no_differences() {
        let inputs = [("launch.axial_speed", json!("50 m/s")), ("tractors[0].corner", json!(3))];
        assert_eq!(differences(&[entrant("a", &inputs), entrant("b", &inputs)]), []);
    }
}
