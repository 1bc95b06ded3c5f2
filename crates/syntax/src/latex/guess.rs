//! What undeclared letters stand for, concluded from where they stand in the formulas of one text.
//!
//! | the letter | is taken for |
//! |---|---|
//! | before brackets that hold single letters or numbers alone, and nowhere without brackets | a function: `f(t)`, `X(u, v)` |
//! | on the left of `=` in such a form | a function, defined there |
//! | in an exponent, an index, a bound, beside a number (`n - 1`, `2n`), or beside `<` and `\in` | a number |
//! | with indices, of which one is the index of a sum, of a range, or a formula such as `i + 1` | a family; bold with a superscript: with one index more |
//! | with indices 0, 1, ... or 1, 2, ... on the left sides of definitions, `f_0(t) = ...`, and with a letter for an index elsewhere | a basis with these functions |
//! | listed as members, `P_0, \dots, P_n` | a family |
//! | with indices that are numbers or words alone | one name for each: `a_0`, `d_{max}` |
//! | bold or under an arrow | a vector |
//! | before other brackets, without one of these signs | a number or a function: two readings |
//! | `e` | as `base` says |
//! | anything else | a number |

use super::base::{BaseLetter, BaseUses, is_letter_e};
use super::item::{Nucleus, TexFace, TexItem, nucleus_signature};
use super::names::{LatexKind, LatexNames, parts, script_words, spelled};
use std::collections::{BTreeMap, BTreeSet};

/// Collects the letters of formulas.
#[derive(Debug, Clone, Default)]
pub struct LatexGuess {
    uses: BTreeMap<String, Uses>,
    /// Letters that are indices of sums or of ranges.
    indices: BTreeSet<String>,
    /// How the letter e stands.
    base: BaseUses,
}

/// How a letter with one subscript, or with subscripts that are indices, is used.
#[derive(Debug, Clone)]
struct Uses {
    item: TexItem,
    /// The subscripts.
    below: Vec<Vec<TexItem>>,
    /// Whether a superscript is no number.
    raised: bool,
    /// The arguments in brackets of letters and numbers; the letters of the first one with letters alone.
    called: bool,
    arguments: Vec<Vec<Option<String>>>,
    /// Scripts and arguments of a left side that defines it.
    defined: Option<Vec<String>>,
    /// The functions that left sides define: their numbers and, where a second script is one, their degrees.
    listed: BTreeSet<(u8, Option<u8>)>,
    /// Whether the text lists its members.
    is_family: bool,
    /// The variable of the functions that are defined one by one.
    variable: Option<String>,
    /// Before other brackets.
    before_brackets: bool,
    bare: bool,
    is_number: bool,
}

impl LatexGuess {
    /// Adds the letters of a formula.
    pub fn add(&mut self, items: &[TexItem]) {
        self.indices_of(items);
        self.left_side(items);
        self.walk(items, false, None);
    }

    fn indices_of(&mut self, items: &[TexItem]) {
        let dots = items
            .iter()
            .any(|item| matches!(item.nucleus, Nucleus::Dots));
        for (at, item) in items.iter().enumerate() {
            if let (Nucleus::Big(kind), Some(below)) = (&item.nucleus, &item.below)
                && kind != "int"
            {
                let end = below
                    .iter()
                    .position(|sign| sign.is_sign("="))
                    .unwrap_or(below.len());
                self.indices
                    .extend(below.iter().take(end).filter_map(letter));
            }
            // i = 0, ..., n
            if dots
                && items.get(at + 1).is_some_and(|next| next.is_sign("="))
                && (at == 0
                    || items.get(at - 1).is_some_and(|before| {
                        before.is_sign(",")
                            || before.is_sign("quad")
                            || matches!(before.nucleus, Nucleus::Words(_))
                    }))
            {
                self.indices.extend(letter(item));
            }
            if let (Nucleus::Letter(..), Some(below)) = (&item.nucleus, &item.below) {
                for part in parts(below) {
                    if let [index, sign, ..] = part
                        && (sign.is_sign("+") || sign.is_sign("-"))
                    {
                        self.indices.extend(letter(index));
                    }
                }
            }
            for list in item.lists() {
                self.indices_of(list);
            }
        }
    }

