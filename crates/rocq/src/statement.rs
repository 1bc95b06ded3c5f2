//! Claims as propositions: all symbols bound, then their declared sets, the hypotheses, the definedness of all terms and
//! the conditions of the verdict as premises, then what is said.

use crate::along::{Along, functions};
use crate::code::{Code, Level};
use crate::context::Context;
use crate::defined::Premises;
use crate::gap::Gap;
use crate::integer::{affine, is_zero};
use crate::shape::Shape;
use crate::value::zero;
use std::sync::Arc;
use torse_language::core::{Claim, Family, FamilyProperty, Node, Printed, Set, Statement, Term};
use torse_language::derivation::declarations::{Bound, Constant, Interval};
use torse_language::syntax::{Connective, Relation};
use torse_numbers::rational;

/// A claim in Rocq.
#[derive(Debug, Clone)]
pub struct Proposition {
    /// The definitions that it needs, in order: names and texts.
    pub definitions: Vec<(String, String)>,
    /// The bound symbols, `(x : R)`, each with the coordinates it is made of.
    pub binders: Vec<Binder>,
    /// The premises, in order.
    pub premises: Vec<Code>,
    /// What is said.
    pub conclusion: Code,
    /// The numbers that the `given` equations determine.
    pub unknowns: Vec<String>,
    /// Whether coefficients occur of forms that are not seen to be linear.
    pub unclear_forms: bool,
    /// The unknowns as functions of symbols whose coefficients are asked for.
    pub alongs: Vec<Along>,
}

/// A symbol that is bound.
#[derive(Debug, Clone)]
pub struct Binder {
    /// The declared name.
    pub symbol: Arc<str>,
    /// The names that are bound, with their type; a vector is bound coordinate by coordinate.
    pub names: Vec<String>,
    /// The type of each.
    pub rocq_type: String,
    /// For a vector, the `let` that puts its coordinates together.
    pub together: Option<String>,
}

/// The proposition of a claim under conditions.
///
/// # Errors
/// [`Gap`] for what has no translation.
pub fn proposition(claim: &Claim, conditions: &[Statement]) -> Result<Proposition, Gap> {
    let mut context = Context::new(&claim.symbols).with_unknowns(&claim.unknowns);
    let mut binders = binders(&mut context)?;
    let mut premises = domain(&context)?;
    for hypothesis in &claim.hypotheses {
        premises.extend(defined(&mut context, [&hypothesis.statement])?);
        premises.push(said(&mut context, &hypothesis.statement, claim)?);
    }
    premises.extend(defined(&mut context, [&claim.statement])?);
    for condition in conditions {
        premises.extend(defined(&mut context, [condition])?);
        premises.push(said(&mut context, condition, claim)?);
    }
    let mut kept: Vec<Code> = vec![];
    for premise in premises {
        // What is assumed anyway needs not be assumed below a binder as well.
        let follows = |known: &Code| premise.text().ends_with(&format!(" -> {}", known.text()));
        if !kept.contains(&premise) && !kept.iter().any(follows) {
            kept.push(premise);
        }
    }
    let conclusion = said(&mut context, &claim.statement, claim)?;
    let functions = functions(&mut context, claim)?;
    binders.extend(functions.binders);
    kept.extend(functions.premises);
    for premise in kept.iter().chain([&conclusion]) {
        context.spend(premise.text().len())?;
    }
    let mut unknowns = vec![];
    for unknown in &claim.unknowns {
        unknowns.extend(numbers_of(&mut context, unknown, &binders)?);
    }
    let definitions = context.definitions().to_vec();
    Ok(Proposition {
        unclear_forms: context.unclear_forms(false),
        alongs: context.alongs().to_vec(),
        definitions,
        binders,
        premises: kept,
        conclusion,
        unknowns,
    })
}

