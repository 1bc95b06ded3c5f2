//! Whether core terms say what the text says: the judge of the elaborator.
//!
//! Prover, checker and the writer of Rocq statements read core terms. So a fault of the elaborator is made wherever these are
//! read, and no comparison of verdicts shows it. Here the core claim and the trees of its text are compared as *terms*: at
//! random residues modulo a prime, whatever the hypotheses say of them, each side of each comparison has to have the same value,
//! and connectives and relations have to be the same. Equal truth would not be enough, and no equation has to be solved.
//!
//! **What the engine names.** The derivative of a smooth function at a place and the root of a formula are symbols in core
//! terms. The value of such a symbol is the value of its *text*; that of a root is the root of what the claim says its square
//! is, and if its name is a text as well, both have to be the same.
//!
//! An assignment counts if both readings have a value. Where none of the first ten does, the formula is not compared.

mod functions;
mod terms;

use self::terms::Terms;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_algebra::{Rational, rational};
use torse_core::{self as core, FamilyProperty, Node, Printed, Statement, Term};
use torse_semantics::tree::{
    Assignment, BASIS_AT, BASIS_DEGREES, Compared, Outline, Piece, Reading, TreeOutline,
    printed_number, word,
};
use torse_semantics::{Class, Gap, Name, Scrambled, Series, Value, Work};
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{self, Expr, Place};
use torse_syntax::notation;

/// How many assignments are tried, and at how many a claim is compared.
const ATTEMPTS: u64 = 10;
const COMPARED: u64 = 2;
/// The operations that one assignment may take.
const WORK: u64 = 400_000;

/// What was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Agreement {
    /// All that was compared has the same value.
    Same,
    /// Some formula has no value for one of the readings wherever it was tried.
    NotCompared(String),
    /// A formula that has two values.
    Differs(String),
}

/// Words and values of core terms.
type CoreOutline<'c> = Outline<&'c Term, Class>;

/// Compares a core claim with the trees that it was made of.
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
    let (mut compared, mut why) = (0, None);
    for attempt in 0..ATTEMPTS {
        match case.at(attempt) {
            Ok(None) => compared += 1,
            Ok(Some(open)) => why = Some(open),
            Err(found) => return Agreement::Differs(found),
        }
        if compared >= COMPARED {
            break;
        }
    }
    match why.filter(|_| compared == 0) {
        None => Agreement::Same,
        Some(why) => Agreement::NotCompared(why),
    }
}

/// The names of core terms that stand in no declaration, with their trees.
fn made_names(core: &core::Claim) -> BTreeMap<Arc<str>, Option<Expr>> {
    let made = core.symbols.keys().filter(|name| !formula::is_name(name));
    made.map(|name| (Arc::clone(name), formula::parse(name).ok()))
        .collect()
}

struct Case<'a> {
    claim: &'a Claim,
    core: &'a core::Claim,
    reading: &'a Reading<'a>,
    /// What the ends of declared sets say that are formulas.
    ends: &'a [(&'a str, Vec<Written>)],
    made: &'a BTreeMap<Arc<str>, Option<Expr>>,
}

impl Case<'_> {
    /// Every symbol has the set that is declared.
    fn declared(&self) -> Result<(), String> {
        let roots: BTreeSet<&Arc<str>> = self.core.roots().collect();
        for (name, set) in &self.core.symbols {
            if roots.contains(name) {
                continue;
            }
            let declared = self.claim.declarations.symbol(name);
            if declared.map(|own| format!("{own:?}")) != Some(format!("{set:?}")) {
                return Err(format!(
                    "the set of `{name}` is not the one that is declared"
                ));
            }
        }
        Ok(())
    }

    /// Compares at one assignment: `None` if everything was compared, else what was not; fails for what differs.
    fn at(&self, attempt: u64) -> Result<Option<String>, String> {
        let work = Work::new(WORK);
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
        let mut note = |found: Option<String>| {
            open = open.take().or(found);
        };
        let both = Both {
            trees: &trees,
            evaluator: &plain,
            claim: self.claim,
        };
        // What the engine named has the value of its text.
        for (name, root) in self.roots() {
            if let Some(Some(tree)) = self.made.get(name) {
                let value = plain.value(root).and_then(|value| value.number());
                let value = value.and_then(|x| x.square_root(&arithmetic));
                let same = both.same(&trees.value(tree), &value.map(Value::Number));
                let wrong = || format!("the root `{name}` is not what its name says");
                note(same.map_err(|()| wrong())?);
            }
        }
        let own = self.core.hypotheses.iter();
        let own = own.filter(|h| h.source != core::Source::Root);
        let own: Vec<CoreOutline<'_>> = own.map(|h| outline(&h.statement, &plain)).collect();
        let mut texts = trees.hypotheses();
        let written = texts.len();
        for (_, relations) in self.ends {
            texts.extend(relations.iter().map(|end| trees.hypothesis(&end.expr)));
        }
        if own.len() != texts.len() {
            return Err("the claim has another number of hypotheses".to_owned());
        }
        for (n, (text, own)) in texts.iter().zip(&own).enumerate().take(written) {
            let found = both.compared(text, own);
            note(found.map_err(|found| format!("in hypothesis {}, {found}", n + 1))?);
        }
        // The ends of ranges come in the order in which their symbols were met.
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
            return Err("the claim has another number of unknowns".to_owned());
        }
        for (text, own) in unknowns.iter().zip(&self.core.unknowns) {
            let same = both.same(text, &plain.value(own));
            note(same.map_err(|()| "an unknown is another number".to_owned())?);
        }
        let statement = trees.statement();
        let both = Both {
            evaluator: &along,
            ..both
        };
        note(both.compared(&statement, &outline(&self.core.statement, &along))?);
        for name in assignment.take_asked() {
            // The place of a function stands in the names of its values.
            let mut places = self.made.values().flatten();
            let is_place = places.any(|tree| tree.names().contains(&&*name));
            let is_sought = self.claim.sought.iter().any(|s| *s.name == *name);
            if !is_place && !is_sought && !self.core.symbols.contains_key(&name) {
                return Err(format!("`{name}` is not among the symbols of the claim"));
            }
        }
        Ok(open)
    }

    fn roots(&self) -> impl Iterator<Item = (&Arc<str>, &Term)> {
        self.core
            .hypotheses
            .iter()
            .filter_map(core::Hypothesis::root)
    }
}

