//! Printed decimals: digits from long division, integer roots and the known digits of pi.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// pi to 30 digits after the point, cut off.
const PI: i128 = 3_141_592_653_589_793_238_462_643_383_279;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let slip = stream.once_in(2);
    let entries = 1 + stream.below(3);
    let wrong = if slip { stream.below(entries) } else { entries };
    let mut values = vec![];
    let mut printed = vec![];
    for entry in 0..entries {
        let (value, digits) = number(stream, entry == wrong);
        values.push(value);
        printed.push(digits);
    }
    let text = match entries {
        1 => format!("agrees({}, {})", values[0], printed[0]),
        _ => format!("agrees([{}], [{}])", values.join(", "), printed.join(", ")),
    };
    let truth = match slip {
        true => Truth::Fails("everywhere".to_owned()),
        false => Truth::Holds,
    };
    Claim::new(Kind::Decimals, States::Other(text), truth).symbol("x", "{}")
}

/// A value and its digits, the last one wrong if wanted.
fn number(stream: &mut Stream, wrong: bool) -> (String, String) {
    let sign = if stream.once_in(3) { "-" } else { "" };
    // The value in units of the last digit: the whole part, and whether the rest is more or less than a half.
    let (value, places, whole, up): (String, usize, String, bool) = match stream.below(4) {
        0 | 1 => {
            let below = stream.integer(2, 97);
            let above = stream.integer(1, 400);
            let places = stream.pick(&[1, 2, 3, 4, 8, 40, 76, 77, 90]);
            let (digits, rest) = divided(above, below, places);
            if 2 * rest == below {
                return number(stream, wrong);
            }
            (format!("{above}/{below}"), places, digits, 2 * rest > below)
        }
        2 => {
            let n = stream.integer(2, 900);
            let places = stream.integer(1, 12);
            let scale = 10_i128.pow(u32::try_from(places).unwrap_or(1));
            let square = n * scale * scale;
            let root = integer_root(square);
            let up = (2 * root + 1) * (2 * root + 1) <= 4 * square;
            (
                format!("sqrt({n})"),
                usize::try_from(places).unwrap_or(1),
                root.to_string(),
                up && root * root != square,
            )
        }
        _ => {
            let (above, below) = (stream.integer(1, 50), stream.integer(1, 50));
            let places = stream.integer(1, 12);
            let scale = 10_i128.pow(u32::try_from(30 - places).unwrap_or(18));
            let scaled = PI * above / below;
            let (whole, rest) = (scaled / scale, scaled % scale);
            (
                format!("{above}/{below}*pi"),
                usize::try_from(places).unwrap_or(1),
                whole.to_string(),
                2 * rest >= scale,
            )
        }
    };
    let change = match (wrong, up) {
        // Away by two units, or rounded the wrong way.
        (true, false) => stream.pick(&[1, 2, 3, -1, -2]),
        (true, true) => stream.pick(&[2, 3, -1, -2]),
        (false, true) => stream.pick(&[0, 1]),
        (false, false) => 0,
    };
    let whole = added(&whole, change);
    if whole.starts_with('-') {
        return number(stream, wrong);
    }
    let padded = format!("{whole:0>width$}", width = places + 1);
    let (before, after) = padded.split_at(padded.len() - places);
    (format!("{sign}{value}"), format!("{sign}{before}.{after}"))
}

/// The digits of `above/below` with this many after the point, as one number, and the rest.
fn divided(above: i128, below: i128, places: usize) -> (String, i128) {
    let mut digits = (above / below).to_string();
    let mut rest = above % below;
    for _ in 0..places {
        digits.push_str(&(rest * 10 / below).to_string());
        rest = rest * 10 % below;
    }
    (digits, rest)
}

/// A number of any length and a small one, added digit by digit.
fn added(digits: &str, change: i128) -> String {
    let mut carry = change;
    let mut reversed = vec![];
    for digit in digits.bytes().rev() {
        let sum = i128::from(digit - b'0') + carry;
        reversed.push(char::from(
            b'0' + u8::try_from(sum.rem_euclid(10)).unwrap_or(0),
        ));
        carry = sum.div_euclid(10);
    }
    match carry {
        0 => (),
        1..=9 => reversed.push(char::from(b'0' + u8::try_from(carry).unwrap_or(0))),
        _ => return "-".to_owned(),
    }
    reversed.iter().rev().collect()
}

/// The integer part of a square root.
fn integer_root(n: i128) -> i128 {
    let (mut low, mut high) = (0_i128, 1_i128 << 63);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if middle * middle <= n {
            low = middle
        } else {
            high = middle
        }
    }
    low
}
