//! The value of a term and the truth of a statement at a point, in doubles: written along `derivations/SEMANTICS.md`, with
//! nothing of the crates.
//!
//! What has no value, or none that doubles can tell, is nothing: such a point says neither true nor false.

use super::jet::Jet;
use super::scene::{Family, Point, Scene};
use super::statement::Statement;
use super::term::{Function, Operation, Part, Term};

/// The most terms of a sum.
const MAX_TERMS: i64 = 60;
/// Numbers nearer than this part of their size are equal.
const EQUAL: f64 = 1e-9;
/// Numbers farther apart than this part of their size are different.
const DIFFERENT: f64 = 1e-5;
/// Larger numbers are not compared.
const LARGEST: f64 = 1e7;
/// Nodes and weights of Gauss and Legendre on [-1, 1], the positive half.
const NODES: [(f64, f64); 5] = [
    (0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// What names stand for that are bound.
#[derive(Clone, Default)]
struct Bound {
    /// Indices, parameters, variables of a basis: not seen by the bodies of definitions.
    local: Vec<(String, Jet)>,
    /// Declared symbols under `at`, `D` and `integral`: seen through definitions and seeds.
    moved: Vec<(String, Jet)>,
}

impl Bound {
    fn find(&self, name: &str) -> Option<&Jet> {
        let all = self.local.iter().rev().chain(self.moved.iter().rev());
        all.into_iter()
            .find(|(own, _)| own == name)
            .map(|(_, value)| value)
    }

    fn with(&self, name: &str, value: Jet) -> Self {
        let mut more = self.clone();
        let layer = match self.local.iter().any(|(own, _)| own == name) {
            true => &mut more.local,
            false => &mut more.moved,
        };
        layer.push((name.to_owned(), value));
        more
    }

    fn inside(&self, local: Vec<(String, Jet)>) -> Self {
        let moved = self.moved.clone();
        Self { local, moved }
    }
}

/// Evaluates at a point.
pub struct Evaluator<'a> {
    scene: &'a Scene,
    point: &'a Point,
}

impl<'a> Evaluator<'a> {
    /// At this point.
    #[must_use]
    pub fn new(scene: &'a Scene, point: &'a Point) -> Self {
        Self { scene, point }
    }

    /// The value of a term.
    #[must_use]
    pub fn term(&self, term: &Term) -> Option<f64> {
        let value = self.value(term, &Bound::default(), 0)?.number();
        value.is_finite().then_some(value)
    }

    /// Whether a statement is true.
    #[must_use]
    pub fn statement(&self, statement: &Statement) -> Option<bool> {
        self.truth(statement, &Bound::default())
    }

    fn truth(&self, statement: &Statement, bound: &Bound) -> Option<bool> {
        match statement {
            Statement::Compare(a, relation, b) => {
                let a = self.value(a, bound, 0)?.number();
                let b = self.value(b, bound, 0)?.number();
                compare(a, relation, b)
            }
            Statement::And(p, q) => Some(self.truth(p, bound)? & self.truth(q, bound)?),
            Statement::Or(p, q) => Some(self.truth(p, bound)? | self.truth(q, bound)?),
            Statement::Implies(p, q) => Some(!self.truth(p, bound)? | self.truth(q, bound)?),
            Statement::Nonnegative(name) => self.nonnegative(self.scene.basis(name)?, bound),
            Statement::At(p, by, value) => {
                let value = self.value(value, bound, 0)?;
                self.truth(p, &bound.with(by, value))
            }
        }
    }

    /// Whether the functions of the first degrees are not negative on [0, 1].
    fn nonnegative(&self, family: &Family, bound: &Bound) -> Option<bool> {
        let mut least = f64::INFINITY;
        for x in (0..=16).map(|k| f64::from(k) / 16.0) {
            let mut arguments = vec![Jet::Number(x)];
            for name in family.variables.iter().skip(1) {
                let name = Term::Name(name.clone());
                arguments.push(self.value(&name, &bound.inside(vec![]), 0)?);
            }
            for degree in family.degree()..family.degree() + 2 {
                for value in self.row(family, degree, &arguments, bound, 0)? {
                    least = least.min(value.number());
                }
            }
        }
        match least {
            least if least >= -1e-12 => Some(true),
            least if least < -DIFFERENT => Some(false),
            _ => None,
        }
    }

    fn integer(&self, term: &Term, bound: &Bound, level: u32) -> Option<i64> {
        match self.value(term, bound, level)? {
            Jet::Number(x) if (x - x.round()).abs() < 1e-9 && x.abs() < 1e6 => {
                Some(x.round() as i64)
            }
            _ => None,
        }
    }

    fn value(&self, term: &Term, bound: &Bound, level: u32) -> Option<Jet> {
        let value = |part: &Part| self.value(part, bound, level);
        Some(match term {
            Term::Number(above, below) => Jet::Number(*above as f64 / *below as f64),
            Term::Name(name) => match bound.find(name) {
                Some(value) => value.clone(),
                None => match self.scene.definition(name) {
                    Some(definition) => {
                        self.value(&definition.body, &bound.inside(vec![]), level)?
                    }
                    None if name == "pi" => Jet::Number(std::f64::consts::PI),
                    None => Jet::Number(*self.point.numbers.get(name)?),
                },
            },
            Term::Negative(a) => value(a)?.scaled(-1.0),
            Term::Binary(operation, a, b) => {
                let (a, b) = (value(a)?, value(b)?);
                match operation {
                    Operation::Add => a.plus(&b),
                    Operation::Subtract => a.plus(&b.scaled(-1.0)),
                    Operation::Multiply => a.times(&b),
                    Operation::Divide => a.times(&inverse(&b)?),
                    Operation::Least => least(&a, &b)?,
                    Operation::Greatest => least(&a.scaled(-1.0), &b.scaled(-1.0))?.scaled(-1.0),
                }
            }
            Term::Power(a, n) => power(&value(a)?, self.integer(n, bound, level)?)?,
            Term::Apply(function, a) => applied(*function, &value(a)?)?,
            Term::Smooth(name, order, place) => {
                let smooth = self.point.functions.get(name)?;
                value(place)?.through(&|k, t| Some(smooth.at(k + order, t)))?
            }
            Term::Rate(body, by, order) => {
                let point = self.value(&Term::Name(by.clone()), bound, level)?;
                let own = level + 1;
                let inside = bound.with(by, Jet::variable(own, point, *order));
                let factorial = (1..=*order).map(|k| k as f64).product();
                let series = self.value(body, &inside, own)?;
                series.coefficient(own, *order).scaled(factorial)
            }
            Term::At(body, by, put) => {
                let put = value(put)?;
                self.value(body, &bound.with(by, put), level)?
            }
            Term::Sum(index, low, high, body) => {
                let mut sum = Jet::Number(0.0);
                for inside in self.rounds(index, low, high, bound, level)? {
                    sum = sum.plus(&self.value(body, &inside, level)?);
                }
                sum
            }
            Term::Product(index, low, high, body) => {
                let mut product = Jet::Number(1.0);
                for inside in self.rounds(index, low, high, bound, level)? {
                    product = product.times(&self.value(body, &inside, level)?);
                }
                product
            }
            Term::Integral(body, by, low, high) => {
                let (low, high) = (value(low)?, value(high)?);
                self.integral(body, by, &low, &high, bound, level)?
            }
            Term::Defined(name, arguments) => {
                let definition = self.scene.definition(name)?;
                let mut local = vec![];
                for (parameter, argument) in definition.parameters.iter().zip(arguments) {
                    local.push((parameter.clone(), value(argument)?));
                }
                self.value(&definition.body, &bound.inside(local), level)?
            }
            Term::Member(name, index) => {
                let index = self.integer(index, bound, level)?;
                Jet::Number(*self.point.members.get(&(name.clone(), index))?)
            }
            Term::Basis(name, index, degree, given) => {
                let family = self.scene.basis(name)?;
                let index = self.integer(index, bound, level)?;
                let degree = usize::try_from(self.integer(degree, bound, level)?).ok()?;
                let mut arguments = vec![];
                for argument in given {
                    arguments.push(value(argument)?);
                }
                for name in family.variables.iter().skip(given.len()) {
                    let name = Term::Name(name.clone());
                    arguments.push(self.value(&name, &bound.inside(vec![]), level)?);
                }
                let row = self.row(family, degree, &arguments, bound, level)?;
                let index = usize::try_from(index).ok();
                let found = index.and_then(|index| row.get(index).cloned());
                found.unwrap_or(Jet::Number(0.0))
            }
        })
    }

    /// The bindings of an index that runs.
    fn rounds(
        &self,
        index: &str,
        low: &Part,
        high: &Part,
        bound: &Bound,
        level: u32,
    ) -> Option<Vec<Bound>> {
        let low = self.integer(low, bound, level)?;
        let high = self.integer(high, bound, level)?;
        if high - low > MAX_TERMS {
            return None;
        }
        let round = |n: i64| {
            let mut inside = bound.clone();
            inside.local.push((index.to_owned(), Jet::Number(n as f64)));
            inside
        };
        Some((low..=high).map(round).collect())
    }

    /// By the rule of Gauss and Legendre on four pieces.
    fn integral(
        &self,
        body: &Part,
        by: &str,
        low: &Jet,
        high: &Jet,
        bound: &Bound,
        level: u32,
    ) -> Option<Jet> {
        let length = high.plus(&low.scaled(-1.0));
        // Both ends belong to the interval.
        for end in [low, high] {
            self.value(body, &bound.with(by, end.clone()), level)?;
        }
        let mut sum = Jet::Number(0.0);
        for piece in 0..4 {
            for (node, weight) in NODES.iter().flat_map(|(x, w)| [(*x, *w), (-*x, *w)]) {
                let share = (f64::from(piece) + 0.5 + node / 2.0) / 4.0;
                let place = low.plus(&length.scaled(share));
                let value = self.value(body, &bound.with(by, place), level)?;
                sum = sum.plus(&value.scaled(weight / 8.0));
            }
        }
        Some(sum.times(&length))
    }

    /// The functions of a degree.
    fn row(
        &self,
        family: &Family,
        degree: usize,
        arguments: &[Jet],
        bound: &Bound,
        level: u32,
    ) -> Option<Vec<Jet>> {
        let names = family.variables.iter().cloned();
        let inside = bound.inside(names.zip(arguments.iter().cloned()).collect());
        let value = |part: &Part| self.value(part, &inside, level);
        let mut row: Vec<Jet> = family.seeds.iter().map(value).collect::<Option<_>>()?;
        if degree + 1 < row.len() || degree > 12 {
            return None;
        }
        let (a, b) = (value(&family.step[0])?, value(&family.step[1])?);
        while row.len() <= degree {
            let mut next: Vec<Jet> = row.iter().map(|g| a.times(g)).collect();
            next.push(Jet::Number(0.0));
            for (sum, g) in next.iter_mut().skip(1).zip(&row) {
                *sum = sum.plus(&b.times(g));
            }
            row = next;
        }
        Some(row)
    }
}

fn compare(a: f64, relation: &str, b: f64) -> Option<bool> {
    let size = 1.0 + a.abs() + b.abs();
    if size.is_nan() || size >= LARGEST {
        return None;
    }
    let apart = (a - b).abs() / size;
    let (equal, different) = (apart < EQUAL, apart > DIFFERENT);
    if !equal && !different {
        return None;
    }
    match relation {
        "==" => Some(equal),
        "!=" => Some(different),
        "<=" => Some(equal || a < b),
        ">=" => Some(equal || a > b),
        _ if equal => None,
        "<" => Some(a < b),
        _ => Some(a > b),
    }
}

/// The smaller one of two; where they are nearly equal there is a corner, and no derivative.
fn least(a: &Jet, b: &Jet) -> Option<Jet> {
    let (first, second) = (a.number(), b.number());
    match (a, b) {
        (Jet::Number(_), Jet::Number(_)) => Some(Jet::Number(first.min(second))),
        _ if (first - second).abs() < 1e-6 => None,
        _ => Some(if first < second { a.clone() } else { b.clone() }),
    }
}

fn inverse(jet: &Jet) -> Option<Jet> {
    jet.through(&|k, x| {
        let mut value = 1.0 / x;
        for j in 1..=k {
            value *= -(j as f64) / x;
        }
        (x.abs() > 1e-6).then_some(value)
    })
}

fn power(base: &Jet, n: i64) -> Option<Jet> {
    if n < 0 {
        return power(&inverse(base)?, -n);
    }
    let factors = std::iter::repeat_n(base, usize::try_from(n.min(40)).ok()?);
    Some(factors.fold(Jet::Number(1.0), |product, a| product.times(a)))
}

fn applied(function: Function, a: &Jet) -> Option<Jet> {
    let turned = |x: f64, k: usize| x + std::f64::consts::FRAC_PI_2 * (k % 4) as f64;
    a.through(&|k, x| match function {
        Function::Sine => Some(turned(x, k).sin()),
        Function::Cosine => Some(turned(x, k).cos()),
        Function::Exponential => Some(x.exp()),
        Function::Logarithm if x <= 1e-6 => None,
        Function::Logarithm if k == 0 => Some(x.ln()),
        // (-1)^(k-1) (k-1)! / x^k
        Function::Logarithm => {
            let falling = (1..k).map(|j| -(j as f64)).product::<f64>();
            Some(falling / x.powi(i32::try_from(k).ok()?))
        }
        Function::Root => {
            let falling = (0..k).map(|j| 0.5 - j as f64).product::<f64>();
            let fits = x > 1e-6 || k == 0 && x >= 0.0;
            fits.then(|| falling * x.powf(0.5 - k as f64))
        }
        Function::Size => match k {
            0 => Some(x.abs()),
            _ if x.abs() < 1e-6 => None,
            1 => Some(x.signum()),
            _ => Some(0.0),
        },
    })
}