/// What core terms ask for.
struct Numbers<'a, 's> {
    core: &'s core::Claim,
    made: &'s BTreeMap<Arc<str>, Option<Expr>>,
    trees: &'a Compared<'s, 'a>,
    assignment: &'a Assignment<'s>,
    arithmetic: &'a Scrambled<'a>,
    known: RefCell<BTreeMap<Arc<str>, Option<Value<Class>>>>,
}

impl Numbers<'_, '_> {
    fn number(&self, name: &Name) -> Option<Class> {
        let declared = name.declared();
        let Some(text) = self.made.get(declared) else {
            return self.assignment.number(name);
        };
        let known = self.known.borrow().get(declared).cloned();
        let value = match known {
            Some(known) => known,
            None => {
                let found = self.made_value(declared, text.as_ref());
                let mut known = self.known.borrow_mut();
                known.insert(Arc::clone(declared), found.clone());
                found
            }
        };
        let value = match name {
            Name::Coordinate(_, c) => {
                let entry = value?.entries().ok()?;
                entry.get(usize::from(*c).checked_sub(1)?)?.clone()
            }
            _ => value?.number().ok()?,
        };
        value.as_number().copied()
    }

    /// The value of a name that the engine made: the root of its square, or what its text is worth.
    fn made_value(&self, name: &Arc<str>, text: Option<&'_ Expr>) -> Option<Value<Class>> {
        let mut roots = self
            .core
            .hypotheses
            .iter()
            .filter_map(core::Hypothesis::root);
        if let Some((_, radicand)) = roots.find(|(own, _)| *own == name) {
            let values = |name: &Name| self.number(name);
            let radicand = Terms::new(self.arithmetic, &values, None).value(radicand);
            let root = radicand.ok()?.number().ok()?.square_root(self.arithmetic);
            return root.ok().map(Value::Number);
        }
        let made = self.made.get(name)?.as_ref();
        debug_assert_eq!(made, text);
        self.trees.value(made?).ok()
    }
}

/// Both readings at one assignment.
#[derive(Clone, Copy)]
struct Both<'a, 's, 'e> {
    trees: &'a Compared<'s, 'e>,
    evaluator: &'a Terms<'a>,
    claim: &'s Claim,
}

impl<'s> Both<'_, 's, '_> {
    /// Compares two outlines: what has no value for one of them, if anything; fails for what differs.
    fn compared(
        &self,
        text: &TreeOutline<'s>,
        own: &CoreOutline<'_>,
    ) -> Result<Option<String>, String> {
        let mut open = None;
        let mut relation = String::new();
        if text.len() != own.len() {
            return Err("core terms make another statement of the text".to_owned());
        }
        for pair in text.iter().zip(own) {
            match pair {
                (Piece::Word(word), Piece::Word(other)) if word == other => {
                    relation.clone_from(word);
                }
                (Piece::Value(tree, text), Piece::Value(term, own)) => match self.same(text, own) {
                    Ok(found) => open = open.or(found),
                    Err(()) => {
                        let least = match (tree, term) {
                            (Some(tree), Some(term)) => Some(self.smallest(tree, term)),
                            _ => None,
                        };
                        let what = least.unwrap_or_else(|| format!("a side of `{relation}`"));
                        return Err(format!(
                            "{what} has another value as a core term than in the text"
                        ));
                    }
                },
                _ => return Err("core terms make another statement of the text".to_owned()),
            }
        }
        Ok(open)
    }

    /// Whether two values are the same: why that is not seen, or an error where they are not.
    fn same(
        &self,
        text: &Result<Value<Class>, Gap>,
        own: &Result<Value<Class>, Gap>,
    ) -> Result<Option<String>, ()> {
        match (text, own) {
            (Ok(text), Ok(own)) if are_same(text, own) => Ok(None),
            (Ok(_), Ok(_)) => Err(()),
            (Err(gap), _) => Ok(Some(format!("in the text {gap}"))),
            (_, Err(gap)) => Ok(Some(format!("as a core term {gap}"))),
        }
    }

