//! Compares each formula in the words of a correction with the statement that is decided with it.
//!
//! A letter prints the words; only the statement is decided. So each formula of the words is set as the letter sets it,
//! read with the declarations of the claim, and evaluated at random residues: a side has to have the value of a part of
//! the corrected statement, of its hypotheses, or of a definition that it uses, and two sides have to be related as
//! they are there. The left side of an equation may also be the print's own, in the order of the print: it names what
//! the right side says.
//!
//! What cannot be read, and a condition in a sentence of which the statement knows nothing, are *unread*: nothing that
//! is decided stands behind them.

use super::formulas::{Formulas, visit_parts};
use super::paper_names::PaperNames;
use super::passages::{is_formula, passages, plain, sides, with_round_brackets};
use crate::agreement::are_same;
use std::sync::OnceLock;
use torse_semantics::tree::{Assignment, Compared, Reading};
use torse_semantics::{Class, Name, Scrambled, Value, Work};
use torse_syntax::derivation::Claim;
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::notation;

/// The assignments that are tried, of small and of greater integers, and at how many of them formulas are compared.
const ATTEMPTS: [u64; 8] = [0, 5, 9, 14, 22, 31, 43, 57];
const COMPARED: usize = 2;
/// Maximum number of operations for one assignment.
const MAX_WORK: u64 = 1_500_000;
/// A formula of so many nodes says more than a condition such as `k > 2` or `μ = -1` does.
const LONGER_THAN_A_CONDITION: usize = 5;

/// What is found of the formulas in the words of a correction.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FormulasOfWords {
    /// Formulas that say what is decided.
    pub decided: Vec<String>,
    /// Formulas that the paper prints as well, and that nothing decides.
    pub printed: Vec<String>,
    /// Formulas that say something else than what is decided.
    pub otherwise: Vec<String>,
    /// Formulas that cannot be read, and conditions that no statement is about.
    pub unread: Vec<String>,
}

/// What the words of a correction are compared with.
#[derive(Debug)]
pub struct CorrectedWords {
    /// The words, passage by passage.
    pub reads: Vec<String>,
    print: Print,
    decided: Vec<Decided>,
}

impl CorrectedWords {
    /// Prepares the comparison with the claims that are decided for the same fault, the corrected one first, with the print
    /// of the claim and what the paper says around it.
    pub(super) fn new(decided: Vec<Claim>, reads: &[&str], printed: &str, around: &str) -> Self {
        let bare = |text: &str| plain(&with_round_brackets(text));
        Self {
            reads: reads.iter().map(|&text| text.to_owned()).collect(),
            print: Print {
                own: bare(printed),
                around: bare(around),
            },
            decided: decided.into_iter().map(Decided::new).collect(),
        }
    }

    /// The corrected statement, as it is decided.
    #[must_use]
    pub fn states(&self) -> String {
        let statement = self
            .decided
            .first()
            .and_then(|own| own.claim.statement.as_ref());
        statement
            .map(|statement| notation::text(&statement.expr))
            .unwrap_or_default()
    }

    /// Compares words with what is decided.
    #[must_use]
    pub fn compared(&self, reads: &str) -> FormulasOfWords {
        let reads = with_round_brackets(reads);
        let texts = passages(&reads);
        let is_printed = |text: &&str| self.print.around.contains(&plain(text));
        // Words that are those of the paper correct nothing.
        let is_unchanged = self.print.own.contains(&plain(&reads));
        let mut best: Vec<Judged> = (texts.iter().map(is_printed))
            .map(|printed| {
                if printed {
                    Judged::Printed
                } else {
                    Judged::Unread
                }
            })
            .collect();
        for claim in &self.decided {
            for (best, found) in best.iter_mut().zip(claim.against(&texts, &self.print)) {
                *best = (*best).max(found);
            }
            if best.iter().all(|found| *found == Judged::Decided) {
                break;
            }
        }
        let mut found = FormulasOfWords::default();
        for (text, judged) in texts.into_iter().zip(best) {
            let list = match judged {
                Judged::Decided => &mut found.decided,
                Judged::Printed if is_unchanged && is_formula(text) => &mut found.otherwise,
                Judged::Printed => &mut found.printed,
                Judged::Otherwise => &mut found.otherwise,
                Judged::Unread => &mut found.unread,
            };
            list.push(text.to_owned());
        }
        found
    }
}

