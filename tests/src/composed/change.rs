//! Substitution and differentiation of terms as texts: what is true by construction is true by these.

use super::scene::Scene;
use super::term::{Function, Operation, Part, Term};
use std::sync::Arc;

/// The names that a part may not mention if something is put into it under this binder.
fn binder(term: &Term, place: usize) -> Option<&String> {
    match (term, place) {
        (Term::Sum(index, ..) | Term::Product(index, ..), 2) => Some(index),
        (Term::Rate(_, by, _) | Term::At(_, by, _) | Term::Integral(_, by, ..), 0) => Some(by),
        _ => None,
    }
}

/// Whether a name occurs free in the term, through definitions and left-out arguments too.
#[must_use]
pub fn mentions(scene: &Scene, term: &Term, name: &str) -> bool {
    if let Term::Rate(_, by, _) = term
        && by == name
    {
        return true;
    }
    let parts = term.parts();
    let mut inside = parts
        .iter()
        .enumerate()
        .filter(|(place, _)| binder(term, *place).is_none_or(|by| by != name));
    if inside.any(|(_, part)| mentions(scene, part, name)) {
        return true;
    }
    match term {
        Term::Name(own) => own == name || defined(scene, own, name),
        Term::Defined(own, _) => defined(scene, own, name),
        Term::Basis(own, _, _, given) => scene.basis(own).is_none_or(|family| {
            let bound = |n: &str| family.variables.iter().any(|v| v == n);
            let left_out = family.variables.iter().skip(given.len());
            let body = family.seeds.iter().chain(&family.step);
            left_out.into_iter().any(|v| v == name)
                || !bound(name) && body.into_iter().any(|part| mentions(scene, part, name))
        }),
        _ => false,
    }
}

fn defined(scene: &Scene, definition: &str, name: &str) -> bool {
    scene
        .definition(definition)
        .is_some_and(|d| !d.parameters.iter().any(|p| p == name) && mentions(scene, &d.body, name))
}

/// Whether the term sees the name only where it is written: not through a definition or a basis.
fn plainly(scene: &Scene, term: &Term, name: &str) -> bool {
    let hidden = match term {
        Term::Defined(own, _) => defined(scene, own, name),
        Term::Name(own) => own != name && defined(scene, own, name),
        Term::Basis(own, index, degree, given) => {
            let bare = Term::Basis(
                own.clone(),
                Arc::clone(index),
                Arc::clone(degree),
                given.clone(),
            );
            let without = bare.with_parts(|_, _| Term::int(0));
            mentions(scene, &without, name)
        }
        _ => false,
    };
    !hidden && term.parts().iter().all(|part| plainly(scene, part, name))
}

/// The term with a value for a name; nothing where a binder would catch a name of the value, or where the name is seen
/// through a definition.
#[must_use]
pub fn substituted(scene: &Scene, term: &Part, name: &str, value: &Part) -> Option<Part> {
    if !mentions(scene, term, name) {
        return Some(Arc::clone(term));
    }
    if !plainly(scene, term, name) {
        return None;
    }
    match &**term {
        Term::Name(_) => return Some(Arc::clone(value)),
        // The point of a derivative is the value of its variable outside.
        Term::Rate(body, by, order) if by == name => {
            let rate = Term::Rate(Arc::clone(body), by.clone(), *order);
            return Some(Arc::new(Term::At(
                Arc::new(rate),
                by.clone(),
                Arc::clone(value),
            )));
        }
        _ => {}
    }
    let mut fits = true;
    let changed = term.with_parts(|place, part| {
        match binder(term, place) {
            Some(by) if by == name => return Arc::clone(part),
            Some(by) if mentions(scene, value, by) && mentions(scene, part, name) => fits = false,
            _ => {}
        }
        let put = substituted(scene, part, name, value);
        fits &= put.is_some();
        put.unwrap_or_else(|| Arc::clone(part))
    });
    fits.then(|| Arc::new(changed))
}

/// The body of a definition with these arguments.
#[must_use]
pub fn unfolded(scene: &Scene, name: &str, arguments: &[Part]) -> Option<Part> {
    let definition = scene.definition(name)?;
    let mut body = Arc::clone(&definition.body);
    // Arguments that mention parameters would be put into one another.
    for argument in arguments {
        if definition.parameters.len() > 1
            && definition
                .parameters
                .iter()
                .any(|p| mentions(scene, argument, p))
        {
            return None;
        }
    }
    for (parameter, argument) in definition.parameters.iter().zip(arguments) {
        body = substituted(scene, &body, parameter, argument)?;
    }
    Some(body)
}