impl Proposition {
    /// `forall (x : R) ..., premises -> conclusion`.
    #[must_use]
    pub fn universal(&self) -> String {
        let mut text = self.bound("forall");
        for premise in &self.premises {
            text.push_str(&format!("  {} ->\n", premise.below(Level::Open)));
        }
        text.push_str(&format!("  {}", self.conclusion.within(Level::Open)));
        text
    }

    /// `exists x ..., premises`: that the premises can be met. None if there are no premises.
    #[must_use]
    pub fn instance(&self) -> Option<String> {
        let (last, first) = self.premises.split_last()?;
        let mut text = self.bound("exists");
        for premise in first {
            text.push_str(&format!("  {} /\\\n", premise.below(Level::Both)));
        }
        text.push_str(&format!("  {}", last.below(Level::Both)));
        Some(text)
    }

    /// The bound symbols under a quantifier.
    fn bound(&self, quantifier: &str) -> String {
        let group =
            |binder: &Binder| format!(" ({} : {})", binder.names.join(" "), binder.rocq_type);
        let groups: String = self.binders.iter().map(group).collect();
        let mut text = match groups.is_empty() {
            true => String::new(),
            false => format!("{quantifier}{groups},\n"),
        };
        for together in self
            .binders
            .iter()
            .filter_map(|binder| binder.together.as_ref())
        {
            text.push_str(&format!("  {together}\n"));
        }
        text
    }
}

/// The numbers that an unknown is made of, coordinate by coordinate.
fn numbers_of(
    context: &mut Context<'_>,
    unknown: &Term,
    binders: &[Binder],
) -> Result<Vec<String>, Gap> {
    let (name, indices) = match &*unknown.node {
        Node::Vector(name, Some(_)) => (name, vec![]),
        Node::Member(points, indices) if points.dimension.is_some_and(|n| n > 1) => {
            let indices = indices.iter().map(|index| context.index(index));
            (&points.name, indices.collect::<Result<Vec<_>, _>>()?)
        }
        _ => return Ok(vec![context.value(unknown)?.code.argument()]),
    };
    let binder = binders.iter().find(|binder| binder.symbol == *name);
    let names = binder.map_or(&[][..], |binder| binder.names.as_slice());
    Ok(names
        .iter()
        .map(|name| Code::apply(name, &indices).argument())
        .collect())
}

/// The symbols, integers first: the index ranges of families name them.
fn binders(context: &mut Context<'_>) -> Result<Vec<Binder>, Gap> {
    let symbols = context.symbols;
    let is_integer = |set: &Set| matches!(set, Set::Integer { .. });
    let integers = symbols.iter().filter(|(_, set)| is_integer(set));
    let others = symbols.iter().filter(|(_, set)| !is_integer(set));
    let mut binders = vec![];
    for (symbol, set) in integers.chain(others) {
        let name = context.symbol(symbol)?.to_owned();
        let symbol = Arc::clone(symbol);
        let coordinates = match set {
            Set::Vector(Some(n)) => Some((*n, 0)),
            Set::Family {
                dimension: Some(n @ 2..),
                ranges,
            } => Some((*n, ranges.len().max(1))),
            _ => None,
        };
        let Some((n, indices)) = coordinates else {
            let rocq_type = context.symbol_type(&symbol)?;
            binders.push(Binder {
                symbol,
                names: vec![name],
                rocq_type,
                together: None,
            });
            continue;
        };
        let names: Vec<String> = (1..=n)
            .map(|i| context.fresh(&format!("{name}'{i}")))
            .collect();
        let arguments: String = (0..indices).map(|i| format!(" i{i}")).collect();
        let entries: Vec<String> = names
            .iter()
            .map(|name| format!("{name}{arguments}"))
            .collect();
        let function = match indices {
            0 => String::new(),
            _ => format!("fun{arguments} => "),
        };
        binders.push(Binder {
            symbol,
            together: Some(format!(
                "let {name} := {function}[{}] in",
                entries.join("; ")
            )),
            names,
            rocq_type: format!("{}R", "Z -> ".repeat(indices)),
        });
    }
    Ok(binders)
}

