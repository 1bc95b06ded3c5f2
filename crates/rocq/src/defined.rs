//! Definedness premises: the operations of Rocq are total, so a statement needs as premises that its terms are defined.
//!
//! Follows the table of `derivations/SEMANTICS.md`, line by line. A premise that is true for all values is left out:
//! divisors that are literal numbers, indices and degrees that are literal numbers in their range, and the
//! differentiability of sums, products, sines and cosines.

use crate::code::{Code, Level};
use crate::context::{Context, Kind, Local};
use crate::gap::Untranslatable;
use crate::integer::{affine, literal};
use crate::kinds::kinds;
use crate::shape::Shape;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_core::{BuiltIn, Family, Node, Points, Term, Variable};
use torse_numbers::{Affine, rational};
use torse_syntax::formula::Operator;

/// Maximum number of terms visited for one claim.
const MAX_TERMS: usize = 100_000;

/// Premises, in the order of the text, without duplicates.
#[derive(Debug, Default)]
pub struct Premises {
    found: Vec<Code>,
    seen: usize,
    /// Definitions whose premises are already collected, by address: they contain no bound variable.
    opened: BTreeSet<usize>,
}

impl Premises {
    fn add(&mut self, premise: Code) {
        if !self.found.contains(&premise) {
            self.found.push(premise);
        }
    }

    /// The premises.
    #[must_use]
    pub fn into_vec(self) -> Vec<Code> {
        self.found
    }
}

fn relation(left: &Code, sign: &str, right: &Code) -> Code {
    let text = format!(
        "{} {sign} {}",
        left.within(Level::Sum),
        right.within(Level::Sum)
    );
    Code::new(text, Level::Relation)
}

/// Writes an integer without the mark of its scope, for a place in that scope.
fn plain(code: &Code) -> String {
    let text = code.text();
    match text.strip_suffix("%Z") {
        Some(inner) => match inner.trim_start_matches('(').trim_end_matches(')') {
            number if number.chars().all(|c| c.is_ascii_digit()) => number.to_owned(),
            _ => inner.to_owned(),
        },
        None => text.to_owned(),
    }
}

fn integer_relation(text: String) -> Code {
    Code::atom(format!("({text})%Z"))
}

