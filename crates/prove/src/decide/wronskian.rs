//! The search for cells on which determinants are positive, see [`torse_certificate::wronskian`] for the theorem.
//!
//! A cell is tried by the very computation that the checker does, since it is the only rigorous one: what is found here are its
//! data, how many places and how large a disc. One cell from 0 to 1/2 is enough for all families that were met; where it is not
//! the half is cut, a few times.

use super::domain::Domain;
use super::value::plain;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Rational};
use torse_certificate::wronskian::cell::Front;
use torse_certificate::wronskian::{AtDegree, Cell, Half, Operator, Seeds, Unfit, Wronskians};
use torse_core::{Degrees, Family};

/// The highest degree for which the search is worth its time: the work grows with the fifth power of it.
const MAX_DEGREE: u8 = 10;
/// How often a half is cut at most.
const CUTS: u32 = 3;
/// The largest determinant that is multiplied out.
const MAX_EXACT: usize = 2;

/// A certificate that the functions of these degrees are totally positive.
///
/// # Errors
/// Why there is none, in words.
pub fn positive(
    basis: &Family,
    degrees: Degrees,
    step: &[Fraction; 2],
    seeds: &[Fraction],
    domain: &Domain<'_>,
) -> Result<Wronskians, String> {
    if degrees.most > MAX_DEGREE {
        return Err(format!("degrees above {MAX_DEGREE} take too much work"));
    }
    if !domain.solved().is_empty() {
        return Err("a symbol is determined by a hypothesis".to_owned());
    }
    let x = Fraction::named(basis.variable());
    if *step != [Fraction::integer(1) - x.clone(), x] {
        return Err("the step is not 1 - x and x".to_owned());
    }
    let functions = seeds.iter().map(|seed| Some(plain(seed.as_polynomial()?)));
    let functions: Option<Vec<_>> = functions.collect();
    let functions = functions.ok_or("a seed has a divisor")?;
    let set = |name: &str| domain.declarations.symbol(name);
    let words = |unfit: Unfit| unfit.to_string();
    let seeds = Seeds::declared(&functions, basis.variable(), &set).map_err(words)?;
    let exchange = seeds.symmetry();
    let mirrored = Operator::new(seeds.mirrored()).map_err(words)?;
    let front = Operator::new(seeds).map_err(words)?;
    let one = |degree: u8| {
        let found = |operator| half(operator, degree).map_err(|u| format!("degree {degree}: {u}"));
        Ok(AtDegree {
            degree,
            front: found(&front)?,
            back: match exchange {
                Some(_) => None,
                None => Some(found(&mirrored)?),
            },
        })
    };
    Ok(Wronskians {
        exchange,
        degrees: (degrees.least..=degrees.most)
            .map(one)
            .collect::<Result<_, String>>()?,
    })
}

/// The cells of one half.
fn half(operator: &Operator, degree: u8) -> Result<Half, Unfit> {
    let mut exact = vec![];
    loop {
        let front = Front::new(operator, degree, &exact)?;
        match cells(&front, degree) {
            Ok(cells) => return Ok(Half { exact, cells }),
            // A coefficient of a small determinant may be zero.
            Err(Unfit::Sign { rank, .. }) if rank <= MAX_EXACT && exact.is_empty() => {
                exact.push(u8::try_from(rank).unwrap_or(0));
            }
            Err(unfit) => return Err(unfit),
        }
    }
}

/// Cells that fill [0, 1/2], the longest that do: what fails is cut into halves.
fn cells(front: &Front<'_>, degree: u8) -> Result<Vec<Cell>, Unfit> {
    let end = ratio(1, 2).unwrap_or_default();
    let mut waiting: Vec<(Rational, u32)> = vec![(end, 0)];
    let (mut from, mut found) = (integer(0), vec![]);
    while let Some((until, cuts)) = waiting.last().cloned() {
        // Met on the bases of papers; a few more places than are needed.
        let cell = Cell {
            until: until.clone(),
            nodes: (6 * u16::from(degree) + 4).max(20),
            radius: integer(2),
        };
        match front.cell(&from, &cell) {
            Ok(()) => {
                waiting.pop();
                from = until;
                found.push(cell);
            }
            Err(_) if cuts < CUTS => {
                if let Some(last) = waiting.last_mut() {
                    last.1 += 1;
                }
                let sum = &from + &until;
                waiting.push((sum * ratio(1, 2).unwrap_or_default(), cuts + 1));
            }
            Err(unfit) => return Err(unfit),
        }
    }
    Ok(found)
}
