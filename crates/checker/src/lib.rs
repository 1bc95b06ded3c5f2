//! The checker: it checks proofs, and never searches for one.
//!
//! A proof is checked against the *core claim*, with plain polynomials and without any code of the prover. The tree
//! of the proof must follow the structure of the statement; at its leaves the terms are expanded as they stand. A
//! step that fails is [`Wrong`]. A step that the checker does not know, such as a series of symbolic degree, is
//! [`Unsupported`], which is no evidence against the proof.

mod apart;
mod arc;
mod assumptions;
mod bernstein;
mod eliminated;
mod ends;
mod even;
mod expand;
mod functions;
mod gap;
mod integral;
mod line;
mod nonzero;
mod point;
mod printed;
mod quotient;
mod range;
mod root;
mod sign;
mod statement;
mod taylor;
mod turn;
mod value;
mod variation;

pub use gap::{CheckError, Unsupported, Work, Wrong};

use assumptions::Domain;
use point::At;
use sign::Signs;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::refutation::Refuted;
use torse_certificate::proof::{Emptiness, Instance, Proof, ZeroSide};
use torse_certificate::sign::Sign;
use torse_certificate::symbol::Symbol;
use torse_core::{Claim, Hypothesis, Set, Source, Statement, stack};
use torse_syntax::derivation::Origin;
use torse_syntax::formula::{Connective, Relation};

/// The largest number of products of terms for one claim.
pub const WORK: u64 = 400_000;
/// The largest number of instances.
const MAX_INSTANCES: usize = 400;
/// The most clauses.
const MAX_CLAUSES: usize = 64;

/// Checks a proof of the statement of a claim, under the conditions that these polynomials do not vanish.
///
/// # Errors
/// [`CheckError`] if the proof is wrong, or not supported.
pub fn proves(
    claim: &Claim,
    origin: &Origin,
    conditions: &[Polynomial],
    proof: &Proof<Polynomial>,
    work: &Work,
) -> Result<(), CheckError> {
    let exponential = Cell::new(conditions.iter().any(has_exponential));
    proof.map(&|p| exponential.set(exponential.get() || has_exponential(p)));
    without(&exponential)?;
    let check = Check {
        origin,
        conditions,
        zeros: &[],
        work,
    };
    work.judged(stack::deep(|| {
        check.proof(&with_roots(claim, origin)?, proof, &BTreeMap::new())
    }))
}

/// Checks a refutation of the statement of a claim.
///
/// # Errors
/// [`CheckError`] if it refutes nothing, or is not supported.
pub fn refutes(
    claim: &Claim,
    origin: &Origin,
    refuted: &Refuted<Polynomial>,
    work: &Work,
) -> Result<(), CheckError> {
    let exponential = Cell::new(false);
    refuted.map(&|p| exponential.set(exponential.get() || has_exponential(p)));
    without(&exponential)?;
    let check = Check {
        origin,
        conditions: &[],
        zeros: &[],
        work,
    };
    work.judged(stack::deep(|| {
        check.refutation(&with_roots(claim, origin)?, refuted, &BTreeMap::new())
    }))
}

/// The claim with roots replaced by symbols, and the hypotheses that define them; proofs are about this claim.
fn with_roots(claim: &Claim, origin: &Origin) -> Result<Claim, CheckError> {
    let rooted = claim.rooted(origin);
    rooted.map_err(|_| Unsupported::Construct("such a root").into())
}

fn has_exponential(p: &Polynomial) -> bool {
    p.symbols().any(|s| matches!(s, Symbol::Exponential(_)))
}

/// Refuses exponentials, because the checker knows neither their ranges nor their order.
fn without(exponential: &Cell<bool>) -> Result<(), CheckError> {
    if exponential.get() {
        return Err(Unsupported::Construct("an exponential").into());
    }
    Ok(())
}

struct Check<'a> {
    /// The origin of the statement.
    origin: &'a Origin,
    /// Polynomials that are nonzero: the conditions of the verdict, and the pivots of the case splits in whose
    /// nonzero case the proof is.
    conditions: &'a [Polynomial],
    /// Polynomials that are zero: the pivots of the case splits in whose zero case the proof is.
    zeros: &'a [Polynomial],
    work: &'a Work,
}

type Integers = BTreeMap<String, i64>;

