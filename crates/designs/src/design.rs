//! What a design file says: patches, chains of them, and what is demanded.

use crate::DesignUnit;
use crate::bending::Bending;
use crate::covers::SurfaceCover;
use crate::error::DesignError;
use crate::seams::{PatchEdge, Seam};
use std::ops::Range;
use torse_geometry::basis::BasisShape;
use torse_geometry::pattern::BendingSheet as Metal;
use torse_geometry::prelude::{PiecewiseRail, Planes, Point, Rail, Sheet};
use torse_geometry::{Rails, TensorSurface};

/// A design: everything in millimetres and radians.
#[derive(Debug, Clone)]
pub struct Design {
    /// The name of the file without its ending.
    pub name: String,
    /// The title; the name where none is given.
    pub title: String,
    /// The unit that the file is written in.
    pub unit: DesignUnit,
    /// What it is made of, if that is said.
    pub metal: Option<Material>,
    /// What the sheet is of, in words, if that is said.
    pub material: Option<String>,
    /// How blanks are found where it is bent.
    pub bending: Bending,
    /// What is demanded.
    pub tolerances: Tolerances,
    /// How it is looked at.
    pub view: DesignView,
    /// The patches in the order of the file.
    pub patches: Vec<Patch>,
    /// The chains in the order of the file.
    pub chains: Vec<Chain>,
    /// What is cut beyond every edge that has no allowance of its own, in millimetres.
    pub allowance: f64,
    /// The edges that meet.
    pub seams: Vec<Seam>,
    /// What is worth knowing of the files that it takes curves from.
    pub notes: Vec<String>,
    /// The faces of a file of another program that have no patch.
    pub left_out: Vec<LeftOut>,
    /// Surfaces that are not unrolled, in the order of the file.
    pub surfaces: Vec<FreeSurface>,
    /// The surfaces that strips cover, in the order of the file.
    pub covers: Vec<SurfaceCover>,
    /// The points whose coordinates stand in the text, in the order in which they are read.
    pub points: Vec<DesignPoint>,
}

/// A point whose coordinates stand in the text of a design: what an editor lets its user drag.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignPoint {
    /// What it belongs to: its own name, or that of the curve or the patch.
    pub name: String,
    /// Its number there, from 1; 0 for a point with a name of its own.
    pub number: usize,
    /// Where it is, in millimetres.
    pub at: [f64; 3],
    /// Where its coordinates stand in the text, in bytes: numbers, or formulas in quotes.
    pub places: [Range<usize>; 3],
    /// Whether each is a number; formulas hang on other numbers.
    pub plain: [bool; 3],
}

/// A face of a file of another program that has no patch.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
#[non_exhaustive]
pub struct LeftOut {
    /// Its name; of what is not read its kind, and how many there are.
    pub name: String,
    /// Why.
    pub reason: String,
}

/// Sheet metal, or what else is bent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Thickness and K-factor.
    pub sheet: Metal,
    /// The least inside radius, as a multiple of the thickness.
    pub least_radius: f64,
}

/// What is demanded of a design; lengths in millimetres, angles in degrees as in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// The largest distance of the cut outline from the exact development.
    pub outline: f64,
    /// The strain up to which a patch counts as developable when it is unrolled.
    pub strain: f64,
    /// The largest angle between the tangent planes at the ends of a ruling.
    pub twist: f64,
    /// The least distance of the edge of regression from the patch.
    pub clearance: f64,
    /// The largest distance of corresponding ends of rulings at a joint.
    pub gap: f64,
    /// The largest angle between the tangent planes at a joint that should be smooth.
    pub kink: f64,
    /// What counts as zero of a derivative at a joint, as a share of its length.
    pub continuity: f64,
    /// The distance of surfaces in files that hold no exact form, and of meshes.
    pub surface: f64,
    /// By how much a pattern that was folded back may miss the design.
    pub fold: Option<f64>,
}

impl Tolerances {
    /// What is demanded where a file says nothing.
    pub const USUAL: Self = Self {
        outline: 0.01,
        strain: torse_geometry::pattern::DEVELOPABLE_STRAIN,
        twist: 0.1,
        clearance: 0.0,
        gap: 1e-3,
        kink: 0.1,
        continuity: 1e-9,
        surface: 0.01,
        fold: None,
    };
}

