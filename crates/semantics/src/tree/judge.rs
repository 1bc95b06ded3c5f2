//! A claim of a derivation file at a point: SEMANTICS.md, "The sentence" and "What there is".

use super::environment::{Environment, Part};
use super::evaluate::{Evaluator, Given, Point};
use super::jets::Jets;
use super::slips::leaves;
use super::statement::joined;
use crate::arithmetic::Arithmetic;
use crate::domain::set;
use crate::domain::stream::Stream;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::real::Real;
use crate::series::Series;
use crate::value::Value;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::declarations::{Bound, Declarations, Interval, SymbolKind};
use torse_syntax::derivation::{Claim, Existential, Written};
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// A claim with a statement, prepared to be judged at points from their trees alone.
#[derive(Debug)]
pub struct Reading<'a> {
    claim: &'a Claim,
    statement: &'a Expr,
    jets: Jets,
    /// The names of the numbers that a point specifies. Other numbers may have any values of their sets.
    names: BTreeSet<String>,
    /// For each existential symbol, the bounds of its set that are formulas, as relations.
    existentials: Vec<Vec<Written>>,
    /// The leaves at which slips are tried.
    leaves: Vec<&'a Expr>,
    /// Whether a slip was noticed at some point.
    seen: Cell<bool>,
    /// Whether the statement was true at some point.
    held: Cell<bool>,
    /// The bounds of declared sets that are formulas, as relations.
    ends: Vec<Written>,
}

/// The numbers of a point.
pub struct Values<'e, N> {
    /// The number of each symbol, coordinate and member.
    pub number: &'e dyn Fn(&Name) -> Option<N>,
    /// Whether they satisfy the equations of the domain only approximately.
    pub near: bool,
    /// Whether a statement is known to be false somewhere in the domain.
    pub fails: &'e dyn Fn(&Expr) -> bool,
}

impl<N> Clone for Values<'_, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<N> Copy for Values<'_, N> {}

/// An evaluator at a point.
pub(crate) type At<'a, 'e, A> = Evaluator<'a, 'e, A>;
type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

