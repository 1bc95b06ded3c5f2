//! Fills the holes of a file's sentence about a finding: numbers are computed, never typed.
//!
//! A hole is evaluated exactly, at the witness of the verdict if there is one. The text shows a certified enclosure
//! rounded to the requested digits: both of its ends round to the same text.

use torse_algebra::Ball;
use torse_algebra::rational::{integer, to_f64};
use torse_algebra::{Fraction, Rational};
use torse_prove::context::solve_given;
use torse_prove::decide::order::enclosure;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::quantity::Quantity;
use torse_prove::evaluate::value::Value;
use torse_prove::evidence::Witness;
use torse_syntax::derivation::{AuthorNote, Claim, DerivationError, Form, Piece, Written};
use torse_syntax::formula::parse;

/// Significant digits if the file does not ask for a number of them.
const DIGITS: usize = 4;

/// Precisions of the enclosures, tried in turn.
const BITS: [usize; 3] = [96, 256, 1024];

/// A fraction with a greater denominator is shown as a decimal.
const SIMPLE: i64 = 100;

/// Returns the finding of a claim in words; none if its file has none.
///
/// # Errors
///
/// A hole that is not a number for this finding, with its place in the file.
pub fn finding_sentence(
    claim: &Claim,
    witness: Option<&Witness>,
) -> Result<Option<String>, Box<DerivationError>> {
    match &claim.author_note {
        Some(note) => filled_in(claim, witness, note).map(Some),
        None => Ok(None),
    }
}

/// Fills the holes of a sentence about a claim.
///
/// # Errors
///
/// A hole that is not a number where the claim fails, with its place in the file.
pub fn filled_in(
    claim: &Claim,
    witness: Option<&Witness>,
    note: &AuthorNote,
) -> Result<String, Box<DerivationError>> {
    let mut evaluator = Evaluator::new(&claim.declarations);
    for (name, value) in witness.iter().flat_map(|witness| &witness.at) {
        if let Some(value) = exact(claim, value) {
            evaluator.fix(name.clone(), value);
        }
    }
    // Given equations determine their unknowns; if they do not, a hole that contains one is refused.
    let given: Vec<Written> = claim.given.iter().map(|h| h.formula.clone()).collect();
    if let Ok(solution) = solve_given(&given, &claim.unknowns, &evaluator) {
        evaluator.determine(solution);
    }
    let mut text = String::new();
    for piece in &note.pieces {
        match piece {
            Piece::Words(words) => text.push_str(words),
            Piece::Hole(formula, form) => text.push_str(&filled(&evaluator, formula, *form)?),
        }
    }
    Ok(text)
}

/// Parses a number of a witness.
fn exact(claim: &Claim, text: &str) -> Option<Fraction> {
    let expr = parse(text).ok()?;
    match Evaluator::new(&claim.declarations).evaluate(&expr).ok()? {
        Value::Scalar(quantity) => quantity.as_fraction().cloned(),
        _ => None,
    }
}

fn filled(
    evaluator: &Evaluator<'_>,
    formula: &Written,
    form: Form,
) -> Result<String, Box<DerivationError>> {
    let value = evaluator.evaluate(&formula.expr);
    let value = value.map_err(|fault| Box::new(fault.into_error(&formula.origin)))?;
    let number = match &value {
        Value::Scalar(quantity) => quantity.as_fraction().and_then(|f| shown(f, form)),
        Value::Matrix(rows) if form == Form::Degrees => angle(rows),
        _ => None,
    };
    number.ok_or_else(|| {
        let message = match form {
            Form::Degrees => "this is not the cosine of an angle at the witness of the finding",
            _ => "this is not a number at the witness of the finding",
        };
        let error = DerivationError::at(&formula.origin, formula.expr.place, message.to_owned());
        Box::new(error.with_help("a hole may use the symbols that the witness of the verdict has, and `at(..., symbol, value)` for others"))
    })
}

/// Returns a number in the requested form; none if it has free symbols, or if an angle is requested and it is no
/// cosine.
fn shown(value: &Fraction, form: Form) -> Option<String> {
    match form {
        Form::Plain => match value.as_rational() {
            Some(q) if *q.denom() <= SIMPLE.into() => Some(q.to_string()),
            _ => rounded(value, DIGITS, &|ball| Some(ball)),
        },
        Form::Digits(digits) => rounded(value, usize::from(digits), &|ball| Some(ball)),
        Form::Percent => {
            let hundred = value.clone() * Fraction::from(integer(100));
            Some(rounded(&hundred, DIGITS, &|ball| Some(ball))? + " %")
        }
        Form::Degrees => Some(rounded(value, DIGITS, &degrees)? + " degrees"),
    }
}

