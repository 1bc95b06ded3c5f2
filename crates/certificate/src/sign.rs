//! Signs of polynomials on a domain, and what shows them.
//!
//! A [`Certificate`] that p >= 0 (or p > 0) says
//!
//! `p = d_1 q_1^2 + ... + m_1 c_1 + m_2 c_2 + ... + f_1 f_2 ... r`
//!
//! with numbers d_i >= 0, constraints c_i >= 0, numbers m_i >= 0, and factors f_i >= 0. The rest r is written in
//! [`Coordinate`]s, of which the bounded ones run from 0 to 1 and the others from 0 on; [`Piece`]s fill the box of the
//! bounded ones, and on each either the Bernstein coefficients of r are not negative, or those of the negative of a
//! constraint say that no point of the domain is there. r is positive on a piece if moreover each of its faces that belongs
//! to the domain has a positive coefficient.

use crate::ratio::Ratio;
use crate::symbol::{Angle, Symbol};
use crate::text;
use serde::Serialize;
use torse_numbers::Rational;

/// A polynomial, and what shows it to be nowhere negative on the domain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sign<P> {
    /// The polynomial.
    pub polynomial: P,
    /// Whether it is shown to be more than zero.
    pub strict: bool,
    /// How.
    pub by: Shown<P>,
}

/// What shows a sign.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shown<P> {
    /// A certificate for the whole domain.
    Whole(Certificate<P>),
    /// One for each part into which angles cut the domain.
    Parts(Vec<Part<P>>),
    /// The signs of polynomials whose product it is, up to a positive number.
    Factors(Vec<Sign<P>>),
    /// The signs of polynomials that make it with products of symbols that run from zero on.
    Rays(Vec<Ray<P>>),
    /// The sign of what is left when a multiple of an equation is subtracted.
    Along(Box<Along<P>>),
    /// It is a - b where a is not negative and the square of a is not below that of b.
    Squares(Box<Squares<P>>),
}

/// A product of symbols that are not negative, and the sign of what it is multiplied with.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Ray<P> {
    /// The product.
    pub product: P,
    /// Its coefficient.
    pub coefficient: Sign<P>,
}

/// A multiple of an equation, of either sign, and the sign of the rest.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Along<P> {
    /// The place of the equation among the constraints of the ground; its numerator is what is zero.
    pub equation: usize,
    /// What it is multiplied with.
    pub multiple: P,
    /// The sign of the rest.
    pub rest: Sign<P>,
}

/// A difference a - b by squares. **Theorem.** If a >= 0 and a^2 >= b^2 then a >= |b| >= b; if a^2 > b^2 then a > b.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Squares<P> {
    /// The sign of a.
    pub larger: Sign<P>,
    /// The sign of a^2 - b^2; strictness comes from here.
    pub difference: Sign<P>,
}

/// A part of the domain: a symbol, or the angle of a cosine, between two numbers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Part<P> {
    /// What is bounded, and where, one after the other.
    pub within: Vec<Bounded<P>>,
    /// The certificate there.
    pub certificate: Certificate<P>,
}

/// A symbol between two numbers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Bounded<P> {
    /// The symbol; a cosine stands for its angle.
    pub symbol: Symbol,
    /// The lower end.
    pub lower: Option<End<P>>,
    /// The upper end.
    pub upper: Option<End<P>>,
}

/// An end of an interval.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct End<P> {
    /// The number.
    pub value: Ratio<P>,
    /// Whether it belongs to the interval.
    pub closed: bool,
}

/// The equation and the pieces.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Certificate<P> {
    /// Whether more than zero is shown.
    pub strict: bool,
    /// Squares, and the numbers that they are multiplied with.
    pub squares: Vec<Square<P>>,
    /// Multiples of constraints.
    pub multiples: Vec<Multiple>,
    /// Factors that are split off.
    pub factors: Vec<Factor<P>>,
    /// What remains.
    pub rest: P,
    /// The coordinates, in the order in which they are put in.
    pub coordinates: Vec<Coordinate<P>>,
    /// Parts that fill the box of the bounded coordinates, whose order is that of the sides.
    pub pieces: Vec<Piece>,
}

