//! The document model: what a report says about one paper, ready to be laid out.
//!
//! Every output is laid out from this one model, so PDF and HTML cannot disagree. It holds strings and
//! indices only. Strings are cleared of characters that act on the text around them; they
//! are never read as markup by any output. Formulas are kept in one list and referred to by position,
//! so that an output can set them all in one go.

use crate::FigureImage;
use crate::edit::{self, Stretch};
use crate::findings::{self, Finding};
use crate::rests::{Rests, rests};
use crate::tally::Tally;
use crate::text::{anchor, counted, name, plain, section_rank, section_title, visible};
use crate::words::{self, Term};
use serde::Serialize;
use std::collections::BTreeMap;
use torse_language::notation::Formula;
use torse_language::words::Verdict;
use torse_prove::Witness;
use torse_verdicts::consequences::consequences;
use torse_verdicts::outcome::{ReadingOutcome, Role};
use torse_verdicts::{Correction, DataCorrection, Outcome, PaperOutcome};

/// What a report says about one paper.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The paper's slug.
    pub slug: String,
    /// The title.
    pub title: String,
    /// The authors.
    pub authors: String,
    /// Where it appeared.
    pub venue: String,
    /// How many claims have which verdict and evidence.
    pub tally: Tally,
    /// What was found out, in plain words.
    pub findings: Vec<Finding>,
    /// How many verdicts differ from what the derivation files expect.
    pub unexpected: usize,
    /// The claims by section of the paper, in the order of the paper.
    pub sections: Vec<Section>,
    /// The pictures; their position is the number that readers see, less one.
    pub figures: Vec<FigureView>,
    /// Positions of the pictures that illustrate no claim of this paper.
    pub further_figures: Vec<usize>,
    /// All formulas, Typst mathematics; a [`FormulaView`] refers to its own by position.
    pub formulas: Vec<String>,
}

/// The claims of one section of the paper.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Section {
    /// The heading, for instance `Section 3`.
    pub title: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// The claims, in file order.
    pub claims: Vec<ClaimView>,
}

/// One claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClaimView {
    /// The id of the inventory.
    pub id: String,
    /// The id without the paper's slug.
    pub name: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// Where the paper says it.
    pub at: String,
    /// The kind of statement.
    pub kind: Term,
    /// What is true of it.
    pub verdict: Term,
    /// What that rests on.
    pub evidence: Option<Term>,
    /// What the derivation file expects, where that is something else.
    pub expected: Option<Term>,
    /// The statement as printed.
    pub printed: String,
    /// How our copy of the text was read.
    pub reading: Option<String>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// The assumptions, as understood.
    pub assumed: Vec<FormulaView>,
    /// What was found, in words.
    pub finding: Option<String>,
    /// What in the finding may be a confusion of the copy at hand.
    pub garbled: Option<String>,
    /// What the statement rests on, in small print.
    pub rests: Vec<Rests>,
    /// Of a sentence with more than one reading: each of them.
    pub readings: Vec<ReadingView>,
    /// Extra conditions.
    pub conditions: Vec<FormulaView>,
    /// A proved correction.
    pub correction: Option<CorrectionView>,
    /// A change of printed data that explains a wrong value, line by line.
    pub data: Vec<String>,
    /// The derived right side.
    pub derived: Option<FormulaView>,
    /// Left side minus right side.
    pub difference: Option<FormulaView>,
    /// A counterexample; decimals are empty where the exact value is as easy to read.
    pub witness: Option<Witness>,
    /// Of a claim that denies what is so: that it is so everywhere, as a sentence.
    pub denied: Option<String>,
    /// The steps of the decision; equal ones in a row are counted.
    pub steps: Vec<String>,
    /// Anything a reader should know.
    pub note: Option<String>,
    /// What it rests on.
    pub uses: Vec<Reference>,
    /// What rests on it directly, unless it is refuted.
    pub used_by: Vec<Reference>,
    /// Of a refuted claim, what rests on it, nearest first, and whether that survives.
    pub consequences: Vec<ConsequenceView>,
    /// How many claims rest on it through others only, and survive, in words: counted, not listed.
    pub distant_survivors: Option<String>,
    /// Positions of the pictures shown here.
    pub figures: Vec<usize>,
    /// Positions of the pictures that illustrate it and are shown elsewhere.
    pub see_figures: Vec<usize>,
    /// The command that reproduces the verdict.
    pub command: String,
}

