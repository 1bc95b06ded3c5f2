//! Sums, products and integrals with their bounds; quotients of differentials.
//!
//! What a sum sums reaches to the end of the term; an integral to its differential.

use super::applied::{lone_letter, named};
use super::arithmetic::begins_operand;
use super::error::LatexError;
use super::item::{Nucleus, TexItem, place_of};
use super::layout::is_letter;
use super::names::LatexKind;
use super::reader::{Line, ReadTerm, Reader, Shape, Term, integer_at};
use crate::formula::Place;

/// The bounds of one index.
struct Bounds<'i> {
    index: String,
    low: &'i [TexItem],
    high: &'i [TexItem],
}

impl Reader<'_> {
    /// Reads a sum, a product over an index, or an integral.
    pub fn big(&mut self, line: &mut Line<'_>, kind: &str) -> ReadTerm {
        let Some(item) = line.peek() else {
            return Err(LatexError::new(line.place(), "an operand is missing"));
        };
        if item.primes > 0 {
            let error = LatexError::new(item.place, "a sum or an integral has a prime");
            return Err(error.with_help("say in words what the prime leaves out"));
        }
        line.next += 1;
        match kind {
            "int" => self.integral(line, item),
            _ => self.over_an_index(line, item, kind),
        }
    }

    fn over_an_index(&mut self, line: &mut Line<'_>, item: &TexItem, kind: &str) -> ReadTerm {
        let place = item.place;
        let bounds = bounds(item)?;
        let mut ends = vec![];
        for bound in &bounds {
            if self
                .names
                .kind(&bound.index)
                .is_some_and(|kind| *kind != LatexKind::Number)
            {
                return Err(LatexError::new(
                    place,
                    format!("the index `{}` is declared as something else", bound.index),
                ));
            }
            let low = self.value(bound.low, place, "the bound")?;
            ends.push((low, self.value(bound.high, place, "the bound")?));
        }
        let outside = self.bound.len();
        self.bound
            .extend(bounds.iter().map(|bound| bound.index.clone()));
        let body = self.deeper(place, |reader| reader.product(line));
        self.bound.truncate(outside);
        let mut body = body?;
        let name = if kind == "sum" { "sum" } else { "product" };
        if name == "product" && body.shape != Shape::Number {
            return Err(LatexError::new(
                place,
                "a product over an index is not of numbers",
            ));
        }
        for (bound, (low, high)) in bounds.iter().zip(ends).rev() {
            let whole = place.to(body.expr.place);
            let index = named(&bound.index, place, Shape::Number).expr;
            body = Term::call(name, vec![index, low, high, body.expr], whole, body.shape);
        }
        Ok(body)
    }

    fn integral(&mut self, line: &mut Line<'_>, item: &TexItem) -> ReadTerm {
        let place = item.place;
        let (Some(low), Some(high)) = (&item.below, &item.above) else {
            return Err(LatexError::new(
                place,
                "an integral without bounds is a family of functions",
            ));
        };
        let (low, high) = (
            self.value(low, place, "the bound")?,
            self.value(high, place, "the bound")?,
        );
        let rest = line.rest();
        if rest
            .first()
            .is_some_and(|first| matches!(first.nucleus, Nucleus::Big(_)))
        {
            return Err(LatexError::new(
                place,
                "which differential belongs to which of several integrals?",
            )
            .with_help("put the inner integral in brackets"));
        }
        let differential = (0..rest.len()).find(|at| is_differential(rest, *at));
        let Some((at, variable)) =
            differential.and_then(|at| Some((at, lone_letter(rest.get(at + 1..at + 2)?)?)))
        else {
            return Err(LatexError::new(place, "the integral has no differential"));
        };
        let inner = rest.get(..at).unwrap_or(&[]);
        if inner
            .iter()
            .any(|item| item.is_sign("=") || item.is_sign(","))
        {
            return Err(LatexError::new(
                place,
                "the integral has no differential before the next relation",
            ));
        }
        let behind = rest.get(at + 2);
        if inner.is_empty() && behind.is_some_and(begins_operand) {
            let error = LatexError::new(
                place,
                "the differential stands before an operand: is this the integrand?",
            );
            return Err(error.with_help("write the differential last"));
        }
        let body = if inner.is_empty() {
            Term {
                expr: integer_at(1, place),
                shape: Shape::Number,
            }
        } else {
            self.whole(inner, place)?
        };
        let end = rest.get(at + 1).map_or(place, |item| item.place);
        line.next += at + 2;
        let variable = named(&variable, end, Shape::Number).expr;
        Ok(Term::call(
            "integral",
            vec![body.expr, variable, low, high],
            place.to(end),
            body.shape,
        ))
    }

    /// Reads `\frac{d}{dt} f`, `\frac{df}{dt}`, `\frac{\partial^2 f}{\partial u \partial v}`, if this is one.
    pub fn derivative(
        &mut self,
        line: &mut Line<'_>,
        over: &[TexItem],
        under: &[TexItem],
    ) -> Result<Option<Term>, LatexError> {
        let (Some((head, of)), Some(item)) = (over.split_first(), line.peek()) else {
            return Ok(None);
        };
        let is_d = |item: &TexItem| {
            let bare = TexItem {
                above: None,
                ..item.clone()
            };
            item.is_sign("partial") || is_letter(std::slice::from_ref(&bare), "d")
        };
        if !is_d(head) || !under.first().is_some_and(is_d) {
            return Ok(None);
        }
        // A number d over d times something is a quotient, and looks like a differential.
        if !head.is_sign("partial") && self.names.kind("d").is_some() {
            return Err(LatexError::new(
                item.place,
                "this may be a derivative or a quotient with the declared `d`",
            ));
        }
        let place = item.place;
        let variables = differentials(under, is_d).ok_or_else(|| {
            LatexError::new(
                place,
                "the denominator of this derivative is not understood",
            )
        })?;
        let order = match &head.above {
            None => 1,
            Some(above) => small(above).ok_or_else(|| {
                LatexError::new(place, "the order of this derivative is no number")
            })?,
        };
        if order != variables.iter().map(|(_, order)| order).sum::<u64>() {
            return Err(LatexError::new(place, "the orders above and below differ"));
        }
        line.next += 1;
        let body = if of.is_empty() {
            let body = self.deeper(place, |reader| reader.factor(line))?;
            if line.peek().is_some_and(begins_operand) {
                let error = LatexError::new(place, "how far does this derivative reach?");
                return Err(error.with_help("put what is differentiated in brackets"));
            }
            body
        } else {
            if line.is_before_bracket() && of.len() == 1 {
                return Err(LatexError::new(
                    place,
                    "a quotient of differentials before brackets is not understood",
                )
                .with_help("write `f'(t)`, or the argument in the numerator"));
            }
            self.whole(of, place)?
        };
        if matches!(body.expr.node, crate::formula::Node::Name(_)) {
            return Err(LatexError::new(
                place,
                "what is differentiated is a symbol that does not depend on anything",
            )
            .with_help("declare it as a function"));
        }
        let shape = body.shape;
        let mut result = body.expr;
        for (variable, order) in variables.into_iter().rev() {
            result = Term::derivative(result, &variable, order, place, shape).expr;
        }
        Ok(Some(Term {
            expr: result,
            shape,
        }))
    }
}

