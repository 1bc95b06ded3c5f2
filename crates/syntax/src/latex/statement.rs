//! Statements: relations with their chains, what joins them, and the conditions behind a comma or behind "for" and "if".
//!
//! | print | reading |
//! |---|---|
//! | `a = b, c = d` | both |
//! | `a = b, t \in [0, 1]`; `0 \le t \le 1` | a condition: the range of t |
//! | `a = b, i = 0, \dots, n` | a condition: i is an integer of this range |
//! | `a = b, c > d` | a condition, or both: two readings |
//! | `a = b (x \ge 0)`, `a = b, (x \ge 0)` | a condition: brackets around a relation behind a statement |
//! | `... \text{ for } ...`, `if`, `where`, `with`, `when` | what follows are conditions |
//! | `t \in [0, 1]` alone | `0 <= t <= 1` |

use super::applied::lone_letter;
use super::arithmetic::unexpected;
use super::error::LatexError;
use super::item::{Nucleus, TexItem, place_of};
use super::names::{LatexKind, spelled};
use super::reader::{Line, Reader, Shape};
use crate::formula::{Connective, Expr, Node, Place, Relation};
use std::sync::Arc;

/// A condition that a formula states beside what it says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LatexCondition {
    /// Real numbers of an interval; an end without a formula is infinite.
    Interval {
        /// The names.
        names: Vec<String>,
        /// The lower end, and whether it belongs to the interval.
        low: (Option<Expr>, bool),
        /// The upper end.
        high: (Option<Expr>, bool),
        /// Whether the text writes a set of real numbers, as `\in [0, 1]` does; `0 \le n \le 1` may be of integers.
        is_set: bool,
    },
    /// An integer from the first formula to the second one; without an end if there is none.
    Integers {
        /// The name.
        name: String,
        /// The least value.
        low: Expr,
        /// The greatest value.
        high: Option<Expr>,
    },
    /// Another condition.
    Formula(Expr),
}

/// A formula with its conditions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LatexStatement {
    /// What it says.
    pub formula: Expr,
    /// Under which conditions.
    pub conditions: Vec<LatexCondition>,
    /// Whether it says that its left side is defined: `:=`, `\equiv`.
    pub defines: bool,
}

/// What stands before a segment.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    Comma,
    And,
    Or,
    Condition,
}

type Segment<'i> = (Before, &'i [TexItem]);

const RELATIONS: [(&str, Relation); 8] = [
    ("=", Relation::Equal),
    ("equiv", Relation::Equal),
    (":=", Relation::Equal),
    ("ne", Relation::Different),
    ("<", Relation::Less),
    ("le", Relation::AtMost),
    (">", Relation::Greater),
    ("ge", Relation::AtLeast),
];

