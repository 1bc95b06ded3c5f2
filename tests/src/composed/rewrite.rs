//! Other terms of the same value, wherever both have one.

use super::change::{derivative, mentions, substituted, unfolded};
use super::scene::Scene;
use super::term::{Function, Operation, Part, Term};
use crate::random::seed::Stream;
use std::sync::Arc;

use Operation::{Add, Divide, Greatest, Least, Multiply, Subtract};

/// The most nodes of a term that is made.
const MAX_SIZE: usize = 120;

/// The term with one of its nodes rewritten, if the rule that is drawn fits the node that is drawn.
pub fn rewritten(scene: &Scene, stream: &mut Stream, term: &Part) -> Option<Part> {
    let place = stream.below(term.size());
    let changed = at_node(term, place, &mut |node| rule(scene, stream, node))?;
    (changed.size() <= MAX_SIZE && changed != *term).then_some(changed)
}

/// The term with the node of this number, counted from the left and from the outside, changed.
pub fn at_node(
    term: &Part,
    place: usize,
    change: &mut dyn FnMut(&Part) -> Option<Part>,
) -> Option<Part> {
    if place == 0 {
        return change(term);
    }
    let mut before = 1;
    let mut target = None;
    for (number, part) in term.parts().iter().enumerate() {
        if (before..before + part.size()).contains(&place) {
            target = Some((number, place - before));
        }
        before += part.size();
    }
    let (number, rest) = target?;
    let changed = at_node(term.parts().get(number)?, rest, change)?;
    Some(Arc::new(term.with_parts(|own, part| {
        Arc::clone(if own == number { &changed } else { part })
    })))
}

fn rule(scene: &Scene, stream: &mut Stream, term: &Part) -> Option<Part> {
    let binary = Term::binary;
    if stream.once_in(6) {
        return anywhere(scene, stream, term);
    }
    match &**term {
        Term::Binary(Add, a, b) => Some(match stream.below(3) {
            0 => binary(Add, b, a),
            1 => binary(Subtract, a, &Term::minus(b)),
            _ => match &**b {
                Term::Binary(Add, c, d) => binary(Add, &binary(Add, a, c), d),
                _ => binary(Add, b, a),
            },
        }),
        Term::Binary(Subtract, a, b) => Some(binary(Add, a, &Term::minus(b))),
        Term::Binary(Multiply, a, b) => match (&**a, &**b) {
            (_, Term::Binary(Add, c, d)) => Some(binary(
                Add,
                &binary(Multiply, a, c),
                &binary(Multiply, a, d),
            )),
            (Term::Binary(Subtract, c, d), _) => {
                let (one, other) = (binary(Multiply, c, b), binary(Multiply, d, b));
                Some(binary(Subtract, &one, &other))
            }
            (Term::Apply(Function::Exponential, c), Term::Apply(Function::Exponential, d)) => Some(
                Arc::new(Term::Apply(Function::Exponential, binary(Add, c, d))),
            ),
            _ => Some(binary(Multiply, b, a)),
        },
        Term::Binary(Divide, a, b) => {
            let one = binary(Divide, &Term::int(1), b);
            Some(binary(Multiply, a, &one))
        }
        Term::Binary(own @ (Least | Greatest), a, b) => Some(match stream.below(4) {
            0 => binary(*own, b, a),
            1 => {
                let other = if *own == Least { Greatest } else { Least };
                binary(Subtract, &binary(Add, a, b), &binary(other, a, b))
            }
            2 => {
                let other = if *own == Least { Greatest } else { Least };
                Term::minus(&binary(other, &Term::minus(a), &Term::minus(b)))
            }
            _ => {
                let size = Arc::new(Term::Apply(Function::Size, binary(Subtract, a, b)));
                let sign = if *own == Least { Subtract } else { Add };
                let twice = binary(sign, &binary(Add, a, b), &size);
                binary(Divide, &twice, &Term::int(2))
            }
        }),
        Term::Negative(a) => Some(binary(Subtract, &Term::int(0), a)),
        Term::Power(a, n) => match &**n {
            Term::Number(n, 1) if *n >= 2 => {
                let less = Arc::new(Term::Power(Arc::clone(a), Term::int(n - 1)));
                Some(binary(Multiply, a, &less))
            }
            Term::Binary(Add, n, one) if **one == Term::Number(1, 1) => {
                let less = Arc::new(Term::Power(Arc::clone(a), Arc::clone(n)));
                Some(binary(Multiply, a, &less))
            }
            _ => None,
        },
        Term::Apply(function, a) => applied(*function, a),
        Term::Rate(a, by, 1) => derivative(scene, a, by),
        Term::Rate(a, by, order) => {
            let less = Arc::new(Term::Rate(Arc::clone(a), by.clone(), order - 1));
            match stream.once_in(2) {
                true => Some(Arc::new(Term::Rate(less, by.clone(), 1))),
                false => {
                    let inner = derivative(scene, a, by)?;
                    Some(Arc::new(Term::Rate(inner, by.clone(), order - 1)))
                }
            }
        }
        Term::At(a, by, value) => substituted(scene, a, by, value),
        Term::Sum(index, low, high, a) => summed(scene, stream, index, [low, high, a]),
        Term::Product(index, low, high, a) => {
            let last = substituted(scene, a, index, high)?;
            let (Term::Number(first, 1), Term::Number(n, 1)) = (&**low, &**high) else {
                return None;
            };
            let less = Term::int(n - 1);
            let rest = Term::Product(index.clone(), Arc::clone(low), less, Arc::clone(a));
            (n >= first).then(|| binary(Multiply, &Arc::new(rest), &last))
        }
        Term::Integral(a, by, low, high) => integrated(scene, stream, a, by, [low, high]),
        Term::Defined(name, arguments) => unfolded(scene, name, arguments),
        Term::Name(name) if scene.definition(name).is_some() => unfolded(scene, name, &[]),
        Term::Basis(name, index, degree, arguments) => {
            let family = scene.basis(name)?;
            let (Term::Number(k, 1), [argument]) = (&**degree, arguments.as_slice()) else {
                return None;
            };
            if usize::try_from(*k).ok()? <= family.degree() || family.variables.len() > 1 {
                return None;
            }
            let lower = |index: &Part| {
                let all = vec![Arc::clone(argument)];
                Arc::new(Term::Basis(
                    name.clone(),
                    Arc::clone(index),
                    Term::int(k - 1),
                    all,
                ))
            };
            let factor = |n: usize| {
                let variable = family.variables.first()?;
                substituted(scene, family.step.get(n)?, variable, argument)
            };
            let before = binary(Subtract, index, &Term::int(1));
            let one = binary(Multiply, &factor(0)?, &lower(index));
            let other = binary(Multiply, &factor(1)?, &lower(&before));
            Some(binary(Add, &one, &other))
        }
        _ => anywhere(scene, stream, term),
    }
}

