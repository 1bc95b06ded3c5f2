//! Parts and multiples of one angle, in radians or in quarter turns: powers of `cos + i sin`, products as sums, tangents,
//! derivatives, and signs on intervals with ends in multiples of pi.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::{Polynomial, SLOTS};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let angle = Variable::some(stream);
    match stream.below(8) {
        0 | 1 => power(stream, angle),
        2 | 3 => product(stream, angle),
        4 => tangent(stream, angle),
        5 => rate(stream, angle),
        6 => arch(stream, angle),
        _ => bound(stream, angle),
    }
}

/// How the angle is written.
#[derive(Clone, Copy)]
enum Variable {
    /// `t`, in radians.
    Radians,
    /// `pi/2*x`.
    QuarterTurns,
}

impl Variable {
    fn some(stream: &mut Stream) -> Self {
        stream.pick(&[Self::Radians, Self::QuarterTurns])
    }

    fn name(self) -> &'static str {
        match self {
            Self::Radians => "t",
            Self::QuarterTurns => "x",
        }
    }

    /// A multiple of the angle.
    fn times(self, q: Q) -> String {
        let whole = match self {
            Self::Radians => "t",
            Self::QuarterTurns => "pi/2*x",
        };
        match (q.above, q.below) {
            (1, 1) => whole.to_owned(),
            (above, 1) => format!("{above}*{whole}"),
            (1, below) => format!("{whole}/{below}"),
            (above, below) => format!("{above}*{whole}/{below}"),
        }
    }

    /// The value of the variable where the angle is so many quarter turns.
    fn at(self, quarters: Q) -> String {
        match self {
            Self::Radians => format!("{}*pi", quarters * Q::new(1, 2)),
            Self::QuarterTurns => quarters.to_string(),
        }
    }

    /// Where the angle is between so many quarter turns.
    fn between(self, low: Q, high: Q, open: bool) -> String {
        let (left, right) = if open { ("(", ")") } else { ("[", "]") };
        format!(
            "{{ in = '{left}{}, {}{right}' }}",
            self.at(low),
            self.at(high)
        )
    }

    /// Any interval, which says nothing of what is claimed.
    fn anywhere(self, stream: &mut Stream) -> String {
        match stream.below(3) {
            0 => "{}".to_owned(),
            1 => self.between(Q::ZERO, Q::ONE, false),
            _ => self.between(
                Q::int(stream.integer(-3, 0)),
                Q::new(stream.integer(1, 9), 2),
                true,
            ),
        }
    }
}

/// A part of the angle: `1/2`, `3/4` and so on.
fn part(stream: &mut Stream) -> Q {
    Q::new(stream.integer(1, 4), stream.integer(1, 4))
}

/// `sin(n a)` or `cos(n a)` by the powers of `cos a + i sin a`.
fn power(stream: &mut Stream, angle: Variable) -> Claim {
    let unit = part(stream);
    let multiple = stream.integer(2, 4);
    let (sine, cosine) = (Polynomial::variable(0), Polynomial::variable(1));
    let (mut real, mut imaginary) = (Polynomial::number(Q::ONE), Polynomial::default());
    for _ in 0..multiple {
        let next = &(&real * &cosine) - &(&imaginary * &sine);
        imaginary = &(&real * &sine) + &(&imaginary * &cosine);
        real = next;
    }
    let (function, form) = match stream.once_in(2) {
        true => ("sin", imaginary),
        false => ("cos", real),
    };
    let (mut truth, mut printed) = (Truth::Holds, form.clone());
    if stream.once_in(2) {
        printed = form.slipped(stream);
        let difference = &form - &printed;
        // Rational points of the circle: (2u/(1 + u^2), (1 - u^2)/(1 + u^2)).
        let vanishes = (1..12).all(|u| {
            let below = Q::int(1 + u * u);
            let mut point = [Q::ONE; SLOTS];
            point[0] = Q::int(2 * u).over(below);
            point[1] = Q::int(1 - u * u).over(below);
            difference.value(&point) == Q::ZERO
        });
        if !vanishes {
            truth = Truth::Fails("almost everywhere".to_owned());
        }
    }
    let names = ["sin", "cos"].map(|f| format!("{f}({})", angle.times(unit)));
    let names = [names[0].as_str(), names[1].as_str()];
    let left = format!("{function}({})", angle.times(unit * Q::int(multiple)));
    let states = States::Compare(left, "==", printed.text(stream, &names));
    let domain = angle.anywhere(stream);
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}