impl Reader<'_> {
    /// Reads a statement, or a formula without a relation.
    pub fn statement(
        &mut self,
        items: &[TexItem],
        around: Place,
    ) -> Result<LatexStatement, LatexError> {
        let arrow = items
            .iter()
            .position(|item| item.is_sign("implies") || item.is_sign("iff"));
        if let Some(at) = arrow {
            return self.implication(items, at, around);
        }
        let segments = segments(items);
        let mut conditions = vec![];
        let mut main: Option<Expr> = None;
        let (mut conditional, mut defines) = (false, false);
        let mut pending: Vec<String> = vec![];
        let mut at = 0;
        while let Some((before, list)) = segments.get(at) {
            let place = place_of(list, around);
            conditional |= *before == Before::Condition;
            if let Some((condition, taken)) = self.enumeration(segments.get(at..).unwrap_or(&[]))? {
                if main.is_none() {
                    return Err(LatexError::new(
                        place,
                        "a range of an index alone states nothing",
                    ));
                }
                conditions.push(condition);
                at += taken;
                continue;
            }
            at += 1;
            // `x, y \in [0, 1]`
            if let (Some(name), true) = (lone_letter(list), main.is_some() && at < segments.len()) {
                pending.push(name);
                continue;
            }
            let alone = segments.len() == 1;
            if !alone
                && main.is_some()
                && let Some(condition) = self.range(list, &mut pending, place)?
            {
                conditions.push(condition);
                continue;
            }
            if !pending.is_empty() {
                return Err(LatexError::new(
                    place,
                    "a letter stands alone between commas",
                ));
            }
            defines |= list
                .iter()
                .any(|item| item.is_sign(":=") || item.is_sign("equiv"));
            let read = self.comparison(list, place)?;
            if conditional && main.is_some() {
                conditions.push(LatexCondition::Formula(read));
                continue;
            }
            let Some(so_far) = main.take() else {
                main = Some(read);
                continue;
            };
            let is_order = !matches!(&read.node, Node::Compare(_, rest) if rest.iter().all(|(relation, _)| *relation == Relation::Equal));
            if *before == Before::Comma && is_order {
                let says = [
                    "what follows the comma is a condition",
                    "what follows the comma is stated too",
                ];
                if self.choose(format!("comma {}", place.start), place, says) == 0 {
                    conditions.push(LatexCondition::Formula(read));
                    main = Some(so_far);
                    continue;
                }
            }
            let connective = if *before == Before::Or {
                Connective::Or
            } else {
                Connective::And
            };
            if let Node::Join(Connective::Or, ..) = so_far.node
                && connective == Connective::And
            {
                return Err(LatexError::new(
                    place,
                    "`and` and `or` are not put in brackets",
                ));
            }
            main = Some(joined(connective, so_far, read));
        }
        if !pending.is_empty() {
            return Err(LatexError::new(
                around,
                "a letter stands alone between commas",
            ));
        }
        match main {
            Some(formula) => Ok(LatexStatement {
                formula,
                conditions,
                defines,
            }),
            None => Err(LatexError::new(around, "there is no formula")),
        }
    }

    fn implication(
        &mut self,
        items: &[TexItem],
        at: usize,
        around: Place,
    ) -> Result<LatexStatement, LatexError> {
        let (left, right) = (
            items.get(..at).unwrap_or(&[]),
            items.get(at + 1..).unwrap_or(&[]),
        );
        let both_ways = items.get(at).is_some_and(|item| item.is_sign("iff"));
        if right
            .iter()
            .any(|item| item.is_sign("implies") || item.is_sign("iff"))
        {
            return Err(LatexError::new(
                around,
                "several arrows are not put in brackets",
            ));
        }
        let (left, right) = (
            self.statement(left, around)?,
            self.statement(right, around)?,
        );
        if !left.conditions.is_empty() || !right.conditions.is_empty() {
            return Err(LatexError::new(
                around,
                "conditions beside an arrow belong to one of its sides, or to both",
            ));
        }
        let implies = joined(
            Connective::Implies,
            left.formula.clone(),
            right.formula.clone(),
        );
        let formula = match both_ways {
            false => implies,
            true => joined(
                Connective::And,
                implies,
                joined(Connective::Implies, right.formula, left.formula),
            ),
        };
        Ok(LatexStatement {
            formula,
            conditions: vec![],
            defines: false,
        })
    }

    /// Reads sides with relations between them.
    fn comparison(&mut self, items: &[TexItem], around: Place) -> Result<Expr, LatexError> {
        if let [first, rest @ ..] = items
            && first.is_sign("not")
        {
            let inner = self.deeper(around, |reader| reader.comparison(rest, around))?;
            let place = first.place.to(inner.place);
            return Ok(Expr {
                node: Node::Not(Arc::new(inner)),
                place,
            });
        }
        if let Some(at) = items.iter().position(|item| item.is_sign("in")) {
            let Some((low, low_closed, high, high_closed)) =
                self.interval(items.get(at + 1..).unwrap_or(&[]), around)?
            else {
                return Err(LatexError::new(around, "this set is not understood")
                    .with_help("write an interval with finite ends, or relations"));
            };
            let middle = self.whole(items.get(..at).unwrap_or(&[]), around)?.expr;
            let (Some(low), Some(high)) = (low, high) else {
                return Err(LatexError::new(
                    around,
                    "an infinite interval is not read as a statement",
                )
                .with_help("write a relation"));
            };
            let sign = |closed: bool| {
                if closed {
                    Relation::AtMost
                } else {
                    Relation::Less
                }
            };
            let rest = vec![(sign(low_closed), middle), (sign(high_closed), high)];
            return Ok(Expr {
                node: Node::Compare(Arc::new(low), rest),
                place: place_of(items, around),
            });
        }
        let mut line = Line::new(items, around);
        let first = self.deeper(around, |reader| reader.sum(&mut line))?;
        let mut shape = (first.shape, super::arithmetic::is_zero(&first.expr));
        let mut rest = vec![];
        while let Some(item) = line.peek() {
            let slashed = item.is_sign("slashed");
            line.next += usize::from(slashed);
            let relation = line
                .peek()
                .and_then(|item| RELATIONS.into_iter().find(|(sign, _)| item.is_sign(sign)));
            let relation = match (relation, slashed) {
                (Some((_, relation)), false) => relation,
                (Some((_, Relation::Equal)), true) => Relation::Different,
                _ => return Err(unexpected(item)),
            };
            line.next += 1;
            let side = self.deeper(around, |reader| reader.sum(&mut line))?;
            let is_zero = super::arithmetic::is_zero(&side.expr);
            if shape.0 != side.shape && !shape.1 && !is_zero {
                return Err(LatexError::new(
                    side.expr.place,
                    "the sides have different shapes: a number and a vector or a matrix",
                ));
            }
            if shape.1 {
                shape = (side.shape, is_zero);
            }
            if side.shape != Shape::Number
                && !matches!(relation, Relation::Equal | Relation::Different)
            {
                return Err(LatexError::new(side.expr.place, "vectors have no order"));
            }
            rest.push((relation, side.expr));
        }
        match rest.last() {
            None => Ok(first.expr),
            Some((_, last)) => {
                let place = first.expr.place.to(last.place);
                Ok(Expr {
                    node: Node::Compare(Arc::new(first.expr), rest),
                    place,
                })
            }
        }
    }

    /// The ends of an interval, and whether each belongs to it.
    #[expect(clippy::type_complexity, reason = "read once, where it is called")]
    fn interval(
        &mut self,
        items: &[TexItem],
        around: Place,
    ) -> Result<Option<(Option<Expr>, bool, Option<Expr>, bool)>, LatexError> {
        let [
            TexItem {
                nucleus: Nucleus::Fenced(open @ ('[' | '('), inner, close @ (']' | ')')),
                below: None,
                above: None,
                ..
            },
        ] = items
        else {
            return Ok(None);
        };
        let ends = super::names::parts(inner);
        let [low, high] = ends.as_slice() else {
            return Ok(None);
        };
        let infinite = |list: &[TexItem]| list.last().is_some_and(|last| last.is_sign("infty"));
        let mut end = |list: &[TexItem]| match infinite(list) {
            true => Ok(None),
            false => self.value(list, around, "the end").map(Some),
        };
        Ok(Some((end(low)?, *open == '[', end(high)?, *close == ']')))
    }

    /// A condition that gives the range of a name: `t \in [0, 1]`, `0 \le t < 1`.
    fn range(
        &mut self,
        items: &[TexItem],
        pending: &mut Vec<String>,
        around: Place,
    ) -> Result<Option<LatexCondition>, LatexError> {
        if let Some(at) = items.iter().position(|item| item.is_sign("in")) {
            let set = items.get(at + 1..).unwrap_or(&[]);
            let Some(name) = lone_letter(items.get(..at).unwrap_or(&[])) else {
                return Ok(None);
            };
            let mut names = std::mem::take(pending);
            names.push(name);
            if matches!(set, [only] if matches!(&only.nucleus, Nucleus::Letter(letter, super::item::TexFace::Other(face)) if letter == "R" && face == "mathbb") && only.is_bare())
            {
                return Ok(Some(LatexCondition::Interval {
                    names,
                    low: (None, false),
                    high: (None, false),
                    is_set: true,
                }));
            }
            return match self.interval(set, around)? {
                Some((low, low_closed, high, high_closed)) => Ok(Some(LatexCondition::Interval {
                    names,
                    low: (low, low_closed),
                    high: (high, high_closed),
                    is_set: true,
                })),
                None => Err(LatexError::new(around, "this set is not understood")),
            };
        }
        let sides: Vec<&[TexItem]> = items
            .split(|item| item.is_sign("le") || item.is_sign("<"))
            .collect();
        let signs: Vec<bool> = items
            .iter()
            .filter(|item| item.is_sign("le") || item.is_sign("<"))
            .map(|item| item.is_sign("le"))
            .collect();
        let ([low, middle, high], [first, second]) = (sides.as_slice(), signs.as_slice()) else {
            return Ok(None);
        };
        // Names of the ends would make it a statement about them.
        let constant = |list: &[TexItem]| {
            list.iter().all(|item| match &item.nucleus {
                Nucleus::Letter(letter, _) => letter == "pi",
                Nucleus::Operator(_) | Nucleus::Big(_) | Nucleus::Words(_) => false,
                _ => true,
            })
        };
        let is_number = |name: &String| matches!(self.names.kind(name), Some(LatexKind::Number));
        let Some(name) = lone_letter(middle)
            .filter(is_number)
            .filter(|_| constant(low) && constant(high))
        else {
            return Ok(None);
        };
        let mut names = std::mem::take(pending);
        names.push(name);
        let low = self.value(low, around, "the end")?;
        let high = self.value(high, around, "the end")?;
        Ok(Some(LatexCondition::Interval {
            names,
            low: (Some(low), *first),
            high: (Some(high), *second),
            is_set: false,
        }))
    }

    /// `i = 0, 1, \dots, n` as segments between commas, and how many these are.
    fn enumeration(
        &mut self,
        segments: &[Segment<'_>],
    ) -> Result<Option<(LatexCondition, usize)>, LatexError> {
        let dots =
            |list: &[TexItem]| matches!(list, [only] if matches!(only.nucleus, Nucleus::Dots));
        let Some(at) = segments
            .iter()
            .take(4)
            .position(|(_, list)| dots(list))
            .filter(|at| *at > 0)
        else {
            return Ok(None);
        };
        let Some((_, first)) = segments.first() else {
            return Ok(None);
        };
        let [letter, equals, low @ ..] = *first else {
            return Ok(None);
        };
        let place = place_of(first, letter.place);
        let Ok((name, false)) = spelled(letter) else {
            return Ok(None);
        };
        if !letter.is_bare() || !equals.is_sign("=") {
            return Ok(None);
        }
        let relation = |(_, list): &&Segment<'_>| {
            list.iter()
                .any(|item| item.is_sign("=") || item.is_sign("in"))
        };
        if segments
            .iter()
            .take(at + 2)
            .skip(1)
            .any(|segment| relation(&segment))
        {
            return Ok(None);
        }
        let low = self.value(low, place, "the first value")?;
        for (step, (_, between)) in segments.iter().enumerate().take(at).skip(1) {
            let next = self.value(between, place, "the next value")?;
            if !follows(&low, &next, step) {
                return Err(LatexError::new(
                    next.place,
                    "these values do not go on by one",
                ));
            }
        }
        let high = match segments.get(at + 1) {
            None => None,
            Some((_, list)) => Some(self.value(list, place, "the last value")?),
        };
        let taken = at + 1 + usize::from(high.is_some());
        Ok(Some((LatexCondition::Integers { name, low, high }, taken)))
    }
}

