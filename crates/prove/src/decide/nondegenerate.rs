//! Counterexamples within the meaning of a paper: no plane or direction is zero and no two vectors are one, where the
//! statement fails without that as well.
//!
//! A point of the domain satisfies every hypothesis that is stated, and a referee looks at what is not: four zeros are
//! no plane, three equal points no curve. Vectors of declared dimension are made different from zero and from each
//! other by the simplest ones that leave the point a counterexample. One of three or more vectors of space may be the
//! origin.

use std::collections::BTreeMap;
use torse_algebra::{Affine, Fraction, Symbol};
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};

/// A point: exact values of symbols.
type Point = BTreeMap<Symbol, Fraction>;

/// The most points that are looked at.
const MAX_TRIES: usize = 60;
/// The dimension of vectors that are no points: coordinates of planes.
const PLANE: u8 = 4;

/// A vector of the point: its coordinates as far as they have values, with their places.
struct Vector {
    dimension: u8,
    coordinates: Vec<(i64, Symbol)>,
}

/// The point with its vectors different from zero and from each other, as far as `fails` allows.
#[must_use]
pub fn make_nondegenerate(
    point: Point,
    declarations: &Declarations,
    fails: &dyn Fn(&Point) -> bool,
) -> Point {
    let vectors = vectors(&point, declarations);
    let mut point = point;
    let mut tries = 0;
    for (position, vector) in vectors.iter().enumerate() {
        let others = |point: &Point| -> Vec<Vec<(i64, Fraction)>> {
            let others = vectors.iter().enumerate();
            let others =
                others.filter(|(other, of)| *other != position && of.dimension == vector.dimension);
            others.map(|(_, other)| other.values(point)).collect()
        };
        let own = vector.values(&point);
        let zero = own.iter().all(|(_, value)| value.is_zero());
        let earlier = vectors.iter().take(position);
        let repeated = earlier
            .filter(|other| other.dimension == vector.dimension)
            .any(|other| other.values(&point) == own);
        let origin = zero && vector.dimension < PLANE && others(&point).len() > 1;
        if !repeated && (!zero || origin) {
            continue;
        }
        let others = others(&point);
        for values in simple(vector.coordinates.len()) {
            let mut moved = point.clone();
            for ((_, symbol), value) in vector.coordinates.iter().zip(values) {
                moved.insert(symbol.clone(), Fraction::integer(value));
            }
            if others.contains(&vector.values(&moved)) {
                continue;
            }
            tries += 1;
            if tries > MAX_TRIES {
                return point;
            }
            if fails(&moved) {
                point = moved;
                break;
            }
        }
    }
    point
}

impl Vector {
    fn values(&self, point: &Point) -> Vec<(i64, Fraction)> {
        let found = self.coordinates.iter();
        found
            .filter_map(|(place, symbol)| Some((*place, point.get(symbol)?.clone())))
            .collect()
    }
}

/// The vectors of two coordinates and more, in the order of the point.
fn vectors(point: &Point, declarations: &Declarations) -> Vec<Vector> {
    let mut found: Vec<(&str, &[Affine], Vector)> = vec![];
    for symbol in point.keys() {
        let Symbol::Indexed(name, indices) = symbol else {
            continue;
        };
        let dimension = match declarations.symbol(name) {
            Some(SymbolKind::Vector(Some(dimension))) => *dimension,
            Some(SymbolKind::Family {
                dimension: Some(dimension),
                ..
            }) => *dimension,
            _ => continue,
        };
        let Some((last, member)) = indices.split_last() else {
            continue;
        };
        let Some(place) = last.as_number().filter(|_| dimension > 1) else {
            continue;
        };
        let coordinate = (place, symbol.clone());
        let known = found
            .iter_mut()
            .find(|(other, of, _)| **other == **name && *of == member);
        match known {
            Some((_, _, vector)) => vector.coordinates.push(coordinate),
            None => {
                let coordinates = vec![coordinate];
                let vector = Vector {
                    dimension,
                    coordinates,
                };
                found.push((name, member, vector));
            }
        }
    }
    let vectors = found.into_iter().map(|(_, _, vector)| vector);
    vectors.filter(|v| v.coordinates.len() > 1).collect()
}

/// Simple vectors: one coordinate 1, then two, then one coordinate 2.
fn simple(length: usize) -> Vec<Vec<i64>> {
    let with = |at: &[(usize, i64)]| -> Vec<i64> {
        let value = |place| at.iter().find(|(p, _)| *p == place).map_or(0, |(_, v)| *v);
        (0..length).map(value).collect()
    };
    let ones = (0..length).map(|place| with(&[(place, 1)]));
    let pairs = (0..length).flat_map(|one| (one + 1..length).map(move |other| (one, other)));
    let pairs = pairs.map(|(one, other)| with(&[(one, 1), (other, 1)]));
    let twos = (0..length).map(|place| with(&[(place, 2)]));
    ones.chain(pairs).chain(twos).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn declared(names: &[(&str, u8)]) -> Declarations {
        let mut declarations = Declarations::default();
        for (name, dimension) in names {
            declarations.declare(name, SymbolKind::Vector(Some(*dimension)));
        }
        declarations
    }

    fn point(vectors: &[(&str, &[i64])]) -> Point {
        let mut point = Point::new();
        for (name, values) in vectors {
            for (place, value) in (1..).zip(*values) {
                let symbol = Symbol::Indexed((*name).into(), vec![Affine::number(place)]);
                point.insert(symbol, Fraction::integer(*value));
            }
        }
        point
    }

    #[test]
    fn no_plane_is_zero_and_no_two_are_one() {
        let declarations = declared(&[("d", 4), ("h", 4)]);
        let zero = point(&[("d", &[0, 0, 0, 0]), ("h", &[0, 0, 0, 0])]);
        let found = make_nondegenerate(zero, &declarations, &|_| true);
        assert_eq!(found, point(&[("d", &[1, 0, 0, 0]), ("h", &[0, 1, 0, 0])]));
    }

    #[test]
    fn one_of_several_points_is_the_origin_and_a_direction_alone_is_not_zero() {
        let several = declared(&[("o", 3), ("p", 3), ("q", 3)]);
        let start = point(&[("o", &[0, 0, 0]), ("p", &[1, 0, 0]), ("q", &[1, 0, 0])]);
        let found = make_nondegenerate(start, &several, &|_| true);
        let moved = point(&[("o", &[0, 0, 0]), ("p", &[1, 0, 0]), ("q", &[0, 1, 0])]);
        assert_eq!(found, moved);
        let alone =
            make_nondegenerate(point(&[("g", &[0, 0, 0])]), &declared(&[("g", 3)]), &|_| {
                true
            });
        assert_eq!(alone, point(&[("g", &[1, 0, 0])]));
    }

    #[test]
    fn what_would_not_fail_stays() {
        let declarations = declared(&[("d", 4)]);
        let zero = point(&[("d", &[0, 0, 0, 0])]);
        assert_eq!(
            make_nondegenerate(zero.clone(), &declarations, &|_| false),
            zero
        );
    }
}
