//! A statement as a list of words and values, for comparison with another reading of its text.
//!
//! Connectives and relations precede their sides, so no brackets are needed. Negations are moved to the comparisons.
//! For a property of a basis the values of the functions are listed, for printed decimals the printed numbers. Names
//! of statements and `at` are opened. The sides are values, so two readings with equal outlines say the same at this
//! point, whether it is true or not.

use super::environment::Environment;
use super::evaluate::Evaluator;
use crate::arithmetic::Arithmetic;
use crate::no_value::NoValue;
use crate::series::Series;
use crate::value::Value;
use torse_numbers::Rational;
use torse_syntax::derivation::declarations::{Basis, Bound};
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// An item of an outline.
#[derive(Debug, Clone)]
pub enum Piece<T, N> {
    /// A connective, a relation, or the name of a property.
    Word(String),
    /// The value of a side, with its formula if no binder encloses it.
    Value(Option<T>, Result<Value<N>, NoValue>),
}

/// Words and values.
pub type Outline<T, N> = Vec<Piece<T, N>>;

/// The word of a connective.
#[must_use]
pub fn word(connective: Connective) -> String {
    connective.word().to_owned()
}

/// The value of the variable at which functions of a basis are evaluated, as numerator and denominator.
pub const BASIS_AT: (i64, i64) = (355, 113);
/// The number of degrees of a basis that are evaluated, beginning with that of the seeds.
pub const BASIS_DEGREES: i64 = 3;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;
type Pieces<'a, A> = Outline<&'a Expr, <A as Arithmetic>::Number>;

/// A compound that is denied this often: its connective, and how often its first side is denied; the second is as often as the compound.
/// One denial makes `p implies q` the statement `p and not q`, and the next one of that `not p or q`.
const fn denied(connective: Connective, denials: u32) -> (Connective, u32) {
    match (connective, denials % 2) {
        (Connective::Implies, 0) if denials == 0 => (Connective::Implies, 0),
        (Connective::Implies, 0) => (Connective::Or, denials - 1),
        (Connective::Implies, _) => (Connective::And, denials - 1),
        (Connective::And, 0) | (Connective::Or, 1) => (Connective::And, denials),
        (Connective::And | Connective::Or, _) => (Connective::Or, denials),
    }
}

