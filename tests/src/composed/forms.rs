//! Statements that are true by the way they are made, before anything slips.

use super::change::{derivative, substituted};
use super::make::{Feature, Maker};
use super::rewrite::rewritten;
use super::scene::{Hypothesis, Scene};
use super::statement::Statement;
use super::term::{Function, Operation, Part, Term};
use crate::random::seed::Stream;
use std::sync::Arc;

/// How a statement is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// A term and another of its forms.
    Rewritten,
    /// A derivative and what it is, written out.
    Derivative,
    /// Derivatives by two variables, in both orders.
    Mixed,
    /// Derivatives by two variables, written out.
    WrittenOut,
    /// A value put into a root that sees the symbol through definitions and bases.
    Moved,
    /// A product of two factors that is zero, multiplied out.
    Factored,
    /// Two equations, of which one gives the other's factor.
    Chained,
    /// The value of a sine, a cosine, an exponential or a root is given.
    Inverse,
    /// A square is not negative, a term is at most itself and a square.
    Order,
    /// A symbol and the formula that it is assumed to be.
    Eliminated,
    /// A symbol that an equation determines where its factor does not vanish.
    Divided,
    /// An equation under a premise.
    Implied,
    /// Two statements joined.
    Joined,
    /// A property of a basis, at a value of a symbol in its seeds, perhaps under a premise.
    Property,
}

impl Form {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Rewritten,
        Self::Derivative,
        Self::Mixed,
        Self::WrittenOut,
        Self::Moved,
        Self::Factored,
        Self::Chained,
        Self::Inverse,
        Self::Order,
        Self::Eliminated,
        Self::Divided,
        Self::Implied,
        Self::Joined,
        Self::Property,
    ];

    /// Its word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Rewritten => "rewritten",
            Self::Derivative => "derivative",
            Self::Mixed => "mixed",
            Self::WrittenOut => "written-out",
            Self::Moved => "moved",
            Self::Factored => "factored",
            Self::Chained => "chained",
            Self::Inverse => "inverse",
            Self::Order => "order",
            Self::Eliminated => "eliminated",
            Self::Divided => "divided",
            Self::Implied => "implied",
            Self::Joined => "joined",
            Self::Property => "property",
        }
    }
}

