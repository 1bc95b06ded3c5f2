//! The Greek letters: their spelling in files, their signs, and their LaTeX commands.
//!
//! Claims, reports, letters, sliders and figure labels share this table, so that a name looks the same everywhere.
//! Letters that look like Latin ones are left out, since a reader cannot distinguish them.

/// A Greek letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GreekLetter {
    /// The spelling in files, which is also the name in Typst.
    pub name: &'static str,
    /// The sign that is shown.
    pub sign: char,
    /// The LaTeX command for the letter in the shown form.
    pub latex: &'static str,
}

const fn letter(name: &'static str, sign: char) -> GreekLetter {
    varied(name, sign, name)
}

const fn varied(name: &'static str, sign: char, latex: &'static str) -> GreekLetter {
    GreekLetter { name, sign, latex }
}

/// All letters: lower case, then upper case, each in alphabetical order.
pub const LETTERS: [GreekLetter; 34] = [
    letter("alpha", 'α'),
    letter("beta", 'β'),
    letter("gamma", 'γ'),
    letter("delta", 'δ'),
    varied("epsilon", 'ε', "varepsilon"),
    letter("zeta", 'ζ'),
    letter("eta", 'η'),
    letter("theta", 'θ'),
    letter("iota", 'ι'),
    letter("kappa", 'κ'),
    letter("lambda", 'λ'),
    letter("mu", 'μ'),
    letter("nu", 'ν'),
    letter("xi", 'ξ'),
    letter("pi", 'π'),
    letter("rho", 'ρ'),
    letter("sigma", 'σ'),
    letter("tau", 'τ'),
    letter("upsilon", 'υ'),
    varied("phi", 'φ', "varphi"),
    letter("chi", 'χ'),
    letter("psi", 'ψ'),
    letter("omega", 'ω'),
    letter("Gamma", 'Γ'),
    letter("Delta", 'Δ'),
    letter("Theta", 'Θ'),
    letter("Lambda", 'Λ'),
    letter("Xi", 'Ξ'),
    letter("Pi", 'Π'),
    letter("Sigma", 'Σ'),
    letter("Upsilon", 'Υ'),
    letter("Phi", 'Φ'),
    letter("Psi", 'Ψ'),
    letter("Omega", 'Ω'),
];

/// Other signs that are printed for letters of the table.
const VARIANTS: [(char, &str); 7] = [
    ('µ', "mu"),
    ('ς', "sigma"),
    ('ϑ', "theta"),
    ('ϕ', "phi"),
    ('ϵ', "epsilon"),
    ('ϱ', "rho"),
    ('ϖ', "pi"),
];

/// Other LaTeX commands for letters of the table.
const LATEX_VARIANTS: [(&str, &str); 6] = [
    ("varepsilon", "epsilon"),
    ("varphi", "phi"),
    ("vartheta", "theta"),
    ("varrho", "rho"),
    ("varsigma", "sigma"),
    ("varkappa", "kappa"),
];

/// The letter with this spelling in files.
///
/// ```
/// use torse_syntax::greek;
/// assert_eq!(greek::by_name("mu").map(|letter| letter.sign), Some('μ'));
/// assert_eq!(greek::by_name("mju"), None);
/// ```
#[must_use]
pub fn by_name(name: &str) -> Option<GreekLetter> {
    LETTERS.into_iter().find(|letter| letter.name == name)
}

/// The letter for this LaTeX command, given without its backslash, in any of its printed forms.
///
/// ```
/// use torse_syntax::greek;
/// let name = |command| greek::by_latex(command).map(|letter| letter.name);
/// assert_eq!([name("mu"), name("varphi"), name("vartheta")], [Some("mu"), Some("phi"), Some("theta")]);
/// assert_eq!(name("sin"), None);
/// ```
#[must_use]
pub fn by_latex(command: &str) -> Option<GreekLetter> {
    let mut variants = LATEX_VARIANTS.into_iter();
    let variant = variants.find(|(variant, _)| *variant == command);
    by_name(variant.map_or(command, |(_, name)| name))
}

/// The letter with this sign, in any of its printed forms.
///
/// ```
/// use torse_syntax::greek;
/// let name = |sign| greek::by_sign(sign).map(|letter| letter.name);
/// assert_eq!([name('φ'), name('ϕ'), name('f')], [Some("phi"), Some("phi"), None]);
/// ```
#[must_use]
pub fn by_sign(sign: char) -> Option<GreekLetter> {
    let plain = LETTERS.into_iter().find(|letter| letter.sign == sign);
    plain.or_else(|| {
        let (_, name) = VARIANTS.into_iter().find(|(variant, _)| *variant == sign)?;
        by_name(name)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_is_found_by_its_name_and_by_its_sign() {
        for letter in LETTERS {
            assert_eq!(by_name(letter.name), Some(letter));
            assert_eq!(by_sign(letter.sign), Some(letter));
            assert_eq!(by_latex(letter.latex), Some(letter));
        }
        for (sign, name) in VARIANTS {
            assert_eq!(by_sign(sign), by_name(name), "{sign}");
        }
    }
}