/// A claim that is decided, with the values of its formulas.
#[derive(Debug)]
struct Decided {
    claim: Claim,
    names: PaperNames,
    /// The names of the definitions without parameters that its formulas use.
    defined: Vec<Expr>,
    /// The terms of its sums, with numbers for the variables.
    terms: Vec<Expr>,
    values: OnceLock<Vec<Known>>,
}

/// The values of the comparisons and formulas of a claim at one assignment.
#[derive(Debug)]
struct Known {
    relations: Vec<KnownRelation>,
    formulas: Vec<KnownFormula>,
}

/// A comparison with the values of its sides.
#[derive(Debug)]
struct KnownRelation {
    relation: Relation,
    left: Option<Value<Class>>,
    right: Option<Value<Class>>,
}

#[derive(Debug)]
struct KnownFormula {
    /// Whether the claim states it; if not, a definition has it.
    stated: bool,
    /// Whether it is a name or a number.
    is_short: bool,
    value: Option<Value<Class>>,
}

impl Decided {
    fn new(claim: Claim) -> Self {
        let names = PaperNames::new(&claim);
        let defined = defined(&claim);
        let terms = terms(&claim, &names);
        Self {
            claim,
            names,
            defined,
            terms,
            values: OnceLock::new(),
        }
    }

    /// What is found of formulas when they are compared with this claim.
    fn against(&self, texts: &[&str], print: &Print) -> Vec<Judged> {
        let Some(statement) = &self.claim.statement else {
            return vec![];
        };
        let read: Vec<ReadPassage<'_>> = texts
            .iter()
            .map(|text| ReadPassage::new(text, &self.names))
            .collect();
        let reading = Reading::new(&self.claim, &statement.expr, []);
        let known = self.values.get_or_init(|| self.known(&reading));
        let points: Vec<Point<'_>> = ATTEMPTS
            .into_iter()
            .zip(known)
            .map(|(attempt, known)| {
                let passages = at_assignment(&self.claim, &reading, attempt, |value| {
                    let mut values = vec![];
                    for passage in &read {
                        let sides = passage.sides.iter();
                        values.push(
                            sides
                                .map(|side| side.trees.iter().map(value).collect())
                                .collect(),
                        );
                    }
                    values
                });
                Point { known, passages }
            })
            .collect();
        let mut followed = Followed::default();
        let each = read.iter().enumerate();
        each.map(|(number, passage)| {
            Comparison {
                number,
                passage,
                points: &points,
            }
            .judged(print, &mut followed)
        })
        .collect()
    }

    /// The values of what is decided, assignment by assignment.
    fn known<'s>(&'s self, reading: &'s Reading<'s>) -> Vec<Known> {
        let mut said = Said::new(&self.claim, &self.defined);
        self.terms.iter().for_each(|term| said.add(true, term));
        let reading_of = |attempt| {
            at_assignment(&self.claim, reading, attempt, |value| Known {
                relations: (said.relations.iter())
                    .map(|(relation, left, right)| KnownRelation {
                        relation: *relation,
                        left: value(left),
                        right: value(right),
                    })
                    .collect(),
                formulas: (said.formulas.iter())
                    .map(|(stated, tree)| KnownFormula {
                        stated: *stated,
                        is_short: tree.size() < 3,
                        value: value(tree),
                    })
                    .collect(),
            })
        };
        ATTEMPTS.into_iter().map(reading_of).collect()
    }
}

/// Evaluates formulas of a claim at an assignment.
fn at_assignment<'s, T>(
    claim: &'s Claim,
    reading: &'s Reading<'s>,
    attempt: u64,
    made: impl FnOnce(&dyn Fn(&'s Expr) -> Option<Value<Class>>) -> T,
) -> T {
    let work = Work::new(MAX_WORK);
    let arithmetic = Scrambled { work: &work };
    let assignment = Assignment::new(&claim.declarations, attempt);
    let number = |name: &Name| assignment.number(name);
    let trees = Compared::new(reading, &arithmetic, &number);
    made(&|tree| trees.value(tree).ok())
}

/// What is known of a formula of the words; what more is known of is greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Judged {
    Unread,
    Otherwise,
    /// It is the print's own, and nothing decides it.
    Printed,
    Decided,
}

/// A formula of the words, with the readings of its sides.
struct ReadPassage<'t> {
    text: &'t str,
    sides: Vec<ReadSide<'t>>,
    relations: Vec<Option<Relation>>,
}

struct ReadSide<'t> {
    text: &'t str,
    trees: Vec<Expr>,
}

