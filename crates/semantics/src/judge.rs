//! Whether statements are true at a point: their trees, in the first arithmetic that decides them.
//!
//! Falsity is proved: two balls that do not meet hold different numbers. Truth of an order relation is proved likewise, and so
//! is equality of exact numbers. Enclosed numbers are called equal if their difference is enclosed within `2^-128` times the
//! larger of 1 and the sides: for two formulas that are no identity an agreement that no chance explains, but no proof.

use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::{Unknown, Work};
use crate::real::{Real, Reals};
use crate::residue::{Residue, Residues};
use crate::tree::{At, Given, Reading, Values, joined};
use torse_syntax::formula::{Expr, Node};

/// The precisions that are tried, in bits.
const PRECISIONS: [usize; 2] = [320, 1280];

/// A point at which statements of a claim are judged.
pub(crate) struct Judge<'j, 'a> {
    pub reading: &'a Reading<'a>,
    /// The numbers of the point.
    pub values: &'j dyn Fn(&Name) -> Option<Real>,
    /// Whether the numbers satisfy the equations of the domain only nearly.
    pub near: bool,
    /// The statements that are known to fail somewhere on the domain.
    pub fails: &'j dyn Fn(&Expr) -> bool,
    pub work: &'j Work,
}

/// The arithmetics in which a judge evaluates.
pub(crate) struct Grounds<'j>([Reals<'j>; 2]);

/// Residues for the numbers of a point.
type Modulo<'g> = (&'g Residues<'g>, &'g dyn Fn(&Name) -> Option<Residue>);

/// The evaluators of a judge, coarse ones first.
pub(crate) struct Ladder<'g, 'a> {
    reading: &'a Reading<'a>,
    residues: Option<At<'a, 'g, Residues<'g>>>,
    reals: [At<'a, 'g, Reals<'g>>; 2],
}

impl<'j, 'a> Judge<'j, 'a> {
    /// The arithmetics of this judge.
    pub fn evaluators(&self) -> Grounds<'j> {
        let work = self.work;
        Grounds(PRECISIONS.map(|bits| Reals { bits, work }))
    }
}

impl<'j> Grounds<'j> {
    /// Evaluators for hypotheses and conditions.
    pub fn each<'g, 'a>(&'g self, judge: &Judge<'g, 'a>) -> Ladder<'g, 'a>
    where
        'j: 'g,
    {
        self.along(judge, None, None)
    }

    /// Evaluators that put the solutions of given equations into coefficients, and begin with residues where there are any.
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
    /// What a statement is; of what is joined each part in the first arithmetic that decides it.
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

    /// What the statement of the claim is; where something is sought with the witnesses in its place. Where it is true, whether
    /// slips in it are seen is noted.
    pub fn statement(&self) -> Judgement {
        let reading = self.reading;
        let judgement = match reading.seeks() {
            true => self.first(|at| reading.judged(at), |at| reading.judged(at)),
            false => self.truth(reading.tree()),
        };
        if judgement == Judgement::True {
            // What has no residue is looked at with the numbers themselves.
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
