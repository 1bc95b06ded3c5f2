//! The lines of a Wavefront OBJ file, and its statements that are not read.

use std::borrow::Cow;

/// Statements of free-form curves and surfaces.
pub(super) const FREE_FORM: [&str; 20] = [
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
    "end", "con", "vp", "ctech", "stech", "mg", "bevel", "lod",
];

/// The lines of a text with their numbers; a line that ends in a backslash goes on in the next.
pub(super) fn whole_lines(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(text.lines());
    std::iter::from_fn(move || {
        let (line, first) = lines.next()?;
        let mut whole = Cow::Borrowed(first);
        while let Some(begun) = whole.trim_end().strip_suffix('\\') {
            let Some((_, next)) = lines.next() else { break };
            whole = Cow::Owned(format!("{begun} {next}"));
        }
        Some((line, whole))
    })
}