/// One reading of a sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReadingView {
    /// A word for it.
    pub name: String,
    /// The sentence as it is read here, in words.
    pub says: String,
    /// What is true of it.
    pub verdict: Term,
    /// What that rests on.
    pub evidence: Option<Term>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// Its assumptions.
    pub assumed: Vec<FormulaView>,
    /// Extra conditions.
    pub conditions: Vec<FormulaView>,
    /// The point at which it fails, in words.
    pub fails_at: Option<String>,
    /// What it rests on, in small print.
    pub rests: Vec<Rests>,
}

/// A formula: its plain text, and where [`Report::formulas`] has its mathematics.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FormulaView {
    /// The notation of the derivation files, shown where the mathematics cannot be set.
    pub text: String,
    /// The position in [`Report::formulas`].
    pub math: usize,
}

/// A proved correction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CorrectionView {
    /// The corrected statement.
    pub statement: FormulaView,
    /// From the statement as understood to the corrected one, in plain notation.
    pub marked: Vec<Stretch>,
    /// What was changed, and the conditions, one entry each.
    pub edits: Vec<String>,
    /// Whether no other repair with as few edits was found.
    pub unique: bool,
}

/// A claim that rests on a refuted one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ConsequenceView {
    /// The claim.
    pub claim: Reference,
    /// What becomes of it, in words.
    pub fate: String,
    /// The claim in between that it rests on, if it does not rest on the refuted one itself.
    pub through: Option<Reference>,
}

/// A mention of another claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reference {
    /// The claim's id.
    pub id: String,
    /// What a reader sees: the name without the slug for a claim of the same paper.
    pub shown: String,
    /// Its identifier for links, if this report has it.
    pub anchor: Option<String>,
}

/// A picture as the report shows it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FigureView {
    /// The name of its file in the typesetter's world.
    pub file: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// The caption.
    pub caption: String,
    /// What it shows, in words.
    pub alt: String,
    /// Whether it was redrawn from printed data alone.
    pub verdict: Term,
    /// What was filled with a default.
    pub assumes: Vec<String>,
    /// What was replaced by data of our own.
    pub stand_in: Vec<String>,
}

impl Report {
    /// The report of `paper`, with pictures.
    #[must_use]
    pub fn new(paper: &PaperOutcome, figures: &[FigureImage]) -> Self {
        let mut builder = Builder::new(paper, figures);
        let mut sections: Vec<Section> = Vec::new();
        for (position, outcome) in paper.claims.iter().enumerate() {
            let claim = builder.claim(position, outcome);
            let title = section_title(&claim.at);
            match sections.iter_mut().find(|section| section.title == title) {
                Some(section) => section.claims.push(claim),
                None => sections.push(Section {
                    title,
                    anchor: String::new(),
                    claims: vec![claim],
                }),
            }
        }
        sections.sort_by_key(|section| section_rank(&section.title));
        for (section, number) in sections.iter_mut().zip(1..) {
            section.anchor = format!("section-{number}");
        }
        Report {
            slug: visible(&paper.slug),
            title: visible(&paper.title),
            authors: visible(&paper.authors),
            venue: visible(&paper.venue),
            tally: Tally::new(&paper.claims),
            findings: findings::of(&paper.claims, &builder.anchors),
            unexpected: paper
                .claims
                .iter()
                .filter(|claim| !claim.as_expected())
                .count(),
            sections,
            figures: figures.iter().enumerate().map(figure_view).collect(),
            further_figures: builder.further_figures(),
            formulas: builder.formulas,
        }
    }

    /// The claims, section by section.
    pub fn claims(&self) -> impl Iterator<Item = &ClaimView> {
        self.sections.iter().flat_map(|section| &section.claims)
    }
}

/// The name under which the typesetter finds picture number `position`.
pub(crate) fn figure_file(position: usize, image: &FigureImage) -> String {
    format!("figure-{position}.{}", image.image.extension())
}

fn figure_view((position, image): (usize, &FigureImage)) -> FigureView {
    FigureView {
        file: figure_file(position, image),
        anchor: format!("figure-{}", position + 1),
        caption: visible(&image.caption),
        alt: visible(&image.alt),
        verdict: words::verdict(image.verdict),
        assumes: image.assumes.iter().map(|of| visible(of)).collect(),
        stand_in: image.stand_in.iter().map(|of| visible(of)).collect(),
    }
}

struct Builder<'a> {
    paper: &'a PaperOutcome,
    figures: &'a [FigureImage],
    /// One identifier for each claim, by position; where ids differ in signs only, a number is added.
    anchors: Vec<String>,
    by_id: BTreeMap<&'a str, usize>,
    formulas: Vec<String>,
}

