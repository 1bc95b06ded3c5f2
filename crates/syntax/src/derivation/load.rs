//! Loads a folder of derivations and parses every formula in it.
//!
//! Invalid entries are reported and left out, together with everything that depends on them. So all mistakes of a
//! folder are shown at once, and nothing is reported that is wrong only because something else is.

use super::claim::{Claim, claim, gather_examples};
use super::corrigendum::corrigenda;
use super::declarations::Declarations;
use super::definitions::{add_definitions, name_of};
use super::error::{DerivationError, LoadError};
use super::figure::{Figure, own_figure};
use super::paper::Paper;
use super::references::Known;
use super::schema::corrigendum::CorrigendumEntry;
use super::schema::figure::FigureEntry;
use super::schema::{ClaimEntry, PaperHead};
use super::source::{Origin, Source};
use super::table::{Errors, entry, list, nothing_else, sections};
use super::{folder, references, table};
use crate::formula::Place;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;
use toml::Spanned;

/// The papers of a folder, and all mistakes in them.
#[derive(Debug)]
pub struct Loaded {
    /// The papers, with their valid claims and figures.
    pub papers: Vec<Paper>,
    /// All mistakes, in the order of papers and files.
    pub errors: Vec<LoadError>,
    /// The ids of the claims and figures that are left out because they are invalid or depend on an invalid
    /// declaration.
    pub left_out: Vec<String>,
}

impl Loaded {
    /// Returns the papers if there are no mistakes.
    ///
    /// # Errors
    /// The first mistake.
    pub fn complete(self) -> Result<Vec<Paper>, LoadError> {
        match self.errors.into_iter().next() {
            Some(error) => Err(error),
            None => Ok(self.papers),
        }
    }
}

/// Loads all papers below `folder`, in the order of the names of their folders, and fails if any is invalid.
///
/// # Errors
/// The first mistake that [`load_all`] finds.
pub fn load(folder: &Path) -> Result<Vec<Paper>, LoadError> {
    load_all(folder)?.complete()
}

/// Loads all papers below `folder`, in the order of the names of their folders, leaving out invalid entries.
///
/// # Errors
/// [`LoadError`] if the folder cannot be read or contains no paper. All other mistakes are collected in
/// [`Loaded::errors`]: unreadable files, TOML errors, unknown fields, syntax errors, repeated ids.
pub fn load_all(folder: &Path) -> Result<Loaded, LoadError> {
    load_all_with(folder, |_| None)
}

/// Loads all papers below `folder` as [`load_all`] does, with texts that are not saved: `unsaved` gives the text that stands
/// for a file, by its name with that of its paper's folder, `my-paper/claims.toml`.
///
/// # Errors
/// As [`load_all`]. A text of more than [`MAX_BYTES`](super::MAX_BYTES) bytes is one of [`Loaded::errors`].
///
/// ```
/// use torse_syntax::derivation::{load_all, load_all_with};
/// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations");
/// # let folder = std::path::Path::new(folder);
/// # if folder.exists() {
/// assert!(load_all(folder)?.errors.is_empty());
/// let broken = |name: &str| (name == "torses/planes.toml").then(|| "[[claim]".to_owned());
/// assert!(!load_all_with(folder, broken)?.errors.is_empty());
/// # }
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
pub fn load_all_with(
    folder: &Path,
    unsaved: impl Fn(&str) -> Option<String>,
) -> Result<Loaded, LoadError> {
    let slugs = slugs(folder)?;
    let mut reading = Reading::default();
    let papers = slugs
        .iter()
        .filter_map(|slug| {
            reading.paper(Some(slug), |name| {
                let path = format!("{slug}/{name}");
                match unsaved(&path) {
                    Some(text) => folder::unsaved(path, text),
                    None => folder::read(folder, slug, name),
                }
            })
        })
        .collect();
    Ok(reading.loaded(papers, &[]))
}

/// The names of the folders of papers below `folder`, in order.
///
/// # Errors
/// [`LoadError`] if the folder cannot be read or contains no paper.
pub(super) fn slugs(folder: &Path) -> Result<Vec<String>, LoadError> {
    let unreadable = |error: std::io::Error| LoadError::Unreadable {
        path: folder.display().to_string(),
        reason: error.to_string(),
    };
    let mut slugs = vec![];
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        // A `paper.toml` of any kind counts: one that cannot be read is reported, not skipped.
        if path.join("paper.toml").symlink_metadata().is_ok() {
            slugs.extend(
                path.file_name()
                    .map(|name| name.to_string_lossy().into_owned()),
            );
        }
    }
    slugs.sort();
    if slugs.is_empty() {
        return Err(LoadError::Empty {
            path: folder.display().to_string(),
        });
    }
    Ok(slugs)
}