/// A statement of this form, and the hypotheses that it needs.
pub fn stated(
    form: Form,
    stream: &mut Stream,
    features: &[Feature],
    scene: &mut Scene,
) -> Statement {
    let depth = 1 + stream.below(3);
    match form {
        Form::Rewritten => equation(stream, features, scene, depth),
        Form::Derivative => {
            let mut maker = Maker::new(stream, features, scene);
            let (term, by) = (maker.term(depth), maker.variable());
            let order = 1 + usize::from(stream.once_in(4));
            let left = Arc::new(Term::Rate(term, by, order));
            let right = others(scene, stream, &left, 4);
            Statement::equal(&left, &right)
        }
        Form::Mixed => {
            let term = Maker::new(stream, features, scene).term(depth);
            let rate =
                |term: &Part, by: &str| Arc::new(Term::Rate(Arc::clone(term), by.to_owned(), 1));
            let left = rate(&rate(&term, "x"), "y");
            let right = rate(&rate(&term, "y"), "x");
            let right = others(scene, stream, &right, 3);
            Statement::equal(&left, &right)
        }
        Form::WrittenOut => {
            let mut term = Maker::new(stream, features, scene).term(depth.min(2));
            let (one, other) = stream.pick(&[("x", "y"), ("y", "x"), ("x", "x"), ("x", "a")]);
            if let Some(name) = scene.functions.first() {
                // A function at a place that both derivatives move.
                let operation = stream.pick(&[Operation::Add, Operation::Multiply]);
                let place = Term::binary(operation, &Term::name(one), &Term::name(other));
                let smooth = Arc::new(Term::Smooth(name.clone(), 0, place));
                let operation = stream.pick(&[Operation::Add, Operation::Multiply]);
                term = Term::binary(operation, &term, &smooth);
            }
            let rate =
                |term: &Part, by: &str| Arc::new(Term::Rate(Arc::clone(term), by.to_owned(), 1));
            let left = rate(&rate(&term, one), other);
            let right = derivative(scene, &term, one)
                .and_then(|first| derivative(scene, &first, other))
                .unwrap_or_else(|| others(scene, stream, &left, 3));
            Statement::equal(&left, &right)
        }
        Form::Moved => {
            let mut maker = Maker::new(stream, features, scene);
            let (inner, value) = (maker.term(depth - 1), maker.term(0));
            let inner = match (scene.bases.first(), scene.definitions.first()) {
                (Some(family), _) => Arc::new(Term::Basis(
                    family.name.clone(),
                    Term::int(0),
                    Term::int(i64::try_from(family.degree()).unwrap_or(0) + 1),
                    vec![],
                )),
                (None, Some(definition)) => Term::name(&definition.name),
                (None, None) => inner,
            };
            let inner = match stream.once_in(2) {
                true => inner,
                false => {
                    let square = Arc::new(Term::Power(inner, Term::int(2)));
                    Term::binary(Operation::Add, &square, &Term::int(1))
                }
            };
            let root = Arc::new(Term::Apply(Function::Root, inner));
            let by = stream.pick(&["x", "a", "b"]).to_owned();
            let at =
                |term: &Part| Arc::new(Term::At(Arc::clone(term), by.clone(), Arc::clone(&value)));
            match stream.below(3) {
                0 => Statement::equal(&at(&root), &others(scene, stream, &at(&root), 4)),
                1 => {
                    let square =
                        |term: &Part| Arc::new(Term::Power(Arc::clone(term), Term::int(2)));
                    Statement::equal(&at(&square(&root)), &square(&at(&root)))
                }
                // As if the value played no role: true where it does not.
                _ => Statement::equal(&at(&root), &root),
            }
        }
        Form::Factored => factored(stream, features, scene),
        Form::Chained => chained(stream, scene),
        Form::Inverse => inverse(stream, scene),
        Form::Order => {
            let mut maker = Maker::new(stream, features, scene);
            let (one, other) = (maker.term(depth - 1), maker.term(0));
            let square = Arc::new(Term::Power(one, Term::int(2)));
            match stream.below(3) {
                0 => Statement::Compare(square, ">=", Term::int(0)),
                1 => {
                    let more = Term::binary(Operation::Add, &square, &Term::int(1));
                    Statement::Compare(more, ">", Term::int(0))
                }
                _ => {
                    let more = Term::binary(Operation::Add, &other, &square);
                    Statement::Compare(other, "<=", others(scene, stream, &more, 2))
                }
            }
        }
        Form::Eliminated => {
            let (value, _) = assumed(stream, features, scene);
            let mut maker = Maker::new(stream, features, scene);
            let term = with(maker.term(depth), stream);
            let put = substituted(scene, &term, "a", &value).unwrap_or_else(|| Arc::clone(&term));
            let right = others(scene, stream, &put, 2);
            Statement::equal(&term, &right)
        }
        Form::Divided => {
            let quotient = divided(stream, scene);
            match stream.below(3) {
                0 => Statement::equal(&Term::name("a"), &quotient),
                _ => {
                    let term = with(Maker::new(stream, features, scene).term(depth - 1), stream);
                    let put = substituted(scene, &term, "a", &quotient)
                        .unwrap_or_else(|| Arc::clone(&term));
                    Statement::equal(&term, &put)
                }
            }
        }
        Form::Implied => {
            let (value, hypothesis) = assumed(stream, features, scene);
            scene.hypotheses.retain(|own| own.statement != hypothesis);
            let mut maker = Maker::new(stream, features, scene);
            let term = with(maker.term(depth - 1), stream);
            let put = substituted(scene, &term, "a", &value).unwrap_or_else(|| Arc::clone(&term));
            let right = others(scene, stream, &put, 2);
            Statement::Implies(
                Arc::new(hypothesis),
                Arc::new(Statement::equal(&term, &right)),
            )
        }
        Form::Joined => {
            let one = Arc::new(equation(stream, features, scene, depth.min(2)));
            let name = Maker::new(stream, features, scene).name();
            let number = Maker::new(stream, features, scene).number();
            let side =
                |relation| Statement::Compare(Term::name(&name), relation, Arc::clone(&number));
            match stream.below(3) {
                0 => {
                    let other = equation(stream, features, scene, 1);
                    Statement::And(one, Arc::new(other))
                }
                1 => Statement::Or(one, Arc::new(side("<="))),
                _ => {
                    let all = Statement::Or(Arc::new(side("<=")), Arc::new(side(">")));
                    Statement::And(Arc::new(all), one)
                }
            }
        }
        Form::Property => property(stream, scene),
    }
}

