//! The hand-written library.

/// The library: the file that statements use, and the files that proofs use, in the order of their dependencies.
pub const LIBRARY: [(&str, &str); 24] = [
    ("Torse/Defs.v", include_str!("../proofs/Torse/Defs.v")),
    ("Torse/Series.v", include_str!("../proofs/Torse/Series.v")),
    ("Torse/Theory.v", include_str!("../proofs/Torse/Theory.v")),
    ("Torse/Bounds.v", include_str!("../proofs/Torse/Bounds.v")),
    ("Torse/Tactics.v", include_str!("../proofs/Torse/Tactics.v")),
    (
        "Torse/Exponentials.v",
        include_str!("../proofs/Torse/Exponentials.v"),
    ),
    ("Torse/Signs.v", include_str!("../proofs/Torse/Signs.v")),
    ("Torse/Sums.v", include_str!("../proofs/Torse/Sums.v")),
    (
        "Torse/Combinations.v",
        include_str!("../proofs/Torse/Combinations.v"),
    ),
    (
        "Torse/Unknowns.v",
        include_str!("../proofs/Torse/Unknowns.v"),
    ),
    ("Torse/Stages.v", include_str!("../proofs/Torse/Stages.v")),
    (
        "Torse/Rationals.v",
        include_str!("../proofs/Torse/Rationals.v"),
    ),
    ("Torse/Solved.v", include_str!("../proofs/Torse/Solved.v")),
    ("Torse/Forms.v", include_str!("../proofs/Torse/Forms.v")),
    (
        "Torse/Consequences.v",
        include_str!("../proofs/Torse/Consequences.v"),
    ),
    (
        "Torse/Radicals.v",
        include_str!("../proofs/Torse/Radicals.v"),
    ),
    (
        "Torse/Bernstein.v",
        include_str!("../proofs/Torse/Bernstein.v"),
    ),
    ("Torse/Mixed.v", include_str!("../proofs/Torse/Mixed.v")),
    ("Torse/Smooth.v", include_str!("../proofs/Torse/Smooth.v")),
    ("Torse/Planes.v", include_str!("../proofs/Torse/Planes.v")),
    ("Torse/Ends.v", include_str!("../proofs/Torse/Ends.v")),
    ("Torse/Joins.v", include_str!("../proofs/Torse/Joins.v")),
    ("Torse/Hermite.v", include_str!("../proofs/Torse/Hermite.v")),
    (
        "Torse/Positive.v",
        include_str!("../proofs/Torse/Positive.v"),
    ),
];

/// Returns for each file of the library the positions of those that it requires.
pub(crate) fn needs() -> Vec<Vec<usize>> {
    let place = |name: &str| {
        let path = format!("Torse/{name}.v");
        LIBRARY.iter().position(|(own, _)| *own == path)
    };
    let needed = |text| required(text).filter_map(place).collect();
    LIBRARY.iter().map(|(_, text)| needed(text)).collect()
}

/// Returns the names after `From Torse Require Import`.
fn required(text: &str) -> impl Iterator<Item = &str> {
    let commands = text.split("From Torse Require Import ").skip(1);
    let names = commands.filter_map(|rest| rest.split_once('.'));
    names.flat_map(|(names, _)| names.split_whitespace())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use super::*;

    #[test]
    fn a_file_requires_files_before_it_and_all_require_the_definitions() {
        for (place, needed) in needs().iter().enumerate() {
            let (path, text) = LIBRARY[place];
            assert!(needed.iter().all(|other| *other < place), "{path}");
            assert_eq!(needed.contains(&0), place > 0, "{path}");
            // Every name is one of the library, and there is no other way to require one.
            assert_eq!(required(text).count(), needed.len(), "{path}");
            let others = text.matches("From Torse").count() + text.matches("Torse.").count();
            assert_eq!(others, usize::from(place > 0), "{path}");
        }
        let named = required("From Torse Require Import Defs Sums.\nFrom Coq Require Import Lra.");
        assert_eq!(named.collect::<Vec<_>>(), ["Defs", "Sums"]);
    }
}
