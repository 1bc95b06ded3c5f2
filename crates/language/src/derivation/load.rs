//! Reading a folder of derivations and parsing every formula in it.
//!
//! What is wrong is collected and left out, and what rests on it is left out with it: so all mistakes of a folder are
//! shown at once, and nothing is complained of that is wrong only because something else is.

use super::error::{DerivationError, LoadError};
use super::schema::{ClaimEntry, PaperHead};
use super::source::{Origin, Source};
use super::table::{Errors, entry, list, nothing_else, sections};
use super::written::{Written, written};
use super::{folder, table};
use crate::derivation::Figure;
use crate::derivation::declarations::{Declarations, Definition};
use crate::derivation::schema::figure::FigureEntry;
use crate::syntax::{Expr, is_name, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;
use toml::Spanned;

/// A claim, parsed but not decided.
#[derive(Debug, Clone)]
pub struct Claim {
    /// The fields of the file.
    pub entry: ClaimEntry,
    /// Where the claim's id stands, for errors about the claim as a whole.
    pub origin: Origin,
    /// Symbols, bases and definitions it may use: its own, its file's, its paper's.
    pub declarations: Arc<Declarations>,
    /// The given equations.
    pub given: Vec<Written>,
    /// The unknowns.
    pub unknowns: Vec<Written>,
    /// The assumptions.
    pub assumptions: Vec<Written>,
    /// The statement, if it has one.
    pub statement: Option<Written>,
    /// The printed values of the same example, this one included: the values of the file whose ids agree
    /// up to the first point. Empty in the members themselves.
    pub example: Arc<[Claim]>,
    /// The drawing of a figure.
    pub figure: Option<Figure>,
}

impl Claim {
    /// The ids of the claims that this one rests on.
    #[must_use]
    pub fn uses(&self) -> Vec<String> {
        let ids = self.entry.uses.iter();
        ids.map(|id| id.get_ref().clone()).collect()
    }
}

/// A paper with its claims in order.
#[derive(Debug, Clone)]
pub struct Paper {
    /// Who and what.
    pub head: PaperHead,
    /// What `paper.toml` declares.
    pub declarations: Arc<Declarations>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// Figures that are not the paper's.
    pub own_figures: Vec<Figure>,
}

impl Paper {
    /// All figures: those of claims, then those of our own, each in file order.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        let drawn = self.claims.iter().filter_map(|claim| claim.figure.as_ref());
        drawn.chain(&self.own_figures)
    }
}

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
            &["paper", "symbols", "basis", "define"],
            &mut self.errors,
        );
        let head = head.and_then(|head| entry::<PaperHead>(&source, head));
        let head = self.errors.keep(head)?;
        let declarations = Arc::new(shared);
        let (mut claims, mut own_figures) = (vec![], vec![]);
        for name in &head.claims {
            let file = folder::check_name(&source, name).and_then(|()| read(name.get_ref()));
            if let Some(source) = self.errors.keep(file) {
                self.file(
                    &source,
                    &declarations,
                    &head.id,
                    &mut claims,
                    &mut own_figures,
                );
            }
        }
        Some(Paper {
            head,
            declarations,
            claims,
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
        declarations.spoil(unread);
        declarations.add_symbols(source, &symbols, errors);
        let (bases, unread) = table::table(source, sections.remove("basis"), errors);
        declarations.spoil(unread);
        declarations.add_bases(source, &bases, errors);
        let (definitions, unread) = table::table(source, sections.remove("define"), errors);
        declarations.spoil(unread.iter().map(|head| name_of(head)));
        add_definitions(declarations, source, &definitions, errors);
    }

    /// Adds the claims and figures of a file.
    fn file(
        &mut self,
        source: &Arc<Source>,
        paper: &Arc<Declarations>,
        slug: &str,
        claims: &mut Vec<Claim>,
        own_figures: &mut Vec<Figure>,
    ) {
        let Some(mut sections) = self.errors.keep(sections(source)) else {
            return;
        };
        let mut shared = (**paper).clone();
        self.declare(&mut shared, source, &mut sections);
        let entries: Vec<ClaimEntry> = list(source, sections.remove("claim"), &mut self.errors);
        let drawn: Vec<Spanned<FigureEntry>> =
            list(source, sections.remove("figure"), &mut self.errors);
        nothing_else(
            source,
            sections,
            &["symbols", "basis", "define", "claim", "figure"],
            &mut self.errors,
        );
        let shared = Arc::new(shared);
        let mut more = vec![];
        for entry in entries {
            let id = entry.id.clone();
            let before = self.errors.0.len();
            self.add_id(source, &id);
            let claim = claim(source, &shared, slug, entry, &mut self.errors);
            match claim.filter(|claim| self.errors.0.len() == before && !rests_on_wrong(claim)) {
                Some(claim) => more.push(claim),
                None => self.left_out.push(id.into_inner()),
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
            self.errors.0.push(wrong(&Origin::of(source, id), message));
        }
    }

    /// Looks at what claims say of each other, and ends.
    fn loaded(mut self, papers: Vec<Paper>) -> Loaded {
        for claim in papers.iter().flat_map(|paper| &paper.claims) {
            for used in &claim.entry.uses {
                if !self.ids.contains(used.get_ref()) {
                    let message = format!("no claim has the id `{}`", used.get_ref());
                    let help = "`uses` takes full ids, such as `gbt-developable/eq-2.2`";
                    let origin = Origin::of(&claim.origin.source, used);
                    let error = DerivationError::at(&origin, whole(used), message).with_help(help);
                    self.errors.0.push(LoadError::Derivation(Box::new(error)));
                }
            }
        }
        Loaded {
            papers,
            errors: self.errors.0,
            left_out: self.left_out,
        }
    }
}

/// Whether a formula of the claim mentions a declaration that is wrong, be it through others.
fn rests_on_wrong(claim: &Claim) -> bool {
    let formulas = claim.given.iter().chain(&claim.unknowns);
    let formulas = formulas.chain(&claim.assumptions).chain(&claim.statement);
    let figure = claim.figure.as_ref();
    claim.declarations.rest_on_wrong(formulas.map(|w| &w.expr))
        || figure.is_some_and(|figure| figure.declarations.any_wrong())
}

/// Shows every value of an example all values of it.
fn gather_examples(claims: &mut [Claim]) {
    let mut examples: BTreeMap<String, Vec<Claim>> = BTreeMap::new();
    for value in claims
        .iter()
        .filter(|c| c.entry.kind == crate::words::Kind::Value)
    {
        let values = examples.entry(example(value).to_owned()).or_default();
        values.push(value.clone());
    }
    for (name, values) in examples {
        let values: Arc<[Claim]> = values.into();
        for value in claims.iter_mut().filter(|c| example(c) == name) {
            value.example = Arc::clone(&values);
        }
    }
}

/// The id up to the first point: `hermite-developable/ex-4` for `hermite-developable/ex-4.r0u`.
fn example(claim: &Claim) -> &str {
    let id = claim.entry.id.get_ref();
    id.split_once('.')
        .map_or(id.as_str(), |(example, _)| example)
}

/// A figure that is not the paper's: it has an id of its own.
fn own_figure(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    slug: &str,
    entry: Spanned<FigureEntry>,
    errors: &mut Errors,
) -> Option<Figure> {
    let range = entry.span();
    let entry = entry.into_inner();
    let Some(id) = entry.id.clone() else {
        let message = "a figure of its own needs an `id`".to_owned();
        errors.0.push(table::complaint(source, range, message));
        return None;
    };
    let origin = Origin::of(source, &id);
    errors.keep(folder::check_id(source, &id, slug))?;
    let claims = entry.claims.iter().map(|c| c.get_ref().clone()).collect();
    Some(figure(
        source,
        origin,
        shared,
        id.into_inner(),
        claims,
        entry,
        errors,
    ))
}

fn figure(
    source: &Arc<Source>,
    origin: Origin,
    shared: &Arc<Declarations>,
    id: String,
    claims: Vec<String>,
    entry: FigureEntry,
    errors: &mut Errors,
) -> Figure {
    let mut declarations = (**shared).clone();
    declarations.add_symbols(source, &entry.symbols, errors);
    add_definitions(&mut declarations, source, &entry.local, errors);
    Figure {
        id,
        claims,
        entry,
        origin,
        source: Arc::clone(source),
        declarations: Arc::new(declarations),
    }
}

/// A claim with those of its formulas that are well formed; none if it cannot be one.
fn claim(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    slug: &str,
    entry: ClaimEntry,
    errors: &mut Errors,
) -> Option<Claim> {
    let origin = Origin::of(source, &entry.id);
    errors.keep(folder::check_id(source, &entry.id, slug));
    let declarations = if entry.symbols.is_empty() && entry.local.is_empty() {
        Arc::clone(shared)
    } else {
        let mut own = (**shared).clone();
        own.add_symbols(source, &entry.symbols, errors);
        add_definitions(&mut own, source, &entry.local, errors);
        Arc::new(own)
    };
    let mut all = |texts: &[Spanned<String>]| -> Vec<Written> {
        let parsed = texts.iter().map(|text| written(source, text));
        parsed.filter_map(|result| errors.keep(result)).collect()
    };
    let statement = all(entry.states.as_slice()).pop();
    let (given, unknowns) = (all(&entry.given), all(&entry.solve_for));
    let assumptions = all(&entry.assume);
    let undecidable = entry.underspecified.is_some() || entry.out_of_scope.is_some();
    let needs_statement = !matches!(
        entry.kind,
        crate::words::Kind::Definition | crate::words::Kind::Figure
    ) && !undecidable;
    if needs_statement && entry.states.is_none() {
        let message = "this claim states nothing: the field `states` is missing";
        let help = "add `states = '...'`, or say why not with `underspecified` or `out_of_scope`";
        let error = DerivationError::at(&origin, whole(&entry.id), message).with_help(help);
        errors.0.push(LoadError::Derivation(Box::new(error)));
    }
    if entry.given.is_empty() != entry.solve_for.is_empty() {
        let message = "`given` and `solve_for` go together".to_owned();
        errors.0.push(wrong(&origin, message));
    }
    let drawn = entry.figure.as_ref().map(|drawn| {
        let id = entry.id.get_ref();
        let (origin, claims) = (origin.clone(), vec![id.clone()]);
        let drawn = (**drawn).clone();
        figure(
            source,
            origin,
            &declarations,
            id.clone(),
            claims,
            drawn,
            errors,
        )
    });
    Some(Claim {
        given,
        unknowns,
        assumptions,
        statement,
        figure: drawn,
        declarations,
        origin,
        entry,
        example: Arc::new([]),
    })
}

fn whole(text: &Spanned<String>) -> crate::syntax::Place {
    crate::syntax::Place {
        start: 0,
        end: text.get_ref().len(),
    }
}

fn wrong(origin: &Origin, message: String) -> LoadError {
    let place = crate::syntax::Place { start: 0, end: 1 };
    LoadError::Derivation(Box::new(DerivationError::at(origin, place, message)))
}

/// Parses definitions: the key is a name or a head `F(z, mu)`. Those that are wrong are marked as such.
fn add_definitions(
    declarations: &mut Declarations,
    source: &Arc<Source>,
    table: &BTreeMap<String, Spanned<String>>,
    errors: &mut Errors,
) {
    for (head, text) in table {
        let definition = definition(source, head, text);
        match errors.keep(definition) {
            Some((name, definition)) => declarations.define(name, definition),
            None => declarations.spoil([name_of(head)]),
        }
    }
}

/// What a head `F(z, mu)` defines, even if it is wrong.
fn name_of(head: &str) -> String {
    let name = head.split_once('(').map_or(head, |(name, _)| name);
    name.trim().to_owned()
}

fn definition(
    source: &Arc<Source>,
    head: &str,
    text: &Spanned<String>,
) -> Result<(String, Definition), LoadError> {
    use crate::syntax::Node;
    let body = written(source, text)?;
    let name = |expr: &Expr| match &expr.node {
        Node::Name(name) if is_name(name) => Some(name.clone()),
        _ => None,
    };
    let parts = parse(head).ok().and_then(|head| match &head.node {
        Node::Call(function, arguments) => {
            let parameters: Option<Vec<String>> = arguments.iter().map(name).collect();
            Some((name(function)?, parameters?))
        }
        _ => Some((name(&head)?, vec![])),
    });
    let Some((name, parameters)) = parts else {
        let message = format!("`{head}` is no name and no head such as `F(z, mu)`");
        return Err(wrong(&body.origin, message));
    };
    let distinct: BTreeSet<&String> = parameters.iter().collect();
    if distinct.len() != parameters.len() {
        let message = format!("`{head}` has two parameters of the same name");
        return Err(wrong(&body.origin, message));
    }
    Ok((name, Definition { parameters, body }))
}
