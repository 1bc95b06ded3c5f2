//! The letter to the authors of a paper: what is to be corrected, fault by fault, in the notation of the paper.
//!
//! A fault that files tell of has one item, wherever it shows, with the words of the paper and what is to be read instead.
//! A refuted statement to which no fault is assigned has an item of its own, so that none is left out. What may be a slip of the
//! copy at hand is asked, and not claimed; conditions that the text should state have a part of their own.

use crate::corrections::{dependents, is_named, is_refuted};
use crate::glossary::plural;
use crate::names::printed_names;
use crate::sentence;
use crate::text::{enumeration, visible};
use crate::view::{CorrectionView, correction};
use serde::Serialize;
use std::cmp::Reverse;
use std::collections::BTreeSet;
use torse_syntax::derivation::LetterPart;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_typography::{PrintedNames, Prose, compared, in_words, plain, quotation, spans};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome, Restored};
use torse_verdicts::repair;

/// Who writes a letter, and when. Without a sender it is a draft.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Envelope {
    /// The name of the sender.
    pub sender: Option<String>,
    /// The date, as it is to be written.
    pub date: Option<String>,
}

impl Envelope {
    /// The envelope with what could act on the text around it spelled out.
    #[must_use]
    pub fn cleared(&self) -> Self {
        let clear = |text: &Option<String>| text.as_deref().map(|text| visible(text.trim()));
        Self {
            sender: clear(&self.sender).filter(|name| !name.is_empty()),
            date: clear(&self.date).filter(|date| !date.is_empty()),
        }
    }
}

/// What a letter says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Letter {
    /// How the authors are addressed; none of a worked example, which has no authors to write to.
    pub salutation: Option<String>,
    /// How much of the paper was decided.
    pub scope: Scope,
    /// What the letter is about, and how the statements were decided.
    pub opening: String,
    /// What is false and how it is to be corrected, the most consequential first.
    pub corrections: Vec<Item>,
    /// Conditions that the text should state.
    pub conditions: Vec<Item>,
    /// What may be right in print, and a slip of the copy at hand.
    pub questions: Vec<Item>,
    /// What is true with all corrections in force, and how all of it was checked.
    pub closing: Vec<String>,
}

/// How many statements, formulas and figures of a paper were decided, of how many that it has. Remarks of ours are not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Scope {
    /// Those that were written as formulas and decided.
    pub decided: usize,
    /// All of them.
    pub total: usize,
}

impl Scope {
    fn new(claims: &[Outcome]) -> Self {
        let own = claims.iter().filter(|of| of.claim.kind != Kind::Remark);
        let is_decided = |outcome: &&Outcome| match outcome.verdict() {
            Verdict::Holds
            | Verdict::Conditional
            | Verdict::Misprint
            | Verdict::False
            | Verdict::Vacuous
            | Verdict::Depends => true,
            // Printed data are compared with those of other statements, or stand for themselves.
            Verdict::Definition => outcome.evidence().is_some(),
            Verdict::Undecided
            | Verdict::Underspecified
            | Verdict::OutOfScope
            | Verdict::Reproduced
            | Verdict::Partial => false,
        };
        Self {
            decided: own.clone().filter(is_decided).count(),
            total: own.count(),
        }
    }

    /// Says how much was decided, without the full stop.
    fn sentence(self) -> String {
        let Self { decided, total } = self;
        match (decided, total) {
            (0, _) => "No statement of your paper has been decided yet, so that nothing is said about it here".to_owned(),
            (1, 1) => "We wrote the statement of your paper as a formula and decided it by exact computation, with the program torse".to_owned(),
            (_, _) if decided == total => format!("We wrote each of the {total} statements of your paper as a formula and decided it by exact computation, with the program torse"),
            (1, _) => format!("Of the {total} statements, formulas and figures of your paper, we wrote one as a formula and decided it by exact computation, with the program torse"),
            _ => format!("Of the {total} statements, formulas and figures of your paper, we wrote {decided} as formulas and decided them by exact computation, with the program torse"),
        }
    }
}

