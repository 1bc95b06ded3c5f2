//! The files of a folder that a manuscript proposes.

use crate::document::{Manuscript, ManuscriptItem};
use crate::meaning::{Meaning, Meanings, Unread, condition_text};
use crate::symbols::{integers, interval, name_of, stated, symbols};
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::latex::{LatexCondition, LatexStatement};
use torse_syntax::notation::text;

/// The proposed files, and what a person has to look at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposal {
    /// `paper.toml`: bibliography, symbols, bases, definitions.
    pub paper: String,
    /// `claims.toml`: a claim for each numbered or theorem-like item.
    pub claims: String,
    /// How many items have a proposed statement, or are definitions that were read.
    pub stated: usize,
    /// How many items have several readings, or words whose formulas are listed.
    pub to_choose: usize,
    /// How many formulas without a number state something: they are listed behind the claims.
    pub unnumbered: usize,
    /// What is not understood.
    pub unread: Vec<Unread>,
}

/// Proposes derivation files for a manuscript; `slug` is the name of the folder.
#[must_use]
pub fn propose(manuscript: &Manuscript, slug: &str) -> Proposal {
    propose_without(manuscript, slug, &BTreeMap::new())
}

/// Proposes derivation files in which the claims of these ids have no statement, for the reasons that are given: their formulas make no
/// sense with the symbols of the proposal.
#[must_use]
pub fn propose_without(
    manuscript: &Manuscript,
    slug: &str,
    refused: &BTreeMap<String, String>,
) -> Proposal {
    let meanings = Meanings::from_manuscript(manuscript);
    let (declared, unknown) = symbols(&meanings);
    let mut writer = Writer {
        manuscript,
        meanings: &meanings,
        unknown,
        slug,
        refused,
        ids: BTreeSet::new(),
        stated: 0,
        to_choose: 0,
        unread: meanings.unread.clone(),
    };
    let claims: Vec<String> = manuscript
        .items
        .iter()
        .map(|item| writer.claim(item))
        .collect();
    let mut paper = format!(
        "# Proposed from a manuscript. Read every line: what the symbols mean, and whether the definitions are the paper's.\n\n[paper]\nid = {}\ntitle = {}\nauthors = {}\nvenue = \"\"\nclaims = [\"claims.toml\"]\n",
        quoted(slug),
        quoted(&manuscript.title),
        quoted(&manuscript.authors)
    );
    if !declared.is_empty() {
        paper.push_str("\n[symbols]\n");
    }
    for symbol in &declared {
        paper.push_str(&format!(
            "{} = {} # {}\n",
            key(&symbol.name),
            symbol.set,
            symbol.comment
        ));
    }
    for (name, (variable, functions)) in &meanings.bases {
        if writer.unknown.contains_key(name) {
            continue;
        }
        let degree = functions.keys().last().copied().unwrap_or(0);
        paper.push_str(&format!(
            "\n[basis.{name}]\nvariable = {}\ndegree = {degree}\nseeds = [\n",
            quoted(variable)
        ));
        if !functions.contains_key(&0) {
            paper.push_str("    '0', # the text begins with index 1\n");
        }
        for body in functions.values() {
            paper.push_str(&format!("    {},\n", quoted(&text(body))));
        }
        paper.push_str("]\n");
    }
    let definitions: Vec<_> = meanings
        .definitions
        .iter()
        .filter(|(head, _, _)| !writer.unknown.contains_key(name_of(head)))
        .collect();
    if !definitions.is_empty() {
        paper.push_str("\n[define]\n");
    }
    for (head, body, line) in definitions {
        paper.push_str(&format!(
            "{} = {} # line {line}\n",
            key(head),
            quoted(&text(body))
        ));
    }
    let printed = meanings
        .names
        .kinds()
        .filter_map(|(name, _)| Some((name, meanings.names.printed(name)?)));
    let used = |name: &str| {
        declared.iter().any(|symbol| symbol.name == name)
            || meanings
                .definitions
                .iter()
                .any(|(head, _, _)| name_of(head) == name && !writer.unknown.contains_key(name))
    };
    let printed: Vec<_> = printed.filter(|(name, _)| used(name)).collect();
    if !printed.is_empty() {
        paper.push_str("\n[display]\n");
    }
    for (name, latex) in printed {
        paper.push_str(&format!(
            "{} = {}\n",
            key(name),
            quoted(&format!("${latex}$"))
        ));
    }
    let unnumbered = writer.unnumbered();
    let mut unread = writer.unread.clone();
    unread.sort_by_key(|unread| (unread.line, unread.column));
    unread.dedup();
    let mut text = "# One claim for each numbered or theorem-like item. A statement is proposed where the print has one meaning; where a comment lists several, choose one.\n".to_owned();
    for claim in claims {
        text.push_str(&claim);
    }
    if !unnumbered.is_empty() {
        text.push_str("\n# Formulas without a number, which are no claims. Make a claim of each that is to be decided:\n");
    }
    for line in &unnumbered {
        text.push_str(line);
    }
    if !unread.is_empty() {
        text.push_str("\n# Not understood, by line and column of the manuscript:\n");
    }
    for unread in &unread {
        text.push_str(&format!(
            "# {}:{} {}: {}\n",
            unread.line,
            unread.column,
            one_line(&unread.why),
            one_line(&unread.print)
        ));
    }
    Proposal {
        paper,
        claims: text,
        stated: writer.stated,
        to_choose: writer.to_choose,
        unnumbered: unnumbered.len(),
        unread,
    }
}

