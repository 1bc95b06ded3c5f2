//! Flags a quotation that does not say the hypothesis that it is given for.
//!
//! The reader of files checks that the words stand in the print. This module checks whether they say the hypothesis,
//! for what can be read off: a bound of a number, and that something is not zero. `0 < u < 1` does not print `0 <= u <=
//! 1`, `m >= 2` says nothing about n, and a slash does not say that the denominator is not zero.

use super::{RaisedFlag, Subject, one_flag_for};
use crate::claim_record::HypothesisSource;
use torse_syntax::formula::{Expr, Node, Relation, parse};
use torse_syntax::greek;
use torse_syntax::notation::text;
use torse_syntax::taxonomy::Flag;

/// Returns the hypotheses whose quotations say something else.
pub(super) fn mismatched_quotations(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let assumed = subject.outcome.claim.assumed.iter();
    let printed = assumed.filter_map(|hypothesis| match &hypothesis.from {
        HypothesisSource::Printed { quote, .. } => Some((&hypothesis.formula.text, quote)),
        _ => None,
    });
    let wrong = printed.filter(|(formula, quote)| !states_hypothesis(quote, formula));
    let list = wrong.map(|(formula, quote)| format!("`{formula}` by “{quote}”"));
    one_flag_for(
        Flag::QuoteSaysOtherwise,
        "the words do not say",
        list.collect(),
    )
}

/// Whether a quotation says a hypothesis, as far as that can be read off.
fn states_hypothesis(quote: &str, formula: &str) -> bool {
    let Ok(expr) = parse(formula) else {
        return true;
    };
    let Node::Compare(first, rest) = &expr.node else {
        return true;
    };
    let mut sides = vec![(**first).clone()];
    sides.extend(rest.iter().map(|(_, side)| side.clone()));
    let signs = signs(quote);
    let mut links = sides.windows(2).zip(rest);
    links.all(|(pair, (relation, _))| match (pair, relation) {
        (_, Relation::Equal) => true,
        (_, Relation::Different) => signs.denied,
        ([a, b], relation) => match (name(a), number(b), number(a), name(b)) {
            (Some(name), Some(bound), ..) => signs.bound(name, &bound, is_strict(*relation)),
            (.., Some(bound), Some(name)) => signs.bound(name, &bound, is_strict(*relation)),
            _ => true,
        },
        _ => true,
    })
}

fn is_strict(relation: Relation) -> bool {
    matches!(relation, Relation::Less | Relation::Greater)
}

fn name(side: &Expr) -> Option<&str> {
    match &side.node {
        Node::Name(name) if name != "pi" => Some(name),
        _ => None,
    }
}

/// Returns a number as a print writes it.
fn number(side: &Expr) -> Option<String> {
    let written = text(side);
    let plain = |c: char| c.is_ascii_digit() || matches!(c, '-' | '/' | '.' | '*');
    let is_number = written.replace("pi", "").chars().all(plain);
    is_number.then(|| written.replace('*', "").replace("pi", "π"))
}

/// The bounds that a quotation states.
struct Signs {
    /// Its letters, digits and signs without blanks.
    plain: String,
    /// Whether it negates something.
    denied: bool,
}

fn signs(quote: &str) -> Signs {
    let denials = [
        "≠",
        "!=",
        " not ",
        "nonzero",
        "except",
        "distinct",
        "different",
        "independent",
        "regular",
    ];
    let mut plain: String = quote.chars().filter(|c| !c.is_whitespace()).collect();
    for (typed, sign) in [("<=", "≤"), (">=", "≥"), ("−", "-"), ("–", "-")] {
        plain = plain.replace(typed, sign);
    }
    Signs {
        plain,
        denied: denials.iter().any(|word| quote.contains(word))
            || quote.contains(['<', '>', '≤', '≥']),
    }
}

impl Signs {
    /// Whether the quotation bounds a name: it has the name, and the number beside a sign that is as strict.
    fn bound(&self, name: &str, bound: &str, strict: bool) -> bool {
        if !self.names(name) {
            return false;
        }
        let beside = |at: usize| {
            let before = self
                .plain
                .get(..at)
                .and_then(|text| text.chars().next_back());
            let behind = self
                .plain
                .get(at + bound.len()..)
                .and_then(|text| text.chars().next());
            let wanted = |c: char| match strict {
                true => matches!(c, '<' | '>'),
                false => matches!(c, '≤' | '≥'),
            };
            let bracket = |open: Option<char>, close: Option<char>| match strict {
                true => matches!(open, Some('(')) || matches!(close, Some(')')),
                false => matches!(open, Some('[')) || matches!(close, Some(']')),
            };
            let listed = matches!(before, Some('=' | ',')) && !strict;
            before.is_some_and(wanted)
                || behind.is_some_and(wanted)
                || bracket(before, behind)
                || listed
        };
        let mut places = self.plain.match_indices(bound).map(|(at, _)| at);
        let near = places.any(beside);
        // Words for a bound, within the declared range of the symbol, and a list 0, 1, ..., m.
        let words = ["positive", "negative", "..."];
        near || words.iter().any(|word| self.plain.contains(word))
    }

    /// Whether the quotation names a symbol: by its letter, with any index.
    fn names(&self, name: &str) -> bool {
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
        let letter = greek::by_name(stem).map_or_else(|| stem.to_owned(), |l| l.sign.to_string());
        self.plain.contains(&letter) || self.plain.contains(stem)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quotation_says_a_bound_with_its_strictness_and_its_name() {
        for (quote, formula, said) in [
            ("u in interval 0 < u < 1", "0 <= u <= 1", false),
            ("u in interval 0 < u < 1", "0 < u < 1", true),
            ("0 ≤ z ≤ 1", "0 <= z <= 1", true),
            ("z, z_1 ∈ [0,1]", "0 <= z1 <= 1", true),
            ("(-1 ≤ μ,ν ≤ 1)", "-1 <= mu1 <= 1", true),
            ("m (m ≥ 2)", "n >= 2", false),
            ("m (m ≥ 2)", "m >= 2", true),
            ("/[(q - o).(a /\\ d)]", "dot(q - o, n) != 0", false),
            ("we elect the value k > 0 and k != 1", "k != 1", true),
            ("k = 0, 1, 2, ..., m", "0 <= k", true),
            ("H_2(0) = H_1(1)", "h2 == h", true),
        ] {
            assert_eq!(
                states_hypothesis(quote, formula),
                said,
                "{quote}: {formula}"
            );
        }
    }
}
