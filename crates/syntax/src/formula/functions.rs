//! The names of the functions of the language. What each means is in SEMANTICS.md.

/// All of them.
pub const FUNCTIONS: [&str; 30] = [
    "sum",
    "product",
    "integral",
    "D",
    "at",
    "binom",
    "factorial",
    "sin",
    "cos",
    "tan",
    "exp",
    "cosh",
    "sinh",
    "tanh",
    "sqrt",
    "abs",
    "dot",
    "cross",
    "det",
    "transpose",
    "inverse",
    "solve",
    "norm",
    "agrees",
    "fails",
    "coefficients",
    "identity",
    "nonnegative",
    "independent",
    "variation_diminishing",
];

/// Those of one number whose values are mostly not rational.
pub const ELEMENTARY: [&str; 8] = ["sqrt", "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"];

/// Whether a name is that of a function of the language.
#[must_use]
pub fn is_function(name: &str) -> bool {
    FUNCTIONS.contains(&name)
}