impl<'a> Builder<'a> {
    fn new(paper: &'a PaperOutcome, figures: &'a [FigureImage]) -> Self {
        let mut by_id = BTreeMap::new();
        let mut anchors: Vec<String> = Vec::new();
        for (position, claim) in paper.claims.iter().enumerate() {
            by_id.entry(claim.id.as_str()).or_insert(position);
            let mut name = format!("claim-{}", anchor(name(&claim.id)));
            while anchors.contains(&name) {
                name.push_str(&format!("-{}", position + 1));
            }
            anchors.push(name);
        }
        Builder {
            paper,
            figures,
            anchors,
            by_id,
            formulas: Vec::new(),
        }
    }

    fn claim(&mut self, position: usize, outcome: &Outcome) -> ClaimView {
        let (here, elsewhere) = self.figures_of(position, &outcome.id);
        let refuted = matches!(outcome.verdict, Verdict::False | Verdict::Misprint);
        let (consequences, distant_survivors) = match refuted {
            true => self.consequences(&outcome.id),
            false => (Vec::new(), None),
        };
        ClaimView {
            id: visible(&outcome.id),
            name: visible(name(&outcome.id)),
            anchor: self.anchors.get(position).cloned().unwrap_or_default(),
            at: visible(&outcome.at),
            kind: words::kind(outcome.kind),
            verdict: words::verdict_on(outcome),
            evidence: words::evidence_on(outcome),
            expected: outcome
                .expect
                .filter(|of| *of != outcome.verdict)
                .map(words::verdict),
            printed: visible(&outcome.printed),
            reading: outcome.reading.as_deref().map(visible),
            parsed: outcome.parsed.as_ref().map(|formula| self.formula(formula)),
            assumed: self.assumed(outcome),
            finding: outcome.finding.as_deref().map(|told| visible(&plain(told))),
            garbled: outcome.garbled.as_deref().map(visible),
            rests: cleared(rests(outcome)),
            readings: self.readings(outcome),
            conditions: self.conditions(&outcome.conditions),
            correction: outcome
                .correction
                .as_ref()
                .map(|repair| self.correction(outcome.parsed.as_ref(), repair)),
            data: (outcome.data.iter())
                .flat_map(DataCorrection::in_words)
                .map(|line| visible(&line))
                .collect(),
            derived: outcome
                .derived
                .as_ref()
                .map(|formula| self.derived(formula)),
            difference: outcome
                .difference
                .as_ref()
                .map(|formula| self.derived(formula)),
            witness: outcome.witness.as_ref().map(witness),
            denied: findings::denied(outcome).map(|text| visible(&text)),
            steps: counted(&outcome.steps)
                .iter()
                .map(|step| visible(step.strip_suffix('.').unwrap_or(step)))
                .collect(),
            note: outcome.note.as_deref().map(visible),
            uses: outcome.uses.iter().map(|id| self.reference(id)).collect(),
            used_by: match refuted {
                true => Vec::new(),
                false => self.used_by(&outcome.id),
            },
            consequences,
            distant_survivors,
            figures: here,
            see_figures: elsewhere,
            command: format!("torse explain {}", visible(&outcome.id)),
        }
    }

    fn assumed(&mut self, outcome: &Outcome) -> Vec<FormulaView> {
        let assumed = outcome.assumed.iter();
        let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
        assumed.map(|h| self.formula(&h.formula)).collect()
    }

    fn readings(&mut self, outcome: &Outcome) -> Vec<ReadingView> {
        let view = |reading: &ReadingOutcome| {
            let of = &reading.outcome;
            ReadingView {
                name: visible(&reading.name),
                says: visible(&reading.says),
                verdict: words::verdict_on(of),
                evidence: words::evidence_on(of),
                parsed: of.parsed.as_ref().map(|formula| self.formula(formula)),
                assumed: self.assumed(of),
                conditions: self.conditions(&of.conditions),
                fails_at: of.witness.as_ref().map(|w| visible(&findings::fails_at(w))),
                rests: cleared(rests(of)),
            }
        };
        outcome.readings.iter().map(view).collect()
    }

    fn conditions(&mut self, conditions: &[Formula]) -> Vec<FormulaView> {
        let view = |condition| self.derived(condition);
        conditions.iter().map(view).collect()
    }