/// The declared sets.
fn domain(context: &Context<'_>) -> Result<Vec<Code>, Gap> {
    let mut premises = vec![];
    for (symbol, set) in context.symbols {
        let name = context.symbol(symbol)?;
        match set {
            Set::Real(interval) => premises.extend(within(name, interval)),
            Set::Integer { least, most } => {
                let least = least
                    .as_ref()
                    .map(|form| affine(context, form))
                    .transpose()?;
                let most = most
                    .as_ref()
                    .map(|form| affine(context, form))
                    .transpose()?;
                let text = match (least, most) {
                    (Some(least), Some(most)) => format!("({least} <= {name} <= {most})%Z"),
                    (Some(least), None) => format!("({least} <= {name})%Z"),
                    (None, Some(most)) => format!("({name} <= {most})%Z"),
                    (None, None) => continue,
                };
                premises.push(Code::atom(text));
            }
            Set::Vector(_) | Set::Family { .. } => {}
        }
    }
    Ok(premises)
}

/// That a number is in an interval, if the interval has an end.
fn within(name: &str, interval: &Interval) -> Option<Code> {
    let sign = |bound: &Bound| if bound.closed { "<=" } else { "<" };
    let end = |bound: &Bound| constant(&bound.value);
    let text = match (&interval.lower, &interval.upper) {
        (Some(low), Some(high)) => {
            format!(
                "{} {} {name} {} {}",
                end(low),
                sign(low),
                sign(high),
                end(high)
            )
        }
        (Some(low), None) => format!("{} {} {name}", end(low), sign(low)),
        (None, Some(high)) => format!("{name} {} {}", sign(high), end(high)),
        (None, None) => return None,
    };
    Some(Code::new(text, Level::Relation))
}

/// A number with a multiple of pi.
fn constant(value: &Constant) -> String {
    let zero = rational::integer(0);
    let rational = Code::rational(&value.rational);
    if value.turns == zero {
        return rational.within(Level::Sum);
    }
    let turns = Code::infix(
        &Code::rational(&value.turns),
        "*",
        &Code::atom("PI"),
        Level::Product,
    );
    match value.rational == zero {
        true => turns.within(Level::Sum),
        false => Code::infix(&rational, "+", &turns, Level::Sum).within(Level::Sum),
    }
}

/// The premises under which the terms of statements have values; what stands in a denial has its own.
pub(crate) fn defined<'s>(
    context: &mut Context<'_>,
    statements: impl IntoIterator<Item = &'s Statement>,
) -> Result<Vec<Code>, Gap> {
    let mut premises = Premises::default();
    for statement in statements {
        for term in outside_of_denials(statement) {
            context.defined(term, &mut premises)?;
        }
    }
    Ok(premises.into_vec())
}

/// The terms of a statement that are not in a denial.
fn outside_of_denials(statement: &Statement) -> Vec<&Term> {
    match statement {
        Statement::Not(_) => vec![],
        Statement::Join(_, a, b) => [outside_of_denials(a), outside_of_denials(b)].concat(),
        _ => statement.terms(),
    }
}

/// The parts of a conjunction, in the order of the text.
fn conjuncts(statement: &Statement) -> Vec<&Statement> {
    match statement {
        Statement::Join(Connective::And, a, b) => [conjuncts(a), conjuncts(b)].concat(),
        _ => vec![statement],
    }
}

