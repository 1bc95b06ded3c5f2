//! A program: the functions of a file, in one form for all languages.
//!
//! Formulas of a program are syntax trees of the formula language ([`Expr`]) whose places are bytes of the file. What the
//! language of formulas does not have is a call of an [`operation`], whose names no program can use for its own.

use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::{DerivationError, Origin, Source};
use torse_syntax::formula::{Expr, Node, Place};

/// A language in which programs are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CodeLanguage {
    /// Python, SymPy and NumPy among it: files that end in `.py`.
    Python,
    /// Rust: files that end in `.rs`.
    Rust,
}

impl CodeLanguage {
    /// The language of a file of this name; none if it ends in neither `.py` nor `.rs`.
    ///
    /// ```
    /// use torse_code::CodeLanguage;
    /// assert_eq!(CodeLanguage::from_name("src/basis.rs"), Some(CodeLanguage::Rust));
    /// assert_eq!(CodeLanguage::from_name("basis.cpp"), None);
    /// ```
    #[must_use]
    pub fn from_name(file: &str) -> Option<Self> {
        match file.rsplit_once('.')?.1 {
            "py" => Some(Self::Python),
            "rs" => Some(Self::Rust),
            _ => None,
        }
    }
}

/// The operations of programs that formulas do not have.
pub(crate) mod operation {
    /// `range(low, high, step)`: integers from low to below high.
    pub(crate) const RANGE: &str = "#range";
    /// `for(body, variable, values)`: the list of the values of the body.
    pub(crate) const FOR: &str = "#for";
    /// `if(condition, value, other)`.
    pub(crate) const IF: &str = "#if";
    /// `float(x)`: an integer as a real number.
    pub(crate) const FLOAT: &str = "#float";
    /// Division that rounds.
    pub(crate) const QUOTIENT: &str = "#quotient";
    /// The remainder of a division.
    pub(crate) const REMAINDER: &str = "#remainder";
    /// The length of a list.
    pub(crate) const LENGTH: &str = "#length";
    /// A new list of the same values, as a comprehension without brackets makes it: gone through once.
    pub(crate) const GENERATE: &str = "#generate";
    /// A copy of the same kind.
    pub(crate) const COPY: &str = "#copy";
    /// A new list of the values that something goes through.
    pub(crate) const LIST: &str = "#list";
    /// A new array, which can be added and multiplied by numbers.
    pub(crate) const VECTOR: &str = "#vector";
    /// An array, the same one if it is one.
    pub(crate) const AS_VECTOR: &str = "#as-vector";
    /// A matrix of SymPy.
    pub(crate) const MATRIX: &str = "#matrix";
    /// `append(list, value)`.
    pub(crate) const APPEND: &str = "#append";
    /// `repeat(value, count)`: a list of equal numbers.
    pub(crate) const REPEAT: &str = "#repeat";
    /// The sum of a list.
    pub(crate) const SUM: &str = "#sum";
    /// The product of a list.
    pub(crate) const PRODUCT: &str = "#product";
    /// The sum of all numbers of an array.
    pub(crate) const TOTAL: &str = "#total";
    /// The product of all numbers of an array.
    pub(crate) const TOTAL_PRODUCT: &str = "#total-product";
    /// SymPy's sum `(variable, low, high, body)`, which has a value of its own where the ends are exchanged.
    pub(crate) const SUMMED: &str = "#summed";
    /// SymPy's product, likewise.
    pub(crate) const MULTIPLIED: &str = "#multiplied";
    /// The list of pairs of a place and a value.
    pub(crate) const ENUMERATE: &str = "#enumerate";
    /// The list of tuples of values of several lists.
    pub(crate) const ZIP: &str = "#zip";
    /// `slice(list, low, high)`: the entries from low to below high.
    pub(crate) const SLICE: &str = "#slice";
    /// A list, last value first.
    pub(crate) const REVERSED: &str = "#reversed";
    /// With a name behind it: a symbol of SymPy.
    pub(crate) const SYMBOL: &str = "#symbol:";
    /// True and false.
    pub(crate) const TRUE: &str = "#true";
    /// A number as an integer; with `:` and the name of a type behind it, as one of that type.
    pub(crate) const WHOLE: &str = "#whole";
    /// The number pi.
    pub(crate) const PI: &str = "#pi";
    /// The base of the exponentials.
    pub(crate) const E: &str = "#e";
    /// With the name of a function behind it: that function of numbers for which it is real.
    pub(crate) const REAL: &str = "#real:";
    /// With the name of a function behind it: that function of integers that are not negative.
    pub(crate) const NATURAL: &str = "#natural:";
    /// An integer itself, whose power is one of integers.
    pub(crate) const INTEGER: &str = "#integer";
    /// True and false.
    pub(crate) const FALSE: &str = "#false";
}