/// What may be done with any term.
fn anywhere(scene: &Scene, stream: &mut Stream, term: &Part) -> Option<Part> {
    let binary = Term::binary;
    let (name, _) = stream.pick(&scene.reals);
    let symbol = Term::name(&name);
    Some(match stream.below(6) {
        0 => binary(Subtract, &binary(Add, term, &symbol), &symbol),
        1 => binary(
            Divide,
            &binary(Multiply, term, &Term::int(3)),
            &Term::int(3),
        ),
        2 => Arc::new(Term::At(Arc::clone(term), name, symbol)),
        3 => {
            let square = |f| {
                let applied = Arc::new(Term::Apply(f, Arc::clone(&symbol)));
                Arc::new(Term::Power(applied, Term::int(2)))
            };
            let one = binary(Add, &square(Function::Sine), &square(Function::Cosine));
            binary(Multiply, term, &one)
        }
        4 => {
            let factor = binary(
                Add,
                &Arc::new(Term::Power(symbol, Term::int(2))),
                &Term::int(1),
            );
            binary(Divide, &binary(Multiply, &factor, term), &factor)
        }
        // A sum of one term.
        _ => Arc::new(Term::Sum(
            "q".to_owned(),
            Term::int(1),
            Term::int(1),
            Arc::clone(term),
        )),
    })
}

