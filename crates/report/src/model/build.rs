//! Builds the document model from outcomes.

use super::recurring::{Entries, proof, shared_steps};
use super::{
    ClaimView, ConsequenceView, FigureView, FormulaView, Picture, ReadingView, Reference, Report,
    RestsView, Section, Side, WitnessView,
};
use crate::dependencies::{concerns, describe_source};
use crate::faults::FaultPart;
use crate::glossary;
use crate::names::printed_names;
use crate::source::Source;
use crate::tally::Tally;
use crate::text::{
    anchor, counted, decimal, figure_anchor, figure_number, name, section_rank, section_title,
    visible,
};
use crate::view::{correction, derived, formula};
use crate::{FigureImage, applicability, corrections, findings, letter, sentence, summary_page};
use std::collections::{BTreeMap, BTreeSet};
use torse_prove::Witness;
use torse_syntax::derivation::schema::is_worked;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_typography::{PrintedNames, Prose, Span, in_words, plain, spans};
use torse_verdicts::claim_record::{Assumed, HypothesisSource, Role};
use torse_verdicts::consequences::consequences;
use torse_verdicts::dependencies::Defined;
use torse_verdicts::outcome::ReadingOutcome;
use torse_verdicts::{Outcome, PaperOutcome, words};

impl Report {
    /// Makes the report of `paper`, with pictures.
    #[must_use]
    pub fn new(paper: &PaperOutcome, figures: &[FigureImage]) -> Self {
        Self::with_kernel(paper, figures, &BTreeSet::new())
    }

    /// Makes the report of `paper`, with pictures; `accepted` contains the ids of the claims whose proofs the kernel of
    /// the proof assistant accepted.
    #[must_use]
    pub fn with_kernel(
        paper: &PaperOutcome,
        figures: &[FigureImage],
        accepted: &BTreeSet<String>,
    ) -> Self {
        let builder = Builder::new(paper, figures);
        let steps: Vec<Vec<String>> = paper.claims.iter().map(sentence::own_steps).collect();
        let shared = shared_steps(steps.iter().map(Vec::as_slice));
        let (mut sources, mut recurring) = (Entries::default(), Entries::default());
        let mut sections: Vec<Section> = Vec::new();
        for (position, outcome) in paper.claims.iter().enumerate() {
            let mut claim = builder.claim(position, outcome, accepted);
            claim.sources = numbers(&claim.rests, &mut sources);
            for reading in &mut claim.readings {
                reading.sources = numbers(&reading.rests, &mut sources);
            }
            let own = steps.get(position).map_or(&[][..], Vec::as_slice);
            claim.proof = proof(own, &shared, &mut recurring, &printed_names(outcome));
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
        let faults_of = |part| corrections::corrections(paper, part, &builder.anchors, accepted);
        Report {
            slug: visible(&paper.slug),
            title: visible(&paper.title),
            authors: visible(&paper.authors),
            venue: visible(&paper.venue),
            source: None,
            tally: Tally::new(&paper.claims),
            short: summary_page::summarize(paper),
            constructions: applicability::constructions(paper, &builder.anchors),
            letter: letter::letter(paper, accepted),
            corrections: faults_of(FaultPart::Correction),
            questions: faults_of(FaultPart::Question),
            findings: findings::collect_findings(paper, &builder.anchors),
            unexpected: paper
                .claims
                .iter()
                .filter(|claim| !claim.as_expected())
                .count(),
            sections,
            figures: builder.figure_views(),
            has_neighbours: true,
            picture: picture(figures),
            further_figures: builder.further_figures(),
            notation: notation(&paper.claims),
            sources: sources.into_list(),
            recurring_steps: recurring.into_list(),
        }
    }

    /// Adds the sources to the report.
    #[must_use]
    pub fn from_source(mut self, source: Source) -> Self {
        self.source = Some(source);
        self
    }

    /// Whether the paper is a worked example of ours rather than a publication.
    #[must_use]
    pub fn is_example(&self) -> bool {
        is_worked(&self.authors)
    }

    /// Returns the claims, section by section.
    pub fn claims(&self) -> impl Iterator<Item = &ClaimView> {
        self.sections.iter().flat_map(|section| &section.claims)
    }
}

/// Returns the typesetter's name for picture number `position`.
pub(crate) fn figure_file(position: usize, image: &FigureImage) -> String {
    format!("figure-{position}.{}", image.image.extension())
}

fn figure_view(position: usize, image: &FigureImage, number: String) -> FigureView {
    let names = PrintedNames::default();
    let prose = |text: &String| spans(&visible(text), &names);
    FigureView {
        file: figure_file(position, image),
        anchor: figure_anchor(position + 1),
        number,
        caption: prose(&image.caption),
        alt: visible(&image.alt),
        verdict: glossary::verdict(image.verdict),
        assumes: image.assumes.iter().map(prose).collect(),
        stand_in: image.stand_in.iter().map(prose).collect(),
    }
}

/// Chooses the figure that stands for a paper: one that unrolls, or one that moves, or the first.
fn picture(figures: &[FigureImage]) -> Option<Picture> {
    let unrolls = figures.iter().find(|figure| figure.torse.is_some());
    let moves = || figures.iter().find(|figure| figure.interactive.is_some());
    let figure = unrolls.or_else(moves).or_else(|| figures.first())?;
    Some(Picture {
        file: format!("figures/{}.{}", figure.name, figure.image.extension()),
        alt: visible(&figure.alt),
    })
}

struct Builder<'a> {
    paper: &'a PaperOutcome,
    figures: &'a [FigureImage],
    /// Returns one identifier for each claim, by position; if ids differ in signs only, a number is added.
    anchors: Vec<String>,
    by_id: BTreeMap<&'a str, usize>,
}

