//! Where a statement with an existential number in it has a value.
//!
//! A statement says nothing where a part of it has no value. With an existential number in that part this is no excuse: the claim
//! says that there is a number for which the statement is *defined and true*. With the witness in place nothing would ask for that
//! any more. So each part with the number in it has a value by the way it is written, or it is a quotient at a place where its
//! divisor becomes a condition of the verdict, or else the claim is refused. The semantics asks at each point, from the text
//! ([`torse_core::Claim`] never sees the number).
//!
//! Of `p implies q` without such a number in p the conclusion counts where p is true; all other implications have values as a whole.

mod sign;

use sign::{Bound, Scope, Sign, has_existential};
use torse_core::{BuiltIn, Family, Node, Statement, Term, Visited};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational::integer;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Operator};

pub(crate) use sign::Signs;

/// The most terms of a sum whose divisors are conditions, one by one: those that the prover reads there, so that none is
/// taken for a condition here which is not stated.
pub const MAX_SUMMANDS: i64 = 8;

/// What becomes of a divisor that may be zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Divisors {
    /// It is a condition of the verdict.
    Conditions,
    /// There is no condition that says so for all terms of a sum, or between the ends of an integral.
    Refused,
}

impl Signs<'_> {
    /// Fails if the statement, in which the outermost binders bind the witnesses, may have no value by the choice of a witness;
    /// `has_free_premise` for an implication of which only the conclusion is about the numbers.
    pub(crate) fn require_values(
        &self,
        statement: &Statement,
        witnesses: usize,
        has_free_premise: bool,
    ) -> Result<(), Fault> {
        match statement {
            _ if injected(InjectedFault::WitnessValueAssumed) => Ok(()),
            Statement::Join(Connective::Implies, _, conclusion) if has_free_premise => {
                self.require_values(conclusion, witnesses, false)
            }
            Statement::Join(Connective::Implies, a, b) => [a, b]
                .into_iter()
                .flat_map(|part| part.terms())
                .try_for_each(|term| self.require_written_value(term, witnesses)),
            Statement::Join(_, a, b) => {
                self.require_values(a, witnesses, false)?;
                self.require_values(b, witnesses, false)
            }
            other => other.terms().into_iter().try_for_each(|term| {
                let (scope, body) = self.opened(term, witnesses);
                self.require(body, &scope, Divisors::Conditions)
            }),
        }
    }

    /// Fails if an end of the set of an existential number may have no value but where a divisor in it, which becomes a condition,
    /// is zero: there is no set there, and so no number in it. The outermost binders bind the witnesses.
    pub(crate) fn require_end(&self, end: &Term, witnesses: usize) -> Result<(), Fault> {
        if injected(InjectedFault::WitnessValueAssumed) {
            return Ok(());
        }
        let (scope, body) = self.opened(end, witnesses);
        let has_value = |node: &Node| match node {
            Node::Apply(function, arguments) => match least_argument(*function) {
                Some(least) => {
                    let mut signs = arguments.iter().map(|own| self.sign(own, &scope, true));
                    signs.all(|sign| sign >= Some(least))
                }
                None => is_arithmetic(node),
            },
            other => is_arithmetic(other),
        };
        if has_only(body, &has_value) {
            return Ok(());
        }
        Err(refused(
            end,
            "an end of the set of an existential number that may have no value by the way it is written",
        ))
    }

    /// Fails if a side of a comparison may have no value.
    fn require_written_value(&self, term: &Term, witnesses: usize) -> Result<(), Fault> {
        let (scope, body) = self.opened(term, witnesses);
        match self.sign(body, &scope, false) {
            Some(_) => Ok(()),
            None => Err(refused(
                term,
                "an implication with an existential number in it, which may have no value by the way it is written",
            )),
        }
    }

    /// What the outermost binders bind to the witnesses, and the term inside of them.
    fn opened<'t>(&self, mut term: &'t Term, witnesses: usize) -> (Scope, &'t Term) {
        let mut scope = Scope::new();
        for _ in 0..witnesses {
            let Node::Let {
                variable,
                value,
                body,
            } = &*term.node
            else {
                break;
            };
            let bound = Bound {
                sign: self.sign(value, &Scope::new(), true),
                is_existential: true,
            };
            scope.insert(variable.number(), bound);
            term = body;
        }
        (scope, term)
    }

    fn require(&self, term: &Term, scope: &Scope, divisors: Divisors) -> Result<(), Fault> {
        if !has_existential(term, scope) {
            return Ok(());
        }
        let within = |part: &Term| self.require(part, scope, divisors);
        let is_free = |part: &Term| !has_existential(part, scope);
        match &*term.node {
            // What a root stands for is no hypothesis here, so nothing in it may lack a value.
            Node::Apply(
                function @ (BuiltIn::SquareRoot
                | BuiltIn::Logarithm
                | BuiltIn::Norm
                | BuiltIn::ArcTangent),
                arguments,
            ) => {
                let least = least_argument(*function);
                let mut signs = arguments.iter().map(|own| self.sign(own, scope, false));
                if signs.all(|sign| sign >= least) {
                    return Ok(());
                }
                Err(refused(
                    term,
                    match function {
                        BuiltIn::SquareRoot => {
                            "a root with an existential number in it, whose radicand may be negative by the way it is written"
                        }
                        BuiltIn::Logarithm => {
                            "a logarithm with an existential number in it, which is not positive by the way it is written"
                        }
                        BuiltIn::ArcTangent => {
                            "an arc tangent with an existential number in it, which may have no value by the way it is written"
                        }
                        _ => {
                            "a length with an existential number in it, which may have no value by the way it is written"
                        }
                    },
                ))
            }
            Node::Apply(
                BuiltIn::ArcSine
                | BuiltIn::Inverse
                | BuiltIn::Solve
                | BuiltIn::Coefficients
                | BuiltIn::Factorial
                | BuiltIn::Binomial
                | BuiltIn::Identity,
                _,
            ) => Err(refused(
                term,
                "a function with an existential number in it that may have no value",
            )),
            Node::Binary(Operator::Divide, above, below) => {
                within(above)?;
                within(below)?;
                self.require_divisor(below, scope, divisors)
            }
            Node::Binary(Operator::Power, base, exponent) => {
                within(base)?;
                match exponent.as_integer() {
                    Some(0..) => Ok(()),
                    Some(_) => self.require_divisor(base, scope, divisors),
                    None if is_free(exponent)
                        && self.sign(exponent, scope, false) >= Some(Sign::Nonnegative) =>
                    {
                        Ok(())
                    }
                    None => Err(refused(
                        term,
                        "a power with an existential number in it whose exponent may be negative",
                    )),
                }
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                within(value)?;
                let inside = self.inside(variable.number(), value, scope);
                self.require(body, &inside, divisors)
            }
            Node::Derivative {
                variable,
                order,
                at,
                body,
                ..
            } => {
                within(at)?;
                self.require_free(order, scope)?;
                let inside = self.inside(variable.number(), at, scope);
                let roots = [
                    BuiltIn::SquareRoot,
                    BuiltIn::Norm,
                    BuiltIn::Logarithm,
                    BuiltIn::ArcTangent,
                    BuiltIn::ArcSine,
                ];
                if has_existential(body, &inside) && roots.iter().any(|own| body.applies(*own)) {
                    return Err(refused(
                        term,
                        "the derivative of a root, a logarithm or an arc with an existential number in it",
                    ));
                }
                self.require(body, &inside, divisors)
            }
            Node::Sum {
                index,
                low,
                high,
                term: body,
            }
            | Node::Product {
                index,
                low,
                high,
                term: body,
            } => {
                self.require_free(low, scope)?;
                self.require_free(high, scope)?;
                let divisors = match (low.as_integer(), high.as_integer()) {
                    (Some(low), Some(high)) if high.saturating_sub(low) < MAX_SUMMANDS => divisors,
                    _ => Divisors::Refused,
                };
                self.require(body, &taking_values(index.number(), scope), divisors)
            }
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => {
                within(low)?;
                within(high)?;
                let inside = taking_values(variable.number(), scope);
                self.require(body, &inside, Divisors::Refused)
            }
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => {
                self.require_free(index, scope)?;
                self.require_free(degree, scope)?;
                arguments.iter().try_for_each(within)?;
                match divides(family) {
                    true => Err(refused(
                        term,
                        "a basis at an existential number, whose seeds or step may have no value",
                    )),
                    false => Ok(()),
                }
            }
            Node::Member(_, indices) => {
                (indices.iter()).try_for_each(|index| self.require_free(index, scope))
            }
            Node::Entry(list, indices) => {
                within(list)?;
                (indices.iter()).try_for_each(|index| self.require_free(index, scope))
            }
            _ => term.parts().into_iter().try_for_each(within),
        }
    }

    /// Fails for a divisor that may be zero where no condition would say so.
    fn require_divisor(
        &self,
        divisor: &Term,
        scope: &Scope,
        divisors: Divisors,
    ) -> Result<(), Fault> {
        let is_never_zero = self.sign(divisor, scope, false) == Some(Sign::Positive);
        if is_never_zero || !has_existential(divisor, scope) {
            return Ok(());
        }
        if divisors == Divisors::Conditions && has_only(divisor, &is_arithmetic) {
            return Ok(());
        }
        Err(refused(
            divisor,
            "a divisor with an existential number in it that cannot be a condition: in a sum, an integral or a function",
        ))
    }

    fn require_free(&self, term: &Term, scope: &Scope) -> Result<(), Fault> {
        match has_existential(term, scope) {
            true => Err(refused(
                term,
                "an existential number where an integer is needed",
            )),
            false => Ok(()),
        }
    }

    /// The scope in which a variable has a value.
    fn inside(&self, variable: u32, value: &Term, scope: &Scope) -> Scope {
        let mut inside = scope.clone();
        let bound = Bound {
            sign: self.sign(value, scope, false),
            is_existential: has_existential(value, scope),
        };
        inside.insert(variable, bound);
        inside
    }
}

