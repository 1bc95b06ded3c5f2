//! What a decision divides by, and which of it is a condition: what neither the hypotheses state nor the domain implies.

use crate::context::ProofContext;
use crate::decide::domain::{Constraint, Domain};
use crate::decide::{self, conditions, sign};
use crate::evaluate::Evaluator;
use crate::evaluate::series::polynomial_of;
use crate::evaluate::value::{Statement, Value};
use crate::roots;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Affine, Finest, Fraction, Polynomial, Symbol};
use torse_certificate::sign::Sign;
use torse_core as core;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Relation;

/// What never vanishes, by its sign: on the declared sets, whatever else is assumed, so that eliminations may rest on it; or
/// under all assumptions.
pub(crate) type Nonzero = (Vec<Sign<Polynomial>>, Vec<Sign<Polynomial>>);

/// The most roots that are taken for positive one after the other.
const MAX_POSITIVE: usize = 6;

/// Those of the factors of divisors that were met, and are no conditions. A radicand whose factors have no sign of their own has
/// one as a whole: `y^2` where `y^2 > 1`.
pub(crate) fn nonzero(
    mut met: Vec<Polynomial>,
    conditions: &[Polynomial],
    domain: &Domain<'_>,
) -> Nonzero {
    // Roots were taken for positive where their radicands are.
    let is_positive = |root: &&decide::root::Root| {
        domain.assumes_nonzero(&Polynomial::symbol(root.symbol.clone()))
    };
    let roots = domain.roots.iter().filter(is_positive);
    let found = domain.positive_roots.iter();
    let mut radicands: Vec<Polynomial> = found.map(|(_, radicand)| radicand.clone()).collect();
    radicands.extend(roots.map(|root| root.radicand.numerator().clone()));
    met.extend(radicands.iter().cloned());
    let met = conditions::separated(&met);
    let declared = Domain::new(domain.declarations);
    // That a root is positive follows from the sign of its radicand, which must not rest on it.
    let positive = domain.positive_roots.len().min(MAX_POSITIVE);
    let before = (0..positive).map(|first| domain.with_positive_roots(first));
    let domains: Vec<Domain<'_>> = before.chain([domain.clone()]).collect();
    let by_sign = |polynomial: &Polynomial| {
        let mut numbered = domains.iter().enumerate();
        numbered.find_map(|(behind, domain)| {
            let sign = sign::positive(polynomial, domain);
            let sign = sign.or_else(|| sign::positive_square(polynomial, domain))?;
            Some((behind, sign))
        })
    };
    let (mut signs, mut apart, mut without_sign) = (vec![], vec![], vec![]);
    for divisor in met {
        if conditions.contains(&divisor) {
            continue;
        }
        match sign::positive(&divisor, &declared) {
            Some(sign) => signs.push(sign),
            // A hypothesis says it, or no integers make it zero.
            None if domain.assumes_nonzero(&divisor) => {}
            None => match by_sign(&domain.without_assumed(&divisor)) {
                Some(sign) => apart.push(sign),
                None => without_sign.push(divisor),
            },
        }
    }
    let is_whole = |radicand: &&Polynomial| {
        let mut factors = without_sign.iter();
        factors.any(|factor| radicand.exact_quotient(factor).is_some())
    };
    let whole = radicands.iter().filter(is_whole);
    apart.extend(whole.filter_map(by_sign));
    // The radicand of a root comes before what the root occurs in.
    apart.sort_by_key(|(behind, sign)| {
        let mut last_first = domain.roots.iter().rev();
        let last = last_first.position(|root| sign.polynomial.symbols().contains(&root.symbol));
        (
            *behind,
            last.map_or(0, |behind| domain.roots.len() - behind),
        )
    });
    (signs, apart.into_iter().map(|(_, sign)| sign).collect())
}

/// Everything that the terms of a statement were divided by.
pub(crate) fn divisors(statement: &Statement) -> Vec<Polynomial> {
    let of = |value: &Value| -> Vec<Polynomial> {
        let entries = value.entries().into_iter();
        entries.flat_map(|q| q.conditions()).collect()
    };
    let mut all = match statement {
        Statement::Compare { left, right, .. } => [of(left), of(right)].concat(),
        Statement::Agrees { values, .. } => {
            let recorded = values.iter().flat_map(Fraction::conditions);
            recorded.cloned().collect()
        }
        Statement::Family { .. } => vec![],
        Statement::Join(_, a, b) => [divisors(a), divisors(b)].concat(),
        Statement::Not(inner) => divisors(inner),
    };
    all.sort();
    all.dedup();
    all
}