/// Whether `next` is the number `step` above the number `low`.
fn follows(low: &Expr, next: &Expr, step: usize) -> bool {
    use torse_numbers::{Integer, Rational};
    match (&low.node, &next.node) {
        (Node::Number { value: low, .. }, Node::Number { value: next, .. }) => {
            let step = u64::try_from(step).unwrap_or(u64::MAX);
            next.clone() - low.clone() == Rational::from_integer(Integer::from(step))
        }
        _ => false,
    }
}

fn joined(connective: Connective, a: Expr, b: Expr) -> Expr {
    let place = a.place.to(b.place);
    Expr {
        node: Node::Join(connective, Arc::new(a), Arc::new(b)),
        place,
    }
}

/// Splits a statement at commas, blanks as wide as a letter, and words that join.
fn segments(items: &[TexItem]) -> Vec<Segment<'_>> {
    let mut found: Vec<Segment<'_>> = vec![];
    let mut before = Before::Comma;
    let mut start = 0;
    for (at, item) in items.iter().enumerate() {
        let Some(sign) = separates(item) else {
            continue;
        };
        let list = items.get(start..at).unwrap_or(&[]);
        if !list.is_empty() {
            segment(before, list, &mut found);
            before = sign;
        } else if sign != Before::Comma {
            before = sign;
        }
        start = at + 1;
    }
    let last = items.get(start..).unwrap_or(&[]);
    if !last.is_empty() {
        segment(before, last, &mut found);
    }
    found
}