/// A term and another of its forms.
fn equation(stream: &mut Stream, features: &[Feature], scene: &Scene, depth: usize) -> Statement {
    let left = Maker::new(stream, features, scene).term(depth);
    let right = others(scene, stream, &left, 5);
    let left = others(scene, stream, &left, 1);
    Statement::equal(&left, &right)
}

/// The term after so many rewritings, as far as they fit.
fn others(scene: &Scene, stream: &mut Stream, term: &Part, count: usize) -> Part {
    let mut made = Arc::clone(term);
    for _ in 0..=stream.below(count) {
        for _ in 0..6 {
            if let Some(next) = rewritten(scene, stream, &made) {
                made = next;
                break;
            }
        }
    }
    made
}

/// The term with the symbol a somewhere.
fn with(term: Part, stream: &mut Stream) -> Part {
    let operation = stream.pick(&[Operation::Add, Operation::Multiply]);
    Term::binary(operation, &term, &Term::name("a"))
}

/// What the symbol a is assumed to be, without a.
fn assumed(stream: &mut Stream, features: &[Feature], scene: &mut Scene) -> (Part, Statement) {
    let plain: Vec<Feature> = features
        .iter()
        .copied()
        .filter(|f| matches!(f, Feature::Quotient | Feature::Integer | Feature::Member))
        .collect();
    let plain = if plain.is_empty() {
        vec![Feature::At]
    } else {
        plain
    };
    let value = loop {
        let value = Maker::new(stream, &plain, scene).term(1);
        if !super::change::mentions(scene, &value, "a") {
            break value;
        }
    };
    let statement = Statement::equal(&Term::name("a"), &value);
    scene.hypotheses.push(Hypothesis {
        statement: statement.clone(),
        solved: vec![("a".to_owned(), Arc::clone(&value))],
        unknown: None,
    });
    (value, statement)
}

/// `p*a + q == r` as a hypothesis, and `(r - q)/p`.
fn divided(stream: &mut Stream, scene: &mut Scene) -> Part {
    let symbol = Term::name("a");
    let x = Term::name(stream.pick(&["x", "y"]));
    let factor = match stream.below(6) {
        0 => Arc::clone(&x),
        1 => Term::binary(Operation::Subtract, &x, &Term::int(1)),
        2 => {
            let square = Arc::new(Term::Power(Arc::clone(&x), Term::int(2)));
            Term::binary(Operation::Subtract, &square, &x)
        }
        3 => Term::binary(Operation::Subtract, &Term::name("x"), &Term::name("y")),
        4 => Term::binary(Operation::Multiply, &Term::name("x"), &Term::name("y")),
        _ => {
            let square = Arc::new(Term::Power(Arc::clone(&x), Term::int(2)));
            Term::binary(Operation::Add, &square, &Term::int(1))
        }
    };
    let mut maker = Maker::new(stream, &[Feature::At], scene);
    let rest = loop {
        let rest = maker.term(1);
        if !super::change::mentions(scene, &rest, "a") {
            break rest;
        }
    };
    let value = match stream.once_in(2) {
        // So that the factor divides both sides.
        true => {
            let one = Term::binary(Operation::Add, &Term::name("b"), &Term::int(1));
            Term::binary(Operation::Multiply, &factor, &one)
        }
        false => Term::name("b"),
    };
    let product = Term::binary(Operation::Multiply, &factor, &symbol);
    let left = Term::binary(Operation::Add, &product, &rest);
    let quotient = Term::binary(
        Operation::Divide,
        &Term::binary(Operation::Subtract, &value, &rest),
        &factor,
    );
    let given = stream.once_in(2);
    scene.hypotheses.push(Hypothesis {
        statement: Statement::equal(&left, &value),
        solved: vec![("a".to_owned(), Arc::clone(&quotient))],
        unknown: given.then(|| "a".to_owned()),
    });
    quotient
}

