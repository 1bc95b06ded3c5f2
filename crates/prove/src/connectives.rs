//! Statements by their structure: conjunctions part by part, denials by one point, alternatives by one of them.

use crate::case_split;
use crate::decide::value::Proof;
use crate::decide::{self, Decision};
use crate::decider::Decider;
use crate::evidence::Witness;
use std::rc::Rc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Polynomial, work};
use torse_certificate::proof::Sides;
use torse_core::{self as core};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::Origin;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Relation};

/// The most absolute values whose signs are told apart.
const MAX_SIZES: usize = 3;
/// The work that one side of one may take.
const SIZE_WORK: u64 = 10_000_000;

/// The domain of a claim, cut into parts without alternatives.
pub(crate) struct DisjunctiveDomain<'a> {
    deciders: Vec<Decider<'a>>,
    elaborator: Rc<Elaborator<'a>>,
    /// Where the statement is written.
    origin: &'a Origin,
}

impl<'a> DisjunctiveDomain<'a> {
    pub fn new(
        claims: Vec<core::Claim>,
        elaborator: &Rc<Elaborator<'a>>,
        origin: &'a Origin,
    ) -> Self {
        let decider = |claim| Decider::new(claim, Rc::clone(elaborator));
        Self {
            deciders: claims.into_iter().map(decider).collect(),
            elaborator: Rc::clone(elaborator),
            origin,
        }
    }

    /// A point of the domain at which the sides of a comparison of the statement have values, if one is found.
    pub fn anywhere(&self, statement: &core::Statement) -> Option<Witness> {
        let mut deciders = self.deciders.iter();
        let point = deciders.find_map(|part| part.anywhere(statement))?;
        Some(
            decide::Refutation {
                refuted: point,
                sides: None,
            }
            .witness(),
        )
    }

    pub fn decide(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        match statement {
            core::Statement::Join(Connective::And, a, b) => {
                let first = self.decide(a)?;
                if first.is_refuted() {
                    return Ok(first);
                }
                Ok(decide::both(first, self.decide(b)?))
            }
            core::Statement::Not(inner) => {
                let decided = self.everywhere_defined(self.decide(inner)?);
                let anywhere = || self.deciders.iter().find_map(|part| part.anywhere(inner));
                Ok(decide::negated(decided, anywhere))
            }
            core::Statement::Join(Connective::Implies, premise, conclusion) => {
                match self.under(&[premise], true, conclusion)? {
                    Some(Decision::Proven(proof)) => {
                        Ok(Decision::Proven(Proof::Conclusion(Box::new(proof))))
                    }
                    Some(decision) => Ok(decision),
                    None => self.everywhere(statement),
                }
            }
            core::Statement::Join(Connective::Or, ..) => match case_split::clauses(statement) {
                Some(clauses) => {
                    let clauses = clauses.iter().map(|clause| self.alternative(clause));
                    conjoined(clauses, Proof::Clauses)
                }
                None => self.everywhere(statement),
            },
            other => self.everywhere(other),
        }
    }

    /// A proof without the conditions that only say where the terms of the statement are defined: those that no eliminated
    /// symbol brought in, neither one of the domain nor one of what the statement assumes itself.
    fn everywhere_defined(&self, decision: Decision) -> Decision {
        let Decision::Proven(proof) = decision else {
            return decision;
        };
        let deciders = self.deciders.iter().map(Decider::undivided_eliminations);
        let most = deciders.collect::<Option<Vec<usize>>>();
        let most = most.and_then(|counts| counts.into_iter().max());
        Decision::Proven(match most {
            Some(most) if !proof.conditions().is_empty() && eliminates_no_more(&proof, most) => {
                Proof::Defined(Box::new(proof))
            }
            _ => proof,
        })
    }

    /// Alternatives, under the conditions that every one of them has a value, whichever is proved: at a point at which one has none
    /// the whole has none.
    fn alternative(&self, literals: &[&core::Statement]) -> Result<Decision, Fault> {
        let proof = match self.one_of(literals)? {
            Decision::Proven(proof) if literals.len() > 1 => proof,
            decision => return Ok(decision),
        };
        let defined = literals.iter().map(|literal| self.definedness(literal));
        Ok(match defined.collect::<Option<Vec<_>>>() {
            Some(conditions) => Decision::Proven(proof.within(conditions.concat())),
            None => Decision::open("it is not known where the alternatives have values", &[]),
        })
    }