/// How a design is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignView {
    /// Azimuth and elevation in degrees; chosen from the patches where none are given.
    pub angles: Option<[f64; 2]>,
    /// How many rulings of a patch are shown, in pictures and in patterns.
    pub rulings: usize,
}

/// The rulings of a patch that are shown where a file says nothing.
pub const USUAL_RULINGS: usize = 17;

/// A patch.
#[derive(Debug, Clone)]
pub struct Patch {
    /// Its name.
    pub name: String,
    /// How it was made, in a word.
    pub kind: &'static str,
    /// The surface, trimmed.
    pub sheet: Sheet,
    /// The closed curve in space that bounds it, where its rails and end rulings do not: of a plane face of a file.
    pub border: Option<NamedCurve>,
    /// What is joined at its ends.
    pub ends: PatchEnds,
    /// What is marked on it.
    pub marks: Vec<Mark>,
    /// Whether it is bent at one line, over a tool, and not rolled.
    pub bend: bool,
    /// Its own names of its edges.
    pub edges: Vec<(String, PatchEdge)>,
    /// What is cut beyond those of its edges that have an allowance of their own, in millimetres.
    pub allowances: Vec<(PatchEdge, f64)>,
    /// What else is worth knowing: which developable was chosen, how much of the curves it uses.
    pub notes: Vec<String>,
}

/// A tensor-product surface.
pub type Tensor = TensorSurface<BasisShape<f64>, BasisShape<f64>, f64>;

/// A surface in general, which is shown and exported but not unrolled: nothing certifies that it is developable.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeSurface {
    /// Its name.
    pub name: String,
    /// How it was made, in a word.
    pub kind: &'static str,
    /// The tensor products that it consists of: four for a whole rotation, else one.
    pub parts: Vec<Tensor>,
}

/// What determines how a patch meets its neighbours.
#[derive(Debug, Clone)]
pub struct PatchEnds {
    /// The family of tangent planes, if the patch is given by one.
    pub planes: Option<Planes>,
    /// The rails, if the patch is given by them.
    pub rails: Option<[Rail; 2]>,
    /// The part of them that the patch uses.
    pub part: [f64; 2],
}

/// Something on a patch, at places `[u, v]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A polygon on the parameters, drawn and not cut.
    Line(Vec<[f64; 2]>),
    /// A hole that is round on the sheet: its centre and radius.
    Hole([f64; 2], f64),
    /// A circle that is round on the sheet, drawn and not cut: its centre and radius.
    Circle([f64; 2], f64),
    /// Lettering that starts at a place: the text, its height, and its direction against the ruling in radians.
    Text([f64; 2], String, f64, f64),
    /// An opening of any shape.
    Opening(MarkedOpening),
}

impl Mark {
    /// Returns whether something is cut out there.
    #[must_use]
    pub fn is_opening(&self) -> bool {
        matches!(self, Self::Hole(..) | Self::Opening(_))
    }
}

/// An opening of any closed shape, as a file gives it.
#[derive(Debug, Clone, PartialEq)]
pub enum MarkedOpening {
    /// A plane curve on the flat sheet.
    OnSheet {
        /// The curve; it lies in the plane of x and y.
        curve: NamedCurve,
        /// The place `[u, v]` of its origin.
        at: [f64; 2],
        /// The direction of its first axis against the ruling, in radians.
        angle: f64,
    },
    /// A polygon on the parameters, side by side.
    OnParameters(Vec<ParameterSide>),
    /// A curve in space: it lies on the piece, or is thrown on it along a direction.
    InSpace {
        /// The curve.
        curve: NamedCurve,
        /// The direction; none where the curve lies on the piece.
        along: Option<Point>,
    },
    /// Where other patches pass through.
    Passed {
        /// The patch or the chain, as the file names it.
        name: String,
        /// Where the name stands in the text, in bytes.
        place: Range<usize>,
        /// The indices of its patches.
        patches: Vec<usize>,
    },
}

/// A curve with its name in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedCurve {
    /// The name.
    pub name: String,
    /// The curve.
    pub curve: PiecewiseRail,
}

/// A side of a polygon on the parameters of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterSide {
    /// How many patches after the one that is marked it lies: of an entry with curves of several pieces.
    pub after: isize,
    /// The places `[u, v]` of its ends.
    pub ends: [[f64; 2]; 2],
}