fn applied(function: Function, a: &Part) -> Option<Part> {
    let apply = |f, a: &Part| Arc::new(Term::Apply(f, Arc::clone(a)));
    match (function, &**a) {
        (Function::Exponential, Term::Binary(Add, b, c)) => {
            let [b, c] = [b, c].map(|part| apply(function, part));
            Some(Term::binary(Multiply, &b, &c))
        }
        (Function::Exponential, Term::Apply(Function::Logarithm, b))
        | (Function::Logarithm, Term::Apply(Function::Exponential, b)) => Some(Arc::clone(b)),
        (Function::Logarithm, Term::Binary(sign @ (Multiply | Divide), b, c)) => {
            let [b, c] = [b, c].map(|part| apply(function, part));
            let sign = if *sign == Multiply { Add } else { Subtract };
            Some(Term::binary(sign, &b, &c))
        }
        (Function::Logarithm, Term::Power(b, n)) => {
            let size = match **n {
                Term::Number(2, 1) => apply(Function::Size, b),
                _ => Arc::clone(b),
            };
            Some(Term::binary(Multiply, n, &apply(function, &size)))
        }
        (Function::Sine, Term::Binary(Add, b, c)) => {
            let product = |f, g| Term::binary(Multiply, &apply(f, b), &apply(g, c));
            let one = product(Function::Sine, Function::Cosine);
            Some(Term::binary(
                Add,
                &one,
                &product(Function::Cosine, Function::Sine),
            ))
        }
        (Function::Cosine, Term::Binary(Add, b, c)) => {
            let product = |f| Term::binary(Multiply, &apply(f, b), &apply(f, c));
            let one = product(Function::Cosine);
            Some(Term::binary(Subtract, &one, &product(Function::Sine)))
        }
        (Function::Root, Term::Binary(Multiply, b, c)) if b == c => Some(apply(Function::Size, b)),
        (Function::Root, Term::Power(b, n)) if **n == Term::Number(2, 1) => {
            Some(apply(Function::Size, b))
        }
        (Function::Size, _) => {
            let square = Arc::new(Term::Power(Arc::clone(a), Term::int(2)));
            Some(apply(Function::Root, &square))
        }
        _ => None,
    }
}

fn summed(
    scene: &Scene,
    stream: &mut Stream,
    index: &str,
    [low, high, a]: [&Part; 3],
) -> Option<Part> {
    let sum = |low: &Part, high: &Part, a: &Part| {
        let (low, high) = (Arc::clone(low), Arc::clone(high));
        Arc::new(Term::Sum(index.to_owned(), low, high, Arc::clone(a)))
    };
    match (&**a, stream.below(3)) {
        (Term::Binary(Add, b, c), 0 | 1) => {
            Some(Term::binary(Add, &sum(low, high, b), &sum(low, high, c)))
        }
        (Term::Binary(Multiply, b, c), 0 | 1) if !mentions(scene, b, index) => {
            Some(Term::binary(Multiply, b, &sum(low, high, c)))
        }
        // The indices are counted from 1 more.
        (_, 2) => {
            let before = Term::binary(Subtract, &Term::name(index), &Term::int(1));
            let moved = substituted(scene, a, index, &before)?;
            let more = |end: &Part| Term::binary(Add, end, &Term::int(1));
            Some(sum(&more(low), &more(high), &moved))
        }
        // The first or the last term alone.
        _ => {
            let (Term::Number(first, 1), Term::Number(last, 1)) = (&**low, &**high) else {
                return None;
            };
            if last < first {
                return None;
            }
            let alone = substituted(scene, a, index, high)?;
            Some(Term::binary(
                Add,
                &sum(low, &Term::int(last - 1), a),
                &alone,
            ))
        }
    }
}

fn integrated(
    scene: &Scene,
    stream: &mut Stream,
    a: &Part,
    by: &str,
    [low, high]: [&Part; 2],
) -> Option<Part> {
    let integral = |a: &Part, low: &Part, high: &Part| {
        let (low, high) = (Arc::clone(low), Arc::clone(high));
        Arc::new(Term::Integral(Arc::clone(a), by.to_owned(), low, high))
    };
    match (&**a, stream.below(3)) {
        (Term::Binary(Add, b, c), 0 | 1) => Some(Term::binary(
            Add,
            &integral(b, low, high),
            &integral(c, low, high),
        )),
        (Term::Binary(Multiply, b, c), 0 | 1) if !mentions(scene, b, by) => {
            Some(Term::binary(Multiply, b, &integral(c, low, high)))
        }
        (Term::Rate(b, own, 1), 0 | 1) if own == by => {
            let at = |end: &Part| Arc::new(Term::At(Arc::clone(b), by.to_owned(), Arc::clone(end)));
            Some(Term::binary(Subtract, &at(high), &at(low)))
        }
        (_, 2) => Some(Term::minus(&integral(a, high, low))),
        _ => {
            let middle = Term::int(1);
            let (one, other) = (integral(a, low, &middle), integral(a, &middle, high));
            Some(Term::binary(Add, &one, &other))
        }
    }
}
