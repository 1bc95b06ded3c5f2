//! The truth values of a statement at a point.

use crate::no_value::{NoValue, Undefined, Unknown};
use std::fmt;

/// The judgement on a statement at a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Judgement {
    /// True.
    True,
    /// False, and all parts are defined.
    False,
    /// Some part is undefined, so the claim makes no assertion about this point.
    Undefined(Undefined),
    /// All parts are defined, but the enclosures are too wide to decide whether it is true.
    Undecided,
    /// It is not known whether all parts are defined, or what their values are.
    Unknown(Unknown),
}

impl fmt::Display for Judgement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::True => write!(f, "true"),
            Self::False => write!(f, "false"),
            Self::Undefined(why) => write!(f, "undefined: {why}"),
            Self::Undecided => write!(f, "undecided"),
            Self::Unknown(why) => write!(f, "not known: {why}"),
        }
    }
}

impl Judgement {
    pub(crate) fn from_truth(truth: Option<bool>) -> Self {
        match truth {
            Some(true) => Self::True,
            Some(false) => Self::False,
            None => Self::Undecided,
        }
    }

    /// The truth value, if it is decided.
    #[must_use]
    pub fn decided(&self) -> Option<bool> {
        match self {
            Self::True => Some(true),
            Self::False => Some(false),
            Self::Undefined(_) | Self::Undecided | Self::Unknown(_) => None,
        }
    }

    /// Joins two parts; the result is undefined or unknown if one of them is.
    pub(crate) fn joined(
        self,
        other: Self,
        join: impl Fn(Option<bool>, Option<bool>) -> Option<bool>,
    ) -> Self {
        match (self, other) {
            // Of divisors it is asked whether they are zero where everything else has a value.
            (Self::Undefined(Undefined::ZeroDivisor), Self::Undefined(why)) => Self::Undefined(why),
            (Self::Undefined(why), _) | (_, Self::Undefined(why)) => Self::Undefined(why),
            (Self::Unknown(why), _) | (_, Self::Unknown(why)) => Self::Unknown(why),
            (a, b) => Self::from_truth(join(a.decided(), b.decided())),
        }
    }
}

impl From<NoValue> for Judgement {
    fn from(gap: NoValue) -> Self {
        match gap {
            NoValue::Undefined(why) => Self::Undefined(why),
            NoValue::Unknown(why) => Self::Unknown(why),
        }
    }
}
