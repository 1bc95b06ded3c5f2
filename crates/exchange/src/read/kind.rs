//! What a file is, by its content: the ending of its name may lie, and decides only where the content does not tell.

use super::obj_lines::{FREE_FORM, whole_lines};
use std::borrow::Cow;
use std::fmt;

/// What a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileKind {
    /// A STEP file (ISO 10303-21).
    Step,
    /// An IGES file of 80 columns.
    Iges,
    /// A DXF drawing, as text or binary.
    Dxf,
    /// An SVG drawing.
    Svg,
    /// A table of values.
    Csv,
    /// A Wavefront OBJ mesh.
    Obj,
    /// An STL mesh, as text or binary.
    Stl,
    /// Something that is not read here, by its name.
    Other(&'static str),
    /// Text that is none of these: a design, for instance.
    Text,
    /// Bytes that are none of these.
    Binary,
    /// Nothing.
    Empty,
}

impl FileKind {
    /// The formats that [`read`](super::read) reads, in a row of words.
    pub const READ: &'static str = "STEP, IGES, DXF, SVG, CSV, OBJ and STL";

    /// What the file with these bytes is; a beginning of it is enough, a mebibyte for instance.
    ///
    /// ```
    /// use torse_exchange::FileKind;
    /// assert_eq!(FileKind::detect(b"ISO-10303-21;\nHEADER;"), FileKind::Step);
    /// assert_eq!(FileKind::detect(b"station,x,y\n0,1.5,2\n1,3,4\n"), FileKind::Csv);
    /// assert_eq!(FileKind::detect(b"[curves.rim]\nbezier = [[0, 0, 0], [1, 0, 0]]\n"), FileKind::Text);
    /// assert_eq!(FileKind::detect(b"%PDF-1.7").to_string(), "a PDF document");
    /// ```
    #[must_use]
    pub fn detect(bytes: &[u8]) -> Self {
        let decoded = utf8(bytes);
        let bytes = decoded.as_ref();
        if bytes.starts_with(b"AutoCAD Binary DXF") {
            return Self::Dxf;
        }
        if let Some((_, name)) = SIGNATURES
            .iter()
            .find(|(start, _)| bytes.starts_with(start))
        {
            return Self::Other(name);
        }
        if is_binary_stl(bytes) {
            return Self::Stl;
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Self::Empty;
        }
        if bytes.iter().take(4096).any(|b| *b == 0) {
            return Self::Binary;
        }
        // Enough of the text to tell, also where it is no UTF-8.
        let text =
            String::from_utf8_lossy(bytes.get(..bytes.len().min(1 << 16)).unwrap_or_default());
        of_text(&unix_lines(&text))
    }

    /// As [`FileKind::detect`]; what is none of the kinds by its content, a damaged file for instance, is what the ending of its
    /// name says.
    ///
    /// ```
    /// use torse_exchange::FileKind;
    /// assert_eq!(FileKind::of_file("hull.igs", b"x,y\n0,1\n2,3\n"), FileKind::Csv);
    /// assert_eq!(FileKind::of_file("hull.igs", b"no columns"), FileKind::Iges);
    /// assert_eq!(FileKind::of_file("hull.toml", b"no columns"), FileKind::Text);
    /// ```
    #[must_use]
    pub fn of_file(name: &str, bytes: &[u8]) -> Self {
        let kind = Self::detect(bytes);
        if !matches!(kind, Self::Text | Self::Binary) {
            return kind;
        }
        Self::of_ending(name).unwrap_or(kind)
    }

    /// What the ending of a name says; nothing where it is none of a file that is read.
    ///
    /// ```
    /// use torse_exchange::FileKind;
    /// assert_eq!(FileKind::of_ending("hull.IGS"), Some(FileKind::Iges));
    /// assert_eq!(FileKind::of_ending("hull.toml"), None);
    /// ```
    #[must_use]
    pub fn of_ending(name: &str) -> Option<Self> {
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
        Some(match ending.to_ascii_lowercase().as_str() {
            "step" | "stp" => Self::Step,
            "iges" | "igs" => Self::Iges,
            "dxf" => Self::Dxf,
            "svg" => Self::Svg,
            "csv" => Self::Csv,
            "obj" => Self::Obj,
            "stl" => Self::Stl,
            _ => return None,
        })
    }