/// What a statement says.
pub(crate) fn said(
    context: &mut Context<'_>,
    statement: &Statement,
    claim: &Claim,
) -> Result<Code, Gap> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => compared(context, *relation, left, right),
        Statement::Agrees { value, printed, .. } => agrees(context, value, printed),
        Statement::Family(property, family) => property_of(context, *property, family),
        Statement::Join(Connective::And, a, b) => {
            // `and` is written without brackets, whichever way it was read.
            let mut parts = vec![];
            for part in [a, b].into_iter().flat_map(|part| conjuncts(part)) {
                parts.push(said(context, part, claim)?);
            }
            let last = parts.pop().ok_or(Gap::Construct("an empty conjunction"))?;
            Ok(parts.iter().rfold(last, |rest, part| {
                Code::infix_right(part, "/\\", &rest, Level::Both)
            }))
        }
        Statement::Join(connective, a, b) => {
            let (a, b) = (said(context, a, claim)?, said(context, b, claim)?);
            Ok(match connective {
                Connective::And | Connective::Or => Code::infix_right(&a, "\\/", &b, Level::Either),
                Connective::Implies => {
                    let text = format!("{} -> {}", a.below(Level::Open), b.within(Level::Open));
                    Code::new(text, Level::Open)
                }
            })
        }
        Statement::Not(inner) => {
            // A denial is about the whole domain: the same claim with the inner statement, denied. Among the hypotheses
            // it would be about the domain that it makes.
            if claim.hypotheses.iter().any(|h| has_denial(&h.statement)) {
                return Err(Gap::Construct("a denial among the hypotheses"));
            }
            let inner = Claim {
                statement: (**inner).clone(),
                ..claim.clone()
            };
            let mut premises = domain(context)?;
            for hypothesis in &inner.hypotheses {
                premises.extend(defined(context, [&hypothesis.statement])?);
                premises.push(said(context, &hypothesis.statement, &inner)?);
            }
            premises.extend(defined(context, [&inner.statement])?);
            let (alongs, unclear) = (context.alongs().len(), context.unclear_forms(false));
            let conclusion = said(context, &inner.statement, &inner)?;
            if context.alongs().len() > alongs {
                return Err(Gap::Theory("denials of coefficients along given equations"));
            }
            if context.unclear_forms(unclear) {
                return Err(Gap::Theory(
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

/// Whether anything is denied in the statement.
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
) -> Result<Code, Gap> {
    let (x, y) = (context.value(left)?, context.value(right)?);
    let (a, b) = match (x.shape, y.shape) {
        (a, b) if a == b => (x.code, y.code),
        (shape, Shape::Number) if is_zero(right) => (x.code, zero(shape)),
        (Shape::Number, shape) if is_zero(left) => (zero(shape), y.code),
        (a, b) => return Err(Gap::Shapes(format!("{a} compared with {b}"))),
    };
    let order = !matches!(relation, Relation::Equal | Relation::Different);
    if order && x.shape != Shape::Number {
        return Err(Gap::Shapes("an order of vectors".to_owned()));
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

/// Printed decimals, entry by entry. A number without a point is read with as many digits as the decimal that has the
/// fewest; where there are none it is exact.
fn agrees(context: &mut Context<'_>, value: &Term, printed: &[Printed]) -> Result<Code, Gap> {
    let value = context.value(value)?;
    let entries: Vec<Code> = match value.shape {
        Shape::Number => vec![value.code],
        Shape::Vector(n) => {
            let entry =
                |i: usize| Code::apply("entry", &[value.code.clone(), Code::atom(i.to_string())]);
            (1..=n).map(entry).collect()
        }
        Shape::Matrix(..) => return Err(Gap::Construct("printed decimals of a matrix")),
    };
    if entries.len() != printed.len() {
        return Err(Gap::Shapes(
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
    all.ok_or(Gap::Construct("an empty list of printed numbers"))
}

/// A property of a basis at every degree. The symbols of the names of its variables are bound outside.
fn property_of(
    context: &mut Context<'_>,
    property: FamilyProperty,
    family: &Arc<Family>,
) -> Result<Code, Gap> {
    if family.counters.is_some() {
        return Err(Gap::Construct(
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
            return Err(Gap::Theory("total positivity and variation diminution"));
        }
    };
    Ok(Code::new(text, Level::Open))
}
