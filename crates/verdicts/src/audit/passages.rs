//! The formulas in the words of a correction, cut out as they stand.
//!
//! A sentence is cut at its words, at semicolons, and at the commas outside brackets; what is left and has a sign or a
//! script is a formula. The words that belong to formulas (`sum`, `sin`, `alpha`) cut nothing.

use torse_syntax::formula::Relation;
use torse_syntax::greek;

/// Words of formulas.
const OF_FORMULAS: [&str; 9] = [
    "sum", "binom", "sqrt", "sin", "cos", "tan", "det", "pi", "max",
];

/// A text with round brackets around the coordinates that it has in angles, and nothing else changed.
pub(super) fn with_round_brackets(text: &str) -> String {
    let mut letters: Vec<char> = text.chars().collect();
    let opens: Vec<usize> = (0..letters.len())
        .filter(|at| {
            let before = letters.get(..*at).unwrap_or_default();
            let mut before = before.iter().rev().filter(|c| !c.is_whitespace());
            letters.get(*at) == Some(&'<') && before.next() == Some(&'=')
        })
        .collect();
    for open in opens {
        let close = letters.iter().skip(open).position(|c| *c == '>');
        if let Some(close) = close {
            for (at, sign) in [(open, '('), (open + close, ')')] {
                letters.splice(at..=at, [sign]);
            }
        }
    }
    letters.into_iter().collect()
}

/// Returns the formulas in a text, in their order.
pub(super) fn passages(text: &str) -> Vec<&str> {
    let mut found = vec![];
    let mut from = 0;
    let mut depth = 0_usize;
    let mut at = 0;
    while let Some(rest) = text.get(at..)
        && let Some(next) = rest.chars().next()
    {
        let script = text.get(..at).is_some_and(is_script);
        if is_latin(next) {
            let word = rest.split(|c: char| !is_latin(c)).next().unwrap_or(rest);
            // `2xy` is a product.
            let factor = text
                .get(..at)
                .is_some_and(|before| before.ends_with(|c: char| c.is_ascii_digit()));
            if is_word(word) && !script && !factor {
                found.extend(text.get(from..at));
                (from, depth) = (at + word.len(), 0);
            }
            at += word.len();
            continue;
        }
        match next {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ';' | ',' if depth == 0 => {
                found.extend(text.get(from..at));
                from = at + 1;
            }
            _ => {}
        }
        at += next.len_utf8();
    }
    found.extend(text.get(from..));
    found
        .into_iter()
        .map(bare)
        .filter(|text| says_something(text))
        .collect()
}

/// Whether what follows is a script: `T_cylinder`.
fn is_script(before: &str) -> bool {
    before.ends_with('_') || before.ends_with("_{") || before.ends_with('^')
}

/// Whether a letter is one of words, and no Greek one.
fn is_latin(letter: char) -> bool {
    letter.is_alphabetic() && greek::by_sign(letter).is_none() && letter != 'π'
}

/// Whether letters side by side are a word of a sentence, and no product of letters: `aa` and `dV` are products.
fn is_word(letters: &str) -> bool {
    let known = OF_FORMULAS.contains(&letters) || greek::by_name(&letters.to_lowercase()).is_some();
    let mut capitals = letters.chars().map(char::is_uppercase);
    let product = capitals.next() == Some(false) && capitals.any(|capital| capital);
    let repeats = letters.chars().all(|c| letters.starts_with(c));
    letters.chars().count() > 1 && !known && !product && !repeats
}

/// The text without blanks, stops and brackets without partners around it.
fn bare(text: &str) -> &str {
    let mut text = text.trim();
    loop {
        let less =
            text.trim_matches(|c: char| c.is_whitespace() || ".:/-–".contains(c) && c != '-');
        let less = less.trim_end_matches(['-', '=']).trim();
        let (mut depth, mut unopened, mut first_open) = (0_usize, None, None);
        for (at, c) in less.char_indices() {
            match c {
                '(' | '[' | '{' => {
                    if depth == 0 {
                        first_open = Some(at);
                    }
                    depth += 1;
                }
                ')' | ']' | '}' if depth == 0 => unopened = unopened.or(Some(at)),
                ')' | ']' | '}' => depth -= 1,
                _ => {}
            }
        }
        let less = match (unopened, first_open.filter(|_| depth > 0)) {
            (Some(at), _) if at + 1 == less.len() => less.get(..at),
            (_, Some(0)) => less.get(1..),
            (_, Some(at)) if at + 1 == less.len() => less.get(..at),
            _ => Some(less),
        };
        let less = less.unwrap_or_default().trim();
        if less == text {
            return text;
        }
        text = less;
    }
}

/// Whether a stretch is a formula: the number of an equation and a letter alone are none.
fn says_something(text: &str) -> bool {
    let signed = text.contains(|c: char| "=<>≤≥≠∈+*^×−√_-∂".contains(c));
    let product = text.chars().filter(|c| c.is_alphabetic()).count() > 1;
    signed || product
}

/// Whether a formula has a relation or an operation: a name with its scripts and places has none.
pub fn is_formula(passage: &str) -> bool {
    passage.contains(|c: char| "=<>≤≥≠∈+*^×−√-/²³".contains(c)) || passage.contains("sum")
}

/// The sides of a formula, and the relations between them: none of the signs of relations for one that is not read.
pub(super) fn sides(passage: &str) -> (Vec<&str>, Vec<Option<Relation>>) {
    let (mut sides, mut relations) = (vec![], vec![]);
    let (mut from, mut depth) = (0, 0_usize);
    let mut at = 0;
    while let Some(rest) = passage.get(at..)
        && let Some(next) = rest.chars().next()
    {
        match next {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        let sign = RELATIONS.iter().find(|(sign, _)| rest.starts_with(sign));
        match sign.filter(|_| depth == 0) {
            Some((sign, relation)) => {
                sides.extend(passage.get(from..at).map(str::trim));
                relations.push(*relation);
                at += sign.len();
                from = at;
            }
            None => at += next.len_utf8(),
        }
    }
    sides.extend(passage.get(from..).map(str::trim));
    (sides, relations)
}

/// The parts of a text between these signs outside brackets.
pub(super) fn split_outside_brackets<'t>(text: &'t str, signs: &str) -> Vec<&'t str> {
    let mut depth = 0_usize;
    let splits = |c: char| {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && signs.contains(c)
    };
    text.split(splits).collect()
}

/// The signs of relations; a longer one comes before its beginning.
const RELATIONS: [(&str, Option<Relation>); 11] = [
    ("!=", Some(Relation::Different)),
    ("<=", Some(Relation::AtMost)),
    (">=", Some(Relation::AtLeast)),
    ("=", Some(Relation::Equal)),
    ("<", Some(Relation::Less)),
    (">", Some(Relation::Greater)),
    ("≤", Some(Relation::AtMost)),
    ("≥", Some(Relation::AtLeast)),
    ("≠", Some(Relation::Different)),
    ("∈", None),
    ("≈", None),
];

/// A text as it is compared with another: without blanks, and with one form of each sign.
pub(super) fn plain(text: &str) -> String {
    let signs = text.chars().filter(|c| !c.is_whitespace());
    signs
        .map(|c| if c == '−' || c == '–' { '-' } else { c })
        .collect()
}