    /// Notes `f(t) = ...`, `B_i^n(t) = ...`, `b_0(t) = ...`.
    fn left_side(&mut self, items: &[TexItem]) {
        let mut start = 0;
        for (at, item) in items.iter().enumerate() {
            if item.is_sign(",") || item.is_sign("quad") || item.is_sign(";") {
                start = at + 1;
            }
            let is_equal = item.is_sign("=") || item.is_sign(":=") || item.is_sign("equiv");
            if !is_equal {
                continue;
            }
            let Some([head, brackets]) = items.get(start..at) else {
                continue;
            };
            let (Nucleus::Letter(..), Nucleus::Fenced('(', inner, ')')) =
                (&head.nucleus, &brackets.nucleus)
            else {
                continue;
            };
            if !brackets.is_bare() || head.primes > 0 {
                continue;
            }
            let scripts = head.below.as_deref().map(parts).unwrap_or_default();
            let above = head.above.as_deref();
            let arguments: Option<Vec<String>> = parts(inner).into_iter().map(lone).collect();
            let Some(arguments) = arguments else { continue };
            let number = |script: &[TexItem]| match script {
                [only] => match &only.nucleus {
                    Nucleus::Number(digits) if only.is_bare() => digits.parse::<u8>().ok(),
                    _ => None,
                },
                _ => None,
            };
            let numbers: Option<Vec<u8>> =
                scripts.iter().copied().chain(above).map(number).collect();
            let listed = match numbers.as_deref() {
                Some([index]) if above.is_none() => Some((*index, None)),
                Some([index, degree]) => Some((*index, Some(*degree))),
                _ => None,
            };
            let scripts: Option<Vec<String>> = scripts.into_iter().chain(above).map(lone).collect();
            let uses = self.uses(head);
            uses.called = true;
            if let Some(listed) = listed {
                if let [variable] = arguments.as_slice() {
                    uses.listed.insert(listed);
                    uses.variable.get_or_insert_with(|| variable.clone());
                }
                uses.arguments
                    .push(arguments.into_iter().map(Some).collect());
            } else if let Some(scripts) = scripts {
                let all: Vec<String> = scripts.into_iter().chain(arguments).collect();
                let distinct: BTreeSet<&String> = all.iter().collect();
                if distinct.len() == all.len() && uses.defined.is_none() {
                    uses.defined = Some(all);
                }
            }
        }
    }

    /// Takes a letter for a family, whose members the text lists; scripts of `letter` do not matter.
    pub fn add_family(&mut self, letter: &TexItem) {
        if matches!(letter.nucleus, Nucleus::Letter(..)) {
            self.uses(letter).is_family = true;
        }
    }

    fn uses(&mut self, item: &TexItem) -> &mut Uses {
        let key = nucleus_signature(&item.nucleus);
        self.uses.entry(key).or_insert_with(|| Uses {
            item: TexItem {
                below: None,
                above: None,
                primes: 0,
                ..item.clone()
            },
            below: vec![],
            raised: false,
            called: false,
            arguments: vec![],
            defined: None,
            listed: BTreeSet::new(),
            is_family: false,
            variable: None,
            before_brackets: false,
            bare: false,
            is_number: false,
        })
    }

