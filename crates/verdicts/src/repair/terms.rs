//! Writes a formula as a sum of products of the names in it, and back.
//!
//! Names, members of families, calls and brackets of control points stay whole ([`Atoms`]): `a1` is not expanded, and
//! neither is `Q[m] - Q[m-1]` as a factor.

use num_traits::{Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator};

/// Maximum number of terms of an expanded formula.
pub const MAX_TERMS: usize = 60;

/// Exponents by the number of the atom; none is zero.
pub type Powers = BTreeMap<usize, i32>;

/// Terms: powers and their coefficients, in the order of the text; no coefficient is zero.
pub type Terms = Vec<(Powers, Rational)>;

/// The formulas that are not taken apart.
#[derive(Debug, Default)]
pub struct Atoms(Vec<Expr>);

impl Atoms {
    /// The atoms in order.
    #[must_use]
    pub fn all(&self) -> &[Expr] {
        &self.0
    }

    /// Returns the number of an atom; adds it if it is new.
    pub fn number(&mut self, expr: &Expr) -> usize {
        let text = torse_syntax::notation::text(expr);
        let known = self
            .0
            .iter()
            .position(|e| torse_syntax::notation::text(e) == text);
        known.unwrap_or_else(|| {
            self.0.push(expr.clone());
            self.0.len() - 1
        })
    }

    /// Returns the formula as terms; none if it has too many, or is a list or a statement.
    pub fn expanded(&mut self, expr: &Expr) -> Option<Terms> {
        let atom = |powers: Powers| Some(vec![(powers, integer(1))]);
        match &expr.node {
            Node::Number { value, .. } => Some(sum(vec![(Powers::new(), value.clone())])),
            Node::Negative(inner) => Some(scaled(self.expanded(inner)?, &integer(-1))),
            Node::Binary(Operator::Add, a, b) => {
                let (mut a, b) = (self.expanded(a)?, self.expanded(b)?);
                a.extend(b);
                Some(sum(a)).filter(|terms| terms.len() <= MAX_TERMS)
            }
            Node::Binary(Operator::Subtract, a, b) => {
                let (mut a, b) = (self.expanded(a)?, self.expanded(b)?);
                a.extend(scaled(b, &integer(-1)));
                Some(sum(a)).filter(|terms| terms.len() <= MAX_TERMS)
            }
            Node::Binary(Operator::Multiply, a, b) => {
                let (a, b) = (self.factor(a)?, self.factor(b)?);
                product(&a, &b)
            }
            Node::Binary(Operator::Divide, a, b) => {
                let (a, b) = (self.factor(a)?, self.factor(b)?);
                match b.as_slice() {
                    [(powers, value)] => {
                        let inverse = powers.iter().map(|(atom, e)| (*atom, -e)).collect();
                        product(&a, &vec![(inverse, value.recip())])
                    }
                    // A sum in a denominator stays whole.
                    _ => {
                        let below = match &expr.node {
                            Node::Binary(_, _, below) => self.number(below),
                            _ => return None,
                        };
                        product(&a, &vec![(Powers::from([(below, -1)]), integer(1))])
                    }
                }
            }
            Node::Binary(Operator::Power, a, b) => {
                let Node::Number { value, .. } = &b.node else {
                    return atom(Powers::from([(self.number(expr), 1)]));
                };
                let exponent = value.is_integer().then(|| value.to_integer().to_u32());
                let exponent = exponent.flatten().filter(|e| *e <= 8)?;
                let base = self.factor(a)?;
                let one = vec![(Powers::new(), integer(1))];
                (0..exponent).try_fold(one, |power, _| product(&power, &base))
            }
            Node::Name(_) | Node::Index(..) | Node::Call(..) => {
                atom(Powers::from([(self.number(expr), 1)]))
            }
            _ => None,
        }
    }

    /// A factor: a bracket of control points stays whole.
    fn factor(&mut self, expr: &Expr) -> Option<Terms> {
        if is_points(expr) && matches!(expr.node, Node::Binary(..)) {
            return Some(vec![(Powers::from([(self.number(expr), 1)]), integer(1))]);
        }
        self.expanded(expr)
    }

