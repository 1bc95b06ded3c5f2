//! Hints for characters that are not in the language.

/// How an implication is written.
pub const IMPLIES: &str = "an implication is written `p implies q`";

/// The hint for a character that is not in the language.
pub fn character(found: char) -> Option<&'static str> {
    Some(match found {
        '=' => "an equation is written with `==`",
        '|' => "the norm of a vector is written `norm(v)`, the absolute value of a number `abs(x)`",
        '\u{2225}' | '\u{2016}' => "the norm of a vector is written `norm(v)`",
        '\u{2265}' | '\u{2a7e}' => "write `>=`",
        '\u{2264}' | '\u{2a7d}' => "write `<=`",
        '\u{2260}' => "write `!=`",
        '\u{2261}' => "write `==`",
        '\u{b7}' | '\u{d7}' | '\u{22c5}' | '\u{2219}' | '\u{2217}' => {
            "a product is written with `*`, that of two vectors `dot(a, b)` or `cross(a, b)`"
        }
        '\u{f7}' | '\u{2215}' | '\u{2044}' => "write `/`",
        '\u{2212}' | '\u{2013}' | '\u{2010}' => "write the minus sign of the keyboard, `-`",
        '\u{b2}' => "a square is written `x^2`",
        '\u{b3}' => "a cube is written `x^3`",
        '\u{2070}'..='\u{2079}' => "a power is written with `^`",
        '\u{2080}'..='\u{2089}' => "an index is written `R[i]`, or is part of the name: `x_1`",
        '\u{b9}' | '\u{bc}'..='\u{be}' => "a fraction is written with `/`",
        '\u{221a}' => "a square root is written `sqrt(x)`",
        '\u{221e}' => {
            "a symbol without a bound is declared with the end `inf`; formulas have no infinity"
        }
        '\u{2211}' => "a sum is written `sum(i, 0, k, ...)`",
        '\u{220f}' => "a product over an index is written `product(i, 1, k, ...)`",
        '\u{222b}' => "an integral is written `integral(f, x, a, b)`",
        '\u{2202}' => "a derivative is written `D(F, x)`",
        '\u{2227}' | '&' => "write `and`",
        '\u{2228}' => "write `or`",
        '\u{ac}' => "write `not`",
        '\u{21d2}' | '\u{2192}' => "write `implies`",
        '\u{2032}' | '\u{2019}' => "write the prime of the keyboard, `'`",
        '\u{b0}' => "angles are in radians: 90 degrees are `pi/2`",
        '!' => "a factorial is written `factorial(n)`, a negation `not`",
        '{' | '}' => "brackets are round, or square for lists and indices",
        '.' => "a number begins with a digit: `0.5`",
        ':' => {
            "a statement holds for all values of its symbols: leave out `for all x:`, and declare what `x` is"
        }
        '\\' | '$' => "formulas are plain text, not TeX",
        _ => return None,
    })
}

/// The hint for a text that begins with a sign of several characters of which the first is not in the language.
pub fn unknown_sign(text: &str) -> Option<&'static str> {
    match text.as_bytes() {
        [b'=', b'>', ..] => Some(IMPLIES),
        [b'=', b'<', ..] => Some("write `<=`"),
        _ => None,
    }
}