/// The derivative of a term by a name, written out.
#[must_use]
pub fn derivative(scene: &Scene, term: &Part, by: &str) -> Option<Part> {
    let rate = |part: &Part| derivative(scene, part, by);
    let times = Term::times;
    if !mentions(scene, term, by) {
        return Some(Term::int(0));
    }
    Some(match &**term {
        Term::Number(..) | Term::Member(..) => Term::int(0),
        Term::Name(name) if name == by => Term::int(1),
        Term::Name(name) => rate(&unfolded(scene, name, &[])?)?,
        Term::Negative(a) => Term::minus(&rate(a)?),
        Term::Binary(operation, a, b) => match operation {
            Operation::Add => Term::plus(&rate(a)?, &rate(b)?),
            Operation::Subtract => Term::binary(Operation::Subtract, &rate(a)?, &rate(b)?),
            Operation::Multiply => Term::plus(&times(&rate(a)?, b), &times(a, &rate(b)?)),
            Operation::Divide => {
                let above = Term::binary(
                    Operation::Subtract,
                    &times(&rate(a)?, b),
                    &times(a, &rate(b)?),
                );
                let below = Arc::new(Term::Power(Arc::clone(b), Term::int(2)));
                Term::binary(Operation::Divide, &above, &below)
            }
            Operation::Least | Operation::Greatest => return None,
        },
        Term::Power(a, n) => {
            let less = match &**n {
                Term::Number(n, 1) => Term::int(n - 1),
                _ if mentions(scene, n, by) => return None,
                _ => Term::binary(Operation::Subtract, n, &Term::int(1)),
            };
            let power = Arc::new(Term::Power(Arc::clone(a), less));
            times(&times(n, &power), &rate(a)?)
        }
        Term::Apply(function, a) => {
            let applied = |f| Arc::new(Term::Apply(f, Arc::clone(a)));
            let outer = match function {
                Function::Sine => applied(Function::Cosine),
                Function::Cosine => Term::minus(&applied(Function::Sine)),
                Function::Exponential => Arc::clone(term),
                Function::Logarithm => Term::binary(Operation::Divide, &Term::int(1), a),
                Function::Root => {
                    let below = times(&Term::int(2), term);
                    Term::binary(Operation::Divide, &Term::int(1), &below)
                }
                Function::Size => return None,
            };
            times(&outer, &rate(a)?)
        }
        Term::Smooth(name, order, a) => {
            let outer = Arc::new(Term::Smooth(name.clone(), order + 1, Arc::clone(a)));
            times(&outer, &rate(a)?)
        }
        Term::Rate(a, own, order) if own == by => {
            Arc::new(Term::Rate(Arc::clone(a), own.clone(), order + 1))
        }
        Term::Rate(a, own, order) => Arc::new(Term::Rate(rate(a)?, own.clone(), *order)),
        Term::At(a, own, value) => {
            let at = |part: Part| Arc::new(Term::At(part, own.clone(), Arc::clone(value)));
            let inner = at(Arc::new(Term::Rate(Arc::clone(a), own.clone(), 1)));
            let through = times(&inner, &rate(value)?);
            match own == by {
                true => through,
                false => Term::plus(&at(rate(a)?), &through),
            }
        }
        Term::Sum(index, low, high, a) => {
            if mentions(scene, low, by) || mentions(scene, high, by) || index == by {
                return None;
            }
            let (low, high) = (Arc::clone(low), Arc::clone(high));
            Arc::new(Term::Sum(index.clone(), low, high, rate(a)?))
        }
        Term::Integral(a, own, low, high) => {
            let at = |end: &Part| Arc::new(Term::At(Arc::clone(a), own.clone(), Arc::clone(end)));
            let upper = times(&at(high), &rate(high)?);
            let lower = times(&at(low), &rate(low)?);
            let ends = Term::plus(&upper, &Term::minus(&lower));
            if own == by {
                return Some(ends);
            }
            let (low, high) = (Arc::clone(low), Arc::clone(high));
            let inner = Arc::new(Term::Integral(rate(a)?, own.clone(), low, high));
            Term::plus(&inner, &ends)
        }
        Term::Defined(name, arguments) => rate(&unfolded(scene, name, arguments)?)?,
        Term::Product(..) | Term::Basis(..) => {
            Arc::new(Term::Rate(Arc::clone(term), by.to_owned(), 1))
        }
    })
}
