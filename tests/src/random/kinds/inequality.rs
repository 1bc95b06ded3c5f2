//! Order relations on boxes and rays: combinations of what the ends give, printed as expansions, and the same with the
//! value at a point taken away and a little more.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::at;
use crate::random::number::Q;
use crate::random::polynomial::{Polynomial, SLOTS};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(7) {
        0..3 => boxed(stream),
        3 => square(stream),
        4 => circle(stream),
        5 => definite(stream),
        _ => knots(stream),
    }
}

struct Range {
    low: Q,
    high: Option<Q>,
    open: bool,
}

impl Range {
    fn some(stream: &mut Stream) -> Self {
        let low = Q::new(stream.integer(-4, 4), stream.integer(1, 3));
        let width = stream.positive();
        Self {
            low,
            high: (!stream.once_in(4)).then_some(low + width),
            open: stream.once_in(2),
        }
    }

    fn declaration(&self) -> String {
        let bracket = if self.open { "(" } else { "[" };
        match self.high {
            Some(high) if self.open => format!("{{ in = '{bracket}{}, {high})' }}", self.low),
            Some(high) => format!("{{ in = '{bracket}{}, {high}]' }}", self.low),
            None => format!("{{ in = '{bracket}{}, inf)' }}", self.low),
        }
    }

    /// Something that is not negative in the range, and positive inside.
    fn factor(&self, stream: &mut Stream, slot: usize) -> Polynomial {
        let x = Polynomial::variable(slot);
        match self.high {
            Some(high) if stream.once_in(2) => &Polynomial::number(high) - &x,
            _ => &x - &Polynomial::number(self.low),
        }
    }

    fn inside(&self, stream: &mut Stream) -> Q {
        let part = Q::new(stream.integer(1, 4), 5);
        match self.high {
            Some(high) => self.low + (high - self.low) * part,
            None => self.low + part * Q::int(5),
        }
    }
}

fn relation(stream: &mut Stream, strict: bool, left: String, right: String) -> States {
    match (stream.once_in(2), strict) {
        (true, true) => States::Compare(left, ">", right),
        (true, false) => States::Compare(left, ">=", right),
        (false, true) => States::Compare(right, "<", left),
        (false, false) => States::Compare(right, "<=", left),
    }
}

fn boxed(stream: &mut Stream) -> Claim {
    let names = ["x", "y"];
    let slots = 1 + stream.below(2);
    let ranges: Vec<Range> = (0..slots).map(|_| Range::some(stream)).collect();
    let mut form = Polynomial::default();
    for _ in 0..=stream.below(3) {
        let mut term = Polynomial::number(stream.positive());
        for _ in 0..=stream.below(3) {
            let slot = stream.below(slots);
            term = &term * &ranges[slot].factor(stream, slot);
        }
        form = &form + &term;
    }
    let mut point = [Q::ONE; SLOTS];
    for (value, range) in point.iter_mut().zip(&ranges) {
        *value = range.inside(stream);
    }
    let slip = stream.once_in(2);
    let mut strict = stream.once_in(2);
    if slip {
        let less = form.value(&point) + Q::new(stream.integer(1, 5), stream.integer(1, 5));
        form = &form - &Polynomial::number(less);
    } else if strict && !ranges.iter().all(|r| r.open) {
        form = &form + &Polynomial::number(stream.positive());
    } else if strict && form.derivative(0).is_zero() && form.derivative(1).is_zero() {
        strict = false;
    }
    let truth = match slip {
        true => Truth::Fails(at(&names[..slots], &point)),
        false => Truth::Holds,
    };
    let moved = Polynomial::some(stream, slots, 1, 2);
    let left = (&form + &moved).text(stream, &names);
    let right = moved.text(stream, &names);
    let states = relation(stream, strict, left, right);
    let claim = Claim::new(Kind::Inequality, states, truth);
    let pairs = names.iter().zip(&ranges);
    pairs.fold(claim, |claim, (name, range)| {
        claim.symbol(name, range.declaration())
    })
}

