//! Reading design files.
//!
//! The format is described in `designs/README.md` and `designs/schema.json`. Sections are read in the order points,
//! planes, curves, families, surfaces, patches, chains, seams, entries in the order of the file; an entry refers to
//! what stands above it. What is wrong is kept with its place, and what leans on it is passed over in silence, so that
//! one run shows all mistakes of a file, each once.

mod chains;
mod curves;
mod edges;
mod formula;
mod imports;
mod joints;
pub mod keys;
mod numerals;
mod passages;
mod patches;
mod pieces;
mod placement;
mod planes;
mod points;
mod reader;
mod seams;
mod settings;
mod shapes;
mod splines;
mod surfaces;

use crate::design::{Design, FreeSurface};
use crate::error::DesignError;
use imports::{Files, Imports};
use patches::ReadPatches;
use reader::{Named, Reader, Value, ordered};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use toml::de::DeTable;
use torse_exchange::FileKind;
use torse_geometry::prelude::{PiecewiseRail, Planes, Point};

pub use torse_syntax::derivation::Source;

/// The largest file that is read, in bytes.
pub const MAX_BYTES: usize = 1 << 20;
/// The longest line that is read, in bytes: mistakes are shown with the line they are in.
pub const MAX_LINE: usize = 1 << 16;
/// The most things of one kind in a file.
pub const MAX_THINGS: usize = 512;
/// The most control elements of a curve of one piece or of a family; splines have more.
pub const MAX_CONTROLS: usize = 65;
/// The most mistakes that are told of one file.
const MAX_MISTAKES: usize = 100;
/// So many bytes of the file are shown with them, and the line of the first in any case.
const MAX_SHOWN: usize = 1 << 15;

/// What patches are made of.
#[derive(Default)]
struct Parts {
    points: Named<Point>,
    planes: Named<[f64; 4]>,
    curves: Named<PiecewiseRail>,
    families: Named<Planes>,
    surfaces: Named<FreeSurface>,
}

/// Reads a design file, or the faces of a file of another program, of which each with rulings between two edges is a
/// patch.
///
/// # Errors
/// [`DesignError::Unreadable`] for a file that is not there, too large or no text, [`DesignError::OtherKind`] for a
/// file of another program without faces, [`DesignError::Listing`] for one that cannot be read, [`DesignError::NoFace`]
/// where none of them has rulings between its edges, [`DesignError::Wrong`] with everything that is wrong in it.
pub fn load(path: &Path) -> Result<Design, DesignError> {
    let unreadable = |reason: String| DesignError::Unreadable {
        path: path.display().to_string(),
        reason,
    };
    let size = std::fs::metadata(path).map_err(|e| unreadable(e.to_string()))?;
    if size.is_dir() {
        return Err(unreadable("it is a folder".to_owned()));
    }
    let file = std::fs::File::open(path).map_err(|e| unreadable(e.to_string()))?;
    load_from(path, file)
}

/// As [`load`], from a stream, standard input for instance; files that the design names are looked for beside `path`.
///
/// # Errors
/// As [`load`].
pub fn load_from(path: &Path, stream: impl std::io::Read) -> Result<Design, DesignError> {
    load_with_settings(path, stream, &[])
}

/// As [`load_from`], with numbers that take the place of those of these names under `[let]`.
///
/// # Errors
/// As [`load`]; a name that the file does not have is a mistake too.
pub fn load_with_settings(
    path: &Path,
    mut stream: impl std::io::Read,
    settings: &[(String, f64)],
) -> Result<Design, DesignError> {
    let shown = path.display().to_string();
    let unreadable = |reason: String| DesignError::Unreadable {
        path: shown.clone(),
        reason,
    };
    let mut bytes = Vec::new();
    // A file may be longer than it says, a device for instance.
    let mut take = |most: usize, bytes: &mut Vec<u8>| {
        let most = u64::try_from(most).unwrap_or(u64::MAX);
        std::io::Read::read_to_end(&mut std::io::Read::take(&mut stream, most), bytes)
            .map_err(|e| unreadable(e.to_string()))
    };
    take(MAX_BYTES + 1, &mut bytes)?;
    if bytes.len() > MAX_BYTES && FileKind::of_file(&shown, &bytes).is_read() {
        take(torse_exchange::MAX_FILE_BYTES - MAX_BYTES, &mut bytes)?;
    }
    if let Some(design) = of_faces(&shown, &bytes)? {
        return Ok(design);
    }
    other_kind(&shown, &bytes)?;
    if bytes.len() > MAX_BYTES {
        return Err(unreadable(format!("it is longer than {MAX_BYTES} bytes")));
    }
    let text = String::from_utf8(bytes).map_err(|e| {
        let at = e.utf8_error().valid_up_to();
        unreadable(format!("it is no UTF-8 text (byte {at})"))
    })?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let folder = path.parent().unwrap_or(Path::new(""));
    read_with_settings(&name, &text, &mut |file| beside(folder, file), settings)
}