/// Returns the angle between two vectors, the rows of a matrix.
fn angle(rows: &[Vec<Quantity>]) -> Option<String> {
    let [first, second] = rows else {
        return None;
    };
    let product = |a: &[Quantity], b: &[Quantity]| -> Option<Fraction> {
        let zero = Fraction::from(integer(0));
        let mut pairs = a.iter().zip(b);
        pairs.try_fold(zero, |sum, (x, y)| {
            Some(sum + x.as_fraction()?.clone() * y.as_fraction()?.clone())
        })
    };
    let (along, a, b) = (
        product(first, second)?,
        product(first, first)?,
        product(second, second)?,
    );
    let square = (along.clone() * along.clone()).over(&(a * b)).ok()?;
    // Takes the root of an enclosure: an exact root need not exist.
    let obtuse = enclosure(&along, BITS[0])?.midpoint() < integer(0);
    let text = rounded(&square, DIGITS, &|ball| {
        let cosine = ball.sqrt().ok()?;
        degrees(if obtuse { -cosine } else { cosine })
    });
    Some(text? + " degrees")
}

/// Rounds an enclosure to significant digits.
fn rounded(
    value: &Fraction,
    digits: usize,
    enclose: &dyn Fn(Ball) -> Option<Ball>,
) -> Option<String> {
    BITS.into_iter().find_map(|bits| {
        let ball = enclose(enclosure(value, bits)?)?;
        let (lower, upper) = (ball.lower(), ball.upper());
        let text = significant(&lower, digits)?;
        (significant(&upper, digits).as_ref() == Some(&text)).then_some(text)
    })
}

/// Returns the angle in degrees of a cosine: bounds are guessed, and kept if the cosines of both enclose the number.
fn degrees(cosine: Ball) -> Option<Ball> {
    let bits = cosine.bits();
    let cosine_of = |angle: &Rational| {
        let part = Ball::from_rational(&(angle.clone() / integer(180)), bits);
        (part * Ball::pi(bits)).sin_cos().1
    };
    let (mut low, mut high) = (integer(0), integer(180));
    // Forty halvings leave less than 10^-9 of a degree.
    for _ in 0..40 {
        let middle = (low.clone() + &high) / integer(2);
        let at = cosine_of(&middle);
        if at.lower() > cosine.upper() {
            low = middle;
        } else if at.upper() < cosine.lower() {
            high = middle;
        } else {
            break;
        }
    }
    let one = integer(1);
    let is_cosine = cosine.lower() >= -one.clone() && cosine.upper() <= one;
    is_cosine.then(|| Ball::from_bounds(&low, &high, bits))
}

/// Rounds a number to significant digits; none for a number of absurd size.
fn significant(q: &Rational, digits: usize) -> Option<String> {
    if *q == integer(0) {
        return Some("0".to_owned());
    }
    let size = if *q < integer(0) {
        -q.clone()
    } else {
        q.clone()
    };
    let mut exponent = libm::log10(to_f64(&size)).floor();
    if !exponent.is_finite() || exponent.abs() > 300.0 {
        return None;
    }
    let ten = |power: i32| integer(10).pow(power);
    // The logarithm may be one off at powers of ten.
    exponent = exponent.clamp(-300.0, 300.0);
    #[expect(clippy::cast_possible_truncation, reason = "between -300 and 300")]
    let mut exponent = exponent as i32;
    while size >= ten(exponent + 1) {
        exponent += 1;
    }
    while size < ten(exponent) {
        exponent -= 1;
    }
    let places = i32::try_from(digits).ok()?.max(1) - 1 - exponent;
    let shifted = (size * ten(places)).round();
    let (shifted, places) = match usize::try_from(places) {
        Ok(places) => (shifted, places),
        Err(_) => (shifted * ten(-places), 0),
    };
    let all = format!(
        "{:0>width$}",
        shifted.to_integer().to_string(),
        width = places + 1
    );
    let (whole, fraction) = all.split_at(all.len() - places);
    let sign = if *q < integer(0) { "-" } else { "" };
    let point = if places > 0 { "." } else { "" };
    Some(format!("{sign}{whole}{point}{fraction}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::ratio;

    #[test]
    fn digits_that_count_are_rounded() {
        for (q, digits, text) in [
            (ratio(1, 3), 4, "0.3333"),
            (ratio(2, 3), 2, "0.67"),
            (ratio(-12345, 1), 3, "-12300"),
            (ratio(9996, 1000), 3, "10.00"),
            (ratio(1, 1000), 2, "0.0010"),
            (ratio(0, 1), 2, "0"),
        ] {
            assert_eq!(significant(&q.unwrap(), digits).unwrap(), text);
        }
    }

    #[test]
    fn angles_come_from_their_cosines() {
        let half = Fraction::from(ratio(1, 3).unwrap());
        assert_eq!(shown(&half, Form::Degrees).unwrap(), "70.53 degrees");
        let beyond = Fraction::from(ratio(4, 3).unwrap());
        assert_eq!(shown(&beyond, Form::Degrees), None);
    }
}
