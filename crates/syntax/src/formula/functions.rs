//! The names of the functions of the language. What each means is in SEMANTICS.md.

/// All of them.
pub const FUNCTIONS: [&str; 36] = [
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
    "log",
    "atan",
    "asin",
    "acos",
    "cosh",
    "sinh",
    "tanh",
    "sqrt",
    "abs",
    "min",
    "max",
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
pub const ELEMENTARY: [&str; 12] = [
    "sqrt", "sin", "cos", "tan", "exp", "log", "atan", "asin", "acos", "sinh", "cosh", "tanh",
];

/// The names of forms, which bind an index or a variable or make a statement; the other names are those of functions of values.
pub const FORMS: [&str; 10] = [
    "sum",
    "product",
    "integral",
    "D",
    "at",
    "agrees",
    "fails",
    "nonnegative",
    "independent",
    "variation_diminishing",
];

/// Whether a name is that of a function of values, such as `asin`. No definition has such a name, since torse names values by
/// them: `asin(x)` is the arc sine of x in every paper.
///
/// ```
/// use torse_syntax::formula::functions::is_function_of_values;
/// assert!(is_function_of_values("asin"));
/// assert!(!is_function_of_values("product") && !is_function_of_values("f"));
/// ```
#[must_use]
pub fn is_function_of_values(name: &str) -> bool {
    is_function(name) && !FORMS.contains(&name)
}

/// Whether a name is that of a function of the language.
#[must_use]
pub fn is_function(name: &str) -> bool {
    FUNCTIONS.contains(&name)
}

/// Why a function that papers use is out of scope, and what to state in its place; none for other names. A claim that calls one
/// without declaring it is undecided, and the other claims of its paper are decided.
///
/// ```
/// use torse_syntax::formula::functions::out_of_scope;
/// assert!(out_of_scope("limit").is_some_and(|why| why.contains("out of scope")));
/// assert_eq!(out_of_scope("sin"), None);
/// ```
#[must_use]
pub fn out_of_scope(name: &str) -> Option<&'static str> {
    Some(match name {
        "limit" | "lim" | "limsup" | "liminf" => {
            "limits are out of scope: state the value of a formula that has one there, or a bound that holds near the place"
        }
        "piecewise" | "cases" => {
            "formulas by cases are out of scope: state a claim for each case, with the case under `assume`, or write `min`, `max` \
             and `abs`"
        }
        "floor" | "ceil" | "ceiling" | "round" | "frac" | "mod" => {
            "rounding to integers is out of scope: state the bounds of the integer, `n <= x` and `x < n + 1`"
        }
        "sign" | "sgn" | "signum" => {
            "signs as numbers are out of scope: write `x/abs(x)`, which has no value at 0"
        }
        "atan2" | "arctan2" => {
            "the angle of a point is out of scope: name it, and state its sine and cosine under `assume`; `atan(y/x)` is it for x > 0"
        }
        "acot" | "asec" | "acsc" | "arccot" | "arcsec" | "arccsc" => {
            "these inverse functions are out of scope, since papers differ in their branches: write them by `atan`, `acos` and `asin`"
        }
        "asinh" | "arcsinh" | "arsinh" => {
            "inverse hyperbolic functions are out of scope: write `log(x + sqrt(x^2 + 1))`"
        }
        "acosh" | "arccosh" | "arcosh" => {
            "inverse hyperbolic functions are out of scope: write `log(x + sqrt(x^2 - 1))`, for x from 1 on"
        }
        "atanh" | "arctanh" | "artanh" => {
            "inverse hyperbolic functions are out of scope: write `log((1 + x)/(1 - x))/2`, for x between -1 and 1"
        }
        _ => return None,
    })
}

/// Why an end without a bound is out of scope, and what to state in its place; none for other names.
///
/// ```
/// use torse_syntax::formula::functions::infinite;
/// assert!(infinite("inf").is_some_and(|why| why.contains("every finite end")));
/// assert_eq!(infinite("t"), None);
/// ```
#[must_use]
pub fn infinite(name: &str) -> Option<&'static str> {
    matches!(name, "inf" | "infinity").then_some(
        "formulas have no infinity, `inf` is an end of an interval: state a value or a bound for every finite end, as `integral(1/x^2, x, 1, b)`",
    )
}

/// How a function is called, and what it means, in a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FunctionDescription {
    /// A call with the names of its arguments.
    pub call: &'static str,
    /// What it means.
    pub says: &'static str,
}