struct Writer<'m> {
    manuscript: &'m Manuscript,
    meanings: &'m Meanings,
    unknown: BTreeMap<String, String>,
    slug: &'m str,
    refused: &'m BTreeMap<String, String>,
    ids: BTreeSet<String>,
    stated: usize,
    to_choose: usize,
    unread: Vec<Unread>,
}

impl Writer<'_> {
    /// A name of a formula that cannot be declared, with the reason.
    fn undeclared(&self, formula: &Expr) -> Option<String> {
        let name = formula
            .names()
            .into_iter()
            .map(|name| name.trim_end_matches('\''))
            .find(|name| self.unknown.contains_key(*name))?;
        Some(format!("`{name}`: {}", self.unknown.get(name)?))
    }

    /// Formulas that no claim has, as comments; what defines a name that cannot be used is listed as not understood.
    fn unnumbered(&mut self) -> Vec<String> {
        let items = self.manuscript.items.iter();
        let claimed: BTreeSet<usize> = items.flat_map(|item| item.formulas.clone()).collect();
        let mut lines = vec![];
        let formulas = self.manuscript.formulas.iter().zip(&self.meanings.formulas);
        for (at, (formula, meaning)) in formulas.enumerate() {
            if claimed.contains(&at) {
                continue;
            }
            let (line, column) = self.manuscript.line_and_column(formula.place.start);
            if let Some(why) = self.undefined(meaning) {
                self.unread.push(Unread {
                    line,
                    column,
                    why,
                    print: formula.latex.clone(),
                });
                continue;
            }
            let listed = match meaning {
                Meaning::States {
                    formula,
                    conditions,
                }
                | Meaning::Defines {
                    states: Some(formula),
                    conditions,
                    ..
                } => format!(
                    "# states = {}{}\n",
                    quoted(&text(formula)),
                    assumptions(conditions)
                ),
                Meaning::Ambiguous { first, others } => readings(first, others),
                _ => continue,
            };
            lines.push(format!(
                "# line {line}: {}\n{listed}",
                one_line(&formula.latex)
            ));
        }
        lines
    }

    /// Why none of the names that a formula defines can be used, if so.
    fn undefined(&self, meaning: &Meaning) -> Option<String> {
        let Meaning::Defines { names, .. } = meaning else {
            return None;
        };
        names.iter().find_map(|name| {
            let name = name_of(name);
            Some(format!("`{name}`: {}", self.unknown.get(name)?))
        })
    }

    /// An id from the label or the number that no claim has.
    fn id(&mut self, item: &ManuscriptItem) -> String {
        let kind = if item.kind == "equation" {
            "eq"
        } else {
            &item.kind
        };
        let wanted = match (&item.label, &item.number) {
            (Some(label), _) => label.clone(),
            (None, Some(number)) => format!("{kind}-{number}"),
            (None, None) => kind.to_owned(),
        };
        let plain: String = wanted
            .chars()
            .map(|c| {
                if c.is_ascii_alphanumeric() {
                    c.to_ascii_lowercase()
                } else {
                    '-'
                }
            })
            .collect();
        let words: Vec<&str> = plain.split('-').filter(|word| !word.is_empty()).collect();
        let base = match words.is_empty() {
            true => "item".to_owned(),
            false => words.join("-"),
        };
        let mut id = base.clone();
        let mut count = 1;
        while !self.ids.insert(id.clone()) {
            count += 1;
            id = format!("{base}-{count}");
        }
        format!("{}/{id}", self.slug)
    }

    fn claim(&mut self, item: &ManuscriptItem) -> String {
        let id = self.id(item);
        let place = match (&item.number, item.kind.as_str()) {
            (Some(number), "equation") => format!("eq. ({number})"),
            (Some(number), kind) => format!("{kind} {number}"),
            (None, kind) => kind.to_owned(),
        };
        let at = match item.section.is_empty() || item.kind == "equation" {
            true => place,
            false => format!("Section {}, {place}", item.section),
        };
        let (line, _) = self.manuscript.line_and_column(item.place.start);
        let mut claim = format!("\n# line {line}\n");
        let body = if let Some(why) = self.refused.get(&id) {
            self.refused(item, &mut claim, why)
        } else if item.kind == "equation" {
            self.equation(item, &mut claim)
        } else {
            self.sentence(item, &mut claim)
        };
        claim.push_str(&format!(
            "[[claim]]\nid = {}\nat = {}\nkind = \"{}\"\nprinted = {}\n{}",
            quoted(&id),
            quoted(&at),
            body.kind,
            quoted(&item.printed),
            body.fields
        ));
        claim
    }

    /// The fields of an equation whose formula makes no sense with the proposed symbols.
    fn refused(&mut self, item: &ManuscriptItem, comments: &mut String, why: &str) -> Fields {
        for at in &item.formulas {
            let (Some(formula), Some(meaning)) = (
                self.manuscript.formulas.get(*at),
                self.meanings.formulas.get(*at),
            ) else {
                continue;
            };
            comments.push_str(&format!("# {}\n", one_line(&formula.latex)));
            for stated in stated(meaning) {
                comments.push_str(&format!("# states = {}\n", quoted(&text(stated))));
            }
            let (line, column) = self.manuscript.line_and_column(formula.place.start);
            self.unread.push(Unread {
                line,
                column,
                why: why.to_owned(),
                print: formula.latex.clone(),
            });
        }
        Fields::unstated(why)
    }

    /// The fields of a numbered equation.
    fn equation(&mut self, item: &ManuscriptItem, comments: &mut String) -> Fields {
        let mut formulas = item.formulas.iter().filter_map(|at| {
            Some((
                self.manuscript.formulas.get(*at)?,
                self.meanings.formulas.get(*at)?,
            ))
        });
        let Some((formula, meaning)) = formulas.next_back() else {
            return Fields::unstated("there is no formula");
        };
        comments.push_str(&format!("# {}\n", one_line(&formula.latex)));
        let is_clear = !matches!(meaning, Meaning::Ambiguous { .. });
        let undeclared = self.undefined(meaning).or_else(|| {
            let mut stated = stated(meaning).into_iter().filter(|_| is_clear);
            stated.find_map(|formula| self.undeclared(formula))
        });
        if let Some(why) = undeclared {
            let (line, column) = self.manuscript.line_and_column(formula.place.start);
            self.unread.push(Unread {
                line,
                column,
                why: why.clone(),
                print: formula.latex.clone(),
            });
            return Fields::unstated(&why);
        }
        match meaning {
            Meaning::Defines {
                names,
                states: None,
                ..
            } => {
                self.stated += 1;
                comments.push_str(&format!(
                    "# taken for the definition of {}\n",
                    names.join(", ")
                ));
                Fields {
                    kind: "definition",
                    fields: String::new(),
                }
            }
            Meaning::Defines {
                names,
                states: Some(formula),
                conditions,
            } => {
                self.stated += 1;
                comments.push_str(&format!(
                    "# taken for the definition of {}, and a statement\n",
                    names.join(", ")
                ));
                self.statement(formula, conditions)
            }
            Meaning::States {
                formula,
                conditions,
            } => {
                self.stated += 1;
                self.statement(formula, conditions)
            }
            Meaning::Ambiguous { first, others } => {
                self.to_choose += 1;
                comments.push_str(&readings(first, others));
                Fields::unstated("the print has several readings")
            }
            Meaning::Nothing => Fields::unstated("no relation was found"),
            Meaning::Unread(why) => Fields::unstated(why),
        }
    }

    /// The fields of something like a theorem: its formulas are listed, for words say what it states.
    fn sentence(&mut self, item: &ManuscriptItem, comments: &mut String) -> Fields {
        let mut formulas = vec![];
        let mut defines = 0;
        let mut says_more = false;
        for at in &item.formulas {
            let meaning = self.meanings.formulas.get(*at);
            match meaning {
                Some(Meaning::Defines { states: None, .. }) => defines += 1,
                Some(Meaning::Nothing) => {}
                _ => says_more = true,
            }
            match meaning {
                Some(Meaning::States {
                    formula,
                    conditions,
                }) => match self.undeclared(formula) {
                    None => {
                        comments.push_str(&format!(
                            "# states = {}{}\n",
                            quoted(&text(formula)),
                            assumptions(conditions)
                        ));
                        formulas.push(formula);
                    }
                    Some(why) => comments.push_str(&format!(
                        "# {}: {}\n",
                        one_line(&text(formula)),
                        one_line(&why)
                    )),
                },
                Some(Meaning::Ambiguous { first, others }) => {
                    comments.push_str(&readings(first, others));
                    formulas.push(&first.formula);
                }
                Some(Meaning::Defines { names, .. }) => {
                    comments.push_str(&format!("# defines {}\n", names.join(", ")))
                }
                _ => {}
            }
        }
        let is_definition = item.kind == "Definition";
        if is_definition && defines > 0 && !says_more {
            self.stated += 1;
            return Fields {
                kind: "definition",
                fields: String::new(),
            };
        }
        self.to_choose += 1;
        let kind = match is_definition {
            true => "definition",
            false => kind(&formulas),
        };
        Fields {
            kind,
            ..Fields::unstated("choose from the formulas above what the sentence states")
        }
    }

    fn statement(&self, formula: &Expr, conditions: &[LatexCondition]) -> Fields {
        let mut fields = String::new();
        let assume: Vec<String> = conditions
            .iter()
            .filter_map(condition_text)
            .map(|text| quoted(&text))
            .collect();
        if !assume.is_empty() {
            fields.push_str(&format!("assume = [{}]\n", assume.join(", ")));
        }
        let mut own = vec![];
        for condition in conditions {
            match condition {
                LatexCondition::Interval { names, .. } => {
                    for name in names {
                        if self
                            .meanings
                            .ranges
                            .get(name)
                            .is_none_or(|(other, _)| interval(other) != interval(condition))
                        {
                            own.push(format!(
                                "{} = {{ in = \"{}\" }}",
                                key(name),
                                interval(condition).unwrap_or_default()
                            ));
                        }
                    }
                }
                LatexCondition::Integers { name, low, high } => {
                    let same = matches!(self.meanings.ranges.get(name), Some((LatexCondition::Integers { low: a, high: b, .. }, _)) if integers(a, b.as_ref()) == integers(low, high.as_ref()));
                    if !same {
                        own.push(format!("{} = {}", key(name), integers(low, high.as_ref())));
                    }
                }
                LatexCondition::Formula(_) => {}
            }
        }
        if !own.is_empty() {
            fields.push_str(&format!("symbols = {{ {} }}\n", own.join(", ")));
        }
        fields.push_str(&format!("states = {}\n", quoted(&text(formula))));
        let kind = kind(&[formula]);
        Fields { kind, fields }
    }
}