/// Loads the paper in a folder that contains a `paper.toml`. References to other papers cannot be resolved.
///
/// # Errors
/// The first mistake.
pub fn open(folder: &Path) -> Result<Paper, LoadError> {
    let real = folder.canonicalize();
    let real = real.map_err(|error| LoadError::Unreadable {
        path: folder.display().to_string(),
        reason: error.to_string(),
    })?;
    let slug = real.file_name().unwrap_or_default().to_string_lossy();
    let above = real.parent().unwrap_or(&real);
    paper(|name| folder::read(above, &slug, name))
}

/// Loads one paper; `read` returns the content of a file of its folder.
///
/// # Errors
/// The first mistake.
pub fn paper(read: impl Fn(&str) -> Result<Arc<Source>, LoadError>) -> Result<Paper, LoadError> {
    let mut reading = Reading::default();
    let paper = reading.paper(None, read);
    let papers = paper.into_iter().collect();
    let mut papers = reading.loaded(papers, &[]).complete()?;
    papers.pop().ok_or_else(|| LoadError::Empty {
        path: "the paper".to_owned(),
    })
}

/// The state of loading.
#[derive(Default)]
pub(super) struct Reading {
    errors: Errors,
    left_out: Vec<String>,
    /// All ids used so far, including those of entries that are left out.
    ids: BTreeSet<String>,
    /// Those that do not begin with their papers, which are mistakes and in nobody's way.
    strangers: BTreeSet<String>,
    /// The ids of sentences that are split into parts.
    sentences: BTreeSet<String>,
}

impl Reading {
    /// Loads a paper with its valid entries; `None` if its head is invalid, or names another folder than this one.
    pub(super) fn paper(
        &mut self,
        folder: Option<&str>,
        read: impl Fn(&str) -> Result<Arc<Source>, LoadError>,
    ) -> Option<Paper> {
        let source = self.errors.keep(read("paper.toml"))?;
        let mut sections = self.errors.keep(sections(&source))?;
        let head = sections.remove("paper").ok_or_else(|| {
            let message = "the section [paper] is missing: id, title, authors, venue, claims";
            table::complaint(&source, 0..1, message.to_owned())
        });
        let mut shared = Declarations::default();
        self.declare(&mut shared, &source, &mut sections);
        nothing_else(
            &source,
            sections,
            &["paper", "symbols", "basis", "define", "display"],
            &mut self.errors,
        );
        let head = head.and_then(|head| {
            let place = place_of_id(&head);
            let head = entry::<PaperHead>(&source, head)?;
            match folder.filter(|folder| *folder != head.id) {
                None => Ok(head),
                Some(folder) => {
                    let message = format!(
                        "the folder of the paper `{}` is called `{folder}`: both have one name",
                        head.id
                    );
                    Err(table::complaint(&source, place, message))
                }
            }
        });
        let head = self.errors.keep(head)?;
        let declarations = Arc::new(shared);
        let (mut claims, mut own_figures, mut faults) = (vec![], vec![], vec![]);
        for name in &head.claims {
            let file = folder::check_name(&source, name).and_then(|()| read(name.get_ref()));
            if let Some(source) = self.errors.keep(file) {
                self.file(
                    &source,
                    &declarations,
                    &head.id,
                    &mut claims,
                    &mut own_figures,
                    &mut faults,
                );
            }
        }
        let corrigenda = corrigenda(&faults, &claims, &self.left_out, &mut self.errors);
        Some(Paper {
            source,
            head,
            declarations,
            claims,
            corrigenda,
            own_figures,
        })
    }

    /// Adds the declarations of a file. Invalid ones are reported and marked.
    fn declare(
        &mut self,
        declarations: &mut Declarations,
        source: &Arc<Source>,
        sections: &mut BTreeMap<String, Spanned<toml::de::DeValue<'_>>>,
    ) {
        let errors = &mut self.errors;
        let (symbols, unread) = table::table(source, sections.remove("symbols"), errors);
        declarations.mark_invalid(unread);
        declarations.add_symbols(source, &symbols, None, errors);
        let (bases, unread) = table::table(source, sections.remove("basis"), errors);
        declarations.mark_invalid(unread);
        declarations.add_bases(source, &bases, errors);
        let (definitions, unread) = table::table(source, sections.remove("define"), errors);
        declarations.mark_invalid(unread.iter().map(|head| name_of(head)));
        add_definitions(declarations, source, &definitions, errors);
        let (displays, _) = table::table(source, sections.remove("display"), errors);
        declarations.add_displays(source, &displays, errors);
    }

