//! Evaluates the trees of a claim at random residues, for comparison with what an elaborator made of it.
//!
//! Hypotheses and sets do not matter, because two readings of a text agree at all numbers. Integers are drawn from
//! their declared ranges, since sums and indices have no values elsewhere. All other numbers are arbitrary residues,
//! and a smooth function is a polynomial with arbitrary coefficients.

use super::environment::{Environment, Part};
use super::evaluate::{Evaluator, Point};
use super::jets::Jets;
use super::judge::Reading;
use super::outline::{Outline, Piece, word};
use crate::domain::set;
use crate::domain::stream::Stream;
use crate::name::Name;
use crate::no_value::NoValue;
use crate::scrambled::{Class, Scrambled};
use crate::value::Value;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_numbers::Affine;
use torse_syntax::derivation::declarations::{Bound, Declarations, Interval, SymbolKind};
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// The largest depth to which bounds of integers refer to other integers.
const MAX_DEPTH: usize = 16;
/// No derivatives of smooth functions are given here.
static NO_JETS: Jets = Jets::none();

/// Residues for the numbers of a claim; they depend on the attempt and on the names.
#[derive(Debug)]
pub struct Assignment<'a> {
    declarations: &'a Declarations,
    stream: Stream,
    integers: RefCell<BTreeMap<String, Option<i64>>>,
    /// The declared names that were evaluated.
    asked: RefCell<BTreeSet<Arc<str>>>,
}

impl<'a> Assignment<'a> {
    /// The residues of this attempt; integers grow with the number of the attempt.
    #[must_use]
    pub fn new(declarations: &'a Declarations, attempt: u64) -> Self {
        Self {
            declarations,
            stream: Stream::new("residues", attempt),
            integers: RefCell::default(),
            asked: RefCell::default(),
        }
    }

    /// The residue of a declared number; `None` for names of other kinds, and for ranges without an integer.
    pub fn number(&self, name: &Name) -> Option<Class> {
        let declared = name.declared();
        // The derivative of a smooth function at a place is evaluated from its text.
        if declared.contains('(') {
            return None;
        }
        self.asked.borrow_mut().insert(Arc::clone(declared));
        match (self.declarations.symbol(declared)?, name) {
            (SymbolKind::Integer { .. }, Name::Symbol(name)) => {
                let class = self.integer(name, MAX_DEPTH)?;
                Some(Class::integer(class))
            }
            _ => Some(Class::drawn(&name.to_string(), self.stream.attempt)),
        }
    }

    fn integer(&self, name: &str, depth: usize) -> Option<i64> {
        if let Some(known) = self.integers.borrow().get(name) {
            return *known;
        }
        let SymbolKind::Integer { least, most } = self.declarations.symbol(name)? else {
            return None;
        };
        let bound = |form: &Option<Affine>| match form {
            None => Some(None),
            Some(form) => self.form(form, depth).map(Some),
        };
        let (least, most) = (bound(least)?, bound(most)?);
        let drawn = set::integer_between(least, most, &self.stream, name);
        self.integers.borrow_mut().insert(name.to_owned(), drawn);
        drawn
    }

    fn form(&self, form: &Affine, depth: usize) -> Option<i64> {
        let depth = depth.checked_sub(1)?;
        let mut multiples = form.multiples();
        multiples.try_fold(form.constant(), |sum, (name, multiple)| {
            let value = self.integer(name, depth)?;
            sum.checked_add(multiple.checked_mul(value)?)
        })
    }

    /// The declared names that were evaluated since the last call.
    pub fn take_asked(&self) -> BTreeSet<Arc<str>> {
        self.asked.take()
    }
}

/// A claim at an assignment.
pub struct Compared<'s, 'e> {
    reading: &'s Reading<'s>,
    hypotheses: Evaluator<'s, 'e, Scrambled<'e>>,
    statement: Evaluator<'s, 'e, Scrambled<'e>>,
}

/// Words of a tree, and values of its formulas at residues.
pub type TreeOutline<'s> = Outline<&'s Expr, Class>;

impl<'s, 'e> Compared<'s, 'e> {
    /// Prepares the evaluation of the trees of a claim at these numbers.
    pub fn new(
        reading: &'s Reading<'s>,
        arithmetic: &'e Scrambled<'e>,
        values: &'e dyn Fn(&Name) -> Option<Class>,
    ) -> Self {
        let evaluator = || {
            let point = Point {
                values,
                near: false,
                failing: &|_| false,
            };
            Evaluator::new(reading.declarations(), &NO_JETS, arithmetic, point).remembering()
        };
        Self {
            reading,
            hypotheses: evaluator(),
            statement: evaluator().along(reading.given()),
        }
    }