/// A file that was read.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    pub(crate) source: Arc<Source>,
    pub(crate) language: CodeLanguage,
    pub(crate) functions: Vec<Function>,
    /// Names outside of functions with their values.
    pub(crate) constants: Vec<Constant>,
}

/// A name outside of functions, which is given a value once.
#[derive(Debug, Clone)]
pub(crate) struct Constant {
    pub(crate) name: String,
    /// Where it is given its value: in Python names that get theirs later have none yet.
    pub(crate) position: usize,
    /// Its value, or why it is not read.
    pub(crate) value: Result<Expr, Box<DerivationError>>,
    /// Whether all that the file does with it is to read its entries: then a list stays as it was made.
    pub(crate) is_only_read: bool,
}

/// The type of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Whole,
    /// Integers that are not negative, of a type that has no others.
    Natural,
    Float,
    Unknown,
}

impl Kind {
    pub(crate) fn from_whole(is_whole: bool) -> Self {
        if is_whole { Self::Whole } else { Self::Float }
    }

    /// Whether it is one of integers.
    pub(crate) fn is_integer(self) -> bool {
        matches!(self, Self::Whole | Self::Natural)
    }

    /// The type of what two numbers make: floating-point numbers prevail.
    pub(crate) fn joined(self, other: Self) -> Self {
        match (self, other) {
            (Self::Float, _) | (_, Self::Float) => Self::Float,
            (Self::Whole, Self::Whole) => Self::Whole,
            // Types of integers are not mixed: the other one is a number that is written down.
            (Self::Natural, Self::Natural | Self::Whole) | (Self::Whole, Self::Natural) => {
                Self::Natural
            }
            _ => Self::Unknown,
        }
    }
}

/// A declared type, as far as it matters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Type {
    Number(Kind),
    /// A list of values of one type.
    Each(Box<Type>),
    Tuple(Vec<Type>),
    /// Not declared.
    Open,
}

impl Type {
    /// The type of all numbers in it.
    pub(crate) fn number(&self) -> Kind {
        match self {
            Self::Number(kind) => *kind,
            Self::Each(inner) => inner.number(),
            Self::Tuple(_) | Self::Open => Kind::Unknown,
        }
    }
}

/// A function. Where its body cannot be read, this is the reason; it matters only if the function is called.
#[derive(Debug, Clone)]
pub(crate) struct Function {
    pub(crate) name: String,
    /// Where its name stands.
    pub(crate) place: Place,
    pub(crate) parameters: Vec<Parameter>,
    /// The type of its value.
    pub(crate) result: Type,
    /// The names that it assigns: they have no value before, whatever they are outside of it.
    pub(crate) locals: BTreeSet<String>,
    /// Whether a later call returns the same object.
    pub(crate) is_cached: bool,
    pub(crate) body: Result<Vec<Step>, Box<DerivationError>>,
}

#[derive(Debug, Clone)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    pub(crate) place: Place,
    /// The value where none is given.
    pub(crate) default: Option<Expr>,
    /// Its declared type.
    pub(crate) declared: Type,
}

/// One step of a function.
#[derive(Debug, Clone)]
pub(crate) enum Step {
    /// `target = value`.
    Assign {
        target: Target,
        value: Expr,
        how: Assignment,
    },
    /// A loop over a list.
    Repeat {
        variable: Target,
        values: Expr,
        body: Vec<Step>,
    },
    /// A branch.
    Branch {
        condition: Expr,
        then: Vec<Step>,
        otherwise: Vec<Step>,
    },
    /// The value of the function.
    Return(Expr),
    /// Where it ends without a value, as by `raise`.
    Stop(Place),
    /// It has a value only where this holds; none where the condition is not read.
    Assert {
        condition: Option<Expr>,
        place: Place,
    },
}

/// How a value is assigned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Assignment {
    /// The name has another value from here on.
    Set,
    /// A list is changed where it is, as by `+=`.
    InPlace,
    /// The name is new and lasts to the end of the block.
    Declare,
}

/// What is assigned to.
#[derive(Debug, Clone)]
pub(crate) enum Target {
    Name(String, Place),
    /// An entry of a list: its name, and one index for each level; several in one pair of brackets are a list.
    Entry(String, Vec<Expr>, Place),
    Several(Vec<Target>, Place),
}