/// A property of a basis whose seeds have a symbol, at a value of it.
fn property(stream: &mut Stream, scene: &mut Scene) -> Statement {
    let binary = Term::binary;
    let (x, symbol) = (Term::name("x"), Term::name("b"));
    let rest = binary(Operation::Subtract, &Term::int(1), &x);
    // Linear seeds: c - b*x is not negative on [0, 1] where b <= c.
    let bound = i64::try_from(stream.integer(1, 2)).unwrap_or(1);
    let product = binary(Operation::Multiply, &symbol, &x);
    scene.bases = vec![super::scene::Family {
        name: "A".to_owned(),
        variables: vec!["x".to_owned()],
        seeds: vec![
            binary(Operation::Subtract, &Term::int(bound), &product),
            Arc::clone(&x),
        ],
        step: [rest, Arc::clone(&x)],
    }];
    for (name, range) in &mut scene.reals {
        if name == "x" {
            *range = &super::scene::RANGES[1];
        }
    }
    // Definitions may use the basis that was there before.
    scene.definitions.clear();
    let all = Arc::new(Statement::Nonnegative("A".to_owned()));
    let premise = Statement::Compare(Arc::clone(&symbol), "<=", Term::int(bound));
    match stream.below(4) {
        0 => Statement::At(all, "b".to_owned(), Term::int(bound)),
        1 => Statement::Implies(Arc::new(premise), all),
        2 => {
            let put = binary(Operation::Subtract, &Term::name("a"), &Term::int(1));
            let bounded = Statement::Compare(Term::name("a"), "<=", Term::int(bound + 1));
            let inside = Statement::At(all, "b".to_owned(), put);
            Statement::Implies(Arc::new(bounded), Arc::new(inside))
        }
        _ => {
            let one = Statement::At(Arc::clone(&all), "b".to_owned(), Term::int(bound - 1));
            Statement::And(
                Arc::new(one),
                Arc::new(Statement::Implies(Arc::new(premise), all)),
            )
        }
    }
}

fn hypothesis(scene: &mut Scene, left: &Part, right: &Part, solved: Vec<(&str, Part)>) {
    let solved = solved
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value));
    scene.hypotheses.push(Hypothesis {
        statement: Statement::equal(left, right),
        solved: solved.collect(),
        unknown: None,
    });
}

/// `(a - p)*(a - q) == 0` multiplied out; what is true for both values is true.
fn factored(stream: &mut Stream, features: &[Feature], scene: &mut Scene) -> Statement {
    let binary = Term::binary;
    let a = Term::name("a");
    let one = stream.pick(&[Term::name("x"), Term::int(2), Term::int(-1), Term::int(0)]);
    let other = stream.pick(&[Term::name("y"), Term::minus(&one), Term::int(1)]);
    let sum = binary(
        Operation::Multiply,
        &a,
        &binary(Operation::Add, &one, &other),
    );
    let square = Arc::new(Term::Power(Arc::clone(&a), Term::int(2)));
    let left = binary(
        Operation::Add,
        &square,
        &binary(Operation::Multiply, &one, &other),
    );
    let solved = vec![("a", Arc::clone(&one)), ("a", Arc::clone(&other))];
    hypothesis(scene, &left, &sum, solved);
    let term = with(Maker::new(stream, features, scene).term(1), stream);
    let value =
        |value: &Part| substituted(scene, &term, "a", value).unwrap_or_else(|| Arc::clone(&term));
    let [p, q] = [value(&one), value(&other)];
    match stream.below(3) {
        // One of the two.
        0 => Statement::Or(
            Arc::new(Statement::equal(&a, &one)),
            Arc::new(Statement::equal(&term, &q)),
        ),
        1 => {
            let left = binary(
                Operation::Multiply,
                &binary(Operation::Subtract, &a, &one),
                &binary(Operation::Subtract, &term, &q),
            );
            Statement::equal(&left, &Term::int(0))
        }
        // As if there were only one.
        _ => Statement::equal(&term, &p),
    }
}

