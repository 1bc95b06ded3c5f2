//! A claim as a proposition: all symbols bound, then smoothness, the declared sets, the hypotheses, the definedness of
//! all terms and the conditions of the verdict as premises, then what is said.

use super::premises::Premises;
use super::reach::{Bound, Names, Reach};
use super::scope::{Scope, words};
use super::translation::{Domain, all_of};
use super::writer::{Writer, fresh};
use crate::binder::Binder;
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::interval::within;
use crate::proposition::Proposition;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::Expr;

/// What a claim is about: its symbols, and what is assumed of them.
struct Subject<'c> {
    declarations: &'c Declarations,
    /// The declared symbols and functions, but for those that are sought.
    symbols: BTreeSet<String>,
    /// `assume`, then `given`, then what the ends of declared intervals say that are formulas.
    hypotheses: Vec<Expr>,
    /// All that occurs.
    reach: Reach,
}

/// The proposition of a claim that says this under these conditions.
///
/// # Errors
/// [`Untranslatable`] for what has no translation.
pub fn sentence(
    claim: &Claim,
    statement: &Expr,
    conditions: &[Expr],
) -> Result<Proposition, Untranslatable> {
    let subject = Subject::new(claim, statement, conditions);
    let writer = &mut Writer::new(&claim.declarations, &subject.reach);
    writer.unknowns = claim.unknowns.iter().map(|w| w.expr.clone()).collect();
    let scope = Scope::default();
    let mut binders = subject.binders(writer)?;
    let mut premises = subject.premises(writer)?;
    let existentials: Vec<&str> = claim.existentials.iter().map(|s| s.name.as_str()).collect();
    let mut needed = Premises::default();
    writer.statement_defined(statement, &scope, &mut needed)?;
    let (of_existentials, of_others): (Vec<Code>, Vec<Code>) =
        needed.into_vec().into_iter().partition(|premise| {
            let mut names = existentials
                .iter()
                .filter_map(|name| writer.symbol(name).ok());
            names.any(|name| words(premise.text()).any(|word| word == name))
        });
    premises.extend(of_others);
    for condition in conditions {
        let mut needed = Premises::default();
        writer.statement_defined(condition, &scope, &mut needed)?;
        premises.extend(needed.into_vec());
        premises.push(writer.translate_statement(condition, &scope, None)?);
    }
    let denied =
        |writer: &mut Writer<'_>, inner: &Expr, scope: &Scope| subject.denied(writer, inner, scope);
    let domain = Domain { denied: &denied };
    let stated = writer.translate_statement(statement, &scope, Some(&domain))?;
    let conclusion = match existentials.as_slice() {
        [] => stated,
        _ => there_are(writer, claim, &existentials, of_existentials, stated)?,
    };
    let mut kept = unrepeated(premises);
    let given: Vec<Expr> = claim.given.iter().map(|h| h.formula.expr.clone()).collect();
    let (functions, solutions) = writer.along_functions(&given)?;
    binders.extend(functions);
    kept.extend(solutions);
    for code in kept.iter().chain([&conclusion]) {
        writer.spend(code.text().len())?;
    }
    Ok(Proposition {
        definitions: writer.definitions.clone(),
        binders,
        premises: kept,
        conclusion,
        unknowns: vec![],
        unclear_forms: false,
        alongs: vec![],
    })
}

/// What is assumed anyway needs not be assumed again, nor below a binder.
fn unrepeated(premises: Vec<Code>) -> Vec<Code> {
    let mut kept: Vec<Code> = vec![];
    for premise in premises {
        // A name that is bound means something else outside.
        let bound: Vec<String> = premise
            .text()
            .split("forall ")
            .skip(1)
            .filter_map(|rest| words(rest).next())
            .collect();
        let follows = |known: &Code| {
            premise.text().ends_with(&format!(" -> {}", known.text()))
                && !words(known.text()).any(|word| bound.contains(&word))
        };
        if !kept.contains(&premise) && !kept.iter().any(follows) {
            kept.push(premise);
        }
    }
    kept
}

