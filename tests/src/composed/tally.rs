//! What the engine and the semantics say of composed claims, against what is true.

use super::statement::Statement;
use super::value::Evaluator;
use super::{Composed, claim, read};
use crate::random::claim::Truth;
use crate::random::judge::{outcome, semantics};
use std::collections::BTreeMap;
use std::fmt;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::correction::Correction;

/// What an answer is, beside the truth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Answer {
    /// Right.
    Right,
    /// Not decided.
    Open,
    /// Outside of what is declared to be decided, which is said.
    Refused,
    /// A false statement is said to hold.
    FalseHolds,
    /// A true statement is said to be false.
    FalseAccusation,
    /// A correction is false.
    FalseCorrection,
    /// The levels of assurance contradict each other.
    Contradiction,
    /// The engine gave up in disorder.
    Panic,
}

impl Answer {
    /// All of them, in the order of the table.
    pub const ALL: [Self; 8] = [
        Self::Right,
        Self::Open,
        Self::Refused,
        Self::FalseHolds,
        Self::FalseAccusation,
        Self::FalseCorrection,
        Self::Contradiction,
        Self::Panic,
    ];

    /// Whether it is neither right nor withheld.
    #[must_use]
    pub fn is_wrong(self) -> bool {
        !matches!(self, Self::Right | Self::Open | Self::Refused)
    }

    /// Its word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Open => "open",
            Self::Refused => "refused",
            Self::FalseHolds => "false-holds",
            Self::FalseAccusation => "accused",
            Self::FalseCorrection => "correction",
            Self::Contradiction => "contradict",
            Self::Panic => "panic",
        }
    }
}

/// What the engine says of a claim.
#[must_use]
pub fn answer(made: &Composed) -> (Answer, String) {
    let found = match outcome(&made.claim) {
        Ok(found) => found,
        Err(message) if message == "panic" => return (Answer::Panic, message),
        Err(message) => return (Answer::Refused, message),
    };
    if let Some(contradiction) = found.contradiction() {
        return (Answer::Contradiction, contradiction.to_owned());
    }
    if let Some(correction) = found.correction().and_then(|c| disproved(made, c)) {
        return (Answer::FalseCorrection, correction);
    }
    let conditions = texts(found.conditions());
    let witness = found.witness().map(|w| &w.at);
    let said = format!("{:?} {conditions:?} {witness:?}", found.verdict());
    let answer = match (&made.claim.truth, found.verdict()) {
        // Two errors of the engine are errors of reading: it says what it does not decide.
        (_, Verdict::Undecided) => Answer::Open,
        (Truth::Fails(_), Verdict::False | Verdict::Misprint)
        | (Truth::Holds | Truth::Conditional, Verdict::Holds | Verdict::Conditional) => {
            Answer::Right
        }
        (Truth::Fails(_), Verdict::Conditional) if excused(made, &conditions) => Answer::Right,
        (Truth::Fails(_), _) => Answer::FalseHolds,
        _ => Answer::FalseAccusation,
    };
    (answer, said)
}

fn texts(formulas: &[Formula]) -> Vec<&str> {
    formulas
        .iter()
        .map(|formula| formula.text.as_str())
        .collect()
}

/// The statement of a correction, if it is false at a point at which its conditions are true. One that cannot be read here says
/// nothing.
fn disproved(made: &Composed, correction: &Correction) -> Option<String> {
    let text = &correction.statement.text;
    let statement = read::statement(text)?;
    let conditions = texts(&correction.conditions);
    let conditions: Vec<Statement> = conditions
        .into_iter()
        .map(read::statement)
        .collect::<Option<_>>()?;
    let wrong = made.points.iter().any(|point| {
        let evaluator = Evaluator::new(&made.scene, point);
        let is = |statement, truth| evaluator.statement(statement) == Some(truth);
        conditions.iter().all(|condition| is(condition, true)) && is(&statement, false)
    });
    wrong.then(|| format!("the correction {text} is false"))
}

/// Whether at each point at which the statement is false a condition is false too. A condition that cannot be read here
/// excuses nothing.
fn excused(made: &Composed, conditions: &[&str]) -> bool {
    let conditions: Vec<Statement> = conditions
        .iter()
        .filter_map(|text| read::statement(text))
        .collect();
    made.failing.iter().all(|point| {
        let evaluator = Evaluator::new(&made.scene, point);
        conditions
            .iter()
            .any(|condition| evaluator.statement(condition) == Some(false))
    })
}

/// What the semantics alone says of a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Seen {
    /// What is true: it fails at a point, or it is true at some and fails at none.
    Right,
    /// No point at which a false statement fails, or none at which a true one is decided.
    Nothing,
    /// That a true statement fails, and where.
    Wrong(String),
}