/// Whether `d` and a letter stand here.
fn is_differential(items: &[TexItem], at: usize) -> bool {
    let d = items.get(at..=at).is_some_and(|list| is_letter(list, "d"));
    d && items
        .get(at + 1..at + 2)
        .is_some_and(|next| lone_letter(next).is_some())
}

/// The variables of a denominator of differentials with their orders.
fn differentials(under: &[TexItem], is_d: impl Fn(&TexItem) -> bool) -> Option<Vec<(String, u64)>> {
    let mut found = vec![];
    let pairs = under.chunks(2);
    for pair in pairs {
        let [d, variable] = pair else {
            return None;
        };
        if !is_d(d) || d.above.is_some() {
            return None;
        }
        let order = match &variable.above {
            None => 1,
            Some(above) => small(above)?,
        };
        let bare = TexItem {
            above: None,
            ..variable.clone()
        };
        found.push((lone_letter(&[bare])?, order));
    }
    Some(found)
}

fn small(list: &[TexItem]) -> Option<u64> {
    match list {
        [
            TexItem {
                nucleus: Nucleus::Number(digits),
                ..
            },
        ] => digits.parse().ok().filter(|order| (1..=12).contains(order)),
        _ => None,
    }
}

/// The bounds of a sum: `i = 0` below and `n` above, several indices with the same bounds, or `0 \le i \le n`.
fn bounds(item: &TexItem) -> Result<Vec<Bounds<'_>>, LatexError> {
    let place: Place = item.place;
    let wrong = || {
        LatexError::new(
            place,
            "the bounds of this sum or product are not understood",
        )
        .with_help("write `\\sum_{i=0}^{n}`")
    };
    let below = item.below.as_deref().ok_or_else(wrong)?;
    let place_below = place_of(below, place);
    if below
        .iter()
        .any(|item| matches!(item.nucleus, Nucleus::Dots))
    {
        return Err(LatexError::new(place_below, "an ellipsis in the bounds"));
    }
    match &item.above {
        Some(high) => {
            if matches!(high.as_slice(), [only] if only.is_sign("infty")) {
                return Err(LatexError::new(
                    place,
                    "series without end are not in the language",
                ));
            }
            let at = below
                .iter()
                .position(|item| item.is_sign("="))
                .ok_or_else(wrong)?;
            let low = below.get(at + 1..).unwrap_or(&[]);
            let names = super::names::parts(below.get(..at).unwrap_or(&[]));
            let names = names
                .into_iter()
                .map(|name| lone_letter(name).ok_or_else(wrong));
            names
                .map(|index| {
                    Ok(Bounds {
                        index: index?,
                        low,
                        high,
                    })
                })
                .collect()
        }
        None => {
            let sides: Vec<&[TexItem]> = below.split(|item| item.is_sign("le")).collect();
            match sides.as_slice() {
                [low, middle, high] => Ok(vec![Bounds {
                    index: lone_letter(middle).ok_or_else(wrong)?,
                    low,
                    high,
                }]),
                _ => Err(wrong()),
            }
        }
    }
}
