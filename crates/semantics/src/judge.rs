//! Judges the truth of statements at a point: evaluates their trees in the first arithmetic that decides them.
//!
//! Falsity is proved: disjoint balls contain different numbers. Truth of an order relation is proved in the same way,
//! and so is equality of exact numbers. Enclosed numbers are called equal if their difference is enclosed within
//! `2^-128` times the maximum of 1 and the sides. For two formulas that are not identical, chance does not explain
//! such an agreement; but it is not a proof.

use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::{Unknown, Work};
use crate::real::{Real, Reals};
use crate::residue::{Residue, Residues};
use crate::tree::{At, Given, Reading, Values, joined};
use torse_syntax::formula::{Expr, Node};

/// The precisions that are tried one after the other, in bits.
const PRECISIONS: [usize; 2] = [320, 1280];

/// A point at which statements of a claim are judged.
pub(crate) struct Judge<'j, 'a> {
    pub reading: &'a Reading<'a>,
    /// The numbers of the point.
    pub values: &'j dyn Fn(&Name) -> Option<Real>,
    /// Whether the numbers satisfy the equations of the domain only approximately.
    pub near: bool,
    /// The statements that are known to fail somewhere in the domain.
    pub fails: &'j dyn Fn(&Expr) -> bool,
    pub work: &'j Work,
}

/// The arithmetics in which a judge evaluates.
pub(crate) struct Evaluators<'j>([Reals<'j>; 2]);

/// Residues modulo the prime of the numbers of a point.
type Modulo<'g> = (&'g Residues<'g>, &'g dyn Fn(&Name) -> Option<Residue>);

/// The evaluators of a judge, cheapest first.
pub(crate) struct Ladder<'g, 'a> {
    reading: &'a Reading<'a>,
    residues: Option<At<'a, 'g, Residues<'g>>>,
    reals: [At<'a, 'g, Reals<'g>>; 2],
}

impl<'j, 'a> Judge<'j, 'a> {
    /// The arithmetics that this judge uses.
    pub fn evaluators(&self) -> Evaluators<'j> {
        let (work, near) = (self.work, self.near);
        Evaluators(PRECISIONS.map(|bits| Reals { bits, work, near }))
    }
}

impl<'j> Evaluators<'j> {
    /// Evaluators for hypotheses and conditions.
    pub fn each<'g, 'a>(&'g self, judge: &Judge<'g, 'a>) -> Ladder<'g, 'a>
    where
        'j: 'g,
    {
        self.along(judge, None, None)
    }

    /// Evaluators that differentiate `coefficients` along the solutions of given equations, and that begin with
    /// residues if there are any.
    pub fn along<'g, 'a>(
        &'g self,
        judge: &Judge<'g, 'a>,
        given: Option<Given<'a>>,
        residues: Option<Modulo<'g>>,
    ) -> Ladder<'g, 'a>
    where
        'j: 'g,
    {
        let values = Values {
            number: judge.values,
            near: judge.near,
            fails: judge.fails,
        };
        let reading = judge.reading;
        let [low, high] = &self.0;
        let modulo = |(arithmetic, number): Modulo<'g>| {
            let values = Values {
                number,
                near: false,
                fails: judge.fails,
            };
            reading.at(arithmetic, values).along(given.clone())
        };
        Ladder {
            reading,
            residues: residues.map(modulo),
            reals: [low, high].map(|reals| reading.at(reals, values).along(given.clone())),
        }
    }
}

impl<'a> Ladder<'_, 'a> {
    /// Judges a statement; each part of a compound is judged in the first arithmetic that decides it.
    pub fn truth(&self, tree: &'a Expr) -> Judgement {
        let mut rights = vec![];
        let mut left = tree;
        while let Node::Join(connective, a, b) = &left.node {
            rights.push((*connective, b));
            left = a;
        }
        let mut all = match &left.node {
            Node::Not(inner) if matches!(inner.node, Node::Join(..)) => {
                let inner = self.truth(inner);
                inner.joined(Judgement::True, |truth, _| truth.map(|t| !t))
            }
            _ => self.first(|at| at.truth_of(left), |at| at.truth_of(left)),
        };
        while let Some((connective, right)) = rights.pop() {
            all = joined(connective, all, self.truth(right));
        }
        all
    }

    /// Judges the statement of the claim, with witnesses in the place of existential symbols. If it is true, records
    /// whether slips in it would be noticed.
    pub fn statement(&self) -> Judgement {
        let reading = self.reading;
        let judgement = if reading.seeks() {
            self.first(|at| reading.judged(at), |at| reading.judged(at))
        } else {
            self.truth(reading.tree())
        };
        if judgement == Judgement::True {
            // If there are no residues, slips are tried with the numbers themselves.
            if let Some(at) = &self.residues {
                reading.look(at);
            }
            let [low, _] = &self.reals;
            reading.look(low);
        }
        judgement
    }

    fn first(
        &self,
        modulo: impl Fn(&At<'a, '_, Residues<'_>>) -> Judgement,
        real: impl Fn(&At<'a, '_, Reals<'_>>) -> Judgement,
    ) -> Judgement {
        if let Some(at) = &self.residues {
            let found = modulo(at);
            if !matches!(found, Judgement::Undecided | Judgement::Unknown(_)) {
                return found;
            }
        }
        let [low, high] = &self.reals;
        match real(low) {
            Judgement::Undecided | Judgement::Unknown(Unknown::Precision) => real(high),
            found => found,
        }
    }
}
