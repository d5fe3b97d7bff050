//! The known name nearest to what was written.

/// The longest word that is looked for, in characters: comparing two takes the product of their lengths in time and
/// memory, and what is longer is no slip of the pen.
const LONGEST: usize = 100;

/// The candidate nearest to `word`: the same letters in another case, else at most a third of the letters changed. None
/// for a word of more than 100 characters.
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
        // every character more or less is a change
        if candidate.chars().take(length + allowed + 1).count().abs_diff(length) > allowed {
            continue;
        }
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
