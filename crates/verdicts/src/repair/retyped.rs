//! Slips of the pen, which change the text and so the structure of a formula: one operator in the place of another,
//! brackets that were left out, put in, or end elsewhere, and a factor or a term that was written twice.

use super::edit::{Change, Edit, parts, placed, text};
use std::collections::BTreeSet;
use torse_syntax::formula::{Expr, Node, Operator, parse};

/// The most tokens of a formula that is retyped.
const MAX_TOKENS: usize = 80;
/// The operators that are taken for one another.
const OPERATORS: [&str; 4] = ["+", "-", "*", "/"];

/// All formulas with one such slip undone.
#[must_use]
pub fn edits(expr: &Expr) -> Vec<Edit> {
    let written = text(expr);
    let tokens = tokens(&written);
    if tokens.len() > MAX_TOKENS {
        return vec![];
    }
    let mut seen = BTreeSet::from([written.clone()]);
    let mut found = vec![];
    let retyped = operators(&tokens).into_iter().chain(brackets(&tokens));
    for (tokens, change) in retyped {
        let Ok(expr) = parse(&tokens.join(" ")) else {
            continue;
        };
        if seen.insert(text(&expr)) && !has_idle_one(&expr) {
            let change = Change::new("", []).at(&change);
            found.push(Edit { expr, change });
        }
    }
    let mut others = structural(expr);
    others.retain(|edit| seen.insert(text(&edit.expr)));
    found.extend(others);
    found
}

/// An operator between operands that are kept, and what was written twice.
fn structural(expr: &Expr) -> Vec<Edit> {
    let mut found = vec![];
    for (path, part) in parts(expr) {
        let Node::Binary(operator, a, b) = &part.node else {
            continue;
        };
        let repeated = match (&a.node, operator) {
            (_, Operator::Multiply | Operator::Add) if text(a) == text(b) => Some(b),
            (Node::Binary(inner, _, last), Operator::Multiply | Operator::Add) => {
                (inner == operator && text(last) == text(b)).then_some(b)
            }
            _ => None,
        };
        if let Some(repeated) = repeated {
            found.push(Edit {
                expr: placed(expr, &path, Expr::clone(a)),
                change: Change::new("the second _ left out", [repeated]),
            });
        }
        let others = match operator {
            Operator::Add | Operator::Subtract => [Operator::Multiply, Operator::Divide],
            Operator::Multiply | Operator::Divide => [Operator::Add, Operator::Subtract],
            Operator::Power => continue,
        };
        for other in others {
            let by = Expr::clone(a).with(other, Expr::clone(b));
            found.push(Edit {
                change: Change::replaced(part, &by),
                expr: placed(expr, &path, by),
            });
        }
    }
    found.retain(|edit| !has_idle_one(&edit.expr));
    found
}

/// Whether something is multiplied or divided by one.
pub(super) fn has_idle_one(expr: &Expr) -> bool {
    let is_one = |expr: &Expr| text(expr) == "1";
    parts(expr).into_iter().any(|(_, part)| match &part.node {
        Node::Binary(Operator::Multiply, a, b) => is_one(a) || is_one(b),
        Node::Binary(Operator::Divide, _, b) => is_one(b),
        _ => false,
    })
}

/// Names and numbers, and each other sign by itself.
fn tokens(written: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || "_'.".contains(c);
    let mut found = vec![];
    let mut rest = written.trim_start();
    while let Some(first) = rest.chars().next() {
        let end = match is_word(first) {
            true => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (token, behind) = rest.split_at(end);
        found.push(token);
        rest = behind.trim_start();
    }
    found
}

/// Whether an operand ends with this token, so that an operator behind it has two.
fn ends_operand(token: &str) -> bool {
    !matches!(token, "(" | "[" | "," | "+" | "-" | "*" | "/" | "^")
}

/// The tokens after a change, and the change in words.
type Retyped<'t> = (Vec<&'t str>, String);

/// One operator between two operands replaced by another.
fn operators<'t>(tokens: &[&'t str]) -> Vec<Retyped<'t>> {
    let mut found = vec![];
    for (place, pair) in tokens.windows(2).enumerate() {
        let [before, operator] = pair else { continue };
        if !ends_operand(before) || !OPERATORS.contains(operator) {
            continue;
        }
        for other in OPERATORS.into_iter().filter(|other| other != operator) {
            let mut changed = tokens.to_vec();
            if let Some(slot) = changed.get_mut(place + 1) {
                *slot = other;
            }
            found.push((changed, format!("`{operator}` replaced by `{other}`")));
        }
    }
    found
}

