//! Core terms: formulas with every name resolved.
//!
//! The text of a claim depends on its surroundings: names are declared elsewhere, definitions abbreviate formulas,
//! `F'` is a derivative, arguments may be left out. A core term depends on nothing else. Every name is resolved,
//! every definition is opened, and every binder (`sum`, `product`, `integral`, `D`, `at`, the parameters of functions
//! and of basis families) binds a [`Variable`] of its own that no text can write and that occurs nowhere else. So `D`
//! differentiates by a variable that has no value yet, even if the symbol of the same name has one;
//! [`Node::Derivative`] substitutes the point after differentiating.
//!
//! `derivations/SEMANTICS.md` gives the meaning of each construct; the room `semantics` executes it.

mod claim;
pub mod degree;
mod roots;
mod visited;
mod walk;

pub use claim::{Claim, Hypothesis, Source};
pub use roots::{ArcFunction, ArcSymbol};
pub use torse_numbers::stack;
pub use visited::Visited;

use std::sync::Arc;
use torse_numbers::{Affine, Rational};
use torse_syntax::derivation::Origin;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Operator, Place, Relation};

/// A variable of one binder. Variables are equal if their numbers are; the name is for messages.
#[derive(Debug, Clone)]
pub struct Variable {
    number: u32,
    name: Arc<str>,
}

impl Variable {
    /// Makes the variable with this number. The caller must give each binder a number of its own.
    #[must_use]
    pub fn new(number: u32, name: &str) -> Self {
        Self {
            number,
            name: Arc::from(name),
        }
    }

    /// The number that identifies this variable within a claim.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The name in the text that introduced it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl PartialEq for Variable {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Eq for Variable {}

impl PartialOrd for Variable {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Variable {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.number.cmp(&other.number)
    }
}

/// A term: a number, a vector or a matrix. Parts are shared.
#[derive(Debug, Clone)]
pub struct Term {
    /// The kind of term, with its parts.
    pub node: Arc<Node>,
    /// The place of the term in its text (see [`Node::Opened`] for terms from other texts).
    pub place: Place,
}

/// The kinds of terms.
#[derive(Debug)]
pub enum Node {
    /// A rational number.
    Number(Rational),
    /// The number pi.
    Pi,
    /// A declared real number or integer of the claim.
    Symbol(Arc<str>),
    /// A variable of an enclosing binder.
    Variable(Variable),
    /// A declared vector of the claim; `None` is one generic coordinate, which represents all.
    Vector(Arc<str>, Option<u8>),
    /// A member of a declared family of points or numbers. Undefined where an index is outside its range.
    Member(Arc<Points>, Vec<Term>),
    /// The function of this index and degree of a basis family, at its arguments: the variable and all
    /// shape parameters. Zero for an index outside of 0 to the degree, undefined below the degree of the seeds.
    Basis {
        /// The family.
        family: Arc<Family>,
        /// The index of the function.
        index: Term,
        /// The degree of the function.
        degree: Term,
        /// Variable and shape parameters, as many as the family has [`Family::variables`].
        arguments: Vec<Term>,
    },
    /// The negative `-x`.
    Negative(Term),
    /// A binary operation such as `a + b`. Undefined for a division by zero, and for zero to a negative power.
    Binary(Operator, Term, Term),
    /// `[a, b, c]`: a vector, or a matrix as a list of rows.
    List(Vec<Term>),
    /// The entry of a vector or matrix, counted from 1.
    Entry(Term, Vec<Term>),
    /// The sum of `term` for all integers from `low` to `high`, zero if there are none.
    Sum {
        /// The variable that is bound in `term`.
        index: Variable,
        /// The first value.
        low: Term,
        /// The last value.
        high: Term,
        /// The summand.
        term: Term,
    },
    /// The product of `term` for all integers from `low` to `high`, one if there are none.
    Product {
        /// The variable that is bound in `term`.
        index: Variable,
        /// The first value.
        low: Term,
        /// The last value.
        high: Term,
        /// The factor.
        term: Term,
    },
    /// The integral of `body` by the variable from `low` to `high`.
    Integral {
        /// The variable that is bound in `body`.
        variable: Variable,
        /// The lower limit.
        low: Term,
        /// The upper limit.
        high: Term,
        /// The integrand, integrated entry by entry.
        body: Term,
    },
    /// `body` with the variable replaced by the value: an applied function, or `at`.
    Let {
        /// The variable that is bound in `body`.
        variable: Variable,
        /// The value of the variable.
        value: Term,
        /// The formula.
        body: Term,
    },
    /// The derivative of `body` by the variable, of the given order, at the given point.
    Derivative {
        /// The variable that is bound in `body`.
        variable: Variable,
        /// The order: a nonnegative integer.
        order: Term,
        /// The formula.
        body: Term,
        /// Whether no variable of an enclosing binder occurs in `body`, except the variable of this derivative.
        closed: bool,
        /// The point at which the derivative is taken.
        at: Term,
    },
    /// A built-in function.
    Apply(BuiltIn, Vec<Term>),
    /// The body of a definition. If `closed`, no variable of an enclosing binder occurs in it, and it is what the name says at
    /// the point.
    Opened {
        /// The name of the definition.
        name: Arc<str>,
        /// The text to which the places of the body refer.
        origin: Arc<Origin>,
        /// Whether no variable of an enclosing binder occurs in the body, and none was replaced in it.
        closed: bool,
        /// The body.
        body: Term,
    },
}

/// A declared family of points, or of numbers.
#[derive(Debug, Clone)]
pub struct Points {
    /// The name.
    pub name: Arc<str>,
    /// The dimension of a member: 1 for numbers, `None` for one generic coordinate.
    pub dimension: Option<u8>,
    /// The range of each index, both ends included, in integer symbols of the claim; empty if no range is declared.
    pub ranges: Vec<(Affine, Affine)>,
}

/// A basis family: seeds of a lowest degree and the step
/// `g[i,k] = a g[i,k-1] + b g[i-1,k-1]`.
#[derive(Debug)]
pub struct Family {
    /// The name.
    pub name: Arc<str>,
    /// The variable, then the shape parameters: bound in seeds and step.
    pub variables: Vec<Variable>,
    /// The degree of the seeds.
    pub degree: u8,
    /// The functions of that degree, `degree + 1` of them.
    pub seeds: Vec<Term>,
    /// The two factors a and b of the step.
    pub step: (Term, Term),
    /// The variables for the index i and the degree k of the new function, if the step depends on them. `a` is used
    /// for i from 0 to k - 1 and `b` for i from 1 to k; elsewhere they need not be defined.
    pub counters: Option<(Variable, Variable)>,
    /// Whether no variable of an enclosing binder occurs in seeds and step.
    pub closed: bool,
}

/// The built-in functions of terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BuiltIn {
    /// `binom(n, j)`: n(n-1)...(n-j+1)/j!; zero for a negative j.
    Binomial,
    /// `factorial(n)` for n >= 0.
    Factorial,
    /// `sqrt(q)`: the nonnegative root; undefined for negative numbers.
    SquareRoot,
    /// `sin(a)`, in radians.
    Sine,
    /// `cos(a)`, in radians.
    Cosine,
    /// `exp(a)`, the number e to the power a.
    Exponential,
    /// `log(a)`, the natural logarithm; undefined for numbers that are not positive.
    Logarithm,
    /// `atan(a)`, the arc tangent, between -pi/2 and pi/2.
    ArcTangent,
    /// `asin(a)`, the arc sine, from -pi/2 to pi/2; undefined for numbers above 1 and below -1.
    ArcSine,
    /// `dot(a, b)`.
    Dot,
    /// `cross(a, b)` of two vectors of 3.
    Cross,
    /// `norm(v)`.
    Norm,
    /// `det(M)`.
    Determinant,
    /// `transpose(M)`.
    Transpose,
    /// `inverse(M)`; undefined where the determinant is zero.
    Inverse,
    /// `solve(M, b)`: the x with `M*x = b`; undefined where the determinant is zero.
    Solve,
    /// `identity(n)`.
    Identity,
    /// `coefficients([forms], [unknowns])`: the matrix of forms that are linear in the unknowns.
    Coefficients,
}