/// The least sign that an argument of a root, a logarithm, an arc tangent or a length has to have; `None` of other functions.
fn least_argument(function: BuiltIn) -> Option<Sign> {
    match function {
        BuiltIn::SquareRoot => Some(Sign::Nonnegative),
        BuiltIn::Logarithm => Some(Sign::Positive),
        BuiltIn::Norm | BuiltIn::ArcTangent => Some(Sign::Any),
        _ => None,
    }
}

fn refused(term: &Term, what: &'static str) -> Fault {
    Fault::limit(term.place, what)
}

/// The scope in which a variable takes several values, none of them existential.
fn taking_values(variable: u32, scope: &Scope) -> Scope {
    let mut inside = scope.clone();
    let bound = Bound {
        sign: Some(Sign::Any),
        is_existential: false,
    };
    inside.insert(variable, bound);
    inside
}

/// Whether the value of a node is a formula in those of its parts.
fn is_arithmetic(node: &Node) -> bool {
    match node {
        Node::Apply(function, _) => matches!(
            function,
            BuiltIn::Sine
                | BuiltIn::Cosine
                | BuiltIn::Exponential
                | BuiltIn::SquareRoot
                | BuiltIn::Norm
                | BuiltIn::Dot
                | BuiltIn::Determinant
        ),
        Node::Number(_)
        | Node::Pi
        | Node::Symbol(_)
        | Node::Variable(_)
        | Node::Vector(..)
        | Node::Negative(_)
        | Node::Binary(..)
        | Node::List(_)
        | Node::Let { .. }
        | Node::Opened { .. } => true,
        _ => false,
    }
}