    /// Whether [`read`](super::read) reads it.
    #[must_use]
    pub fn is_read(self) -> bool {
        matches!(
            self,
            Self::Step | Self::Iges | Self::Dxf | Self::Svg | Self::Csv | Self::Obj | Self::Stl
        )
    }
}

impl fmt::Display for FileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Step => "a STEP file",
            Self::Iges => "an IGES file",
            Self::Dxf => "a DXF drawing",
            Self::Svg => "an SVG drawing",
            Self::Csv => "a CSV table",
            Self::Obj => "an OBJ mesh",
            Self::Stl => "an STL mesh",
            Self::Other(name) => name,
            Self::Text => "a text",
            Self::Binary => "a binary file",
            Self::Empty => "an empty file",
        })
    }
}

/// How files of other kinds begin.
const SIGNATURES: &[(&[u8], &str)] = &[
    (b"AC10", "a DWG drawing"),
    (b"3D Geometry File Format", "a Rhino model"),
    (b"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", "a Parasolid model"),
    (b"DBRep_DrawableShape", "a BREP model of OpenCASCADE"),
    (b"CASCADE Topology", "a BREP model of OpenCASCADE"),
    (b"ply\n", "a PLY mesh"),
    (b"ply\r\n", "a PLY mesh"),
    (b"glTF", "a GLB mesh"),
    (
        b"PK\x03\x04",
        "a ZIP archive (3MF, FreeCAD and others are such)",
    ),
    (b"\x1f\x8b", "a gzip archive"),
    (b"%PDF", "a PDF document"),
    (b"%!PS", "a PostScript document"),
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"\x7fELF", "a program"),
];

/// Eighty bytes, a count, and fifty bytes for each triangle.
fn is_binary_stl(bytes: &[u8]) -> bool {
    let Some(count) = bytes.get(80..84).and_then(|b| <[u8; 4]>::try_from(b).ok()) else {
        return false;
    };
    let size = u64::from(u32::from_le_bytes(count)) * 50 + 84;
    u64::try_from(bytes.len()) == Ok(size)
}

/// Converts a text that begins with the mark of UTF-16 to UTF-8, and returns all other bytes as they are. Units that encode no
/// character become the replacement character; an odd last byte is dropped.
pub(super) fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let units = |from: fn([u8; 2]) -> u16| {
        let pairs = bytes.chunks_exact(2).skip(1);
        let units = pairs.filter_map(|pair| Some(from(pair.try_into().ok()?)));
        let text: String = char::decode_utf16(units)
            .map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        Cow::Owned(text.into_bytes())
    };
    match bytes {
        [0xff, 0xfe, ..] => units(u16::from_le_bytes),
        [0xfe, 0xff, ..] => units(u16::from_be_bytes),
        _ => Cow::Borrowed(bytes),
    }
}

/// A text whose lines end as they do today, not in a carriage return as on old machines.
pub(super) fn unix_lines(text: &str) -> Cow<'_, str> {
    if !text.contains('\r') {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
}