/// A multiple of a square.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Square<P> {
    /// The number.
    #[serde(serialize_with = "text::number")]
    pub multiple: Rational,
    /// What is squared.
    pub root: P,
}

/// A multiple of a constraint, turned such that it is not negative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Multiple {
    /// The place of the constraint among those of the ground.
    pub constraint: usize,
    /// The number.
    #[serde(serialize_with = "text::number")]
    pub multiple: Rational,
}

/// A quantity that is not negative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Factor<P> {
    /// A symbol whose range begins at zero or later.
    Symbol(Symbol),
    /// The constraint in this place, turned such that it is not negative.
    Constraint(usize),
    /// The square of this polynomial.
    Square(P),
}

/// What a symbol is in the coordinate that takes its place. The ends enclose the range of the symbol on the domain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Coordinate<P> {
    /// Sine and cosine of the angle are those of an angle `from` quarter turns further, of which the symbol is the tangent of
    /// the half.
    Tangent {
        /// The symbol.
        symbol: Symbol,
        /// The variable of the angle.
        variable: String,
        /// Which angle.
        #[serde(serialize_with = "as_formula")]
        angle: Angle,
        /// Quarter turns.
        from: i64,
    },
    /// `symbol = lower + (upper - lower)*t`, t from 0 to 1.
    Side {
        /// The symbol.
        symbol: Symbol,
        /// Where t is 0.
        lower: End<P>,
        /// Where t is 1.
        upper: End<P>,
    },
    /// `symbol = end + t` or `end - t`, t from 0 on.
    Ray {
        /// The symbol.
        symbol: Symbol,
        /// Where t is 0.
        end: End<P>,
        /// Whether t is added.
        up: bool,
    },
    /// `symbol^2 = t`, t from 0 on, of a symbol that stands in even powers alone.
    Squared {
        /// The symbol.
        symbol: Symbol,
    },
}

fn as_formula<S: serde::Serializer>(angle: &Angle, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(&format!("{angle}x"))
}

/// A part of the box.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Piece {
    /// The ends of each bounded coordinate.
    #[serde(serialize_with = "text::region")]
    pub region: Vec<(Rational, Rational)>,
    /// Why nothing more is to be shown there: the coefficients of the rest, or that this constraint fails.
    pub outside: Option<usize>,
}

