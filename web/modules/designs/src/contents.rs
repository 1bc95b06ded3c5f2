//! Files of other programs: what they hold, and a design that begins with their curves.

use crate::Failure;
use serde::Serialize;
use std::fmt::Write;
use torse::Design;
use torse::designs::listing::FileListing;

/// What was found in files that were dropped on the page.
#[derive(Serialize)]
pub struct Contents {
    /// File by file.
    listings: Vec<FileListing>,
    /// The listings for people.
    text: String,
    /// The name of a file whose faces are a design as they are.
    faces: Option<String>,
    /// A design that takes the curves of the files; none where they have fewer than two.
    start: Option<String>,
}

/// The most curves that a design begins with.
const MAX_CURVES: usize = 64;

/// Lists the files.
pub fn contents(files: &[(&str, &[u8])]) -> Result<Contents, Failure> {
    let mut listings = Vec::with_capacity(files.len());
    let mut faces = None;
    for (name, bytes) in files {
        let listing = torse::contents(name, bytes, None)?;
        if !listing.faces.is_empty() && Design::read_bytes(name, bytes).is_ok() {
            faces.get_or_insert_with(|| (*name).to_owned());
        }
        listings.push(listing);
    }
    let texts = listings.iter().map(FileListing::text);
    Ok(Contents {
        text: texts.collect::<Vec<String>>().join("\n"),
        start: start(&listings, files),
        faces,
        listings,
    })
}

/// A patch between two curves, as a design says it.
const PATCHES: [&str; 2] = [
    "\n# The developable that touches both curves: change the names to connect others.\n[patches.panel]\nconnect = [\"c1\", \"c2\"]\n",
    "\n# No developable touches both curves: rulings between equal parameters. Change the names to connect others.\n[patches.panel]\n\
     ruled = [\"c1\", \"c2\"]\n",
];

/// A design of the first two curves, the others named above it: connected if they can be, else ruled.
fn start(listings: &[FileListing], files: &[(&str, &[u8])]) -> Option<String> {
    let curves = listings.iter().flat_map(|listing| {
        let own = listing.curves.iter().filter(|curve| !curve.edge);
        own.map(|curve| format!("{}#{}", listing.file, curve.name))
    });
    let curves: Vec<String> = curves.take(MAX_CURVES).collect();
    if curves.len() < 2 {
        return None;
    }
    let names: Vec<&str> = listings
        .iter()
        .map(|listing| listing.file.as_str())
        .collect();
    let mut text = format!(
        "[design]\ntitle = {}\n\n[curves]\n",
        quoted(&names.join(", "))
    );
    for (number, curve) in (1..).zip(&curves) {
        // Text is written to a String without fail.
        let _ = writeln!(text, "c{number} = {{ import = {} }}", quoted(curve));
    }
    let mut file = |wanted: &str| {
        let found = files.iter().find(|(name, _)| *name == wanted);
        let bytes = found.map(|(_, bytes)| bytes.to_vec());
        bytes.ok_or_else(|| format!("there is no `{wanted}`"))
    };
    let [connected, ruled] = PATCHES.map(|patch| text.clone() + patch);
    let is_read = Design::read_with("start.toml", &connected, &mut file).is_ok();
    Some(if is_read { connected } else { ruled })
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            letter if letter.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(letter));
            }
            letter => quoted.push(letter),
        }
    }
    quoted + "\""
}
