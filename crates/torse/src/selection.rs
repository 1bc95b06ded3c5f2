//! Selects claims by name.
//!
//! A name is a paper (`gbt-developable`), a claim (`gbt-developable/thm-4.c`), or a prefix of several ids that ends at
//! the end of a word: `gbt-developable/thm-4` matches `thm-4.a`, `thm-4.b` and `thm-4.c`, but not `thm-40`.

use crate::error::Error;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::{Claim, Paper};

/// Returns the claims of `papers` that match one of `names`, or all if there are no names, in file order; our own
/// figures are included only with their whole paper. A name may match a claim that was left out because it is wrong, or a
/// paper all of whose claims were.
///
/// # Errors
/// [`Error::UnknownName`] for a name without a match.
pub fn select(
    papers: Vec<Paper>,
    names: &[String],
    left_out: &[String],
) -> Result<Vec<Paper>, Error> {
    for name in names {
        let mut known = ids(&papers).chain(left_out.iter().map(String::as_str));
        let is_paper = papers.iter().any(|paper| paper.head.id == *name);
        if !is_paper && !known.any(|id| means(name, id)) {
            return Err(unknown(&papers, name));
        }
    }
    if names.is_empty() {
        return Ok(papers);
    }
    let kept = papers.into_iter().map(|paper| {
        let wanted = |claim: &Claim| {
            names
                .iter()
                .any(|name| means(name, claim.entry.id.get_ref()))
        };
        let whole = names.contains(&paper.head.id);
        Paper {
            claims: paper.claims.into_iter().filter(wanted).collect(),
            own_figures: if whole { paper.own_figures } else { vec![] },
            corrigenda: paper.corrigenda,
            ..paper
        }
    });
    Ok(kept.filter(|paper| !paper.claims.is_empty()).collect())
}

/// Returns the papers with the claims of these ids alone.
#[must_use]
pub fn only(papers: &[Paper], ids: &[&str]) -> Vec<Paper> {
    let ids: BTreeSet<&str> = ids.iter().copied().collect();
    let kept = papers.iter().map(|paper| {
        let wanted = |claim: &&Claim| ids.contains(claim.entry.id.get_ref().as_str());
        Paper {
            source: Arc::clone(&paper.source),
            head: paper.head.clone(),
            declarations: paper.declarations.clone(),
            claims: paper.claims.iter().filter(wanted).cloned().collect(),
            corrigenda: paper.corrigenda.clone(),
            own_figures: vec![],
        }
    });
    kept.filter(|paper| !paper.claims.is_empty()).collect()
}

/// Returns the one claim that matches `name`, without its paper's other claims.
///
/// # Errors
/// [`Error::UnknownName`], or [`Error::Ambiguous`] for a prefix of several ids.
pub fn select_one(papers: &[Paper], name: &str) -> Result<Paper, Error> {
    let matching: Vec<&str> = match ids(papers).find(|id| *id == name) {
        Some(exact) => vec![exact],
        None => ids(papers).filter(|id| means(name, id)).collect(),
    };
    match matching.as_slice() {
        [] | [_] => only(papers, &matching)
            .pop()
            .ok_or_else(|| unknown(papers, name)),
        several => Err(Error::Ambiguous {
            name: name.to_owned(),
            ids: several.iter().map(|id| (*id).to_owned()).collect(),
        }),
    }
}

/// Returns the paper with this slug.
///
/// # Errors
/// [`Error::UnknownName`].
pub fn paper<'p>(papers: &'p [Paper], slug: &str) -> Result<&'p Paper, Error> {
    let found = papers.iter().find(|paper| paper.head.id == slug);
    found.ok_or_else(|| Error::UnknownName {
        name: slug.to_owned(),
        help: format!("the papers are {}", slugs(papers)),
    })
}

/// Fails unless every name is the slug of a paper.
///
/// # Errors
/// [`Error::UnknownName`] for the first that is not.
pub fn check_papers(papers: &[Paper], names: &[String]) -> Result<(), Error> {
    names
        .iter()
        .try_for_each(|name| paper(papers, name).map(|_| ()))
}

