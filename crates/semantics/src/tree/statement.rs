//! The truth of a statement at a point: SEMANTICS.md, "Statements".
//!
//! Every part is evaluated, so a statement with an undefined part is undefined. Only `fails(p)` is about the domain:
//! its parts do not affect where the statement is defined.

use super::environment::Environment;
use super::evaluate::{Evaluator, Meaning};
use crate::arithmetic::{Arithmetic, Comparison};
use crate::judgement::Judgement;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::value::Value;
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};
use torse_syntax::formula::functions::ELEMENTARY;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// The largest number of digits after the point of a printed number.
const MAX_DECIMALS: u32 = 1000;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

/// The conjunction; false as soon as one side is false.
pub(super) fn both(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

/// The disjunction; true as soon as one side is true.
fn either(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    both(a.map(|t| !t), b.map(|t| !t)).map(|t| !t)
}

/// Joins two judgements by a connective.
pub(crate) fn joined(connective: Connective, a: Judgement, b: Judgement) -> Judgement {
    let (a, b) = match (connective, a, b) {
        (Connective::Implies, Judgement::Undefined(_), b) => {
            (Judgement::Undefined(Undefined::Unasserted), b)
        }
        (Connective::Implies, Judgement::False, Judgement::Undefined(_)) => {
            let unasserted = Judgement::Undefined(Undefined::Unasserted);
            (Judgement::False, unasserted)
        }
        (_, a, b) => (a, b),
    };
    a.joined(b, |a, b| match connective {
        Connective::And => both(a, b),
        Connective::Or => either(a, b),
        Connective::Implies => either(a.map(|t| !t), b),
    })
}

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Judges a statement; terms without a value make it undefined or unknown.
    pub(super) fn truth(&self, tree: &'a Expr, place: &Place<'a, A>) -> Judgement {
        match self.meaning(tree, place) {
            Ok(Meaning::Statement(judgement)) => judgement,
            Ok(Meaning::Value(_)) => NoValue::shape("a number where a statement is needed").into(),
            Err(NoValue::Undefined(Undefined::ZeroDivisor)) => {
                self.divides_by_zero(tree, place).into()
            }
            Err(gap) => gap.into(),
        }
    }

    /// Judges a statement outside of all binders.
    pub(crate) fn truth_of(&self, tree: &'a Expr) -> Judgement {
        self.truth(tree, &Environment::outermost())
    }

    /// Judges a comparison, a negation, or a compound.
    pub(super) fn statement(
        &self,
        tree: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Judgement, NoValue> {
        match &tree.node {
            Node::Compare(first, rest) => self.compared(first, rest, place),
            Node::Not(inner) => {
                let inner = self.truth(inner, place);
                Ok(inner.joined(Judgement::True, |truth, _| truth.map(|t| !t)))
            }
            Node::Join(..) => {
                // Long chains are visited without recursion.
                let mut rights = vec![];
                let mut left = tree;
                while let Node::Join(connective, a, b) = &left.node {
                    rights.push((*connective, b));
                    left = a;
                }
                let mut all = self.truth(left, place);
                while let Some((connective, right)) = rights.pop() {
                    all = joined(connective, all, self.truth(right, place));
                }
                Ok(all)
            }
            _ => Err(NoValue::shape("a formula where a statement is needed")),
        }
    }

    /// `a == b`, `a < b <= c`: the conjunction of all links of the chain.
    fn compared(
        &self,
        first: &'a Expr,
        rest: &'a [(Relation, Expr)],
        place: &Place<'a, A>,
    ) -> Result<Judgement, NoValue> {
        let mut all = Some(true);
        let (mut left_tree, mut left) = (first, self.value(first, place)?);
        for (relation, right_tree) in rest {
            let right = self.value(right_tree, place)?;
            let found = match self.related(*relation, &left, &right)? {
                // At a point that satisfies its hypotheses only approximately, equal numbers may stand for different
                // ones.
                None if !self.point.near && self.is_same(left_tree, right_tree, place) => {
                    Some(matches!(
                        relation,
                        Relation::Equal | Relation::AtMost | Relation::AtLeast
                    ))
                }
                found => found,
            };
            all = both(all, found);
            (left_tree, left) = (right_tree, right);
        }
        Ok(Judgement::from_truth(all))
    }

    /// Whether two formulas apply the same functions to the same rational numbers, so that they are equal although
    /// enclosures cannot show it: `exp(u)` and `exp(1)` at u = 1.
    fn is_same(&self, a: &'a Expr, b: &'a Expr, place: &Place<'a, A>) -> bool {
        match (&a.node, &b.node) {
            (Node::Call(f, x), Node::Call(g, y)) => {
                let is_elementary = match &f.node {
                    Node::Name(name) => ELEMENTARY.contains(&name.as_str()),
                    _ => false,
                };
                let mut pairs = x.iter().zip(y);
                is_elementary
                    && f.node == g.node
                    && x.len() == y.len()
                    && pairs.all(|(x, y)| self.is_same(x, y, place))
            }
            (Node::Negative(a), Node::Negative(b)) => self.is_same(a, b, place),
            (Node::Binary(f, a, b), Node::Binary(g, c, d)) if f == g => {
                self.is_same(a, c, place) && self.is_same(b, d, place)
            }
            _ => {
                let rational = |tree: &'a Expr| {
                    let value = self.value(tree, place).ok()?;
                    match value {
                        Value::Number(number) => self.arithmetic.as_rational(number.as_number()?),
                        _ => None,
                    }
                };
                rational(a).is_some_and(|a| rational(b) == Some(a))
            }
        }
    }

    /// Whether two values have a relation.
    pub(super) fn related(
        &self,
        relation: Relation,
        left: &Value<A::Number>,
        right: &Value<A::Number>,
    ) -> Result<Option<bool>, NoValue> {
        let a = self.arithmetic;
        let mut all = vec![];
        for (x, y) in left.pairs(right, a)? {
            let (Some(x), Some(y)) = (x.as_number(), y.as_number()) else {
                return Err(NoValue::shape("an infinitesimal to a comparison"));
            };
            all.push(a.compare(x, y)?);
        }
        let equal = || {
            let each = all.iter().map(|comparison| comparison.equal());
            each.fold(Some(true), both)
        };
        let truth = match all.as_slice() {
            [only] => only.relation(relation),
            _ if relation == Relation::Equal => equal(),
            _ if relation == Relation::Different => equal().map(|e| !e),
            _ => return Err(NoValue::shape("an order of vectors")),
        };
        let is_thin = matches!(
            relation,
            Relation::Different | Relation::Less | Relation::Greater
        );
        // Sides that are equal at this point may differ at the point beside it that satisfies the hypotheses exactly.
        let unsettled = is_thin && a.is_beside_domain() && equal() == Some(true);
        Ok(truth.filter(|_| !unsettled))
    }

    /// The built-in functions that are statements.
    pub(super) fn stated(
        &self,
        name: &str,
        arguments: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Result<Judgement, NoValue> {
        match (name, arguments) {
            ("agrees", [value, printed]) => {
                let value = self.value(value, place)?;
                Ok(Judgement::from_truth(self.agrees(&value, printed)?))
            }
            ("fails", [inner]) => {
                if (self.point.failing)(inner) {
                    return Ok(Judgement::True);
                }
                match self.truth(inner, place) {
                    Judgement::False => Ok(Judgement::True),
                    _ => {
                        let what = "a denial without a point where the denied statement fails";
                        Err(Unknown::NotCovered { what }.into())
                    }
                }
            }
            (_, [family, degrees @ ..]) => self.property(name, family, degrees, place),
            _ => Err(NoValue::shape("a number of arguments")),
        }
    }

    /// Whether every entry agrees with its printed number, rounded or truncated to the printed number of digits.
    fn agrees(&self, value: &Value<A::Number>, printed: &Expr) -> Result<Option<bool>, NoValue> {
        let items = match &printed.node {
            Node::List(items) => items.as_slice(),
            _ => std::slice::from_ref(printed),
        };
        let printed: Option<Vec<Printed>> = items.iter().map(Printed::new).collect();
        let printed = printed.ok_or_else(|| NoValue::shape("a formula for a printed number"))?;
        let values = value.numbers();
        if values.len() != printed.len() {
            return Err(NoValue::shape("the printed numbers to the value"));
        }
        // An integer among decimals is read with as many digits as the decimal with the fewest digits.
        let decimals = printed.iter().map(|p| p.decimals).filter(|d| *d > 0);
        let fewest = decimals.min().unwrap_or(0);
        let mut all = Some(true);
        for (value, printed) in values.into_iter().zip(&printed) {
            let value = value.as_number();
            let value = value.ok_or_else(|| NoValue::shape("an infinitesimal"))?;
            all = both(all, self.agrees_with(value, printed, fewest)?);
        }
        Ok(all)
    }

    fn agrees_with(
        &self,
        value: &A::Number,
        printed: &Printed,
        fewest: u32,
    ) -> Result<Option<bool>, NoValue> {
        let a = self.arithmetic;
        let compared = |q: Rational| a.compare(value, &a.rational(&q));
        let decimals = match printed.decimals {
            0 => fewest,
            own => own,
        };
        if decimals == 0 {
            // If only integers are printed they are exact.
            return Ok(compared(printed.value.clone())?.exactly_equal());
        }
        if decimals > MAX_DECIMALS {
            let what = "a number of printed digits";
            return Err(Unknown::Large { what }.into());
        }
        let digits = usize::try_from(decimals).unwrap_or(usize::MAX);
        let unit = Rational::new(1.into(), Integer::from(10).pow(digits));
        let half = &unit / integer(2);
        let not = |truth: Option<bool>| truth.map(|t| !t);
        let rounded = both(
            not(compared(&printed.value - &half)?.less()),
            not(compared(&printed.value + &half)?.greater()),
        );
        // Truncated: the value lies between the printed number and the next one away from zero.
        let cut = if printed.is_negative {
            both(
                not(compared(printed.value.clone())?.greater()),
                compared(&printed.value - &unit)?.greater(),
            )
        } else {
            both(
                not(compared(printed.value.clone())?.less()),
                compared(&printed.value + &unit)?.less(),
            )
        };
        Ok(either(rounded, cut))
    }
}

/// A printed number.
struct Printed {
    value: Rational,
    /// The number of digits after the point; 0 for an integer.
    decimals: u32,
    /// Whether a minus sign is printed; needed for `-0.00`.
    is_negative: bool,
}

impl Printed {
    fn new(item: &Expr) -> Option<Self> {
        let (number, is_negative) = match &item.node {
            Node::Negative(inner) => (&inner.node, true),
            other => (other, false),
        };
        let Node::Number { value, decimals } = number else {
            return None;
        };
        Some(Self {
            value: if is_negative {
                -value.clone()
            } else {
                value.clone()
            },
            decimals: decimals.unwrap_or(0),
            is_negative,
        })
    }
}

impl Comparison {
    /// Whether the numbers have a relation.
    fn relation(self, relation: Relation) -> Option<bool> {
        match relation {
            Relation::Equal => self.equal(),
            Relation::Different => self.equal().map(|e| !e),
            Relation::Less => self.less(),
            Relation::Greater => self.greater(),
            Relation::AtMost => self.greater().map(|g| !g),
            Relation::AtLeast => self.less().map(|l| !l),
        }
    }

    /// Whether the numbers are equal, or as close as only equal numbers are expected to be.
    fn equal(self) -> Option<bool> {
        match self {
            Self::Equal | Self::Near => Some(true),
            Self::Less | Self::Greater | Self::Apart => Some(false),
            Self::Open => None,
        }
    }

    fn exactly_equal(self) -> Option<bool> {
        match self {
            Self::Near => None,
            other => other.equal(),
        }
    }

    /// Whether the first is less.
    pub(super) fn less(self) -> Option<bool> {
        match self {
            Self::Less => Some(true),
            Self::Equal | Self::Greater => Some(false),
            Self::Near | Self::Apart | Self::Open => None,
        }
    }

    /// Whether the first is greater.
    pub(super) fn greater(self) -> Option<bool> {
        match self {
            Self::Greater => Some(true),
            Self::Equal | Self::Less => Some(false),
            Self::Near | Self::Apart | Self::Open => None,
        }
    }
}