/// Describes a function of the language in a line; `derivations/README.md` says more. None for other names.
///
/// ```
/// use torse_syntax::formula::functions::described;
/// assert_eq!(described("binom").map(|of| of.call), Some("binom(n, k)"));
/// assert_eq!(described("mu"), None);
/// ```
#[must_use]
pub fn described(name: &str) -> Option<FunctionDescription> {
    let (call, says) = match name {
        "sum" => (
            "sum(i, low, high, term)",
            "The sum over i, both ends included.",
        ),
        "product" => (
            "product(i, low, high, factor)",
            "The product over i, both ends included; 1 if there are no factors.",
        ),
        "integral" => (
            "integral(f, x, a, b)",
            "The integral of the formula f by x from a to b.",
        ),
        "D" => (
            "D(e, x, n)",
            "The derivative of the formula e by x, of order n (1 if left out); `D(F)` of a function is a function.",
        ),
        "at" => ("at(e, x, a)", "The formula e with a in place of x."),
        "binom" => ("binom(n, k)", "The binomial coefficient n over k."),
        "factorial" => ("factorial(n)", "The factorial of a number up to 200."),
        "sin" => ("sin(a)", "The sine of an angle in radians."),
        "cos" => ("cos(a)", "The cosine of an angle in radians."),
        "tan" => (
            "tan(a)",
            "The tangent of an angle in radians, sin(a)/cos(a).",
        ),
        "exp" => ("exp(a)", "The exponential function."),
        "log" => ("log(a)", "The natural logarithm of a positive number."),
        "atan" => (
            "atan(a)",
            "The arc tangent: the angle between -pi/2 and pi/2 with this tangent.",
        ),
        "asin" => (
            "asin(a)",
            "The arc sine of a number from -1 to 1: the angle from -pi/2 to pi/2 with this sine.",
        ),
        "acos" => (
            "acos(a)",
            "The arc cosine of a number from -1 to 1, pi/2 - asin(a): the angle from 0 to pi with this cosine.",
        ),
        "cosh" => ("cosh(a)", "The hyperbolic cosine, (exp(a) + exp(-a))/2."),
        "sinh" => ("sinh(a)", "The hyperbolic sine, (exp(a) - exp(-a))/2."),
        "tanh" => ("tanh(a)", "The hyperbolic tangent, sinh(a)/cosh(a)."),
        "sqrt" => ("sqrt(r)", "The root of r that is not negative."),
        "abs" => ("abs(a)", "The absolute value, sqrt(a*a)."),
        "min" => ("min(a, b)", "The smaller one of two numbers."),
        "max" => ("max(a, b)", "The greater one of two numbers."),
        "dot" => ("dot(a, b)", "The scalar product of two vectors."),
        "cross" => ("cross(a, b)", "The vector product of two vectors of space."),
        "det" => ("det(M)", "The determinant: `det([a, b, c])` of three rows."),
        "transpose" => ("transpose(M)", "The transposed matrix."),
        "inverse" => (
            "inverse(M)",
            "The inverse matrix; that its determinant is not zero becomes a condition.",
        ),
        "solve" => (
            "solve(M, b)",
            "The solution x of M*x == b, for a vector or a matrix b.",
        ),
        "norm" => ("norm(v)", "The length of a vector, sqrt(dot(v, v))."),
        "agrees" => (
            "agrees(value, printed)",
            "Says that printed decimals agree with the value.",
        ),
        "fails" => (
            "fails(p)",
            "Says that p is defined and false at some point of the whole domain.",
        ),
        "coefficients" => (
            "coefficients([forms], [unknowns])",
            "The matrix of linear forms: a row for each form, a column for each unknown.",
        ),
        "identity" => ("identity(n)", "The unit matrix with n rows, up to 16."),
        "nonnegative" => (
            "nonnegative(f)",
            "Says that all functions of the basis f are not negative, for every degree.",
        ),
        "independent" => (
            "independent(f)",
            "Says that the functions of the basis f are linearly independent, for every degree.",
        ),
        "variation_diminishing" => (
            "variation_diminishing(f)",
            "Says that a curve of the basis f crosses no line more often than its polygon does.",
        ),
        _ => return None,
    };
    Some(FunctionDescription { call, says })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_is_described_by_a_call_of_it() {
        for name in FUNCTIONS {
            let call = described(name).map(|own| own.call).unwrap_or_default();
            assert!(call.starts_with(&format!("{name}(")), "{name}: {call}");
        }
    }
}