    /// The smallest part with two values, among those that depend on no variable of a binder.
    fn smallest(&self, tree: &'s Expr, term: &Term) -> String {
        let mut within = None;
        let (mut tree, mut term) = (tree, term.clone());
        loop {
            let parts: Vec<Term> = term.parts().into_iter().cloned().collect();
            let opened = match (&*term.node, &tree.node) {
                (
                    Node::Opened {
                        closed: true, name, ..
                    },
                    formula::Node::Name(own),
                ) if **name == **own => self.claim.declarations.definition(name),
                _ => None,
            };
            if let (Some(definition), [body]) = (opened, parts.as_slice()) {
                within = Some(tree_name(tree));
                (tree, term) = (&definition.body.expr, body.clone());
                continue;
            }
            let next = parts.into_iter().find_map(|part| {
                let tree = tree
                    .parts()
                    .into_iter()
                    .find(|tree| tree.place == part.place)?;
                let differ = part.is_closed()
                    && self
                        .same(&self.trees.value(tree), &self.evaluator.value(&part))
                        .is_err();
                differ.then_some((tree, part))
            });
            match next {
                Some(next) => (tree, term) = next,
                None => break,
            }
        }
        let text = notation::text(tree);
        match within {
            None => format!("`{text}`"),
            Some(name) => format!("`{text}` in `{name}`"),
        }
    }
}

fn tree_name(tree: &Expr) -> &str {
    match &tree.node {
        formula::Node::Name(name) => name,
        _ => "",
    }
}

/// Whether all entries are equal; 0 is an empty sum of any shape.
fn are_same(text: &Value<Class>, own: &Value<Class>) -> bool {
    let shapes = |value: &Value<Class>| value.numbers().len();
    let zero = |value: &Value<Class>| value.numbers().iter().all(|x| x.all(&|x| x.is_zero()));
    (text == own) || (zero(text) && zero(own) && (shapes(text) == 1 || shapes(own) == 1))
}

/// The outline of a core statement.
fn outline<'c>(statement: &'c Statement, at: &Terms<'_>) -> CoreOutline<'c> {
    let mut all = vec![];
    let mut pending = vec![statement];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Compare {
                relation,
                left,
                right,
            } => {
                all.push(Piece::Word(relation.sign().to_owned()));
                all.extend([left, right].map(|side| Piece::Value(Some(side), at.value(side))));
            }
            Statement::Agrees { value, printed, .. } => {
                let printed: Vec<String> = printed.iter().map(printed_word).collect();
                all.push(Piece::Word(format!("agrees {}", printed.join(", "))));
                all.push(Piece::Value(Some(value), at.value(value)));
            }
            Statement::Join(connective, a, b) => {
                all.push(Piece::Word(word(*connective)));
                pending.extend([&**b, &**a]);
            }
            Statement::Not(inner) => {
                all.push(Piece::Word("fails".to_owned()));
                pending.push(inner);
            }
            Statement::Family(property, family) => {
                let (name, degrees) = match property {
                    FamilyProperty::Nonnegative => ("nonnegative", vec![]),
                    FamilyProperty::Independent => ("independent", vec![]),
                    FamilyProperty::VariationDiminishing(degrees) => {
                        let degrees = degrees.iter().flat_map(|d| [d.least, d.most]);
                        ("variation_diminishing", degrees.collect())
                    }
                };
                all.push(Piece::Word(format!(
                    "{name} {degrees:?} from {}",
                    family.degree
                )));
                let least = i64::from(family.degree);
                for degree in least..least + BASIS_DEGREES {
                    let row = (0..=degree).map(|i| {
                        let term = basis_function(family, i, degree);
                        at.value(&term)?.number()
                    });
                    let row = row.collect::<Result<Vec<Series<Class>>, Gap>>();
                    all.push(Piece::Value(None, row.map(Value::vector)));
                }
            }
        }
    }
    all
}

fn printed_word(printed: &Printed) -> String {
    let size = match printed.negative {
        true => -printed.value.clone(),
        false => printed.value.clone(),
    };
    printed_number(&size, printed.decimals, printed.negative)
}

/// A function of a basis at one value of its variable, with the shape parameters of the point.
fn basis_function(family: &Arc<core::Family>, index: i64, degree: i64) -> Term {
    let made = |node| Term {
        node: Arc::new(node),
        place: Place::default(),
    };
    let number = |n: i64| made(Node::Number(rational::integer(n)));
    let (u, v) = BASIS_AT;
    let variable = made(Node::Number(Rational::new(u.into(), v.into())));
    let parameters = family.parameters();
    let parameters = parameters.map(|name| made(Node::Symbol(Arc::from(name))));
    made(Node::Basis {
        family: Arc::clone(family),
        index: number(index),
        degree: number(degree),
        arguments: std::iter::once(variable).chain(parameters).collect(),
    })
}