/// A fault.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Item {
    /// Where it is.
    pub heading: Prose,
    /// What is wrong, in a sentence.
    pub says: Prose,
    /// What is printed and what is to be read.
    pub changes: Vec<ItemChange>,
    /// An exact counterexample.
    pub why: Option<Prose>,
    /// Whether its points and vectors are numbers: one coordinate of them, which stands for all.
    pub in_one_coordinate: bool,
    /// Where it shows besides.
    pub also: Vec<Prose>,
}

impl Item {
    /// What stands before the counterexample.
    pub(crate) fn why_label(&self) -> &'static str {
        match self.in_one_coordinate {
            true => "Counterexample, for one coordinate",
            false => "Counterexample",
        }
    }
}

/// Words of the paper, and what is to be read instead.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ItemChange {
    /// Where they stand, if there is more than one place; none where that is the place of the change before.
    pub at: Option<Prose>,
    /// The words.
    pub printed: Prose,
    /// What is to be read instead; none where the words say what is not so and no others are offered.
    pub reads: Option<Prose>,
    /// A correction that was found for the formula by which the words were understood.
    pub formula: Option<CorrectionView>,
}

/// The letter about a paper.
pub(crate) fn letter(paper: &PaperOutcome, accepted: &BTreeSet<String>) -> Letter {
    let claims = &paper.claims;
    let find = |id: &String| claims.iter().find(|outcome| outcome.claim.id == *id);
    let mut placed: Vec<(Part, Weight, Item)> = vec![];
    for fault in &paper.faults {
        let shows: Vec<&Outcome> = fault.shows.iter().filter_map(find).collect();
        if let Some(part) = fault_part(fault, &shows) {
            let item = item_of_fault(fault, &shows, &find);
            placed.push((part, Weight::new(&shows, paper), item));
        }
    }
    let is_assigned = |id: &str| paper.faults.iter().any(|fault| fault.shows_in(id));
    for outcome in claims
        .iter()
        .filter(|outcome| is_refuted(outcome) && !is_assigned(&outcome.claim.id))
    {
        let part = part(&[outcome]).unwrap_or(Part::Correction);
        let item = item_without_fault(outcome);
        placed.push((part, Weight::new(&[outcome], paper), item));
    }
    placed.sort_by(|(part, weight, _), (other, other_weight, _)| {
        (part, weight).cmp(&(other, other_weight))
    });
    let take = |wanted: Part| -> Vec<Item> {
        let of = placed.iter().filter(|(part, ..)| *part == wanted);
        of.map(|(.., item)| item.clone()).collect()
    };
    let (corrections, conditions, questions) = (
        take(Part::Correction),
        take(Part::Condition),
        take(Part::Question),
    );
    let is_open = |outcome: &&Outcome| {
        outcome.verdict() == Verdict::Undecided && outcome.claim.kind != Kind::Remark
    };
    let open: Vec<&Outcome> = claims.iter().filter(is_open).collect();
    let scope = Scope::new(claims);
    Letter {
        scope,
        salutation: (!is_example(&paper.authors)).then(|| salutation(&visible(&paper.authors))),
        opening: match is_example(&paper.authors) {
            true => example(corrections.len()),
            false => opening(
                scope,
                [corrections.len(), conditions.len(), questions.len()],
                &open,
            ),
        },
        closing: closing(paper, corrections.len(), accepted),
        corrections,
        conditions,
        questions,
    }
}

/// The parts of a letter, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Correction,
    Condition,
    Question,
}

/// What makes one fault come before another in a part of a letter: theorems, propositions and algorithms first, then the
/// faults that concern most statements, then the order of the paper.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Weight {
    is_unnamed: bool,
    concerned: Reverse<usize>,
    position: usize,
}

impl Weight {
    fn new(shows: &[&Outcome], paper: &PaperOutcome) -> Self {
        let mut concerned = BTreeSet::new();
        for claim in shows
            .iter()
            .filter(|claim| is_limited(claim) || is_refuted(claim))
        {
            concerned.insert(claim.claim.id.as_str());
            let (_, falling) = dependents(claim, paper);
            concerned.extend(falling.iter().map(|other| other.claim.id.as_str()));
        }
        let position = paper.claims.iter().position(|claim| {
            let mut shown = shows.iter();
            shown.any(|shown| shown.claim.id == claim.claim.id)
        });
        Self {
            is_unnamed: !shows.iter().any(|claim| is_named(claim)),
            concerned: Reverse(concerned.len()),
            position: position.unwrap_or(usize::MAX),
        }
    }
}

