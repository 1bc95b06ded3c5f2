//! Random declarations, and random terms of them.

use super::scene::{Definition, Family, RANGES, Scene};
use super::term::{Function, Operation, Part, Term};
use crate::random::seed::Stream;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What may occur in a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// Quotients by what may vanish.
    Quotient,
    /// Sines and cosines.
    Angle,
    /// Exponentials.
    Exponential,
    /// Logarithms.
    Logarithm,
    /// Roots and absolute values.
    Root,
    /// The smaller and the greater one of two numbers.
    Extremum,
    /// Smooth functions.
    Smooth,
    /// `D`
    Rate,
    /// `at`
    At,
    /// Sums and products.
    Sum,
    /// Integrals.
    Integral,
    /// Definitions.
    Definition,
    /// Bases.
    Basis,
    /// Families of numbers with a range of indices.
    Member,
    /// Integers in exponents, indices and bounds.
    Integer,
}

impl Feature {
    /// All of them.
    pub const ALL: [Self; 15] = [
        Self::Quotient,
        Self::Angle,
        Self::Exponential,
        Self::Logarithm,
        Self::Root,
        Self::Extremum,
        Self::Smooth,
        Self::Rate,
        Self::At,
        Self::Sum,
        Self::Integral,
        Self::Definition,
        Self::Basis,
        Self::Member,
        Self::Integer,
    ];

    /// Its word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Quotient => "quotient",
            Self::Angle => "angle",
            Self::Exponential => "exponential",
            Self::Logarithm => "logarithm",
            Self::Root => "root",
            Self::Extremum => "extremum",
            Self::Smooth => "smooth",
            Self::Rate => "rate",
            Self::At => "at",
            Self::Sum => "sum",
            Self::Integral => "integral",
            Self::Definition => "definition",
            Self::Basis => "basis",
            Self::Member => "member",
            Self::Integer => "integer",
        }
    }
}

/// Some features: three to six.
pub fn features(stream: &mut Stream) -> Vec<Feature> {
    let mut all = Feature::ALL.to_vec();
    stream.shuffle(&mut all);
    all.truncate(3 + stream.below(4));
    // Members have integers as indices, and derivatives of smooth functions are what they are for.
    if all.contains(&Feature::Member) && !all.contains(&Feature::Integer) {
        all.push(Feature::Integer);
    }
    if all.contains(&Feature::Smooth) && !all.contains(&Feature::Rate) {
        all.push(Feature::Rate);
    }
    all.sort_unstable();
    all
}

/// Makes terms.
pub struct Maker<'a> {
    /// The stream.
    pub stream: &'a mut Stream,
    /// What may occur.
    pub features: &'a [Feature],
    /// What is declared so far.
    pub scene: &'a Scene,
    /// Numbers that may be named.
    names: Vec<String>,
    /// Indices of sums that run here.
    indices: Vec<String>,
    /// Where each function is taken, if that is settled.
    places: BTreeMap<String, Part>,
}

impl<'a> Maker<'a> {
    /// For these declarations.
    pub fn new(stream: &'a mut Stream, features: &'a [Feature], scene: &'a Scene) -> Self {
        let names = scene.reals.iter().map(|(name, _)| name.clone());
        Self {
            stream,
            features,
            scene,
            names: names.filter(|name| name != "t").collect(),
            indices: vec![],
            places: BTreeMap::new(),
        }
    }

    /// With a number that may be named besides.
    #[must_use]
    pub fn naming(mut self, names: &[String]) -> Self {
        self.names.extend(names.iter().cloned());
        self
    }

    fn has(&self, feature: Feature) -> bool {
        self.features.contains(&feature)
    }

    /// A name of a number.
    pub fn name(&mut self) -> String {
        self.stream.pick(&self.names)
    }

    fn symbol(&mut self) -> Part {
        let name = self.name();
        Term::name(&name)
    }

    /// A declared number, by which one may differentiate.
    pub fn variable(&mut self) -> String {
        let all: Vec<String> = self
            .scene
            .reals
            .iter()
            .map(|(name, _)| name.clone())
            .collect();
        self.stream.pick(&all[..all.len().min(2)])
    }

