//! The entries of a design file, section by section: what the reader knows, and `designs/schema.json` describes.

/// A section and its entries.
pub type KeySection = (&'static str, &'static [&'static str]);

/// The sections of a file.
pub const TOP: &[&str] = &[
    "design",
    "let",
    "sheet",
    "tolerances",
    "view",
    "points",
    "planes",
    "curves",
    "families",
    "patches",
    "chains",
    "seams",
    "surfaces",
];
/// `[design]`.
pub const DESIGN: &[&str] = &["title", "unit", "about", "allowance"];
/// `[sheet]`.
pub const SHEET: &[&str] = &[
    "thickness",
    "material",
    "k-factor",
    "least-radius",
    "surface",
];
/// `[tolerances]`.
pub const TOLERANCES: &[&str] = &[
    "outline",
    "strain",
    "twist",
    "clearance",
    "gap",
    "kink",
    "continuity",
    "surface",
    "fold",
];
/// `[view]`.
pub const VIEW: &[&str] = &["azimuth", "elevation", "rulings"];
/// A plane that is no list of four numbers.
pub const PLANE: &[&str] = &["through", "point", "normal"];
/// `[curves.NAME]`.
pub const CURVE: &[&str] = &[
    "bezier",
    "gbt",
    "hermite",
    "arc",
    "shape",
    "weights",
    "continues",
    "join",
    "beta",
    "free",
    "spline",
    "through",
    "spacing",
    "ends",
    "polyline",
    "row",
    "import",
    "unit",
    "copy",
    "section",
    "reversed",
    "scale",
    "mirror",
    "rotate",
    "move",
];
/// An arc of an ellipse or of a circle.
pub const ARC: &[&str] = &["centre", "from", "to", "axis", "angle", "climb"];
/// A spline by its control points.
pub const SPLINE: &[&str] = &["degree", "points", "knots", "weights", "closed"];
/// The tangents at the ends of a spline through points.
pub const ENDS: &[&str] = &["start", "end"];
/// A stretch about a point.
pub const SCALE: &[&str] = &["about", "by"];
/// A turn about an axis.
pub const ROTATE: &[&str] = &["about", "axis", "angle"];
/// `[families.NAME]`.
pub const FAMILY: &[&str] = &[
    "bernstein",
    "gbt",
    "shape",
    "continues",
    "join",
    "beta",
    "scale",
    "free",
];
/// `[patches.NAME]`.
pub const PATCH: &[&str] = &[
    "ruled",
    "connect",
    "envelope",
    "tangent",
    "cylinder",
    "cone",
    "hermite",
    "continues",
    "strips",
    "between",
    "range",
    "direction",
    "apex",
    "join",
    "beta",
    "scale",
    "free",
    "shape",
    "branch",
    "panel",
    "part",
    "marks",
    "bend",
    "edges",
    "allowance",
];
/// A Hermite cone.
pub const HERMITE: &[&str] = &[
    "degree",
    "ratio",
    "summit",
    "q",
    "p-start",
    "p-middle",
    "p-middle-tangent",
    "q-ends",
    "q-tangents",
    "tension",
    "as-printed",
];
/// Strips that cover a surface.
pub const STRIPS: &[&str] = &["surface", "along", "within"];
/// A mark.
pub const MARK: &[&str] = &[
    "line", "hole", "text", "at", "radius", "height", "angle", "opening", "along", "passes",
];
/// `[chains.NAME]`.
pub const CHAIN: &[&str] = &["patches", "continuity", "closed", "layout", "radius"];

/// `[surfaces.NAME]`.
pub const SURFACE: &[&str] = &[
    "net", "bilinear", "swung", "swept", "rotation", "shape-u", "shape-v", "factor", "degrees",
    "interior", "matrices",
];

/// All of them by the names of their definitions in the schema.
pub const ALL: &[KeySection] = &[
    ("top", TOP),
    ("design", DESIGN),
    ("sheet", SHEET),
    ("tolerances", TOLERANCES),
    ("view", VIEW),
    ("plane", PLANE),
    ("curve", CURVE),
    ("arc", ARC),
    ("spline", SPLINE),
    ("ends", ENDS),
    ("scaling", SCALE),
    ("rotation", ROTATE),
    ("family", FAMILY),
    ("patch", PATCH),
    ("hermite", HERMITE),
    ("strips", STRIPS),
    ("mark", MARK),
    ("chain", CHAIN),
    ("surface", SURFACE),
];
