//! What names of the standard library of Rust mean.

use torse_numbers::rational::{integer, ratio};
use torse_syntax::formula::{Expr, Operator};

/// A constant of `std::f64::consts`.
pub(super) fn constant(name: &str) -> Option<Expr> {
    let pi = |above: i64, below: i64| {
        let factor = ratio(above, below)?;
        let pi = Expr::name(crate::program::operation::PI);
        Some(Expr::number(&factor).with(Operator::Multiply, pi))
    };
    match name {
        "PI" => Some(Expr::name(crate::program::operation::PI)),
        "TAU" => pi(2, 1),
        "FRAC_PI_2" => pi(1, 2),
        "FRAC_PI_3" => pi(1, 3),
        "FRAC_PI_4" => pi(1, 4),
        "FRAC_PI_6" => pi(1, 6),
        "FRAC_PI_8" => pi(1, 8),
        "E" => Some(crate::program::call(
            "exp",
            vec![Expr::number(&integer(1))],
            Default::default(),
        )),
        "SQRT_2" => Some(crate::program::call(
            "sqrt",
            vec![Expr::number(&integer(2))],
            Default::default(),
        )),
        _ => None,
    }
}

/// The constants that a `use` names.
pub(super) fn imported_constants(declaration: &str) -> Vec<String> {
    let Some((path, rest)) = declaration.split_once("consts::") else {
        return vec![];
    };
    if !path.ends_with("f64::") && !path.ends_with("f32::") {
        return vec![];
    }
    let names = rest.trim_end_matches(';').trim_matches(['{', '}', ' ']);
    let names = names.split(',').map(|name| name.trim().to_owned());
    names.filter(|name| !name.is_empty()).collect()
}

/// The function of formulas that a method without arguments is.
pub(super) fn elementary(method: &str) -> Option<&'static str> {
    let all = [
        "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh", "sqrt", "abs", "atan", "asin", "acos",
    ];
    match method {
        "ln" => Some("log"),
        _ => all.into_iter().find(|known| *known == method),
    }
}