/// What the semantics alone says, against what is true.
#[must_use]
pub fn seen(made: &Composed) -> Seen {
    let Ok(points) = semantics(&made.claim) else {
        return Seen::Nothing;
    };
    match (&made.claim.truth, points.failing) {
        (Truth::Fails(_), Some(_)) => Seen::Right,
        (Truth::Holds | Truth::Conditional, None) if points.holding > 0 => Seen::Right,
        (Truth::Holds | Truth::Conditional, Some(point)) => {
            Seen::Wrong(format!("the semantics finds it false at {point}"))
        }
        _ => Seen::Nothing,
    }
}

/// Counts of answers.
#[derive(Debug, Clone, Default)]
pub struct Counts {
    /// By form, then by feature: how many true claims, and answers.
    rows: BTreeMap<String, (u64, BTreeMap<Answer, u64>)>,
    /// Every answer that is wrong: claim, truth, answer.
    pub wrong: Vec<String>,
    /// Every claim that is open or refused, and why.
    pub undecided: Vec<String>,
    /// What the semantics says against the truth.
    pub contradicted: Vec<String>,
    /// Of how many claims the semantics alone says what is true.
    pub seconded: u64,
}

impl Counts {
    /// How many answers of this kind there are.
    #[must_use]
    pub fn of(&self, answer: Answer) -> u64 {
        let all = self.rows.get("all");
        all.and_then(|(_, answers)| answers.get(&answer))
            .copied()
            .unwrap_or(0)
    }

    /// Adds a claim.
    pub fn add(&mut self, made: &Composed) {
        let (answer, said) = answer(made);
        let holds = !matches!(made.claim.truth, Truth::Fails(_));
        let mut rows = vec!["all".to_owned(), format!("form {}", made.form.word())];
        rows.extend(
            made.features
                .iter()
                .map(|feature| format!("with {}", feature.word())),
        );
        for row in rows {
            let (truths, answers) = self.rows.entry(row).or_default();
            *truths += u64::from(holds);
            *answers.entry(answer).or_default() += 1;
        }
        let text = || {
            format!(
                "{}truth: {:?}\nanswer: {said}\n",
                made.claim.file(),
                made.claim.truth
            )
        };
        match answer {
            Answer::Right => {}
            Answer::Open | Answer::Refused => self.undecided.push(text()),
            _ => self.wrong.push(format!("{}\n{}", answer.word(), text())),
        }
        match seen(made) {
            Seen::Right => self.seconded += 1,
            Seen::Nothing => {}
            Seen::Wrong(how) => self.contradicted.push(format!("{}{how}\n", text())),
        }
    }

    /// Adds all that another one counted.
    pub fn join(&mut self, other: Self) {
        for (row, (truths, answers)) in other.rows {
            let own = self.rows.entry(row).or_default();
            own.0 += truths;
            for (answer, count) in answers {
                *own.1.entry(answer).or_default() += count;
            }
        }
        self.wrong.extend(other.wrong);
        self.undecided.extend(other.undecided);
        self.contradicted.extend(other.contradicted);
        self.seconded += other.seconded;
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<18} {:>7} {:>7}", "", "claims", "true")?;
        for answer in Answer::ALL {
            write!(f, " {:>11}", answer.word())?;
        }
        for (row, (truths, answers)) in &self.rows {
            let total: u64 = answers.values().sum();
            write!(f, "\n{row:<18} {total:>7} {truths:>7}")?;
            for answer in Answer::ALL {
                write!(f, " {:>11}", answers.get(&answer).copied().unwrap_or(0))?;
            }
        }
        Ok(())
    }
}

/// The claims `first..first + count` of a seed.
#[must_use]
pub fn run(seed: u64, first: u64, count: u64) -> Counts {
    let mut counts = Counts::default();
    for number in first..first + count {
        counts.add(&claim(seed, number));
    }
    counts
}

/// The claims `0..count` of a seed, by so many threads.
#[must_use]
pub fn run_by(threads: u64, seed: u64, count: u64) -> Counts {
    let each = count.div_ceil(threads.max(1));
    std::thread::scope(|scope| {
        let part = |n: u64| {
            let builder = std::thread::Builder::new().stack_size(64 << 20);
            let (first, rest) = (n * each, count.saturating_sub(n * each));
            builder.spawn_scoped(scope, move || run(seed, first, each.min(rest)))
        };
        let parts: Vec<_> = (0..threads).map(part).collect();
        let mut counts = Counts::default();
        for part in parts.into_iter().flatten() {
            if let Ok(part) = part.join() {
                counts.join(part);
            }
        }
        counts
    })
}

/// Of how many of the claims `0..count` of a seed the semantics alone says what is true, and what it says against the truth.
#[must_use]
pub fn semantics_alone(seed: u64, count: u64) -> (u64, Vec<String>) {
    let (mut seconded, mut wrong) = (0, vec![]);
    for number in 0..count {
        let made = claim(seed, number);
        match seen(&made) {
            Seen::Right => seconded += 1,
            Seen::Nothing => {}
            Seen::Wrong(how) => wrong.push(format!("{}{how}\n", made.claim.file())),
        }
    }
    (seconded, wrong)
}
