//! Lists the values of a scenario under their dotted paths, so that two scenarios can be compared.

use netcast_scenario::path::Path;
use netcast_scenario::tree::Value;
use serde_json::Value as Json;

/// Appends every value within `value` under its dotted path; `path` is that of `value`.
pub(crate) fn flatten(path: &Path, value: &Value, into: &mut Vec<(String, Json)>) {
    match value {
        // leave out an empty section, but keep an empty variant such as `[stow.roll]`, which is a choice
        Value::Table(table) if table.0.is_empty() && path.0.len() > 1 => into.push((path.to_string(), json(value))),
        Value::Table(table) => {
            for entry in &table.0 {
                flatten(&path.key(&entry.key), &entry.node.value, into);
            }
        }
        Value::Array(elements) if elements.iter().any(|element| element.value.as_table().is_some()) => {
            for (i, element) in elements.iter().enumerate() {
                flatten(&path.index(i), &element.value, into);
            }
        }
        leaf => into.push((path.to_string(), json(leaf))),
    }
}

fn json(value: &Value) -> Json {
    match value {
        Value::String(text) => Json::from(text.as_str()),
        Value::Integer(number) => Json::from(*number),
        Value::Float(number) => Json::from(*number),
        Value::Boolean(value) => Json::from(*value),
        Value::Datetime(datetime) => Json::from(datetime.to_string()),
        Value::Array(elements) => elements.iter().map(|element| json(&element.value)).collect(),
        Value::Table(table) => table.0.iter().map(|entry| (entry.key.clone(), json(&entry.node.value))).collect(),
    }
}

#[cfg(test)]
mod tests {
    use netcast_scenario::tree::Tree;

    use super::*;

    #[test]
    fn values_are_listed_by_path_with_their_units() {
        let tree = Tree::parse(
            "title = \"x\"\n[web.graph]\noutline = [\"n1\", \"n2\"]\n[stow.roll]\n[measure]\n[[tractors]]\ncorner = 3\n\
             axial_speed = \"5 m/s\"\n[points]\n\"knot 3\" = \"n4\"\n",
        );
        let mut found = Vec::new();
        flatten(&Path::default(), &tree.unwrap().root.value, &mut found);
        let listed: Vec<String> = found.iter().map(|(path, value)| format!("{path}={value}")).collect();
        assert_eq!(
            listed,
            [
                "title=\"x\"",
                "web.graph.outline=[\"n1\",\"n2\"]",
                "stow.roll={}",
                "tractors[0].corner=3",
                "tractors[0].axial_speed=\"5 m/s\"",
                "points.\"knot 3\"=\"n4\"",
            ]
        );
    }
}