/// The part that the files name, or else that the verdicts ask for; none if all is true in which the fault is said to show.
fn fault_part(fault: &PaperFault, shows: &[&Outcome]) -> Option<Part> {
    match fault.part {
        _ if shows.is_empty() => None,
        Some(LetterPart::Correction) => Some(Part::Correction),
        Some(LetterPart::Condition) => Some(Part::Condition),
        None => part(shows),
    }
}

/// What has conditions or readings, and words of which nothing is to be decided.
fn is_limited(claim: &Outcome) -> bool {
    matches!(
        claim.verdict(),
        Verdict::Conditional | Verdict::Depends | Verdict::Underspecified | Verdict::OutOfScope
    )
}

/// Where a fault belongs; nowhere if all is true in which it is said to show.
fn part(shows: &[&Outcome]) -> Option<Part> {
    let mut refuted = shows.iter().filter(|claim| is_refuted(claim)).peekable();
    if refuted.peek().is_some() {
        return Some(
            match refuted.all(|outcome| outcome.claim.garbled.is_some()) {
                true => Part::Question,
                false => Part::Correction,
            },
        );
    }
    if !shows.is_empty() && shows.iter().all(|outcome| outcome.claim.garbled.is_some()) {
        return Some(Part::Question);
    }
    let is_condition = shows.iter().any(|claim| is_limited(claim));
    is_condition.then_some(Part::Condition)
}

fn item_of_fault<'a>(
    fault: &PaperFault,
    shows: &[&'a Outcome],
    find: &impl Fn(&String) -> Option<&'a Outcome>,
) -> Item {
    let mut names = shows
        .first()
        .map(|claim| printed_names(claim))
        .unwrap_or_default();
    for claim in shows.iter().skip(1) {
        names.extend(printed_names(claim));
    }
    let several = fault.changes.len() > 1;
    let mut before = None;
    let mut changes: Vec<ItemChange> = (fault.changes.iter())
        .filter_map(|change| {
            let claim = find(&change.claim)?;
            let [printed, reads] =
                compared(&visible(&change.printed), &visible(&change.reads), &names);
            // A place is named once for all changes that follow one another there.
            let at = Some(place(claim)).filter(|at| several && before.as_ref() != Some(at));
            before = at.clone().or(before.take());
            Some(ItemChange {
                at,
                printed,
                reads: Some(reads),
                formula: None,
            })
        })
        .collect();
    // Of a sentence for which no other is offered, the words.
    if changes.is_empty() {
        changes.extend(shows.first().map(|outcome| ItemChange {
            at: None,
            printed: quotation(&visible(&outcome.claim.printed), &names),
            reads: None,
            formula: None,
        }));
    }
    let changed = |claim: &&&Outcome| {
        fault
            .changes
            .iter()
            .any(|change| change.claim == claim.claim.id)
    };
    let heading = match &fault.at {
        Some(at) => spans(&visible(at), &names),
        None => shows.first().map(|claim| place(claim)).unwrap_or_default(),
    };
    // Places at which the item is already: its heading, or a part or the whole of that, and those of its changes.
    let own = in_words(&heading);
    let mut here: Vec<Prose> = (fault.changes.iter())
        .filter_map(|change| find(&change.claim).map(place))
        .collect();
    let mut also: Vec<Prose> = vec![];
    for claim in shows
        .iter()
        .filter(|claim| !changed(claim))
        .skip(usize::from(fault.changes.is_empty()))
    {
        let place = place(claim);
        let words = in_words(&place);
        let is_here = own.starts_with(&words) || words.starts_with(&own) || here.contains(&place);
        if !is_here {
            here.push(place.clone());
            also.push(place);
        }
    }
    let refuted = shows
        .iter()
        .filter(|claim| !is_about_a_letter(fault, claim))
        .find_map(|claim| Some((counterexample(claim)?, is_in_one_coordinate(claim))));
    Item {
        heading,
        says: spans(&visible(&sentence::finished(&fault.says)), &names),
        changes,
        in_one_coordinate: refuted.as_ref().is_some_and(|(_, one)| *one),
        why: refuted.map(|(why, _)| why),
        also,
    }
}

