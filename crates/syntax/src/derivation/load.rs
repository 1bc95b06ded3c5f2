//! Reading a folder of derivations and parsing every formula in it.
//!
//! What is wrong is collected and left out, and what rests on it is left out with it: so all mistakes of a folder are
//! shown at once, and nothing is complained of that is wrong only because something else is.

use super::claim::{Claim, claim, gather_examples};
use super::corrigendum::corrigenda;
use super::declarations::Declarations;
use super::definitions::{add_definitions, name_of};
use super::error::{DerivationError, LoadError};
use super::figure::{Figure, own_figure};
use super::paper::Paper;
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

/// The papers of a folder, and what is wrong with them.
#[derive(Debug)]
pub struct Loaded {
    /// The papers, with the claims and figures that are well formed.
    pub papers: Vec<Paper>,
    /// All mistakes, in the order of papers and files.
    pub errors: Vec<LoadError>,
    /// The ids of the claims and figures that are left out: they are wrong, or rest on a declaration that is.
    pub left_out: Vec<String>,
}

impl Loaded {
    /// The papers if nothing is wrong.
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

/// Loads all papers below `folder`, in the order of their folders' names, if nothing is wrong with them.
///
/// # Errors
/// The first mistake that [`load_all`] finds.
pub fn load(folder: &Path) -> Result<Vec<Paper>, LoadError> {
    load_all(folder)?.complete()
}

/// Loads all papers below `folder`, in the order of their folders' names, as far as they are well formed.
///
/// # Errors
/// [`LoadError`] if the folder cannot be read or holds no paper. All other mistakes are in [`Loaded::errors`]:
/// unreadable files, TOML errors, unknown fields, syntax errors, repeated ids.
pub fn load_all(folder: &Path) -> Result<Loaded, LoadError> {
    let unreadable = |error: std::io::Error| LoadError::Unreadable {
        path: folder.display().to_string(),
        reason: error.to_string(),
    };
    let mut slugs = vec![];
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        // Whatever it is: one that cannot be read is a mistake, not nothing.
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
    let mut reading = Reading::default();
    let papers = slugs
        .iter()
        .filter_map(|slug| reading.paper(|name| folder::read(folder, slug, name)))
        .collect();
    Ok(reading.loaded(papers))
}

/// Loads the paper of one folder, that with a `paper.toml`. It stands for itself: what it says of other papers cannot be
/// looked up.
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

/// Loads one paper through `read`, which returns a file of its folder.
///
/// # Errors
/// The first mistake.
pub fn paper(read: impl Fn(&str) -> Result<Arc<Source>, LoadError>) -> Result<Paper, LoadError> {
    let mut reading = Reading::default();
    let paper = reading.paper(read);
    let mut papers = reading.loaded(paper.into_iter().collect()).complete()?;
    papers.pop().ok_or_else(|| LoadError::Empty {
        path: "the paper".to_owned(),
    })
}

/// What was found so far.
#[derive(Default)]
struct Reading {
    errors: Errors,
    left_out: Vec<String>,
    /// Every id, of what is left out too.
    ids: BTreeSet<String>,
    /// The ids of sentences that are stated in parts.
    wholes: BTreeSet<String>,
}

impl Reading {
    /// A paper with what is well formed in it; none if its head is wrong.
    fn paper(&mut self, read: impl Fn(&str) -> Result<Arc<Source>, LoadError>) -> Option<Paper> {
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
        let head = head.and_then(|head| entry::<PaperHead>(&source, head));
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
            head,
            declarations,
            claims,
            corrigenda,
            own_figures,
        })
    }

    /// Adds the declarations of a file. Those that are wrong are marked as such.
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
        let told: Vec<CorrigendumEntry> =
            list(source, sections.remove("corrigendum"), &mut self.errors);
        for entry in told {
            self.add_id(source, &entry.id);
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
            self.add_id(source, &id);
            let whole = entry.part_of.as_ref();
            self.wholes.extend(whole.map(|id| id.get_ref().clone()));
            let claim = claim(source, &shared, slug, entry, &mut self.errors);
            match self.errors.0.len() == before && !claim.rests_on_wrong() {
                true => more.push(claim),
                false => self.left_out.push(id.into_inner()),
            }
        }
        gather_examples(&mut more);
        claims.append(&mut more);
        for entry in drawn {
            let before = self.errors.0.len();
            let id = entry.get_ref().id.clone();
            let figure = own_figure(source, &shared, slug, entry, &mut self.errors);
            if let Some(id) = &id {
                self.add_id(source, id);
            }
            let wrong = |figure: &Figure| figure.declarations.any_wrong();
            match figure.filter(|figure| self.errors.0.len() == before && !wrong(figure)) {
                Some(figure) => own_figures.push(figure),
                None => self.left_out.extend(id.map(Spanned::into_inner)),
            }
        }
    }

    /// An id may be used once in a folder.
    fn add_id(&mut self, source: &Arc<Source>, id: &Spanned<String>) {
        if !self.ids.insert(id.get_ref().clone()) {
            let message = format!("the id `{}` is used twice", id.get_ref());
            let origin = Origin::from_spanned(source, id);
            let error = DerivationError::at(&origin, Place { start: 0, end: 1 }, message);
            self.errors.0.push(LoadError::Derivation(Box::new(error)));
        }
    }

    /// Looks at what claims say of each other, and ends.
    fn loaded(mut self, mut papers: Vec<Paper>) -> Loaded {
        references::resolve(&mut papers, &self.ids, &self.wholes, &mut self.errors);
        Loaded {
            papers,
            errors: self.errors.0,
            left_out: self.left_out,
        }
    }
}
