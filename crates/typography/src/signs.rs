//! Signs by the names that LaTeX gives them: one table for labels, quotations and printed names.

use torse_syntax::greek;

/// Named signs that are no Greek letters. A sign has its shortest name first.
pub const SIGNS: [(&str, char); 26] = [
    ("le", '≤'),
    ("leq", '≤'),
    ("ge", '≥'),
    ("geq", '≥'),
    ("ne", '≠'),
    ("neq", '≠'),
    ("approx", '≈'),
    ("in", '∈'),
    ("to", '→'),
    ("times", '×'),
    ("cdot", '⋅'),
    ("pm", '±'),
    ("infty", '∞'),
    ("partial", '∂'),
    ("nabla", '∇'),
    ("sum", '∑'),
    ("int", '∫'),
    ("degree", '°'),
    ("dots", '…'),
    ("ldots", '…'),
    ("cdots", '…'),
    ("circ", '∘'),
    ("parallel", '∥'),
    ("wedge", '∧'),
    ("{", '{'),
    ("}", '}'),
];

/// The sign that `\\name` stands for: one of [`SIGNS`].
#[must_use]
pub fn sign(name: &str) -> Option<char> {
    let mut all = SIGNS.iter();
    all.find(|(own, _)| *own == name).map(|(_, sign)| *sign)
}

/// The Greek letter that `\\name` stands for, by the name that files or LaTeX give it.
#[must_use]
pub fn letter(name: &str) -> Option<char> {
    greek::by_latex(name).map(|letter| letter.sign)
}
