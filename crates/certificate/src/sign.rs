//! Signs of polynomials on a domain, with certificates.
//!
//! A [`Certificate`] for p >= 0 (or p > 0) is an identity
//!
//! `p = d_1 q_1^2 + ... + m_1 c_1 + m_2 c_2 + ... + f_1 f_2 ... r`
//!
//! with numbers d_i >= 0, constraints c_i >= 0, numbers m_i >= 0, and factors f_i >= 0. The remaining polynomial r is
//! written in [`Coordinate`]s, of which the bounded ones run from 0 to 1 and the others from 0 to infinity.
//! [`Piece`]s fill the box of the bounded coordinates. On each piece either the Bernstein coefficients of r are
//! nonnegative, or the Bernstein coefficients of the negative of a constraint show that the piece contains no point
//! of the domain. r is positive on a piece if, in addition, each face of the piece that belongs to the domain has a
//! positive coefficient.

use crate::line::Line;
use crate::ratio::Ratio;
use crate::symbol::{Angle, Symbol};
use crate::taylor::PartialSum;
use crate::text;
use serde::Serialize;
use torse_numbers::Rational;

/// A polynomial with a proof that it is nonnegative (or positive) on the domain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sign<P> {
    /// The polynomial.
    pub polynomial: P,
    /// Whether it is positive.
    pub strict: bool,
    /// The proof.
    pub by: Shown<P>,
}

/// The proof of a sign.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shown<P> {
    /// One certificate for the whole domain.
    Whole(Certificate<P>),
    /// A certificate for each part into which angles divide the domain.
    Parts(Vec<Part<P>>),
    /// The signs of polynomials whose product is the polynomial times a positive number.
    Factors(Vec<Sign<P>>),
    /// The polynomial is a sum of these polynomials times products of nonnegative symbols.
    Rays(Vec<Ray<P>>),
    /// The sign of the polynomial minus a multiple of an equation.
    Along(Box<Along<P>>),
    /// The polynomial is a - b where a is nonnegative and a^2 >= b^2.
    Squares(Box<Squares<P>>),
    /// It has one variable: the signs of factors between their roots.
    Line(Box<Line<P>>),
    /// It has sines, cosines and exponentials beside their variable: partial sums of their series.
    Taylor(Box<Taylor<P>>),
    /// It is linear in the square of a bounded symbol: the signs where that is zero, and where it is largest.
    Even(Box<Even<P>>),
    /// Its derivatives by a variable, with exponentials of it: where that is zero, and how it grows from there.
    Increasing(Box<Increasing<P>>),
}

/// A product of nonnegative symbols, and the sign of its coefficient.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Ray<P> {
    /// The product.
    pub product: P,
    /// Its coefficient.
    pub coefficient: Sign<P>,
}

/// A multiple of an equation (of either sign), and the sign of the remainder.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Along<P> {
    /// The index of the equation among the constraints of the assumptions; the numerator of the equation is zero.
    pub equation: usize,
    /// The multiplier of the equation.
    pub multiple: P,
    /// The sign of the remainder.
    pub rest: Sign<P>,
}

/// A difference a - b by squares. **Theorem.** If a >= 0 and a^2 >= b^2 then a >= |b| >= b; if a^2 > b^2 then a > b.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Squares<P> {
    /// The sign of a.
    pub larger: Sign<P>,
    /// The sign of a^2 - b^2; the result is strict if this is.
    pub difference: Sign<P>,
}

/// A polynomial by gaps between functions and partial sums of their series.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Taylor<P> {
    /// The partial sums.
    pub bounds: Vec<PartialSum>,
    /// The products of gaps, with their coefficients, which make the polynomial.
    pub terms: Vec<GapTerm<P>>,
}

/// A product of powers of gaps, and its coefficient, which is not negative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GapTerm<P> {
    /// The exponents of the gaps, in the order of the sums.
    pub exponents: Vec<u32>,
    /// The coefficient.
    pub coefficient: Sign<P>,
}

