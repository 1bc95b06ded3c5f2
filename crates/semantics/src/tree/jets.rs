//! The derivatives of smooth functions that a point specifies, and functions with these derivatives.

use crate::series::Series;
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, parse};

/// The derivatives of smooth functions that a point specifies.
#[derive(Debug, Clone)]
pub(crate) struct Jets {
    /// For each function: the text of each place, its tree, and the orders that are specified there.
    pub(super) places: BTreeMap<String, Vec<(String, Expr, BTreeSet<usize>)>>,
    /// The number of additional random coefficients.
    pub(super) drawn: usize,
}

/// The number of additional random coefficients if a point specifies derivatives, and if it specifies none.
const DRAWN: usize = 6;
const ALL_DRAWN: usize = 24;

impl Jets {
    /// No derivatives are specified; all coefficients are random.
    pub const fn none() -> Self {
        Self {
            places: BTreeMap::new(),
            drawn: ALL_DRAWN,
        }
    }

    /// The derivatives among the names, such as `f''(u)`.
    pub fn new<'n>(declarations: &Declarations, names: impl IntoIterator<Item = &'n str>) -> Self {
        let mut places: BTreeMap<String, Vec<(String, Expr, BTreeSet<usize>)>> = BTreeMap::new();
        for name in names {
            let Some((head, rest)) = name.split_once('(') else {
                continue;
            };
            let function = head.trim_end_matches('\'');
            let Some(text) = rest.strip_suffix(')') else {
                continue;
            };
            if declarations.function(function).is_none() {
                continue;
            }
            let Ok(tree) = parse(text) else {
                continue;
            };
            let order = head.len() - function.len();
            let all = places.entry(function.to_owned()).or_default();
            match all.iter_mut().find(|(own, ..)| own == text) {
                Some((.., orders)) => {
                    orders.insert(order);
                }
                None => all.push((text.to_owned(), tree, BTreeSet::from([order]))),
            }
        }
        Self {
            places,
            drawn: DRAWN,
        }
    }
}

impl Jets {
    /// Whether a place is a formula that contains this symbol.
    pub fn are_at(&self, symbol: &str) -> bool {
        let mut places = self.places.values().flatten();
        places.any(|(_, tree, _)| tree.names().contains(&symbol))
    }
}

/// A polynomial in Newton form for each coordinate: the sum of `c_k (t - z_0) ... (t - z_(k-1))`.
#[derive(Debug)]
pub(super) struct Smooth<N> {
    pub nodes: Vec<Series<N>>,
    pub coefficients: Vec<Vec<Series<N>>>,
    /// Whether its values are vectors.
    pub is_vector: bool,
}