impl<'t> ReadPassage<'t> {
    fn new(text: &'t str, names: &PaperNames) -> Self {
        let (sides, relations) = sides(text);
        let sides = sides.into_iter().map(|text| ReadSide {
            text,
            trees: names.readings(text),
        });
        Self {
            text,
            sides: sides.collect(),
            relations,
        }
    }
}

/// The values of what is decided, and of what is read, at one assignment.
struct Point<'k> {
    known: &'k Known,
    /// By passage, side and reading.
    passages: Vec<Vec<Vec<Option<Value<Class>>>>>,
}

impl Point<'_> {
    fn value(&self, passage: usize, side: usize, tree: usize) -> Option<&Value<Class>> {
        self.passages.get(passage)?.get(side)?.get(tree)?.as_ref()
    }
}

/// Whether a test holds wherever it can be made, and can be made often enough.
fn holds(points: &[Point<'_>], test: impl Fn(&Point<'_>) -> Option<bool>) -> bool {
    let made: Vec<bool> = points.iter().filter_map(test).collect();
    made.len() >= COMPARED && made.into_iter().all(|holds| holds)
}

/// A formula of the words, compared with what is decided.
struct Comparison<'p> {
    number: usize,
    passage: &'p ReadPassage<'p>,
    points: &'p [Point<'p>],
}

impl Comparison<'_> {
    fn trees(&self, side: usize) -> std::ops::Range<usize> {
        0..self
            .passage
            .sides
            .get(side)
            .map_or(0, |side| side.trees.len())
    }

    fn is_long(&self, side: usize) -> bool {
        let read = self.passage.sides.get(side);
        let first = read.and_then(|side| side.trees.first());
        first.is_some_and(|tree| tree.size() >= LONGER_THAN_A_CONDITION)
    }

    /// Whether a side has a value at all.
    fn has_value(&self, side: usize) -> bool {
        self.trees(side).any(|tree| {
            self.points
                .iter()
                .any(|point| point.value(self.number, side, tree).is_some())
        })
    }

    /// The first formula that has the value of a side: of those that the claim states, or of its definitions, too.
    fn formula(&self, side: usize, stated: bool) -> Option<usize> {
        let all = self
            .points
            .first()
            .map_or(0, |point| point.known.formulas.len());
        (0..all).find(|formula| {
            self.trees(side).any(|tree| {
                holds(self.points, |point| {
                    let known = point.known.formulas.get(*formula)?;
                    if (stated && !known.stated) || (self.is_long(side) && known.is_short) {
                        return Some(false);
                    }
                    let value = known.value.as_ref()?;
                    let own = point.value(self.number, side, tree);
                    Some(own.is_some_and(|own| are_same(own, value)))
                })
            })
        })
    }

    /// Whether a side and the next one are related in this way by a comparison.
    fn are_related(&self, side: usize, relation: Relation) -> bool {
        let all = self
            .points
            .first()
            .map_or(0, |point| point.known.relations.len());
        (0..all).any(|stated| {
            let pairs = self
                .trees(side)
                .flat_map(|a| self.trees(side + 1).map(move |b| (a, b)));
            pairs.into_iter().any(|(a, b)| {
                holds(self.points, |point| {
                    let known = point.known.relations.get(stated)?;
                    let (left, right) = (known.left.as_ref()?, known.right.as_ref()?);
                    let (Some(a), Some(b)) = (
                        point.value(self.number, side, a),
                        point.value(self.number, side + 1, b),
                    ) else {
                        return Some(false);
                    };
                    let same =
                        known.relation == relation && are_same(a, left) && are_same(b, right);
                    let mirrored = known.relation.mirrored() == relation;
                    Some(same || (mirrored && are_same(a, right) && are_same(b, left)))
                })
            })
        })
    }

    /// Whether the left side is what the paper calls the right one, which is decided: a name of the print; of those with
    /// a value, which another name could have, each behind the one before.
    fn names(&self, print: &str, followed: &mut Followed) -> bool {
        let is_named = !self.has_value(0);
        if !self.is_long(1) && !is_named {
            return false;
        }
        let Some(formula) = self.formula(1, !is_named) else {
            return false;
        };
        let name = self
            .passage
            .sides
            .first()
            .map(|side| plain(side.text))
            .unwrap_or_default();
        if name.is_empty() {
            return true;
        }
        if is_named {
            return print.contains(&name);
        }
        let Some(at) = print
            .get(followed.print..)
            .and_then(|rest| rest.find(&name))
        else {
            return false;
        };
        let in_order = followed.formula.is_none_or(|before| before < formula);
        followed.print += at + name.len();
        followed.formula = Some(formula);
        in_order
    }

    fn judged(&self, print: &Print, followed: &mut Followed) -> Judged {
        let relations = &self.passage.relations;
        let all_decided = match relations.as_slice() {
            [] => self.formula(0, self.is_long(0)).is_some(),
            relations => (0..).zip(relations).all(|(side, relation)| {
                let is_equation = *relation == Some(Relation::Equal);
                relation.is_some_and(|relation| self.are_related(side, relation))
                    || (side == 0 && is_equation && self.names(&print.own, followed))
            }),
        };
        let sides = 0..self.passage.sides.len();
        // A long side of which no statement knows.
        let is_unknown = sides
            .clone()
            .any(|side| self.is_long(side) && self.formula(side, false).is_none());
        let is_read = sides
            .skip(usize::from(!relations.is_empty()))
            .all(|side| !self.trees(side).is_empty());
        // An inequality is a condition; which of them are stated and which are assumed differs.
        let is_equation = relations
            .iter()
            .all(|relation| *relation == Some(Relation::Equal));
        match all_decided {
            true => Judged::Decided,
            false if print.around.contains(&plain(self.passage.text)) => Judged::Printed,
            false if is_read && is_equation && (is_unknown || self.is_long(1)) => Judged::Otherwise,
            false => Judged::Unread,
        }
    }
}

