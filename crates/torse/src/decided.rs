//! One statement, decided.

use crate::error::Error;
use crate::explanation::{Explanation, short};
use crate::verifier::Verifier;
use serde::ser::{Error as _, Serialize, Serializer};
use serde_json::Value;
use std::sync::Arc;
use torse_prove::evidence::Witness;
use torse_report::{Mathematics, finding_json, glossary};
use torse_syntax::derivation::{
    DerivationError, LoadError, Origin, Source, latex_question, question,
};
use torse_syntax::formula::parse;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

/// Decides one statement about real numbers: is it true for all values for which it has a meaning?
///
/// # Errors
/// [`Error::Load`] for a statement that cannot be read, [`Error::Formula`] for one that makes no sense, each with its
/// place.
///
/// ```
/// assert_eq!(torse::decide("sin(x)^2 + cos(x)^2 == 1")?.is_true(), Some(true));
/// let wrong = torse::decide("(a + b)^2 == a^2 + b^2")?;
/// assert_eq!(wrong.is_true(), Some(false));
/// let at = wrong.witness().ok_or("it is refuted by a point")?.at.clone();
/// assert_eq!(at, [("a".to_owned(), "1".to_owned()), ("b".to_owned(), "1".to_owned())]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn decide(statement: &str) -> Result<Decided, Error> {
    decide_where(statement, "")
}

/// Decides one statement in a setting: declarations, definitions and hypotheses with semicolons or commas between, such as
/// `x in [0, 1]; n in 0..; p: vector 3; f: function 1; H(t) := t^2; a > 0`.
///
/// # Errors
/// As [`decide`].
///
/// ```
/// use torse::Verdict;
/// assert_eq!(torse::decide_where("x + 1/x >= 2", "x > 0")?.verdict(), Verdict::Holds);
/// let sum = torse::decide_where("sum(i, 0, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1", "n in 0..")?;
/// assert_eq!(sum.is_true(), Some(true));
/// // It needs a condition that nobody has stated, so it is neither true nor false.
/// let quotient = torse::decide("x/x == 1")?;
/// assert_eq!((quotient.verdict(), quotient.is_true()), (Verdict::Conditional, None));
/// # Ok::<(), torse::Error>(())
/// ```
pub fn decide_where(statement: &str, setting: &str) -> Result<Decided, Error> {
    Verifier::new().decide(statement, setting)
}

/// Writes a formula as exact SymPy code: quotients and decimals become rationals, never floats.
///
/// # Errors
/// [`Error::Formula`] for one that cannot be read.
///
/// ```
/// assert_eq!(torse::sympy("(a + b)^2/3 == 1/4")?, "Eq((a + b)**2/3, Rational(1, 4))");
/// let place = torse::sympy("a +").unwrap_err().place().ok_or("it has a place")?;
/// assert_eq!((place.file.as_str(), place.line, place.column), ("the formula", 1, 4));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sympy(formula: &str) -> Result<String, Error> {
    let source = Arc::new(Source::new("the formula", formula));
    let origin = Origin::all(&source);
    let read =
        parse(formula).map_err(|error| Box::new(DerivationError::syntax(&origin, &error)))?;
    Ok(torse_syntax::notation::sympy(&read))
}

impl Verifier<'_> {
    /// Decides one statement in a setting, as [`decide_where`].
    ///
    /// # Errors
    /// As [`decide`], and [`Error::Cancelled`].
    ///
    /// ```
    /// use torse::{Verifier, WorkBudget};
    /// let hasty = Verifier::new().with_budget(WorkBudget::new(1));
    /// assert_eq!(hasty.decide("(a + b)^9 == (b + a)^9", "")?.is_true(), None);
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn decide(&self, statement: &str, setting: &str) -> Result<Decided, Error> {
        let paper = question(statement, setting)?;
        let claim = paper.claims.first().ok_or_else(|| LoadError::Empty {
            path: "the statement".to_owned(),
        })?;
        let outcome = self.claim(&paper.head.id, claim)?;
        Ok(Decided { outcome })
    }

    /// Decides one statement in LaTeX in a setting.
    ///
    /// # Errors
    /// As [`decide`]; [`Error::Load`] also for what has two readings, or none.
    ///
    /// ```
    /// use torse::Verifier;
    /// let decided = Verifier::new().decide_latex(r"\cos 2x = 1 - 2\sin^2 x", "")?;
    /// assert_eq!(decided.is_true(), Some(true));
    /// assert!(Verifier::new().decide_latex("1/2x = x/2", "").is_err());
    /// # Ok::<(), torse::Error>(())
    /// ```
    pub fn decide_latex(&self, latex: &str, setting: &str) -> Result<Decided, Error> {
        let (statement, setting) = latex_question(latex, setting)?;
        self.decide(&statement, &setting)
    }
}

