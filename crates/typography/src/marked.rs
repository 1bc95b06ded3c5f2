//! Marks the differences of two versions of a sentence, box by box: for corrections in the notation of the paper rather
//! than that of the files.
//!
//! Words are compared one by one, formulas box by box, with a longest common subsequence kept. Only differences are
//! marked: the letter of an index without its base, the inside of a bracket. Words are marked in bold, boxes by a
//! frame.

use crate::difference::common;
use crate::letters::is_function;
use crate::markup;
use crate::math_box::{Fence, MathBox, MathChange};
use crate::prose::{Stretch, quoted};
use crate::write::text;
use crate::{Mathematics, PrintedNames, Prose, Span};

/// Longer sentences, and formulas of more boxes, are not compared.
const MAX_TOKENS: usize = 2_000;

/// Marks the differences of a sentence as printed and as corrected, in both.
pub fn compared(printed: &str, reads: &str, names: &PrintedNames) -> [Prose; 2] {
    let (old, new) = (atoms(printed, names), atoms(reads, names));
    if old.len().max(new.len()) > MAX_TOKENS {
        return [prose(&old), prose(&new)];
    }
    let (mut shown_old, mut shown_new) = (vec![], vec![]);
    let (mut i, mut j) = (0, 0);
    for (next_i, next_j) in common(&old, &new, |a, b| a.is(b)) {
        gap(
            slice(&old, i, next_i),
            slice(&new, j, next_j),
            &mut shown_old,
            &mut shown_new,
        );
        shown_old.extend(old.get(next_i).cloned());
        shown_new.extend(new.get(next_j).cloned());
        (i, j) = (next_i + 1, next_j + 1);
    }
    gap(
        slice(&old, i, old.len()),
        slice(&new, j, new.len()),
        &mut shown_old,
        &mut shown_new,
    );
    [prose(&shown_old), prose(&shown_new)]
}

/// A word or a formula, with the blanks after it.
#[derive(Clone)]
struct Atom {
    inner: Stretch,
    behind: String,
}

impl Atom {
    fn is(&self, other: &Self) -> bool {
        self.inner == other.inner
    }

    fn marked(&self, mark: MathChange) -> Self {
        let inner = match &self.inner {
            Stretch::Words(word) if word.chars().any(char::is_alphanumeric) => {
                Stretch::Strong(word.clone())
            }
            // A bold comma looks like any other.
            Stretch::Words(_) | Stretch::Strong(_) | Stretch::Code(_) => return self.clone(),
            Stretch::Math(node) => Stretch::Math(whole(mark, node)),
        };
        Atom {
            inner,
            behind: self.behind.clone(),
        }
    }
}

fn slice<T>(list: &[T], from: usize, to: usize) -> &[T] {
    list.get(from..to).unwrap_or_default()
}