/// Patches in a row.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// Its name.
    pub name: String,
    /// The indices of its patches.
    pub patches: Vec<usize>,
    /// What is demanded of every joint.
    pub continuity: Option<Smoothness>,
    /// Whether the last patch meets the first.
    pub closed: bool,
    /// How the patches are laid out.
    pub layout: ChainLayout,
    /// The inside radius in millimetres over which each joint with an edge is bent, where it is bent over one.
    pub radii: Vec<Option<f64>>,
}

/// How smooth a joint is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Smoothness {
    /// The ends of the rulings meet.
    G0,
    /// The tangent planes agree as well.
    G1,
    /// The curvature too: of plane families, points of regression.
    G2,
    /// Derivatives up to this order agree.
    C(usize),
}

impl Smoothness {
    /// All with their names in files.
    pub const ALL: [(&'static str, Self); 6] = [
        ("G0", Self::G0),
        ("G1", Self::G1),
        ("G2", Self::G2),
        ("C1", Self::C(1)),
        ("C2", Self::C(2)),
        ("C3", Self::C(3)),
    ];

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, known)| *known == self);
        found.map_or("G0", |(name, _)| name)
    }
}

/// How the patches of a chain are laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChainLayout {
    /// Neighbours share their ruling: one piece.
    Attached,
    /// Each is a piece of its own.
    Apart,
}

/// Patches that are unrolled as one piece.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DesignPiece {
    /// The name of the chain or of the patch.
    pub name: String,
    /// The patches in order.
    pub patches: Vec<usize>,
}

impl DesignPiece {
    /// Returns whether tools bend it: a patch is said to be a bend, or edges have a radius. Then its blank differs from
    /// its development.
    #[must_use]
    pub fn has_tool_bends(&self, design: &Design) -> bool {
        let mut patches = self.patches.iter();
        let bent = |index: &usize| design.patches.get(*index).is_some_and(|patch| patch.bend);
        let mut chains = design.chains.iter().filter(|chain| chain.name == self.name);
        patches.any(bent) || chains.any(|chain| chain.radii.iter().any(Option::is_some))
    }
}

impl Patch {
    /// Rails that are a point: the apex of a cone, the corner of a triangle.
    #[must_use]
    pub fn apexes(&self) -> [bool; 2] {
        Rails::<f64>::end_kinds(&self.sheet).apexes()
    }
}

impl Design {
    /// Returns why no piece has a name: it is that of a face that is left out, or of nothing.
    pub(crate) fn without(&self, name: &str, known: Vec<String>) -> DesignError {
        match self.left_out.iter().find(|face| face.name == name) {
            Some(face) => DesignError::LeftOut {
                name: name.to_owned(),
                reason: face.reason.clone(),
            },
            None => DesignError::NoSuch {
                what: "piece",
                name: name.to_owned(),
                known,
            },
        }
    }

    /// Whether a piece is cut along a border of its own: then rails and end rulings are none of its edges, and it has no rulings.
    pub(crate) fn has_border(&self, piece: &DesignPiece) -> bool {
        let mut patches = piece.patches.iter();
        patches.any(|index| {
            let patch = self.patches.get(*index);
            patch.is_some_and(|patch| patch.border.is_some())
        })
    }

    /// Returns the pieces that are cut: chains whose patches stay attached, and single patches.
    #[must_use]
    pub fn pieces(&self) -> Vec<DesignPiece> {
        let mut pieces: Vec<DesignPiece> = Vec::new();
        for chain in self
            .chains
            .iter()
            .filter(|c| c.layout == ChainLayout::Attached)
        {
            pieces.push(DesignPiece {
                name: chain.name.clone(),
                patches: chain.patches.clone(),
            });
        }
        for (index, patch) in self.patches.iter().enumerate() {
            if pieces.iter().all(|piece| !piece.patches.contains(&index)) {
                pieces.push(DesignPiece {
                    name: patch.name.clone(),
                    patches: vec![index],
                });
            }
        }
        pieces
    }

    /// Returns whether tools bend one of its pieces.
    #[must_use]
    pub fn has_tool_bends(&self) -> bool {
        self.pieces().iter().any(|piece| piece.has_tool_bends(self))
    }

    /// Returns the names of all patches and surfaces.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let patches = self.patches.iter().map(|patch| patch.name.clone());
        patches
            .chain(self.surfaces.iter().map(|s| s.name.clone()))
            .collect()
    }

    /// Returns the patch of this name.
    #[must_use]
    pub fn patch(&self, name: &str) -> Option<&Patch> {
        self.patches.iter().find(|patch| patch.name == name)
    }
}
