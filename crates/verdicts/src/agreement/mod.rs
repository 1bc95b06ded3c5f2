//! Compares core terms with the text that they were made from: the test of the elaborator.
//!
//! Prover, checker and the writer of Rocq lemmas read core terms, so a fault of the elaborator affects all of them and
//! no comparison of verdicts shows it. Here the core claim and the trees of its text are compared as *terms*: at random
//! residues modulo a prime, whether or not these satisfy the hypotheses, each side of each comparison must have the
//! same value, and connectives and relations must be the same. Comparing truth values would not suffice, and no
//! equation has to be solved.
//!
//! **Names made by the engine.** In core terms, the derivative of a smooth function at a place and the root or logarithm
//! of a formula are symbols. The value of such a symbol is the value of its *text*; the value of a root is the root of its
//! square and that of a logarithm the logarithm of its exponential, as the claim defines them, and if its name is a text
//! as well, both must agree.
//!
//! An assignment counts if both readings have a value. If none of the first ten does, the claim is not compared, and
//! not netted. But if one reading never has a value and the other always has one, they differ.

mod basis;
mod both;
mod functions;
mod numbers;
mod outline;
mod scope;
mod terms;

pub(crate) use self::both::are_same;
use self::both::{Both, Missing};
use self::numbers::Numbers;
use self::outline::{CoreOutline, outline};
use self::terms::Terms;
use functions::arc_value;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_core as core;
use torse_semantics::tree::{Assignment, Compared, Reading};
use torse_semantics::{Name, Scrambled, Value, Work};
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{self, Expr};

/// How many assignments are tried, and at how many of them a claim is compared.
const MAX_ATTEMPTS: u64 = 10;
const COMPARED: u64 = 2;
/// Maximum number of operations for one assignment.
const MAX_WORK: u64 = 1_500_000;

/// The result of a comparison.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Agreement {
    /// Everything that was compared has the same value.
    Same,
    /// Some formula has no value in one of the readings at any assignment that was tried.
    NotCompared(String),
    /// A formula that has two different values.
    Differs(String),
}

/// Compares a core claim with the trees that it was made from.
pub fn agreement(claim: &Claim, statement: &Written, core: &core::Claim) -> Agreement {
    let rooted = core.rooted(&statement.origin);
    let core = rooted.as_ref().unwrap_or(core);
    let reading = Reading::new(claim, &statement.expr, []);
    let ends: Vec<(&str, Vec<Written>)> = core
        .symbols
        .keys()
        .filter_map(|name| match claim.declarations.symbol(name) {
            Some(core::Set::Real(interval)) => Some((&**name, interval.relations(name))),
            _ => None,
        })
        .collect();
    let made = made_names(core);
    let case = Case {
        claim,
        core,
        reading: &reading,
        ends: &ends,
        made: &made,
    };
    if let Err(found) = case.declared() {
        return Agreement::Differs(found);
    }
    let (mut compared, mut missing) = (0, vec![]);
    for attempt in 0..MAX_ATTEMPTS {
        match case.at(attempt) {
            Ok(None) => compared += 1,
            Ok(Some(found)) => missing.push(found),
            Err(found) => return Agreement::Differs(found),
        }
        if compared >= COMPARED {
            break;
        }
    }
    match missing.first().filter(|_| compared == 0) {
        None => Agreement::Same,
        // One reading has a value at every assignment, the other at none.
        Some(first) if missing.iter().all(|found| found.is_one_sided) => {
            Agreement::Differs(format!("one reading has no value: {}", first.why))
        }
        Some(first) => Agreement::NotCompared(first.why.clone()),
    }
}

/// Returns the names that occur in core terms and in no declaration, with their trees.
fn made_names(core: &core::Claim) -> BTreeMap<Arc<str>, Option<Expr>> {
    let made = core.symbols.keys().filter(|name| !formula::is_name(name));
    made.map(|name| (Arc::clone(name), formula::parse(name).ok()))
        .collect()
}

struct Case<'a> {
    claim: &'a Claim,
    core: &'a core::Claim,
    reading: &'a Reading<'a>,
    /// Ends of declared sets that are formulas.
    ends: &'a [(&'a str, Vec<Written>)],
    made: &'a BTreeMap<Arc<str>, Option<Expr>>,
}

