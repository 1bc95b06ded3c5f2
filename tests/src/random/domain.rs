//! Intervals of random claims, and points in them.

use super::number::Q;
use super::polynomial::{Polynomial, SLOTS};
use super::seed::Stream;

/// An interval as declared, with some of its points.
#[derive(Debug, Clone)]
pub struct Domain {
    /// What stands after the name.
    pub declaration: &'static str,
    /// Points of it, as pairs above, below.
    points: &'static [(i128, i128)],
}

const DOMAINS: [Domain; 6] = [
    Domain {
        declaration: "{}",
        points: &[(1, 1), (2, 1), (-1, 1), (3, 1), (-2, 1), (1, 2), (-3, 1)],
    },
    Domain {
        declaration: "{ in = '[0, 1]' }",
        points: &[(1, 1), (1, 2), (1, 3), (3, 4), (1, 5), (0, 1)],
    },
    Domain {
        declaration: "{ in = '(0, 1)' }",
        points: &[(1, 2), (1, 3), (3, 4), (1, 5), (2, 5)],
    },
    Domain {
        declaration: "{ in = '[2, inf)' }",
        points: &[(3, 1), (2, 1), (5, 1), (7, 2), (4, 1)],
    },
    Domain {
        declaration: "{ in = '(-1, 3/2]' }",
        points: &[(1, 1), (1, 2), (3, 2), (-1, 2), (1, 3), (0, 1)],
    },
    Domain {
        declaration: "{ in = '(-inf, -1/2)' }",
        points: &[(-1, 1), (-2, 1), (-3, 1), (-3, 4), (-5, 2)],
    },
];

impl Domain {
    /// Some interval.
    pub fn some(stream: &mut Stream) -> Self {
        let wide = stream.once_in(2);
        DOMAINS[if wide { 0 } else { stream.below(DOMAINS.len()) }].clone()
    }

    /// Some of its points.
    pub fn points(&self) -> impl Iterator<Item = Q> + '_ {
        self.points
            .iter()
            .map(|&(above, below)| Q::new(above, below))
    }

    /// Some point of it.
    pub fn point(&self, stream: &mut Stream) -> Q {
        let (above, below) = stream.pick(self.points);
        Q::new(above, below)
    }
}

/// A point of these intervals at which the polynomial does not vanish, in words.
#[must_use]
pub fn where_not_zero(polynomial: &Polynomial, names: &[&str], domains: &[Domain]) -> String {
    let mut points = vec![[Q::ONE; SLOTS]];
    for (slot, domain) in domains.iter().enumerate().take(SLOTS) {
        points = points
            .iter()
            .flat_map(|point| {
                domain.points().map(move |q| {
                    let mut point = *point;
                    point[slot] = q;
                    point
                })
            })
            .collect();
    }
    let found = points.iter().find(|p| polynomial.value(p) != Q::ZERO);
    match found {
        Some(point) => at(names, point),
        None => "almost everywhere".to_owned(),
    }
}

/// `x = 1, y = 2`
#[must_use]
pub fn at(names: &[&str], point: &[Q]) -> String {
    let values: Vec<String> = names
        .iter()
        .zip(point)
        .map(|(name, q)| format!("{name} = {q}"))
        .collect();
    values.join(", ")
}
