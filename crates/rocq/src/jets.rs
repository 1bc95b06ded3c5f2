//! Derives a statement about functions from the one about their values and the values of their derivatives.
//!
//! The lemma from core terms has a number for each value of a function, or of a derivative of it, at a place: `c'(u)`
//! is such a number. The printed statement has the functions. A proof is instantiated at the numbers of the functions,
//! `Derive_n c 1 u`; a refutation, or an instance that satisfies the premises, is taken at polynomials that have these
//! numbers at the place. The tactics of `Torse/Jets.v` compute that both then say the same.

use crate::binder::Binder;
use crate::code::Code;
use crate::proposition::Proposition;
use std::collections::BTreeSet;
use torse_syntax::formula::{Expr, Node, Operator, parse};

/// The value of a function, or of one of its derivatives, at a place.
struct Rate {
    function: String,
    order: usize,
    place: Expr,
}

impl Rate {
    /// Parses a formula such as `c'(u)`.
    fn read(expr: &Expr) -> Option<Self> {
        let Node::Call(head, arguments) = &expr.node else {
            return None;
        };
        let (Node::Name(name), [place]) = (&head.node, arguments.as_slice()) else {
            return None;
        };
        let function = name.trim_end_matches('\'');
        Some(Self {
            function: function.to_owned(),
            order: name.len() - function.len(),
            place: place.clone(),
        })
    }

    /// Writes a function's value or derivative at a place.
    fn text(function: &str, order: usize, place: &str) -> String {
        match order {
            0 => format!("({function} {place})"),
            order => format!("(Derive_n {function} {order} {place})"),
        }
    }
}

/// Returns the binders of declared functions, from the premises that these are smooth.
fn functions(printed: &Proposition) -> impl Iterator<Item = &Binder> {
    printed.binders.iter().filter(|binder| {
        let name = binder.names.first().map_or("", String::as_str);
        let smooth = format!("smooth {name}");
        let mut premises = printed.premises.iter();
        premises.any(|premise| premise.text() == smooth)
    })
}

/// Whether a statement is about functions.
pub(crate) fn has_functions(printed: &Proposition) -> bool {
    functions(printed).next().is_some()
}

fn bound<'p>(proposition: &'p Proposition, symbol: &str) -> Option<&'p Binder> {
    let mut binders = proposition.binders.iter();
    binders.find(|binder| *binder.symbol == *symbol)
}

/// Returns all bound names, in order.
pub(crate) fn names(proposition: &Proposition) -> Vec<&str> {
    let names = proposition.binders.iter().flat_map(|binder| &binder.names);
    names.map(String::as_str).collect()
}

/// Writes a place; `value` supplies the text for a name, and for the value of a function.
fn place(expr: &Expr, value: &dyn Fn(&Expr) -> Option<String>) -> Option<String> {
    Some(match &expr.node {
        Node::Number { value, .. } => Code::rational(value).argument(),
        Node::Negative(inner) => format!("(- {})", place(inner, value)?),
        Node::Binary(operator, a, b) => {
            let sign = match operator {
                Operator::Add => '+',
                Operator::Subtract => '-',
                Operator::Multiply => '*',
                Operator::Divide => '/',
                Operator::Power => return None,
            };
            format!("({} {sign} {})", place(a, value)?, place(b, value)?)
        }
        _ => value(expr)?,
    })
}

/// Returns the arguments at which the statement about numbers becomes the printed one; none if that is not seen.
pub(crate) fn numbers(core: &Proposition, printed: &Proposition) -> Option<Vec<String>> {
    let value = |expr: &Expr| standing(printed, expr);
    let mut arguments = vec![];
    for binder in &core.binders {
        let rate = parse(&binder.symbol).ok();
        match rate.as_ref().and_then(Rate::read) {
            Some(rate) => {
                let function = bound(printed, &rate.function)?;
                let place = place(&rate.place, &value)?;
                let own = function.names.iter();
                arguments.extend(own.map(|name| Rate::text(name, rate.order, &place)));
            }
            None => arguments.extend(bound(printed, &binder.symbol)?.names.iter().cloned()),
        }
    }
    Some(arguments)
}

/// Returns what a name, or the value of a function, is in terms of the functions.
fn standing(printed: &Proposition, expr: &Expr) -> Option<String> {
    let single = |binder: &Binder| match binder.names.as_slice() {
        [name] => Some(name.clone()),
        _ => None,
    };
    match &expr.node {
        Node::Name(name) => bound(printed, name).and_then(single),
        _ => {
            let rate = Rate::read(expr)?;
            let function = bound(printed, &rate.function).and_then(single)?;
            let at = place(&rate.place, &|expr| standing(printed, expr))?;
            Some(Rate::text(&function, rate.order, &at))
        }
    }
}