/// That there are numbers in their sets for which all that depends on them has a value and something is true.
fn there_are(
    writer: &Writer<'_>,
    claim: &Claim,
    existentials: &[&str],
    needed: Vec<Code>,
    stated: Code,
) -> Result<Code, Untranslatable> {
    let mut parts = vec![];
    let mut bound = String::new();
    for name in existentials {
        let own = writer.symbol(name)?;
        bound.push_str(&format!(" ({own} : R)"));
        if let Some(SymbolKind::Real(interval)) = claim.declarations.symbol(name) {
            parts.extend(within(own, interval));
            if interval.formulas().next().is_some() {
                return Err(Untranslatable::Construct(
                    "a sought number between formulas",
                ));
            }
        }
    }
    parts.extend(needed);
    parts.push(stated);
    let text = format!("exists{bound}, {}", all_of(parts)?.within(Level::Open));
    Ok(Code::new(text, Level::Open))
}

impl<'c> Subject<'c> {
    fn new(claim: &'c Claim, statement: &Expr, conditions: &[Expr]) -> Self {
        let declarations: &Declarations = &claim.declarations;
        let names = Names::new(declarations);
        let mut reach = Reach::default();
        let given = claim.assumptions.iter().chain(&claim.given);
        let mut hypotheses: Vec<Expr> = given.map(|h| h.formula.expr.clone()).collect();
        let unknowns = claim.unknowns.iter().map(|w| &w.expr);
        let all = hypotheses.iter().chain(unknowns).chain([statement]);
        for expr in all.chain(conditions) {
            reach.extend(&names.reach(expr, &Bound::new()));
        }
        let is_existential = |name: &String| claim.existentials.iter().any(|s| s.name == *name);
        // Sets are declared in terms of symbols whose sets are declared in terms of others again.
        let mut bounded = BTreeSet::new();
        let symbols = loop {
            let symbols = with_sets(declarations, &reach.symbols);
            let with_formulas = symbols
                .iter()
                .find_map(|name| match declarations.symbol(name) {
                    Some(SymbolKind::Real(interval))
                        if interval.formulas().next().is_some()
                            && !bounded.contains(name)
                            && !is_existential(name) =>
                    {
                        Some((name.clone(), interval.relations(name)))
                    }
                    _ => None,
                });
            let Some((name, relations)) = with_formulas else {
                break symbols;
            };
            for relation in relations {
                reach.extend(&names.reach(&relation.expr, &Bound::new()));
                hypotheses.push(relation.expr);
            }
            bounded.insert(name);
        };
        reach.symbols.extend(symbols.iter().cloned());
        Self {
            declarations,
            symbols: symbols
                .into_iter()
                .filter(|name| !is_existential(name))
                .collect(),
            hypotheses,
            reach,
        }
    }

    /// The symbols: functions, then integers, which index ranges name, then all others.
    fn binders(&self, writer: &Writer<'_>) -> Result<Vec<Binder>, Untranslatable> {
        let order = |name: &&String| match self.declarations.symbol(name) {
            None => 0,
            Some(SymbolKind::Integer { .. }) => 1,
            Some(_) => 2,
        };
        let mut sorted: Vec<&String> = self.symbols.iter().collect();
        sorted.sort_by_key(order);
        let mut taken: BTreeSet<String> = writer.all_symbols();
        let mut binders = vec![];
        for name in sorted {
            let rocq_type = writer.symbol_type(name)?;
            let own = writer.symbol(name)?.to_owned();
            let symbol: Arc<str> = Arc::from(name.as_str());
            let Some(coordinates) = coordinates(self.declarations, name) else {
                binders.push(Binder {
                    symbol,
                    names: vec![own],
                    rocq_type,
                    together: None,
                });
                continue;
            };
            let arguments: Vec<String> = match self.declarations.symbol(name) {
                None => vec!["t".to_owned()],
                Some(SymbolKind::Family { ranges, .. }) => {
                    (0..ranges.len().max(1)).map(|i| format!("i{i}")).collect()
                }
                Some(_) => vec![],
            };
            let named = |i: u8| {
                let name = fresh(&format!("{own}'{i}"), &taken);
                taken.insert(name.clone());
                name
            };
            let names: Vec<String> = (1..=coordinates).map(named).collect();
            let entry = |name: &String| {
                let arguments = arguments.iter().map(|a| format!(" {a}"));
                format!("{name}{}", arguments.collect::<String>())
            };
            let entries: Vec<String> = names.iter().map(entry).collect();
            let function = match arguments.is_empty() {
                true => String::new(),
                false => format!("fun {} => ", arguments.join(" ")),
            };
            binders.push(Binder {
                symbol,
                together: Some(format!(
                    "let {own} := {function}[{}] in",
                    entries.join("; ")
                )),
                names,
                rocq_type: rocq_type.replace("list R", "R"),
            });
        }
        Ok(binders)
    }

