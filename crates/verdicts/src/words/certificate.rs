//! The steps of proofs and refutations in words. A certificate is data and speaks no language; this module alone says
//! what one shows.

use torse_certificate::enclosure::{Agreement, Enclosure};
use torse_certificate::family::{Nonnegative, Part};
use torse_certificate::identity::{Combination, Equations, Identity, Vanishing};
use torse_certificate::order::Order;
use torse_certificate::point::{Comparison, Failure};
use torse_certificate::proof::assumptions::{Determining, Elimination, Sharpness};
use torse_certificate::proof::{Emptiness, Instance, Sides, Split, ZeroSide};
use torse_certificate::sign::Sign;
use torse_certificate::wronskian::{AtDegree, Wronskians};
use torse_certificate::zero_by_sign::{Zero, ZeroBySign};
use torse_certificate::{Polynomial, Proof, Refuted};

/// Describes the steps of a proof, followed by what it says about ranges.
#[must_use]
pub fn proof(proof: &Proof<Polynomial>) -> Vec<String> {
    let ranges = proof.ranges();
    let ranges = ranges.iter().map(range);
    reasons(proof).into_iter().chain(ranges).collect()
}

/// Describes the steps of a proof, without what it says about ranges.
#[must_use]
pub fn reasons(proof: &Proof<Polynomial>) -> Vec<String> {
    match proof {
        Proof::Identity(own) => identity(own),
        Proof::Combination(own) => vec![combination(own)],
        Proof::ZeroBySign(own) => zero_by_sign(own),
        Proof::Order(own) => order(own),
        Proof::Excluded(_) => vec!["the hypotheses exclude that the difference vanishes".to_owned()],
        Proof::Enclosure(own) => enclosure(own),
        Proof::Nonnegative(own) => nonnegative(own),
        Proof::Powers(_) => vec![
            "the functions of each degree are one function times powers of the quotient of the step factors, with \
             positive coefficients"
                .to_owned(),
            "the quotient is monotone: the minors of the collocation matrices are those of generalised Vandermonde \
             matrices, nonnegative at every degree"
                .to_owned(),
        ],
        Proof::Wronskians(own) => wronskians(own),
        Proof::On(ground) => {
            let roots = ground.eliminated.iter().filter_map(elimination);
            roots.chain(reasons(&ground.proof)).collect()
        }
        Proof::Instances(instances) => instances.iter().map(instance).collect(),
        Proof::Nowhere(empty) => vec![format!("no point is to be looked at: {}", emptiness(empty))],
        Proof::Split(own) => split(own),
        Proof::Sides(own) => sides(own),
        Proof::Exists(refuted) => {
            let point = place(refuted);
            let last = format!("a point where the negated statement fails: {point}");
            refutation(refuted).into_iter().chain([last]).collect()
        }
        _ => proof.parts().into_iter().flat_map(reasons).collect(),
    }
}

/// Describes the steps of a refutation.
#[must_use]
pub fn refutation(refuted: &Refuted<Polynomial>) -> Vec<String> {
    match refuted {
        Refuted::At(point) => failure(&point.failure),
        Refuted::Instance { integers, refuted } => {
            let first = format!("the instance {}", values(integers));
            std::iter::once(first).chain(refutation(refuted)).collect()
        }
        Refuted::Denied { proof, .. } => {
            let first = "the negated statement is proved: it holds everywhere".to_owned();
            std::iter::once(first).chain(self::proof(proof)).collect()
        }
    }
}

/// Says why a domain has no points, or a statement no values.
#[must_use]
pub fn emptiness(empty: &Emptiness<Polynomial>) -> String {
    match empty {
        Emptiness::Range(name) => format!("the declared range of {name} is empty"),
        Emptiness::Constraint { fails, others } => {
            let sign = fails.relation.sign();
            let others = match others {
                true => "on the declared ranges where the other assumptions hold",
                false => "on the declared ranges",
            };
            format!("{} {sign} 0 holds nowhere {others}", fails.value)
        }
        Emptiness::Undefined(term) => term.clone(),
    }
}

fn identity(own: &Identity<Polynomial>) -> Vec<String> {
    let steps: &[&str] = match (own.in_order, own.by) {
        (true, _) => &["both sides are equal identically"],
        (false, Vanishing::NormalForm) => &["both sides have the same normal form"],
        (false, Vanishing::Series) => {
            &["by the recursion both sides reduce to the same expression, for every degree at once"]
        }
    };
    owned(steps)
}