impl<'a> Builder<'a> {
    fn new(paper: &'a PaperOutcome, figures: &'a [FigureImage]) -> Self {
        let mut by_id = BTreeMap::new();
        let mut anchors: Vec<String> = Vec::new();
        for (position, claim) in paper.claims.iter().enumerate() {
            by_id.entry(claim.claim.id.as_str()).or_insert(position);
            let mut name = format!("claim-{}", anchor(name(&claim.claim.id)));
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
        }
    }

    fn claim(&self, position: usize, outcome: &Outcome, accepted: &BTreeSet<String>) -> ClaimView {
        let names = printed_names(outcome);
        let prose = |text: &str| spans(&visible(text), &names);
        let option = |text: Option<&str>| text.map(prose);
        let (here, elsewhere) = self.figures_of(position, &outcome.claim.id);
        let refuted = matches!(outcome.verdict(), Verdict::False | Verdict::Misprint);
        let (consequences, distant_survivors) = match refuted {
            true => self.consequences(&outcome.claim.id),
            false => (Vec::new(), None),
        };
        ClaimView {
            id: visible(&outcome.claim.id),
            name: visible(name(&outcome.claim.id)),
            anchor: self.anchors.get(position).cloned().unwrap_or_default(),
            at: visible(&plain(&outcome.claim.at)),
            kind: glossary::kind(outcome.claim.kind),
            verdict: glossary::verdict_on(outcome),
            evidence: glossary::evidence_on(outcome),
            level: glossary::level(outcome, accepted.contains(&outcome.claim.id)),
            expected: outcome
                .claim
                .expect
                .filter(|own| *own != outcome.verdict())
                .map(glossary::verdict),
            words_of: glossary::words_of(outcome.claim.kind),
            printed: prose(&outcome.claim.printed),
            reading: option(outcome.claim.reading.as_deref()),
            parsed: outcome.parsed().map(|own| formula(own, &names)),
            assumed: assumed(outcome, &names),
            finding: option(outcome.claim.author_note.as_deref()),
            garbled: option(outcome.claim.garbled.as_deref()),
            rests: views(outcome, &names),
            sources: Vec::new(),
            readings: outcome.readings().iter().map(reading).collect(),
            conditions: conditions(outcome.conditions(), &names),
            correction: outcome
                .correction()
                .map(|repair| correction(outcome.parsed(), repair, &names)),
            data: (outcome.data().into_iter())
                .flat_map(words::data_correction)
                .map(|line| prose(&line))
                .collect(),
            derived: outcome.derived().map(|own| derived(own, &names)),
            difference: (outcome.difference())
                .filter(|difference| outcome.derived() != Some(difference))
                .map(|own| derived(own, &names)),
            witness: outcome.witness().map(|own| witness(own, &names)),
            denied: sentence::denied(outcome).map(|text| prose(&text)),
            steps: counted(&words::steps(outcome))
                .iter()
                .map(|step| prose(step.strip_suffix('.').unwrap_or(step)))
                .collect(),
            proof: Vec::new(),
            note: option(outcome.claim.note.as_deref()),
            uses: outcome
                .claim
                .uses
                .iter()
                .map(|id| self.reference(id))
                .collect(),
            used_by: match refuted {
                true => Vec::new(),
                false => self.used_by(&outcome.claim.id),
            },
            consequences,
            distant_survivors,
            figures: here,
            see_figures: elsewhere,
            command: format!("torse explain {}", visible(&outcome.claim.id)),
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
        let users = claims.filter(|outcome| outcome.claim.uses.iter().any(|used| used == id));
        users
            .map(|outcome| self.reference(&outcome.claim.id))
            .collect()
    }

    /// Returns the dependents of a claim: all direct ones, and the indirect ones that do not survive; then the number
    /// of those left out, in words.
    fn consequences(&self, id: &str) -> (Vec<ConsequenceView>, Option<String>) {
        let claims: Vec<&Outcome> = self.paper.claims.iter().collect();
        let found = consequences(id, &claims);
        let (distant, listed): (Vec<_>, Vec<_>) = found
            .iter()
            .partition(|own| !own.through.is_empty() && own.fate.survives());
        let views = listed.into_iter().map(|listed| ConsequenceView {
            claim: self.reference(&listed.id),
            fate: spans(
                &visible(&glossary::consequence(listed)),
                &PrintedNames::default(),
            ),
            through: listed.through.last().map(|id| self.reference(id)),
        });
        let survivors = (!distant.is_empty()).then(|| glossary::distant_survivors(distant.len()));
        (views.collect(), survivors)
    }

    /// Returns the pictures that the claim shows itself, and those that it links to.
    fn figures_of(&self, claim: usize, id: &str) -> (Vec<usize>, Vec<usize>) {
        let illustrating = self.figures.iter().enumerate();
        illustrating
            .filter(|(_, figure)| figure.claims.iter().any(|illustrated| illustrated == id))
            .map(|(position, _)| position)
            .partition(|position| self.shown_at(*position) == Some(claim))
    }

    /// Returns the claim at which a picture is shown: the first of those that its file names.
    fn shown_at(&self, figure: usize) -> Option<usize> {
        let claims = self.figures.get(figure)?.claims.iter();
        let mut known = claims.filter_map(|id| self.by_id.get(id.as_str()));
        known.next().copied()
    }

    /// Returns the pictures with their numbers: a figure of the paper has the paper's, the others are counted.
    fn figure_views(&self) -> Vec<FigureView> {
        let mut taken = BTreeSet::new();
        let mut own = 0;
        let mut views = Vec::with_capacity(self.figures.len());
        for (position, image) in self.figures.iter().enumerate() {
            let claim = self.shown_at(position);
            let claim = claim.and_then(|claim| self.paper.claims.get(claim));
            let printed = claim
                .filter(|outcome| outcome.claim.kind == Kind::Figure)
                .and_then(|outcome| figure_number(&outcome.claim.at))
                .filter(|number| taken.insert(number.clone()));
            let number = printed.unwrap_or_else(|| {
                own += 1;
                format!("E{own}")
            });
            views.push(figure_view(position, image, number));
        }
        views
    }

    fn further_figures(&self) -> Vec<usize> {
        (0..self.figures.len())
            .filter(|figure| self.shown_at(*figure).is_none())
            .collect()
    }
}

fn conditions(conditions: &[Formula], names: &PrintedNames) -> Vec<FormulaView> {
    let view = |condition| derived(condition, names);
    conditions.iter().map(view).collect()
}

fn assumed(outcome: &Outcome, names: &PrintedNames) -> Vec<FormulaView> {
    let assumed = outcome.claim.assumed.iter();
    let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
    assumed.map(|h| formula(&h.formula, names)).collect()
}

/// The label of the sources of hypotheses.
const SOURCE: &str = "source";

/// Returns the numbers of the sources among the dependencies of a statement.
fn numbers(rests: &[RestsView], entries: &mut Entries) -> Vec<usize> {
    let sources = rests.iter().filter(|group| group.label == SOURCE);
    let mut numbers: Vec<usize> = Vec::new();
    for line in sources.flat_map(|group| &group.lines) {
        let number = entries.number(line.clone());
        if !numbers.contains(&number) {
            numbers.push(number);
        }
    }
    numbers
}

/// Writes the dependencies of a statement, in small print. Definitions that it shares with others are in the notation
/// of the report.
fn views(outcome: &Outcome, names: &PrintedNames) -> Vec<RestsView> {
    let table = &outcome.claim.table;
    let prose = |text: &str| spans(&visible(text), names);
    let quoted = |formula: &Formula| prose(&format!("`{}`", formula.text));
    let given = outcome.claim.assumed.iter();
    let given = given.filter(|hypothesis| hypothesis.role == Role::Given);
    let sets = table.symbols.iter();
    let sets = sets.filter(|symbol| symbol.set.contains(" in "));
    let own = table.definitions.iter().filter(|definition| definition.own);
    let hypotheses = outcome.claim.assumed.iter();
    let hypotheses = hypotheses.filter(|hypothesis| concerns(hypothesis, &table.symbols));
    let groups = [
        ("given", given.map(|h| quoted(&h.formula)).collect()),
        ("solved for", table.unknowns.iter().map(quoted).collect()),
        (
            "where",
            sets.map(|symbol| prose(&symbol.set.replace(" in ", " ∈ ").replace("inf)", "∞)")))
                .collect(),
        ),
        (
            "with",
            own.map(|definition| defined(definition, names)).collect(),
        ),
        (
            SOURCE,
            hypotheses.filter_map(|h| source(h, names)).collect(),
        ),
    ];
    let groups = groups.into_iter();
    let groups = groups.map(|(label, lines)| RestsView { label, lines });
    groups.filter(|group| !group.lines.is_empty()).collect()
}

/// Writes the source of a hypothesis; the claim that it names is no formula.
fn source(hypothesis: &Assumed, names: &PrintedNames) -> Option<Prose> {
    let text = describe_source(hypothesis, &|code| format!("`{code}`"))?;
    let HypothesisSource::Printed { claim, .. } = &hypothesis.from else {
        return Some(spans(&visible(&text), names));
    };
    let words = text.strip_suffix(&format!("({claim})")).unwrap_or(&text);
    let mut prose = spans(&visible(words), names);
    prose.push(Span::Code(visible(name(claim))));
    Some(prose)
}

/// Writes a definition as an equation.
fn defined(definition: &Defined, names: &PrintedNames) -> Prose {
    let text = format!("`{} == {}`", definition.head.text, definition.body.text);
    spans(&visible(&text), names)
}

/// A definition that a claim shares with others, as readers see it.
struct SharedDefinition<'c> {
    /// The name of the claim.
    claim: &'c str,
    /// What is defined: different names of the files may be printed alike.
    head: String,
    /// The definition in words.
    words: String,
    /// The definition.
    line: Prose,
}

