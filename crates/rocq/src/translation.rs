//! Translates hypotheses and statements to propositions.

use crate::code::{Code, Level};
use crate::context::Context;
use crate::defined::Premises;
use crate::domain::{binders, domain};
use crate::gap::Untranslatable;
use crate::integer::is_zero;
use crate::interval::within;
use crate::proposition::Proposition;
use crate::shape::Shape;
use crate::value::zero;
use std::sync::Arc;
use torse_core::{Claim, Family, FamilyProperty, Printed, Set, Statement, Term};
use torse_syntax::formula::{Connective, Relation};

/// Adds the premises under which the terms of statements have values; terms in a denial have their own.
pub(crate) fn defined<'s>(
    context: &mut Context<'_>,
    statements: impl IntoIterator<Item = &'s Statement>,
) -> Result<Vec<Code>, Untranslatable> {
    let mut premises = Premises::default();
    for statement in statements {
        for term in outside_of_denials(statement) {
            context.defined(term, &mut premises)?;
        }
    }
    Ok(premises.into_vec())
}

/// Returns the terms of a statement outside denials.
fn outside_of_denials(statement: &Statement) -> Vec<&Term> {
    match statement {
        Statement::Not(_) => vec![],
        Statement::Join(_, a, b) => [outside_of_denials(a), outside_of_denials(b)].concat(),
        _ => statement.terms(),
    }
}

/// Returns the parts of a conjunction, in the order of the text.
fn conjuncts(statement: &Statement) -> Vec<&Statement> {
    match statement {
        Statement::Join(Connective::And, a, b) => [conjuncts(a), conjuncts(b)].concat(),
        _ => vec![statement],
    }
}

/// Translates a statement.
pub(crate) fn translate_statement(
    context: &mut Context<'_>,
    statement: &Statement,
    claim: &Claim,
) -> Result<Code, Untranslatable> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => compared(context, *relation, left, right),
        Statement::Agrees { value, printed, .. } => agrees(context, value, printed),
        Statement::Family(property, family) => property_of(context, *property, family),
        Statement::Join(Connective::And, a, b) => {
            // `and` is written without brackets, however it was grouped.
            let mut parts = vec![];
            for part in [a, b].into_iter().flat_map(|part| conjuncts(part)) {
                parts.push(translate_statement(context, part, claim)?);
            }
            let last = parts
                .pop()
                .ok_or(Untranslatable::Construct("an empty conjunction"))?;
            Ok(parts.iter().rfold(last, |rest, part| {
                Code::infix_right(part, "/\\", &rest, Level::Both)
            }))
        }
        Statement::Join(connective, a, b) => {
            let (a, b) = (
                translate_statement(context, a, claim)?,
                translate_statement(context, b, claim)?,
            );
            Ok(match connective {
                Connective::And | Connective::Or => Code::infix_right(&a, "\\/", &b, Level::Either),
                Connective::Implies => {
                    let text = format!("{} -> {}", a.below(Level::Open), b.within(Level::Open));
                    Code::new(text, Level::Open)
                }
            })
        }
        Statement::Not(inner) => {
            // A denial is about the whole domain: it is the same claim with the inner statement, denied. Among the
            // hypotheses it would be about the domain that it defines.
            if claim.hypotheses.iter().any(|h| has_denial(&h.statement)) {
                return Err(Untranslatable::Construct("a denial among the hypotheses"));
            }
            let inner = Claim {
                statement: (**inner).clone(),
                ..claim.clone()
            };
            let mut premises = domain(context)?;
            for hypothesis in &inner.hypotheses {
                premises.extend(defined(context, [&hypothesis.statement])?);
                premises.push(translate_statement(context, &hypothesis.statement, &inner)?);
            }
            premises.extend(defined(context, [&inner.statement])?);
            let (alongs, unclear) = (context.alongs().len(), context.unclear_forms(false));
            let conclusion = translate_statement(context, &inner.statement, &inner)?;
            if context.alongs().len() > alongs {
                return Err(Untranslatable::Theory(
                    "denials of coefficients along given equations",
                ));
            }
            if context.unclear_forms(unclear) {
                return Err(Untranslatable::Theory(
                    "denials of coefficients of forms that are not plainly linear",
                ));
            }
            let whole = Proposition {
                definitions: vec![],
                binders: binders(context)?,
                premises,
                conclusion,
                unknowns: vec![],
                unclear_forms: false,
                alongs: vec![],
            };
            Ok(Code::new(
                format!("~ ({})", whole.universal()),
                Level::Relation,
            ))
        }
    }
}

/// Whether the statement contains a denial.
fn has_denial(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) => true,
        Statement::Join(_, a, b) => has_denial(a) || has_denial(b),
        Statement::Compare { .. } | Statement::Agrees { .. } | Statement::Family(..) => false,
    }
}

