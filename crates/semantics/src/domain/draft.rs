//! A point under construction: each number is drawn from its declared set when it is first needed.

use super::stream::Stream;
use super::{Domain, set};
use crate::name::Name;
use crate::real::Real;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use torse_numbers::Affine;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::SymbolKind;

/// The largest depth to which bounds of integers refer to other integers.
const MAX_DEPTH: usize = 16;
/// The largest number of numbers of a point.
const MAX_NAMES: usize = 4000;

/// A point under construction.
pub(crate) struct Draft<'a> {
    domain: &'a Domain<'a>,
    stream: Stream,
    values: RefCell<BTreeMap<Name, Real>>,
    rounded: RefCell<BTreeSet<Name>>,
    determined: RefCell<BTreeSet<Name>>,
    /// Whether a declared range turned out to be empty.
    pub empty: Cell<bool>,
}

impl<'a> Draft<'a> {
    /// An empty draft for one attempt; symbols are drawn from the narrowed sets.
    pub fn new(domain: &'a Domain<'a>, stream: Stream) -> Self {
        Self {
            domain,
            stream,
            values: RefCell::default(),
            rounded: RefCell::default(),
            determined: RefCell::default(),
            empty: Cell::new(false),
        }
    }

    /// The random choices of this attempt.
    pub fn stream(&self) -> &Stream {
        &self.stream
    }

    /// The number of this name, drawn if necessary; `None` if that is impossible.
    pub fn value(&self, name: &Name) -> Option<Real> {
        self.value_within(name, MAX_DEPTH)
    }

    fn value_within(&self, name: &Name, depth: usize) -> Option<Real> {
        if let Some(known) = self.values.borrow().get(name) {
            return Some(known.clone());
        }
        if self.values.borrow().len() >= MAX_NAMES {
            return None;
        }
        let label = self.stream.label(name);
        let declared = self.domain.set(name)?;
        let set = self.domain.narrowed.sets.get(name.declared());
        let drawn = match (name, set.unwrap_or(declared)) {
            (Name::Symbol(_), SymbolKind::Real(interval)) => {
                let drawn = set::in_interval(interval, &self.stream, &label);
                if set::contains(interval, &drawn, false) != Some(true) {
                    // The bounds are in the wrong order, or the only remaining point does not belong to the interval.
                    self.empty.set(true);
                    return None;
                }
                drawn
            }
            (Name::Symbol(_), SymbolKind::Integer { least, most }) => {
                let bound = |form: &Option<Affine>| match form {
                    None => Some(None),
                    Some(form) => self.form(form, depth).map(Some),
                };
                let (least, most) = (bound(least)?, bound(most)?);
                let Some(drawn) = set::integer_between(least, most, &self.stream, &label) else {
                    self.empty.set(true);
                    return None;
                };
                integer(drawn).into()
            }
            _ => set::anywhere(&self.stream, &label).into(),
        };
        self.values.borrow_mut().insert(name.clone(), drawn.clone());
        Some(drawn)
    }

    /// The value of an index form, or `None` if a symbol in it has no integer value.
    fn form(&self, form: &Affine, depth: usize) -> Option<i64> {
        let depth = depth.checked_sub(1)?;
        let mut multiples = form.multiples();
        multiples.try_fold(form.constant(), |sum, (name, multiple)| {
            let value = self.value_within(&Name::Symbol(name.into()), depth)?;
            let value = value.as_rational().filter(|v| v.is_integer())?.to_integer();
            sum.checked_add(multiple.checked_mul(i64::try_from(&value).ok()?)?)
        })
    }

    /// Replaces the value of a number.
    pub fn set(&self, name: &Name, value: Real) {
        self.values.borrow_mut().insert(name.clone(), value);
    }

    /// Records that a number satisfies the equations only approximately.
    pub fn round(&self, name: &Name) {
        self.rounded.borrow_mut().insert(name.clone());
    }

    /// Whether a number satisfies the equations only approximately.
    pub fn is_rounded(&self, name: &Name) -> bool {
        self.rounded.borrow().contains(name)
    }

    /// The numbers that satisfy the equations only approximately.
    pub fn rounded(&self) -> BTreeSet<Name> {
        self.rounded.borrow().clone()
    }

    /// Records numbers that linear equations determine uniquely, given all others.
    pub fn determine(&self, names: impl IntoIterator<Item = Name>) {
        self.determined.borrow_mut().extend(names);
    }

    /// Whether the domain has no other point: the equations determine all numbers of this one.
    pub fn is_determined(&self) -> bool {
        let determined = self.determined.borrow();
        let pinned = |name: &Name| match name {
            Name::Symbol(symbol) => self.domain.narrowed.pinned.contains(symbol),
            Name::Coordinate(..) | Name::Member(..) => false,
        };
        self.values
            .borrow()
            .keys()
            .all(|name| pinned(name) || determined.contains(name))
    }

    /// Calls a function with all numbers drawn so far; it must not draw others.
    pub fn look<T>(&self, at: impl FnOnce(&BTreeMap<Name, Real>) -> T) -> T {
        at(&self.values.borrow())
    }

    /// All numbers drawn so far.
    pub fn values(&self) -> BTreeMap<Name, Real> {
        self.values.borrow().clone()
    }
}
