//! What is asked: which function, which side of which claim, and what names stand for.

use crate::grammar::{Read, small};
use crate::program::refused;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::derivation::schema::SideEntry;
use torse_syntax::derivation::{
    Claim, DerivationError, Hypothesis, Origin, Provenance, Source, Written,
};
use torse_syntax::formula::{Connective, Expr, Node, Place, Relation, parse};
use torse_syntax::notation;
use torse_verdicts::repair::one_side::sides;
use torse_verdicts::repair::subject::Subject;

/// Which side of an equation the code is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PrintedSide {
    /// The right one, unless only the left one calls a definition whose name begins with `printed`.
    #[default]
    Printed,
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// A function, and how it is compared with a claim.
#[derive(Debug, Clone, Default)]
pub struct CodeQuestion {
    /// The name of the file, which says its language, for messages.
    pub file: String,
    /// Its text.
    pub text: String,
    /// The name of the function.
    pub function: String,
    /// What names of parameters and of SymPy's symbols stand for: formulas of the claim.
    pub map: Vec<(String, String)>,
    /// Hypotheses besides those of the claim, such as `n == 3`.
    pub conditions: Vec<String>,
    /// The side of the claim.
    pub side: PrintedSide,
    /// Which equation of a claim with several, counted from one.
    pub part: Option<usize>,
}

impl CodeQuestion {
    /// A function that has the claim's names for its parameters.
    #[must_use]
    pub fn new(
        file: impl Into<String>,
        text: impl Into<String>,
        function: impl Into<String>,
    ) -> Self {
        Self {
            file: file.into(),
            text: text.into(),
            function: function.into(),
            ..Self::default()
        }
    }

    /// The question that a claim asks with its field `code`: the file is seen from the folder of its paper, and its text is still to
    /// be read.
    #[must_use]
    pub fn declared(claim: &Claim) -> Option<Self> {
        let code = claim.entry.code.as_ref()?;
        let text = |text: &toml::Spanned<String>| text.get_ref().clone();
        let map = code.map.iter();
        Some(Self {
            file: text(&code.file),
            text: String::new(),
            function: text(&code.function),
            map: map
                .map(|(name, formula)| (name.clone(), text(formula)))
                .collect(),
            conditions: code.conditions.iter().map(text).collect(),
            side: match code.side {
                None => PrintedSide::Printed,
                Some(SideEntry::Left) => PrintedSide::Left,
                Some(SideEntry::Right) => PrintedSide::Right,
            },
            part: code.part,
        })
    }
}

/// A question whose formulas are read.
pub(super) struct Asked<'c> {
    pub(super) claim: &'c Claim,
    pub(super) origin: Origin,
    /// The claim's names, and those that the code binds itself.
    pub(super) declarations: Arc<Declarations>,
    /// The side that the code is compared with.
    pub(super) printed: Expr,
    /// The other side of the claim.
    pub(super) other: Expr,
    pub(super) hypotheses: Vec<Hypothesis>,
    /// The integers that hypotheses fix.
    pub(super) fixed: BTreeMap<String, i64>,
    pub(super) given: BTreeMap<String, Expr>,
}

impl<'c> Asked<'c> {
    pub(super) fn new(claim: &'c Claim, question: &CodeQuestion) -> Read<Self> {
        let (equation, origin) = equation(claim, question.part)?;
        let wrong = |message: &str, help: &str| wrong(claim, message, help);
        let Some((left, right)) = sides(equation) else {
            let message = "this states no equation, and code is compared with a side of one";
            return Err(wrong(message, "compare with a claim of the form `f == g`"));
        };
        let is_left = match question.side {
            PrintedSide::Left => true,
            PrintedSide::Right => false,
            PrintedSide::Printed => Subject::is_left(equation),
        };
        let (printed, other) = if is_left {
            (left, right)
        } else {
            (right, left)
        };
        let conditions = question.conditions.iter();
        let hypotheses: Vec<Hypothesis> = conditions
            .map(|text| hypothesis(text))
            .collect::<Read<_>>()?;
        let all = claim.assumptions.iter().chain(&hypotheses);
        let fixed = all.filter_map(|own| fixed(&own.formula.expr)).collect();
        let mut given = BTreeMap::new();
        for (name, text) in &question.map {
            let source = Arc::new(Source::new("the mapping", text.as_str()));
            let origin = Origin::all(&source);
            let formula =
                parse(text).map_err(|error| Box::new(DerivationError::syntax(&origin, &error)))?;
            given.insert(name.clone(), formula);
        }
        Ok(Self {
            claim,
            origin,
            declarations: Arc::clone(&claim.declarations),
            printed: printed.clone(),
            other: other.clone(),
            hypotheses,
            fixed,
            given,
        })
    }
}