/// Whether a witness has a number for a letter that stands in the print and in no correction. Such a letter may mean
/// nothing, and a number for it refutes nothing.
fn is_about_a_letter(fault: &PaperFault, outcome: &Outcome) -> bool {
    let stands = |letter: &str, text: &str| {
        text.match_indices(letter).any(|(at, _)| {
            let before = text.get(..at).and_then(|text| text.chars().next_back());
            let after = text
                .get(at + letter.len()..)
                .and_then(|text| text.chars().next());
            let joined = |c: Option<char>| c.is_some_and(|c| c.is_ascii_lowercase());
            !joined(before) && !joined(after)
        })
    };
    let is_gone = |name: &String| {
        let mut changes = fault.changes.iter();
        name.len() == 1
            && fault
                .changes
                .iter()
                .any(|change| stands(name, &change.printed))
            && !changes.any(|change| stands(name, &change.reads))
    };
    let witness = outcome.witness().into_iter();
    let mut names = witness.flat_map(sentence::point).map(|(name, _)| name);
    names.any(is_gone)
}

/// Whether a witness has a number for a point or a vector, each coordinate of which it stands for.
fn is_in_one_coordinate(outcome: &Outcome) -> bool {
    let generic = outcome.claim.table.symbols.iter();
    let mut generic = generic.filter(|symbol| symbol.is_generic);
    let Some(witness) = outcome.witness() else {
        return false;
    };
    let head = |name: &str| name.split(['[', '(', '\'']).next().map(str::to_owned);
    generic.any(|symbol| {
        sentence::point(witness).any(|(name, _)| head(name).as_deref() == Some(&symbol.name))
    })
}

/// The item of a refuted statement to which no fault is assigned.
fn item_without_fault(outcome: &Outcome) -> Item {
    let names = printed_names(outcome);
    let formula = (outcome.correction()).map(|repair| correction(outcome.parsed(), repair, &names));
    let change = match (
        &outcome.claim.author_note,
        outcome.correction(),
        &outcome.claim.note,
    ) {
        (Some(finding), ..) => Some(sentence::finished(finding)),
        (None, Some(repair), _) => Some(with_changes(&repair.edits)),
        (None, None, Some(note)) => Some(note.clone()),
        (None, None, None) => None,
    };
    // Where nothing else is known it is the counterexample that says what is wrong, and it is said once.
    let why = change.is_some().then(|| counterexample(outcome)).flatten();
    let says = change.unwrap_or_else(|| {
        let failure = sentence::failure_in_full(outcome);
        failure.map_or_else(String::new, |text| sentence::finished(&text))
    });
    Item {
        heading: place(outcome),
        says: spans(&visible(&says), &names),
        changes: vec![ItemChange {
            at: None,
            printed: quotation(&visible(&outcome.claim.printed), &names),
            reads: None,
            formula,
        }],
        in_one_coordinate: why.is_some() && is_in_one_coordinate(outcome),
        why,
        also: vec![],
    }
}

/// Says by which edits a statement becomes true.
fn with_changes(edits: &[String]) -> String {
    let count = match edits.len() {
        1 => "one change",
        _ => "these changes",
    };
    sentence::finished(&format!("It holds with {count}: {}", edits.join("; ")))
}

fn place(outcome: &Outcome) -> Prose {
    spans(&visible(&outcome.claim.at), &PrintedNames::default())
}

/// A counterexample of more characters is left to the report.
const MAX_COUNTEREXAMPLE_LENGTH: usize = 400;