impl Check<'_> {
    fn proof(
        &self,
        claim: &Claim,
        proof: &Proof<Polynomial>,
        integers: &Integers,
    ) -> Result<(), CheckError> {
        let beyond = |what| Err(Unsupported::Construct(what).into());
        match (&claim.statement, proof) {
            (Statement::Join(Connective::And, a, b), Proof::Both(first, second)) => {
                let (a, b) = conjuncts(claim, a, b)?;
                self.proof(&a, first, integers)?;
                self.proof(&b, second, integers)
            }
            (Statement::Not(inner), Proof::Exists(refuted)) => {
                self.refutation(&stating(claim, inner), refuted, integers)
            }
            (
                statement,
                Proof::Alternative {
                    place,
                    where_others_fail,
                    proof,
                },
            ) => {
                let parts = alternatives(statement);
                let chosen = parts.get(*place).ok_or(Wrong::Kind)?;
                let mut chosen = stating(claim, chosen);
                if *where_others_fail {
                    for (_, other) in parts.iter().enumerate().filter(|(n, _)| n != place) {
                        let denied = Statement::Not(Box::new((*other).clone()));
                        chosen.hypotheses.push(self.assumed(denied));
                    }
                }
                self.proof(&chosen, proof, integers)
            }
            (
                Statement::Join(Connective::Implies, premise, conclusion),
                Proof::Conclusion(proof),
            ) => {
                let mut restricted = stating(claim, conclusion);
                restricted
                    .hypotheses
                    .push(self.assumed((**premise).clone()));
                self.proof(&restricted, proof, integers)
            }
            (_, Proof::Instances(instances)) => self.instances(claim, instances, integers),
            (_, Proof::On(ground)) if matches!(ground.proof, Proof::Nowhere(_)) => {
                beyond("a domain without points")
            }
            (_, Proof::On(ground)) => {
                let facts = (self.conditions, self.zeros);
                let own = || Domain::new(claim, facts, Some(ground), integers, self.work);
                let nonzero = nonzero(&own(), &ground.nonzero)?;
                let domain = own().with_nonzero(nonzero);
                match (statement::check(&domain, ground), domain.unread()) {
                    (Err(CheckError::Wrong(_)), Some(gap)) => Err(gap.into()),
                    (checked, _) => checked,
                }
            }
            (_, Proof::Defined(proof)) => {
                // The conditions must follow from the definedness of the terms.
                let check = Check {
                    conditions: &[],
                    ..*self
                };
                check.proof(claim, proof, integers)
            }
            // The conditions say where the statement is defined, which no proof of its truth needs.
            (_, Proof::Within { proof, .. }) => self.proof(claim, proof, integers),
            // A constant is either zero or nonzero.
            (_, Proof::Split(split)) => {
                let with = |all: &[Polynomial]| [all, std::slice::from_ref(&split.pivot)].concat();
                let (conditions, zeros) = (with(self.conditions), with(self.zeros));
                let nonzero = Check {
                    conditions: &conditions,
                    ..*self
                };
                let zero = Check {
                    zeros: &zeros,
                    ..*self
                };
                match &split.zero {
                    ZeroSide::Proved(proof) => {
                        nonzero.proof(claim, &split.nonzero, integers)?;
                        zero.proof(claim, proof, integers)
                    }
                    // That the pivot is nonzero is a condition of the verdict.
                    ZeroSide::Fails(refuted) => {
                        self.proof(claim, &split.nonzero, integers)?;
                        match self.refutation(claim, refuted, integers) {
                            Err(wrong @ CheckError::Wrong(_)) => Err(wrong),
                            Ok(()) | Err(CheckError::Unsupported(_)) => Ok(()),
                        }
                    }
                }
            }
            // A number is not negative or not positive.
            (_, Proof::Sides(sides)) => {
                let mut sizes = claim.sizes();
                let argument = sizes.find(|(name, _)| ***name == sides.root);
                let (_, argument) = argument.ok_or(Wrong::Kind)?;
                let side = |relation| claim.where_compared(argument, relation, self.origin);
                self.proof(&side(Relation::AtLeast), &sides.above, integers)?;
                self.proof(&side(Relation::AtMost), &sides.below, integers)
            }
            (_, Proof::Parts(_)) => beyond("a domain cut into parts"),
            // A statement is true where all clauses of its conjunctive form are.
            (statement, Proof::Clauses(proofs)) => {
                let clauses = clauses(statement).ok_or(Unsupported::Large)?;
                if clauses.len() != proofs.len() {
                    return Err(Wrong::Kind.into());
                }
                for (clause, proof) in clauses.iter().zip(proofs) {
                    self.proof(&stating(claim, clause), proof, integers)?;
                }
                Ok(())
            }
            (_, Proof::Nowhere(_)) => beyond("a domain without points"),
            _ => Err(Wrong::Kind.into()),
        }
    }

    fn assumed(&self, statement: Statement) -> Hypothesis {
        Hypothesis {
            statement,
            source: Source::Assume,
            origin: self.origin.clone(),
        }
    }

    /// Checks that every combination of values of the integers has a proof. Combinations outside of the declared
    /// ranges need none.
    fn instances(
        &self,
        claim: &Claim,
        instances: &[Instance<Polynomial>],
        integers: &Integers,
    ) -> Result<(), CheckError> {
        let names = instances.first().ok_or(Wrong::Instances)?.integers.keys();
        let all = assignments(claim, &names.cloned().collect::<Vec<_>>(), integers)?;
        let given: BTreeSet<&Integers> = instances.iter().map(|one| &one.integers).collect();
        if !all.iter().all(|own| given.contains(own)) {
            return Err(Wrong::Instances.into());
        }
        for instance in instances.iter().filter(|one| all.contains(&one.integers)) {
            let mut chosen = integers.clone();
            chosen.extend(instance.integers.clone());
            match &instance.proof {
                // If a term is undefined everywhere, the statement asserts nothing.
                Proof::Nowhere(Emptiness::Undefined(_)) => {
                    let undefined = Domain::new(claim, (&[], &[]), None, &chosen, self.work);
                    let mut terms = claim.statement.terms().into_iter();
                    let gap = |term| match undefined.entries(term) {
                        Err(Unsupported::Undefined(_)) => Some(()),
                        _ => None,
                    };
                    let beyond = Unsupported::Construct("a statement that says nothing");
                    terms.find_map(gap).ok_or(beyond)?;
                }
                proof => self.proof(claim, proof, &chosen)?,
            }
        }
        Ok(())
    }

    fn refutation(
        &self,
        claim: &Claim,
        refuted: &Refuted<Polynomial>,
        integers: &Integers,
    ) -> Result<(), CheckError> {
        match refuted {
            Refuted::At(point) => {
                let at = At::new(claim, integers, point, self.work)?;
                at.in_domain()?;
                at.refutes(point)
            }
            Refuted::Instance {
                integers: chosen,
                refuted,
            } => {
                let mut all_chosen = integers.clone();
                all_chosen.extend(chosen.clone());
                self.refutation(claim, refuted, &all_chosen)
            }
            Refuted::Denied { proof, anywhere } => {
                let Statement::Not(inner) = &claim.statement else {
                    return Err(Unsupported::Construct("a denial inside of a statement").into());
                };
                let denied = stating(claim, inner);
                let check = Check {
                    conditions: &[],
                    ..*self
                };
                check.proof(&denied, proof, integers)?;
                let mut all_chosen = integers.clone();
                let chosen = anywhere.integers().into_iter();
                all_chosen.extend(chosen.map(|(name, value)| (name.to_owned(), value)));
                let at = At::new(&denied, &all_chosen, anywhere.counterexample(), self.work)?;
                at.in_domain()?;
                Ok(at.defined(inner)?)
            }
        }
    }
}

