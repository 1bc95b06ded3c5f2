//! And, or, not, chains: parts that are true everywhere, and parts that fail at the origin. A statement of these parts
//! without `not` fails at the origin or is true everywhere; `not p`, "p is not true everywhere", exchanges the two.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let wanted = stream.once_in(2);
    let depth = 1 + stream.below(2);
    let text = part(stream, depth, wanted);
    let truth = match wanted {
        true => Truth::Holds,
        false => Truth::Fails("x = y = 0, m = 1, p = [0, 0, 0]".to_owned()),
    };
    Claim::new(Kind::Logic, States::Other(text), truth)
        .symbol("x", "{ in = '[0, 1]' }")
        .symbol("y", "{}")
        .symbol("m", "{ integer = '>= 1' }")
        .symbol("p", "{ vector = 3 }")
}

fn part(stream: &mut Stream, depth: usize, wanted: bool) -> String {
    if depth == 0 {
        return leaf(stream, wanted);
    }
    let other = stream.once_in(2);
    let (word, left, right) = match (stream.once_in(2), wanted) {
        (true, true) => ("and", true, true),
        (true, false) => ("and", other, false),
        (false, true) => ("or", other, true),
        (false, false) => ("or", false, false),
    };
    let (left, right) = if stream.once_in(2) {
        (left, right)
    } else {
        (right, left)
    };
    let (left, right) = (
        part(stream, depth - 1, left),
        part(stream, depth - 1, right),
    );
    format!("({left}) {word} ({right})")
}

fn leaf(stream: &mut Stream, wanted: bool) -> String {
    if stream.once_in(5) {
        // A denial is about the point: what is false somewhere may be true elsewhere.
        let k = stream.positive();
        return match (wanted, stream.once_in(2)) {
            (true, true) => format!("not (x + {k} <= 0)"),
            (true, false) => format!("not (y^2 + {k} == 0)"),
            (false, _) => format!("not ({})", atom(stream, true)),
        };
    }
    atom(stream, wanted)
}

fn atom(stream: &mut Stream, wanted: bool) -> String {
    let k = stream.positive();
    match wanted {
        true => match stream.below(9) {
            0 => format!("x + {k} > 0"),
            1 => format!("(y + {k})^2 == y^2 + 2*{k}*y + ({k})^2"),
            2 => format!("y^2 + {k} != 0"),
            3 => format!("0 <= x <= 1 <= 1 + {k}"),
            4 => format!("m + {k} > 1"),
            5 => "cross(p, p) == 0".to_owned(),
            6 => format!("x + {k} != x"),
            7 => format!("y == y == y + {k} - {k}"),
            _ => "0 <= x^2 <= x".to_owned(),
        },
        false => match stream.below(8) {
            0 => format!("x - {k} >= 0"),
            1 => format!("y == {k}"),
            2 => "y != 0".to_owned(),
            3 => format!("y <= x < x + y^2 < x + {k}"),
            4 => format!("m > 1 + {k}*x"),
            5 => format!("p == [{k}, 0, 0]"),
            6 => format!("dot(p, p) + y >= {k}"),
            _ => "x*m != 0".to_owned(),
        },
    }
}
