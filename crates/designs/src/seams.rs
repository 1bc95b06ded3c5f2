//! Edges of patches, and which of them meet.

/// An edge of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatchEdge {
    /// The first ruling.
    Start,
    /// The last ruling.
    End,
    /// The first rail.
    First,
    /// The second rail.
    Second,
}

impl PatchEdge {
    /// All with their names in files.
    pub const ALL: [(&'static str, Self); 4] = [
        ("start", Self::Start),
        ("end", Self::End),
        ("first", Self::First),
        ("second", Self::Second),
    ];

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, edge)| *edge == self);
        found.map_or("start", |(name, _)| name)
    }
}

/// An edge of an entry under `[patches]`, as a seam names it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeName {
    /// As the file writes it: `side.first`.
    pub text: String,
    /// The patches along the edge in their order; for the first or the last ruling of several, one.
    pub patches: Vec<usize>,
    /// The edge of each of them.
    pub edge: PatchEdge,
}

impl EdgeName {
    /// Returns whether both have an edge of a patch in common.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.edge == other.edge
            && self
                .patches
                .iter()
                .any(|patch| other.patches.contains(patch))
    }
}

/// Two edges that are sewn, welded or glued together.
#[derive(Debug, Clone, PartialEq)]
pub struct Seam {
    /// The edges; both run from the point with the smaller parameter.
    pub edges: [EdgeName; 2],
    /// By how much the first is longer on purpose, in millimetres.
    pub ease: f64,
}