/// Where a formula of the paper fails; none where that cannot be said in names that the paper has. The formulas of sentences
/// are ours, and what they come to at a point tells an author nothing.
fn counterexample(outcome: &Outcome) -> Option<Prose> {
    let witness = outcome.witness()?;
    let names = printed_names(outcome);
    let stated = outcome.parsed()?;
    let of_the_paper = names.are_of_the_paper(&stated.text)
        && sentence::point(witness).all(|(name, _)| names.are_of_the_paper(name));
    let plain_value = |text: &str| !text.starts_with('[');
    let is_shown = is_refuted(outcome)
        && repair::is_sought(outcome.claim.kind)
        && of_the_paper
        && plain_value(&witness.left)
        && plain_value(&witness.right);
    let why = is_shown
        .then(|| sentence::counterexample(outcome))
        .flatten()?;
    if why.chars().count() > MAX_COUNTEREXAMPLE_LENGTH {
        return None;
    }
    // What is no equation in print has no sides there.
    let has_sides = outcome
        .claim
        .printed
        .contains(['=', '<', '>', '≤', '≥', '≠']);
    let why = match has_sides {
        true => why,
        false => why.replace("the right side", "what is printed"),
    };
    // Two sides of one name would be said to differ from themselves.
    let (left, right) = stated.text.split_once(" == ")?;
    let shown = |side: &str| in_words(&spans(&format!("`{side}`"), &names));
    (shown(left) != shown(right)).then(|| spans(&visible(&why), &names))
}

fn salutation(authors: &str) -> String {
    let names: Vec<&str> = authors.split(',').map(str::trim).collect();
    match names.as_slice() {
        [] => "Dear authors,".to_owned(),
        names => format!("Dear {},", enumeration(names)),
    }
}

/// Whether a folder is a worked example of ours, and no paper.
pub(crate) fn is_example(authors: &str) -> bool {
    authors == "torse"
}

fn example(corrections: usize) -> String {
    format!(
        "This is no paper but a worked example: {} in it {} wrong on purpose, and here is what torse found of {}. Changes are framed; changed words are bold.",
        plural(corrections, "statement"),
        if corrections == 1 { "is" } else { "are" },
        if corrections == 1 { "it" } else { "them" },
    )
}

fn opening(
    scope: Scope,
    [corrections, conditions, questions]: [usize; 3],
    open: &[&Outcome],
) -> String {
    let mut text = scope.sentence();
    let named: Vec<String> = open.iter().map(|outcome| named(outcome)).collect();
    text.push_str(&match named.as_slice() {
        [] => ".".to_owned(),
        [one] => format!("; one more is not decided, {one}."),
        several => format!(
            "; {} more are not decided: {}.",
            several.len(),
            several.join("; ")
        ),
    });
    text.push_str(&match corrections {
        0 if scope.decided == 0 => String::new(),
        0 => " None was found to be false.".to_owned(),
        1 => " We propose one correction. Changes are framed; changed words are bold.".to_owned(),
        _ => format!(
            " We propose {corrections} corrections, the most consequential first. Changes are framed; changed words are bold."
        ),
    });
    text.push_str(&match conditions {
        0 => String::new(),
        1 => " We add one point that the text should state more exactly.".to_owned(),
        _ => format!(" We add {conditions} points that the text should state more exactly."),
    });
    text.push_str(&match questions {
        0 => String::new(),
        1 => " We also ask you to look at one place that may be a slip of our copy.".to_owned(),
        _ => {
            format!(" We also ask you to look at {questions} places that may be slips of our copy.")
        }
    });
    text
}

/// The words of a statement and its place, for a sentence.
fn named(outcome: &Outcome) -> String {
    // Words that are left out are marked, but for those before and after the quotation.
    let quoted = outcome.claim.printed.trim_matches(['.', ' ']);
    let words = quoted.replace("...", "[…]");
    let words: Vec<&str> = words.split_whitespace().collect();
    let at = plain(&outcome.claim.at);
    visible(&format!("“{}” ({at})", words.join(" ")))
}