impl<'c> SharedDefinition<'c> {
    fn new(outcome: &'c Outcome, definition: &Defined, names: &PrintedNames) -> Self {
        let line = defined(definition, names);
        let head = format!("`{}`", definition.head.text);
        Self {
            claim: name(&outcome.claim.id),
            head: in_words(&spans(&visible(&head), names)),
            words: in_words(&line),
            line,
        }
    }
}

/// Returns the definitions and families that statements share, each once, in the order of use.
fn notation(claims: &[Outcome]) -> Vec<Prose> {
    let shared = claims.iter().map(|outcome| {
        let names = printed_names(outcome);
        let definitions = outcome.claim.table.definitions.iter();
        let definitions = definitions.filter(|definition| !definition.own);
        let shared: Vec<SharedDefinition<'_>> = definitions
            .map(|own| SharedDefinition::new(outcome, own, &names))
            .collect();
        (&outcome.claim.table.bases, names, shared)
    });
    let shared: Vec<_> = shared.collect();
    // For each name that readers see, the claims that use it, by the definition that they see.
    let mut users: BTreeMap<&str, BTreeMap<&str, Vec<&str>>> = BTreeMap::new();
    for of in shared.iter().flat_map(|(.., definitions)| definitions) {
        let lines = users.entry(&of.head).or_default();
        lines.entry(&of.words).or_default().push(of.claim);
    }
    let mut seen = BTreeSet::new();
    let mut list = Vec::new();
    for (bases, names, definitions) in &shared {
        for of in definitions {
            if !seen.insert((of.head.clone(), of.words.clone())) {
                continue;
            }
            let mut line = of.line.clone();
            // What readers see defined in several ways says where.
            if let Some(lines) = users.get(of.head.as_str()).filter(|lines| lines.len() > 1) {
                let using = lines.get(of.words.as_str()).into_iter().flatten();
                let using: Vec<&str> = using.copied().collect();
                line.push(Span::Words(" in ".to_owned()));
                line.push(Span::Code(visible(&using.join(", "))));
            }
            list.push(line);
        }
        for family in *bases {
            let seeds: Vec<String> = (family.seeds.iter())
                .map(|seed| format!("`{}`", seed.text))
                .collect();
            let [a, b] = &family.step;
            let functions = seeds.join(", ");
            let step = match family.is_list() {
                true => String::new(),
                false => format!(
                    ", and from each degree to the next the factors `{}` and `{}`",
                    a.text, b.text
                ),
            };
            let text = format!(
                "`{}`: in degree {} the functions {functions}{step}",
                family.head.text, family.degree
            );
            if seen.insert((family.head.text.clone(), text.clone())) {
                list.push(spans(&visible(&text), names));
            }
        }
    }
    list
}