    /// A small number, not zero.
    pub fn number(&mut self) -> Part {
        let below = if self.stream.once_in(4) { 2 } else { 1 };
        let above = i64::try_from(self.stream.nonzero(3)).unwrap_or(1);
        match below == 2 && above % 2 == 0 {
            true => Term::int(above / 2),
            false => Arc::new(Term::Number(above, below)),
        }
    }

    fn leaf(&mut self) -> Part {
        match self.stream.below(8) {
            0 => self.number(),
            1 if !self.indices.is_empty() => Term::name(&self.stream.pick(&self.indices)),
            2 if self.has(Feature::Integer) => Term::name("m"),
            3 if self.has(Feature::Member) => {
                let index = self.index();
                Arc::new(Term::Member("P".to_owned(), index))
            }
            4 if self.has(Feature::Definition) && !self.scene.definitions.is_empty() => {
                self.defined(0)
            }
            5 if self.has(Feature::Smooth) => self.smooth(),
            _ => self.symbol(),
        }
    }

    /// An index of the family, between 0 and m, for m of at least 1.
    fn index(&mut self) -> Part {
        let last = Term::name("m");
        match self.stream.below(5) {
            0 => Term::int(0),
            1 => Term::int(1),
            2 => last,
            3 => Term::binary(Operation::Subtract, &last, &Term::int(1)),
            _ => match self.indices.last() {
                Some(index) => Term::name(index),
                None => Term::int(0),
            },
        }
    }

    fn defined(&mut self, depth: usize) -> Part {
        let definition = self.stream.pick(&self.scene.definitions);
        let arguments = definition
            .parameters
            .iter()
            .map(|_| self.term(depth.min(1)));
        let arguments: Vec<Part> = arguments.collect();
        match arguments.is_empty() {
            true => Term::name(&definition.name),
            false => Arc::new(Term::Defined(definition.name, arguments)),
        }
    }

    fn smooth(&mut self) -> Part {
        let name = self.stream.pick(&self.scene.functions);
        let place = match self.places.get(&name) {
            Some(place) if !self.stream.once_in(20) => Arc::clone(place),
            _ => {
                let (one, other) = (self.symbol(), self.symbol());
                match self.stream.below(7) {
                    0 => Term::binary(Operation::Multiply, &one, &other),
                    1 => Term::binary(Operation::Add, &one, &other),
                    2 => Term::binary(Operation::Multiply, &Term::int(2), &one),
                    3 if name == "f" && self.scene.functions.len() > 1 => {
                        Arc::new(Term::Smooth("g".to_owned(), 0, one))
                    }
                    4 => Arc::new(Term::Power(one, Term::int(2))),
                    _ => one,
                }
            }
        };
        self.places.insert(name.clone(), Arc::clone(&place));
        let order = if self.stream.once_in(4) { 1 } else { 0 };
        Arc::new(Term::Smooth(name, order, place))
    }

    /// What sines, cosines and exponentials are taken of.
    fn linear(&mut self) -> Part {
        let one = self.symbol();
        match self.stream.below(4) {
            0 => Term::binary(Operation::Add, &one, &self.symbol()),
            1 => Term::binary(Operation::Multiply, &Term::int(2), &one),
            _ => one,
        }
    }

    /// A random term, nested about so deep.
    pub fn term(&mut self, depth: usize) -> Part {
        if depth == 0 {
            return self.leaf();
        }
        for _ in 0..4 {
            let arithmetic = self.stream.once_in(2);
            let feature = self.stream.pick(self.features);
            let made = match arithmetic {
                true => None,
                false => self.featured(feature, depth),
            };
            if let Some(made) = made {
                return made;
            }
            if arithmetic {
                break;
            }
        }
        let one = self.term(depth - 1);
        match self.stream.below(7) {
            0 | 1 => Term::binary(Operation::Add, &one, &self.term(depth - 1)),
            2 => Term::binary(Operation::Subtract, &one, &self.term(depth - 1)),
            3 | 4 => Term::binary(Operation::Multiply, &one, &self.term(depth - 1)),
            5 => Term::minus(&one),
            _ => Arc::new(Term::Power(one, Term::int(2))),
        }
    }

