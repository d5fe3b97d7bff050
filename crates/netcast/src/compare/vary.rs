//! Variants of one scenario: `path=value,value,...` as after `--vary`, and all their combinations.

/// A combination of varied values: a design of each scenario.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Variant {
    /// What tells it from the others, such as `mass=60 g`; empty where nothing is varied.
    pub name: String,
    /// Its overrides, as after `--set`.
    pub overrides: Vec<String>,
}

/// All combinations of the values that are asked for, at most `most`, the last varied fastest; one without a name where none
/// are.
///
/// # Errors
/// Each text that is not a path with at least two values, and more combinations than a comparison holds.
pub(super) fn variants(asked: &[String], most: usize) -> Result<Vec<Variant>, Vec<String>> {
    let mut faults = Vec::new();
    let mut count = 1_usize;
    let mut varied = Vec::new();
    for text in asked {
        let (path, values) =
            text.split_once('=').map_or((&text[..], Vec::new()), |(path, all)| (path.trim(), split(all)));
        if path.is_empty() || values.len() < 2 || values.iter().any(|value| value.is_empty()) {
            let expected = "expected a path and at least two values, such as tractor.particle.mass=60g,120g";
            faults.push(format!("--vary {text}: {expected}"));
        }
        count = count.saturating_mul(values.len().max(1));
        varied.push((path, values));
    }
    if count > most {
        faults.push(format!("--vary asks for {count} variants of each scenario; a comparison has at most {most}"));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut variants = vec![Variant::default()];
    for (path, values) in varied {
        let with = |variant: &Variant, value: &str| Variant {
            name: joined(&variant.name, &format!("{}={}", last_key(path), bare(value))),
            overrides: variant.overrides.iter().cloned().chain([format!("{path}={value}")]).collect(),
        };
        variants = variants.iter().flat_map(|variant| values.iter().map(|value| with(variant, value))).collect();
    }
    Ok(variants)
}

/// Two parts of a name, one of which may be empty.
pub(super) fn joined(first: &str, second: &str) -> String {
    if first.is_empty() || second.is_empty() { format!("{first}{second}") } else { format!("{first}, {second}") }
}

/// The values of a list. A comma in quotes, brackets or braces separates none.
fn split(list: &str) -> Vec<&str> {
    let (mut values, mut start, mut depth, mut quote) = (Vec::new(), 0, 0_i32, None);
    for (at, character) in list.char_indices() {
        match (quote, character) {
            (Some(open), _) if character == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(character),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth -= 1,
            (None, ',') if depth == 0 => {
                values.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    values.push(list[start..].trim());
    values
}

/// The key at the end of a path.
fn last_key(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// A value as a part of the name of a folder: without quotes, and without what separates folders.
fn bare(value: &str) -> String {
    value
        .trim_matches(['"', '\''])
        .chars()
        .map(|c| if matches!(c, '/' | '\\' | ':') { '_' } else { c })
        .take(60)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_multiply_and_are_named_by_what_varies() {
        let asked = ["tractor.particle.mass=60g,120g", "launch.axial_speed=\"30 m/s\",40 m/s"].map(str::to_owned);
        let found = variants(&asked, 12).unwrap();
        let names: Vec<&str> = found.iter().map(|variant| &variant.name[..]).collect();
        let slow_and_fast = ["axial_speed=30 m_s", "axial_speed=40 m_s"];
        let expected: Vec<String> =
            ["60g", "120g"].iter().flat_map(|m| slow_and_fast.map(|v| format!("mass={m}, {v}"))).collect();
        assert_eq!(names, expected);
        assert_eq!(found[3].overrides, ["tractor.particle.mass=120g", "launch.axial_speed=40 m/s"]);
        assert_eq!(variants(&[], 12).unwrap(), [Variant::default()]);
    }

    #[test]
    fn a_comma_in_quotes_or_brackets_separates_no_values() {
        assert_eq!(
            split("[0, 1, 2], {a = 1, b = 2},\"x, y\", 'z,'"),
            ["[0, 1, 2]", "{a = 1, b = 2}", "\"x, y\"", "'z,'"]
        );
    }

    #[test]
    fn a_single_value_no_path_and_too_many_variants_are_refused() {
        let wrong = ["a.b=1", "=1,2", "a.b", "a.b=1,,2"].map(str::to_owned);
        assert_eq!(variants(&wrong, 12).unwrap_err().len(), wrong.len());
        let many = vec!["a=1,2,3,4".to_owned(), "b=1,2,3,4".to_owned()];
        assert!(variants(&many, 12).unwrap_err()[0].contains("16 variants"));
    }
}