/// Returns the design of the faces of a file of another program; nothing for one without faces, and for a design.
fn of_faces(path: &str, bytes: &[u8]) -> Result<Option<Design>, DesignError> {
    if !FileKind::of_file(path, bytes).is_read() {
        return Ok(None);
    }
    match torse_exchange::read(path, bytes, None) {
        Ok(imported) if !imported.faces.is_empty() => {
            crate::faces::design_of_faces(path, &imported).map(Some)
        }
        // It is named as what it is.
        Ok(_) => Ok(None),
        Err(reason) => Err(DesignError::Listing {
            path: path.to_owned(),
            reason,
        }),
    }
}

/// Returns a file that a design in a folder names.
fn beside(folder: &Path, file: &str) -> Result<Vec<u8>, String> {
    let path = folder.join(file);
    let most = u64::try_from(torse_exchange::MAX_FILE_BYTES).unwrap_or(u64::MAX);
    let open = std::fs::File::open(&path).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    std::io::Read::read_to_end(&mut std::io::Read::take(open, most + 1), &mut bytes)
        .map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Refuses, in one line, what is a file of another kind: its text is no TOML that somebody mistyped.
fn other_kind(path: &str, bytes: &[u8]) -> Result<(), DesignError> {
    match FileKind::of_file(path, bytes) {
        // An empty design is a design; that of another program is none.
        kind @ FileKind::Empty if FileKind::of_ending(path).is_some() => {
            Err(DesignError::OtherKind {
                path: path.to_owned(),
                kind,
            })
        }
        // Bytes that mean nothing are refused where they are no text.
        FileKind::Text | FileKind::Empty | FileKind::Binary => Ok(()),
        kind => Err(DesignError::OtherKind {
            path: path.to_owned(),
            kind,
        }),
    }
}

/// Returns the line of a text in which a byte is.
fn line_at(text: &str, byte: usize) -> &str {
    let starts = |line: &str| line.as_ptr().addr() - text.as_ptr().addr();
    let line = text.lines().take_while(|line| starts(line) <= byte).last();
    line.unwrap_or_default()
}

/// Reads the text of a design file with this name.
///
/// # Errors
/// [`DesignError::OtherKind`] for a file of another program, [`DesignError::Wrong`] with everything that is wrong, in
/// the order of the file; [`DesignError::Unreadable`] for lines longer than [`MAX_LINE`].
///
/// ```
/// use torse_designs::{DesignError, read};
/// let design = read("cone.toml", r#"
///     [let]
///     r = "20*sqrt(2)"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = ["r", 0, 0], to = [0, "r", 0] }
///     [patches.cone]
///     cone = "rim"
///     apex = [0, 0, 40]
///     range = [1, 0.5]
/// "#)?;
/// assert_eq!((design.name.as_str(), design.patches.len()), ("cone", 1));
///
/// let wrong = read("cone.toml", "[points]\nA = [0, 0]\nB = [1, \"2*q\", 0]\n[patch.x]\n").unwrap_err();
/// let DesignError::Wrong { mistakes } = wrong else { panic!() };
/// let all: Vec<String> = mistakes.iter().map(ToString::to_string).collect();
/// assert_eq!(all, [
///     "2 numbers: 3 are wanted",
///     "`q` is not declared",
///     "a design file has no entry `patch`",
///     "a design has one patch or surface at least",
/// ]);
/// # Ok::<(), DesignError>(())
/// ```
pub fn read(name: &str, text: &str) -> Result<Design, DesignError> {
    let none = |_: &str| Err("no files are read here".to_owned());
    read_with(name, text, &mut { none })
}

/// As [`read`], of a design that names other files: `files` gives the bytes of the file at a path that stands in the
/// design, or says why it has none.
///
/// # Errors
/// As [`read`].
///
/// ```
/// use torse_designs::read_with;
/// let text = r#"
///     [curves.low]
///     import = "hull.csv#chine"
///     [curves.high]
///     import = "hull.csv#sheer"
///     [patches.side]
///     ruled = ["low", "high"]
/// "#;
/// let table = "x [m],chine y,chine z,sheer y,sheer z\n0,0,0,0,0.5\n1,0.3,0,0.4,0.6\n2,0.2,0.1,0.3,0.7\n";
/// let design = read_with("hull.toml", text, &mut |_| Ok(table.as_bytes().to_vec()))?;
/// assert_eq!(design.patches.len(), design.chains[0].patches.len());
/// assert_eq!(design.notes, ["hull.csv: a CSV table, lengths in m, stated by the file"]);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn read_with(name: &str, text: &str, files: Files<'_>) -> Result<Design, DesignError> {
    read_with_settings(name, text, files, &[])
}