fn ids(papers: &[Paper]) -> impl Iterator<Item = &str> {
    papers
        .iter()
        .flat_map(|paper| &paper.claims)
        .map(|claim| claim.entry.id.get_ref().as_str())
}

/// Whether a name matches the claim of this id.
#[must_use]
pub fn means(name: &str, id: &str) -> bool {
    let name = name.strip_suffix('/').unwrap_or(name);
    match id.strip_prefix(name) {
        Some(rest) => !name.is_empty() && !rest.starts_with(char::is_alphanumeric),
        None => false,
    }
}

fn slugs(papers: &[Paper]) -> String {
    let slugs: Vec<&str> = papers.iter().map(|paper| paper.head.id.as_str()).collect();
    slugs.join(", ")
}

fn unknown(papers: &[Paper], name: &str) -> Error {
    let names = ids(papers).chain(papers.iter().map(|paper| paper.head.id.as_str()));
    let nearest = names.min_by_key(|known| distance(known, name));
    let suggestion = nearest.filter(|known| is_slip(known, name));
    let help = match suggestion {
        Some(known) => format!("did you mean `{known}`?"),
        None => match name.split_once('/') {
            Some((slug, _)) if paper(papers, slug).is_ok() => {
                format!("`torse list {slug}` shows the claims of this paper")
            }
            _ => format!("the papers are {}", slugs(papers)),
        },
    };
    Error::UnknownName {
        name: name.to_owned(),
        help,
    }
}

/// Whether a name may be a mistyped id: at most half of the letters differ, not counting the paper if both have the
/// same one.
fn is_slip(known: &str, name: &str) -> bool {
    let (known, name) = match (known.split_once('/'), name.split_once('/')) {
        (Some((paper, known)), Some((same, name))) if paper == same => (known, name),
        _ => (known, name),
    };
    2 * distance(known, name) <= known.chars().count()
}

/// Returns how many letters to insert, delete or replace to turn one word into the other (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
    // No id is longer, and the work is the product of the lengths.
    let b: Vec<char> = b.chars().take(200).collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = i;
        let mut left = i + 1;
        for (cell, y) in row.iter_mut().skip(1).zip(&b) {
            let replaced = corner + usize::from(x != *y);
            corner = *cell;
            left = replaced.min(left + 1).min(*cell + 1);
            *cell = left;
        }
        if let Some(first) = row.first_mut() {
            *first = i + 1;
        }
    }
    row.last().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_the_edits() {
        for (a, b, edits) in [
            ("", "", 0),
            ("", "abc", 3),
            ("abc", "", 3),
            ("kitten", "sitting", 3),
            ("thm-4.c", "thm-4c", 1),
            ("flaw", "lawn", 2),
        ] {
            assert_eq!(distance(a, b), edits, "{a} {b}");
            assert_eq!(distance(b, a), edits, "{b} {a}");
        }
    }

    #[test]
    fn a_name_of_the_right_paper_is_a_slip_only_if_its_own_letters_are_near() {
        assert!(is_slip("gbt-developable/thm-4.c", "gbt-developable/thm-4c"));
        assert!(is_slip("gbt-developable", "gbt-developabel"));
        assert!(!is_slip("gbt-developable/fig-1", "gbt-developable/nope"));
    }

    #[test]
    fn a_name_means_the_ids_that_continue_it_at_the_end_of_a_word() {
        assert!(means("p/thm-4", "p/thm-4"));
        assert!(means("p/thm-4", "p/thm-4.c"));
        assert!(means("p", "p/thm-4.c"));
        assert!(means("p/", "p/thm-4.c"));
        assert!(!means("p/thm-4", "p/thm-40"));
        assert!(!means("thm-4", "p/thm-4"));
        assert!(!means("", "p/thm-4"));
        assert!(!means("/", "p/thm-4"));
    }
}
