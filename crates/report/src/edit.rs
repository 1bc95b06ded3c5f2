//! What a correction changed, token by token.
//!
//! The statement as understood and the corrected one are compared as sequences of names, numbers and signs.
//! What stands before the first difference and after the last is cut off, and of what lies between a longest
//! common subsequence is kept (the quadratic method; long stretches are shown as replaced altogether).

use serde::Serialize;

/// The largest table of the comparison; a formula of a page stays far below.
const MOST_CELLS: usize = 1_000_000;

/// What happened to a stretch of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// It stayed.
    Kept,
    /// It was taken away.
    Removed,
    /// It is new.
    Added,
}

/// A stretch of a formula in the notation of the derivation files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Stretch {
    /// What happened to it.
    pub change: Change,
    /// The stretch.
    pub text: String,
}

/// The stretches that lead from the formula `before` to the formula `after`.
///
/// Those that stayed or are new make up `after`, those that stayed or were taken away `before`, up to blanks.
pub(crate) fn stretches<'a>(before: &'a str, after: &'a str) -> Vec<Stretch> {
    let (old, new) = (tokens(before), tokens(after));
    let same = |(a, b): &(&&'a str, &&'a str)| a.trim_end() == b.trim_end();
    let front = old.iter().zip(&new).take_while(same).count();
    let rest = old.len().min(new.len()) - front;
    let back = (old.iter().rev().zip(new.iter().rev()).take(rest))
        .take_while(same)
        .count();
    let between = |tokens: &[&'a str]| -> Vec<&'a str> {
        let count = tokens.len() - front - back;
        tokens.iter().skip(front).take(count).copied().collect()
    };
    let (start, rest) = new.split_at(front);
    let (_, end) = rest.split_at(rest.len() - back);
    let mut list = List::default();
    list.extend(Change::Kept, start);
    middle(&between(&old), &between(&new), &mut list);
    list.extend(Change::Kept, end);
    list.0
}

/// Stretches of tokens; neighbours of one kind are one.
#[derive(Default)]
struct List(Vec<Stretch>);

impl List {
    fn extend(&mut self, change: Change, tokens: &[&str]) {
        let text = tokens.concat();
        match self.0.last_mut() {
            _ if text.is_empty() => {}
            Some(last) if last.change == change => last.text.push_str(&text),
            _ => self.0.push(Stretch { change, text }),
        }
    }
}

/// A longest common subsequence is kept.
fn middle(old: &[&str], new: &[&str], list: &mut List) {
    let width = new.len() + 1;
    if old.len().saturating_add(1).saturating_mul(width) > MOST_CELLS {
        list.extend(Change::Removed, old);
        list.extend(Change::Added, new);
        return;
    }
    // lengths[i * width + j] is the length of a longest common subsequence of old[i..] and new[j..].
    let mut lengths = vec![0_usize; (old.len() + 1) * width];
    let at = |lengths: &[usize], i: usize, j: usize| lengths.get(i * width + j).copied();
    for (i, a) in old.iter().enumerate().rev() {
        for (j, b) in new.iter().enumerate().rev() {
            let length = if a.trim_end() == b.trim_end() {
                at(&lengths, i + 1, j + 1).map(|length| length + 1)
            } else {
                at(&lengths, i + 1, j).max(at(&lengths, i, j + 1))
            };
            if let Some(cell) = lengths.get_mut(i * width + j) {
                *cell = length.unwrap_or(0);
            }
        }
    }
    let (mut i, mut j) = (0, 0);
    loop {
        match (old.get(i), new.get(j)) {
            (Some(a), Some(b)) if a.trim_end() == b.trim_end() => {
                list.extend(Change::Kept, &[b]);
                (i, j) = (i + 1, j + 1);
            }
            (Some(a), _) if at(&lengths, i + 1, j) >= at(&lengths, i, j + 1) || j == new.len() => {
                list.extend(Change::Removed, &[a]);
                i += 1;
            }
            (_, Some(b)) => {
                list.extend(Change::Added, &[b]);
                j += 1;
            }
            (Some(a), None) => {
                list.extend(Change::Removed, &[a]);
                i += 1;
            }
            (None, None) => return,
        }
    }
}

/// Names, numbers and single signs, each with the blanks after it.
fn tokens(formula: &str) -> Vec<&str> {
    let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '°');
    let mut tokens = Vec::new();
    let mut rest = formula;
    while let Some(first) = rest.chars().next() {
        let body = match word(first) {
            true => rest.find(|c| !word(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let after = rest.get(body..).unwrap_or_default();
        let blanks = after.len() - after.trim_start().len();
        let (token, next) = rest.split_at(body + blanks);
        tokens.push(token);
        rest = next;
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stretches with `-removed-` and `+added+` marked.
    fn shown(before: &str, after: &str) -> String {
        let mark = |stretch: &Stretch| match stretch.change {
            Change::Kept => stretch.text.clone(),
            Change::Removed => format!("<-{}>", stretch.text),
            Change::Added => format!("<+{}>", stretch.text),
        };
        stretches(before, after).iter().map(mark).collect()
    }

    #[test]
    fn a_replaced_name_an_added_factor_and_a_dropped_bracket_are_marked() {
        assert_eq!(shown("a2*a0' - x", "a2*a3' - x"), "a2*<-a0' ><+a3' >- x");
        assert_eq!(shown("pi^2*q", "4*pi^2*q"), "<+4*>pi^2*q");
        assert_eq!(shown("1 + f(x)", "1 + x"), "1 + <-f(>x<-)>");
        assert_eq!(
            shown("sin(x)^2 + sin(y)", "x^2 + y"),
            "<-sin(>x<-)>^2 + <-sin(>y<-)>"
        );
    }

    #[test]
    fn equal_formulas_are_kept_and_blanks_do_not_count() {
        assert_eq!(shown("a+b", "a + b"), "a + b");
        assert_eq!(shown("", ""), "");
        assert_eq!(shown("a", ""), "<-a>");
    }

    #[test]
    fn what_stayed_and_what_is_new_make_up_the_new_formula() {
        let pairs = [
            ("k*(mu + nu)^2 - R[i]", "l*(mu - nu)^3*R[i+1]"),
            ("x = [1, 2; 3]", "x = [2, 1]"),
            ("∂π", "π∂'"),
        ];
        for (before, after) in pairs {
            let side = |left_out: Change| -> String {
                let stretches = stretches(before, after);
                let kept = stretches
                    .iter()
                    .filter(|stretch| stretch.change != left_out);
                kept.flat_map(|stretch| stretch.text.chars())
                    .filter(|c| *c != ' ')
                    .collect()
            };
            assert_eq!(side(Change::Removed), after.replace(' ', ""));
            assert_eq!(side(Change::Added), before.replace(' ', ""));
        }
    }

    #[test]
    fn formulas_too_long_to_compare_are_replaced_altogether() {
        let (old, new) = ("a+".repeat(2000), "b-".repeat(2000));
        let changes: Vec<Change> = stretches(&old, &new).iter().map(|s| s.change).collect();
        assert_eq!(changes, [Change::Removed, Change::Added]);
    }
}