    fn featured(&mut self, feature: Feature, depth: usize) -> Option<Part> {
        Some(match feature {
            Feature::Quotient => {
                let above = self.term(depth - 1);
                let below = match self.stream.below(3) {
                    0 => self.symbol(),
                    1 => Term::binary(Operation::Subtract, &self.symbol(), &self.number()),
                    _ => self.term(0),
                };
                Term::binary(Operation::Divide, &above, &below)
            }
            Feature::Angle => {
                let function = self.stream.pick(&[Function::Sine, Function::Cosine]);
                Arc::new(Term::Apply(function, self.linear()))
            }
            Feature::Exponential => Arc::new(Term::Apply(Function::Exponential, self.linear())),
            Feature::Logarithm => {
                let inner = match self.stream.below(6) {
                    0 | 1 => self.symbol(),
                    2 => {
                        let square = Arc::new(Term::Power(self.term(depth - 1), Term::int(2)));
                        Term::binary(Operation::Add, &square, &Term::int(1))
                    }
                    3 => Arc::new(Term::Power(self.symbol(), Term::int(2))),
                    4 => Arc::new(Term::Apply(Function::Exponential, self.linear())),
                    _ => Term::binary(Operation::Multiply, &self.symbol(), &self.symbol()),
                };
                Arc::new(Term::Apply(Function::Logarithm, inner))
            }
            Feature::Root => {
                let inner = match self.stream.below(4) {
                    0 => self.symbol(),
                    1 => {
                        let square = Arc::new(Term::Power(self.term(depth - 1), Term::int(2)));
                        Term::binary(Operation::Add, &square, &Term::int(1))
                    }
                    2 => Arc::new(Term::Power(self.term(depth - 1), Term::int(2))),
                    _ => Term::binary(Operation::Multiply, &self.symbol(), &self.symbol()),
                };
                let function = self
                    .stream
                    .pick(&[Function::Root, Function::Root, Function::Size]);
                Arc::new(Term::Apply(function, inner))
            }
            Feature::Extremum => {
                let operation = self.stream.pick(&[Operation::Least, Operation::Greatest]);
                let other = match self.stream.once_in(3) {
                    true => self.number(),
                    false => self.symbol(),
                };
                Term::binary(operation, &self.term(depth - 1), &other)
            }
            Feature::Smooth => self.smooth(),
            Feature::Rate => {
                let inner = self.term(depth - 1);
                let by = self.variable();
                Arc::new(Term::Rate(
                    inner,
                    by,
                    1 + usize::from(self.stream.once_in(4)),
                ))
            }
            Feature::At => {
                let inner = self.term(depth - 1);
                let by = self.variable();
                let value = match self.stream.once_in(2) {
                    true => self.number(),
                    false => self.term(0),
                };
                Arc::new(Term::At(inner, by, value))
            }
            Feature::Sum => {
                let index = self.stream.pick(&["i", "j", "i", "j", "b"]).to_owned();
                let high = match self.has(Feature::Integer) && self.stream.once_in(2) {
                    true => Term::name("m"),
                    false => Term::int(2),
                };
                self.indices.push(index.clone());
                let body = self.term(depth - 1);
                self.indices.pop();
                let low = Term::int(i64::from(self.stream.once_in(3)));
                match self.stream.once_in(5) && *high == Term::Number(2, 1) {
                    true => Arc::new(Term::Product(index, low, high, body)),
                    false => Arc::new(Term::Sum(index, low, high, body)),
                }
            }
            Feature::Integral => {
                let outer = self.names.len();
                self.names.push("t".to_owned());
                let polynomial = match self.stream.below(3) {
                    0 => Arc::new(Term::Power(Term::name("t"), Term::int(2))),
                    1 => Term::binary(Operation::Multiply, &Term::name("t"), &self.symbol()),
                    _ => Term::name("t"),
                };
                self.names.truncate(outer);
                let other = self.term(depth - 1);
                let operation = self.stream.pick(&[Operation::Multiply, Operation::Add]);
                let body = Term::binary(operation, &polynomial, &other);
                let ends = [Term::int(1), Term::int(2), self.symbol()];
                let high = self.stream.pick(&ends);
                Arc::new(Term::Integral(body, "t".to_owned(), Term::int(0), high))
            }
            Feature::Definition => {
                if self.scene.definitions.is_empty() {
                    return None;
                }
                self.defined(depth - 1)
            }
            Feature::Basis => {
                let family = self.scene.bases.first()?;
                let least = i64::try_from(family.degree()).unwrap_or(0);
                let degree = least + i64::try_from(self.stream.below(3)).unwrap_or(0);
                let index = i64::try_from(self.stream.below(4)).unwrap_or(0).min(degree);
                let arguments = match self.stream.below(3) {
                    0 => vec![],
                    _ => vec![self.term(0)],
                };
                Arc::new(Term::Basis(
                    family.name.clone(),
                    Term::int(index),
                    Term::int(degree),
                    arguments,
                ))
            }
            Feature::Member => {
                let index = self.index();
                Arc::new(Term::Member("P".to_owned(), index))
            }
            Feature::Integer => Arc::new(Term::Power(self.leaf(), Term::name("m"))),
        })
    }
}