/// A polynomial `p + q b^2`, where b lies between `-c` and c. **Theorem.** It is `(1 - s) p + s (p + q c^2)` with
/// `s = b^2/c^2` between 0 and 1; so it is not negative if neither of both is, and positive if p is and `b^2 < c^2`, or
/// the other is as well.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Even<P> {
    /// The symbol b.
    pub symbol: Symbol,
    /// The number c, which is positive.
    #[serde(serialize_with = "text::number")]
    pub bound: Rational,
    /// The sign of p.
    pub at_zero: Sign<P>,
    /// The sign of `p + q c^2`.
    pub at_bound: Sign<P>,
}

/// A polynomial f whose sign its derivatives by a variable show. **Theorem.** If `f >= 0` where the variable x is zero, and
/// `f' - c*f >= 0` between zero and each value of x, none of which is negative, then `f >= 0`. If `f >= 0` and `f' == c*f` where x is zero,
/// and `f'' - 2*c*f' + c^2*f >= 0` between zero and each value, then `f >= 0`. For these are the derivatives of `f*exp(-c*x)`, times
/// `exp(c*x)`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Increasing<P> {
    /// The variable x.
    pub variable: Symbol,
    /// The number c.
    #[serde(serialize_with = "text::number")]
    pub rate: Rational,
    /// How often is differentiated: once or twice.
    pub order: u32,
    /// The sign of f where x is zero.
    pub start: Sign<P>,
    /// The sign of `f' - c*f`, or of `f'' - 2*c*f' + c^2*f`.
    pub slope: Sign<P>,
}

/// A part of the domain: a symbol, or the angle of a cosine, between two numbers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Part<P> {
    /// The bounds, one symbol after the other.
    pub within: Vec<Bounded<P>>,
    /// The certificate on this part.
    pub certificate: Certificate<P>,
}

/// A symbol with bounds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Bounded<P> {
    /// The symbol; a cosine represents its angle.
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

/// The identity and the pieces, see the [module](self).
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Certificate<P> {
    /// Whether the polynomial is shown to be positive.
    pub strict: bool,
    /// Multiples of squares.
    pub squares: Vec<Square<P>>,
    /// Multiples of constraints.
    pub multiples: Vec<Multiple>,
    /// Nonnegative factors of the remaining polynomial.
    pub factors: Vec<Factor<P>>,
    /// The remaining polynomial r.
    pub rest: P,
    /// The coordinates, in the order of substitution.
    pub coordinates: Vec<Coordinate<P>>,
    /// Pieces that fill the box of the bounded coordinates; sides are in the order of the coordinates.
    pub pieces: Vec<Piece>,
}

/// A multiple of a square.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Square<P> {
    /// The number, which is nonnegative.
    #[serde(serialize_with = "text::number")]
    pub multiple: Rational,
    /// The polynomial that is squared.
    pub root: P,
}

/// A multiple of a constraint, whose sign is chosen such that it is nonnegative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Multiple {
    /// The index of the constraint among those of the assumptions.
    pub constraint: usize,
    /// The multiplier, which is nonnegative.
    #[serde(serialize_with = "text::number")]
    pub multiple: Rational,
}

/// A nonnegative quantity.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Factor<P> {
    /// A symbol whose range contains no negative numbers.
    Symbol(Symbol),
    /// The constraint of this index, with its sign chosen such that it is nonnegative.
    Constraint(usize),
    /// The square of this polynomial.
    Square(P),
}

/// A substitution of a coordinate for a symbol. Its ends enclose the range of the symbol on the domain.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Coordinate<P> {
    /// Half-angle substitution: the angle is `from` quarter turns plus another angle, and the symbol is the tangent
    /// of half of that other angle.
    Tangent {
        /// The symbol.
        symbol: Symbol,
        /// The variable of the angle.
        variable: String,
        /// The angle.
        #[serde(serialize_with = "as_formula")]
        angle: Angle,
        /// The number of quarter turns.
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
    /// `symbol = end + t` or `end - t`, t from 0 to infinity.
    Ray {
        /// The symbol.
        symbol: Symbol,
        /// Where t is 0.
        end: End<P>,
        /// Whether t is added.
        up: bool,
    },
    /// `symbol^2 = t`, t from 0 to infinity, for a symbol that occurs in even powers only.
    Squared {
        /// The symbol.
        symbol: Symbol,
    },
}

fn as_formula<S: serde::Serializer>(angle: &Angle, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(&format!("{angle}x"))
}