/// A mistake about the claim as a whole.
fn wrong(claim: &Claim, message: &str, help: &str) -> Box<DerivationError> {
    Box::new(DerivationError::at(&claim.origin, Place::default(), message).with_help(help))
}

/// The equation of a claim that is compared.
fn equation(claim: &Claim, part: Option<usize>) -> Read<(&Expr, Origin)> {
    let Some(statement) = &claim.statement else {
        let message = match claim.readings.is_empty() {
            true => "this claim states nothing that code could be compared with",
            false => "this claim has several readings, and code is compared with one equation",
        };
        return Err(wrong(claim, message, "name a claim with `states`"));
    };
    if !claim.existentials.is_empty() {
        let message = "this claim says that numbers exist, and code is compared with an equation";
        return Err(wrong(claim, message, "name a claim without `exists`"));
    }
    let mut parts = vec![];
    conjuncts(&statement.expr, &mut parts);
    let origin = statement.origin.clone();
    let at = |place: Place, message: String, help: String| {
        Box::new(DerivationError::at(&origin, place, message).with_help(help))
    };
    let listed = || {
        let numbered = parts.iter().enumerate();
        let numbered = numbered.map(|(n, part)| format!("{}: {}", n + 1, notation::text(part)));
        format!(
            "`--part N` takes one of them: {}",
            numbered.collect::<Vec<_>>().join("; ")
        )
    };
    match (parts.as_slice(), part) {
        ([only], None | Some(1)) => Ok((only, origin)),
        (several, None) => {
            let message = format!("this states {} things together", several.len());
            Err(at(statement.expr.place, message, listed()))
        }
        (several, Some(part)) => {
            let found = part
                .checked_sub(1)
                .and_then(|position| several.get(position));
            found.map(|found| (*found, origin.clone())).ok_or_else(|| {
                let message = format!("this has no part {part}");
                at(statement.expr.place, message, listed())
            })
        }
    }
}

/// The statements that a statement joins by `and`.
fn conjuncts<'e>(expr: &'e Expr, into: &mut Vec<&'e Expr>) {
    match &expr.node {
        Node::Join(Connective::And, left, right) => {
            conjuncts(left, into);
            conjuncts(right, into);
        }
        _ => into.push(expr),
    }
}

fn hypothesis(text: &str) -> Read<Hypothesis> {
    let source = Arc::new(Source::new("the setting", text));
    let origin = Origin::all(&source);
    let expr = parse(text).map_err(|error| Box::new(DerivationError::syntax(&origin, &error)))?;
    if !matches!(expr.node, Node::Compare(..) | Node::Join(..) | Node::Not(_)) {
        let message = "this is no hypothesis";
        let whole = Place {
            start: 0,
            end: text.len(),
        };
        return Err(refused(
            &source,
            whole,
            message,
            "write a comparison: `n == 3`",
        ));
    }
    Ok(Hypothesis {
        formula: Written { expr, origin },
        provenance: Provenance::Stated,
    })
}

/// The integer that a hypothesis gives to a name.
fn fixed(expr: &Expr) -> Option<(String, i64)> {
    let Node::Compare(left, rest) = &expr.node else {
        return None;
    };
    let [(Relation::Equal, right)] = rest.as_slice() else {
        return None;
    };
    let (Node::Name(name), Some(value)) = (&left.node, number(right)) else {
        return None;
    };
    Some((name.clone(), value))
}

fn number(expr: &Expr) -> Option<i64> {
    match &expr.node {
        Node::Number { value, .. } => small(value),
        Node::Negative(inner) => number(inner)?.checked_neg(),
        _ => None,
    }
}