/// Products of sines and cosines of two parts as sums.
fn product(stream: &mut Stream, angle: Variable) -> Claim {
    let small = part(stream);
    let large = small + part(stream);
    let [sum, difference] = [large + small, large - small].map(|q| angle.times(q));
    let [large, small] = [large, small].map(|q| angle.times(q));
    let (left, first, sign, second) = match stream.below(3) {
        0 => ([("sin", &large), ("cos", &small)], "sin", "+", "sin"),
        1 => ([("cos", &large), ("cos", &small)], "cos", "+", "cos"),
        _ => ([("sin", &large), ("sin", &small)], "cos", "-", "cos"),
    };
    let (above, below) = match left[0].0 == "sin" && left[1].0 == "sin" {
        true => (&difference, &sum),
        false => (&sum, &difference),
    };
    let (mut truth, mut sign, mut half) = (Truth::Holds, sign, "2");
    if stream.once_in(2) {
        truth = Truth::Fails("almost everywhere".to_owned());
        match stream.once_in(2) {
            true => half = "3",
            false => sign = if sign == "+" { "-" } else { "+" },
        }
    }
    let states = States::Compare(
        format!("{}({})*{}({})", left[0].0, left[0].1, left[1].0, left[1].1),
        "==",
        format!("({first}({above}) {sign} {second}({below}))/{half}"),
    );
    let domain = angle.anywhere(stream);
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}

/// The tangent of the half, where it is defined and elsewhere.
fn tangent(stream: &mut Stream, angle: Variable) -> Claim {
    let half = part(stream);
    let whole = half * Q::int(2);
    // Up to half a turn of the whole angle, or beyond.
    let reach = Q::int(2).over(whole);
    let slip = stream.once_in(2);
    let inside = slip || stream.once_in(2);
    let domain = match inside {
        true => angle.between(-reach, reach, true),
        false => angle.between(-reach, reach, false),
    };
    let below = if slip { "1 - cos" } else { "1 + cos" };
    let truth = match (slip, inside) {
        (true, _) => Truth::Fails("almost everywhere".to_owned()),
        (false, true) => Truth::Holds,
        (false, false) => Truth::Conditional,
    };
    let whole = angle.times(whole);
    let states = States::Compare(
        format!("tan({})", angle.times(half)),
        "==",
        format!("sin({whole})/({below}({whole}))"),
    );
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}

/// The derivative of the sine or cosine of a part, by the variable.
fn rate(stream: &mut Stream, angle: Variable) -> Claim {
    let times = part(stream);
    let argument = angle.times(times);
    let factor = match angle {
        Variable::Radians => format!("{times}"),
        Variable::QuarterTurns => format!("{}*pi", times * Q::new(1, 2)),
    };
    let (function, mut sign, derived) = match stream.once_in(2) {
        true => ("sin", "", "cos"),
        false => ("cos", "-", "sin"),
    };
    let mut truth = Truth::Holds;
    if stream.once_in(2) {
        truth = Truth::Fails("almost everywhere".to_owned());
        sign = if sign == "-" { "" } else { "-" };
    }
    let states = States::Compare(
        format!("D({function}({argument}), {})", angle.name()),
        "==",
        format!("{sign}{factor}*{derived}({argument})"),
    );
    let domain = angle.anywhere(stream);
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}

/// The sine from where it is zero: not negative for half a turn, negative beyond.
fn arch(stream: &mut Stream, angle: Variable) -> Claim {
    let times = part(stream);
    let from = Q::int(stream.integer(-2, 2)) + stream.pick(&[Q::ZERO, Q::new(1, 2), Q::new(2, 3)]);
    let long = stream.once_in(2);
    let reach = match long {
        true => Q::int(2) + stream.pick(&[Q::new(1, 3), Q::new(1, 2), Q::ONE]),
        false => stream.pick(&[Q::int(2), Q::ONE, Q::new(1, 2), Q::new(2, 3)]),
    };
    let open = stream.once_in(2);
    let (low, high) = (from.over(times), (from + reach).over(times));
    let relation = if open { ">" } else { ">=" };
    let sine = format!("sin({} - {}*pi)", angle.times(times), from * Q::new(1, 2));
    let states = States::Compare(sine, relation, "0".to_owned());
    let truth = match long {
        true => Truth::Fails(format!("near the end, {}", angle.at(high))),
        false => Truth::Holds,
    };
    let domain = angle.between(low, high, open);
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}

/// The cosine between an angle and its negative is at least that at the ends.
fn bound(stream: &mut Stream, angle: Variable) -> Claim {
    const KNOWN: [(i128, i128); 6] = [(1, 3), (1, 2), (2, 3), (1, 1), (4, 3), (3, 2)];
    let times = part(stream);
    let place = stream.below(KNOWN.len() - 1);
    let [near, far] = [place, place + 1].map(|n| Q::new(KNOWN[n].0, KNOWN[n].1));
    let slip = stream.once_in(2);
    let reach = if slip { far } else { near }.over(times);
    let states = States::Compare(
        format!("cos({})", angle.times(times)),
        ">=",
        format!("cos({}*pi)", near * Q::new(1, 2)),
    );
    let truth = match slip {
        true => Truth::Fails(format!("at the ends, {}", angle.at(reach))),
        false => Truth::Holds,
    };
    let domain = angle.between(-reach, reach, false);
    Claim::new(Kind::Angles, states, truth).symbol(angle.name(), domain)
}
