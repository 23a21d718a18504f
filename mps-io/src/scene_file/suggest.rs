//! Which word was meant.

/// The candidate that was most likely meant by a mistyped word: at most every third letter wrong.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let nearest = candidates
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(word, candidate), candidate))
        .min_by_key(|(distance, _)| *distance)?;
    let reach = word.chars().count().div_ceil(3);
    (nearest.0 <= reach).then_some(nearest.1)
}

/// "did you mean `this`?" if something is close, else what there is.
pub(super) fn advice(word: &str, candidates: &[&str]) -> String {
    match closest(word, candidates.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None if candidates.is_empty() => "leave it out".to_owned(),
        None => format!("allowed are {}", candidates.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_of_the_keyboard_are_understood_and_other_words_are_not() {
        let keys = ["spacing", "density", "viscosity", "numerics"];
        for (typed, meant) in [("spcing", "spacing"), ("desnity", "density"), ("viscosty", "viscosity")] {
            assert_eq!(closest(typed, keys), Some(meant));
        }
        assert_eq!(closest("temperature", keys), None);
        assert_eq!(closest("x", []), None);
        assert_eq!(advice("colour", &["red", "blue"]), "allowed are red, blue");
    }
}
