//! Random enclosures as the numbers compute them.

use crate::random::number::Q;
use crate::random::seed::Stream;
use serde_json::{Value, json};
use torse_numbers::{Ball, Rational, Scalar, rational};

const OPERATIONS: [&str; 14] = [
    "pi",
    "sum",
    "difference",
    "product",
    "quotient",
    "power",
    "root",
    "sine",
    "cosine",
    "exponential",
    "logarithm",
    "arc tangent",
    "arc sine",
    "quarter",
];

/// Line `number` of the seed: an operation, its arguments as intervals, the exponent of a power, and the interval that is
/// to contain the value of the operation at all numbers of the arguments; none if it is refused.
#[must_use]
pub fn line(seed: u64, number: u64) -> Value {
    let mut stream = Stream::new(seed, 1_000, number);
    let bits = stream.pick(&[1, 8, 30, 64, 65, 128, 320, 700, 1280]);
    let exact = stream.once_in(2);
    let one = argument(&mut stream, bits, exact);
    let more = if stream.once_in(3) { bits + 13 } else { bits };
    let other = argument(&mut stream, more, exact);
    let exponent = u32::try_from(stream.below(9)).unwrap_or(0);
    let operation = stream.pick(&OPERATIONS);
    let found = match operation {
        "pi" => Some(Ball::pi(bits)),
        "sum" => Some(&one + &other),
        "difference" => Some(&one - &other),
        "product" => Some(&one * &other),
        "quotient" => one.divided_by(&other).ok(),
        "power" => Some(one.powi(exponent)),
        "root" => one.sqrt().ok(),
        "sine" => Some(one.sin_cos().0),
        "cosine" => Some(one.sin_cos().1),
        "exponential" => one.exp().ok(),
        "logarithm" => one.ln().ok(),
        "arc tangent" => one.atan().ok(),
        "arc sine" => one.asin().ok(),
        _ => one.quarter_turn().ok().map(|(sine, _)| sine),
    };
    let ends = |ball: &Ball| json!([ball.lower().to_string(), ball.upper().to_string()]);
    json!({
        "operation": operation,
        "arguments": [ends(&one), ends(&other)],
        "exponent": exponent,
        "bits": found.as_ref().map(Ball::bits),
        "exact": one.width() == rational::integer(0) && other.width() == rational::integer(0),
        "value": found.as_ref().map(ends),
    })
}

/// A number or an interval: small, near zero, near multiples of quarter turns, or large.
fn argument(stream: &mut Stream, bits: usize, exact: bool) -> Ball {
    let size = match stream.below(5) {
        0 => Q::new(stream.nonzero(9), stream.integer(1, 1_000_000_000)),
        1 => Q::new(stream.nonzero(1_000_000), stream.integer(1, 7)),
        2 => Q::int(stream.integer(-6, 6)),
        3 => Q::new(stream.nonzero(40) * 355, 226),
        _ => stream.fraction(),
    };
    let width = Q::new(
        stream.integer(0, 9),
        stream.pick(&[1, 3, 1_000, 1_000_000_007]),
    );
    let low = Ball::from_rational(&fraction(size), bits);
    if exact {
        // The upper end: an exact number of this precision.
        let upper = low.upper();
        return Ball::from_rational(&upper, bits);
    }
    let high = Ball::from_rational(&fraction(size + width), bits);
    low.hull(&high)
}

fn fraction(q: Q) -> Rational {
    Rational::new(q.above.into(), q.below.into())
}