/// Returns the arguments at which the printed statement becomes the one about numbers; none if a function is evaluated
/// at several places.
pub(crate) fn polynomials(core: &Proposition, printed: &Proposition) -> Option<Vec<String>> {
    let taken: BTreeSet<&str> = names(core).into_iter().collect();
    let variable = ["t", "s", "t'", "s'"];
    let variable = variable.iter().find(|name| !taken.contains(*name))?;
    let is_function = |binder: &Binder| functions(printed).any(|own| own.symbol == binder.symbol);
    let mut arguments = vec![];
    for binder in &printed.binders {
        if is_function(binder) {
            for coordinate in 0..binder.names.len() {
                arguments.push(polynomial(core, &binder.symbol, coordinate, variable)?);
            }
            continue;
        }
        match (bound(core, &binder.symbol), binder.rocq_type.as_str()) {
            (Some(own), _) => arguments.extend(own.names.iter().cloned()),
            (None, "R") => arguments.extend(binder.names.iter().map(|_| "0".to_owned())),
            (None, "Z") => arguments.extend(binder.names.iter().map(|_| "0%Z".to_owned())),
            (None, _) => return None,
        }
    }
    Some(arguments)
}

/// Returns the polynomial that stands for a coordinate of a function.
fn polynomial(
    core: &Proposition,
    function: &str,
    coordinate: usize,
    variable: &str,
) -> Option<String> {
    let value = |expr: &Expr| {
        let text = torse_syntax::notation::text(expr);
        match (
            bound(core, &text).map(|own| own.names.as_slice()),
            &expr.node,
        ) {
            (Some([name]), _) => Some(name.clone()),
            // Nothing depends on it, so it is zero.
            (None, Node::Name(_)) => Some("0".to_owned()),
            _ => None,
        }
    };
    let mut at: Option<String> = None;
    let mut terms = vec![];
    for binder in &core.binders {
        let rate = parse(&binder.symbol).ok();
        let Some(rate) = rate.as_ref().and_then(Rate::read) else {
            continue;
        };
        if rate.function != function {
            continue;
        }
        let place = place(&rate.place, &value)?;
        if at.get_or_insert_with(|| place.clone()) != &place {
            return None;
        }
        let number = binder.names.get(coordinate)?;
        let factorial: usize = (1..=rate.order).product();
        let power = format!("({variable} - {place}) * ").repeat(rate.order);
        terms.push(match factorial {
            1 => format!("{power}{number}"),
            _ => format!("{power}({number} / {factorial})"),
        });
    }
    Some(match terms.as_slice() {
        [] => "(fun _ : R => 0)".to_owned(),
        terms => format!("(fun {variable} : R => {})", terms.join(" + ")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::code::Level;

    fn binder(symbol: &str, names: &[&str], rocq_type: &str) -> Binder {
        Binder {
            symbol: symbol.into(),
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            rocq_type: rocq_type.to_owned(),
            together: None,
        }
    }

    fn proposition(binders: Vec<Binder>, smooth: &[&str]) -> Proposition {
        let premise = |name: &&str| Code::new(format!("smooth {name}"), Level::Application);
        Proposition {
            definitions: vec![],
            binders,
            premises: smooth.iter().map(premise).collect(),
            conclusion: Code::atom("True"),
            unknowns: vec![],
            unclear_forms: false,
            alongs: vec![],
        }
    }

    #[test]
    fn numbers_are_derivatives_and_functions_are_polynomials_with_these_numbers() {
        let core = proposition(
            vec![
                binder("c''(phi(u))", &["a1", "a2"], "R"),
                binder("c(phi(u))", &["b1", "b2"], "R"),
                binder("phi(u)", &["p"], "R"),
                binder("u", &["u"], "R"),
            ],
            &[],
        );
        let printed = proposition(
            vec![
                binder("c", &["c'1", "c'2"], "R -> R"),
                binder("phi", &["phi"], "R -> R"),
                binder("u", &["u"], "R"),
            ],
            &["c'1", "c'2", "phi"],
        );
        let at = numbers(&core, &printed).unwrap();
        assert_eq!(at[0], "(Derive_n c'1 2 (phi u))");
        assert_eq!(at[2..], ["(c'1 (phi u))", "(c'2 (phi u))", "(phi u)", "u"]);
        let at = polynomials(&core, &printed).unwrap();
        assert_eq!(at[0], "(fun t : R => (t - p) * (t - p) * (a1 / 2) + b1)");
        assert_eq!(at[2..], ["(fun t : R => p)", "u"]);
    }

    #[test]
    fn a_function_at_two_places_has_no_polynomial_here() {
        let core = proposition(
            vec![
                binder("c(u)", &["a"], "R"),
                binder("c(0)", &["b"], "R"),
                binder("u", &["u"], "R"),
            ],
            &[],
        );
        let functions = vec![binder("c", &["c"], "R -> R"), binder("u", &["u"], "R")];
        let printed = proposition(functions, &["c"]);
        assert_eq!(polynomials(&core, &printed), None);
        assert_eq!(numbers(&core, &printed).unwrap(), ["(c u)", "(c 0)", "u"]);
    }
}