    /// Returns the terms as a formula, with common factors before brackets; of several common factors, those of
    /// `outermost` go outside, in their order.
    #[must_use]
    pub fn collected(&self, terms: &Terms, outermost: &[usize]) -> Expr {
        let mut counts: BTreeMap<(usize, bool), usize> = BTreeMap::new();
        for (powers, _) in terms {
            for (atom, exponent) in powers {
                *counts.entry((*atom, *exponent > 0)).or_default() += 1;
            }
        }
        counts.retain(|_, count| *count > 1);
        let rank = |((atom, above), count): &((usize, bool), usize)| {
            let outer = outermost.iter().position(|o| o == atom);
            let bracket = self.0.get(*atom).is_some_and(is_points);
            let first = outer.unwrap_or(outermost.len());
            (first, !bracket, terms.len() - count, !above, *atom)
        };
        let Some(((atom, above), _)) = counts.into_iter().min_by_key(rank) else {
            return self.written(terms);
        };
        let divisible = |powers: &Powers| {
            let exponent = powers.get(&atom).copied().unwrap_or(0);
            exponent != 0 && (exponent > 0) == above
        };
        let (with, without): (Terms, Terms) = terms
            .iter()
            .cloned()
            .partition(|(powers, _)| divisible(powers));
        let exponents = with.iter().filter_map(|(powers, _)| powers.get(&atom));
        let common = if above {
            exponents.min()
        } else {
            exponents.max()
        };
        let common = common.copied().unwrap_or(1);
        let rest: Terms = with
            .into_iter()
            .map(|(mut powers, value)| {
                let exponent = powers.remove(&atom).unwrap_or(0) - common;
                if exponent != 0 {
                    powers.insert(atom, exponent);
                }
                (powers, value)
            })
            .collect();
        // The printed order is kept: a bracket that comes later takes the sign of its first term.
        let leads = terms.first().is_some_and(|(powers, _)| divisible(powers));
        let negative = !leads && rest.first().is_some_and(|(_, value)| value.is_negative());
        let content = content(&rest);
        let sign = integer(if negative { -1 } else { 1 });
        let inner = self.collected(&scaled(rest, &(sign / &content)), outermost);
        let factor = self.written(&vec![(Powers::from([(atom, common)]), content)]);
        let bracket = match &factor.node {
            // 2/x with a bracket: the bracket goes into the numerator.
            Node::Binary(Operator::Divide, top, below) => {
                let one = Expr::number(&integer(1));
                let top = if top.node == one.node {
                    inner
                } else {
                    (**top).clone().with(Operator::Multiply, inner)
                };
                top.with(Operator::Divide, (**below).clone())
            }
            _ => factor.with(Operator::Multiply, inner),
        };
        if without.is_empty() {
            return bracket;
        }
        let rest = self.collected(&without, outermost);
        match (leads, rest.node) {
            (true, Node::Negative(rest)) => {
                bracket.with(Operator::Subtract, Arc::unwrap_or_clone(rest))
            }
            (true, rest) => bracket.with(Operator::Add, Expr::made(rest)),
            (false, rest) if negative => Expr::made(rest).with(Operator::Subtract, bracket),
            (false, rest) => Expr::made(rest).with(Operator::Add, bracket),
        }
    }

    /// Returns the terms as a plain sum, with a positive one first.
    fn written(&self, terms: &Terms) -> Expr {
        let mut terms: Vec<&(Powers, Rational)> = terms.iter().collect();
        if let Some(first) = terms.iter().position(|(_, value)| value.is_positive()) {
            let term = terms.remove(first);
            terms.insert(0, term);
        }
        let mut sum: Option<Expr> = None;
        for (powers, value) in terms {
            let term = self.term(powers, &value.abs());
            sum = Some(match (sum, value.is_negative()) {
                (None, false) => term,
                (None, true) => Expr::made(Node::Negative(Arc::new(term))),
                (Some(sum), false) => sum.with(Operator::Add, term),
                (Some(sum), true) => sum.with(Operator::Subtract, term),
            });
        }
        sum.unwrap_or_else(|| Expr::number(&integer(0)))
    }

