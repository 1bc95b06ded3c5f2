//! What a verdict prints is read back like any formula of a file, and judged.

use torse_semantics::tree::Reading;
use torse_semantics::{SampleStatistics, judge_samples};
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::{Bound, SymbolKind};
use torse_syntax::formula::{Expr, parse};
use torse_syntax::notation;
use torse_verdicts::Outcome;
use torse_verdicts::words;

/// The formulas that a verdict prints.
fn formulas(outcome: &Outcome) -> Vec<&str> {
    let correction = outcome.correction().into_iter();
    let corrected = correction.flat_map(|c| std::iter::once(&c.statement).chain(&c.conditions));
    let conditions = outcome.conditions().iter();
    let assumed = outcome.claim.assumed.iter().map(|assumed| &assumed.formula);
    let all = conditions
        .chain(corrected)
        .chain(assumed)
        .chain(outcome.parsed())
        .chain(outcome.derived());
    all.map(|formula| formula.text.as_str()).collect()
}

/// What is printed and cannot be read, or is written otherwise when it is read.
pub fn unreadable(outcome: &Outcome) -> Vec<String> {
    let id = &outcome.claim.id;
    let wrong = formulas(outcome).into_iter().filter(|text| {
        let again = parse(text).map(|expr| notation::text(&expr));
        again.ok().as_deref() != Some(text)
    });
    let wrong = wrong.map(|text| format!("{id}: {text}"));
    let witness = outcome.witness().into_iter();
    let witness = witness.flat_map(|witness| &witness.at);
    // What stands for a root without a text of its own has a number for a name, and is left out of what is shown.
    let witness = witness.filter(|(name, _)| !name.starts_with('√'));
    let sides = witness.filter(|(name, value)| parse(name).is_err() || parse(value).is_err());
    let sides = sides.map(|(name, value)| format!("{id}: {name} = {value}"));
    wrong.chain(sides).collect()
}

/// The steps that say of a range that it may be wider: the name, and the new end.
pub fn widened(outcome: &Outcome) -> Vec<(String, String)> {
    let said = |step: &String| {
        let rest = step.strip_prefix("the range of ")?;
        let (name, rest) = rest.split_once(" may be widened to ")?;
        Some((name.to_owned(), rest.split_once(':')?.0.to_owned()))
    };
    words::steps(outcome).iter().filter_map(said).collect()
}

/// Numbers by name, as printed.
type Point = Vec<(String, String)>;

/// The steps that say of a range that the statement fails beyond: the numbers of the point, that which leaves its range first.
pub fn beyond(outcome: &Outcome) -> Vec<Point> {
    let pair = |part: &str| {
        let (name, value) = part.split_once(" = ")?;
        Some((name.to_owned(), value.to_owned()))
    };
    let said = |step: &String| {
        let (_, point) = step
            .strip_prefix("the range of ")?
            .split_once(" cannot be larger: at ")?;
        let point = point.strip_suffix(" it fails")?;
        point.split(", ").map(pair).collect()
    };
    words::steps(outcome).iter().filter_map(said).collect()
}

/// What the semantics finds of a claim on such a wider range; nothing if the name is none of the file, or the end lies inside.
pub fn on_wider_range(claim: &Claim, name: &str, end: &str) -> Option<SampleStatistics> {
    judged(&wider(claim, name, end)?, &format!("wider {name}"), 40)
}

/// What the semantics finds of a claim where these numbers have these values, whatever the others are; nothing where one of them
/// is no declared number, as the tangent of an angle is none, or its value is not rational.
pub fn at_point_beyond(claim: &Claim, point: &[(String, String)]) -> Option<SampleStatistics> {
    let mut there = claim.clone();
    for (name, value) in point {
        let Some(SymbolKind::Real(interval)) = there.declarations.symbol(name) else {
            return None;
        };
        let mut interval = (**interval).clone();
        let end = Some(Bound {
            value: number(&parse(value).ok()?)?.into(),
            closed: true,
        });
        (interval.lower, interval.upper) = (end.clone(), end);
        let kind = SymbolKind::Real(Box::new(interval));
        there.declarations = there.declarations.with_symbol(name, kind).into();
    }
    judged(&there, "beyond", 6)
}

/// What the semantics finds at so many points.
fn judged(claim: &Claim, seed: &str, points: u64) -> Option<SampleStatistics> {
    let statement = claim.statement.as_ref()?;
    let core = torse_elaborate::elaborate(claim, statement).ok()?;
    let names = core.symbols.keys().map(|name| &**name);
    let reading = Reading::new(claim, &statement.expr, names);
    Some(judge_samples(&reading, &[], seed, points, 400_000))
}

/// The claim with a range that reaches to this end.
fn wider(claim: &Claim, name: &str, end: &str) -> Option<Claim> {
    let Some(SymbolKind::Real(interval)) = claim.declarations.symbol(name) else {
        return None;
    };
    let mut interval = (**interval).clone();
    let value = number(&parse(end).ok()?)?;
    let bound = Bound {
        value: value.clone().into(),
        closed: true,
    };
    let below = |b: &Bound| b.value.as_rational().is_some_and(|lower| value < *lower);
    let above = |b: &Bound| b.value.as_rational().is_some_and(|upper| value > *upper);
    if interval.lower.as_ref().is_some_and(below) {
        interval.lower = Some(bound);
    } else if interval.upper.as_ref().is_some_and(above) {
        interval.upper = Some(bound);
    } else {
        return None;
    }
    let mut wider = claim.clone();
    wider.declarations = claim
        .declarations
        .with_symbol(name, SymbolKind::Real(Box::new(interval)))
        .into();
    Some(wider)
}

fn number(expr: &Expr) -> Option<torse_numbers::Rational> {
    use torse_syntax::formula::{Node, Operator};
    Some(match &expr.node {
        Node::Number { value, .. } => value.clone(),
        Node::Negative(inner) => -number(inner)?,
        Node::Binary(Operator::Divide, a, b) => number(a)? / number(b)?,
        _ => return None,
    })
}