/// A decided statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decided {
    outcome: Outcome,
}

/// As a line of `torse decide - --format json`.
///
/// ```
/// let value = serde_json::to_value(torse::decide("x + x == 2*x")?)?;
/// assert_eq!(value["verdict"], "holds");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl Serialize for Decided {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let text = self.json().map_err(S::Error::custom)?;
        let value: Value = serde_json::from_str(&text).map_err(S::Error::custom)?;
        value.serialize(serializer)
    }
}

impl Decided {
    /// The verdict.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        self.outcome.verdict()
    }

    /// Whether it is true; none if that is undecided, needs a condition, or if the statement says nothing.
    #[must_use]
    pub fn is_true(&self) -> Option<bool> {
        match self.verdict() {
            Verdict::Holds => Some(true),
            Verdict::False | Verdict::Misprint => Some(false),
            _ => None,
        }
    }

    /// The verdict in a word: `holds`, `conditional`, `misprint`, `false`, `undecided`, `vacuous`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        glossary::verdict(self.verdict()).key
    }

    /// The evidence, in a word: `identity`, `witness` and others.
    #[must_use]
    pub fn evidence(&self) -> Option<&'static str> {
        self.outcome
            .evidence()
            .map(|own| glossary::evidence(own).key)
    }

    /// The statement as it was understood.
    #[must_use]
    pub fn statement(&self) -> Option<&str> {
        self.outcome.parsed().map(|formula| formula.text.as_str())
    }

    /// A counterexample, with the values of both sides there.
    #[must_use]
    pub fn witness(&self) -> Option<&Witness> {
        self.outcome.witness()
    }

    /// The statement with the smallest change that makes it true, if one was found and proved.
    #[must_use]
    pub fn corrected(&self) -> Option<&str> {
        let correction = self.outcome.correction()?;
        Some(&correction.statement.text)
    }

    /// The conditions under which it is true, if it needs any.
    #[must_use]
    pub fn conditions(&self) -> Vec<&str> {
        let conditions = self.outcome.conditions().iter();
        conditions.map(|formula| formula.text.as_str()).collect()
    }

    /// Whether the checker accepts the proof; none if there is no proof.
    #[must_use]
    pub fn is_replayed(&self) -> Option<bool> {
        self.outcome.replay().map(|replay| replay.replayed)
    }

    /// The steps of the decision, in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        words::steps(&self.outcome)
    }

    /// All of it, labelled.
    #[must_use]
    pub fn explanation(&self) -> Explanation {
        short(&self.outcome)
    }

    /// One object of JSON on a line, with the fields of a claim of `torse verify --format json`.
    ///
    /// # Errors
    /// [`Error::Report`] when the serialiser fails, which strings give it no reason to.
    pub fn json(&self) -> Result<String, Error> {
        Ok(finding_json(&self.outcome)?)
    }

    /// The statement as LaTeX mathematics, without dollar signs.
    ///
    /// ```
    /// let decided = torse::decide("x/2 + x/2 == x")?;
    /// let latex = decided.latex().unwrap_or_default();
    /// assert!(latex.contains(r"\frac"), "{latex}");
    /// # Ok::<(), torse::Error>(())
    /// ```
    #[must_use]
    pub fn latex(&self) -> Option<String> {
        Some(Mathematics::read(self.statement()?)?.latex)
    }

    /// The statement as MathML, in pieces between which a line may be broken.
    #[must_use]
    pub fn mathml(&self) -> Option<Vec<String>> {
        Some(Mathematics::read(self.statement()?)?.mathml)
    }

    /// The finding with all its parts.
    #[must_use]
    pub fn outcome(&self) -> &Outcome {
        &self.outcome
    }
}