impl<'a> Reading<'a> {
    /// A statement about the domain of a claim. `names` are the names of the numbers that points specify, including
    /// derivatives of smooth functions such as `f'(u)`.
    pub fn new<'n>(
        claim: &'a Claim,
        statement: &'a Expr,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Self {
        let names: BTreeSet<String> = names.into_iter().map(str::to_owned).collect();
        let ends = |name: &str| match claim.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => interval.relations(name),
            _ => vec![],
        };
        Self {
            claim,
            statement,
            jets: Jets::new(&claim.declarations, names.iter().map(String::as_str)),
            existentials: claim.existentials.iter().map(|s| ends(&s.name)).collect(),
            leaves: leaves(statement),
            seen: Cell::new(false),
            held: Cell::new(false),
            ends: names.iter().flat_map(|name| ends(name)).collect(),
            names,
        }
    }

    pub(crate) fn at<'s, 'e, A: Arithmetic>(
        &'s self,
        arithmetic: &'e A,
        values: Values<'e, A::Number>,
    ) -> At<'s, 'e, A> {
        let point = Point {
            values: values.number,
            near: values.near,
            failing: values.fails,
        };
        Evaluator::new(&self.claim.declarations, &self.jets, arithmetic, point).remembering()
    }

    /// A value for a declared symbol that the point does not specify, although the place of a function is a formula
    /// in it: any number of its set.
    pub(crate) fn free(&self, name: &Name) -> Option<Real> {
        let symbol = &**name.declared();
        if self.names.contains(symbol) || !self.jets.are_at(symbol) {
            return None;
        }
        match self.claim.declarations.symbol(symbol)? {
            SymbolKind::Real(interval) if interval.formulas().next().is_none() => {
                let stream = Stream::new(symbol, 0);
                Some(set::in_interval(interval, &stream, symbol))
            }
            _ => None,
        }
    }

    /// The statement.
    pub(crate) const fn tree(&self) -> &'a Expr {
        self.statement
    }

    pub(crate) fn declarations(&self) -> &'a Declarations {
        &self.claim.declarations
    }

    /// The unknowns of the given equations.
    pub(crate) fn unknowns(&self) -> impl Iterator<Item = &'a Expr> {
        self.claim.unknowns.iter().map(|unknown| &unknown.expr)
    }

    /// The existential symbols, with the bounds of their sets that are formulas.
    pub(super) fn existentials(&self) -> impl Iterator<Item = (&'a Existential, &[Written])> {
        let ends = self.existentials.iter().map(Vec::as_slice);
        self.claim.existentials.iter().zip(ends)
    }

    /// The existential symbols that have witnesses, with these.
    pub(crate) fn witnesses(&self) -> impl Iterator<Item = (&'a str, &'a Expr)> {
        let own = self.claim.existentials.iter();
        own.filter_map(|own| Some((own.name.as_str(), &own.witness.as_ref()?.expr)))
    }

    pub(crate) fn seeks(&self) -> bool {
        !self.claim.existentials.is_empty()
    }

    /// The hypotheses as written: `assume`, then `given`.
    pub(super) fn assumptions(&self) -> impl Iterator<Item = &'a Expr> {
        let all = self.claim.assumptions.iter().chain(&self.claim.given);
        all.map(|hypothesis| &hypothesis.formula.expr)
    }

    /// All hypotheses: those that are written, and the bounds of declared sets that are formulas.
    pub(crate) fn hypotheses(&self) -> impl Iterator<Item = &Expr> {
        self.assumptions()
            .chain(self.ends.iter().map(|end| &end.expr))
    }

    /// The names of the numbers that points specify.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// The value of a formula outside of all binders.
    pub(crate) fn value_of<A: Arithmetic>(
        &self,
        tree: &Expr,
        arithmetic: &A,
        values: Values<'_, A::Number>,
    ) -> Result<Value<A::Number>, NoValue> {
        self.at(arithmetic, values)
            .value(tree, &Environment::outermost())
    }

    /// The differences of the sides of equations, entry by entry.
    pub(crate) fn differences<A: Arithmetic>(
        &self,
        equations: &[(&Expr, &Expr)],
        a: &A,
        values: Values<'_, A::Number>,
    ) -> Result<Vec<A::Number>, NoValue> {
        let (at, outermost) = (self.at(a, values), Environment::outermost());
        let mut gaps = vec![];
        for (left, right) in equations {
            let (left, right) = (at.value(left, &outermost)?, at.value(right, &outermost)?);
            for (x, y) in left.pairs(&right, a)? {
                gaps.extend(x.minus(&y, a)?.as_number().cloned());
            }
        }
        Ok(gaps)
    }

    /// The numbers that a list of symbols, coordinates and members denotes.
    pub(crate) fn names_in<A: Arithmetic>(
        &self,
        tree: &Expr,
        arithmetic: &A,
        number: &dyn Fn(&Name) -> Option<A::Number>,
    ) -> Result<Vec<Name>, NoValue> {
        let values = Values {
            number,
            near: false,
            fails: &|_| false,
        };
        let at = self.at(arithmetic, values);
        let parts = at.moving_parts(tree, &Environment::outermost())?;
        let name = |(symbol, part): (&str, Part)| {
            let symbol = Arc::from(symbol);
            match part {
                Part::Whole => Name::Symbol(symbol),
                Part::Coordinate(c) => Name::Coordinate(symbol, c),
                Part::Member(indices, c) => Name::Member(symbol, indices, c),
            }
        };
        Ok(parts.into_iter().map(name).collect())
    }

    /// Judges the statement at a point.
    #[must_use]
    pub fn statement<A: Arithmetic>(
        &self,
        arithmetic: &A,
        values: Values<'_, A::Number>,
    ) -> Judgement {
        self.judged(&self.at(arithmetic, values).along(self.given()))
    }

    /// Judges the statement without a cache: slow and simple, for tests.
    #[must_use]
    pub fn statement_plainly<A: Arithmetic>(
        &self,
        arithmetic: &A,
        values: Values<'_, A::Number>,
    ) -> Judgement {
        let point = Point {
            values: values.number,
            near: values.near,
            failing: values.fails,
        };
        let declarations = &self.claim.declarations;
        let at = Evaluator::new(declarations, &self.jets, arithmetic, point);
        self.judged(&at.along(self.given()))
    }

    /// Judges the statement with an evaluator that knows the given equations.
    pub(crate) fn judged<'s, A: Arithmetic>(&'s self, at: &At<'s, '_, A>) -> Judgement {
        let outermost = Environment::outermost();
        if self.claim.existentials.is_empty() {
            return at.truth(self.statement, &outermost);
        }
        self.existential(at)
    }

    /// Whether slips were tried in the statement, and none was noticed at any point.
    #[must_use]
    pub fn is_blind(&self) -> bool {
        let looked = !self.leaves.is_empty() && self.claim.existentials.is_empty();
        looked && self.held.get() && !self.seen.get()
    }

    /// Records a point at which the statement is true, and tries whether a slip in it changes a value there.
    pub(crate) fn look<'s, A: Arithmetic>(&'s self, at: &At<'s, '_, A>) {
        self.held.set(true);
        if !self.seen.get() && self.claim.existentials.is_empty() {
            let seen = at.sees_a_slip(self.statement, &self.leaves);
            self.seen.set(seen);
        }
    }

    /// The given equations and their unknowns, if there are any.
    pub(crate) fn given(&self) -> Option<Given<'_>> {
        if self.claim.unknowns.is_empty() {
            return None;
        }
        Some(Given {
            equations: self.claim.given.iter().map(|h| &h.formula.expr).collect(),
            unknowns: self.claim.unknowns.iter().map(|w| &w.expr).collect(),
        })
    }

    /// Judges an existential statement with the witnesses put in: they must be in their sets, and the statement must
    /// be true. In `p implies q` where p contains no existential symbol, only the conclusion is instantiated.
    fn existential<'s, A: Arithmetic>(&'s self, at: &At<'s, '_, A>) -> Judgement {
        let outermost = Environment::outermost();
        let mut inside = outermost.clone();
        for existentials in &self.claim.existentials {
            let Some(witness) = &existentials.witness else {
                let what = "what there is without a witness";
                return Judgement::Unknown(Unknown::NotCovered { what });
            };
            match at.number(&witness.expr, &outermost) {
                Ok(value) => inside = at.moving(&existentials.name, Part::Whole, value, &inside),
                Err(gap) => return self.without_value(gap, at),
            }
        }
        let mut members = Judgement::True;
        for (existentials, ends) in self.claim.existentials.iter().zip(&self.existentials) {
            let inside_set = match self.claim.declarations.symbol(&existentials.name) {
                Some(SymbolKind::Real(interval)) => {
                    is_member(at, &existentials.name, interval, &inside)
                }
                _ => Ok(Judgement::True),
            };
            let inside_set = inside_set.unwrap_or_else(Judgement::from);
            members = joined(Connective::And, members, inside_set);
            for end in ends {
                let end = at.truth(&end.expr, &inside);
                members = joined(Connective::And, members, end);
            }
        }
        let stated = if let Some((premise, conclusion)) = self.with_free_premise() {
            let premise = at.truth(premise, &inside);
            let conclusion = at.truth(conclusion, &inside);
            let conclusion = joined(Connective::And, members, conclusion);
            joined(Connective::Implies, premise, conclusion)
        } else {
            joined(Connective::And, members, at.truth(self.statement, &inside))
        };
        match stated {
            // The number makes the statement defined and true, or it is none of those that the claim says to exist.
            Judgement::Undefined(
                Undefined::NegativeRoot | Undefined::NoLogarithm | Undefined::NoArc,
            ) if self.is_defined_but_for_witnesses(at, self.statement) => Judgement::False,
            stated => stated,
        }
    }

    /// The premise and the conclusion of an implication of which only the conclusion is about the existential numbers.
    fn with_free_premise(&self) -> Option<(&'a Expr, &'a Expr)> {
        let Node::Join(Connective::Implies, premise, conclusion) = &self.statement.node else {
            return None;
        };
        let is_about_conclusion =
            self.is_free(premise) && self.existentials.iter().all(Vec::is_empty);
        is_about_conclusion.then_some((premise, conclusion))
    }

    /// The judgement where a witness has no value: where the premise is false any number will do.
    fn without_value<'s, A: Arithmetic>(&'s self, gap: NoValue, at: &At<'s, '_, A>) -> Judgement {
        let premise = self.with_free_premise().map(|(premise, _)| premise);
        match premise.map(|premise| at.truth(premise, &Environment::outermost())) {
            Some(Judgement::False) => Judgement::Undefined(Undefined::Unasserted),
            _ => gap.into(),
        }
    }

    /// Whether all parts of a statement without an existential number have values; `false` if that is not known.
    fn is_defined_but_for_witnesses<'s, A: Arithmetic>(
        &'s self,
        at: &At<'s, '_, A>,
        tree: &'s Expr,
    ) -> bool {
        let outermost = Environment::outermost();
        let is_defined = |tree: &'s Expr| self.is_defined_but_for_witnesses(at, tree);
        match &tree.node {
            Node::Compare(first, rest) => {
                is_defined(first) && rest.iter().all(|(_, side)| is_defined(side))
            }
            Node::Join(_, a, b) => is_defined(a) && is_defined(b),
            Node::Not(inner) => is_defined(inner),
            _ if self.is_free(tree) => at.value(tree, &outermost).is_ok(),
            Node::Negative(inner) => is_defined(inner),
            Node::Binary(_, a, b) => is_defined(a) && is_defined(b),
            Node::List(items) => items.iter().all(is_defined),
            Node::Name(name) => match at.declarations.definition(name) {
                Some(definition) => is_defined(&definition.body.expr),
                None => true,
            },
            // A formula in which a name is bound may have parts whose values no point has.
            Node::Call(head, arguments) => match &head.node {
                Node::Name(name) => match at.built_in(name, &outermost) {
                    // A derivative is taken where the point is.
                    Some("D") => arguments.first().is_some_and(is_defined),
                    None | Some("sum" | "product" | "integral" | "at" | "coefficients") => false,
                    Some(_) => arguments.iter().all(is_defined),
                },
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether a tree contains no existential symbol, directly or through definitions.
    pub(super) fn is_free(&self, tree: &Expr) -> bool {
        let names = super::memory::reached(&self.claim.declarations, [tree]);
        let mut existentials = self.claim.existentials.iter();
        !existentials.any(|existentials| names.contains(existentials.name.as_str()))
    }
}

/// Whether the moved value of a symbol is in its set, as far as the bounds are numbers.
fn is_member<'a, A: Arithmetic>(
    at: &At<'a, '_, A>,
    name: &'a str,
    interval: &Interval,
    place: &Place<'a, A>,
) -> Result<Judgement, NoValue> {
    let a = at.arithmetic;
    let value = Value::Number(at.symbol(name, &Part::Whole, place)?);
    let mut all = Judgement::True;
    let ends: [(&Option<Bound>, [Relation; 2]); 2] = [
        (&interval.lower, [Relation::AtLeast, Relation::Greater]),
        (&interval.upper, [Relation::AtMost, Relation::Less]),
    ];
    for (end, [closed, open]) in ends {
        let Some(end) = end else {
            continue;
        };
        let turns = Series::rational(&end.value.turns, a);
        let turns = Series::Number(a.pi()).times(&turns, a)?;
        let number = Series::rational(&end.value.rational, a).plus(&turns, a)?;
        let relation = if end.closed { closed } else { open };
        let inside = at.related(relation, &value, &Value::Number(number))?;
        all = joined(Connective::And, all, Judgement::from_truth(inside));
    }
    Ok(all)
}