/// A square, with a zero in the interval or not, and with something positive or not.
fn square(stream: &mut Stream) -> Claim {
    let zero = Q::new(stream.integer(-3, 3), stream.integer(1, 4));
    let root = &Polynomial::variable(0) - &Polynomial::number(zero);
    let mut form = root.power(2).times(stream.positive());
    let (strict, truth) = match stream.below(4) {
        0 => (false, Truth::Holds),
        1 => {
            form = &form + &Polynomial::number(stream.positive());
            (true, Truth::Holds)
        }
        2 => (true, Truth::Fails(at(&["x"], &[zero]))),
        _ => {
            form = &form - &Polynomial::number(Q::new(1, stream.integer(2, 40)));
            (stream.once_in(2), Truth::Fails(at(&["x"], &[zero])))
        }
    };
    let text = form.text(stream, &["x"]);
    let states = relation(stream, strict, text, "0".to_owned());
    let declaration = stream.pick(&["{}", "{ in = '[-5, 5]' }"]);
    Claim::new(Kind::Inequality, states, truth).symbol("x", declaration)
}

/// Products of sine, cosine and their distances from one.
fn circle(stream: &mut Stream) -> Claim {
    let names = ["sin(pi/2*x)", "cos(pi/2*x)"];
    let one = Polynomial::number(Q::ONE);
    let (s, c) = (Polynomial::variable(0), Polynomial::variable(1));
    let factors = [s.clone(), c.clone(), &one - &s, &one - &c];
    let mut form = Polynomial::default();
    for _ in 0..=stream.below(2) {
        let mut term = Polynomial::number(stream.positive());
        for _ in 0..=stream.below(2) {
            term = &term * &stream.pick(&factors);
        }
        form = &form + &term;
    }
    let mut strict = false;
    let mut truth = Truth::Holds;
    if stream.once_in(2) {
        let end = [Q::ZERO, Q::ONE, Q::ZERO, Q::ZERO];
        let less = form.value(&end) + Q::new(stream.integer(1, 5), stream.integer(1, 5));
        form = &form - &Polynomial::number(less);
        truth = Truth::Fails("x = 0".to_owned());
    } else if stream.once_in(2) {
        form = &form + &Polynomial::number(stream.positive());
        strict = true;
    }
    let text = form.text(stream, &names);
    let states = relation(stream, strict, text, "0".to_owned());
    Claim::new(Kind::Inequality, states, truth).symbol("x", "{ in = '[0, 1]' }")
}

/// Sums of squares of linear forms on the whole plane, and the same below zero at a point.
fn definite(stream: &mut Stream) -> Claim {
    let names = ["x", "y"];
    let mut form = Polynomial::default();
    for _ in 0..=stream.below(2) {
        let mut root = Polynomial::number(stream.fraction());
        for slot in 0..2 {
            root = &root + &Polynomial::variable(slot).times(stream.fraction());
        }
        form = &form + &root.power(2).times(stream.positive());
    }
    let mut point = [Q::ONE; SLOTS];
    point[0] = stream.fraction();
    point[1] = stream.fraction();
    let strict = stream.once_in(2);
    let mut truth = Truth::Holds;
    if stream.once_in(2) {
        form = &form - &Polynomial::number(form.value(&point) + stream.positive());
        truth = Truth::Fails(at(&names, &point[..2]));
    } else if strict {
        form = &form + &Polynomial::number(stream.positive());
    }
    let text = form.text(stream, &names);
    let states = relation(stream, strict, text, "0".to_owned());
    let claim = Claim::new(Kind::Inequality, states, truth);
    names
        .iter()
        .fold(claim, |claim, name| claim.symbol(name, "{}"))
}

/// Products of distances of ordered knots, some in the wrong order.
fn knots(stream: &mut Stream) -> Claim {
    let names = ["a", "b", "c"];
    let strict = stream.once_in(2);
    let less = if strict { "<" } else { "<=" };
    let mut form = Polynomial::number(stream.positive());
    let mut negative = false;
    for _ in 0..2 {
        let low = stream.below(2);
        let high = low + 1 + stream.below(2 - low);
        let distance = &Polynomial::variable(high) - &Polynomial::variable(low);
        let turned = stream.once_in(4);
        negative ^= turned;
        form = &form
            * &if turned {
                distance.times(-Q::ONE)
            } else {
                distance
            };
    }
    let truth = match negative {
        true => Truth::Fails("a = 0, b = 1, c = 2".to_owned()),
        false => Truth::Holds,
    };
    let text = form.text(stream, &names);
    let states = relation(stream, strict, text, "0".to_owned());
    let claim = names.windows(2).fold(
        Claim::new(Kind::Inequality, states, truth),
        |claim, pair| claim.assuming(format!("{} {less} {}", pair[0], pair[1])),
    );
    names
        .iter()
        .fold(claim, |claim, name| claim.symbol(name, "{}"))
}
