//! The meaning of names at one place of a tree: SEMANTICS.md, "Names".
//!
//! There are two layers. *Local* names are bound by sums, products, the heads of definitions, and the variables,
//! parameters and counters of bases; the bodies of definitions do not see them. *Moved* names are declared symbols to
//! which `at`, `D`, `integral`, `coefficients` or a witness gives another value; everything evaluated inside sees
//! them, including the bodies of definitions. Both layers are lists with shared tails, so that a closure keeps the
//! environment in which it was made.

use crate::series::Series;
use crate::value::Value;
use std::rc::Rc;

/// A local name.
#[derive(Debug)]
pub(super) struct Local<'a, N> {
    pub name: &'a str,
    pub value: Value<N>,
    /// Whether it takes integer values only (an index or a counter), so that it cannot be differentiated by.
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
    /// A serial number: equal for bindings of one number to equal values, different otherwise.
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

    /// Iterates from the innermost binding outwards.
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
    /// The environment without bindings.
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

    /// The environment of the body of a definition.
    pub fn outside(&self) -> Self {
        Self {
            local: Chain::new(),
            moved: self.moved.clone(),
        }
    }

    /// Binds a local name.
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

    /// The local binding of a name.
    pub fn local(&self, name: &str) -> Option<&Local<'a, N>> {
        self.local.iter().find(|local| local.name == name)
    }

    /// The moved value of a number of the point.
    pub fn moved(&self, symbol: &str, part: &Part) -> Option<&Moved<'a, N>> {
        let mut all = self.moved.iter();
        all.find(|moved| moved.symbol == symbol && moved.part == *part)
    }
}