/// As [`read_with`], with numbers that take the place of those of these names under `[let]`.
///
/// # Errors
/// As [`read`]; [`DesignError::NoSuch`] for a name that `[let]` does not have.
///
/// ```
/// let text = r#"
///     [let]
///     r = 30
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = ["r", 0, 0], to = [0, "r", 0] }
///     [patches.cone]
///     cone = "rim"
///     apex = [0, 0, 40]
/// "#;
/// let none = |_: &str| Err(String::new());
/// let wide = torse_designs::read_with_settings("cone.toml", text, &mut { none }, &[("r".to_owned(), 45.0)])?;
/// assert_eq!(wide.patches[0].sheet.point(0.0, 0.0).ok(), Some([45.0, 0.0, 0.0]));
/// assert!(torse_designs::read_with_settings("cone.toml", text, &mut { none }, &[("q".to_owned(), 1.0)]).is_err());
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn read_with_settings(
    name: &str,
    text: &str,
    files: Files<'_>,
    settings: &[(String, f64)],
) -> Result<Design, DesignError> {
    other_kind(name, text.as_bytes())?;
    if let Some(line) = text.lines().position(|line| line.len() > MAX_LINE) {
        return Err(DesignError::Unreadable {
            path: name.to_owned(),
            reason: format!("line {} is longer than {MAX_LINE} bytes", line + 1),
        });
    }
    let source = Arc::new(Source::new(name, text));
    let mut reader = Reader::new(Arc::clone(&source));
    // Digits without an exponent are a formula that nothing is wrong with.
    let digits = |(name, value): &(String, f64)| (name.clone(), format!("{value}"));
    reader.settings = settings.iter().map(digits).collect();
    let (table, errors) = DeTable::parse_recoverable(&source.text);
    for error in &errors {
        let span = error.span().unwrap_or(0..0);
        reader.complain(&span, error.message(), "");
    }
    let design = if errors.is_empty() {
        sections(&mut reader, name, table.into_inner(), files)
    } else {
        None
    };
    if let Some(name) = reader.unset.first() {
        return Err(DesignError::NoSuch {
            what: "number under [let]",
            name: name.clone(),
            known: reader.names(),
        });
    }
    let mut mistakes = std::mem::take(&mut reader.mistakes);
    mistakes.sort_by_key(|(start, _)| *start);
    match design {
        Some(design) if mistakes.is_empty() => Ok(design),
        _ => {
            let mut shown = 0;
            let told = mistakes.into_iter().take_while(|(start, _)| {
                let first = shown == 0;
                shown += 1 + line_at(text, *start).len();
                first || shown <= MAX_SHOWN
            });
            let mistakes = told.map(|(_, error)| error).take(MAX_MISTAKES).collect();
            Err(DesignError::Wrong { mistakes })
        }
    }
}

