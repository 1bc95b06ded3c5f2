//! What the derivatives of a polynomial in a variable and its functions make: `f' - c*f` and `f'' - 2*c*f' + c^2*f`.

use torse_algebra::{Polynomial, Rational, Symbol};

/// `slope - rate*value`.
pub(super) fn less(slope: &Polynomial, value: &Polynomial, rate: &Rational) -> Polynomial {
    slope - &value.scaled(rate)
}

/// The polynomial where the variable is zero; `None` if a symbol of it depends on the variable and on others.
pub(super) fn at_zero(polynomial: &Polynomial, name: &str) -> Option<Polynomial> {
    let value = |symbol: &Symbol| match symbol {
        Symbol::Named(_) | Symbol::Sin(..) => Some(Polynomial::zero()),
        Symbol::Cos(..) => Some(Polynomial::integer(1)),
        Symbol::Exp(exponent) if exponent.powers().len() == 1 => Some(Polynomial::integer(1)),
        _ => None,
    };
    let mut own = polynomial.symbols().iter().filter(|s| s.depends_on(name));
    let is_known = own.all(|symbol| value(symbol).is_some());
    is_known.then(|| {
        polynomial.substituted(|symbol| match symbol.depends_on(name) {
            true => value(symbol),
            false => None,
        })
    })
}

/// Whether these are the polynomial where the variable is zero, and what a number and the derivatives make of it.
pub(super) fn is_made(
    polynomial: &Polynomial,
    (variable, rate, order): (&Symbol, &Rational, u32),
    [start, slope]: [&Polynomial; 2],
) -> bool {
    let Some(name) = variable.names().next() else {
        return false;
    };
    let first = less(&polynomial.derivative(name), polynomial, rate);
    let own = match order {
        1 => first,
        _ if at_zero(&first, name).is_none_or(|p| !p.is_zero()) => return false,
        _ => less(&first.derivative(name), &first, rate),
    };
    at_zero(polynomial, name).is_some_and(|value| value == *start) && own == *slope
}
