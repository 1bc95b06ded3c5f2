//! Splines on the knots of a formula, by a basis whose step depends on index and degree: values by the recursion over all
//! indices in rational numbers, partitions of unity, and derivatives at the knots.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let knots = stream.pick(&[Knots::Equal, Knots::Growing]);
    let (degree, span) = (stream.integer(1, 3), stream.integer(3, 5));
    let claim = match stream.below(4) {
        0 => value(stream, knots, degree, span),
        1 => unity(stream, degree, span),
        2 => factor(stream, knots, degree, span),
        _ => knot(stream, knots, degree, span),
    };
    claim.symbol("x", "{}").basis("N", knots.basis())
}

/// Which number the knot with an index is.
#[derive(Clone, Copy)]
enum Knots {
    Equal,
    Growing,
}

impl Knots {
    fn text(self, index: &str) -> String {
        match self {
            Self::Equal => format!("({index})"),
            Self::Growing => format!("(({index})^2 + ({index}))"),
        }
    }

    fn at(self, index: i128) -> Q {
        match self {
            Self::Equal => Q::int(index),
            Self::Growing => Q::int(index * index + index),
        }
    }

    fn basis(self) -> String {
        let [above, below, here, back] =
            ["j+i+1", "j+i+1-k", "j+i", "j+i-k"].map(|index| self.text(index));
        format!(
            "variable = 'x'\nparameters = ['j']\ndegree = 0\nseeds = ['1']\nindex = 'i'\norder = 'k'\nstep = ['({above} - x)/({above} - {below})', '(x - {back})/({here} - {back})']"
        )
    }

    /// Function i of a degree on a span, by the recursion of Cox and de Boor.
    fn value(self, i: i128, degree: i128, span: i128, x: Q) -> Q {
        if degree == 0 {
            return Q::int(i128::from(i == span));
        }
        let rising = (x - self.at(i)).over(self.at(i + degree) - self.at(i));
        let falling = (self.at(i + degree + 1) - x).over(self.at(i + degree + 1) - self.at(i + 1));
        rising * self.value(i, degree - 1, span, x)
            + falling * self.value(i + 1, degree - 1, span, x)
    }
}

fn value(stream: &mut Stream, knots: Knots, degree: i128, span: i128) -> Claim {
    let i = stream.integer(0, degree);
    let x = Q::new(stream.integer(-3, 30), stream.integer(1, 4));
    let mut right = knots.value(span - degree + i, degree, span, x);
    let mut truth = Truth::Holds;
    if stream.once_in(2) {
        right = right + Q::new(1, stream.integer(2, 9));
        truth = Truth::Fails("everywhere".to_owned());
    }
    let left = format!("N[{i},{degree}]({x}, {span})");
    let states = States::Compare(left, "==", right.to_string());
    Claim::new(Kind::Splines, states, truth)
}

fn unity(stream: &mut Stream, degree: i128, span: i128) -> Claim {
    let (mut high, mut truth) = (degree, Truth::Holds);
    if stream.once_in(2) {
        high -= 1;
        truth = Truth::Fails("almost everywhere".to_owned());
    }
    let left = format!("sum(n, 0, {high}, N[n,{degree}](x, {span}))");
    let states = States::Compare(left, "==", "1".to_owned());
    Claim::new(Kind::Splines, states, truth)
}

/// The derivative by the functions of one degree less.
fn factor(stream: &mut Stream, knots: Knots, degree: i128, span: i128) -> Claim {
    let i = stream.integer(0, degree);
    let global = span - degree + i;
    let gap = |from: i128| knots.at(from + degree) - knots.at(from);
    let (rising, falling) = (gap(global), gap(global + 1));
    let (mut sign, mut truth) = ("-", Truth::Holds);
    // At the ends one of the two functions is zero, and its sign makes no difference.
    if i > 0 && i < degree && stream.once_in(2) {
        sign = "+";
        truth = Truth::Fails("almost everywhere".to_owned());
    }
    let lower = degree - 1;
    let right = format!(
        "{degree}*(N[{},{lower}](x, {span})/{rising} {sign} N[{i},{lower}](x, {span})/{falling})",
        i - 1
    );
    let left = format!("D(N[{i},{degree}](x, {span}), x)");
    Claim::new(Kind::Splines, States::Compare(left, "==", right), truth)
}

/// Derivatives of one function from both sides of a knot of its own: those of an order below the degree agree, that of the
/// degree jumps at knots that all differ.
fn knot(stream: &mut Stream, knots: Knots, degree: i128, span: i128) -> Claim {
    let i = stream.integer(1, degree);
    let jumps = stream.once_in(2);
    let order = if jumps {
        degree
    } else {
        stream.integer(0, degree - 1)
    };
    let truth = match jumps {
        true => Truth::Fails("at the knot".to_owned()),
        false => Truth::Holds,
    };
    let place = knots.at(span + 1);
    let side =
        |i: i128, span: i128| format!("at(D(N[{i},{degree}](x, {span}), x, {order}), x, {place})");
    let states = States::Compare(side(i, span), "==", side(i - 1, span + 1));
    Claim::new(Kind::Splines, states, truth)
}