/// A box of the subdivision.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Piece {
    /// The interval of each bounded coordinate.
    #[serde(serialize_with = "text::region")]
    pub region: Vec<(Rational, Rational)>,
    /// The index of a constraint that fails on the whole piece; `None` if the coefficients of the remaining
    /// polynomial show its sign.
    pub outside: Option<usize>,
}

impl<P> Sign<P> {
    /// Converts every polynomial.
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
                Shown::Line(line) => Shown::Line(Box::new(line.map(change))),
                Shown::Taylor(taylor) => Shown::Taylor(Box::new(taylor.map(change))),
                Shown::Even(own) => Shown::Even(Box::new(Even {
                    symbol: own.symbol.clone(),
                    bound: own.bound.clone(),
                    at_zero: own.at_zero.map(change),
                    at_bound: own.at_bound.map(change),
                })),
                Shown::Increasing(own) => Shown::Increasing(Box::new(Increasing {
                    variable: own.variable.clone(),
                    rate: own.rate.clone(),
                    order: own.order,
                    start: own.start.map(change),
                    slope: own.slope.map(change),
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

    /// The proofs of which this one is made.
    fn nested(&self) -> Vec<&Self> {
        match &self.by {
            Shown::Whole(_) | Shown::Parts(_) | Shown::Line(_) => vec![],
            Shown::Factors(signs) => signs.iter().collect(),
            Shown::Rays(rays) => rays.iter().map(|ray| &ray.coefficient).collect(),
            Shown::Along(along) => vec![&along.rest],
            Shown::Squares(own) => vec![&own.larger, &own.difference],
            Shown::Taylor(taylor) => taylor.coefficients().collect(),
            Shown::Even(own) => vec![&own.at_zero, &own.at_bound],
            Shown::Increasing(own) => vec![&own.start, &own.slope],
        }
    }

    /// What these proofs say of themselves, and those of which they are made.
    fn collected<'s, T>(&'s self, own: &impl Fn(&'s Self) -> Vec<T>) -> Vec<T> {
        let nested = self.nested().into_iter();
        let mut all = own(self);
        all.extend(nested.flat_map(|sign| sign.collected(own)));
        all
    }

    /// All certificates in the proof.
    #[must_use]
    pub fn certificates(&self) -> Vec<&Certificate<P>> {
        self.collected(&|sign| match &sign.by {
            Shown::Whole(certificate) => vec![certificate],
            Shown::Parts(parts) => parts.iter().map(|part| &part.certificate).collect(),
            _ => vec![],
        })
    }

    /// The indices of the constraints that are used.
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
        used.extend(self.lines().into_iter().flat_map(Line::constraints));
        used.sort_unstable();
        used.dedup();
        used
    }

    /// The lines.
    #[must_use]
    pub fn lines(&self) -> Vec<&Line<P>> {
        self.collected(&|sign| match &sign.by {
            Shown::Line(line) => vec![&**line],
            _ => vec![],
        })
    }

    /// Whether partial sums of series are used.
    #[must_use]
    pub fn uses_series(&self) -> bool {
        matches!(self.by, Shown::Taylor(_)) || self.nested().into_iter().any(Self::uses_series)
    }

    /// Whether derivatives are used.
    #[must_use]
    pub fn uses_derivatives(&self) -> bool {
        matches!(self.by, Shown::Increasing(_))
            || self.nested().into_iter().any(Self::uses_derivatives)
    }

    /// The places of the equations of which multiples are subtracted.
    fn equations(&self) -> Vec<usize> {
        self.collected(&|sign| match &sign.by {
            Shown::Along(along) => vec![along.equation],
            _ => vec![],
        })
    }
}

impl<P> Taylor<P> {
    /// The signs of the coefficients.
    pub fn coefficients(&self) -> impl Iterator<Item = &Sign<P>> {
        self.terms.iter().map(|term| &term.coefficient)
    }

    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Taylor<Q> {
        let term = |term: &GapTerm<P>| GapTerm {
            exponents: term.exponents.clone(),
            coefficient: term.coefficient.map(change),
        };
        Taylor {
            bounds: self.bounds.clone(),
            terms: self.terms.iter().map(term).collect(),
        }
    }
}

impl<P> End<P> {
    /// Converts the polynomials.
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