/// Whether a quotation is a single formula without words other than letters, names of functions, and words in scripts.
fn is_formula(text: &str) -> bool {
    if text.contains(['$', '`', '…']) || text.contains("...") {
        return false;
    }
    let known = |word: &str| {
        // d V for a vector V
        let product = word.len() == 2 && word.ends_with(|c: char| c.is_ascii_uppercase());
        product || is_function(word) || matches!(word, "sum" | "binom" | "det" | "sqrt")
    };
    let mut rest = text;
    let mut before = ' ';
    while let Some(first) = rest.chars().next() {
        let letters = |c: char| c.is_ascii_alphabetic();
        let end = match letters(first) {
            true => rest.find(|c| !letters(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (word, after) = rest.split_at_checked(end).unwrap_or((rest, ""));
        let script = matches!(before, '_' | '^' | '{');
        if word.len() > 1 && letters(first) && !script && !known(word) {
            return false;
        }
        (before, rest) = (first, after);
    }
    true
}

fn atoms(text: &str, names: &PrintedNames) -> Vec<Atom> {
    if is_formula(text) {
        return vec![Atom {
            inner: Stretch::Math(names.with_vectors(markup::boxes(text))),
            behind: String::new(),
        }];
    }
    let mut list: Vec<Atom> = vec![];
    for stretch in quoted(text, names) {
        let Stretch::Words(words) = &stretch else {
            list.push(Atom {
                inner: stretch,
                behind: String::new(),
            });
            continue;
        };
        let mut rest = words.as_str();
        while !rest.is_empty() {
            let blank = rest.len() - rest.trim_start().len();
            if blank > 0 {
                let (blanks, after) = rest.split_at(blank);
                match list.last_mut() {
                    Some(last) => last.behind.push_str(blanks),
                    None => list.push(Atom {
                        inner: Stretch::Words(String::new()),
                        behind: blanks.to_owned(),
                    }),
                }
                rest = after;
                continue;
            }
            let (inner, after) = match interval(rest) {
                Some(end) => {
                    let (stretch, after) = rest.split_at_checked(end).unwrap_or((rest, ""));
                    (Stretch::Math(markup::boxes(stretch)), after)
                }
                None => {
                    let (word, after) = first_word(rest);
                    (Stretch::Words(word.to_owned()), after)
                }
            };
            list.push(Atom {
                inner,
                behind: String::new(),
            });
            rest = after;
        }
    }
    enumerated(list)
}

/// Words that end with a point within a sentence.
const ABBREVIATIONS: [&str; 6] = ["Sect.", "Sects.", "Fig.", "Figs.", "Eq.", "Eqs."];

/// The first word of a text, or a sign before or behind it: the word may be unchanged where they change.
fn first_word(text: &str) -> (&str, &str) {
    let punctuation = |c: char| matches!(c, ',' | ';' | '.' | ':');
    let blank = text.find(char::is_whitespace).unwrap_or(text.len());
    let word = text.get(..blank).unwrap_or(text);
    let end = match text.starts_with(punctuation) {
        true if text.starts_with("...") => 3,
        true => 1,
        false if word.starts_with('(') && !word.contains(')') => 1,
        false if ABBREVIATIONS.contains(&word) => word.len(),
        false => {
            let word = word.trim_end_matches(punctuation);
            let closed = match word.contains('(') {
                true => word,
                false => word.trim_end_matches(')'),
            };
            closed.len().max(1)
        }
    };
    text.split_at_checked(end).unwrap_or((text, ""))
}

/// Where an interval between two numbers ends with which a text begins: `[−1, 1]`.
fn interval(text: &str) -> Option<usize> {
    let (inner, _) = text.strip_prefix('[')?.split_once(']')?;
    let is_number = |end: &str| {
        let digits = end.trim().trim_start_matches(['-', '−', '–']);
        digits.starts_with(|c: char| c.is_ascii_digit()) && digits.parse::<f64>().is_ok()
    };
    let (from, to) = inner.split_once(',')?;
    (is_number(from) && is_number(to)).then_some(inner.len() + 2)
}

/// The list with each enumeration, `i = 0, 1, ..., k`, as one formula.
fn enumerated(list: Vec<Atom>) -> Vec<Atom> {
    let mut made: Vec<Atom> = vec![];
    let mut rest = list.as_slice();
    while let Some((first, after)) = rest.split_first() {
        rest = after;
        let mut atom = first.clone();
        if let Stretch::Math(MathBox::Row(nodes)) = &first.inner
            && matches!(
                nodes.as_slice(),
                [.., MathBox::Sign('='), MathBox::Number(_)]
            )
        {
            let mut nodes = nodes.clone();
            while let Some((entry, behind)) = entry(rest, &nodes) {
                nodes.extend([MathBox::Sign(','), entry]);
                atom.behind = behind;
                rest = slice(rest, 2, rest.len());
            }
            atom.inner = Stretch::Math(MathBox::Row(nodes));
        }
        made.push(atom);
    }
    made
}

/// The next entry of an enumeration, and the blanks behind it: a number, dots, or the last entry behind dots.
fn entry(rest: &[Atom], before: &[MathBox]) -> Option<(MathBox, String)> {
    let [comma, next, ..] = rest else {
        return None;
    };
    let is_comma = matches!(&comma.inner, Stretch::Words(word) if word == ",");
    let dots = MathBox::Sign('…');
    let node = match &next.inner {
        Stretch::Words(word) if word == "..." => Some(dots),
        Stretch::Words(word) if word.chars().all(|c| c.is_ascii_digit()) => {
            Some(MathBox::Number(word.clone()))
        }
        Stretch::Math(node) if before.last() == Some(&dots) => Some(node.clone()),
        _ => None,
    };
    node.filter(|_| is_comma)
        .map(|node| (node, next.behind.clone()))
}

/// Whether a formula is a range: an interval, or an enumeration. Half a range is no change that a reader can see.
fn is_range(node: &MathBox) -> bool {
    let has_comma = |nodes: &[MathBox]| nodes.contains(&MathBox::Sign(','));
    match node {
        MathBox::Fenced(Fence::Square, inner) => {
            matches!(&**inner, MathBox::Row(nodes) if has_comma(nodes) && size(inner) <= 5)
        }
        MathBox::Row(nodes) => {
            let simple = |node: &MathBox| match node {
                MathBox::Letter(..) | MathBox::Number(_) => true,
                MathBox::Sign(sign) => matches!(sign, ',' | '…' | '=' | '+' | '−'),
                MathBox::Row(nodes) => !has_comma(nodes),
                _ => false,
            };
            let relations = nodes.iter().filter(|node| **node == MathBox::Sign('='));
            has_comma(nodes) && relations.count() == 1 && nodes.iter().all(simple)
        }
        _ => false,
    }
}

/// Compares the parts between two common atoms: formulas with formulas, one by one.
fn gap(old: &[Atom], new: &[Atom], shown_old: &mut Vec<Atom>, shown_new: &mut Vec<Atom>) {
    let formulas = |list: &[Atom]| -> Vec<MathBox> {
        let nodes = list.iter().filter_map(|atom| match &atom.inner {
            Stretch::Math(node) => Some(node.clone()),
            _ => None,
        });
        nodes.collect()
    };
    let (a, b) = (formulas(old), formulas(new));
    let pairs: Vec<Pair> = a.iter().zip(&b).map(|(a, b)| compare(a, b)).collect();
    let show = |list: &[Atom], mark: MathChange, of: fn(&Pair) -> &MathBox| -> Vec<Atom> {
        let mut pairs = pairs.iter();
        let shown = list.iter().map(|atom| match &atom.inner {
            Stretch::Math(_) => match pairs.next() {
                Some(pair) => Atom {
                    inner: Stretch::Math(of(pair).clone()),
                    behind: atom.behind.clone(),
                },
                None => atom.marked(mark),
            },
            _ => atom.marked(mark),
        });
        shown.collect()
    };
    shown_old.extend(show(old, MathChange::Removed, |pair| &pair.old));
    shown_new.extend(show(new, MathChange::Added, |pair| &pair.new));
}

fn prose(atoms: &[Atom]) -> Prose {
    let mut list: Prose = vec![];
    for atom in atoms {
        let (words, span) = match &atom.inner {
            Stretch::Words(word) => (word.as_str(), None),
            Stretch::Strong(word) => {
                strong(&mut list, word);
                ("", None)
            }
            Stretch::Code(code) => ("", Some(Span::Code(code.clone()))),
            Stretch::Math(node) => ("", Some(Span::Math(Mathematics::inline(node)))),
        };
        list.extend(span);
        let words = format!("{words}{}", atom.behind);
        match list.last_mut() {
            _ if words.is_empty() => {}
            Some(Span::Words(last)) => last.push_str(&words),
            _ => list.push(Span::Words(words)),
        }
    }
    list
}

/// Adds a marked word; neighbouring marked words get one mark.
fn strong(list: &mut Prose, word: &str) {
    if let [.., Span::Strong(last), Span::Words(blank)] = list.as_mut_slice()
        && blank.trim().is_empty()
    {
        last.push_str(blank);
        last.push_str(word);
        list.pop();
        return;
    }
    list.push(Span::Strong(word.to_owned()));
}

/// Larger formulas are never marked as a whole.
const SMALL: usize = 60;

/// Two boxes with marks, and how many boxes are marked.
struct Pair {
    old: MathBox,
    new: MathBox,
    marked: usize,
}

/// A frame cannot be broken over lines: wider formulas are framed term by term.
const WIDE: usize = 24;

fn whole(mark: MathChange, node: &MathBox) -> MathBox {
    let framed = |node: MathBox| MathBox::Marked(mark, Box::new(node));
    let MathBox::Row(nodes) = node else {
        return framed(node.clone());
    };
    if size(node) <= WIDE {
        return framed(node.clone());
    }
    let (mut terms, mut term) = (vec![], vec![]);
    for node in nodes {
        if matches!(node, MathBox::Sign('=' | '+' | '−')) && !term.is_empty() {
            terms.extend(framed_term(mark, std::mem::take(&mut term)));
            terms.push(framed(node.clone()));
        } else {
            term.push(node.clone());
        }
    }
    terms.extend(framed_term(mark, term));
    MathBox::row(terms)
}

/// Maximum length of a term in one frame, in letters: a frame is no wider than half a line.
const MAX_FRAMED_TERM: usize = 50;

/// A term in one frame, or, where that would be longer than a line, what is in its brackets term by term and the rest in frames
/// between them.
fn framed_term(mark: MathChange, term: Vec<MathBox>) -> Vec<MathBox> {
    let framed = |nodes: Vec<MathBox>| MathBox::Marked(mark, Box::new(MathBox::row(nodes)));
    let is_long = |node: &MathBox| text(node).chars().count() > MAX_FRAMED_TERM;
    if term.is_empty() {
        return vec![];
    }
    if !is_long(&MathBox::row(term.iter().cloned())) {
        return vec![framed(term)];
    }
    let (mut pieces, mut piece) = (vec![], vec![]);
    for node in term {
        match node {
            MathBox::Fenced(fence, inner) if size(&inner) > WIDE => {
                if !piece.is_empty() {
                    pieces.push(framed(std::mem::take(&mut piece)));
                }
                pieces.push(MathBox::Fenced(fence, Box::new(whole(mark, &inner))));
            }
            node => piece.push(node),
        }
    }
    if !piece.is_empty() {
        pieces.push(framed(piece));
    }
    pieces
}

fn replaced(old: &MathBox, new: &MathBox) -> Pair {
    Pair {
        old: whole(MathChange::Removed, old),
        new: whole(MathChange::Added, new),
        marked: size(old) + size(new),
    }
}

fn compare(old: &MathBox, new: &MathBox) -> Pair {
    if old == new {
        return Pair {
            old: old.clone(),
            new: new.clone(),
            marked: 0,
        };
    }
    if is_range(old) && is_range(new) {
        return replaced(old, new);
    }
    let pair = parts(old, new).unwrap_or_else(|| replaced(old, new));
    let all = size(old) + size(new);
    // A formula with marks everywhere is unreadable.
    match pair.marked * 4 > all * 3 && all < SMALL && !matches!(old, MathBox::Scripts { .. }) {
        true => replaced(old, new),
        false => pair,
    }
}

fn parts(old: &MathBox, new: &MathBox) -> Option<Pair> {
    let one = |a: &MathBox, b: &MathBox, make: &dyn Fn(Box<MathBox>) -> MathBox| {
        let pair = compare(a, b);
        Pair {
            old: make(Box::new(pair.old)),
            new: make(Box::new(pair.new)),
            marked: pair.marked,
        }
    };
    let two = |[a, b]: [&MathBox; 2],
               [c, d]: [&MathBox; 2],
               make: fn(Box<MathBox>, Box<MathBox>) -> MathBox| {
        let (first, second) = (compare(a, c), compare(b, d));
        Pair {
            old: make(Box::new(first.old), Box::new(second.old)),
            new: make(Box::new(first.new), Box::new(second.new)),
            marked: first.marked + second.marked,
        }
    };
    Some(match (old, new) {
        (MathBox::Row(a), MathBox::Row(b)) => rows(a, b),
        (MathBox::Row(a), _) => rows(a, std::slice::from_ref(new)),
        (_, MathBox::Row(b)) => rows(std::slice::from_ref(old), b),
        (MathBox::Fenced(f, a), MathBox::Fenced(g, b)) if f == g => {
            one(a, b, &|inner| MathBox::Fenced(*f, inner))
        }
        (MathBox::Root(a), MathBox::Root(b)) => one(a, b, &MathBox::Root),
        (MathBox::Accent(s, a), MathBox::Accent(t, b)) if s == t => {
            one(a, b, &|inner| MathBox::Accent(*s, inner))
        }
        (MathBox::Fraction(a, b), MathBox::Fraction(c, d)) => {
            two([a, b], [c, d], MathBox::Fraction)
        }
        (MathBox::Binomial(a, b), MathBox::Binomial(c, d)) => {
            two([a, b], [c, d], MathBox::Binomial)
        }
        (
            MathBox::Scripts {
                base,
                primes,
                below,
                above,
            },
            MathBox::Scripts {
                base: other,
                primes: count,
                below: under,
                above: over,
            },
        ) if primes == count => {
            let base = compare(base, other);
            let below = script(below.as_deref(), under.as_deref())?;
            let above = script(above.as_deref(), over.as_deref())?;
            let marked = base.marked + below.marked + above.marked;
            let made =
                |base: MathBox, below: Option<MathBox>, above: Option<MathBox>| MathBox::Scripts {
                    base: Box::new(base),
                    primes: *primes,
                    below: below.map(Box::new),
                    above: above.map(Box::new),
                };
            Pair {
                old: made(base.old, below.old, above.old),
                new: made(base.new, below.new, above.new),
                marked,
            }
        }
        (
            MathBox::Sum { below, above },
            MathBox::Sum {
                below: under,
                above: over,
            },
        ) => {
            let below = compare(below, under);
            let above = script(above.as_deref(), over.as_deref())?;
            let made = |below: MathBox, above: Option<MathBox>| MathBox::Sum {
                below: Box::new(below),
                above: above.map(Box::new),
            };
            Pair {
                marked: below.marked + above.marked,
                old: made(below.old, above.old),
                new: made(below.new, above.new),
            }
        }
        _ => return None,
    })
}

/// Two scripts, each of which may be missing.
struct ScriptPair {
    old: Option<MathBox>,
    new: Option<MathBox>,
    marked: usize,
}

/// None if only one is there: then the whole box differs.
fn script(old: Option<&MathBox>, new: Option<&MathBox>) -> Option<ScriptPair> {
    match (old, new) {
        (None, None) => Some(ScriptPair {
            old: None,
            new: None,
            marked: 0,
        }),
        (Some(old), Some(new)) => {
            let pair = compare(old, new);
            Some(ScriptPair {
                old: Some(pair.old),
                new: Some(pair.new),
                marked: pair.marked,
            })
        }
        _ => None,
    }
}

fn rows(old: &[MathBox], new: &[MathBox]) -> Pair {
    if old.len().max(new.len()) > MAX_TOKENS {
        return replaced(&MathBox::Row(old.to_vec()), &MathBox::Row(new.to_vec()));
    }
    let (a, b) = (terms(old), terms(new));
    if a.len() != b.len() && a.len().min(b.len()) > 1 {
        return sums(&a, &b);
    }
    // With few boxes, such as indices, each is compared with the one in its place.
    const FEW: usize = 4;
    let (mut shown_old, mut shown_new, mut marked) = (vec![], vec![], 0);
    let mut between = |a: &[MathBox], b: &[MathBox]| match a.len() == b.len() {
        true => {
            for (a, b) in a.iter().zip(b) {
                let pair = compare(a, b);
                marked += pair.marked;
                shown_old.push(pair.old);
                shown_new.push(pair.new);
            }
        }
        false => {
            // The insides of two brackets are compared, wherever the rest ends.
            let fenced = |(a, b): &(&MathBox, &MathBox)| matches!((a, b), (MathBox::Fenced(f, _), MathBox::Fenced(g, _)) if f == g);
            let mut paired = 0;
            for (a, b) in a.iter().zip(b).take_while(fenced) {
                let pair = compare(a, b);
                marked += pair.marked;
                shown_old.push(pair.old);
                shown_new.push(pair.new);
                paired += 1;
            }
            let (a, b) = (slice(a, paired, a.len()), slice(b, paired, b.len()));
            for (list, shown, mark) in [
                (a, &mut shown_old, MathChange::Removed),
                (b, &mut shown_new, MathChange::Added),
            ] {
                if !list.is_empty() {
                    marked += list.iter().map(size).sum::<usize>();
                    shown.push(whole(mark, &MathBox::row(list.iter().cloned())));
                }
            }
        }
    };
    let (mut i, mut j) = (0, 0);
    let in_place = old.len() == new.len() && old.len() < FEW;
    let kept = match in_place {
        true => vec![],
        false => common(old, new, |a, b| a == b),
    };
    for (next_i, next_j) in kept {
        between(slice(old, i, next_i), slice(new, j, next_j));
        (i, j) = (next_i + 1, next_j + 1);
        // Common parts go to both unchanged.
        if let Some(node) = old.get(next_i) {
            between(std::slice::from_ref(node), std::slice::from_ref(node));
        }
    }
    between(slice(old, i, old.len()), slice(new, j, new.len()));
    Pair {
        old: MathBox::row(shown_old),
        new: MathBox::row(shown_new),
        marked,
    }
}

/// The terms of a sum, each with its sign; a sign of equality is a term of its own, and so is what follows a comma before
/// another equation.
fn terms(nodes: &[MathBox]) -> Vec<MathBox> {
    let (mut terms, mut term): (Vec<MathBox>, Vec<MathBox>) = (vec![], vec![]);
    let is_equality = |node: &MathBox| matches!(node, MathBox::Sign('='));
    let last_equality = nodes.iter().rposition(is_equality);
    for (place, node) in nodes.iter().enumerate() {
        let begins = match (term.last(), node) {
            (None, _) => false,
            (Some(MathBox::Sign('=')), _) => true,
            (Some(MathBox::Sign(_)), MathBox::Sign('+' | '−')) => false,
            (_, MathBox::Sign('+' | '−' | '=')) => true,
            (_, MathBox::Sign(',')) => last_equality.is_some_and(|last| place < last),
            _ => false,
        };
        if begins {
            terms.push(MathBox::row(term.drain(..)));
        }
        term.push(node.clone());
    }
    if !term.is_empty() {
        terms.push(MathBox::row(term));
    }
    terms
}

/// Compares sums of different length term by term: a term that only one has is framed as a whole.
fn sums(old: &[MathBox], new: &[MathBox]) -> Pair {
    let (mut shown_old, mut shown_new, mut marked) = (vec![], vec![], 0);
    let mut between = |a: &[MathBox], b: &[MathBox]| {
        if a.len() == b.len() {
            for (a, b) in a.iter().zip(b) {
                let pair = compare(a, b);
                marked += pair.marked;
                shown_old.push(pair.old);
                shown_new.push(pair.new);
            }
            return;
        }
        // Long terms that have more in common than not are compared, wherever the others end.
        const LONG: usize = 24;
        let mut paired = 0;
        for (a, b) in a.iter().zip(b) {
            let pair = compare(a, b);
            let all = size(a) + size(b);
            if all < LONG || 2 * pair.marked > all {
                break;
            }
            marked += pair.marked;
            shown_old.push(pair.old);
            shown_new.push(pair.new);
            paired += 1;
        }
        let (a, b) = (slice(a, paired, a.len()), slice(b, paired, b.len()));
        for (list, others, shown, mark) in [
            (a, b, &mut shown_old, MathChange::Removed),
            (b, a, &mut shown_new, MathChange::Added),
        ] {
            marked += list.iter().map(size).sum::<usize>();
            shown.extend(framed_terms(mark, list, others));
        }
    };
    let (mut i, mut j) = (0, 0);
    for (next_i, next_j) in common(old, new, |a, b| a == b) {
        between(slice(old, i, next_i), slice(new, j, next_j));
        between(
            slice(old, next_i, next_i + 1),
            slice(new, next_j, next_j + 1),
        );
        (i, j) = (next_i + 1, next_j + 1);
    }
    between(slice(old, i, old.len()), slice(new, j, new.len()));
    Pair {
        old: MathBox::row(shown_old),
        new: MathBox::row(shown_new),
        marked,
    }
}

/// The boxes of a row; any other box alone.
fn nodes(term: &MathBox) -> &[MathBox] {
    match term {
        MathBox::Row(nodes) => nodes,
        one => std::slice::from_ref(one),
    }
}

/// The sign with which a term begins, and what is behind it.
fn signed(term: &MathBox) -> Option<(&MathBox, &[MathBox])> {
    match nodes(term) {
        [sign @ MathBox::Sign('+' | '−'), rest @ ..] if !rest.is_empty() => Some((sign, rest)),
        _ => None,
    }
}

/// Frames each of some terms, and the sign before it in a frame of its own: a frame around a sum would read as a bracket.
/// A sign that the term in the same place of the `others` has, too, has no frame. An equation behind a comma has one.
fn framed_terms(mark: MathChange, terms: &[MathBox], others: &[MathBox]) -> Vec<MathBox> {
    let all = MathBox::row(terms.iter().flat_map(nodes).cloned());
    if let [comma @ MathBox::Sign(','), equation @ ..] = nodes(&all) {
        let equation = MathBox::row(equation.iter().cloned());
        return vec![comma.clone(), whole(mark, &equation)];
    }
    let mut framed = vec![];
    for (place, term) in terms.iter().enumerate() {
        let Some((sign, rest)) = signed(term) else {
            framed.push(whole(mark, term));
            continue;
        };
        let other = others.get(place).and_then(signed);
        framed.push(match other.is_some_and(|(other, _)| other == sign) {
            true => sign.clone(),
            false => MathBox::Marked(mark, Box::new(sign.clone())),
        });
        framed.push(whole(mark, &MathBox::row(rest.iter().cloned())));
    }
    framed
}

/// Counts the visible boxes in a box.
fn size(node: &MathBox) -> usize {
    let of = |inner: &Option<Box<MathBox>>| inner.as_deref().map_or(0, size);
    match node {
        MathBox::Letter(..) | MathBox::Function(_) | MathBox::Number(_) | MathBox::Sign(_) => 1,
        MathBox::Gap => 0,
        MathBox::Row(nodes) => nodes.iter().map(size).sum(),
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => size(base) + primes + of(below) + of(above),
        MathBox::Accent(_, inner) | MathBox::Root(inner) | MathBox::Marked(_, inner) => {
            1 + size(inner)
        }
        MathBox::Fenced(_, inner) => 2 + size(inner),
        MathBox::Fraction(a, b) | MathBox::Binomial(a, b) => 1 + size(a) + size(b),
        MathBox::Matrix(_, rows) => rows.iter().flatten().map(size).sum(),
        MathBox::Sum { below, above } => 1 + size(below) + of(above),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both sentences, with marked parts in angle brackets.
    fn shown(printed: &str, reads: &str) -> [String; 2] {
        compared(printed, reads, &PrintedNames::default()).map(|spans| {
            let part = |span: &Span| match span {
                Span::Words(text) | Span::Code(text) => text.clone(),
                Span::Strong(text) => format!("**{text}**"),
                Span::Math(math) => math.latex.clone(),
            };
            spans.iter().map(part).collect()
        })
    }

    #[test]
    fn a_missing_factor_is_marked_alone() {
        let [old, new] = shown("q = c (γ a + λ (k + 1))", "q = c (γ a + 4 λ (k + 1))");
        assert!(!old.contains("boxed"), "{old}");
        assert!(new.contains("\\boxed{4}"), "{new}");
        assert_eq!(new.matches("boxed").count(), 1);
    }

    #[test]
    fn of_an_index_the_letter_is_marked_and_not_its_base() {
        let [old, new] = shown("Q^X_{k,0} and Q^Y_{k,1}", "Q^X_{k,0} and Q^Y_{l,1}");
        assert!(old.contains("_{\\boxed{\\scriptstyle k}, 1}"), "{old}");
        assert!(new.contains("_{\\boxed{\\scriptstyle l}, 1}"), "{new}");
    }

    #[test]
    fn a_changed_sign_is_boxed_and_no_line_lies_on_it() {
        let [old, new] = shown("b = c + d (1 − μ − ν)", "b = c + d (1 + μ − ν)");
        assert_eq!(old.matches("\\mathbin{\\boxed{-}}").count(), 1, "{old}");
        assert_eq!(new.matches("\\mathbin{\\boxed{+}}").count(), 1, "{new}");
    }

    #[test]
    fn a_wide_formula_is_framed_term_by_term() {
        let [_, new] = shown(
            "the conditions are those",
            "the conditions are Q_{1,2} = ρ Q_{k,1} + ρ γ (Q_{k,1} − Q_{k−1,1}) + s Q_{k,1} + t Q_{k,2}",
        );
        assert!(new.matches("boxed").count() > 5, "{new}");
        assert!(new.contains("\\mathbin{\\boxed{+}}"), "{new}");
    }

    #[test]
    fn of_a_term_longer_than_a_line_the_brackets_are_framed_term_by_term() {
        let long = "1/(c_l + π²(1−ν_2)) [ρ γ² (c_k (Q_{k,1} − 2 Q_{k−1,1} + Q_{k−2,1}) − π² (1−μ_1) (Q_{k−1,1} − Q_{k−2,1})) + 4 v (k − 2 + π/2 (1+ν_1)) (Q_{k,1} − Q_{k−1,1}) + 4 u Q_{k,1}]";
        let [_, new] = shown(
            "the condition",
            &format!("the condition Q_{{2,2}} = Q_{{1,2}} + {long}"),
        );
        assert!(new.contains("\\boxed{1 / (c_l"), "{new}");
        assert!(new.contains("\\boxed{4 u Q_{k, 1}}"), "{new}");
    }

    #[test]
    fn the_point_of_an_abbreviation_stays_with_it() {
        let [_, new] = shown("see Figs. 9–10. More", "see Fig. 9. More");
        assert_eq!(new, "see **Fig. 9**. More");
    }

    #[test]
    fn a_range_is_framed_as_a_whole_and_keeps_its_brackets() {
        let [old, new] = shown("in the value range [0, 1]", "in the value range [−1, 1]");
        assert!(old.ends_with("\\boxed{[0, 1]}"), "{old}");
        assert!(new.ends_with("\\boxed{[- 1, 1]}"), "{new}");
        let [old, new] = shown("planes P (i = 1, 2, ..., k)", "planes P (i = 0, 1, ..., k)");
        assert!(old.contains("\\boxed{i = 1, 2, \\ldots, k}"), "{old}");
        assert_eq!(new.matches("boxed").count(), 1, "{new}");
        assert!(!new.contains("**"), "{new}");
    }

    #[test]
    fn of_sums_with_other_terms_whole_terms_are_framed_and_signs_that_stay_are_not() {
        let [old, new] = shown(
            "det(A) = −2176 k^5 + 4336 k^4 − 2160 k^3",
            "det(A) = −16 k^4 + 16 k^3",
        );
        assert!(
            old.ends_with(
                "= - \\boxed{2176 k^5} + \\boxed{4336 k^4} \\mathbin{\\boxed{-}} \\boxed{2160 k^3}"
            ),
            "{old}"
        );
        assert!(
            new.ends_with("= - \\boxed{16 k^4} + \\boxed{16 k^3}"),
            "{new}"
        );
        assert!(new.starts_with("\\det"), "{new}");
    }

    #[test]
    fn in_a_long_bracket_the_changes_are_marked_though_another_term_follows() {
        let [old, new] = shown(
            "Q = P + 1/b [c (P − 3 R) + d (P − 2 R + S) − (1 − μ_1) e (R − S)]",
            "Q = P + 1/b [c (P − 3 R) + d (P − 2 R + S) − (1 − μ) e (R − S)], f = 6 (m − 2)",
        );
        assert!(old.contains("\\boxed{\\mu_1}"), "{old}");
        assert_eq!(old.matches("boxed").count(), 1, "{old}");
        assert!(new.contains("\\boxed{\\mu}"), "{new}");
        assert!(new.ends_with(", \\boxed{f = 6 (m - 2)}"), "{new}");
    }

    #[test]
    fn brackets_dots_and_spelled_letters_of_a_quotation_stay() {
        let [old, _] = shown(
            "the G2 beta joint and k ≠ (135/136) for q − o and k [p − o]",
            "the G2 beta joint",
        );
        assert!(old.contains("G2 beta joint"), "{old}");
        assert!(old.contains("(135 / 136)"), "{old}");
        assert!(old.contains("[p - o]"), "{old}");
    }

    #[test]
    fn words_are_marked_one_by_one() {
        let [old, new] = shown(
            "the starting generator J(0) grows",
            "the ending generator J(1) grows",
        );
        assert!(old.starts_with("the **starting** generator "), "{old}");
        assert!(new.starts_with("the **ending** generator "), "{new}");
        assert!(new.ends_with(" grows"));
    }

    #[test]
    fn what_is_equal_has_no_mark() {
        let [old, new] = shown("a = b, and no more.", "a = b, and no more.");
        assert_eq!(old, new);
        assert!(!old.contains("boxed"));
    }
}