    /// What a statement divides by and may vanish, if that is known; a premise is a hypothesis of its conclusion.
    fn definedness(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        match statement {
            core::Statement::Join(Connective::Implies, premise, conclusion) => {
                self.restricted(&[premise], true)?.definedness(conclusion)
            }
            core::Statement::Join(Connective::And | Connective::Or, a, b) => {
                Some([self.definedness(a)?, self.definedness(b)?].concat())
            }
            core::Statement::Not(_) | core::Statement::Family(..) => Some(vec![]),
            core::Statement::Compare { .. } | core::Statement::Agrees { .. } => {
                match self.deciders.as_slice() {
                    [whole] => whole.definedness(statement),
                    _ => self.as_written(statement),
                }
            }
        }
    }

    /// What a statement divides by as it is written, and may vanish on some part of the domain.
    fn as_written(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        let mut written = self.deciders.first()?.written_divisors(statement)?;
        let may_vanish = |p: &Polynomial| self.deciders.iter().any(|part| part.may_vanish(p));
        written.retain(may_vanish);
        Some(written)
    }

    /// Alternatives: proved if one is, or one is where all others fail. A denial among them is true or false of the whole
    /// domain: a false one is no alternative.
    fn one_of(&self, literals: &[&core::Statement]) -> Result<Decision, Fault> {
        let (mut left, mut decisions, mut false_denial) = (vec![], vec![], None);
        for (place, literal) in literals.iter().enumerate() {
            match self.decide(literal)? {
                Decision::Proven(proof) if proof.conditions().is_empty() => {
                    return Ok(Decision::Proven(decide::alternative(place, false, proof)));
                }
                refuted @ Decision::Refuted(_) if denies(literal) => {
                    false_denial = Some(refuted);
                }
                decision => {
                    left.push((place, *literal));
                    decisions.push((place, decision));
                }
            }
        }
        if left.len() <= 1 {
            match (decisions.pop(), false_denial) {
                (Some((place, Decision::Proven(proof))), _) => {
                    return Ok(Decision::Proven(decide::alternative(place, false, proof)));
                }
                (Some((_, decision)), _) | (None, Some(decision)) => return Ok(decision),
                (None, None) => {}
            }
        }
        for (number, (place, conclusion)) in left.iter().enumerate().rev() {
            let others = left
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != number);
            let others: Vec<&core::Statement> = others.map(|(_, (_, literal))| *literal).collect();
            match self.under(&others, false, conclusion)? {
                Some(Decision::Proven(proof)) if proof.conditions().is_empty() => {
                    return Ok(Decision::Proven(decide::alternative(*place, true, proof)));
                }
                Some(refuted @ Decision::Refuted(_)) => return Ok(refuted),
                _ => {}
            }
        }
        Ok(Decision::open(
            "no alternative is proved on the whole domain",
            &["each alternative on its own, and where the others fail"],
        ))
    }

    /// A statement that is decided as it is, on every part.
    fn everywhere(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        let decision = self.on_parts(statement)?;
        let Some(conditions) = decision.conditions().filter(|all| !all.is_empty()) else {
            return Ok(decision);
        };
        // Conditions of parts, of values of integers, and of eliminations may be more than the statement needs to have a value.
        let is_cut = self.deciders.len() > 1
            || self.deciders.iter().any(Decider::divides_by_splits)
            || matches!(&decision, Decision::Proven(Proof::Instances(_)));
        let Some(written) = is_cut.then(|| self.as_written(statement)).flatten() else {
            return Ok(decision);
        };
        if conditions
            .iter()
            .all(|condition| written.contains(condition))
        {
            return Ok(decision);
        }
        let deciders = self.deciders.iter();
        let there = Self {
            deciders: deciders.map(|part| part.where_nonzero(&written)).collect(),
            elaborator: Rc::clone(&self.elaborator),
            origin: self.origin,
        };
        Ok(match there.on_parts(statement) {
            Ok(Decision::Proven(proof)) if proof.conditions().is_empty() => {
                Decision::Proven(proof.within(written))
            }
            _ => decision,
        })
    }

    fn on_parts(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        let parts = self.deciders.iter();
        let parts = parts.map(|part| self.on_sides(part, statement, 0));
        conjoined(parts, Proof::Parts)
    }

    /// Decides a statement on a part; where that is open, on both sides of an absolute value; so many are divided already.
    fn on_sides(
        &self,
        part: &Decider<'a>,
        statement: &core::Statement,
        sides: usize,
    ) -> Result<Decision, Fault> {
        let decision = part.single(statement)?;
        let mut sizes = part.claim.sizes().skip(sides);
        if !matches!(decision, Decision::Open(_)) || sides >= MAX_SIZES {
            return Ok(decision);
        }
        let Some((root, argument)) = sizes.next() else {
            return Ok(decision);
        };
        let side = |relation| {
            let claim = part.claim.where_compared(argument, relation, self.origin);
            let side = Decider::new(claim, Rc::clone(&self.elaborator));
            let side = side.where_nonzero(&part.nonzero);
            let decided = work::within(SIZE_WORK, || self.on_sides(&side, statement, sides + 1));
            match decided {
                Ok(Ok(Decision::Vacuous(why))) => Some(Decision::Proven(Proof::Nowhere(why))),
                Ok(Ok(decision @ (Decision::Proven(_) | Decision::Refuted(_)))) => Some(decision),
                _ => None,
            }
        };
        let is_nowhere = |proof: &Proof| matches!(proof, Proof::Nowhere(_));
        Ok(match (side(Relation::AtLeast), side(Relation::AtMost)) {
            (Some(refuted @ Decision::Refuted(_)), _)
            | (_, Some(refuted @ Decision::Refuted(_))) => refuted,
            (Some(Decision::Proven(above)), _) if injected(InjectedFault::OtherSideForgotten) => {
                Decision::Proven(above)
            }
            (Some(Decision::Proven(above)), Some(Decision::Proven(below)))
                if !is_nowhere(&above) || !is_nowhere(&below) =>
            {
                let root = root.to_string();
                let divided = Sides { root, above, below };
                Decision::Proven(Proof::Sides(Box::new(divided)))
            }
            _ => decision,
        })
    }

    /// The domain where all premises are true, or all are false; `None` if one cannot be assumed.
    fn restricted(&self, premises: &[&core::Statement], truth: bool) -> Option<Self> {
        let mut there = vec![];
        for part in &self.deciders {
            there.extend(case_split::under(
                &part.claim,
                premises,
                truth,
                self.origin,
            )?);
        }
        Some(Self::new(there, &self.elaborator, self.origin))
    }

    /// The conclusion where all premises are true, or all are false: at every other point the statement is true. `None` if
    /// a premise cannot be assumed, or one of them denies something of the whole domain.
    fn under(
        &self,
        premises: &[&core::Statement],
        truth: bool,
        conclusion: &core::Statement,
    ) -> Result<Option<Decision>, Fault> {
        if premises.iter().any(|p| denies(p)) || denies(conclusion) {
            return Ok(None);
        }
        let Some(there) = self.restricted(premises, truth) else {
            return Ok(None);
        };
        Ok(Some(match there.decide(conclusion) {
            // No point, or none at which the premises are so: the second is a proof.
            Ok(Decision::Vacuous(emptiness)) => match self.everywhere(conclusion)? {
                vacuous @ Decision::Vacuous(_) => vacuous,
                _ => Decision::Proven(Proof::Nowhere(emptiness)),
            },
            Ok(decision) => decision,
            Err(fault) if fault.is_limit() => Decision::open(fault.problem.to_string(), &[]),
            Err(fault) => return Err(fault),
        }))
    }
}