/// The kind of a claim that states these formulas: an identity if there is an equation, for corrections are searched of that kind, an
/// inequality if there are relations of order alone, and a property if there is anything else.
fn kind(formulas: &[&Expr]) -> &'static str {
    let parts = formulas
        .iter()
        .flat_map(|formula| crate::meaning::conjuncts(formula));
    let relations: Option<Vec<Relation>> = parts
        .map(|part| match &part.node {
            Node::Compare(_, rest) => Some(rest.iter().map(|(relation, _)| *relation)),
            _ => None,
        })
        .collect::<Option<Vec<_>>>()
        .map(|all| all.into_iter().flatten().collect());
    let order = [
        Relation::Less,
        Relation::AtMost,
        Relation::Greater,
        Relation::AtLeast,
    ];
    match relations.as_deref() {
        None | Some([]) => "property",
        Some(all) if all.iter().all(|relation| order.contains(relation)) => "inequality",
        Some(all) if all.contains(&Relation::Equal) => "identity",
        Some(_) => "property",
    }
}

struct Fields {
    kind: &'static str,
    fields: String,
}

impl Fields {
    fn unstated(why: &str) -> Self {
        Self {
            kind: "identity",
            fields: format!("unstated = {}\n", quoted(&one_line(why))),
        }
    }
}