fn combination(own: &Combination<Polynomial>) -> String {
    let step = match own.of {
        Equations::Assumed => "each difference is a multiple of an equation that is assumed",
        Equations::Together => {
            "each difference is a sum of multiples of the equations that are assumed"
        }
        Equations::Given => "the difference is a combination of the given equations",
    };
    step.to_owned()
}

fn zero_by_sign(own: &ZeroBySign<Polynomial>) -> Vec<String> {
    let mut steps: Vec<String> = vec![];
    for entry in &own.entries {
        let step = match entry {
            Zero::Identically => continue,
            Zero::Between(_) => "the difference is neither negative nor positive",
            Zero::Square { .. } => "the square of the difference is not positive",
            Zero::Product { .. } => {
                "the difference, times what is assumed not to vanish, is a combination of the equations that are assumed"
            }
        };
        if !steps.iter().any(|known| known == step) {
            steps.push(step.to_owned());
        }
    }
    steps
}

fn order(own: &Order<Polynomial>) -> Vec<String> {
    if own.of_many {
        return vec!["one coordinate of the difference never vanishes on the domain".to_owned()];
    }
    let certificates = || own.signs.iter().flat_map(Sign::certificates);
    let mut steps = vec![];
    if certificates().any(|certificate| certificate.squares.is_empty()) {
        steps
            .push("all Bernstein coefficients of the difference on the domain have the right sign");
    }
    if certificates().any(|certificate| !certificate.squares.is_empty()) {
        steps.push("sums of squares are not negative");
    }
    if own.signs.iter().any(Sign::uses_series) {
        steps.push("partial sums of their series bound sines, cosines and exponentials");
    }
    if own.signs.iter().any(Sign::uses_derivatives) {
        steps.push("the difference has that sign where its variable is zero, and grows from there by the signs of derivatives");
    }
    if own.signs.iter().any(|sign| !sign.lines().is_empty()) {
        steps.push("the signs between the real roots are those that are asked");
    }
    let uses = own.signs.iter().any(|sign| !sign.constraints().is_empty());
    if uses || own.bounded_by_assumptions {
        steps.push("the assumptions bound the domain");
    }
    let mut steps = owned(&steps);
    let pieces = |sign: &Sign<Polynomial>| sign.certificates().iter().map(|c| c.pieces.len()).sum();
    let pieces = own.signs.iter().map(pieces).max();
    if let Some(pieces) = pieces.filter(|n: &usize| *n > 1) {
        steps.push(format!("on each of the {pieces} parts of the domain"));
    }
    steps
}

fn enclosure(own: &Enclosure<Polynomial>) -> Vec<String> {
    let decimals = counted(own.digits(), "decimal");
    let mut entries = own.entries.iter();
    let is_cut = entries.any(|entry| entry.how == Some(Agreement::CutOff));
    let how = match (own.is_exact(), is_cut) {
        (true, _) => "the printed numbers are exact".to_owned(),
        (false, false) => format!("the printed numbers are the values rounded to {decimals}"),
        (false, true) => {
            format!("the printed numbers are the values cut off (not rounded) after {decimals}")
        }
    };
    vec![format!("the exact values begin {}", own.decimals()), how]
}

fn nonnegative(own: &Nonnegative<Polynomial>) -> Vec<String> {
    let step = |part: &Part<Polynomial>| {
        let what = if part.is_seed { "seed" } else { "step factor" };
        let function = &part.function;
        format!("{what} {function} >= 0 by Bernstein coefficients in the tangent of the half angle")
    };
    let end = "the step keeps nonnegative functions nonnegative: induction over the degree";
    let steps = own.parts.iter().map(step);
    steps.chain([end.to_owned()]).collect()
}

fn wronskians(own: &Wronskians) -> Vec<String> {
    let step = |at: &AtDegree| {
        let front = at.front.cells.len();
        let other = match &at.back {
            Some(back) => format!("{} from the other end", back.cells.len()),
            None => "the other half by symmetry".to_owned(),
        };
        format!(
            "degree {k}: the Wronskians of L[1], L[x], ..., L[x^r], r = 1..{k}, are positive, by their Bernstein \
             coefficients in the shape parameters on {front} cells of x, {other}",
            k = at.degree
        )
    };
    let operator = "a curve is an operator L applied to the Bézier curve of the same control values; positive \
                    Wronskians and the orders at the ends make the functions totally positive, and they sum to one";
    let first = std::iter::once(operator.to_owned());
    first.chain(own.degrees.iter().map(step)).collect()
}