/// That the indices of all members of families in a statement are in their ranges, where these name integers.
pub(crate) fn index_ranges(
    statement: &Statement,
    claim: &core::Claim,
    evaluator: &Evaluator<'_>,
) -> Vec<Constraint> {
    let mut found = vec![];
    let sides = decide::comparisons(statement).into_iter();
    for value in sides.flat_map(|(left, right)| [left, right]) {
        let entries = value.entries().into_iter();
        let symbols = entries.filter_map(|q| Some(q.as_fraction()?.symbols()));
        for symbol in symbols.flatten() {
            let Symbol::Indexed(name, index) = &symbol else {
                continue;
            };
            let Some(SymbolKind::Family { ranges, .. }) = claim.symbols.get(name) else {
                continue;
            };
            for (index, ends) in index.iter().zip(ranges) {
                found.extend(within(index, ends, evaluator));
            }
        }
    }
    found
}

/// The same of a statement as it is written, before equations give values to members.
pub(crate) fn written_ranges(
    statement: &core::Statement,
    evaluator: &Evaluator<'_>,
) -> Vec<Constraint> {
    let (mut found, mut seen) = (vec![], BTreeSet::new());
    let mut open = statement.terms();
    while let Some(term) = open.pop() {
        if !seen.insert(Arc::as_ptr(&term.node).addr()) {
            continue;
        }
        if let core::Node::Member(points, indices) = &*term.node {
            for (index, ends) in indices.iter().zip(&points.ranges) {
                // An index that depends on a binder has its range from there.
                if let Some(index) = evaluator.integer_form(index) {
                    found.extend(within(&index, ends, evaluator));
                }
            }
        }
        open.extend(term.parts());
    }
    found
}

/// That an index lies between the ends of its range, as far as the fixed integers leave that open.
fn within(
    index: &Affine,
    (least, most): &(Affine, Affine),
    evaluator: &Evaluator<'_>,
) -> Vec<Constraint> {
    let gaps = [index.clone() - least.clone(), most.clone() - index.clone()];
    let gaps = gaps.map(|gap| evaluator.affine_fixed(&gap));
    let open = gaps
        .iter()
        .filter(|gap| gap.as_number().is_none_or(|n| n < 0));
    let constraint = |gap| Constraint {
        value: polynomial_of(gap).into(),
        relation: Relation::AtLeast,
    };
    open.map(constraint).collect()
}

/// Whether a condition is a factor of a divisor.
pub(crate) fn divides(condition: &Polynomial, divisor: &Polynomial) -> bool {
    condition == divisor
        || condition.len() < divisor.len() && divisor.exact_quotient(condition).is_some()
}

/// The divisors, factor by factor, with radicands for roots, which vanish where these do.
pub(crate) fn unrooted(divisors: &[Polynomial], ground: &ProofContext<'_>) -> Vec<Polynomial> {
    let roots = &ground.branch.domain.roots;
    let plain: Vec<Polynomial> = divisors.iter().map(|p| roots::unrooted(p, roots)).collect();
    conditions::separated(&plain)
}

/// The factors of divisors that were evaluated apart, with one angle in each.
pub(crate) fn in_finest_parts(divisors: &[Polynomial]) -> Vec<Polynomial> {
    let symbols = divisors.iter().flat_map(Polynomial::symbols);
    let finest = Finest::new(symbols);
    let written = divisors
        .iter()
        .map(|p| p.substituted(|symbol| finest.value(symbol)));
    conditions::separated(&written.collect::<Vec<_>>())
}

/// Whether the hypotheses, or the values that equations give to symbols, say that a factor of a divisor is not zero.
pub(crate) fn never_zero(p: &Polynomial, ground: &ProofContext<'_>) -> bool {
    let domain = &ground.branch.domain;
    domain.pivots().iter().any(|pivot| divides(p, pivot))
        || domain.assumes_nonzero(p)
        || sign::never_zero(&domain.without_assumed(p), domain)
        || roots::norm(p, &domain.roots).is_some_and(|norm| domain.assumes_nonzero(&norm))
}

/// The conditions, factor by factor, that neither the hypotheses state nor the domain implies: divisors of the statement, and
/// those of eliminations, of which what they made of the claim says nothing.
pub(crate) fn open_conditions(
    mut conditions: Vec<Polynomial>,
    ground: &ProofContext<'_>,
) -> Vec<Polynomial> {
    conditions.retain(|p| !never_zero(p, ground));
    conditions.extend(ground.branch.splits().iter().cloned());
    conditions.retain(|_| !injected(InjectedFault::ConditionDropped));
    conditions.sort();
    conditions.dedup();
    conditions
}
