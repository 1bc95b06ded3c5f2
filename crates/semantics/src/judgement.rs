//! What a statement can be at a point.

use crate::no_value::{NoValue, Undefined, Unknown};
use std::fmt;

/// What a statement is at a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Judgement {
    /// True.
    True,
    /// False, and all parts are defined.
    False,
    /// Some part is undefined: the claim says nothing about this point.
    Undefined(Undefined),
    /// All parts are defined, but the enclosures do not tell whether it is true.
    Undecided,
    /// Whether all parts are defined, or their values, is not known.
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

    /// Whether the statement is settled here.
    #[must_use]
    pub fn decided(&self) -> Option<bool> {
        match self {
            Self::True => Some(true),
            Self::False => Some(false),
            Self::Undefined(_) | Self::Undecided | Self::Unknown(_) => None,
        }
    }

    /// What two parts make together; undefined or unknown if one of them is.
    pub(crate) fn joined(
        self,
        other: Self,
        join: impl Fn(Option<bool>, Option<bool>) -> Option<bool>,
    ) -> Self {
        match (self, other) {
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