fn reading(reading: &ReadingOutcome) -> ReadingView {
    let of = &reading.outcome;
    let names = printed_names(of);
    ReadingView {
        name: spans(&visible(&reading.name), &names),
        says: spans(&visible(&reading.says), &names),
        verdict: glossary::verdict_on(of),
        evidence: glossary::evidence_on(of),
        parsed: of.parsed().map(|parsed| formula(parsed, &names)),
        assumed: assumed(of, &names),
        conditions: conditions(of.conditions(), &names),
        fails_at: sentence::failure(of).map(|text| spans(&visible(&text), &names)),
        rests: views(of, &names),
        sources: Vec::new(),
    }
}

fn witness(witness: &Witness, names: &PrintedNames) -> WitnessView {
    /// Maximum number of characters of values that stand side by side.
    const SHORT: usize = 16;
    let equation =
        |(name, value): &(String, String)| spans(&visible(&format!("`{name} = {value}`")), names);
    let side = |label, exact: &str, decimals: &str| Side {
        label,
        exact: spans(&visible(&format!("`{}`", exact)), names),
        decimal: shorter_decimal(exact, decimals),
    };
    let sides = match witness.left == witness.right {
        true => vec![side("equal sides", &witness.left, &witness.left_decimal)],
        false => vec![
            side("left side", &witness.left, &witness.left_decimal),
            side("right side", &witness.right, &witness.right_decimal),
        ],
    };
    let length = |(name, value): &(String, String)| name.len() + value.len();
    WitnessView {
        short: sentence::point(witness).all(|pair| length(pair) <= SHORT),
        at: sentence::point(witness).map(equation).collect(),
        sides,
    }
}

/// Returns the decimals, unless the exact value consists of integers and is as easy to read.
fn shorter_decimal(exact: &str, decimals: &str) -> String {
    let integers = exact
        .chars()
        .all(|c| c.is_ascii_digit() || "-[], ".contains(c));
    match integers || decimals.is_empty() {
        true => String::new(),
        false => visible(&decimal(decimals)),
    }
}
