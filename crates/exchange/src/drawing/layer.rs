//! The layers of a drawing.

/// What a path is for; each is a layer of its own in the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layer {
    /// What is cut.
    Outline,
    /// Rulings: along these lines the sheet stays straight.
    Rulings,
    /// Bend lines, towards the viewer.
    BendUp,
    /// Bend lines, away from the viewer.
    BendDown,
    /// The edge of regression, which must not lie in the sheet.
    Regression,
    /// Marks and lettering.
    Marks,
}

impl Layer {
    /// All layers, in the order of the files.
    pub const ALL: [Self; 6] = [
        Self::Outline,
        Self::Rulings,
        Self::BendUp,
        Self::BendDown,
        Self::Regression,
        Self::Marks,
    ];

    /// The name in the files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Outline => "OUTLINE",
            Self::Rulings => "RULINGS",
            Self::BendUp => "BEND_UP",
            Self::BendDown => "BEND_DOWN",
            Self::Regression => "REGRESSION",
            Self::Marks => "MARKS",
        }
    }

    /// The layer of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|layer| layer.name() == name)
    }
}
