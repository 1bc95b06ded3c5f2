//! Proofs as values, and the checker that goes through them without search.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests"
)]

#[path = "../verdicts/common/mod.rs"]
mod common;

mod damaged;
#[cfg(debug_assertions)]
mod faults;
mod forced;
mod kinds;
mod lines;
mod random;

use torse_certificate::Polynomial;
use torse_checker::{CheckError, Work};
use torse_core as core;
use torse_prove::decide_statement;
use torse_syntax::derivation::{Claim, Origin};
use torse_verdicts::certificate::DecisionCertificate;

const DECLARATIONS: &str = r#"
[symbols]
x = { in = "[0, 1]" }
z = { in = "[0, 1]" }
u = { in = "[0, inf)" }
v = { in = "[0, inf)" }
a = {}
b = {}
r = {}
s = {}
n = { integer = ">= 1" }
i = { integer = "0..2" }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[basis.G]
variable = "x"
parameters = ["z"]
degree = 2
seeds = ['(1 - sin(pi/2*x))', '1 - (1 - sin(pi/2*x)) - (1 - cos(pi/2*x))*(1 + cos(pi/2*x) - 2*z*cos(pi/2*x))', '(1 - cos(pi/2*x))*(1 + cos(pi/2*x) - 2*z*cos(pi/2*x))']
step = ['1 - x', 'x']
"#;

/// A claim with what the prover found.
struct Found {
    core: core::Claim,
    origin: Origin,
    certificate: DecisionCertificate<Polynomial>,
}

fn claim(lines: &str) -> Claim {
    let paper = common::loaded("proofs", DECLARATIONS, &[lines]).unwrap();
    paper.claims.into_iter().next().unwrap()
}

/// What the prover finds of a claim whose fields are `lines`; nothing where it decides nothing.
fn tried(lines: &str) -> Option<Found> {
    let claim = claim(lines);
    let statement = claim.statement.clone().unwrap();
    let decision = decide_statement(&claim, &statement).unwrap();
    Some(Found {
        core: torse_elaborate::elaborate(&claim, &statement).unwrap(),
        origin: statement.origin,
        certificate: DecisionCertificate::from_decision(&decision)?.plain(),
    })
}

#[track_caller]
fn found(lines: &str) -> Found {
    tried(lines).unwrap_or_else(|| panic!("{lines}: not decided"))
}

impl Found {
    /// What the checker says.
    fn checked(&self) -> Result<(), CheckError> {
        let work = Work::new(torse_checker::WORK);
        match &self.certificate {
            DecisionCertificate::Proof { conditions, of } => {
                torse_checker::proves(&self.core, &self.origin, conditions, of, &work)
            }
            DecisionCertificate::Refutation(of) => {
                torse_checker::refutes(&self.core, &self.origin, of, &work)
            }
        }
    }
}