    /// Adds the claims and figures of a file.
    fn file(
        &mut self,
        source: &Arc<Source>,
        paper: &Arc<Declarations>,
        slug: &str,
        claims: &mut Vec<Claim>,
        own_figures: &mut Vec<Figure>,
        faults: &mut Vec<(Arc<Source>, CorrigendumEntry)>,
    ) {
        let Some(mut sections) = self.errors.keep(sections(source)) else {
            return;
        };
        let mut shared = (**paper).clone();
        self.declare(&mut shared, source, &mut sections);
        let entries: Vec<ClaimEntry> = list(source, sections.remove("claim"), &mut self.errors);
        let drawn: Vec<Spanned<FigureEntry>> =
            list(source, sections.remove("figure"), &mut self.errors);
        let corrigenda: Vec<CorrigendumEntry> =
            list(source, sections.remove("corrigendum"), &mut self.errors);
        for entry in corrigenda {
            self.add_id(source, slug, &entry.id);
            self.errors.keep(folder::check_id(source, &entry.id, slug));
            faults.push((Arc::clone(source), entry));
        }
        nothing_else(
            source,
            sections,
            &[
                "symbols",
                "basis",
                "define",
                "display",
                "claim",
                "figure",
                "corrigendum",
            ],
            &mut self.errors,
        );
        let shared = Arc::new(shared);
        let mut more = vec![];
        for entry in entries {
            let id = entry.id.clone();
            let before = self.errors.0.len();
            self.add_id(source, slug, &id);
            let sentence = entry.part_of.as_ref();
            self.sentences
                .extend(sentence.map(|id| id.get_ref().clone()));
            let claim = claim(source, &shared, slug, entry, &mut self.errors);
            if self.errors.0.len() == before && !claim.uses_invalid_declaration() {
                more.push(claim)
            } else {
                self.left_out.push(id.into_inner())
            }
        }
        gather_examples(&mut more);
        claims.append(&mut more);
        for entry in drawn {
            let before = self.errors.0.len();
            let id = entry.get_ref().id.clone();
            let figure = own_figure(source, &shared, slug, entry, &mut self.errors);
            if let Some(id) = &id {
                self.add_id(source, slug, id);
            }
            let wrong = |figure: &Figure| figure.declarations.any_invalid();
            match figure.filter(|figure| self.errors.0.len() == before && !wrong(figure)) {
                Some(figure) => own_figures.push(figure),
                None => self.left_out.extend(id.map(Spanned::into_inner)),
            }
        }
    }

    /// Records an id, which may be used only once in a folder.
    fn add_id(&mut self, source: &Arc<Source>, slug: &str, id: &Spanned<String>) {
        let own = id.get_ref().strip_prefix(slug);
        if !own.is_some_and(|name| name.starts_with('/')) {
            self.strangers.insert(id.get_ref().clone());
            return;
        }
        if !self.ids.insert(id.get_ref().clone()) {
            let message = format!("the id `{}` is used twice", id.get_ref());
            let origin = Origin::from_spanned(source, id);
            let error = DerivationError::at(&origin, Place { start: 0, end: 1 }, message);
            self.errors.0.push(LoadError::Derivation(Box::new(error)));
        }
    }

    /// What papers that were read have for those that refer to them.
    pub(super) fn known(self, papers: &[Paper]) -> Known {
        let mut ids = self.ids;
        ids.extend(self.strangers);
        Known::new(papers, ids, self.sentences)
    }

    /// Resolves references between claims, also to those of other papers, and finishes.
    pub(super) fn loaded(mut self, mut papers: Vec<Paper>, others: &[&Known]) -> Loaded {
        let (mut errors, left_out) = (
            std::mem::take(&mut self.errors),
            std::mem::take(&mut self.left_out),
        );
        let own = self.known(&papers);
        let known: Vec<&Known> = std::iter::once(&own)
            .chain(others.iter().copied())
            .collect();
        references::resolve(&mut papers, &known, &mut errors);
        Loaded {
            papers,
            errors: errors.0,
            left_out,
        }
    }
}

/// Where the id of a paper stands in its head; where it is missing, the head.
fn place_of_id(head: &Spanned<toml::de::DeValue<'_>>) -> std::ops::Range<usize> {
    head.get_ref().get("id").map_or(head.span(), Spanned::span)
}