impl Program {
    pub(crate) fn function(&self, name: &str) -> Option<&Function> {
        // A later definition of the same name replaces an earlier one.
        self.functions.iter().rev().find(|f| f.name == name)
    }
}

/// A formula of a program.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part<'s> {
    pub(crate) expr: &'s Expr,
    /// Where the target stands of an assignment such as `+=`, whose formula is written in part only.
    pub(crate) changed: Option<Place>,
}

/// The formulas of a list of steps, outermost first, in the order of the file.
pub(crate) fn formulas(steps: &[Step]) -> Vec<Part<'_>> {
    let plain = |expr| Part {
        expr,
        changed: None,
    };
    let mut found = vec![];
    for step in steps {
        match step {
            Step::Assign { target, value, how } => {
                found.extend(indices(target).into_iter().map(plain));
                found.push(Part {
                    expr: value,
                    changed: (*how == Assignment::InPlace).then(|| target.place()),
                });
            }
            Step::Repeat { values, body, .. } => {
                found.push(plain(values));
                found.extend(formulas(body));
            }
            Step::Branch {
                condition,
                then,
                otherwise,
            } => {
                found.push(plain(condition));
                found.extend(formulas(then));
                found.extend(formulas(otherwise));
            }
            Step::Return(value) => found.push(plain(value)),
            Step::Stop(_) | Step::Assert { .. } => {}
        }
    }
    found
}

fn indices(target: &Target) -> Vec<&Expr> {
    match target {
        Target::Name(..) => vec![],
        Target::Entry(_, indices, _) => indices.iter().collect(),
        Target::Several(all, _) => all.iter().flat_map(indices).collect(),
    }
}

impl Target {
    fn place(&self) -> Place {
        match self {
            Self::Name(_, place) | Self::Entry(_, _, place) | Self::Several(_, place) => *place,
        }
    }
}

/// Copies steps with one formula replaced: the one at a position in [`formulas`].
pub(crate) struct Replaced<'e> {
    remaining: Option<usize>,
    by: &'e Expr,
}

impl<'e> Replaced<'e> {
    pub(crate) fn new(position: usize, by: &'e Expr) -> Self {
        Self {
            remaining: Some(position),
            by,
        }
    }

    pub(crate) fn steps(&mut self, steps: &[Step]) -> Vec<Step> {
        steps.iter().map(|step| self.step(step)).collect()
    }

    fn step(&mut self, step: &Step) -> Step {
        match step {
            Step::Assign { target, value, how } => Step::Assign {
                how: *how,
                target: self.target(target),
                value: self.formula(value),
            },
            Step::Repeat {
                variable,
                values,
                body,
            } => Step::Repeat {
                variable: variable.clone(),
                values: self.formula(values),
                body: self.steps(body),
            },
            Step::Branch {
                condition,
                then,
                otherwise,
            } => Step::Branch {
                condition: self.formula(condition),
                then: self.steps(then),
                otherwise: self.steps(otherwise),
            },
            Step::Return(value) => Step::Return(self.formula(value)),
            Step::Stop(place) => Step::Stop(*place),
            assertion @ Step::Assert { .. } => assertion.clone(),
        }
    }

    fn target(&mut self, target: &Target) -> Target {
        match target {
            Target::Name(..) => target.clone(),
            Target::Entry(name, indices, place) => {
                let indices = indices.iter().map(|index| self.formula(index)).collect();
                Target::Entry(name.clone(), indices, *place)
            }
            Target::Several(all, place) => {
                Target::Several(all.iter().map(|one| self.target(one)).collect(), *place)
            }
        }
    }

    fn formula(&mut self, expr: &Expr) -> Expr {
        let here = self.remaining == Some(0);
        self.remaining = self.remaining.and_then(|left| left.checked_sub(1));
        if here { self.by.clone() } else { expr.clone() }
    }
}

/// The place of a formula that stands for none of the text.
pub(crate) const NOWHERE: Place = Place { start: 0, end: 0 };

/// A call of an operation, or of a function of the language.
pub(crate) fn call(name: &str, arguments: Vec<Expr>, place: Place) -> Expr {
    let head = Expr {
        node: Node::Name(name.to_owned()),
        place,
    };
    Expr {
        node: Node::Call(Arc::new(head), arguments),
        place,
    }
}

/// A mistake of a file of code, or what is not read in it, with its place and what would be right.
pub(crate) fn refused(
    source: &Arc<Source>,
    place: Place,
    message: impl Into<String>,
    help: impl Into<String>,
) -> Box<DerivationError> {
    let origin = Origin::range(source, place.start, place.end);
    Box::new(DerivationError::at(&origin, place, message).with_help(help))
}
