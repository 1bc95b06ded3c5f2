//! What names stand for at one place of a tree: SEMANTICS.md, "Names".
//!
//! There are two layers. *Local* names are bound by sums, products, the heads of definitions and the variables, parameters and
//! counters of bases: the bodies of definitions do not see them. *Moved* names are declared symbols to which `at`, `D`, `integral`,
//! `coefficients` or a witness gives another value: whatever is read inside sees them, through definitions as well. Both
//! layers are lists that share their tails, so that a closure keeps the one that it was made in.

use crate::series::Series;
use crate::value::Value;
use std::rc::Rc;

/// A name that a binder of the text binds.
#[derive(Debug)]
pub(super) struct Local<'a, N> {
    pub name: &'a str,
    pub value: Value<N>,
    /// Whether it takes integers alone: an index or a counter. Nothing is differentiated by it.
    pub is_index: bool,
}

/// Which number of a declared symbol is moved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Part {
    /// The number itself, or the generic coordinate of a vector.
    Whole,
    /// A coordinate of a vector, counted from 1.
    Coordinate(u8),
    /// A member of a family, and its coordinate.
    Member(Vec<i64>, Option<u8>),
}

/// A number of the point that has another value here.
#[derive(Debug)]
pub(super) struct Moved<'a, N> {
    pub symbol: &'a str,
    pub part: Part,
    pub value: Series<N>,
    /// Equal for bindings of one number to one value, different otherwise.
    pub serial: u64,
}

/// A list that shares its tail.
#[derive(Debug)]
pub(super) struct Chain<T>(Option<Rc<(T, Chain<T>)>>);

impl<T> Clone for Chain<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T> Chain<T> {
    pub const fn new() -> Self {
        Self(None)
    }

    pub fn with(&self, first: T) -> Self {
        Self(Some(Rc::new((first, self.clone()))))
    }

    /// From the innermost binding outwards.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        std::iter::successors(self.0.as_deref(), |link| link.1.0.as_deref()).map(|link| &link.0)
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }
}

/// The two layers.
#[derive(Debug)]
pub(super) struct Environment<'a, N> {
    pub local: Chain<Local<'a, N>>,
    pub moved: Chain<Moved<'a, N>>,
}

impl<N> Clone for Environment<'_, N> {
    fn clone(&self) -> Self {
        Self {
            local: self.local.clone(),
            moved: self.moved.clone(),
        }
    }
}

impl<'a, N> Environment<'a, N> {
    /// Where nothing is bound.
    pub fn outermost() -> Self {
        Self {
            local: Chain::new(),
            moved: Chain::new(),
        }
    }

    /// Whether nothing is bound.
    pub fn is_outermost(&self) -> bool {
        self.local.is_empty() && self.moved.is_empty()
    }

    /// What the body of a definition sees.
    pub fn outside(&self) -> Self {
        Self {
            local: Chain::new(),
            moved: self.moved.clone(),
        }
    }

    /// With a name bound by a binder of the text.
    pub fn with_local(&self, name: &'a str, value: Value<N>, is_index: bool) -> Self {
        let local = Local {
            name,
            value,
            is_index,
        };
        Self {
            local: self.local.with(local),
            moved: self.moved.clone(),
        }
    }

    /// What a binder of the text binds to a name.
    pub fn local(&self, name: &str) -> Option<&Local<'a, N>> {
        self.local.iter().find(|local| local.name == name)
    }

    /// The value that a number of the point has here instead of its own.
    pub fn moved(&self, symbol: &str, part: &Part) -> Option<&Moved<'a, N>> {
        let mut all = self.moved.iter();
        all.find(|moved| moved.symbol == symbol && moved.part == *part)
    }
}
