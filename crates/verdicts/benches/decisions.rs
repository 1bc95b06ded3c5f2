//! What users of the engine wait for: loading, deriving a join, deciding and correcting claims.

#![allow(missing_docs, reason = "criterion's macros define items without docs")]
#![allow(clippy::expect_used, reason = "a benchmark on known good data")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::path::{Path, PathBuf};
use torse_syntax::derivation::load;
use torse_verdicts::derive::{Shape, continuity};
use torse_verdicts::engine::decide_claim;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations")
}

fn decisions(c: &mut Criterion) {
    let mut group = c.benchmark_group("claims");
    group.sample_size(10);
    group.bench_function("load every derivation", |b| {
        b.iter(|| load(&folder()).expect("the derivations load"));
    });
    let papers = load(&folder()).expect("the derivations load");
    let surfaces = papers
        .iter()
        .find(|paper| paper.head.id == "gbt-surfaces")
        .expect("a paper of the repository");
    group.bench_function("derive the C3 join of symbolic degrees", |b| {
        b.iter(|| {
            continuity(&surfaces.declarations, "f", 3, Shape::default())
                .expect("a basis that collapses")
        });
    });
    for id in [
        "gbt-developable/thm-1.3",
        "gbt-developable/thm-4.c",
        "gbt-surfaces/eq-5.Q12",
        "hermite-developable/eq-3.6.det",
    ] {
        let mut claims = papers.iter().flat_map(|paper| &paper.claims);
        let claim = claims
            .find(|claim| claim.entry.id.get_ref() == id)
            .expect("a claim of the repository");
        group.bench_function(id, |b| {
            b.iter(|| decide_claim("paper", claim).expect("formulas that make sense"));
        });
    }
    group.finish();
}

criterion_group!(benches, decisions);
criterion_main!(benches);
