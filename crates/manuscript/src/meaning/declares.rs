//! Declarations of formulas, read with the names of the text and noted.

use super::{DeclaredFamily, Meanings};
use crate::declared::{Declared, Least, Space, declared};
use crate::document::ManuscriptFormula;
use torse_syntax::formula::{Expr, Node, Place, parse};
use torse_syntax::latex::item::{Nucleus, TexItem};
use torse_syntax::latex::{LatexCondition, LatexKind};

/// A declaration that is read.
enum Noted {
    Family(String, Option<Space>, Option<(Expr, Expr)>),
    Vectors(Vec<String>, Space),
    Range(LatexCondition),
}

impl Meanings {
    /// Notes what a formula declares, if it does nothing else.
    pub(super) fn declares(
        &mut self,
        formula: &ManuscriptFormula,
        items: &[TexItem],
        line: usize,
    ) -> bool {
        let Some(found) = declared(items) else {
            return false;
        };
        let noted: Option<Vec<Noted>> = found
            .iter()
            .map(|declaration| self.noted(declaration, formula.place))
            .collect();
        let Some(noted) = noted else { return false };
        for note in noted {
            match note {
                Noted::Family(name, space, ends) => {
                    let family = self.families.entry(name).or_insert(DeclaredFamily {
                        space: None,
                        ends: None,
                        line,
                    });
                    family.space = family.space.or(space);
                    family.ends = family.ends.take().or(ends);
                }
                Noted::Vectors(names, space) => {
                    for name in names {
                        self.vectors.entry(name).or_insert((space, line));
                    }
                }
                Noted::Range(condition) => {
                    let ranges = match (&condition, formula.in_theorem) {
                        (_, false) => &mut self.ranges,
                        (LatexCondition::Integers { .. }, true) => &mut self.theorem_ranges,
                        _ => continue,
                    };
                    let names = match &condition {
                        LatexCondition::Interval { names, .. } => names.clone(),
                        LatexCondition::Integers { name, .. } => vec![name.clone()],
                        LatexCondition::Formula(_) => vec![],
                    };
                    for name in names {
                        ranges.entry(name).or_insert((condition.clone(), line));
                    }
                }
            }
        }
        // The indices of members that are listed after their set: `P_i \in \mathbb{R}^3, i = 0, \dots, n`.
        if let [
            Declared::Points {
                member, ends: None, ..
            },
            Declared::Integers {
                letters,
                low: Least::Written(low),
                high: Some(high),
            },
        ] = found.as_slice()
            && let (Some([index]), [own]) = (member.below.as_deref(), letters.as_slice())
            && index.nucleus == own.nucleus
            && let (Some((name, _)), Some(low), Some(high)) = (
                self.member_of(member),
                self.value(low, formula.place),
                self.value(high, formula.place),
            )
            && let Some(family) = self.families.get_mut(&name)
        {
            family.ends.get_or_insert((low, high));
        }
        true
    }

    /// A declaration with its names and formulas read; none if they cannot be.
    fn noted(&self, declaration: &Declared<'_>, place: Place) -> Option<Noted> {
        let names = |letters: &[&TexItem]| -> Option<Vec<String>> {
            let name = |item: &&TexItem| match self.value(std::slice::from_ref(*item), place)?.node
            {
                Node::Name(name) if name != "pi" => Some(name),
                _ => None,
            };
            letters.iter().map(name).collect()
        };
        match declaration {
            Declared::Points {
                member,
                space,
                ends,
            } => {
                let (name, _) = self.member_of(member)?;
                let ends = match ends {
                    Some((low, high)) => Some((self.value(low, place)?, self.value(high, place)?)),
                    None => None,
                };
                Some(Noted::Family(name, *space, ends))
            }
            Declared::Vectors { letters, space } => match names(letters) {
                Some(names) => Some(Noted::Vectors(names, *space)),
                None => Some(Noted::Family(self.family_of(letters)?, Some(*space), None)),
            },
            Declared::Integers { letters, low, high } => {
                let low = match low {
                    Least::Written(low) => self.value(low, place)?,
                    Least::Number(number) => parse(&number.to_string()).ok()?,
                };
                let high = match high {
                    Some(high) => Some(self.value(high, place)?),
                    None => None,
                };
                let [name] = <[String; 1]>::try_from(names(letters)?).ok()?;
                Some(Noted::Range(LatexCondition::Integers { name, low, high }))
            }
            Declared::Reals { letters, interval } => {
                let names = match (names(letters), interval) {
                    (Some(names), _) => names,
                    (None, None) => {
                        let space = Some(Space::Coordinates(1));
                        return Some(Noted::Family(self.family_of(letters)?, space, None));
                    }
                    (None, Some(_)) => return None,
                };
                let all = ((None, false), (None, false));
                let (low, high) = match interval.map(|item| &item.nucleus) {
                    Some(Nucleus::Fenced(open, inner, close)) => {
                        let ends = torse_syntax::latex::parts(inner);
                        let [low, high] = ends.as_slice() else {
                            return None;
                        };
                        let infinite = |list: &[TexItem]| {
                            list.last().is_some_and(|last| last.is_sign("infty"))
                        };
                        let end = |list: &[TexItem]| match infinite(list) {
                            true => Some(None),
                            false => self.value(list, place).map(Some),
                        };
                        ((end(low)?, *open == '['), (end(high)?, *close == ']'))
                    }
                    _ => all,
                };
                Some(Noted::Range(LatexCondition::Interval {
                    names,
                    low,
                    high,
                    is_set: true,
                }))
            }
        }
    }

    /// The family to which all of some members belong: `P_0, P_1, P_2`.
    fn family_of(&self, members: &[&TexItem]) -> Option<String> {
        let families = members.iter().map(|member| self.member_of(member));
        let families: Option<Vec<String>> = families
            .map(|found| found.map(|(family, _)| family))
            .collect();
        let families = families?;
        let (first, others) = families.split_first()?;
        others
            .iter()
            .all(|other| other == first)
            .then(|| first.clone())
    }

    /// The family of a member, and its index.
    fn member_of(&self, member: &TexItem) -> Option<(String, Expr)> {
        match self.value(std::slice::from_ref(member), member.place)?.node {
            Node::Index(head, indices) => match (&head.node, indices.as_slice()) {
                (Node::Name(name), [index])
                    if matches!(self.names.kind(name), Some(LatexKind::Family { .. })) =>
                {
                    Some((name.clone(), index.clone()))
                }
                _ => None,
            },
            _ => None,
        }
    }
}