impl<P> Sign<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Sign<Q> {
        Sign {
            polynomial: change(&self.polynomial),
            strict: self.strict,
            by: match &self.by {
                Shown::Whole(certificate) => Shown::Whole(certificate.map(change)),
                Shown::Parts(parts) => {
                    Shown::Parts(parts.iter().map(|part| part.map(change)).collect())
                }
                Shown::Factors(signs) => {
                    Shown::Factors(signs.iter().map(|sign| sign.map(change)).collect())
                }
                Shown::Along(along) => Shown::Along(Box::new(Along {
                    equation: along.equation,
                    multiple: change(&along.multiple),
                    rest: along.rest.map(change),
                })),
                Shown::Squares(own) => Shown::Squares(Box::new(Squares {
                    larger: own.larger.map(change),
                    difference: own.difference.map(change),
                })),
                Shown::Rays(rays) => Shown::Rays(
                    rays.iter()
                        .map(|ray| Ray {
                            product: change(&ray.product),
                            coefficient: ray.coefficient.map(change),
                        })
                        .collect(),
                ),
            },
        }
    }

    /// The certificates.
    #[must_use]
    pub fn certificates(&self) -> Vec<&Certificate<P>> {
        match &self.by {
            Shown::Whole(certificate) => vec![certificate],
            Shown::Parts(parts) => parts.iter().map(|part| &part.certificate).collect(),
            Shown::Factors(signs) => signs.iter().flat_map(Self::certificates).collect(),
            Shown::Along(along) => along.rest.certificates(),
            Shown::Squares(own) => {
                [own.larger.certificates(), own.difference.certificates()].concat()
            }
            Shown::Rays(rays) => {
                let signs = rays.iter().map(|ray| &ray.coefficient);
                signs.flat_map(Self::certificates).collect()
            }
        }
    }

    /// The places of the constraints that are used.
    #[must_use]
    pub fn constraints(&self) -> Vec<usize> {
        let mut used = vec![];
        for certificate in self.certificates() {
            used.extend(certificate.multiples.iter().map(|m| m.constraint));
            used.extend(certificate.pieces.iter().filter_map(|piece| piece.outside));
            used.extend(certificate.factors.iter().filter_map(|f| match f {
                Factor::Constraint(place) => Some(*place),
                Factor::Symbol(_) | Factor::Square(_) => None,
            }));
        }
        used.extend(self.equations());
        used.sort_unstable();
        used.dedup();
        used
    }

    /// The places of the equations of which multiples are subtracted.
    fn equations(&self) -> Vec<usize> {
        match &self.by {
            Shown::Whole(_) | Shown::Parts(_) => vec![],
            Shown::Factors(signs) => signs.iter().flat_map(Self::equations).collect(),
            Shown::Rays(rays) => {
                let signs = rays.iter().map(|ray| &ray.coefficient);
                signs.flat_map(Self::equations).collect()
            }
            Shown::Along(along) => [vec![along.equation], along.rest.equations()].concat(),
            Shown::Squares(own) => [own.larger.equations(), own.difference.equations()].concat(),
        }
    }
}

impl<P> End<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> End<Q> {
        End {
            value: self.value.map(change),
            closed: self.closed,
        }
    }
}

impl<P> Part<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Part<Q> {
        let end = |end: &Option<End<P>>| end.as_ref().map(|end| end.map(change));
        let bounded = |bounded: &Bounded<P>| Bounded {
            symbol: bounded.symbol.clone(),
            lower: end(&bounded.lower),
            upper: end(&bounded.upper),
        };
        Part {
            within: self.within.iter().map(bounded).collect(),
            certificate: self.certificate.map(change),
        }
    }
}

impl<P> Certificate<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Certificate<Q> {
        let square = |square: &Square<P>| Square {
            multiple: square.multiple.clone(),
            root: change(&square.root),
        };
        let factor = |factor: &Factor<P>| match factor {
            Factor::Symbol(symbol) => Factor::Symbol(symbol.clone()),
            Factor::Constraint(place) => Factor::Constraint(*place),
            Factor::Square(root) => Factor::Square(change(root)),
        };
        let coordinate = |coordinate: &Coordinate<P>| match coordinate {
            Coordinate::Tangent {
                symbol,
                variable,
                angle,
                from,
            } => Coordinate::Tangent {
                symbol: symbol.clone(),
                variable: variable.clone(),
                angle: *angle,
                from: *from,
            },
            Coordinate::Side {
                symbol,
                lower,
                upper,
            } => Coordinate::Side {
                symbol: symbol.clone(),
                lower: lower.map(change),
                upper: upper.map(change),
            },
            Coordinate::Ray { symbol, end, up } => Coordinate::Ray {
                symbol: symbol.clone(),
                end: end.map(change),
                up: *up,
            },
            Coordinate::Squared { symbol } => Coordinate::Squared {
                symbol: symbol.clone(),
            },
        };
        Certificate {
            strict: self.strict,
            squares: self.squares.iter().map(square).collect(),
            multiples: self.multiples.clone(),
            factors: self.factors.iter().map(factor).collect(),
            rest: change(&self.rest),
            coordinates: self.coordinates.iter().map(coordinate).collect(),
            pieces: self.pieces.clone(),
        }
    }
}