/// Random declarations with these features.
pub fn scene(stream: &mut Stream, features: &[Feature]) -> Scene {
    let has = |feature| features.contains(&feature);
    let mut scene = Scene::default();
    for name in ["x", "y", "a", "b"] {
        let range = if stream.once_in(2) {
            0
        } else {
            stream.below(RANGES.len())
        };
        scene.reals.push((name.to_owned(), &RANGES[range]));
    }
    if has(Feature::Integral) {
        scene.reals.push(("t".to_owned(), &RANGES[0]));
    }
    if has(Feature::Integer) {
        scene
            .integers
            .push(("m".to_owned(), 1, 3, stream.once_in(2)));
    }
    if has(Feature::Member) {
        scene.families.push(("P".to_owned(), "m".to_owned()));
    }
    if has(Feature::Smooth) {
        scene.functions.push("f".to_owned());
        if stream.once_in(2) {
            scene.functions.push("g".to_owned());
        }
    }
    if has(Feature::Basis) {
        scene.bases.push(basis(stream));
    }
    if has(Feature::Definition) {
        // The bodies have no definitions and no integrals.
        let inner: Vec<Feature> = features
            .iter()
            .copied()
            .filter(|f| !matches!(f, Feature::Definition | Feature::Integral))
            .collect();
        let inner = if inner.is_empty() {
            vec![Feature::At]
        } else {
            inner
        };
        let parameter = stream.pick(&["u", "x", "b"]).to_owned();
        let body = Maker::new(stream, &inner, &scene)
            .naming(std::slice::from_ref(&parameter))
            .term(2);
        let function = Definition {
            name: "F".to_owned(),
            parameters: vec![parameter],
            body,
        };
        let body = Maker::new(stream, &inner, &scene).term(2);
        let plain = Definition {
            name: "E".to_owned(),
            parameters: vec![],
            body,
        };
        scene.definitions.extend([plain, function]);
    }
    scene
}

/// Bernstein polynomials, or two seeds with a symbol in them.
fn basis(stream: &mut Stream) -> Family {
    let x = Term::name("x");
    let rest = Term::binary(Operation::Subtract, &Term::int(1), &x);
    let step = [Arc::clone(&rest), Arc::clone(&x)];
    let seeds = match stream.once_in(2) {
        true => vec![Term::int(1)],
        false => {
            let symbol = Term::name(stream.pick(&["a", "b"]));
            let one = Term::binary(Operation::Multiply, &symbol, &x);
            let other = Term::binary(Operation::Subtract, &Term::int(2), &one);
            vec![one, other]
        }
    };
    Family {
        name: "B".to_owned(),
        variables: vec!["x".to_owned()],
        seeds,
        step,
    }
}