/// Whether no part of a proof eliminates more than this many times, and none tells the points apart at which a divisor vanishes.
fn eliminates_no_more(proof: &Proof, most: usize) -> bool {
    let own = match proof {
        Proof::Split(_) => false,
        Proof::On(ground) => ground.eliminated.len() <= most,
        _ => true,
    };
    let parts = proof.parts();
    own && parts.into_iter().all(|part| eliminates_no_more(part, most))
}

/// Whether something is denied of the whole domain.
fn denies(statement: &core::Statement) -> bool {
    match statement {
        core::Statement::Not(_) => true,
        core::Statement::Join(_, a, b) => denies(a) || denies(b),
        _ => false,
    }
}

/// The decision from those on all parts of a domain, or of all parts of a statement. A part without points says nothing.
fn conjoined(
    parts: impl Iterator<Item = Result<Decision, Fault>>,
    joined: impl FnOnce(Vec<Proof>) -> Proof,
) -> Result<Decision, Fault> {
    let (mut proofs, mut open, mut empty) = (vec![], None, None);
    let mut proven = false;
    for part in parts {
        match part? {
            refuted @ Decision::Refuted(_) => return Ok(refuted),
            Decision::Proven(proof) => {
                proven = true;
                proofs.push(proof);
            }
            Decision::Vacuous(emptiness) => {
                proofs.push(Proof::Nowhere(emptiness.clone()));
                empty = Some(emptiness);
            }
            undecided @ Decision::Open(_) => {
                open.get_or_insert(undecided);
            }
        }
    }
    Ok(match (open, proven, empty) {
        (Some(open), _, _) => open,
        (None, true, _) => Decision::Proven(match proofs.pop() {
            Some(only) if proofs.is_empty() => only,
            last => {
                proofs.extend(last);
                joined(proofs)
            }
        }),
        (None, false, Some(emptiness)) => Decision::Vacuous(emptiness),
        (None, false, None) => Decision::open("no part of the domain", &[]),
    })
}
