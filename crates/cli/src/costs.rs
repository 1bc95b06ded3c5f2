//! What claims are expected to cost, in the units of the budget: what they have cost before, or an estimate.

use crate::exit::Failure;
use crate::input;
use serde::Deserialize;
use std::collections::HashMap;
use std::path::PathBuf;
use torse::ClaimDigest;
use torse_syntax::derivation::Claim;
use torse_syntax::taxonomy::Kind;

/// What claims have cost, by the first half of their digests: an expectation that is wrong costs time alone.
#[derive(Debug, Default)]
pub struct Costs {
    before: HashMap<u128, u64>,
}

/// A line of a part; other fields are ignored.
#[derive(Deserialize)]
struct DecidedClaim {
    digest: String,
    work: u64,
}

impl Costs {
    /// Reads parts that `torse verify --ids` has written. What is no line of a claim is passed over: a part that was cut off
    /// says something, too.
    ///
    /// # Errors
    /// [`Failure::Input`] for a file that cannot be read.
    pub fn read(parts: &[PathBuf]) -> Result<Self, Failure> {
        let mut before = HashMap::new();
        for part in parts {
            for line in input::lines(part)? {
                let Ok(DecidedClaim { digest, work }) = serde_json::from_str(&line?) else {
                    continue;
                };
                before.extend(key(&digest).map(|key| (key, work)));
            }
        }
        Ok(Self { before })
    }

    /// What a claim is expected to cost.
    pub fn expected(&self, claim: &Claim, digest: &ClaimDigest) -> u64 {
        let before = key(&digest.digest).and_then(|key| self.before.get(&key));
        before.copied().unwrap_or_else(|| estimate(claim))
    }
}

fn key(digest: &str) -> Option<u128> {
    u128::from_str_radix(digest.get(..32)?, 16).ok()
}

/// What loading a claim and a look at it cost.
const LEAST: u64 = 5_000;

/// What a claim of this kind and length has cost on the average in the papers of the repository: work a byte of its
/// statements, in one or two digits.
fn estimate(claim: &Claim) -> u64 {
    let a_byte = match claim.entry.kind {
        Kind::Definition => 200,
        Kind::Value => 350,
        Kind::Identity => 4_000,
        Kind::Inequality | Kind::Prose => 5_000,
        Kind::Construction => 9_000,
        Kind::Remark => 16_000,
        Kind::Property => 30_000,
        // It is drawn, which is not counted.
        Kind::Figure => 0,
    };
    let readings = claim.entry.readings.iter().map(|reading| &reading.states);
    let texts = claim.entry.states.iter().chain(readings);
    let bytes: u64 = texts.map(|text| text.get_ref().len() as u64).sum();
    LEAST.saturating_add(bytes.saturating_mul(a_byte))
}
