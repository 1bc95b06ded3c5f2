//! Statements by their structure: conjunctions part by part, denials by one point, alternatives by one of them.

use crate::case_split;
use crate::decide::value::Proof;
use crate::decide::{self, Decision};
use crate::decider::Decider;
use crate::evidence::Witness;
use std::rc::Rc;
use torse_core::{self as core};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::Origin;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Connective;

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
        let mut conditions = vec![];
        for literal in literals {
            let mut parts = self.deciders.iter().map(|part| part.definedness(literal));
            if !is_implication(literal)
                && let Some(all) = parts.by_ref().collect::<Option<Vec<_>>>()
            {
                conditions.extend(all.concat());
                continue;
            }
            let Some(values) = literal.has_values() else {
                continue;
            };
            match self.decide(&values)? {
                Decision::Proven(defined) => {
                    conditions.extend(defined.conditions().into_iter().cloned());
                }
                vacuous @ Decision::Vacuous(_) => return Ok(vacuous),
                Decision::Refuted(_) | Decision::Open { .. } => {
                    return Ok(Decision::Open {
                        reason: "it is not known where the alternatives have values".to_owned(),
                        tried: vec![],
                    });
                }
            }
        }
        Ok(Decision::Proven(proof.within(conditions)))
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
        Ok(Decision::Open {
            reason: "no alternative is proved on the whole domain".to_owned(),
            tried: vec!["each alternative on its own, and where the others fail".to_owned()],
        })
    }

    /// A statement that is decided as it is, on every part.
    fn everywhere(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        conjoined(
            self.deciders.iter().map(|part| part.single(statement)),
            Proof::Parts,
        )
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
        let mut there = vec![];
        for part in &self.deciders {
            let Some(claims) = case_split::under(&part.claim, premises, truth, self.origin) else {
                return Ok(None);
            };
            there.extend(claims);
        }
        let there = DisjunctiveDomain::new(there, &self.elaborator, self.origin);
        Ok(Some(match there.decide(conclusion) {
            // No point, or none at which the premises are so: the second is a proof.
            Ok(Decision::Vacuous(emptiness)) => match self.everywhere(conclusion)? {
                vacuous @ Decision::Vacuous(_) => vacuous,
                _ => Decision::Proven(Proof::Nowhere(emptiness)),
            },
            Ok(decision) => decision,
            Err(fault) if fault.is_limit() => Decision::Open {
                reason: fault.problem.to_string(),
                tried: vec![],
            },
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

/// Whether a statement is an implication, whose terms need values where its premise is true alone.
fn is_implication(statement: &core::Statement) -> bool {
    matches!(statement, core::Statement::Join(Connective::Implies, ..))
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
            undecided @ Decision::Open { .. } => {
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
        (None, false, None) => Decision::Open {
            reason: "no part of the domain".to_owned(),
            tried: vec![],
        },
    })
}