fn closing(paper: &PaperOutcome, corrections: usize, accepted: &BTreeSet<String>) -> Vec<String> {
    let mut list = vec![];
    list.extend(restored(paper));
    if corrections > 0 {
        let refuted: Vec<&Outcome> = paper
            .claims
            .iter()
            .filter(|claim| is_refuted(claim))
            .collect();
        let proved = refuted
            .iter()
            .filter(|outcome| accepted.contains(&outcome.claim.id))
            .count();
        let mut text =
            "The counterexamples were computed exactly; the decimals in them are rounded."
                .to_owned();
        if proved > 0 {
            text.push_str(&format!(
                " The proof assistant Rocq also accepted {}; they stand in the folder proofs of torse {}.",
                match proved == refuted.len() {
                    true => "proofs of all refutations".to_owned(),
                    false => format!(
                        "proofs of {proved} of the {}",
                        plural(refuted.len(), "refutation")
                    ),
                },
                env!("CARGO_PKG_VERSION"),
            ));
        }
        list.push(text);
    }
    list.push(match is_example(&paper.authors) {
        true => format!(
            "The command “torse report {}” writes a page with every statement, its verdict and its proof.",
            visible(&paper.slug)
        ),
        false => "A report with every statement of the paper, its verdict and its proof will be sent on request.".to_owned(),
    });
    list
}

/// What became of the claims with all corrections in force; none if nobody asked.
fn restored(paper: &PaperOutcome) -> Option<String> {
    let of = |wanted: Verdict| {
        let list = paper.restored.iter().filter(move |of| of.verdict == wanted);
        list.collect::<Vec<&Restored>>()
    };
    let (holds, limited) = (
        of(Verdict::Holds).len() + of(Verdict::Definition).len(),
        of(Verdict::Conditional).len(),
    );
    let all = paper.restored.len();
    if all == 0 {
        return None;
    }
    let mut text = format!(
        "With all corrections of this letter made, the {} that they concern {} decided again: ",
        plural(all, "statement"),
        if all == 1 { "was" } else { "were" }
    );
    let mut parts = vec![];
    if holds > 0 {
        parts.push(format!(
            "{holds} {} true",
            if holds == 1 { "is" } else { "are" }
        ));
    }
    if limited > 0 {
        let verb = if limited == 1 { "is" } else { "are" };
        parts.push(format!(
            "{limited} {verb} true where what they divide by does not vanish"
        ));
    }
    let ambiguous = of(Verdict::Depends);
    if !ambiguous.is_empty() {
        let verb = if ambiguous.len() == 1 {
            "depends"
        } else {
            "depend"
        };
        let (count, places) = (ambiguous.len(), places(paper, &ambiguous));
        parts.push(format!("{count} still {verb} on the reading ({places})"));
    }
    let settled = [
        Verdict::Holds,
        Verdict::Definition,
        Verdict::Conditional,
        Verdict::Depends,
    ];
    let left = paper.restored.iter();
    let left: Vec<&Restored> = left.filter(|of| !settled.contains(&of.verdict)).collect();
    if !left.is_empty() {
        let verb = if left.len() == 1 { "is" } else { "are" };
        let (count, places) = (left.len(), places(paper, &left));
        parts.push(format!(
            "{count} {verb} not repaired, and cannot stay as printed ({places})"
        ));
    }
    text.push_str(&enumeration(&parts));
    text.push('.');
    let is_restored = |outcome: &Outcome| {
        let mut restored = paper.restored.iter();
        restored.any(|of| of.claim == outcome.claim.id)
    };
    let uncorrected = paper.claims.iter();
    let uncorrected: Vec<String> = uncorrected
        .filter(|outcome| is_refuted(outcome) && !is_restored(outcome))
        .map(|outcome| visible(&plain(&outcome.claim.at)))
        .collect();
    if !uncorrected.is_empty() {
        text.push_str(&format!(
            " No correction is offered for {} ({}).",
            plural(uncorrected.len(), "false statement"),
            uncorrected.join("; ")
        ));
    }
    Some(text)
}

/// Where the paper has these claims, each place once.
fn places(paper: &PaperOutcome, of: &[&Restored]) -> String {
    let find = |of: &&Restored| {
        paper
            .claims
            .iter()
            .find(|outcome| outcome.claim.id == of.claim)
    };
    let mut places: Vec<String> = vec![];
    for outcome in of.iter().filter_map(find) {
        let place = visible(&plain(&outcome.claim.at));
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places.join("; ")
}