    /// Notes the letters of a list; `before` is the letter in whose brackets the list stands.
    fn walk(&mut self, items: &[TexItem], in_script: bool, before: Option<&str>) {
        for (at, item) in items.iter().enumerate() {
            let (previous, next) = (
                at.checked_sub(1).and_then(|at| items.get(at)),
                items.get(at + 1),
            );
            let own = nucleus_signature(&item.nucleus);
            if is_letter_e(item) {
                self.base.add(item, previous, next);
            }
            if is_letter_e(item) && item.above.is_some() {
                // Brackets behind a power are a factor, and the letter is as `base` says.
                self.uses(item).raised = true;
            } else if matches!(item.nucleus, Nucleus::Letter(..)) {
                let beside_number = {
                    let is_number = |item: Option<&TexItem>| {
                        item.is_some_and(|item| matches!(item.nucleus, Nucleus::Number(_)))
                    };
                    let is_sign = |item: Option<&TexItem>, signs: &[&str]| {
                        item.is_some_and(|item| signs.iter().any(|sign| item.is_sign(sign)))
                    };
                    let terms = ["+", "-"];
                    let orders = ["<", ">", "le", "ge", "in"];
                    is_number(previous)
                        || is_sign(next, &terms) && is_number(items.get(at + 2))
                        || is_sign(previous, &terms)
                            && is_number(at.checked_sub(2).and_then(|at| items.get(at)))
                        || is_sign(next, &orders)
                        || is_sign(previous, &orders)
                };
                let uses = self.uses(item);
                uses.below.extend(item.below.clone());
                let number = |list: &Vec<TexItem>| {
                    matches!(
                        list.as_slice(),
                        [TexItem {
                            nucleus: Nucleus::Number(_),
                            ..
                        }]
                    )
                };
                uses.raised |= item.above.as_ref().is_some_and(|above| !number(above));
                match next.map(|next| &next.nucleus) {
                    Some(Nucleus::Fenced('(', inner, ')')) => {
                        let all = parts(inner);
                        let simple = all.iter().all(|part| lone(part).is_some() || matches!(part, [one] if matches!(one.nucleus, Nucleus::Number(_)) && one.is_bare()));
                        if simple && !inner.is_empty() || all.len() > 1 {
                            uses.called = true;
                            uses.arguments.push(all.into_iter().map(lone).collect());
                        } else {
                            uses.before_brackets = true;
                        }
                    }
                    _ => {
                        uses.bare |= item.primes == 0;
                        uses.is_number |=
                            in_script || beside_number || before == Some(own.as_str());
                    }
                }
            }
            let inside = match (&item.nucleus, previous.map(|previous| &previous.nucleus)) {
                (Nucleus::Fenced(..), Some(nucleus @ Nucleus::Letter(..))) => {
                    Some(nucleus_signature(nucleus))
                }
                _ => None,
            };
            let scripts = [item.below.as_deref(), item.above.as_deref()];
            for list in item.lists() {
                let in_script = scripts
                    .iter()
                    .flatten()
                    .any(|script| std::ptr::eq(*script, list));
                self.walk(list, in_script, inside.as_deref().filter(|_| !in_script));
            }
        }
    }

    /// The names with their kinds.
    #[must_use]
    pub fn names(&self) -> LatexNames {
        let mut names = LatexNames::default();
        for uses in self.uses.values() {
            self.declare(&mut names, uses);
        }
        names
    }

    fn declare(&self, names: &mut LatexNames, uses: &Uses) {
        let Nucleus::Letter(letters, face) = &uses.item.nucleus else {
            return;
        };
        let is_bold = match face {
            TexFace::Bold => true,
            TexFace::Accent(_, inner) => **inner == TexFace::Bold,
            _ => false,
        };
        let plain = TexItem {
            nucleus: Nucleus::Letter(letters.clone(), TexFace::Plain),
            ..uses.item.clone()
        };
        let has_plain = is_bold
            && *face == TexFace::Bold
            && self.uses.contains_key(&nucleus_signature(&plain.nucleus));
        let shown = printed(letters, face);
        let name = match spelled(&uses.item) {
            Ok((name, _)) if !has_plain => name,
            Ok((name, _)) => format!("{name}_vector"),
            Err(_) => match face {
                TexFace::Other(face) if *face == "mathbb" && letters == "R" => return,
                TexFace::Other(face) => format!("{letters}_{}", face.trim_start_matches("math")),
                _ => return,
            },
        };
        if matches!(letters.as_str(), "pi" | "d") && *face == TexFace::Plain && !uses.called {
            // The number, and the sign of differentials.
            return;
        }
        let words = uses.below.iter().map(|below| script_words(&parts(below)));
        let is_index = |below: &Vec<TexItem>| {
            below
                .iter()
                .any(|item| letter(item).is_some_and(|letter| self.indices.contains(&letter)))
                || script_words(&parts(below)).is_none()
        };
        let has_index = uses.is_family || uses.below.iter().any(is_index);
        if let (Some(basis), false) = (uses.basis(), is_bold)
            && (has_index || uses.defined.is_some())
        {
            names.declare(&name, basis);
        } else if let Some(parameters) = &uses.defined {
            // Functions with scripts for parameters, or with none.
            names.declare(
                &name,
                LatexKind::Function {
                    parameters: parameters.clone(),
                    is_vector: is_bold,
                },
            );
        } else if has_index {
            if uses.called {
                // Of its parameters only the number is known.
                let scripts = uses
                    .below
                    .iter()
                    .map(|below| parts(below).len())
                    .max()
                    .unwrap_or(1);
                let arguments = uses.arguments.first().map_or(1, Vec::len);
                let count = scripts + usize::from(uses.raised) + arguments;
                names.declare(
                    &name,
                    LatexKind::Function {
                        parameters: vec![String::new(); count],
                        is_vector: is_bold,
                    },
                );
            } else if !uses.raised || is_bold {
                let two = |below: &Vec<TexItem>| match parts(below).as_slice() {
                    [one] if one.len() == 2 && one.iter().all(|item| letter(item).is_some()) => 2,
                    all => all.len(),
                };
                let mut indices = uses.below.iter().map(two).max().unwrap_or(1);
                indices += usize::from(is_bold && uses.raised);
                names.declare(
                    &name,
                    LatexKind::Family {
                        indices,
                        is_vector: is_bold,
                    },
                );
            }
        } else {
            for word in words.flatten().collect::<BTreeSet<_>>() {
                names.declare(&format!("{name}_{}", word.join("_")), single(uses, is_bold));
            }
            let kind = match self.base.letter() {
                _ if name != "e" || is_bold || uses.called => Some(single(uses, is_bold)),
                BaseLetter::Base => None,
                BaseLetter::Open => Some(LatexKind::NumberOrBase),
                BaseLetter::Number => Some(single(uses, is_bold)),
            };
            if let Some(kind) = kind.filter(|_| uses.below.is_empty() || uses.bare) {
                names.declare(&name, kind);
            }
        }
        let by_rule = matches!(face, TexFace::Plain | TexFace::Bold)
            || matches!(face, TexFace::Other(face) if face == "mathrm");
        if !by_rule || has_plain {
            names.display(&name, &shown);
        }
    }
}