/// The value of a root or an arc; `None` for other symbols.
fn elimination(own: &Elimination<Polynomial>) -> Option<String> {
    let [determined] = own.values.as_slice() else {
        return None;
    };
    let square = match &own.by {
        Determining::Root(_) => "the square is the radicand",
        Determining::RootAlong(_) => "by the equations the square is the radicand",
        Determining::Arc(_) => {
            let (arc, value) = (&determined.symbol, &determined.value);
            return Some(format!(
                "{arc} is {value}: the angle is right, and it lies on the branch of the arc"
            ));
        }
        Determining::Assumed { .. } | Determining::Given { .. } => return None,
    };
    let (root, value) = (&determined.symbol, &determined.value);
    Some(format!(
        "{root} is {value}: {square}, and this is nowhere negative"
    ))
}

fn instance(own: &Instance<Polynomial>) -> String {
    let label = values(&own.integers);
    match &own.proof {
        Proof::Nowhere(empty) => format!("says nothing for {label}: {}", emptiness(empty)),
        _ => format!("holds for {label}"),
    }
}

fn split(own: &Split<Polynomial>) -> Vec<String> {
    let pivot = &own.pivot;
    let zero = match &own.zero {
        ZeroSide::Proved(_) => format!("where {pivot} is zero it holds as well"),
        ZeroSide::Fails(refuted) => format!("where {pivot} is zero it fails: {}", place(refuted)),
    };
    reasons(&own.nonzero).into_iter().chain([zero]).collect()
}

fn sides(own: &Sides<Polynomial>) -> Vec<String> {
    let root = &own.root;
    let cut = format!("the sign of what is in {root} is told apart");
    let (mut steps, below) = (reasons(&own.above), reasons(&own.below));
    let others = below.into_iter().filter(|step| !steps.contains(step));
    let others: Vec<String> = others.collect();
    steps.extend(others);
    std::iter::once(cut).chain(steps).collect()
}

/// Describes what is shown of the range of a parameter.
pub(super) fn range(own: &Sharpness<Polynomial>) -> String {
    match own {
        Sharpness::Fails {
            name, at, others, ..
        } => {
            let others = others.iter();
            let others: String = others
                .map(|(text, value)| format!(", {text} = {value}"))
                .collect();
            format!("the range of {name} cannot be larger: at {name} = {at}{others} it fails")
        }
        Sharpness::Wider { name, to } => {
            format!("the range of {name} may be widened to {to}: it is proved there too")
        }
    }
}

fn failure(own: &Failure<Polynomial>) -> Vec<String> {
    match own {
        Failure::Sides { kind, left, .. } => match kind {
            Comparison::Equation { entry, terms } => {
                let terms = counted(terms, "term");
                let mut steps = vec![format!("the normal form of the difference has {terms}")];
                if left.len() > 1 {
                    steps.push(format!("entry {} differs", entry + 1));
                }
                steps
            }
            Comparison::Order => owned(&["a point of the domain at which the relation fails"]),
            Comparison::Seed => owned(&["a seed is negative somewhere"]),
            Comparison::Domain => owned(&["a point of the domain"]),
        },
        Failure::Printed(enclosure) => {
            let mut steps = owned(&["the value is computed exactly and enclosed"]);
            if enclosure.entries.len() > 1 {
                let differing = enclosure.differing();
                let list: Vec<String> = differing.iter().map(usize::to_string).collect();
                steps.push(match list.as_slice() {
                    [one] => format!("entry {one} differs"),
                    _ => format!("entries {} differ", list.join(", ")),
                });
            }
            steps
        }
        Failure::Dependent { degree, .. } => vec![
            "the coefficients of the functions in normal form are a matrix in the shape parameters"
                .to_owned(),
            format!("at these shape parameters its rows are dependent for degree {degree}"),
        ],
        Failure::Turning { .. } => owned(&[
            "the quotient of two functions rises and falls",
            "so control values with one change of sign give a curve with two: its values at three places are shown",
        ]),
        Failure::Beyond { .. } => owned(&["the functions do not sum to one"]),
    }
}

/// `x = 1, y = 2`.
fn place(refuted: &Refuted<Polynomial>) -> String {
    let values: Vec<String> = refuted.at().iter().map(|value| value.text()).collect();
    values.join(", ")
}

/// Lists values of integers: `i = 1, n = 2`.
pub fn values<'i>(integers: impl IntoIterator<Item = (&'i String, &'i i64)>) -> String {
    let values = integers.into_iter();
    let values: Vec<String> = values.map(|(name, n)| format!("{name} = {n}")).collect();
    values.join(", ")
}

/// A count with its noun, in the plural unless it is 1.
fn counted(count: impl std::fmt::Display, noun: &str) -> String {
    let count = count.to_string();
    match count.as_str() {
        "1" => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}

fn owned(steps: &[&str]) -> Vec<String> {
    steps.iter().map(|step| (*step).to_owned()).collect()
}
