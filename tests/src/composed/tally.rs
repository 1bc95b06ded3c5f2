//! What the engine and the semantics say of composed claims, against what is true.

use super::forms::Form;
use super::statement::Statement;
use super::value::Evaluator;
use super::{Composed, claim, read};
use crate::random::claim::Truth;
use crate::random::judge::{outcome, semantics};
use std::collections::BTreeMap;
use std::fmt;
use torse_syntax::words::Verdict;

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
    /// The levels of assurance contradict each other.
    Contradiction,
    /// The engine gave up in disorder.
    Panic,
}

impl Answer {
    /// All of them, in the order of the table.
    pub const ALL: [Self; 7] = [
        Self::Right,
        Self::Open,
        Self::Refused,
        Self::FalseHolds,
        Self::FalseAccusation,
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
    let conditions: Vec<&str> = found.conditions().iter().map(|c| c.text.as_str()).collect();
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

/// Whether the semantics contradicts what is true.
#[must_use]
pub fn contradicted(made: &Composed) -> Option<String> {
    let points = semantics(&made.claim).ok()?;
    match (&made.claim.truth, points.failing) {
        (Truth::Holds | Truth::Conditional, Some(point)) => {
            Some(format!("the semantics finds it false at {point}"))
        }
        _ => None,
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

    /// How many answers to claims of this form are wrong.
    #[must_use]
    pub fn wrong_of(&self, form: Form) -> u64 {
        let answers = self.rows.get(&format!("form {}", form.word()));
        let wrong = |(answer, count): (&Answer, &u64)| answer.is_wrong().then_some(*count);
        answers.map_or(0, |(_, answers)| answers.iter().filter_map(wrong).sum())
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
        if let Some(how) = contradicted(made) {
            self.contradicted.push(format!("{}{how}\n", text()));
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
