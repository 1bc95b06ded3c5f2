//! The Greek letters: how files spell them, how they look, how LaTeX calls them.
//!
//! One table for claims, reports, letters, sliders and labels of figures, so that a name looks the same wherever it is
//! read. Letters that look like Latin ones are not in it: nobody can tell them apart.

/// A Greek letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GreekLetter {
    /// How files spell it; Typst calls it the same.
    pub name: &'static str,
    /// How it is shown.
    pub sign: char,
    /// The command of LaTeX for the letter in the form in which it is shown.
    pub latex: &'static str,
}

const fn letter(name: &'static str, sign: char) -> GreekLetter {
    varied(name, sign, name)
}

const fn varied(name: &'static str, sign: char, latex: &'static str) -> GreekLetter {
    GreekLetter { name, sign, latex }
}

/// All letters, small ones first, in the order of the alphabet.
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

/// Other signs that are printed for a letter of the table.
const VARIANTS: [(char, &str); 7] = [
    ('µ', "mu"),
    ('ς', "sigma"),
    ('ϑ', "theta"),
    ('ϕ', "phi"),
    ('ϵ', "epsilon"),
    ('ϱ', "rho"),
    ('ϖ', "pi"),
];

/// The letter that files spell like this.
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

/// The letter that a printed sign is, in any of its forms.
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
        }
        for (sign, name) in VARIANTS {
            assert_eq!(by_sign(sign), by_name(name), "{sign}");
        }
    }
}
