//! Finds the known name that is most similar to a misspelt one.

/// The longest word that is compared, in characters. Comparing two words takes time and memory in proportion to the
/// product of their lengths, and a longer word is not a spelling mistake.
const LONGEST: usize = 100;

/// The candidate most similar to `word`: it differs in case only, or in at most a third of its characters. `None`
/// where there is none, and for a word of more than 100 characters.
pub fn nearest<S: AsRef<str>>(word: &str, candidates: impl IntoIterator<Item = S>) -> Option<String> {
    let length = word.chars().take(LONGEST + 1).count();
    if length > LONGEST {
        return None;
    }
    let lower_case = word.to_lowercase();
    let allowed = length.div_ceil(3);
    let mut best: Option<(usize, String)> = None;
    for candidate in candidates {
        let candidate = candidate.as_ref();
        // a difference in length is a lower bound of the number of changes
        if candidate.chars().take(length + allowed + 1).count().abs_diff(length) > allowed {
            continue;
        }
        let differs_in_case_only = candidate.to_lowercase() == lower_case;
        let changes = if differs_in_case_only { 0 } else { strsim::damerau_levenshtein(word, candidate) };
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
    fn a_misspelt_word_is_found_and_another_word_is_not() {
        assert_eq!(nearest("sid", ["mesh", "side"]).as_deref(), Some("side"));
        assert_eq!(nearest("Side", ["sine", "side"]).as_deref(), Some("side"));
        assert_eq!(nearest("lengthsegment", ["side", "duration"]), None);
        assert_eq!(nearest("sidelong", ["side"]), None);
    }

    /// Two words of a megabyte would have taken eight terabytes to compare.
    #[test]
    fn a_word_of_a_megabyte_is_compared_with_nothing() {
        let long = "m".repeat(1 << 20);
        assert_eq!(nearest(&long, [&long, "m"]), None);
        assert_eq!(nearest("m", [&long]), None);
    }
}
