//! Why a formula has no value: either a mistake of the author, or a limit of the program.

use crate::derivation::{DerivationError, Origin};
use crate::formula::{Place, hints, is_name};
use torse_numbers::ExactError;

/// The kind of problem.
#[derive(Debug, Clone, thiserror::Error)]
pub enum Problem {
    /// An undeclared name.
    #[error("`{name}` is not declared")]
    UnknownName {
        /// The name.
        name: String,
        /// The declared name that is most similar.
        similar: Option<String>,
    },
    /// A value of the wrong type.
    #[error("{what} where {wanted} is needed")]
    WrongType {
        /// What was found.
        what: &'static str,
        /// What is needed.
        wanted: &'static str,
    },
    /// Vectors or matrices whose sizes do not match.
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
    /// An argument of a basis was left out where a parameter of a definition has the same name.
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
    /// Definitions that refer to one another in a circle, or are nested too deeply.
    #[error("definitions are nested deeper than {limit} levels: is one defined through itself?")]
    Circular {
        /// The limit.
        limit: usize,
    },
    /// An operation that is not supported, or exceeds a limit.
    #[error("{what}")]
    Limit {
        /// A description.
        what: String,
    },
}

/// A problem with its place.
#[derive(Debug, Clone)]
pub struct Fault {
    /// What went wrong.
    pub problem: Box<Problem>,
    /// The place in the text of the formula.
    pub place: Place,
    /// The text, once it is known; a fault inside of a definition points into the definition.
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

    /// A power whose exponent is no integer: out of scope, with what to write in its place.
    #[must_use]
    pub fn exponent(place: Place) -> Self {
        Self::limit(
            place,
            "powers whose exponents are not integers are out of scope: a square root is written `sqrt(x)`, `a^b` with a positive base \
             `exp(b*log(a))`, the exponential function `exp(x)`; of another root `r` state `r^3 == x` under `assume`, and declare an \
             exponent that is an integer as one",
        )
    }

    /// Converts the error of an exact operation.
    #[must_use]
    pub fn exact(place: Place, error: ExactError) -> Self {
        match error {
            ExactError::DivisionByZero { divisor } => {
                Self::at(place, Problem::ZeroDivisor { divisor })
            }
            other => Self::limit(place, other.to_string()),
        }
    }

    /// Whether the author made no mistake: the formula is valid, but exceeds what the program supports, or a divisor
    /// vanishes.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        matches!(
            *self.problem,
            Problem::Limit { .. } | Problem::ZeroDivisor { .. }
        )
    }

    /// Sets the text that the place refers to, unless it is set already.
    #[must_use]
    pub fn within(mut self, origin: &Origin) -> Self {
        self.origin.get_or_insert_with(|| origin.clone());
        self
    }

    /// Makes the error that is shown to the author of the file; `origin` is the text if the fault has none.
    #[must_use]
    pub fn into_error(self, origin: &Origin) -> DerivationError {
        let origin = self.origin.unwrap_or_else(|| origin.clone());
        let error = DerivationError::at(&origin, self.place, self.problem.to_string());
        let own = origin.text(self.place).unwrap_or("");
        let help = match origin.is_typed() {
            true => typed_help(&self.problem, own).or_else(|| help(&self.problem)),
            false => help(&self.problem),
        };
        match help {
            Some(help) => error.with_help(help),
            None => error,
        }
    }
}

/// A hint at what would be correct in a single statement with its setting; `text` is what stands at the place.
fn typed_help(problem: &Problem, text: &str) -> Option<String> {
    match problem {
        Problem::UnknownName { name, similar } if similar.as_deref() != Some(name.as_str()) => {
            if let Some(hint) = hints::name(name) {
                return Some(hint.to_owned());
            }
            let similar = similar.as_ref();
            let similar = similar.map(|similar| format!("did you mean `{similar}`? "));
            Some(format!(
                "{}declare a function by --where \"{name}(i, t) := ...\" or \"{name}: function 1\", a vector by \"{name}: vector 3\"",
                similar.unwrap_or_default()
            ))
        }
        Problem::WrongType { wanted, .. } if wanted.starts_with("an integer") && is_name(text) => {
            Some(format!(
                "`{text}` is taken for a real number, but a bound of a sum, an index and what a binomial coefficient takes are \
                 integers: add --where \"{text} in 0..\""
            ))
        }
        _ => None,
    }
}

/// A hint at what would be correct.
fn help(problem: &Problem) -> Option<String> {
    match problem {
        Problem::UnknownName { name, similar } => Some(unknown(name, similar.as_deref())),
        Problem::Count {
            wanted, found: 2.., ..
        } if wanted.contains("ind") => {
            Some("the coordinate of a member stands in brackets of its own: `P[i][2]`".to_owned())
        }
        Problem::Count {
            name, found: 2.., ..
        } if name == "det" => {
            Some("a determinant has its rows in square brackets: `det([a, b, c])`".to_owned())
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
            "`{name}` is not a number by itself: a function takes arguments, `{name}(x)`, a basis its index and degree, \
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
