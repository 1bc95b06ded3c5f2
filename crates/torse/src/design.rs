//! Designs: files with control data of developables, or texts that stand for them.

use crate::error::Error;
use std::path::Path;
use torse_designs as rooms;
use torse_designs::eval::{EvalPlaces, EvalRow, eval};
use torse_designs::export::PATTERNS;
use torse_designs::fold::{FoldReport, fold_text};
use torse_designs::inspect::{DesignReport, inspect, inspect_quickly, inspect_within, table};
use torse_designs::listing::{FileListing, list};
use torse_designs::unroll::{
    Demand, FlatPiece, Part, PatternSummary, Purpose, drawing, parts, unroll,
};
use torse_exchange::{Drawing, LengthUnit, dxf, svg};
use torse_geometry::batch::par_ruled_grid_into;
use torse_geometry::prelude::{ConnectedSheets, MeasureBudget, Rail, Sheet};
use torse_plot::Picture;

/// Finds the developable surface between two curves: with tangent planes that touch both.
///
/// # Errors
/// [`Error::Geometry`] for curves of which nothing can be made.
///
/// ```
/// use torse::geometry::prelude::Rail;
/// let chine = Rail::bezier(&[[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]])?;
/// let deck = Rail::bezier(&[[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]])?;
/// let sheet = torse::connect(&chine, &deck)?.sheet.ok_or("no developable touches both")?;
/// let flat = sheet.unroll(64, 1e-6)?;
/// assert!(flat.errors().outline <= 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn connect(first: &Rail, second: &Rail) -> Result<ConnectedSheets, Error> {
    Ok(Sheet::between(first, second)?)
}

/// Lists the curves, faces and meshes of a file of another program: STEP, IGES, DXF, SVG, CSV, OBJ, STL. `unit` is that of
/// a file that states none.
///
/// # Errors
/// [`Error::Design`] for a file that cannot be read.
///
/// ```
/// let table = "x [mm],y,z\n0,0,0\n10,0,0\n20,5,0\n";
/// let listing = torse::contents("line.csv", table.as_bytes(), None)?;
/// assert_eq!(listing.curves.len(), 1);
/// # Ok::<(), torse::Error>(())
/// ```
pub fn contents(name: &str, bytes: &[u8], unit: Option<&LengthUnit>) -> Result<FileListing, Error> {
    let listing = list(name, bytes, unit);
    let failed = |reason| rooms::DesignError::Listing {
        path: name.to_owned(),
        reason,
    };
    Ok(listing.map_err(failed)?)
}

/// The most points of a grid of [`Design::points`].
const MAX_GRID_POINTS: usize = 1 << 24;

/// A design that was read: points, curves, patches and chains of them, in millimetres.
///
/// ```
/// let design = torse::Design::read("cone.toml", r#"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [30, 0, 0], to = [0, 30, 0] }
///     [patches.cone]
///     cone = "rim"
///     apex = [0, 0, 40]
///     range = [1, 0.5]
/// "#)?;
/// assert!(design.inspect()?.missed.is_empty());
/// let pattern = design.unroll()?;
/// // A sector of an annulus of radii 50 and 25.
/// let exact = std::f64::consts::PI * (30.0 * 50.0 - 15.0 * 25.0) / 4.0;
/// assert!((pattern.area() - exact).abs() < 1e-9);
/// assert!(pattern.dxf()?.contains("LWPOLYLINE"));
/// # Ok::<(), torse::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Design {
    read: rooms::Design,
}

/// The flat pattern of a design.
#[derive(Debug, Clone)]
pub struct Pattern {
    pieces: Vec<FlatPiece>,
    drawing: Drawing,
    summary: PatternSummary,
}