/// Checks polynomials that never vanish by their signs. No elimination is used, because these signs justify
/// eliminations.
fn nonzero(domain: &Domain<'_>, signs: &[Sign<Polynomial>]) -> Result<Vec<Polynomial>, CheckError> {
    if signs.is_empty() {
        return Ok(vec![]);
    }
    let check = Signs::new(domain, &[], 0)?;
    for sign in signs {
        check.check(sign)?;
        if !sign.strict {
            return Err(Wrong::Zero.into());
        }
    }
    Ok(signs.iter().map(|sign| sign.polynomial.clone()).collect())
}

/// The claim with another statement.
fn stating(claim: &Claim, statement: &Statement) -> Claim {
    Claim {
        statement: statement.clone(),
        ..claim.clone()
    }
}

/// The claims about two conjuncts. The terms of a denial do not count for where the other conjunct has a value, nor the other way
/// round.
fn conjuncts(claim: &Claim, a: &Statement, b: &Statement) -> Result<(Claim, Claim), CheckError> {
    let is_denial = |part: &Statement| matches!(part, Statement::Not(_));
    let alone = |part| stating(claim, part).needed_by([part]);
    match (is_denial(a), is_denial(b)) {
        (false, false) if has_denial(a) || has_denial(b) => {
            if claim.implicit().next().is_some() {
                let what = "roots beside a denial and several other statements";
                return Err(Unsupported::Construct(what).into());
            }
            Ok((stating(claim, a), stating(claim, b)))
        }
        (false, false) => Ok((stating(claim, a), stating(claim, b))),
        _ => Ok((alone(a), alone(b))),
    }
}

