//! The known name nearest to what was written.

/// The candidate nearest to `word`: the same letters in another case, else at most a third of the letters changed.
pub fn nearest<S: AsRef<str>>(word: &str, candidates: impl IntoIterator<Item = S>) -> Option<String> {
    let lower_case = word.to_lowercase();
    let allowed = word.chars().count().div_ceil(3);
    let mut best: Option<(usize, String)> = None;
    for candidate in candidates {
        let candidate = candidate.as_ref();
        let changes = match candidate.to_lowercase() == lower_case {
            true => 0,
            false => strsim::damerau_levenshtein(word, candidate),
        };
        if changes <= allowed && best.as_ref().is_none_or(|(fewest, _)| changes < *fewest) {
            best = Some((changes, candidate.to_string()));
        }
    }
    best.map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_is_found_and_a_stranger_is_not() {
        assert_eq!(nearest("sid", ["mesh", "side"]).as_deref(), Some("side"));
        assert_eq!(nearest("Side", ["sine", "side"]).as_deref(), Some("side"));
        assert_eq!(nearest("lengthsegment", ["side", "duration"]), None);
    }
}