impl Design {
    /// Reads a design file.
    ///
    /// # Errors
    /// [`Error::Design`] with everything that is wrong in it.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, Error> {
        Ok(Self {
            read: rooms::load(path.as_ref())?,
        })
    }

    /// Reads the text of a design that names no other files.
    ///
    /// # Errors
    /// As [`Design::open`].
    ///
    /// ```
    /// let wrong = torse::Design::read("cone.toml", "[points]\nA = [0, 0]\n").unwrap_err();
    /// let place = wrong.place().ok_or("a mistake has a place")?;
    /// assert_eq!((place.line, place.column), (2, 5));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn read(name: &str, text: &str) -> Result<Self, Error> {
        Ok(Self {
            read: rooms::read(name, text)?,
        })
    }

    /// Reads the text of a design; `files` gives the bytes of the files that it names, or says why it has none.
    ///
    /// # Errors
    /// As [`Design::open`].
    pub fn read_with(
        name: &str,
        text: &str,
        files: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, Error> {
        Ok(Self {
            read: rooms::read_with(name, text, files)?,
        })
    }

    /// Reads the bytes of a file with this name: a design, or a file of another program, of which each face with
    /// rulings between two edges is a patch. Neither may name other files.
    ///
    /// # Errors
    /// As [`Design::open`].
    ///
    /// ```
    /// let tube = "[curves.rim]\narc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }\n\
    ///             [patches.tube]\ncylinder = 'rim'\ndirection = [0, 0, 30]\n";
    /// let step = torse::Design::read("tube.toml", tube)?.export("step", &Default::default())?;
    /// let faces = torse::Design::read_bytes("tube.step", &step)?;
    /// assert_eq!(faces.names().len(), 1);
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn read_bytes(name: &str, bytes: &[u8]) -> Result<Self, Error> {
        Ok(Self {
            read: rooms::load_from(Path::new(name), bytes)?,
        })
    }

    /// Its name: that of the file without the ending.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.read.name
    }

    /// Its title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.read.title
    }

    /// The names of its patches and surfaces.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.read.names()
    }

    /// Measures it: can it be made? With bounds and proofs.
    ///
    /// # Errors
    /// [`Error::Design`] for a patch that has no value where one is needed.
    pub fn inspect(&self) -> Result<DesignReport, Error> {
        Ok(inspect(&self.read)?)
    }

    /// The same with another budget for bounds and proofs.
    ///
    /// # Errors
    /// As [`Design::inspect`].
    pub fn inspect_within(&self, budget: MeasureBudget) -> Result<DesignReport, Error> {
        Ok(inspect_within(&self.read, budget)?)
    }

    /// Measures only, without bounds and proofs.
    ///
    /// # Errors
    /// As [`Design::inspect`].
    pub fn inspect_quickly(&self) -> Result<DesignReport, Error> {
        Ok(inspect_quickly(&self.read)?)
    }

    /// Unrolls it, if it is developable.
    ///
    /// # Errors
    /// [`Error::Design`] for what is not developable, has its edge of regression inside, or crosses itself.
    pub fn unroll(&self) -> Result<Pattern, Error> {
        self.unroll_as(&Demand::default())
    }

    /// Unrolls it with these wishes.
    ///
    /// # Errors
    /// As [`Design::unroll`], and for a piece that is not there.
    pub fn unroll_as(&self, demand: &Demand) -> Result<Pattern, Error> {
        let pieces = unroll(&self.read, demand)?;
        Ok(Pattern {
            drawing: drawing(&self.read, &pieces)?,
            summary: PatternSummary::new(&self.read, &pieces),
            pieces,
        })
    }

    /// Folds the text of a pattern file back into space and compares it with the design.
    ///
    /// # Errors
    /// [`Error::Design`] for a file that is no pattern.
    pub fn fold(&self, name: &str, pattern: &str) -> Result<FoldReport, Error> {
        Ok(fold_text(&self.read, name, pattern)?)
    }

    /// Points, normals and curvatures of all patches, or of one.
    ///
    /// # Errors
    /// [`Error::Design`] for a patch that is not there, or a place without a value.
    pub fn eval(&self, patch: Option<&str>, at: &EvalPlaces) -> Result<Vec<EvalRow>, Error> {
        Ok(eval(&self.read, patch, at)?)
    }

    /// The points of a patch alone, on a grid of so many equal steps from ruling to ruling and along rulings; the latter run
    /// fastest. A million take milliseconds.
    ///
    /// # Errors
    /// [`Error::Design`] for a patch that is not there, no steps or more than 2^24 points, [`Error::Geometry`] where
    /// the patch has no point.
    ///
    /// ```
    /// use torse::designs::eval::EvalPlaces;
    /// let design = torse::Design::read("tube.toml", r#"
    ///     [curves.rim]
    ///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
    ///     [patches.tube]
    ///     cylinder = "rim"
    ///     direction = [0, 0, 30]
    /// "#)?;
    /// let points = design.points("tube", [4, 2])?;
    /// let rows = design.eval(None, &EvalPlaces::Grid(4, 2))?;
    /// assert!(points.len() == 15 && points.iter().zip(&rows).all(|(point, row)| *point == row.point));
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn points(&self, patch: &str, [along, across]: [usize; 2]) -> Result<Vec<[f64; 3]>, Error> {
        let mut patches = self.read.patches.iter();
        let found = patches.find(|other| other.name == patch);
        let found = found.ok_or_else(|| rooms::DesignError::NoSuch {
            what: "patch",
            name: patch.to_owned(),
            known: self.read.patches.iter().map(|p| p.name.clone()).collect(),
        })?;
        let counts = [along, across].map(|steps| steps.saturating_add(1));
        let count = counts[0].saturating_mul(counts[1]);
        if along == 0 || across == 0 || count > MAX_GRID_POINTS {
            #[allow(clippy::cast_precision_loss, reason = "shown in a message")]
            let value = if along.min(across) == 0 {
                0.0
            } else {
                along.max(across) as f64
            };
            let (name, range) = ("steps of the grid", "1, 2, .. with 2^24 points at most");
            return Err(rooms::DesignError::OutOfRange { name, value, range }.into());
        }
        #[allow(clippy::cast_precision_loss, reason = "at most 2^24")]
        let steps = |steps: usize| -> Vec<f64> {
            let share = |step| step as f64 / steps as f64;
            (0..=steps).map(share).collect()
        };
        let mut points = vec![[0.0; 3]; count];
        par_ruled_grid_into(&found.sheet, &steps(along), &steps(across), &mut points)?;
        Ok(points)
    }

    /// The bytes of a file with this ending, one of [`ENDINGS`](torse_designs::export::ENDINGS): a pattern, a mesh or a CAD
    /// model.
    ///
    /// # Errors
    /// [`Error::Design`] for what cannot be written so.
    pub fn export(&self, ending: &'static str, demand: &Demand) -> Result<Vec<u8>, Error> {
        Ok(rooms::export::bytes(&self.read, ending, demand)?)
    }

    /// The files that are cut, bent or sewn: the name of each part, and its text as DXF or SVG, as `torse unroll`
    /// writes them.
    ///
    /// # Errors
    /// [`Error::Design`] for what has no pattern or no blank, and for an ending that is no pattern's.
    ///
    /// ```
    /// let design = torse::Design::read("strip.toml", r#"
    ///     [curves]
    ///     a = { bezier = [[0, 0, 0], [40, 0, 0]] }
    ///     b = { bezier = [[0, 60, 0], [40, 60, 0]] }
    ///     [patches]
    ///     strip = { ruled = ["a", "b"] }
    /// "#)?;
    /// use torse::designs::unroll::{Demand, Purpose};
    /// let parts = design.parts_as("dxf", Purpose::Cut, &Demand::default())?;
    /// assert_eq!((parts.len(), parts[0].0.as_str()), (1, "strip"));
    /// assert!(parts[0].1.contains("LWPOLYLINE"));
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn parts_as(
        &self,
        ending: &str,
        purpose: Purpose,
        demand: &Demand,
    ) -> Result<Vec<(String, String)>, Error> {
        let ending = rooms::export::ending(Path::new(&format!("x.{ending}")), PATTERNS)?;
        let made = parts(&self.read, &unroll(&self.read, demand)?)?;
        let text = |part: &Part| {
            let drawing = part.drawing(purpose)?;
            let text = if ending == "dxf" {
                dxf(&drawing)
            } else {
                svg(&drawing)
            };
            Ok((part.name.clone(), text.map_err(rooms::DesignError::from)?))
        };
        made.iter().map(text).collect()
    }

    /// A picture of it with its pattern.
    ///
    /// # Errors
    /// [`Error::Design`] for what cannot be drawn.
    pub fn picture(&self) -> Result<Picture, Error> {
        Ok(rooms::draw::picture(&self.read, &Demand::default())?)
    }

    /// The design with all its parts.
    #[must_use]
    pub fn parts(&self) -> &rooms::Design {
        &self.read
    }
}

impl Pattern {
    /// The area of all pieces.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.flat.area()).sum()
    }

    /// The pieces, each with its outline, its rulings and its errors.
    #[must_use]
    pub fn pieces(&self) -> &[FlatPiece] {
        &self.pieces
    }

    /// What the pattern promises.
    #[must_use]
    pub fn summary(&self) -> &PatternSummary {
        &self.summary
    }

    /// The lines of the drawing, by layers.
    #[must_use]
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// The pattern as a DXF file.
    ///
    /// # Errors
    /// [`Error::Design`] for what DXF cannot hold.
    pub fn dxf(&self) -> Result<String, Error> {
        Ok(dxf(&self.drawing).map_err(rooms::DesignError::from)?)
    }

    /// The pattern as an SVG file.
    ///
    /// # Errors
    /// [`Error::Design`] for what SVG cannot hold.
    pub fn svg(&self) -> Result<String, Error> {
        Ok(svg(&self.drawing).map_err(rooms::DesignError::from)?)
    }
}

/// The report of [`Design::inspect`] as a text for people.
#[must_use]
pub fn report_text(report: &DesignReport) -> String {
    table(report)
}
