//! Bernstein forms on pieces of a box, and whether pieces fill the box.

use std::collections::BTreeMap;
use torse_certificate::polynomial::{Monomial, Polynomial};
use torse_certificate::sign::Piece;
use torse_certificate::symbol::Symbol;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The coordinates of a domain.
#[derive(Debug)]
pub struct Sides {
    /// The bounded ones, and which of their ends belong to the domain.
    pub sides: Vec<(Symbol, bool, bool)>,
    /// The unbounded coordinates, which are nonnegative, and whether each is never zero.
    pub rays: BTreeMap<Symbol, bool>,
}

/// Whether each face of the piece that belongs to the domain has a positive coefficient. Ends of a piece inside of
/// the box always belong to the domain.
pub fn every_face(positive: &[&Vec<u32>], degrees: &[u32], bounds: &Sides, piece: &Piece) -> bool {
    let mut faces: Vec<Vec<Option<u32>>> = vec![vec![]];
    for ((side, degree), (low, high)) in bounds.sides.iter().zip(degrees).zip(&piece.region) {
        let (_, lower_closed, upper_closed) = side;
        let lower = *lower_closed || *low != integer(0);
        let upper = *upper_closed || *high != integer(1);
        let choices = [
            Some(None),
            lower.then_some(Some(0)),
            upper.then_some(Some(*degree)),
        ];
        let longer = |face: &Vec<Option<u32>>| -> Vec<Vec<Option<u32>>> {
            let choices = choices.iter().flatten();
            choices.map(|c| [face.as_slice(), &[*c]].concat()).collect()
        };
        faces = faces.iter().flat_map(longer).collect();
    }
    faces.iter().all(|face| {
        positive.iter().any(|index| {
            let mut pairs = index.iter().zip(face);
            pairs.all(|(j, place)| place.is_none_or(|place| *j == place))
        })
    })
}

/// The Bernstein coefficients by multi-index: a power t^e is, in degree d, the sum of `C(j,e)/C(d,e)` times the j-th
/// Bernstein polynomial, and likewise in each coordinate. Missing indices have the coefficient zero.
pub fn bernstein(
    polynomial: &Polynomial,
    sides: &[&Symbol],
    degrees: &[u32],
) -> Option<BTreeMap<Vec<u32>, Polynomial>> {
    const MAX_COEFFICIENTS: usize = 40_000;
    let mut forms: BTreeMap<Vec<u32>, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let power = |side: &&Symbol| {
            let own = monomial.iter().find(|(symbol, _)| symbol == *side);
            own.map_or(0, |(_, exponent)| *exponent)
        };
        let index = sides.iter().map(power).collect();
        let rest = monomial.iter().filter(|(s, _)| !sides.contains(&s));
        let slot = forms.entry(index).or_default();
        slot.enter(rest.cloned().collect(), coefficient.clone());
    }
    for (side, degree) in degrees.iter().enumerate() {
        let mut next: BTreeMap<Vec<u32>, Polynomial> = BTreeMap::new();
        for (index, coefficient) in &forms {
            let power = *index.get(side)?;
            for j in power..=*degree {
                let mut place = index.clone();
                *place.get_mut(side)? = j;
                let share = binomial(j, power) / binomial(*degree, power);
                let slot = next.entry(place).or_default();
                *slot = slot.plus(&coefficient.scaled(&share));
            }
        }
        if next.len() > MAX_COEFFICIENTS {
            return None;
        }
        forms = next;
    }
    Some(forms)
}

fn binomial(n: u32, k: u32) -> Rational {
    let factor = |i: u32| integer(i64::from(n - i)) / integer(i64::from(i + 1));
    (0..k.min(n)).map(factor).product()
}

/// Collects the constant coefficients (made of pi and roots) of the products of the other symbols.
pub fn by_rays(polynomial: &Polynomial) -> BTreeMap<Monomial, Polynomial> {
    let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let parts = monomial.iter().cloned();
        let (number, ray): (Monomial, Monomial) = parts.partition(|(s, _)| s.is_number());
        groups
            .entry(ray)
            .or_default()
            .enter(number, coefficient.clone());
    }
    groups
}

/// Whether the pieces fill the unit box: they lie in it, no two overlap, and their volumes add up to one.
pub fn fills(pieces: &[Piece], dimension: usize) -> bool {
    if dimension == 0 {
        return pieces.len() == 1;
    }
    let inside = |piece: &Piece| {
        let has_all_sides = piece.region.len() == dimension;
        let side = |(a, b): &(Rational, Rational)| *a >= integer(0) && a < b && *b <= integer(1);
        has_all_sides && piece.region.iter().all(side)
    };
    let apart = |p: &Piece, q: &Piece| {
        let mut sides = p.region.iter().zip(&q.region);
        sides.any(|((a, b), (c, d))| b <= c || d <= a)
    };
    let mut later = pieces.iter().enumerate();
    let disjoint = later.all(|(place, piece)| {
        let mut earlier = pieces.iter().take(place);
        earlier.all(|other| apart(piece, other))
    });
    let volume = |piece: &Piece| -> Rational { piece.region.iter().map(|(a, b)| b - a).product() };
    let total = pieces.iter().map(volume).fold(integer(0), |sum, v| sum + v);
    pieces.iter().all(inside) && disjoint && total == integer(1)
}
