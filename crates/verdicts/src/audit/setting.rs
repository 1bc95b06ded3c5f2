//! The surroundings of a claim: the print of the claims that it rests on.

use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::derivation::{Claim, CorrectedClaim, Paper, Rewording};
use torse_syntax::taxonomy::Kind;

/// The claims of papers by id; the parts of a sentence by the id of the sentence too.
pub(super) struct Setting<'a> {
    claims: BTreeMap<&'a str, Vec<&'a Claim>>,
    papers: &'a [Paper],
}

/// The correction of a claim.
pub(super) struct Correction<'a> {
    /// The claim with all corrections in force.
    pub corrected: &'a CorrectedClaim,
    /// The corrected words of its print.
    pub reads: Vec<&'a str>,
    /// The other claims of the same fault, with all corrections in force.
    pub siblings: Vec<&'a CorrectedClaim>,
    /// The corrected words of other claims for the same fault.
    pub beside: Vec<&'a str>,
}

impl<'a> Setting<'a> {
    /// Indexes the claims of these papers.
    pub fn new(papers: &'a [Paper]) -> Self {
        let mut claims: BTreeMap<&str, Vec<&Claim>> = BTreeMap::new();
        for claim in papers.iter().flat_map(|paper| &paper.claims) {
            let whole = claim.sentence_id().map(String::as_str);
            for id in whole.into_iter().chain([claim.entry.id.get_ref().as_str()]) {
                claims.entry(id).or_default().push(claim);
            }
        }
        Self { claims, papers }
    }

    /// Returns the correction of the claim with this id; none if the files have none.
    pub fn correction(&self, id: &str) -> Option<Correction<'a>> {
        let mut corrigenda = self.papers.iter().flat_map(|paper| &paper.corrigenda);
        corrigenda.find_map(|entry| {
            let mut all = entry.corrected.iter();
            let corrected = all.find(|own| own.claim.entry.id.get_ref() == id)?;
            let changes = entry.changes.iter();
            let (own, others): (Vec<_>, Vec<_>) = changes.partition(|change| change.claim == id);
            let reads = |changes: Vec<&'a Rewording>| {
                let reads = changes.into_iter().map(|change| change.reads.as_str());
                reads.collect()
            };
            let siblings = entry.corrected.iter();
            let siblings = siblings.filter(|other| other.claim.entry.id.get_ref() != id);
            Some(Correction {
                siblings: siblings.collect(),
                corrected,
                reads: reads(own),
                beside: reads(others),
            })
        })
    }

    /// The ids of the faults that are said to show in the claim with this id.
    pub fn faults_in(&self, id: &str) -> impl Iterator<Item = &'a str> {
        let corrigenda = self.papers.iter().flat_map(|paper| &paper.corrigenda);
        let showing = corrigenda.filter(move |own| own.shows.iter().any(|shown| shown == id));
        showing.map(|own| own.id.as_str())
    }

    /// The corrections of the words of the claim with this id: what is printed, and what is to be read.
    pub fn changes_of(&self, id: &str) -> impl Iterator<Item = (&'a str, &'a str)> {
        let corrigenda = self.papers.iter().flat_map(|paper| &paper.corrigenda);
        let changes = corrigenda.flat_map(|own| &own.changes);
        let changes = changes.filter(move |change| change.claim == id);
        changes.map(|change| (change.printed.as_str(), change.reads.as_str()))
    }

    /// Whether the claim with this id stands in a worked folder of ours.
    pub fn is_worked(&self, id: &str) -> bool {
        let mut papers = self.papers.iter();
        let paper = papers.find(|paper| id.split('/').next() == Some(&paper.head.id));
        paper.is_some_and(|paper| paper.head.is_worked())
    }

    fn named(&self, id: &str) -> impl Iterator<Item = &&'a Claim> {
        self.claims.get(id).into_iter().flatten()
    }

    /// Returns the print of the claim, of the other parts of its sentence, and of the claims that it uses or quotes.
    /// The words of remarks are ours and left out.
    pub fn prints(&self, claim: &Claim) -> String {
        let ids = claim
            .uses
            .iter()
            .chain(claim.sentence_id())
            .map(String::as_str);
        let quoted = claim.quotes().into_iter().map(|quote| quote.claim.as_str());
        let others = ids.chain(quoted).flat_map(|id| self.named(id));
        let others = others.filter(|other| other.entry.kind != Kind::Remark);
        let others = others.map(|other| other.entry.printed.as_str());
        let mut seen = BTreeSet::from([claim.entry.printed.as_str()]);
        let mut text = claim.entry.printed.clone();
        for printed in others {
            if seen.insert(printed) {
                text.push_str(" / ");
                text.push_str(printed);
            }
        }
        text
    }

    /// Returns the claim, the other parts of its sentence, and all claims that these rest on.
    pub fn rests_on(&self, claim: &'a Claim) -> Vec<&'a Claim> {
        let parts = claim
            .sentence_id()
            .into_iter()
            .flat_map(|id| self.named(id));
        let mut pending: Vec<&Claim> = parts.copied().chain([claim]).collect();
        let (mut seen, mut found) = (BTreeSet::new(), vec![]);
        while let Some(claim) = pending.pop() {
            if seen.insert(claim.entry.id.get_ref().as_str()) {
                found.push(claim);
                let quoted = claim.quotes().into_iter().map(|quote| quote.claim.as_str());
                let ids = claim.uses.iter().map(String::as_str).chain(quoted);
                pending.extend(ids.flat_map(|id| self.named(id)).copied());
            }
        }
        found
    }
}