    /// A formula that the engine derived: a long one is counted.
    fn derived(&mut self, formula: &Formula) -> FormulaView {
        let Some(words) = words::long(&formula.text) else {
            return self.formula(formula);
        };
        // A string in quotes is text in the mathematics of the typesetter.
        self.formulas
            .push(format!("\"{}\"", words.replace('`', "")));
        FormulaView {
            text: words,
            math: self.formulas.len() - 1,
        }
    }

    fn formula(&mut self, formula: &Formula) -> FormulaView {
        self.formulas.push(visible(&formula.typst));
        FormulaView {
            text: visible(&formula.text),
            math: self.formulas.len() - 1,
        }
    }

    fn correction(&mut self, parsed: Option<&Formula>, repair: &Correction) -> CorrectionView {
        let before = parsed.map_or(String::new(), |formula| visible(&formula.text));
        CorrectionView {
            marked: edit::stretches(&before, &visible(&repair.statement.text)),
            statement: self.formula(&repair.statement),
            edits: repair.in_words().iter().map(|line| visible(line)).collect(),
            unique: repair.unique,
        }
    }

    fn reference(&self, id: &str) -> Reference {
        let anchor = self
            .by_id
            .get(id)
            .and_then(|position| self.anchors.get(*position))
            .cloned();
        let shown = if anchor.is_some() { name(id) } else { id };
        Reference {
            id: visible(id),
            shown: visible(shown),
            anchor,
        }
    }

    fn used_by(&self, id: &str) -> Vec<Reference> {
        let claims = self.paper.claims.iter();
        let users = claims.filter(|claim| claim.uses.iter().any(|used| used == id));
        users.map(|claim| self.reference(&claim.id)).collect()
    }

    /// What rests on a claim: all that does so directly, and of the rest what does not survive; then the
    /// number of those left out, in words.
    fn consequences(&self, id: &str) -> (Vec<ConsequenceView>, Option<String>) {
        let claims: Vec<&Outcome> = self.paper.claims.iter().collect();
        let found = consequences(id, &claims);
        let (distant, listed): (Vec<_>, Vec<_>) = found
            .iter()
            .partition(|of| !of.through.is_empty() && of.fate.survives());
        let views = listed.into_iter().map(|of| ConsequenceView {
            claim: self.reference(&of.id),
            fate: visible(&words::consequence(of)),
            through: of.through.last().map(|id| self.reference(id)),
        });
        let told = (!distant.is_empty()).then(|| words::distant_survivors(distant.len()));
        (views.collect(), told)
    }

    /// The pictures that the claim shows itself, and those that it points to.
    fn figures_of(&self, claim: usize, id: &str) -> (Vec<usize>, Vec<usize>) {
        let illustrating = self.figures.iter().enumerate();
        illustrating
            .filter(|(_, figure)| figure.claims.iter().any(|illustrated| illustrated == id))
            .map(|(position, _)| position)
            .partition(|position| self.shown_at(*position) == Some(claim))
    }

    /// The claim at which a picture is shown: the first in file order of those that it illustrates.
    fn shown_at(&self, figure: usize) -> Option<usize> {
        let claims = self.figures.get(figure)?.claims.iter();
        claims
            .filter_map(|id| self.by_id.get(id.as_str()))
            .min()
            .copied()
    }

    fn further_figures(&self) -> Vec<usize> {
        (0..self.figures.len())
            .filter(|figure| self.shown_at(*figure).is_none())
            .collect()
    }
}

/// The lines without characters that act on the text around them.
fn cleared(groups: Vec<Rests>) -> Vec<Rests> {
    let lines = |lines: Vec<String>| lines.iter().map(|line| visible(line)).collect();
    let group = |of: Rests| Rests {
        label: of.label,
        lines: lines(of.lines),
    };
    groups.into_iter().map(group).collect()
}

fn witness(of: &Witness) -> Witness {
    Witness {
        at: of
            .at
            .iter()
            .map(|(name, value)| (visible(name), visible(value)))
            .collect(),
        left: visible(&of.left),
        right: visible(&of.right),
        left_decimal: told_anew(&of.left, &of.left_decimal),
        right_decimal: told_anew(&of.right, &of.right_decimal),
    }
}

/// The decimals, unless the exact value is as easy to read: made of integers.
fn told_anew(exact: &str, decimal: &str) -> String {
    let integers = exact
        .chars()
        .all(|c| c.is_ascii_digit() || "-[], ".contains(c));
    match integers {
        true => String::new(),
        false => visible(decimal),
    }
}
