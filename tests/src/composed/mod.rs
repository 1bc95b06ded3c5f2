//! Statements in which everything is composed with everything, by a grammar.
//!
//! The kinds of [`random`](crate::random) keep to one subject each. Here a claim draws some [`Feature`]s, random declarations
//! and a [`Form`] of statement, which is true by how it is made: a term and another of its forms, a derivative written out, a
//! symbol and what it is assumed to be. In half of the claims one place slips. Whether the statement is true is then asked of an
//! evaluator of its own, in doubles, at many points of the domain, degenerate ones among them: a claim that slipped is kept
//! only if a point refutes it, so its truth is known without the crates that are judged.
//!
//! Everything is a function of a seed.

pub mod change;
pub mod forms;
pub mod jet;
pub mod make;
pub mod read;
pub mod rewrite;
pub mod scene;
pub mod slip;
pub mod statement;
pub mod tally;
pub mod term;
pub mod value;

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;
use forms::Form;
use make::Feature;
use scene::{Point, Scene};
use statement::Statement;
use value::Evaluator;

/// At how many points a statement is tried.
const POINTS: usize = 80;
/// A statement is kept if it says something at so many of them.
const LEAST_POINTS: usize = 6;

/// A composed claim.
#[derive(Debug)]
pub struct Composed {
    /// How it was made.
    pub form: Form,
    /// What may occur in it.
    pub features: Vec<Feature>,
    /// The claim, with its truth.
    pub claim: Claim,
    /// Its declarations.
    pub scene: Scene,
    /// The points at which it was tried.
    pub points: Vec<Point>,
    /// The points at which it is false.
    pub failing: Vec<Point>,
}

/// The composed claim of this number.
#[must_use]
pub fn claim(seed: u64, number: u64) -> Composed {
    let mut stream = Stream::new(seed, 2_000, number);
    loop {
        if let Some(made) = attempt(&mut stream, number) {
            return made;
        }
    }
}

fn attempt(stream: &mut Stream, number: u64) -> Option<Composed> {
    let mut features = make::features(stream);
    let form = stream.pick(&Form::ALL);
    if matches!(form, Form::Derivative | Form::Mixed) && !features.contains(&Feature::Rate) {
        features.push(Feature::Rate);
    }
    let mut scene = make::scene(stream, &features);
    let mut statement = forms::stated(form, stream, &features, &mut scene);
    let slips = stream.once_in(2);
    if slips {
        statement = slipped(stream, &statement)?;
    }
    let points: Vec<Point> = (0..POINTS).filter_map(|_| scene.point(stream)).collect();
    let judged: Vec<(&Point, bool)> = points
        .iter()
        .filter_map(|point| Some((point, Evaluator::new(&scene, point).statement(&statement)?)))
        .collect();
    if judged.len() < LEAST_POINTS {
        return None;
    }
    let failing: Vec<&Point> = judged
        .iter()
        .filter(|(_, holds)| !holds)
        .map(|(p, _)| *p)
        .collect();
    let truth = match (failing.first(), slips) {
        (Some(point), _) => Truth::Fails(format!("{:?}", point.numbers)),
        (None, false) if judged.len() == POINTS => Truth::Holds,
        (None, false) => Truth::Conditional,
        // It may be true all the same.
        (None, true) => return None,
    };
    let mut claim = written(&scene, &statement, truth);
    claim.number = number;
    let failing = failing.into_iter().cloned().collect();
    Some(Composed {
        form,
        features,
        claim,
        points,
        failing,
        scene,
    })
}

/// The statement with a slip in one of its terms.
fn slipped(stream: &mut Stream, statement: &Statement) -> Option<Statement> {
    let target = stream.below(statement.terms());
    let (mut place, mut done) = (0, false);
    let changed = statement.with_terms(&mut |term| {
        place += 1;
        let other = match place - 1 == target {
            true => slip::slipped(stream, term),
            false => None,
        };
        done |= other.is_some();
        other.unwrap_or_else(|| term.clone())
    });
    (done && changed != *statement).then_some(changed)
}

/// As a claim of a derivation file.
fn written(scene: &Scene, statement: &Statement, truth: Truth) -> Claim {
    let states = match statement {
        Statement::Compare(a, relation, b) => {
            States::Compare(a.to_string(), relation, b.to_string())
        }
        other => States::Other(other.to_string()),
    };
    let mut claim = Claim::new(Kind::Composed, states, truth);
    for (name, range) in &scene.reals {
        claim = claim.symbol(name, range.written);
    }
    for (name, low, high, bounded) in &scene.integers {
        let range = match bounded {
            true => format!("{{ integer = '{low}..{high}' }}"),
            false => format!("{{ integer = '>= {low}' }}"),
        };
        claim = claim.symbol(name, range);
    }
    for name in &scene.functions {
        claim = claim.symbol(name, "{ function = 1 }");
    }
    for (name, high) in &scene.families {
        claim = claim.symbol(name, format!("{{ family = 1, indices = ['0..{high}'] }}"));
    }
    for family in &scene.bases {
        let quoted = |parts: &[term::Part]| {
            let all: Vec<String> = parts.iter().map(|part| format!("'{part}'")).collect();
            all.join(", ")
        };
        let [variable, ..] = family.variables.as_slice() else {
            continue;
        };
        let lines = format!(
            "variable = '{variable}'\ndegree = {}\nseeds = [{}]\nstep = [{}]",
            family.degree(),
            quoted(&family.seeds),
            quoted(&family.step)
        );
        claim = claim.basis(&family.name, lines);
    }
    for definition in &scene.definitions {
        let head = match definition.parameters.as_slice() {
            [] => definition.name.clone(),
            all => format!("{}({})", definition.name, all.join(", ")),
        };
        claim = claim.letting(&head, definition.body.to_string());
    }
    for hypothesis in &scene.hypotheses {
        let text = hypothesis.statement.to_string();
        match &hypothesis.unknown {
            Some(unknown) => {
                claim.given.push(text);
                claim.unknowns.push(unknown.clone());
            }
            None => claim.assume.push(text),
        }
    }
    claim
}