fn of_text(text: &str) -> FileKind {
    let start = text.trim_start();
    if start.starts_with("ISO-10303-21") {
        return FileKind::Step;
    }
    if is_iges(text) {
        return FileKind::Iges;
    }
    if is_dxf(text) {
        return FileKind::Dxf;
    }
    if start.starts_with('<') {
        // Comments, declarations and instructions may come first; a prefix may name the elements.
        let named = |rest: &str| {
            let name = rest
                .split(|c: char| c.is_whitespace() || matches!(c, '>' | '/'))
                .next();
            let name = name.unwrap_or_default();
            name.rsplit(':')
                .next()
                .unwrap_or_default()
                .to_ascii_lowercase()
        };
        let first = start
            .match_indices('<')
            .map(|(at, _)| named(&start[at + 1..]));
        let mut elements = first.filter(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()));
        return match elements.next().as_deref() {
            Some("svg") => FileKind::Svg,
            Some("html" | "head" | "body") => FileKind::Other("an HTML page"),
            _ => FileKind::Other("an XML file"),
        };
    }
    let begins = |word: &str| {
        let first = start.get(..word.len());
        first.is_some_and(|first| first.eq_ignore_ascii_case(word))
    };
    if begins("solid") && text.to_ascii_lowercase().contains("facet") {
        return FileKind::Stl;
    }
    if is_obj(text) {
        return FileKind::Obj;
    }
    if start.starts_with('{') && is_object(start) {
        return FileKind::Other("a JSON file");
    }
    if is_table(text) {
        return FileKind::Csv;
    }
    FileKind::Text
}

/// JSON begins with a name in quotes and a colon; no table of TOML does at the start of a file.
fn is_object(start: &str) -> bool {
    let inside = start.trim_start_matches('{').trim_start();
    inside.starts_with('"') || inside.starts_with('}')
}

/// The first line is of the start section: `S` in column 73 and a number after it.
fn is_iges(text: &str) -> bool {
    let line = text.lines().next().unwrap_or_default();
    let tail = line.get(72..80.min(line.len())).unwrap_or_default();
    let number = tail.strip_prefix('S').unwrap_or_default().trim();
    !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit())
}

/// Pairs of lines: a group code, a value; the first that is no comment is `0 SECTION`.
fn is_dxf(text: &str) -> bool {
    let mut lines = text.lines();
    while let (Some(code), Some(value)) = (lines.next(), lines.next()) {
        match code.trim() {
            "999" => {}
            "0" => return value.trim() == "SECTION",
            _ => return false,
        }
    }
    false
}

fn is_obj(text: &str) -> bool {
    let mut vertices = 0;
    for (_, line) in whole_lines(text).take(1000) {
        let mut words = line.split_whitespace();
        match words.next() {
            None => {}
            Some(word) if word.starts_with('#') => {}
            Some("v") if words.clone().count() >= 3 => {
                if words.take(3).any(|word| word.parse::<f64>().is_err()) {
                    return false;
                }
                vertices += 1;
            }
            Some("vn" | "vt" | "f" | "l" | "p" | "o" | "g" | "s" | "mtllib" | "usemtl") => {}
            Some(word) if FREE_FORM.contains(&word) => {}
            Some(_) => return false,
        }
    }
    vertices > 0
}

/// The separator of a line of a table, if it has one.
pub(super) fn separator(line: &str) -> Option<char> {
    [';', '\t', ','].into_iter().find(|c| line.contains(*c))
}

/// Two lines or more of equally many values, most of them numbers, and nothing of TOML's.
fn is_table(text: &str) -> bool {
    let mut lines = text
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with('#'));
    let Some(head) = lines.next() else {
        return false;
    };
    if head.starts_with('[') || head.contains('=') {
        return false;
    }
    let Some(separator) = separator(head) else {
        return false;
    };
    let rows: Vec<Vec<&str>> = lines
        .take(50)
        .map(|l| l.split(separator).collect())
        .collect();
    let columns = head.split(separator).count();
    // The last line may be cut.
    let whole = rows.split_last().map_or(
        &rows[..],
        |(_, rest)| if rows.len() > 1 { rest } else { &rows[..] },
    );
    let number = |cell: &&str| {
        cell.trim()
            .trim_matches('"')
            .replace(',', ".")
            .parse::<f64>()
            .is_ok()
    };
    let (all, numbers) = whole.iter().flatten().fold((0, 0), |(all, numbers), cell| {
        (all + 1, numbers + usize::from(number(cell)))
    });
    columns > 1 && all > 0 && 2 * numbers >= all
}