    /// What is assumed: smoothness, sets, hypotheses with their definedness.
    fn premises(&self, writer: &mut Writer<'_>) -> Result<Vec<Code>, Untranslatable> {
        let mut premises = vec![];
        for binder in self.binders(writer)? {
            let is_function = self.declarations.symbol(&binder.symbol).is_none();
            for name in binder.names.iter().filter(|_| is_function) {
                premises.push(Code::apply("smooth", &[Code::atom(name)]));
            }
        }
        for name in &self.symbols {
            let own = writer.symbol(name)?;
            match self.declarations.symbol(name) {
                Some(SymbolKind::Real(interval)) => premises.extend(within(own, interval)),
                Some(SymbolKind::Integer { least, most }) => {
                    let form = |form: &Option<_>| {
                        form.as_ref().map(|form| writer.affine(form)).transpose()
                    };
                    let text = match (form(least)?, form(most)?) {
                        (Some(least), Some(most)) => format!("({least} <= {own} <= {most})%Z"),
                        (Some(least), None) => format!("({least} <= {own})%Z"),
                        (None, Some(most)) => format!("({own} <= {most})%Z"),
                        (None, None) => continue,
                    };
                    premises.push(Code::atom(text));
                }
                _ => {}
            }
        }
        for hypothesis in &self.hypotheses {
            let mut needed = Premises::default();
            writer.statement_defined(hypothesis, &Scope::default(), &mut needed)?;
            premises.extend(needed.into_vec());
            premises.push(writer.translate_statement(hypothesis, &Scope::default(), None)?);
        }
        Ok(premises)
    }

    /// The same claim with another statement, which `fails` denies.
    fn denied(
        &self,
        writer: &mut Writer<'_>,
        inner: &Expr,
        scope: &Scope,
    ) -> Result<Code, Untranslatable> {
        let mut premises = self.premises(writer)?;
        let mut needed = Premises::default();
        writer.statement_defined(inner, scope, &mut needed)?;
        premises.extend(needed.into_vec());
        let alongs = writer.alongs.len();
        let conclusion = writer.translate_statement(inner, scope, None)?;
        if writer.alongs.len() > alongs {
            return Err(Untranslatable::Theory(
                "denials of coefficients along given equations",
            ));
        }
        let whole = Proposition {
            definitions: vec![],
            binders: self.binders(writer)?,
            premises,
            conclusion,
            unknowns: vec![],
            unclear_forms: false,
            alongs: vec![],
        };
        Ok(Code::new(whole.universal(), Level::Open))
    }
}

/// How many coordinates a value of a symbol has, where it is bound coordinate by coordinate.
fn coordinates(declarations: &Declarations, name: &str) -> Option<u8> {
    match declarations.symbol(name) {
        Some(SymbolKind::Vector(Some(n))) => Some(*n),
        Some(SymbolKind::Family {
            dimension: Some(n @ 2..),
            ..
        }) => Some(*n),
        Some(_) => None,
        None => declarations.function(name)?.filter(|n| *n > 1),
    }
}

/// Symbols, with those in whose terms their sets are declared.
fn with_sets(declarations: &Declarations, symbols: &BTreeSet<String>) -> BTreeSet<String> {
    let mut pending: Vec<String> = symbols.iter().cloned().collect();
    let mut all: BTreeMap<String, ()> = BTreeMap::new();
    while let Some(name) = pending.pop() {
        if all.insert(name.clone(), ()).is_some() {
            continue;
        }
        let forms = match declarations.symbol(&name) {
            Some(SymbolKind::Integer { least, most }) => least.iter().chain(most).collect(),
            Some(SymbolKind::Family { ranges, .. }) => {
                ranges.iter().flat_map(|(a, b)| [a, b]).collect()
            }
            _ => vec![],
        };
        for form in forms {
            let names = form.multiples().map(|(name, _)| name.to_owned());
            pending.extend(names);
        }
    }
    all.into_keys().collect()
}
