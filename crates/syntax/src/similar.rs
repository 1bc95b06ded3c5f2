//! Suggestions for misspelled names.

/// The candidate that is most similar to `name`; `None` if none is similar enough.
///
/// ```
/// use torse_syntax::similar::similar;
/// assert_eq!(similar("beizer", ["bezier", "hermite"]), Some("bezier"));
/// assert_eq!(similar("beizer", ["gbt"]), None);
/// assert_eq!(similar("e", ["D"]), None);
/// ```
#[must_use]
pub fn similar<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let near = candidates.into_iter();
    near.map(|candidate| (edit_distance(name, candidate), candidate))
        // A name that shares no letter is not similar.
        .filter(|(distance, candidate)| {
            let longer = candidate.chars().count().max(name.chars().count());
            *distance <= 1 + candidate.len() / 4 && *distance < longer
        })
        .min()
        .map(|(_, candidate)| candidate)
}

/// The Levenshtein distance.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        for (y, slot) in b.iter().zip(row.iter_mut().skip(1)) {
            let cost = (diagonal + usize::from(x != *y))
                .min(left + 1)
                .min(*slot + 1);
            diagonal = *slot;
            *slot = cost;
            left = cost;
        }
        if let Some(first) = row.first_mut() {
            *first = i + 1;
        }
    }
    row.last().copied().unwrap_or(0)
}
