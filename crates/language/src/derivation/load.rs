//! Reading a folder of derivations and parsing every formula in it.

use super::error::{DerivationError, LoadError};
use super::schema::{ClaimEntry, ClaimsFile, PaperFile, PaperHead};
use super::source::{Origin, Source};
use crate::derivation::Figure;
use crate::derivation::declarations::{Declarations, Definition};
use crate::derivation::schema::figure::FigureEntry;
use crate::syntax::{Expr, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;
use toml::Spanned;

/// A parsed formula and where it was written.
#[derive(Debug, Clone)]
pub struct Written {
    /// The formula.
    pub expr: Expr,
    /// Its origin.
    pub origin: Origin,
}

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

/// Loads all papers below `folder`, in the order of their folders' names.
///
/// # Errors
/// [`LoadError`]: unreadable files, TOML errors, unknown fields, syntax errors, repeated ids.
pub fn load(folder: &Path) -> Result<Vec<Paper>, LoadError> {
    let unreadable = |path: &Path, error: &std::io::Error| LoadError::Unreadable {
        path: path.display().to_string(),
        reason: error.to_string(),
    };
    let mut slugs = vec![];
    for entry in std::fs::read_dir(folder).map_err(|e| unreadable(folder, &e))? {
        let path = entry.map_err(|e| unreadable(folder, &e))?.path();
        if path.join("paper.toml").is_file() {
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
    let papers: Vec<Paper> = slugs
        .iter()
        .map(|slug| {
            let read = |name: &str| -> Result<Arc<Source>, LoadError> {
                let path = folder.join(slug).join(name);
                let text = std::fs::read_to_string(&path).map_err(|e| unreadable(&path, &e))?;
                Ok(Arc::new(Source {
                    name: format!("{slug}/{name}"),
                    text,
                }))
            };
            paper(read)
        })
        .collect::<Result<_, _>>()?;
    check_uses(&papers)?;
    Ok(papers)
}

/// Fails when a claim rests on one that no paper of the folder states.
fn check_uses(papers: &[Paper]) -> Result<(), LoadError> {
    let claims = || papers.iter().flat_map(|paper| &paper.claims);
    let ids: BTreeSet<&str> = claims()
        .map(|claim| claim.entry.id.get_ref().as_str())
        .collect();
    for claim in claims() {
        for used in &claim.entry.uses {
            if !ids.contains(used.get_ref().as_str()) {
                let message = format!("no claim has the id `{}`", used.get_ref());
                let help = "`uses` takes full ids, such as `gbt-developable/eq-2.2`";
                let origin = Origin::of(&claim.origin.source, used);
                return Err(LoadError::Derivation(Box::new(
                    DerivationError::at(&origin, whole(used), message).with_help(help),
                )));
            }
        }
    }
    Ok(())
}

/// Loads one paper through `read`, which returns a file of its folder.
pub fn paper(read: impl Fn(&str) -> Result<Arc<Source>, LoadError>) -> Result<Paper, LoadError> {
    let source = read("paper.toml")?;
    let file: PaperFile = toml_file(&source)?;
    let mut declarations = Declarations::default();
    declarations.add_symbols(&source, &file.symbols)?;
    declarations.add_bases(&source, &file.basis)?;
    add_definitions(&mut declarations, &source, &file.define)?;
    let declarations = Arc::new(declarations);
    let mut claims = vec![];
    let mut own_figures = vec![];
    for name in &file.paper.claims {
        let source = read(name.get_ref())?;
        let (more, figures) = claims_of(&source, &declarations, &file.paper.id)?;
        claims.extend(more);
        own_figures.extend(figures);
    }
    let mut seen: BTreeMap<&str, ()> = BTreeMap::new();
    for claim in &claims {
        if seen.insert(claim.entry.id.get_ref(), ()).is_some() {
            return Err(wrong(
                &claim.origin,
                format!("the id `{}` is used twice", claim.entry.id.get_ref()),
            ));
        }
    }
    for figure in &own_figures {
        if seen.insert(&figure.id, ()).is_some() {
            let message = format!("the id `{}` is used twice", figure.id);
            return Err(wrong(&figure.origin, message));
        }
    }
    Ok(Paper {
        head: file.paper,
        declarations,
        claims,
        own_figures,
    })
}

fn claims_of(
    source: &Arc<Source>,
    paper: &Arc<Declarations>,
    slug: &str,
) -> Result<(Vec<Claim>, Vec<Figure>), LoadError> {
    let file: ClaimsFile = toml_file(source)?;
    let mut shared = (**paper).clone();
    shared.add_symbols(source, &file.symbols)?;
    shared.add_bases(source, &file.basis)?;
    add_definitions(&mut shared, source, &file.define)?;
    let shared = Arc::new(shared);
    let mut claims: Vec<Claim> = file
        .claim
        .iter()
        .map(|entry| claim(source, &shared, slug, entry))
        .collect::<Result<_, _>>()?;
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
    let figures = file
        .figure
        .into_iter()
        .map(|entry| own_figure(source, &shared, slug, entry))
        .collect::<Result<_, _>>()?;
    Ok((claims, figures))
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
) -> Result<Figure, LoadError> {
    let range = entry.span();
    let entry = entry.into_inner();
    let Some(id) = entry.id.clone() else {
        let origin = Origin::range(source, range.start, range.end);
        let message = "a figure of its own needs an `id`".to_owned();
        return Err(wrong(&origin, message));
    };
    let origin = Origin::of(source, &id);
    if !id.get_ref().starts_with(&format!("{slug}/")) {
        return Err(wrong(&origin, format!("the id must begin with `{slug}/`")));
    }
    let claims = entry.claims.iter().map(|c| c.get_ref().clone()).collect();
    figure(source, origin, shared, id.into_inner(), claims, entry)
}

fn figure(
    source: &Arc<Source>,
    origin: Origin,
    shared: &Arc<Declarations>,
    id: String,
    claims: Vec<String>,
    entry: FigureEntry,
) -> Result<Figure, LoadError> {
    let mut declarations = (**shared).clone();
    declarations.add_symbols(source, &entry.symbols)?;
    add_definitions(&mut declarations, source, &entry.local)?;
    Ok(Figure {
        id,
        claims,
        entry,
        origin,
        source: Arc::clone(source),
        declarations: Arc::new(declarations),
    })
}

fn claim(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    slug: &str,
    entry: &Spanned<ClaimEntry>,
) -> Result<Claim, LoadError> {
    let entry = entry.get_ref().clone();
    let origin = Origin::of(source, &entry.id);
    if !entry.id.get_ref().starts_with(&format!("{slug}/")) {
        return Err(wrong(&origin, format!("the id must begin with `{slug}/`")));
    }
    let declarations = if entry.symbols.is_empty() && entry.local.is_empty() {
        Arc::clone(shared)
    } else {
        let mut own = (**shared).clone();
        own.add_symbols(source, &entry.symbols)?;
        add_definitions(&mut own, source, &entry.local)?;
        Arc::new(own)
    };
    let all = |texts: &[Spanned<String>]| -> Result<Vec<Written>, LoadError> {
        texts.iter().map(|text| written(source, text)).collect()
    };
    let statement = entry
        .states
        .as_ref()
        .map(|text| written(source, text))
        .transpose()?;
    let undecidable = entry.underspecified.is_some() || entry.out_of_scope.is_some();
    let needs_statement = !matches!(
        entry.kind,
        crate::words::Kind::Definition | crate::words::Kind::Figure
    ) && !undecidable;
    if needs_statement && statement.is_none() {
        return Err(LoadError::Derivation(Box::new(
            DerivationError::at(
                &origin,
                whole(&entry.id),
                "this claim states nothing: the field `states` is missing",
            )
            .with_help(
                "add `states = '...'`, or say why not with `underspecified` or `out_of_scope`",
            ),
        )));
    }
    let drawn = match &entry.figure {
        None => None,
        Some(drawn) => {
            let id = entry.id.get_ref();
            let (origin, claims) = (origin.clone(), vec![id.clone()]);
            let drawn = (**drawn).clone();
            Some(figure(
                source,
                origin,
                &declarations,
                id.clone(),
                claims,
                drawn,
            )?)
        }
    };
    if entry.given.is_empty() != entry.solve_for.is_empty() {
        return Err(wrong(
            &origin,
            "`given` and `solve_for` go together".to_owned(),
        ));
    }
    Ok(Claim {
        given: all(&entry.given)?,
        unknowns: all(&entry.solve_for)?,
        assumptions: all(&entry.assume)?,
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

/// Parses a text of a file.
pub fn written(source: &Arc<Source>, text: &Spanned<String>) -> Result<Written, LoadError> {
    Ok(parsed(source, text)?)
}

/// Parses a text of a file that is being evaluated.
pub fn parsed(
    source: &Arc<Source>,
    text: &Spanned<String>,
) -> Result<Written, Box<DerivationError>> {
    let origin = Origin::of(source, text);
    match parse(text.get_ref()) {
        Ok(expr) => Ok(Written { expr, origin }),
        Err(error) => Err(Box::new(DerivationError::syntax(&origin, &error))),
    }
}

/// Parses definitions: the key is a name or a head `F(z, mu)`.
fn add_definitions(
    declarations: &mut Declarations,
    source: &Arc<Source>,
    table: &BTreeMap<String, Spanned<String>>,
) -> Result<(), LoadError> {
    use crate::syntax::Node;
    for (head, text) in table {
        let body = written(source, text)?;
        let bad_head = || {
            wrong(
                &body.origin,
                format!("`{head}` is no name and no head such as `F(z, mu)`"),
            )
        };
        let (name, parameters) = match parse(head).map_err(|_| bad_head())?.node {
            Node::Name(name) => (name, vec![]),
            Node::Call(function, arguments) => {
                let parameters = arguments.into_iter().map(|a| match a.node {
                    Node::Name(parameter) => Ok(parameter),
                    _ => Err(bad_head()),
                });
                match &function.node {
                    Node::Name(name) => (name.clone(), parameters.collect::<Result<_, _>>()?),
                    _ => return Err(bad_head()),
                }
            }
            _ => return Err(bad_head()),
        };
        declarations.define(name, Definition { parameters, body });
    }
    Ok(())
}

/// Reads a TOML file into its schema, with the place of a mistake.
fn toml_file<T: serde::de::DeserializeOwned>(source: &Arc<Source>) -> Result<T, LoadError> {
    toml::from_str(&source.text).map_err(|error| {
        let range = error.span().unwrap_or(0..0);
        let origin = Origin::range(
            source,
            range.start,
            range.end.max(range.start + 1).min(source.text.len()),
        );
        LoadError::Derivation(Box::new(DerivationError::at(
            &origin,
            crate::syntax::Place::default(),
            error.message().to_owned(),
        )))
    })
}
