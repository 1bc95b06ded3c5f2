//! What the derivatives of a polynomial in a variable and its functions make: `f' - c*f` and `f'' - 2*c*f' + c^2*f`.

use torse_algebra::{Polynomial, Rational, Symbol};

/// `f' - c*f` where the order is 1; `f'' - 2*c*f' + c^2*f` where it is 2 and `f' - c*f` is zero with the variable.
pub(super) fn slope(
    polynomial: &Polynomial,
    name: &str,
    rate: &Rational,
    order: u32,
) -> Option<Polynomial> {
    let first = less(&polynomial.derivative(name), polynomial, rate);
    match order {
        1 => Some(first),
        _ if at_zero(&first, name)?.is_zero() => Some(less(&first.derivative(name), &first, rate)),
        _ => None,
    }
}

/// `slope - rate*value`.
fn less(slope: &Polynomial, value: &Polynomial, rate: &Rational) -> Polynomial {
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
    [start, grown]: [&Polynomial; 2],
) -> bool {
    let Some(name) = variable.names().next() else {
        return false;
    };
    at_zero(polynomial, name).is_some_and(|value| value == *start)
        && slope(polynomial, name, rate, order).is_some_and(|value| value == *grown)
}
