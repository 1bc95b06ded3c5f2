//! Core terms: what a formula means, with nothing left to look up.
//!
//! The text of a claim leans on its surroundings: names are declared elsewhere, definitions stand for formulas,
//! `F'` is a derivative, arguments may be left out. A core term leans on nothing. Every name is resolved, every
//! definition is opened, and every binder (`sum`, `product`, `integral`, `D`, `at`, the parameters of functions and of basis families) binds a
//! [`Variable`] of its own that no text can write and that occurs nowhere else. So `D` differentiates by a variable that
//! has no value yet, whatever value the symbol of the same name has: the value is put in afterwards, by the meaning of
//! [`Node::Derivative`] itself.
//!
//! `derivations/SEMANTICS.md` gives the meaning of each construct; the room `semantics` executes it.

mod claim;
pub mod degree;
mod roots;
mod visited;
mod walk;

pub use claim::{Claim, Hypothesis, Source};
pub use torse_numbers::stack;
pub use visited::Visited;

use std::sync::Arc;
use torse_numbers::{Affine, Rational};
use torse_syntax::derivation::Origin;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Operator, Place, Relation};

/// A variable of one binder. Two variables are the same if their numbers are; the name is for messages.
#[derive(Debug, Clone)]
pub struct Variable {
    number: u32,
    name: Arc<str>,
}

impl Variable {
    /// The variable with this number. Whoever makes variables gives each binder a number of its own.
    #[must_use]
    pub fn new(number: u32, name: &str) -> Self {
        Self {
            number,
            name: Arc::from(name),
        }
    }

    /// The number that tells this variable from all others of the same claim.
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
    /// What it is.
    pub node: Arc<Node>,
    /// Where it stands in its text (see [`Node::Opened`] for terms of other texts).
    pub place: Place,
}

/// The kinds of terms.
#[derive(Debug)]
pub enum Node {
    /// A rational number.
    Number(Rational),
    /// The circle number.
    Pi,
    /// A declared real number or integer of the claim.
    Symbol(Arc<str>),
    /// A variable of an enclosing binder.
    Variable(Variable),
    /// A declared vector of the claim; `None` is one generic coordinate that stands for all.
    Vector(Arc<str>, Option<u8>),
    /// A member of a declared family of points or numbers. Undefined where an index is outside its range.
    Member(Arc<Points>, Vec<Term>),
    /// The function of this index and degree of a basis family, at its arguments: the variable and all
    /// shape parameters. Zero for an index outside of 0 to the degree, undefined below the degree of the seeds.
    Basis {
        /// The family.
        family: Arc<Family>,
        /// Which function.
        index: Term,
        /// Of which degree.
        degree: Term,
        /// Variable and shape parameters, as many as the family has [`Family::variables`].
        arguments: Vec<Term>,
    },
    /// `-x`.
    Negative(Term),
    /// `a + b`. Undefined for a division by zero, and for zero to a negative power.
    Binary(Operator, Term, Term),
    /// `[a, b, c]`: a vector, or a matrix as a list of rows.
    List(Vec<Term>),
    /// The entry of a vector or matrix, counted from 1.
    Entry(Term, Vec<Term>),
    /// The sum of `term` for all integers from `low` to `high`, zero if there are none.
    Sum {
        /// Bound in `term`.
        index: Variable,
        /// The first value.
        low: Term,
        /// The last value.
        high: Term,
        /// What is added.
        term: Term,
    },
    /// The product of `term` for all integers from `low` to `high`, one if there are none.
    Product {
        /// Bound in `term`.
        index: Variable,
        /// The first value.
        low: Term,
        /// The last value.
        high: Term,
        /// What is multiplied.
        term: Term,
    },
    /// The integral of `body` by the variable from `low` to `high`.
    Integral {
        /// Bound in `body`.
        variable: Variable,
        /// Where it begins.
        low: Term,
        /// Where it ends.
        high: Term,
        /// What is integrated, entry by entry.
        body: Term,
    },
    /// `body` with the variable standing for the value: an applied function, or `at`.
    Let {
        /// Bound in `body`.
        variable: Variable,
        /// What it stands for.
        value: Term,
        /// The formula.
        body: Term,
    },
    /// The derivative of `body` by the variable, of this order, at this point.
    Derivative {
        /// Bound in `body`.
        variable: Variable,
        /// How often: an integer that is not negative.
        order: Term,
        /// The formula.
        body: Term,
        /// Whether no variable of an enclosing binder occurs in the formula, besides that of the derivative.
        closed: bool,
        /// Where.
        at: Term,
    },
    /// A built-in function.
    Apply(BuiltIn, Vec<Term>),
    /// The opened body of a definition. Outside of binders of its own it contains no variable if `closed`.
    Opened {
        /// The name of the definition.
        name: Arc<str>,
        /// The text in which the places of the body are.
        origin: Arc<Origin>,
        /// Whether no variable of an enclosing binder occurs in the body.
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
    /// The dimension of a member; 1 for numbers, `None` for one generic coordinate.
    pub dimension: Option<u8>,
    /// The range of each index, both ends included, in integer symbols of the claim; empty if none is declared.
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
    /// The variables that stand in the step for the index i and the degree k of the function that is made, if the step
    /// depends on them: `a` counts for i from 0 to k - 1 and `b` for i from 1 to k, and nowhere else have they to be defined.
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
    /// `sqrt(q)`: the root that is not negative; undefined for negative numbers.
    SquareRoot,
    /// `sin(a)`, in radians.
    Sine,
    /// `cos(a)`, in radians.
    Cosine,
    /// `exp(a)`, the number e to this power.
    Exponential,
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
    /// `left relation right`, entry by entry for `==`; `!=` is the denial of `==`; order is for numbers.
    Compare {
        /// The relation.
        relation: Relation,
        /// The left side.
        left: Term,
        /// The right side.
        right: Term,
    },
    /// The printed decimals agree with the value, entry by entry: rounded or cut off there.
    Agrees {
        /// The value.
        value: Term,
        /// Each printed number with its digits after the point, if it has a point, and whether a minus sign stands
        /// before it.
        printed: Vec<Printed>,
        /// Where the printed numbers stand.
        place: Place,
    },
    /// A property of a basis family at every degree and for all values of its variables.
    Family(FamilyProperty, Arc<Family>),
    /// Both, one of both, or the second wherever the first.
    Join(Connective, Box<Statement>, Box<Statement>),
    /// `fails(p)`: there is a point of the domain at which p is defined and false. As a hypothesis, which only proofs
    /// make: p is false at the point.
    Not(Box<Statement>),
}

/// A printed number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Printed {
    /// The number, with its sign.
    pub value: Rational,
    /// Digits after the decimal point, if there is a point.
    pub decimals: Option<u32>,
    /// Whether a minus sign is printed, which `-0.00` needs.
    pub negative: bool,
}

/// A property that a basis family may have at every degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FamilyProperty {
    /// All functions are nonnegative.
    Nonnegative,
    /// The functions are linearly independent.
    Independent,
    /// A curve crosses no line more often than its control polygon: at every degree, or at these.
    VariationDiminishing(Option<Degrees>),
}

/// Degrees of a basis family, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Degrees {
    /// The first, not below that of the seeds.
    pub least: u8,
    /// The last, not below the first.
    pub most: u8,
}

/// The declared set of a symbol, as it stands in the derivation file.
pub type Set = SymbolKind;