    fn term(&self, powers: &Powers, value: &Rational) -> Expr {
        let part = |sign: i32| {
            let atoms = powers.iter().filter(move |(_, e)| e.signum() == sign);
            atoms.filter_map(|(atom, e)| {
                let base = self.0.get(*atom)?.clone();
                let exponent = Expr::number(&integer(i64::from(e.abs())));
                Some(match e.abs() {
                    1 => base,
                    _ => base.with(Operator::Power, exponent),
                })
            })
        };
        let times = |a: Expr, b: Expr| a.with(Operator::Multiply, b);
        let above: Vec<Expr> = part(1).collect();
        let number = (above.is_empty() || *value != integer(1)).then(|| Expr::number(value));
        let top = number.into_iter().chain(above).reduce(times);
        let top = top.unwrap_or_else(|| Expr::number(&integer(1)));
        match part(-1).reduce(times) {
            Some(below) => top.with(Operator::Divide, below),
            None => top,
        }
    }
}

/// Whether a formula is a linear combination of members of families with numbers.
fn is_points(expr: &Expr) -> bool {
    match &expr.node {
        Node::Index(..) => true,
        Node::Negative(inner) => is_points(inner),
        Node::Binary(Operator::Add | Operator::Subtract, a, b) => is_points(a) && is_points(b),
        Node::Binary(Operator::Multiply, a, b) => {
            matches!(a.node, Node::Number { .. }) && is_points(b)
        }
        _ => false,
    }
}

/// Terms with like powers added, in the order of first appearance.
fn sum(terms: Terms) -> Terms {
    let mut result: Terms = vec![];
    for (powers, value) in terms {
        match result.iter_mut().find(|(p, _)| *p == powers) {
            Some((_, total)) => *total += value,
            None => result.push((powers, value)),
        }
    }
    result.retain(|(_, value)| !value.is_zero());
    result
}

fn scaled(terms: Terms, by: &Rational) -> Terms {
    let scale = |(powers, value): (Powers, Rational)| (powers, value * by);
    terms.into_iter().map(scale).collect()
}

/// The product of two sums.
#[must_use]
pub fn product(a: &Terms, b: &Terms) -> Option<Terms> {
    if a.len() * b.len() > MAX_TERMS * 4 {
        return None;
    }
    let mut terms = vec![];
    for (p, x) in a {
        for (q, y) in b {
            let mut powers = p.clone();
            for (atom, exponent) in q {
                *powers.entry(*atom).or_default() += exponent;
            }
            powers.retain(|_, e| *e != 0);
            terms.push((powers, x * y));
        }
    }
    Some(sum(terms)).filter(|terms| terms.len() <= MAX_TERMS)
}

/// Returns the greatest common divisor of integer coefficients, one otherwise.
fn content(terms: &Terms) -> Rational {
    use num_integer::Integer;
    let integers: Option<Vec<i64>> = terms
        .iter()
        .map(|(_, v)| v.is_integer().then(|| v.to_integer().to_i64()).flatten())
        .collect();
    let divisor = integers.unwrap_or_default().iter().fold(0, |g, n| g.gcd(n));
    integer(divisor.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    fn written(text: &str, outermost: &str) -> String {
        let mut atoms = Atoms::default();
        let first = parse(outermost).map(|e| atoms.number(&e)).unwrap_or(0);
        let terms = parse(text).ok().and_then(|e| atoms.expanded(&e));
        let terms = terms.unwrap_or_default();
        torse_syntax::notation::text(&atoms.collected(&terms, &[first]))
    }

    #[test]
    fn terms_are_collected_with_the_named_factor_outside() {
        assert_eq!(
            written("2*a*b - a*pi^2 + 2*a*pi^2*mu + 2*pi^2*nu", "a"),
            "a*(2*b - pi^2*(1 - 2*mu)) + 2*pi^2*nu"
        );
        assert_eq!(written("16*k^3 - 16*k^4", "k"), "16*k^3*(1 - k)");
    }

    #[test]
    fn brackets_of_control_points_stay_whole() {
        assert_eq!(
            written("P[m] + c/b*(P[m] - P[m-1]) - 2/b*(P[m] - P[m-1])", "c"),
            "P[m] + (P[m] - P[m-1])*((c - 2)/b)"
        );
    }

    #[test]
    fn what_cancels_is_gone() {
        assert_eq!(written("(x + y)*(x - y) - x^2", "x"), "-y^2");
        assert_eq!(written("x - x", "x"), "0");
    }
}