impl Context<'_> {
    /// Adds the premises under which a term has a value.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value of the term.
    pub fn defined(&mut self, term: &Term, premises: &mut Premises) -> Result<(), Untranslatable> {
        premises.seen += 1;
        if premises.seen > MAX_TERMS {
            return Err(Untranslatable::Size { limit: MAX_TERMS });
        }
        match &*term.node {
            Node::Sum {
                index,
                low,
                high,
                term,
            } => {
                self.defined(low, premises)?;
                self.defined(high, premises)?;
                let (low, high) = (self.index(low)?, self.index(high)?);
                let name = self.bind(index, Kind::Integer);
                let inner = self.gathered(term, premises);
                self.release(index);
                let range = format!("{} <= {name} <= {}", plain(&low), plain(&high));
                for premise in inner? {
                    // The index of a sum is in the range of this sum.
                    if premise.text() == format!("({range})%Z") {
                        continue;
                    }
                    let premise = premise.within(Level::Open);
                    let text = format!("forall {name} : Z, ({range})%Z -> {premise}");
                    premises.add(Code::new(text, Level::Open));
                }
                Ok(())
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                // Applied terms inside the value may have the same variables, with other texts.
                let before = self.locals();
                self.defined(value, premises)?;
                self.put_back(before);
                // The text stands for the variable: there is nothing to bind.
                let local = self.standing_for(value)?;
                let code = Code::atom(local.code.argument());
                self.bind_to(variable, Local { code, ..local });
                self.defined(body, premises)
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                self.defined(order, premises)?;
                self.defined(at, premises)?;
                self.differentiable(variable, order, body, at, premises)
            }
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => {
                for part in [index, degree].into_iter().chain(arguments) {
                    self.defined(part, premises)?;
                }
                self.basis_defined(family, degree, arguments, premises)
            }
            Node::Opened { body, closed, .. } => {
                let address = Arc::as_ptr(&term.node).addr();
                if *closed && !premises.opened.insert(address) {
                    return Ok(());
                }
                self.defined(body, premises)
            }
            _ => {
                for part in term.parts() {
                    self.defined(part, premises)?;
                }
                self.operation_defined(term, premises)
            }
        }
    }

    /// Returns the premises of a single term.
    pub(crate) fn gathered(
        &mut self,
        term: &Term,
        outer: &mut Premises,
    ) -> Result<Vec<Code>, Untranslatable> {
        let mut inner = Premises {
            seen: outer.seen,
            ..Premises::default()
        };
        self.defined(term, &mut inner)?;
        outer.seen = inner.seen;
        Ok(inner.found)
    }

    /// Adds the premises of one operation whose arguments are defined.
    fn operation_defined(
        &mut self,
        term: &Term,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let zero = Code::atom("0");
        match &*term.node {
            Node::Binary(Operator::Divide, _, divisor) if !is_nonzero(divisor) => {
                if self
                    .constant_value(divisor)
                    .is_some_and(|number| number != 0)
                {
                    return Ok(());
                }
                let divisor = self.number(divisor)?;
                premises.add(relation(&divisor, "<>", &zero));
            }
            Node::Binary(Operator::Power, base, exponent) => match literal(exponent) {
                Some(0..) => {}
                Some(_) if is_nonzero(base) => {}
                Some(_) => {
                    let base = self.number(base)?;
                    premises.add(relation(&base, "<>", &zero));
                }
                None => {
                    let (base, exponent) = (self.number(base)?, self.index(exponent)?);
                    let nonzero = relation(&base, "<>", &zero);
                    let natural = integer_relation(format!("0 <= {}", exponent.argument()));
                    premises.add(Code::infix(&natural, "\\/", &nonzero, Level::Either));
                }
            },
            Node::Member(points, indices) => self.in_range(points, indices, premises)?,
            Node::Entry(of, indices) if indices.iter().any(|i| literal(i).is_none()) => {
                self.in_list(of, indices, premises)?;
            }
            Node::Apply(BuiltIn::SquareRoot, arguments) => {
                for argument in arguments.iter().filter(|a| !is_positive(a)) {
                    let argument = self.number(argument)?;
                    premises.add(relation(&zero, "<=", &argument));
                }
            }
            Node::Apply(BuiltIn::Factorial, arguments) => {
                for argument in arguments
                    .iter()
                    .filter(|a| literal(a).is_none_or(|n| n < 0))
                {
                    let argument = self.index(argument)?;
                    premises.add(integer_relation(format!("0 <= {}", argument.argument())));
                }
            }
            Node::Apply(BuiltIn::Coefficients, arguments) => {
                self.coefficients_defined(arguments, premises)?;
            }
            Node::Apply(BuiltIn::Inverse | BuiltIn::Solve, arguments) => {
                if let Some(matrix) = arguments.first() {
                    let matrix = self.value(matrix)?;
                    let det = Code::apply("det", &[matrix.code]);
                    premises.add(relation(&det, "<>", &zero));
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// A place that is a symbol is one of those of its list.
    fn in_list(
        &mut self,
        of: &Term,
        indices: &[Term],
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let lengths = match self.value(of)?.shape {
            Shape::Number => vec![],
            Shape::Vector(length) => vec![length],
            Shape::Matrix(rows, columns) => vec![rows, columns],
        };
        for (index, length) in indices.iter().zip(lengths) {
            if literal(index).is_none() {
                let place = self.index(index)?;
                premises.add(integer_relation(format!(
                    "1 <= {} <= {length}",
                    plain(&place)
                )));
            }
        }
        Ok(())
    }

    fn in_range(
        &mut self,
        points: &Points,
        indices: &[Term],
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        for ((low, high), index) in points.ranges.iter().zip(indices) {
            let number = |end: &Affine| end.as_number();
            if let (Some(low), Some(high), Some(index)) =
                (number(low), number(high), self.constant_value(index))
                && (low..=high).contains(&index)
            {
                continue;
            }
            let code = self.integer(index).ok_or(Untranslatable::Construct(
                "an index that is not made of integers",
            ))?;
            let (low, high) = (affine(self, low)?, affine(self, high)?);
            let index = code.within(Level::Sum);
            premises.add(integer_relation(format!("{low} <= {index} <= {high}")));
        }
        Ok(())
    }

    fn basis_defined(
        &mut self,
        family: &Arc<Family>,
        degree: &Term,
        arguments: &[Term],
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let lowest = family.degree;
        if literal(degree).is_none_or(|degree| degree < i64::from(lowest)) {
            let degree = self.integer(degree).ok_or(Untranslatable::Construct(
                "a degree that is not made of integers",
            ))?;
            premises.add(integer_relation(format!(
                "{lowest} <= {}",
                degree.within(Level::Sum)
            )));
        }
        let given = family.variables.iter().zip(arguments);
        for ((variable, argument), kind) in given.zip(kinds(family)) {
            let code = Code::atom(self.argument_of(argument, &kind)?.argument());
            self.bind_to(variable, Local { code, kind });
        }
        for seed in &family.seeds {
            self.defined(seed, premises)?;
        }
        if let Some(counters) = &family.counters {
            return self.factors_defined(family, counters, degree, premises);
        }
        for factor in [&family.step.0, &family.step.1] {
            self.defined(factor, premises)?;
        }
        Ok(())
    }

    fn differentiable(
        &mut self,
        variable: &Variable,
        order: &Term,
        body: &Term,
        at: &Term,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let at = self.number(at)?;
        let name = self.bind(variable, Kind::Value(Shape::Number));
        let inner = self.gathered(body, premises);
        let rough = rough(body, variable);
        let value = if rough { Some(self.number(body)) } else { None };
        self.release(variable);
        for premise in inner? {
            // A term that does not depend on the variable needs no neighbourhood.
            if !mentions(premise.text(), &name) {
                premises.add(premise);
                continue;
            }
            let near = format!(
                "locally {} (fun {name} => {})",
                at.argument(),
                premise.text()
            );
            premises.add(Code::new(near, Level::Application));
        }
        if let Some(value) = value {
            let order = literal(order)
                .ok_or(Untranslatable::Construct("a derivative of symbolic order"))?;
            let text = format!(
                "ex_derive_n (fun {name} => {}) {order} {}",
                value?.text(),
                at.argument()
            );
            premises.add(Code::new(text, Level::Application));
        }
        Ok(())
    }
}

/// Whether a name occurs in a text.
pub(crate) fn mentions(text: &str, name: &str) -> bool {
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
    text.split(|c: char| !letter(c)).any(|word| word == name)
}

/// Whether a term is nonzero for all values: literal numbers and pi, their products and powers.
fn is_nonzero(term: &Term) -> bool {
    match &*term.node {
        Node::Pi => true,
        Node::Number(value) => *value != rational::integer(0),
        Node::Negative(inner) => is_nonzero(inner),
        Node::Binary(Operator::Multiply | Operator::Divide, a, b) => is_nonzero(a) && is_nonzero(b),
        Node::Binary(Operator::Power, a, n) => literal(n).is_some() && is_nonzero(a),
        Node::Apply(BuiltIn::SquareRoot, arguments) => arguments.iter().all(is_nonzero),
        _ => false,
    }
}

/// Whether a term is a literal number that is not negative.
fn is_positive(term: &Term) -> bool {
    match &*term.node {
        Node::Pi => true,
        Node::Number(value) => *value >= rational::integer(0),
        _ => false,
    }
}

/// Whether a term contains something that is not smooth wherever it is defined: roots, and powers with symbols in the
/// exponent, of terms that may depend on the variable.
fn rough(term: &Term, variable: &Variable) -> bool {
    let depends = |part: &Term| {
        crate::context::Used::from_term(part)
            .variables
            .contains(variable)
    };
    let own = match &*term.node {
        Node::Apply(BuiltIn::SquareRoot | BuiltIn::Norm, _) => {
            !term.parts().iter().all(|a| is_positive(a))
        }
        Node::Binary(Operator::Power, base, exponent) => {
            literal(exponent).is_none() && depends(base)
        }
        _ => false,
    };
    own || term.parts().into_iter().any(|part| rough(part, variable))
}