/// Whether a denial is among the conjuncts of a statement.
fn has_denial(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) => true,
        Statement::Join(Connective::And, a, b) => has_denial(a) || has_denial(b),
        _ => false,
    }
}

/// The parts that `or` joins, from the left.
fn alternatives(statement: &Statement) -> Vec<&Statement> {
    match statement {
        Statement::Join(Connective::Or, a, b) => [alternatives(a), alternatives(b)].concat(),
        other => vec![other],
    }
}

/// A statement of `and` and `or` as clauses that are all true, each one part or several that `or` joins; `None` if there are too many.
fn clauses(statement: &Statement) -> Option<Vec<Statement>> {
    let Statement::Join(connective, a, b) = statement else {
        return Some(vec![statement.clone()]);
    };
    match connective {
        Connective::And => Some([clauses(a)?, clauses(b)?].concat()),
        Connective::Or => {
            let (first, second) = (clauses(a)?, clauses(b)?);
            if first.len() * second.len() > MAX_CLAUSES {
                return None;
            }
            let join = |x: &Statement, y: &Statement| {
                Statement::Join(Connective::Or, Box::new(x.clone()), Box::new(y.clone()))
            };
            let pairs = first
                .iter()
                .flat_map(|x| second.iter().map(move |y| join(x, y)));
            Some(pairs.collect())
        }
        Connective::Implies => Some(vec![statement.clone()]),
    }
}

/// All values of these integers in their ranges, which may name one another.
fn assignments(
    claim: &Claim,
    names: &[String],
    integers: &Integers,
) -> Result<Vec<Integers>, CheckError> {
    let mut all = vec![Integers::new()];
    let mut left: Vec<&String> = names.iter().collect();
    while !left.is_empty() {
        // Find an integer whose range refers to none of the remaining ones.
        let ready = left.iter().position(|name| {
            bounds(claim, name).is_some_and(|forms| {
                let mut named = forms.iter().flat_map(|form| form.multiples());
                named.all(|(other, _)| {
                    integers.contains_key(other)
                        || (names.iter().any(|n| n == other) && !left.iter().any(|n| *n == other))
                })
            })
        });
        let Some(name) = ready.map(|place| left.remove(place)) else {
            return Err(Unsupported::Construct("integers without end").into());
        };
        let Some([least, most]) = bounds(claim, name) else {
            return Err(Unsupported::Construct("integers without end").into());
        };
        let mut next = vec![];
        for known in &all {
            let value = |form: &torse_numbers::Affine| {
                let term = |(name, n): (&str, i64)| {
                    let own = known.get(name).or_else(|| integers.get(name));
                    own.and_then(|value| value.checked_mul(n))
                };
                let mut terms = form.multiples();
                terms.try_fold(form.constant(), |sum, part| sum.checked_add(term(part)?))
            };
            let (Some(low), Some(high)) = (value(least), value(most)) else {
                return Err(Unsupported::Large.into());
            };
            for n in low..=high {
                let mut more = known.clone();
                more.insert(name.clone(), n);
                next.push(more);
                if next.len() > MAX_INSTANCES {
                    return Err(Unsupported::Large.into());
                }
            }
        }
        all = next;
    }
    Ok(all)
}

/// The two bounds of an integer, if it has both.
fn bounds<'c>(claim: &'c Claim, name: &str) -> Option<[&'c torse_numbers::Affine; 2]> {
    match claim.symbols.get(name)? {
        Set::Integer { least, most } => Some([least.as_ref()?, most.as_ref()?]),
        _ => None,
    }
}