/// Whether a node has a value wherever its parts have.
fn is_total(node: &Node) -> bool {
    match node {
        Node::Binary(Operator::Divide, _, below) => {
            matches!(&*below.node, Node::Number(q) if *q != integer(0))
        }
        Node::Binary(Operator::Power, _, exponent) => {
            matches!(&*exponent.node, Node::Number(q) if q.is_integer() && *q >= integer(0))
        }
        Node::Apply(function, _) => matches!(
            function,
            BuiltIn::Sine | BuiltIn::Cosine | BuiltIn::Exponential | BuiltIn::Dot | BuiltIn::Cross
        ),
        Node::Basis { .. } | Node::Integral { .. } | Node::Derivative { .. } => false,
        _ => true,
    }
}

/// Whether this is so of all parts of a term. Shared parts are visited once.
fn has_only(term: &Term, is_so: &dyn Fn(&Node) -> bool) -> bool {
    let mut seen = Visited::default();
    let mut pending = vec![term];
    while let Some(term) = pending.pop() {
        if !is_so(&term.node) {
            return false;
        }
        if seen.is_new(term) {
            pending.extend(term.parts());
        }
    }
    true
}

/// Whether seeds or step of a family may have no value.
fn divides(family: &Family) -> bool {
    !family
        .formulas()
        .all(|formula| has_only(formula, &is_total))
}