    /// The value of a formula outside of all binders, as in the statement.
    ///
    /// # Errors
    /// [`NoValue`] if it is undefined or its value is unknown.
    pub fn value(&self, tree: &'s Expr) -> Result<Value<Class>, NoValue> {
        self.statement.value(tree, &Environment::outermost())
    }

    /// The hypotheses, `assume` and `given`, in this order.
    pub fn hypotheses(&self) -> Vec<TreeOutline<'s>> {
        let all = self.reading.assumptions();
        all.map(|tree| self.hypothesis(tree)).collect()
    }

    /// Any statement, read as a hypothesis.
    pub fn hypothesis(&self, tree: &'s Expr) -> TreeOutline<'s> {
        let mut pieces = vec![];
        let outermost = Environment::outermost();
        self.hypotheses.outline(tree, 0, &outermost, &mut pieces);
        pieces
    }

    /// The unknowns of the given equations.
    pub fn unknowns(&self) -> Vec<Result<Value<Class>, NoValue>> {
        let outermost = Environment::outermost();
        let all = self.reading.unknowns();
        all.map(|tree| self.hypotheses.value(tree, &outermost))
            .collect()
    }

    /// The statement. Existential symbols are replaced by their witnesses, and the conditions that these are in their
    /// sets are added.
    pub fn statement(&self) -> TreeOutline<'s> {
        let (at, reading) = (&self.statement, self.reading);
        let mut all = vec![];
        let outermost = Environment::outermost();
        if !reading.seeks() {
            at.outline(reading.tree(), 0, &outermost, &mut all);
            return all;
        }
        let mut inside = outermost.clone();
        for (existentials, _) in reading.existentials() {
            let witness = existentials.witness.as_ref();
            let value = witness.map(|witness| at.number(&witness.expr, &outermost));
            match value {
                Some(Ok(value)) => {
                    inside = at.moving(&existentials.name, Part::Whole, value, &inside)
                }
                Some(Err(gap)) => return vec![Piece::Value(None, Err(gap))],
                None => return vec![Piece::Word("without a witness".to_owned())],
            }
        }
        let mut members: Vec<TreeOutline<'s>> = vec![];
        let mut is_inhabited = true;
        for (existentials, ends) in reading.existentials() {
            let symbol = reading.declarations().symbol(&existentials.name);
            let Some(SymbolKind::Real(interval)) = symbol else {
                continue;
            };
            is_inhabited &= ends.is_empty() && has_points(interval);
            let own = || {
                let own = at.symbol(&existentials.name, &Part::Whole, &inside);
                Piece::Value(None, own.map(Value::Number))
            };
            let end = |bound: &Bound| Piece::Value(None, at.end(bound));
            let lower = interval.lower.iter();
            members.extend(lower.map(|bound| vec![relation(bound), end(bound), own()]));
            let upper = interval.upper.iter();
            members.extend(upper.map(|bound| vec![relation(bound), own(), end(bound)]));
            for end in ends {
                let mut pieces = vec![];
                at.outline(&end.expr, 0, &inside, &mut pieces);
                members.push(pieces);
            }
        }
        let tree = match &reading.tree().node {
            Node::Join(Connective::Implies, premise, conclusion)
                if is_inhabited && reading.is_free(premise) && !members.is_empty() =>
            {
                all.push(Piece::Word(word(Connective::Implies)));
                at.outline(premise, 0, &inside, &mut all);
                conclusion
            }
            _ => reading.tree(),
        };
        all.extend(members.iter().map(|_| Piece::Word(word(Connective::And))));
        all.extend(members.into_iter().flatten());
        at.outline(tree, 0, &inside, &mut all);
        all
    }
}

fn relation<T, N>(bound: &Bound) -> Piece<T, N> {
    let relation = if bound.closed {
        Relation::AtMost
    } else {
        Relation::Less
    };
    Piece::Word(relation.sign().to_owned())
}

/// Whether an interval with rational bounds is nonempty.
fn has_points(interval: &Interval) -> bool {
    let (Some(lower), Some(upper)) = (&interval.lower, &interval.upper) else {
        return true;
    };
    let ends = (lower.value.as_rational(), upper.value.as_rational());
    let (Some(a), Some(b)) = ends else {
        return false;
    };
    a < b || (a == b && lower.closed && upper.closed)
}