/// `a*g(x) == 0` and `b*(y^2 + 1) == a`: then b is zero where g has no zero.
fn chained(stream: &mut Stream, scene: &mut Scene) -> Statement {
    let binary = Term::binary;
    let square = |name: &str| Arc::new(Term::Power(Term::name(name), Term::int(2)));
    let [a, b] = ["a", "b"].map(Term::name);
    let number = Term::int(i64::try_from(stream.integer(1, 2)).unwrap_or(1));
    let operation = stream.pick(&[Operation::Add, Operation::Subtract]);
    let factor = binary(operation, &square("x"), &number);
    let left = binary(Operation::Multiply, &a, &factor);
    let mut solved = vec![("a", Term::int(0)), ("b", Arc::clone(&b))];
    if operation == Operation::Subtract {
        // Where the factor vanishes a is free.
        let root = Term::Apply(Function::Root, Arc::clone(&number));
        solved.push(("x", Arc::new(root)));
    }
    hypothesis(scene, &left, &Term::int(0), solved);
    let operation = stream.pick(&[Operation::Add, Operation::Subtract]);
    let next = binary(operation, &square("y"), &Term::int(1));
    let quotient = binary(Operation::Divide, &a, &next);
    let product = binary(Operation::Multiply, &b, &next);
    let mut solved = vec![("b", quotient), ("b", Arc::clone(&b))];
    if operation == Operation::Subtract {
        // Where this factor vanishes b is free.
        solved.push(("y", Term::int(1)));
    }
    hypothesis(scene, &product, &a, solved);
    let zero = |part: &Part| Statement::equal(part, &Term::int(0));
    match stream.below(4) {
        0 => zero(&b),
        1 => zero(&binary(Operation::Multiply, &b, &factor)),
        2 => {
            let all = binary(Operation::Multiply, &product, &factor);
            zero(&all)
        }
        _ => Statement::equal(&Arc::new(Term::Apply(Function::Cosine, b)), &Term::int(1)),
    }
}

/// What follows from the value of a function.
fn inverse(stream: &mut Stream, scene: &mut Scene) -> Statement {
    let binary = Term::binary;
    let [a, b, y] = ["a", "b", "y"].map(Term::name);
    let apply = |function, part: &Part| Arc::new(Term::Apply(function, Arc::clone(part)));
    let (zero, one, pi) = (Term::int(0), Term::int(1), Term::name("pi"));
    let square = |part: &Part| Arc::new(Term::Power(Arc::clone(part), Term::int(2)));
    for (name, range) in &mut scene.reals {
        if name == "a" || name == "b" || name == "y" {
            *range = &super::scene::RANGES[0];
        }
    }
    let turn = binary(Operation::Multiply, &Term::int(2), &pi);
    match stream.below(7) {
        0 => {
            hypothesis(
                scene,
                &apply(Function::Exponential, &a),
                &one,
                vec![("a", zero.clone())],
            );
            Statement::equal(&a, &zero)
        }
        1 => {
            hypothesis(
                scene,
                &apply(Function::Cosine, &a),
                &one,
                vec![("a", zero.clone()), ("a", turn)],
            );
            match stream.once_in(2) {
                true => Statement::equal(&a, &zero),
                false => Statement::equal(&apply(Function::Sine, &a), &zero),
            }
        }
        2 => {
            hypothesis(
                scene,
                &apply(Function::Cosine, &a),
                &b,
                vec![("b", apply(Function::Cosine, &a))],
            );
            hypothesis(
                scene,
                &apply(Function::Sine, &a),
                &y,
                vec![("y", apply(Function::Sine, &a))],
            );
            Statement::equal(&binary(Operation::Add, &square(&b), &square(&y)), &one)
        }
        3 => {
            hypothesis(
                scene,
                &apply(Function::Exponential, &a),
                &b,
                vec![("b", apply(Function::Exponential, &a))],
            );
            Statement::Compare(b, stream.pick(&[">", ">="]), zero)
        }
        4 => {
            hypothesis(
                scene,
                &apply(Function::Root, &a),
                &b,
                vec![("b", apply(Function::Root, &a))],
            );
            match stream.once_in(2) {
                true => Statement::equal(&square(&b), &a),
                false => Statement::Compare(b, ">=", zero),
            }
        }
        5 => {
            let sum = binary(Operation::Add, &a, &binary(Operation::Add, &b, &y));
            let rest = binary(
                Operation::Subtract,
                &binary(Operation::Subtract, &pi, &b),
                &y,
            );
            hypothesis(scene, &sum, &pi, vec![("a", rest)]);
            let both = binary(Operation::Add, &b, &y);
            Statement::equal(&apply(Function::Sine, &a), &apply(Function::Sine, &both))
        }
        _ => {
            let [one, other] = [&a, &b].map(|part| apply(Function::Exponential, part));
            hypothesis(scene, &one, &other, vec![("a", Arc::clone(&b))]);
            Statement::equal(&a, &b)
        }
    }
}