/// How far the names on left sides have been followed through the print, and the formulas that they name.
#[derive(Default)]
struct Followed {
    print: usize,
    formula: Option<usize>,
}

/// The print, without blanks.
#[derive(Debug)]
struct Print {
    /// That of the claim.
    own: String,
    /// What the paper says around it, too.
    around: String,
}

/// What is decided: comparisons, and the formulas in them.
#[derive(Default)]
struct Said<'c> {
    relations: Vec<(Relation, &'c Expr, &'c Expr)>,
    /// Each with whether the claim states it.
    formulas: Vec<(bool, &'c Expr)>,
}

impl<'c> Said<'c> {
    /// What a claim states, and what its definitions say; `defined` are the names of those without parameters.
    fn new(claim: &'c Claim, defined: &'c [Expr]) -> Self {
        let mut said = Self::default();
        let hypotheses = claim.assumptions.iter().chain(&claim.given);
        let hypotheses = hypotheses.map(|own| &own.formula.expr);
        let written = claim.statement.iter().map(|own| &own.expr);
        written
            .chain(hypotheses)
            .for_each(|tree| said.add(true, tree));
        for name in defined {
            if let Node::Name(text) = &name.node
                && let Some(definition) = claim.declarations.definition(text)
            {
                said.add(false, &definition.body.expr);
                said.relate(Relation::Equal, name, &definition.body.expr);
            }
        }
        said
    }

    /// Adds the comparisons of a statement, and all formulas in it.
    fn add(&mut self, stated: bool, tree: &'c Expr) {
        visit_parts(tree, &mut |part| {
            self.formulas.push((stated, part));
            if let Node::Compare(first, rest) = &part.node {
                let mut left = &**first;
                for (relation, right) in rest {
                    self.relate(*relation, left, right);
                    left = right;
                }
            }
        });
    }

    /// Adds a comparison, and those of the entries of two lists.
    fn relate(&mut self, relation: Relation, left: &'c Expr, right: &'c Expr) {
        self.relations.push((relation, left, right));
        if let (Node::List(left), Node::List(right)) = (&left.node, &right.node) {
            for (left, right) in left.iter().zip(right) {
                self.relate(relation, left, right);
            }
        }
    }
}

/// The names of definitions without parameters that formulas use.
fn defined(claim: &Claim) -> Vec<Expr> {
    let formulas = Formulas::new(claim);
    let names = formulas.names.iter().filter(|name| {
        let definition = claim.declarations.definition(name);
        definition.is_some_and(|definition| definition.parameters.is_empty())
    });
    names.map(|name| Expr::name(name)).collect()
}

/// The terms of the sums of a claim, with numbers for the variables of the sums.
fn terms(claim: &Claim, names: &PaperNames) -> Vec<Expr> {
    let mut found = vec![];
    for tree in Formulas::new(claim).reached {
        visit_parts(tree, &mut |part| {
            if let Node::Call(head, arguments) = &part.node
                && let Node::Name(name) = &head.node
                && let ("sum", [_, _, _, term]) = (name.as_str(), arguments.as_slice())
            {
                found.push(names.with_numbers(term));
            }
        });
    }
    found
}