/// A statement.
#[derive(Debug, Clone)]
pub enum Statement {
    /// `left relation right`, entry by entry for `==`; `!=` is the negation of `==`; order relations are for numbers
    /// only.
    Compare {
        /// The relation.
        relation: Relation,
        /// The left side.
        left: Term,
        /// The right side.
        right: Term,
    },
    /// The printed decimals agree with the value, entry by entry, whether it was rounded or truncated.
    Agrees {
        /// The value.
        value: Term,
        /// Each printed number, with the number of its digits after the point (if it has a point), and whether it has
        /// a minus sign.
        printed: Vec<Printed>,
        /// The place of the printed numbers.
        place: Place,
    },
    /// A property of a basis family at every degree and for all values of its variables.
    Family(FamilyProperty, Arc<Family>),
    /// Two statements joined by `and`, `or` or `implies`.
    Join(Connective, Box<Statement>, Box<Statement>),
    /// `fails(p)`: there is a point of the domain at which p is defined and false. As a hypothesis, which only proofs
    /// make, it says that p is false at the point.
    Not(Box<Statement>),
}

/// A printed number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Printed {
    /// The number, with its sign.
    pub value: Rational,
    /// Digits after the decimal point, if there is a point.
    pub decimals: Option<u32>,
    /// Whether a minus sign is printed; needed for `-0.00`, which is zero with a sign.
    pub negative: bool,
}

/// A property that a basis family may have at every degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FamilyProperty {
    /// All functions are nonnegative.
    Nonnegative,
    /// The functions are linearly independent.
    Independent,
    /// A curve crosses no line more often than its control polygon: at every degree, or at the given degrees.
    VariationDiminishing(Option<Degrees>),
}

/// Degrees of a basis family, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Degrees {
    /// The first degree, at least the degree of the seeds.
    pub least: u8,
    /// The last degree, at least the first.
    pub most: u8,
}

/// The declared set of a symbol, as in the derivation file.
pub type Set = SymbolKind;