fn sections(
    reader: &mut Reader,
    name: &str,
    table: DeTable<'_>,
    files: Files<'_>,
) -> Option<Design> {
    let mut sections: BTreeMap<String, Value<'_>> = BTreeMap::new();
    for (key, span, value) in ordered(table) {
        if keys::TOP.contains(&key.as_str()) {
            sections.insert(key, value);
            continue;
        }
        let help = match torse_syntax::similar::similar(&key, keys::TOP.iter().copied()) {
            Some(near) => format!("did you mean `[{near}]`?"),
            None => format!("its sections are `{}`", keys::TOP.join("`, `")),
        };
        reader.complain(&span, format!("a design file has no entry `{key}`"), &help);
    }
    let mut take = |key: &str| sections.remove(key);
    let head = settings::head(reader, take("design"), name);
    match take("let") {
        Some(value) => reader.constants(value),
        None => {
            let names = reader.settings.iter().map(|(name, _)| name.clone());
            reader.unset = names.collect();
        }
    }
    let (metal, material, bending) = settings::metal(reader, take("sheet"));
    let tolerances = settings::tolerances(reader, take("tolerances"));
    let view = settings::view(reader, take("view"));
    let mut parts = Parts::default();
    parts.points = points::points(reader, take("points"));
    parts.planes = planes::planes(reader, take("planes"), &parts.points);
    let mut imports = Imports::new(files);
    let section = take("curves");
    parts.curves = curves::curves(reader, section, &parts.points, &parts.planes, &mut imports);
    parts.families = planes::families(reader, take("families"), &parts.planes);
    parts.surfaces = surfaces::surfaces(reader, take("surfaces"), &parts);
    let ReadPatches {
        mut patches,
        groups,
        covers,
    } = patches::patches(reader, take("patches"), &parts);
    let chains = chains::chains(reader, take("chains"), &patches, &groups);
    passages::resolved(reader, &mut patches, &chains);
    let seams = seams::seams(reader, take("seams"), &patches, &groups);
    let surfaces = parts.surfaces;
    if patches.is_empty() && surfaces.is_empty() {
        let end = reader.source().text.len();
        let help = "a patch stands under `[patches.NAME]`, a surface under `[surfaces.NAME]`";
        reader.complain(
            &(end..end),
            "a design has one patch or surface at least",
            help,
        );
    }
    Some(Design {
        name: name.strip_suffix(".toml").unwrap_or(name).to_owned(),
        title: head.title,
        unit: head.unit,
        metal,
        material,
        bending,
        tolerances,
        view,
        patches: patches.into_iter().filter_map(|(_, patch)| patch).collect(),
        chains,
        allowance: head.allowance,
        seams,
        notes: imports.notes,
        left_out: Vec::new(),
        surfaces: surfaces.into_iter().filter_map(|(_, one)| one).collect(),
        covers,
        points: std::mem::take(&mut reader.placed),
    })
}

/// Returns the entries of a section of named things, each read by `read`; too many are a mistake.
fn named<'s, T>(
    reader: &mut Reader,
    section: Option<Value<'s>>,
    what: &str,
    mut read: impl FnMut(&mut Reader, &str, Value<'s>, &Named<T>) -> Option<T>,
) -> Named<T> {
    let mut things = Named::new();
    let Some(entries) = section.and_then(|value| reader.table(value, what)) else {
        return things;
    };
    let span = entries.span.clone();
    let rest = entries.rest();
    if rest.len() > MAX_THINGS {
        let message = format!(
            "{} entries of {what}: at most {MAX_THINGS} are read",
            rest.len()
        );
        reader.complain(&span, message, "");
        return things;
    }
    for (name, span, value) in rest {
        if name.is_empty() || name.chars().any(char::is_control) {
            reader.complain(&span, "a name has letters", "");
            continue;
        }
        reader.begin(&name);
        let thing = read(reader, &name, value, &things);
        things.push((name, thing));
    }
    things
}
