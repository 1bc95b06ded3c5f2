//! The library that is written by hand.

/// The library: the file that statements use, and the files that proofs use, in the order in which they need each other.
pub const LIBRARY: [(&str, &str); 20] = [
    ("Torse/Defs.v", include_str!("../../../proofs/Torse/Defs.v")),
    (
        "Torse/Series.v",
        include_str!("../../../proofs/Torse/Series.v"),
    ),
    (
        "Torse/Theory.v",
        include_str!("../../../proofs/Torse/Theory.v"),
    ),
    (
        "Torse/Bounds.v",
        include_str!("../../../proofs/Torse/Bounds.v"),
    ),
    (
        "Torse/Tactics.v",
        include_str!("../../../proofs/Torse/Tactics.v"),
    ),
    (
        "Torse/Exponentials.v",
        include_str!("../../../proofs/Torse/Exponentials.v"),
    ),
    (
        "Torse/Signs.v",
        include_str!("../../../proofs/Torse/Signs.v"),
    ),
    ("Torse/Sums.v", include_str!("../../../proofs/Torse/Sums.v")),
    (
        "Torse/Combinations.v",
        include_str!("../../../proofs/Torse/Combinations.v"),
    ),
    (
        "Torse/Unknowns.v",
        include_str!("../../../proofs/Torse/Unknowns.v"),
    ),
    (
        "Torse/Stages.v",
        include_str!("../../../proofs/Torse/Stages.v"),
    ),
    (
        "Torse/Rationals.v",
        include_str!("../../../proofs/Torse/Rationals.v"),
    ),
    (
        "Torse/Solved.v",
        include_str!("../../../proofs/Torse/Solved.v"),
    ),
    (
        "Torse/Forms.v",
        include_str!("../../../proofs/Torse/Forms.v"),
    ),
    (
        "Torse/Consequences.v",
        include_str!("../../../proofs/Torse/Consequences.v"),
    ),
    (
        "Torse/Radicals.v",
        include_str!("../../../proofs/Torse/Radicals.v"),
    ),
    (
        "Torse/Bernstein.v",
        include_str!("../../../proofs/Torse/Bernstein.v"),
    ),
    (
        "Torse/Mixed.v",
        include_str!("../../../proofs/Torse/Mixed.v"),
    ),
    (
        "Torse/Smooth.v",
        include_str!("../../../proofs/Torse/Smooth.v"),
    ),
    ("Torse/Ends.v", include_str!("../../../proofs/Torse/Ends.v")),
];