impl Case<'_> {
    /// Checks that every symbol has its declared set.
    fn declared(&self) -> Result<(), String> {
        let made: BTreeSet<&Arc<str>> = self.core.implicit().map(|(name, _)| name).collect();
        for (name, set) in &self.core.symbols {
            if made.contains(name) {
                continue;
            }
            let declared = self.claim.declarations.symbol(name);
            if declared.map(|own| format!("{own:?}")) != Some(format!("{set:?}")) {
                return Err(format!("the set of `{name}` is not the declared one"));
            }
        }
        Ok(())
    }

    /// Compares at one assignment: returns `None` if everything was compared, else what was not; fails where values
    /// differ.
    fn at(&self, attempt: u64) -> Result<Option<Missing>, String> {
        let work = Work::new(MAX_WORK);
        let arithmetic = Scrambled { work: &work };
        let assignment = Assignment::new(&self.claim.declarations, attempt);
        let number = |name: &Name| assignment.number(name);
        let trees = Compared::new(self.reading, &arithmetic, &number);
        let numbers = Numbers {
            core: self.core,
            made: self.made,
            trees: &trees,
            assignment: &assignment,
            arithmetic: &arithmetic,
            known: RefCell::default(),
        };
        let values = |name: &Name| numbers.number(name);
        let (plain, along) = (
            Terms::new(&arithmetic, &values, None),
            Terms::new(&arithmetic, &values, Some(self.core)),
        );
        let mut open = None;
        let mut note = |found: Option<Missing>| {
            open = open.take().or(found);
        };
        let both = Both {
            trees: &trees,
            evaluator: &plain,
            claim: self.claim,
        };
        // What the engine named has the value of its text.
        for (name, root) in self.core.roots() {
            if let Some(Some(tree)) = self.made.get(name) {
                let value = plain.value(root).and_then(|value| value.number());
                let value = value.and_then(|x| x.square_root(&arithmetic));
                let same = both.same(&trees.value(tree), &value.map(Value::Number));
                let wrong = || format!("the root `{name}` is not what its name says");
                note(same.map_err(|()| wrong())?);
            }
        }
        for (name, argument) in self.core.logarithms() {
            if let Some(Some(tree)) = self.made.get(name) {
                let value = plain.value(argument).and_then(|value| value.number());
                let value = value.and_then(|x| x.logarithm(&arithmetic));
                let same = both.same(&trees.value(tree), &value.map(Value::Number));
                let wrong = || format!("the logarithm `{name}` is not what its name says");
                note(same.map_err(|()| wrong())?);
            }
        }
        for arc in self.core.arcs() {
            if let Some(Some(tree)) = self.made.get(arc.name) {
                let value = plain.value(arc.argument).and_then(|value| value.number());
                let value = value.and_then(|x| arc_value(arc.function, &x, &arithmetic));
                let same = both.same(&trees.value(tree), &value.map(Value::Number));
                let wrong = || format!("the arc `{}` is not what its name says", arc.name);
                note(same.map_err(|()| wrong())?);
            }
        }
        let own = self.core.hypotheses.iter();
        let is_made = |source| {
            use core::Source::{Arc, Logarithm, Root};
            matches!(source, Root | Logarithm | Arc)
        };
        let own = own.filter(|h| !is_made(h.source));
        let own: Vec<CoreOutline<'_>> = own.map(|h| outline(&h.statement, &plain)).collect();
        let mut texts = trees.hypotheses();
        let written = texts.len();
        for (_, relations) in self.ends {
            texts.extend(relations.iter().map(|end| trees.hypothesis(&end.expr)));
        }
        if own.len() != texts.len() {
            return Err("the claim has a different number of hypotheses".to_owned());
        }
        for (n, (text, own)) in texts.iter().zip(&own).enumerate().take(written) {
            let found = both.compared(text, own);
            note(found.map_err(|found| format!("in hypothesis {}, {found}", n + 1))?);
        }
        // The ends of ranges come in the order in which their symbols occur first.
        let mut left: Vec<&CoreOutline<'_>> = own.iter().skip(written).collect();
        for text in texts.iter().skip(written) {
            let found = left.iter().position(|own| both.compared(text, own).is_ok());
            match found {
                Some(found) => note(both.compared(text, left.remove(found))?),
                None => return Err("the end of a range is not among the hypotheses".to_owned()),
            }
        }
        let unknowns = trees.unknowns();
        if unknowns.len() != self.core.unknowns.len() {
            return Err("the claim has a different number of unknowns".to_owned());
        }
        for (text, own) in unknowns.iter().zip(&self.core.unknowns) {
            let same = both.same(text, &plain.value(own));
            note(same.map_err(|()| "an unknown has a different value".to_owned())?);
        }
        let statement = trees.statement();
        let both = Both {
            evaluator: &along,
            ..both
        };
        note(both.compared(&statement, &outline(&self.core.statement, &along))?);
        for name in assignment.take_asked() {
            // The names of the values of a function contain the place.
            let mut places = self.made.values().flatten();
            let is_place = places.any(|tree| tree.names().contains(&&*name));
            let is_sought = self.claim.existentials.iter().any(|s| *s.name == *name);
            // Of `at(f(x), y, t)` only f(x) is left, and no y.
            let may_be_left_out = self.claim.declarations.has_functions();
            let is_missing = !self.core.symbols.contains_key(&name);
            if is_missing && !is_place && !is_sought && !may_be_left_out {
                return Err(format!("`{name}` is not among the symbols of the claim"));
            }
        }
        Ok(open)
    }
}
