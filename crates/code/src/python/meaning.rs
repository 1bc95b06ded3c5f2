//! What names of modules of Python mean, and those that are always there.

use crate::program::operation;

/// What a name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    /// A function of formulas, or an operation, of the same arguments.
    Function(&'static str),
    /// The number pi, and the base of the exponentials.
    Pi,
    /// The same.
    E,
    /// `Rational(p, q)`: a quotient, or a number alone.
    Quotient,
    /// What returns its first argument, as far as values are concerned, and how many arguments it may have.
    Same(usize),
    /// A function of SymPy that has complex values elsewhere, where that of formulas has none.
    Complex(&'static str),
    /// A function that is zero for negative integers, where that of formulas is something else.
    Natural(&'static str),
    /// What makes an integer of its argument.
    Whole,
    /// The smallest or the greatest of several numbers.
    Extremum(&'static str),
    /// The smaller or the greater of two numbers.
    ExtremumOfTwo(&'static str),
    /// `pow(a, b)`.
    Power,
    /// `square(a)`.
    Square,
    /// SymPy's `diff`.
    Derivative,
    /// SymPy's `Integral` and `integrate`.
    Integral,
    /// SymPy's `Sum` and `Product`, with a tuple of a symbol and its bounds.
    Series(&'static str),
    /// SymPy's `symbols`.
    Symbols,
    /// SymPy's `Symbol`, of one name.
    Symbol,
    /// `range`.
    Range,
    /// `zeros(n)` and `ones(n)`.
    Filled(i64),
}

/// The modules that are read.
pub(super) const MODULES: [&str; 5] = ["math", "numpy", "sympy", "scipy.special", "fractions"];

/// What a name of a module means, if it is read.
pub(super) fn meaning(module: &str, name: &str) -> Option<Meaning> {
    use Meaning::{
        Complex, Derivative, E, Extremum, ExtremumOfTwo, Filled, Function, Integral, Natural, Pi,
        Power, Quotient, Same, Series, Square, Symbol, Symbols, Whole,
    };
    if !MODULES.contains(&module) {
        return None;
    }
    if let Some(function) = elementary(name) {
        let is_complex = matches!(function, "sqrt" | "log" | "asin" | "acos");
        return match module {
            "math" | "numpy" => Some(Function(function)),
            "sympy" if is_complex => Some(Complex(function)),
            "sympy" => Some(Function(function)),
            _ => None,
        };
    }
    Some(match (module, name) {
        ("math" | "numpy" | "sympy", "pi") => Pi,
        ("math" | "numpy", "e") | ("sympy", "E") => E,
        ("math", "comb") | ("sympy", "binomial") | ("scipy.special", "binom") => Function("binom"),
        ("scipy.special", "comb") => Natural("binom"),
        ("math" | "sympy", "factorial") => Function("factorial"),
        ("scipy.special", "factorial") => Natural("factorial"),
        ("math", "fabs") | ("numpy", "abs" | "absolute" | "fabs") | ("sympy", "Abs") => {
            Function("abs")
        }
        ("numpy", "minimum" | "fmin") => ExtremumOfTwo("min"),
        ("numpy", "maximum" | "fmax") => ExtremumOfTwo("max"),
        ("sympy", "Min") => Extremum("min"),
        ("sympy", "Max") => Extremum("max"),
        ("sympy", "Integer") => Whole,
        ("math" | "numpy" | "sympy", "pow" | "power" | "Pow") => Power,
        ("numpy", "square") => Square,
        ("sympy", "Rational") | ("fractions", "Fraction") => Quotient,
        (
            "sympy",
            "S" | "sympify" | "simplify" | "expand" | "factor" | "together" | "cancel" | "trigsimp",
        )
        | ("numpy", "float64") => Same(1),
        ("sympy", "apart" | "collect") => Same(2),
        ("sympy", "symbols") => Symbols,
        ("sympy", "Symbol") => Symbol,
        ("sympy", "diff" | "Derivative") => Derivative,
        ("sympy", "integrate" | "Integral") => Integral,
        ("sympy", "Sum" | "summation") => Series(operation::SUMMED),
        ("sympy", "Product" | "product") => Series(operation::MULTIPLIED),
        ("numpy", "array" | "copy") => Function(operation::VECTOR),
        ("numpy", "asarray") => Function(operation::AS_VECTOR),
        ("sympy", "Matrix") => Function(operation::MATRIX),
        ("numpy", "zeros") => Filled(0),
        ("numpy", "ones") => Filled(1),
        ("numpy", "sum") => Function(operation::TOTAL),
        ("math", "fsum") => Function(operation::SUM),
        ("numpy", "prod") => Function(operation::TOTAL_PRODUCT),
        ("math", "prod") => Function(operation::PRODUCT),
        ("numpy", "dot") => Function("dot"),
        ("numpy", "cross") => Function("cross"),
        _ => return None,
    })
}

/// Functions that have the same name everywhere.
fn elementary(name: &str) -> Option<&'static str> {
    let all = [
        "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "sqrt", "atan", "asin", "acos",
    ];
    // NumPy's names of the inverse functions.
    let name = match name {
        "arctan" => "atan",
        "arcsin" => "asin",
        "arccos" => "acos",
        own => own,
    };
    all.into_iter().find(|known| *known == name)
}

/// What a name means that is always there.
pub(super) fn built_in(name: &str) -> Option<Meaning> {
    use Meaning::Function;
    Some(match name {
        "abs" => Function("abs"),
        "min" => Function("min"),
        "max" => Function("max"),
        "len" => Function(operation::LENGTH),
        "sum" => Function(operation::SUM),
        "list" | "tuple" => Function(operation::LIST),
        "float" => Meaning::Same(1),
        "pow" => Meaning::Power,
        "range" => Meaning::Range,
        "enumerate" => Function(operation::ENUMERATE),
        "zip" => Function(operation::ZIP),
        "reversed" => Function(operation::REVERSED),
        _ => return None,
    })
}