/// A relation that is denied this often.
fn related(relation: Relation, denials: u32) -> Relation {
    match denials % 2 {
        0 => relation,
        _ => relation.opposite(),
    }
}

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Adds the items of a statement that is denied this often.
    pub(super) fn outline(
        &self,
        tree: &'a Expr,
        denials: u32,
        place: &Place<'a, A>,
        all: &mut Pieces<'a, A>,
    ) {
        let Ok(_deeper) = self.deeper() else {
            return all.push(Piece::Word("too deep".to_owned()));
        };
        match &tree.node {
            Node::Join(..) => {
                // Long chains are visited without recursion.
                let (mut left, mut left_denials) = (tree, denials);
                let mut rights = vec![];
                while let Node::Join(connective, a, b) = &left.node {
                    let (connective, first) = denied(*connective, left_denials);
                    all.push(Piece::Word(word(connective)));
                    rights.push((b, left_denials));
                    (left, left_denials) = (a, first);
                }
                self.outline(left, left_denials, place, all);
                for (right, right_denials) in rights.into_iter().rev() {
                    self.outline(right, right_denials, place, all);
                }
            }
            Node::Not(inner) => self.outline(inner, denials.saturating_add(1), place, all),
            Node::Compare(first, rest) => {
                let (joined, _) = denied(Connective::And, denials);
                all.extend(rest.iter().skip(1).map(|_| Piece::Word(word(joined))));
                let mut left = &**first;
                for (relation, right) in rest {
                    all.push(Piece::Word(related(*relation, denials).sign().to_owned()));
                    all.push(self.piece(left, place));
                    all.push(self.piece(right, place));
                    left = right;
                }
            }
            Node::Name(name) => match self.declarations.definition(name) {
                Some(definition) if place.local(name).is_none() => {
                    let body = &definition.body.expr;
                    self.outline(body, denials, &place.outside(), all);
                }
                _ => all.push(Piece::Word(format!("a name, {name}"))),
            },
            Node::Call(head, arguments) => match &head.node {
                Node::Name(name) => self.outline_of_call(name, arguments, denials, place, all),
                _ => all.push(Piece::Word("a value".to_owned())),
            },
            _ => all.push(Piece::Word("a value".to_owned())),
        }
    }

    fn outline_of_call(
        &self,
        name: &'a str,
        arguments: &'a [Expr],
        denials: u32,
        place: &Place<'a, A>,
        all: &mut Pieces<'a, A>,
    ) {
        match (name, arguments) {
            ("at", [inner, name, point]) => match self.bind_at(name, point, place) {
                Ok(inside) => self.outline(inner, denials, &inside, all),
                Err(gap) => all.push(Piece::Value(None, Err(gap))),
            },
            ("fails", [inner]) => {
                all.push(Piece::Word("fails".to_owned()));
                self.outline(inner, 0, place, all);
            }
            ("agrees", [value, printed]) => {
                all.push(Piece::Word(format!("agrees {}", digits(printed))));
                all.push(self.piece(value, place));
            }
            (property, [family, degrees @ ..]) => {
                if let Node::Name(name) = &family.node
                    && let Some(basis) = self.declarations.basis(name)
                {
                    let found = if basis.is_list {
                        self.outline_of_list(name, basis, denials, place, all)
                    } else {
                        self.outline_of_property(property, name, (basis, degrees), place, all)
                    };
                    if let Err(gap) = found {
                        all.push(Piece::Value(None, Err(gap)));
                    }
                } else {
                    all.push(Piece::Word(format!("{property} of something")));
                }
            }
            _ => all.push(Piece::Word(name.to_owned())),
        }
    }

    /// The statement that all functions of a list are nonnegative, denied this often.
    fn outline_of_list(
        &self,
        name: &'a str,
        basis: &'a Basis,
        denials: u32,
        place: &Place<'a, A>,
        all: &mut Pieces<'a, A>,
    ) -> Result<(), NoValue> {
        let arguments = self.left_out(basis, 0, place)?;
        let row = self.row(name, basis, i64::from(basis.degree), arguments, place)?;
        let (joined, _) = denied(Connective::And, denials);
        let joints = row.iter().skip(1);
        all.extend(joints.map(|_| Piece::Word(word(joined))));
        let relation = related(Relation::AtLeast, denials);
        for function in row.iter() {
            all.push(Piece::Word(relation.sign().to_owned()));
            all.push(Piece::Value(None, Ok(Value::Number(function.clone()))));
            all.push(Piece::Value(None, Ok(self.integer_value(0))));
        }
        Ok(())
    }

    /// The outline of a property: its name, and the values of its functions at one value of the variable.
    fn outline_of_property(
        &self,
        property: &str,
        name: &'a str,
        (basis, degrees): (&'a Basis, &'a [Expr]),
        place: &Place<'a, A>,
        all: &mut Pieces<'a, A>,
    ) -> Result<(), NoValue> {
        let degrees = degrees
            .iter()
            .map(|degree| self.integer(degree, "a degree", place));
        let degrees = degrees.collect::<Result<Vec<i64>, _>>()?;
        all.push(Piece::Word(format!(
            "{property} {degrees:?} from {}",
            basis.degree
        )));
        let (u, v) = BASIS_AT;
        let variable = Series::rational(&Rational::new(u.into(), v.into()), self.arithmetic);
        let mut arguments = vec![Value::Number(variable)];
        arguments.extend(self.left_out(basis, 1, place)?);
        let least = i64::from(basis.degree);
        for degree in least..least + BASIS_DEGREES {
            let row = self.row(name, basis, degree, arguments.clone(), place);
            all.push(Piece::Value(
                None,
                row.map(|row| Value::vector(row.to_vec())),
            ));
        }
        Ok(())
    }

    fn piece(&self, tree: &'a Expr, place: &Place<'a, A>) -> Piece<&'a Expr, A::Number> {
        let is_outermost = place.is_outermost();
        Piece::Value(is_outermost.then_some(tree), self.value(tree, place))
    }

    /// The value of a bound of an interval.
    pub(super) fn end(&self, bound: &Bound) -> Result<Value<A::Number>, NoValue> {
        let a = self.arithmetic;
        let turns = Series::Number(a.pi()).times(&Series::rational(&bound.value.turns, a), a)?;
        let rational = Series::rational(&bound.value.rational, a);
        Ok(Value::Number(rational.plus(&turns, a)?))
    }
}

/// The printed numbers of `agrees` in a canonical form.
fn digits(printed: &Expr) -> String {
    let items = match &printed.node {
        Node::List(items) => items.as_slice(),
        _ => std::slice::from_ref(printed),
    };
    let one = |item: &Expr| {
        let (number, is_negative) = match &item.node {
            Node::Negative(inner) => (&inner.node, true),
            number => (number, false),
        };
        match number {
            Node::Number { value, decimals } => printed_number(value, *decimals, is_negative),
            _ => "a formula".to_owned(),
        }
    };
    items.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// A printed number as a word: its absolute value, the number of digits after the point, and the sign.
#[must_use]
pub fn printed_number(size: &Rational, decimals: Option<u32>, is_negative: bool) -> String {
    let sign = if is_negative { "-" } else { "" };
    format!("{sign}{size} to {decimals:?}")
}