/// The readings of a formula as comments.
fn readings(
    first: &LatexStatement,
    others: &[(torse_syntax::latex::LatexDoubt, LatexStatement)],
) -> String {
    let mut lines = String::new();
    let mut add = |says: &str, statement: &LatexStatement| {
        lines.push_str(&format!(
            "# states = {}{} # {says}\n",
            quoted(&text(&statement.formula)),
            assumptions(&statement.conditions)
        ));
    };
    let says: Vec<&str> = others
        .iter()
        .map(|(doubt, _)| doubt.says[0].as_str())
        .collect();
    add(&says.join("; "), first);
    for (doubt, other) in others {
        add(&doubt.says[1], other);
    }
    lines
}

fn assumptions(conditions: &[LatexCondition]) -> String {
    let assume: Vec<String> = conditions
        .iter()
        .filter_map(condition_text)
        .map(|text| quoted(&text))
        .collect();
    match assume.is_empty() {
        true => String::new(),
        false => format!(", assume = [{}]", assume.join(", ")),
    }
}

/// A text without ends of lines.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text as TOML: in single quotes if it can be.
fn quoted(text: &str) -> String {
    let simple = !text.contains('\'') && !text.chars().any(char::is_control);
    match simple {
        true => format!("'{text}'"),
        false => toml::Value::String(one_line(text)).to_string(),
    }
}

/// A key as TOML.
fn key(name: &str) -> String {
    let bare = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    match bare {
        true => name.to_owned(),
        false => format!("\"{}\"", name.replace(['"', '\\'], "")),
    }
}