impl Uses {
    /// The basis whose functions left sides define, if they define all from 0 or from 1 on.
    fn basis(&self) -> Option<LatexKind> {
        let numbers: Vec<u8> = self.listed.iter().map(|(number, _)| *number).collect();
        let last = *numbers.last()?;
        let first = *numbers.first()?;
        let all = first <= 1 && last > 0 && (first..=last).eq(numbers.iter().copied());
        // Another degree than that of the last function makes it no list of functions.
        let is_list = self
            .listed
            .iter()
            .all(|(_, degree)| degree.is_none_or(|degree| degree == last));
        let scripts = if self.listed.iter().any(|(_, degree)| degree.is_some()) {
            2
        } else {
            1
        };
        // A formula for all indices and degrees says more than the list.
        let is_general = self
            .defined
            .as_ref()
            .is_some_and(|parameters| parameters.len() != 2);
        if !all || !is_list || scripts == 2 && is_general {
            return None;
        }
        Some(LatexKind::Basis {
            degree: Some(last),
            variable: self.variable.clone()?,
        })
    }
}

/// The kind of a name without indices.
fn single(uses: &Uses, is_bold: bool) -> LatexKind {
    let letters = uses
        .arguments
        .iter()
        .find(|arguments| arguments.iter().all(Option::is_some));
    let count = uses.arguments.first().map_or(1, Vec::len);
    let function = || {
        let first =
            letters.map(|arguments| arguments.iter().flatten().cloned().collect::<Vec<_>>());
        let distinct = first.filter(|all| all.iter().collect::<BTreeSet<_>>().len() == all.len());
        // Parameters without names, where no call shows them.
        let parameters = distinct.unwrap_or_else(|| vec![String::new(); count]);
        LatexKind::Function {
            parameters,
            is_vector: is_bold,
        }
    };
    match (uses.called, is_bold) {
        (true, true) => function(),
        (true, false) if !uses.bare => function(),
        (true, false) => LatexKind::Open,
        (false, true) if uses.before_brackets => LatexKind::Open,
        (false, true) => LatexKind::Vector,
        (false, false) if uses.before_brackets && !uses.is_number => LatexKind::Open,
        (false, false) => LatexKind::Number,
    }
}

fn letter(item: &TexItem) -> Option<String> {
    match &item.nucleus {
        Nucleus::Letter(letters, TexFace::Plain) => Some(letters.clone()),
        _ => None,
    }
}

fn lone(list: &[TexItem]) -> Option<String> {
    match list {
        [only] if only.is_bare() => letter(only),
        _ => None,
    }
}

/// A letter in its face, as LaTeX.
fn printed(letters: &str, face: &TexFace) -> String {
    let letter = match crate::greek::by_name(letters) {
        Some(letter) => format!("\\{}", letter.latex),
        None => letters.to_owned(),
    };
    match face {
        TexFace::Plain => letter,
        TexFace::Bold => format!("\\mathbf{{{letter}}}"),
        TexFace::Other(name) => format!("\\{name}{{{letter}}}"),
        TexFace::Accent(name, inner) => format!("\\{name}{{{}}}", printed(letters, inner)),
    }
}
