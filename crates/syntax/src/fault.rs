//! Why a formula has no value: mistakes of the author, and limits of the engine.

use crate::derivation::{DerivationError, Origin};
use crate::formula::{Place, hints};
use torse_numbers::ExactError;

/// What went wrong.
#[derive(Debug, Clone, thiserror::Error)]
pub enum Problem {
    /// A name that nothing declares.
    #[error("`{name}` is not declared")]
    UnknownName {
        /// The name.
        name: String,
        /// The declared name that looks most like it.
        similar: Option<String>,
    },
    /// A value of the wrong type.
    #[error("{what} where {wanted} is needed")]
    WrongType {
        /// What stands there.
        what: &'static str,
        /// What would be right.
        wanted: &'static str,
    },
    /// Vectors or matrices whose sizes do not fit.
    #[error("{left} does not fit {right}")]
    Shapes {
        /// One size.
        left: String,
        /// The other.
        right: String,
    },
    /// A wrong number of arguments or indices.
    #[error("`{name}` takes {wanted}, found {found}")]
    Count {
        /// The function or family.
        name: String,
        /// What it takes.
        wanted: String,
        /// How many there are.
        found: usize,
    },
    /// A shape parameter that was left out where a parameter of a definition has its name.
    #[error("`{family}` leaves out its argument `{argument}`, which is ambiguous here: write it")]
    LeftOut {
        /// The basis family.
        family: String,
        /// The argument.
        argument: String,
    },
    /// An index outside its range.
    #[error("the index {index} of `{name}` is outside {range}")]
    IndexOutside {
        /// The family.
        name: String,
        /// The index.
        index: String,
        /// The range.
        range: String,
    },
    /// A divisor that is zero.
    #[error("division by zero: {divisor} vanishes")]
    ZeroDivisor {
        /// The divisor.
        divisor: String,
    },
    /// Definitions that call each other without end, or nearly so.
    #[error("definitions are nested deeper than {limit} levels: is one defined through itself?")]
    Circular {
        /// The limit.
        limit: usize,
    },
    /// Something the engine cannot carry out symbolically.
    #[error("{what}")]
    Limit {
        /// What it is, in words.
        what: String,
    },
}

/// A problem and its place.
#[derive(Debug, Clone)]
pub struct Fault {
    /// What went wrong.
    pub problem: Box<Problem>,
    /// Where in the text of the formula.
    pub place: Place,
    /// The text, once it is known; a fault in a definition points into the definition.
    pub origin: Option<Origin>,
}

impl Fault {
    /// A fault at a place.
    #[must_use]
    pub fn at(place: Place, problem: Problem) -> Self {
        Self {
            problem: Box::new(problem),
            place,
            origin: None,
        }
    }

    /// A limit of the engine at a place.
    #[must_use]
    pub fn limit(place: Place, what: impl Into<String>) -> Self {
        Self::at(place, Problem::Limit { what: what.into() })
    }

    /// The fault of an exact operation.
    #[must_use]
    pub fn exact(place: Place, error: ExactError) -> Self {
        match error {
            ExactError::DivisionByZero { divisor } => {
                Self::at(place, Problem::ZeroDivisor { divisor })
            }
            other => Self::limit(place, other.to_string()),
        }
    }

    /// Whether the author is not to blame: the formula means something that is not reached here.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        matches!(
            *self.problem,
            Problem::Limit { .. } | Problem::ZeroDivisor { .. }
        )
    }

    /// The fault in the text `origin`, unless it already points into another text.
    #[must_use]
    pub fn within(mut self, origin: &Origin) -> Self {
        self.origin.get_or_insert_with(|| origin.clone());
        self
    }

    /// The error for the author of the file.
    #[must_use]
    pub fn into_error(self, origin: &Origin) -> DerivationError {
        let origin = self.origin.unwrap_or_else(|| origin.clone());
        let error = DerivationError::at(&origin, self.place, self.problem.to_string());
        match help(&self.problem) {
            Some(help) => error.with_help(help),
            None => error,
        }
    }
}

/// What would be right.
fn help(problem: &Problem) -> Option<String> {
    match problem {
        Problem::UnknownName { name, similar } => Some(unknown(name, similar.as_deref())),
        Problem::Count {
            wanted, found: 2.., ..
        } if wanted.contains("ind") => {
            Some("the coordinate of a member stands in brackets of its own: `P[i][2]`".to_owned())
        }
        Problem::WrongType {
            wanted: "a function",
            ..
        } => Some("a product is written with `*`".to_owned()),
        _ => None,
    }
}

fn unknown(name: &str, similar: Option<&str>) -> String {
    let declared = "Names are declared under [symbols], [define], [basis] or `let`";
    if similar == Some(name) {
        return format!(
            "`{name}` is no number by itself: a function takes arguments, `{name}(x)`, a basis its index and degree, \
             `{name}[0,2](x)`"
        );
    }
    match (hints::name(name), similar) {
        (Some(hint), _) => hint.to_owned(),
        (None, Some(similar)) => format!("did you mean `{similar}`? {declared}"),
        (None, None) => {
            "declare it under [symbols], [define], [basis] or in the claim's `let`".to_owned()
        }
    }
}