fn compared(
    context: &mut Context<'_>,
    relation: Relation,
    left: &Term,
    right: &Term,
) -> Result<Code, Untranslatable> {
    let (x, y) = (context.value(left)?, context.value(right)?);
    let (a, b) = match (x.shape, y.shape) {
        (a, b) if a == b => (x.code, y.code),
        (shape, Shape::Number) if is_zero(right) => (x.code, zero(shape)),
        (Shape::Number, shape) if is_zero(left) => (zero(shape), y.code),
        (a, b) => return Err(Untranslatable::Shapes(format!("{a} compared with {b}"))),
    };
    let order = !matches!(relation, Relation::Equal | Relation::Different);
    if order && x.shape != Shape::Number {
        return Err(Untranslatable::Shapes("an order of vectors".to_owned()));
    }
    let sign = match relation {
        Relation::Equal => "=",
        Relation::Different => "<>",
        Relation::Less => "<",
        Relation::AtMost => "<=",
        Relation::Greater => ">",
        Relation::AtLeast => ">=",
    };
    Ok(Code::infix(
        &Code::atom(a.within(Level::Sum)),
        sign,
        &b,
        Level::Relation,
    ))
}

/// Translates printed decimals, entry by entry. A number without a point is read with as many digits as the decimal
/// with the fewest; if there are none it is exact.
fn agrees(
    context: &mut Context<'_>,
    value: &Term,
    printed: &[Printed],
) -> Result<Code, Untranslatable> {
    let value = context.value(value)?;
    let entries: Vec<Code> = match value.shape {
        Shape::Number => vec![value.code],
        Shape::Vector(n) => {
            let entry =
                |i: usize| Code::apply("entry", &[value.code.clone(), Code::atom(i.to_string())]);
            (1..=n).map(entry).collect()
        }
        Shape::Matrix(..) => return Err(Untranslatable::Construct("printed decimals of a matrix")),
    };
    if entries.len() != printed.len() {
        return Err(Untranslatable::Shapes(
            "as many printed numbers as entries are wanted".to_owned(),
        ));
    }
    let fewest = printed
        .iter()
        .filter_map(|p| p.decimals.filter(|d| *d > 0))
        .min();
    let mut all: Option<Code> = None;
    for (entry, printed) in entries.iter().zip(printed) {
        let number = Code::rational(&printed.value);
        let digits = printed.decimals.filter(|d| *d > 0).or(fewest);
        let one = match digits {
            None => Code::infix(
                &Code::atom(entry.within(Level::Sum)),
                "=",
                &number,
                Level::Relation,
            ),
            Some(digits) => {
                let head = if printed.negative {
                    "agrees_down"
                } else {
                    "agrees_up"
                };
                Code::apply(
                    head,
                    &[entry.clone(), number, Code::atom(digits.to_string())],
                )
            }
        };
        all = Some(match all {
            None => one,
            Some(before) => Code::infix_right(&before, "/\\", &one, Level::Both),
        });
    }
    all.ok_or(Untranslatable::Construct(
        "an empty list of printed numbers",
    ))
}

/// Translates a property of a basis at every degree. The symbols of the names of its variables are bound outside.
fn property_of(
    context: &mut Context<'_>,
    property: FamilyProperty,
    family: &Arc<Family>,
) -> Result<Code, Untranslatable> {
    if family.counters.is_some() {
        return Err(Untranslatable::Construct(
            "a property of a basis whose step depends on the index",
        ));
    }
    let (name, mut arguments) = context.family(family)?;
    for variable in &family.variables {
        let symbol = context.symbol(&Arc::from(variable.name()))?;
        arguments.push(Code::atom(symbol));
    }
    let (i, k, c) = (context.fresh("i"), context.fresh("k"), context.fresh("c"));
    arguments.extend([Code::atom(&i), Code::atom(&k)]);
    let function = Code::apply(&name, &arguments);
    let lowest = family.degree;
    let text = match property {
        FamilyProperty::Nonnegative => {
            format!(
                "forall {i} {k} : Z, ({lowest} <= {k})%Z -> 0 <= {}",
                function.text()
            )
        }
        FamilyProperty::Independent => {
            let x: Arc<str> = Arc::from(family.variable());
            let variable = context.symbol(&x)?.to_owned();
            let inside = match context.symbols.get(&x) {
                Some(Set::Real(interval)) => within(&variable, interval),
                _ => None,
            };
            let inside = inside.map_or(String::new(), |code| format!("{} -> ", code.text()));
            format!(
                "forall ({k} : Z) ({c} : Z -> R), ({lowest} <= {k})%Z -> \
                 (forall {variable} : R, {inside}sum 0 {k} (fun {i} => {c} {i} * {}) = 0) -> \
                 forall {i} : Z, (0 <= {i} <= {k})%Z -> {c} {i} = 0",
                function.argument()
            )
        }
        FamilyProperty::VariationDiminishing(_) => {
            return Err(Untranslatable::Theory(
                "total positivity and variation diminution",
            ));
        }
    };
    Ok(Code::new(text, Level::Open))
}