/// One pair of brackets less, more, or with another end.
fn brackets<'t>(tokens: &[&'t str]) -> Vec<Retyped<'t>> {
    let mut found = added(tokens, "brackets put around");
    for (open, close) in pairs(tokens) {
        let within = tokens.get(open + 1..close).unwrap_or_default().join(" ");
        let kept = tokens.iter().enumerate();
        let kept = kept.filter(|(place, _)| *place != open && *place != close);
        let without: Vec<&str> = kept.map(|(_, token)| *token).collect();
        // With another end: the pair that is taken away and the one that is put in share one.
        for (changed, change) in added(&without, "brackets around") {
            let same_open = changed.get(open) == Some(&"(");
            let same_close = changed.get(close) == Some(&")");
            if same_open || same_close {
                found.push((changed, format!("{change}, not around `{within}`")));
            }
        }
        found.push((without, format!("brackets around `{within}` left out")));
    }
    found
}

/// The brackets that are not those of a call, each with its partner.
fn pairs(tokens: &[&str]) -> Vec<(usize, usize)> {
    let (mut open, mut found) = (vec![], vec![]);
    let mut before = "(";
    for (place, token) in tokens.iter().enumerate() {
        match *token {
            "(" => open.push((place, ends_operand(before))),
            ")" => {
                if let Some((start, false)) = open.pop() {
                    found.push((start, place));
                }
            }
            _ => {}
        }
        before = token;
    }
    found
}

/// One pair of brackets put around operands with a sum or a difference at their level.
fn added<'t>(tokens: &[&'t str], words: &str) -> Vec<Retyped<'t>> {
    let mut found = vec![];
    let starts = |place: usize| {
        let before = place.checked_sub(1).and_then(|before| tokens.get(before));
        before.is_none_or(|token| !ends_operand(token))
    };
    for start in (0..tokens.len()).filter(|place| starts(*place)) {
        let (mut depth, mut is_sum, mut before) = (0_usize, false, "(");
        for (end, token) in tokens.iter().enumerate().skip(start) {
            match *token {
                "(" | "[" => depth += 1,
                ")" | "]" => match depth.checked_sub(1) {
                    Some(outer) => depth = outer,
                    None => break,
                },
                "," if depth == 0 => break,
                "+" | "-" if depth == 0 && ends_operand(before) => is_sum = true,
                _ => {}
            }
            before = token;
            let is_whole = (start, end + 1) == (0, tokens.len());
            let calls = matches!(tokens.get(end + 1), Some(&("(" | "[")));
            if depth == 0 && is_sum && ends_operand(token) && !calls && !is_whole {
                let (left, rest) = tokens.split_at(start);
                let (inside, right) = rest.split_at(end + 1 - start);
                let changed = [left, &["("], inside, &[")"], right].concat();
                found.push((changed, format!("{words} `{}`", inside.join(" "))));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn retyped(formula: &str) -> Vec<String> {
        let all = edits(&parse(formula).unwrap());
        all.iter().map(|edit| text(&edit.expr)).collect()
    }

    #[test]
    fn one_operator_is_replaced_by_another() {
        let all = retyped("a^2 + 2*a + b + b^2");
        for expected in ["a^2 + 2*a*b + b^2", "a^2 + 2/a + b + b^2"] {
            assert!(all.contains(&expected.to_owned()), "{expected} in {all:?}");
        }
        assert!(!retyped("-a").contains(&"+a".to_owned()));
    }

    #[test]
    fn what_was_written_twice_is_left_out() {
        for (printed, meant) in [
            ("1 + 2*t*t*(1 - t)", "1 + 2*t*(1 - t)"),
            ("2*2*a", "2*a"),
            ("a + b + b", "a + b"),
            ("(a + b) + (a - b)", "(a + b)*(a - b)"),
        ] {
            let all = retyped(printed);
            assert!(all.contains(&meant.to_owned()), "{meant} in {all:?}");
        }
        assert!(!retyped("n - 1").contains(&"n*1".to_owned()));
    }

    #[test]
    fn brackets_are_put_in_left_out_and_ended_elsewhere() {
        for (printed, meant) in [
            ("a + b*(a - b)", "(a + b)*(a - b)"),
            ("(x - y)*(x^2 + x*y) + y^2", "(x - y)*(x^2 + x*y + y^2)"),
            ("(n*n + 1)/2", "n*(n + 1)/2"),
            ("a*(b + c)*(a + b)", "a*(b + c*(a + b))"),
            ("1/(x + 1)*y", "1/((x + 1)*y)"),
            ("sum(i, 0, n, a + b*i)", "sum(i, 0, n, (a + b)*i)"),
        ] {
            let all = retyped(printed);
            let found = all.contains(&meant.to_owned());
            assert_eq!(found, meant != "1/((x + 1)*y)", "{meant} in {all:?}");
        }
    }

    #[test]
    fn the_brackets_of_a_call_stay() {
        let all = retyped("f(a + b)*c");
        assert!(all.iter().all(|text| text.starts_with("f(")), "{all:?}");
    }
}