/// Adds a segment; a relation in round brackets behind others is the condition of these.
fn segment<'i>(before: Before, list: &'i [TexItem], found: &mut Vec<Segment<'i>>) {
    let is_relation =
        |item: &TexItem| item.is_sign("in") || RELATIONS.iter().any(|(sign, _)| item.is_sign(sign));
    let (main, condition) = match list.split_last() {
        Some((last, main)) => match &last.nucleus {
            Nucleus::Fenced('(', inner, ')')
                if last.is_bare()
                    && inner.iter().any(is_relation)
                    && (main.iter().any(is_relation) || main.is_empty() && !found.is_empty()) =>
            {
                (main, inner.as_slice())
            }
            _ => (list, &[][..]),
        },
        None => return,
    };
    if !main.is_empty() {
        found.push((before, main));
    }
    let inner = segments(condition).into_iter();
    found.extend(inner.map(|(before, list)| match before {
        Before::Comma => (Before::Condition, list),
        other => (other, list),
    }));
}

fn separates(item: &TexItem) -> Option<Before> {
    match &item.nucleus {
        Nucleus::Sign(sign) => match sign.as_str() {
            "," | ";" | "quad" => Some(Before::Comma),
            "and" => Some(Before::And),
            "or" => Some(Before::Or),
            "forall" => Some(Before::Condition),
            _ => None,
        },
        Nucleus::Words(words) => match words
            .trim_matches([',', '.', ' '])
            .to_ascii_lowercase()
            .as_str()
        {
            "" => Some(Before::Comma),
            "and" => Some(Before::And),
            "or" => Some(Before::Or),
            "for" | "if" | "where" | "with" | "when" | "for all" | "whenever" | "provided that"
            | "provided" => Some(Before::Condition),
            _ => None,
        },
        _ => None,
    }
}
