//! What the names of a program's parameters and symbols stand for in a claim.

use super::value::{FOREIGN, Family, List, Shape, Term, Value};
use crate::grammar::Read;
use crate::program::{Function, Kind, Parameter, Program, refused};
use std::collections::BTreeMap;
use torse_numbers::Affine;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::greek;

/// The deepest definition within definitions that is looked into.
const MAX_DEPTH: usize = 64;

/// The claim's side of a comparison.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setting<'c> {
    pub(crate) declarations: &'c Declarations,
    /// The integers that hypotheses fix.
    pub(crate) fixed: &'c BTreeMap<String, i64>,
    /// What names of the program stand for, as the user says.
    pub(crate) given: &'c BTreeMap<String, Expr>,
}

impl Setting<'_> {
    /// The values of the parameters of the function that is compared.
    pub(crate) fn arguments(
        &self,
        program: &Program,
        function: &Function,
    ) -> Read<Vec<Option<Value>>> {
        for (name, formula) in self.given {
            let is_parameter = function.parameters.iter().any(|p| p.name == *name);
            if !is_parameter && !program.source.text.contains(name.as_str()) {
                let message = format!("`{}` has no parameter `{name}`", function.name);
                let names = function.parameters.iter().map(|p| p.name.as_str());
                let help = format!("it has {}", listed(names));
                return Err(refused(&program.source, function.place, message, help));
            }
            let undeclared = formula
                .names()
                .into_iter()
                .find(|name| !self.is_declared(name));
            if let Some(undeclared) = undeclared {
                let message = format!(
                    "`{name}` is to stand for a formula with `{undeclared}`, which the claim does not declare"
                );
                return Err(refused(
                    &program.source,
                    function.place,
                    message,
                    self.declared(),
                ));
            }
        }
        let parameters = function.parameters.iter();
        let values = parameters
            .map(|parameter| self.argument(program, parameter))
            .collect::<Read<Vec<_>>>()?;
        let mut before: Vec<(&str, &Parameter)> = vec![];
        for parameter in &function.parameters {
            let Ok(symbol) = self.alike(&parameter.name) else {
                continue;
            };
            if let Some((_, other)) = before.iter().find(|(own, _)| *own == symbol) {
                let message = format!(
                    "`{}` and `{}` would both stand for `{symbol}`",
                    other.name, parameter.name
                );
                let help = format!(
                    "say what each of them stands for: `--map '{}=FORMULA'`",
                    parameter.name
                );
                return Err(refused(&program.source, parameter.place, message, help));
            }
            before.push((symbol, parameter));
        }
        Ok(values)
    }

    /// The value of one parameter; none where its default is taken.
    fn argument(&self, program: &Program, parameter: &Parameter) -> Read<Option<Value>> {
        match self.symbol(&parameter.name) {
            Ok(value) => Ok(Some(value.typed(&parameter.declared))),
            Err(_) if parameter.default.is_some() => Ok(None),
            Err(message) => {
                let help = format!(
                    "say what it stands for, `--map '{}=FORMULA'`; {}",
                    parameter.name,
                    self.declared()
                );
                Err(refused(&program.source, parameter.place, message, help))
            }
        }
    }

    /// What a name of the program stands for: as given, a symbol of that name, or one that is spelled alike.
    pub(crate) fn symbol(&self, name: &str) -> Result<Value, String> {
        if let Some(formula) = self.given.get(name) {
            return Ok(self.formula(formula));
        }
        self.alike(name).map(|name| self.named(name))
    }

    /// What a symbol of a program stands for that has exactly this name in the claim.
    pub(crate) fn own_symbol(&self, name: &str) -> Option<Value> {
        let given = self.given.get(name).map(|formula| self.formula(formula));
        given.or_else(|| self.is_symbol(name).then(|| self.named(name)))
    }

    /// The symbol of the claim that a name is, or that is spelled alike; not for names of which the user says what they are.
    fn alike<'n>(&'n self, name: &'n str) -> Result<&'n str, String> {
        if self.given.contains_key(name) {
            return Err(format!("`{name}` stands for a formula"));
        }
        if self.is_symbol(name) {
            return Ok(name);
        }
        let spelled = spelling(name);
        let own = self.declarations.symbols().map(|(name, _)| name);
        let mut alike = own.filter(|symbol| spelling(symbol) == spelled);
        match (alike.next(), alike.next()) {
            (Some(only), None) => Ok(only),
            (Some(first), Some(second)) => Err(format!(
                "`{name}` may stand for `{first}` or for `{second}`"
            )),
            (None, _) => Err(format!("nothing of the claim is called `{name}`")),
        }
    }

    fn is_symbol(&self, name: &str) -> bool {
        let constant = self.declarations.definition(name);
        self.declarations.symbol(name).is_some()
            || constant.is_some_and(|own| own.parameters.is_empty())
    }

    /// Whether a name has a meaning in the claim.
    pub(crate) fn is_declared(&self, name: &str) -> bool {
        let base = name.trim_end_matches('\'');
        base == "pi"
            || torse_syntax::formula::functions::is_function(base)
            || self.declarations.names().any(|known| known == base)
    }

    /// The symbols of the claim, for messages.
    fn declared(&self) -> String {
        let names = self.declarations.symbols().map(|(name, _)| name);
        format!("the claim has {}", listed(names))
    }

    /// The value of a declared name.
    fn named(&self, name: &str) -> Value {
        if let Some(value) = self.fixed.get(name) {
            return Value::Term(Term::number(integer(*value), true));
        }
        match self.declarations.symbol(name) {
            Some(SymbolKind::Family { ranges, dimension }) => Value::Family(Family {
                name: name.to_owned(),
                is_of_points: *dimension != Some(1),
                kind: Kind::Float,
                ranges: ranges
                    .iter()
                    .map(|(low, high)| (self.at(low), self.at(high)))
                    .collect(),
                given: vec![],
            }),
            kind => {
                let is_whole = matches!(kind, Some(SymbolKind::Integer { .. }));
                Value::Term(Term {
                    is_point: self.may_be_point(&Expr::name(name), 0),
                    ..Term::formula(Expr::name(name), Kind::from_whole(is_whole))
                })
            }
        }
    }

    /// The value of a formula that a name stands for.
    fn formula(&self, formula: &Expr) -> Value {
        match &formula.node {
            Node::List(items) => Value::List(List {
                values: items.iter().map(|item| self.formula(item)).collect(),
                shape: Shape::Either,
                object: FOREIGN,
                sources: vec![],
            }),
            Node::Name(name) => self.named(name),
            Node::Number { value, .. } => {
                Value::Term(Term::number(value.clone(), value.is_integer()))
            }
            _ => Value::Term(Term {
                is_point: self.may_be_point(formula, 0),
                ..Term::formula(formula.placeless(), Kind::Float)
            }),
        }
    }

    /// Whether a formula of the claim may be a point.
    fn may_be_point(&self, formula: &Expr, depth: usize) -> bool {
        if depth > MAX_DEPTH {
            return true;
        }
        let inner = |part: &Expr| self.may_be_point(part, depth + 1);
        match &formula.node {
            Node::Number { .. } | Node::Compare(..) | Node::Join(..) | Node::Not(_) => false,
            Node::Name(name) => match self.declarations.symbol(name) {
                Some(SymbolKind::Vector(_)) => true,
                Some(SymbolKind::Family { dimension, .. }) => *dimension != Some(1),
                Some(_) => false,
                None => {
                    let definition = self.declarations.definition(name);
                    let function = self.declarations.function(name);
                    definition.is_some_and(|own| inner(&own.body.expr))
                        || function.is_some_and(|dimension| dimension != Some(1))
                }
            },
            Node::Negative(part) => inner(part),
            Node::Binary(_, left, right) => inner(left) || inner(right),
            Node::List(_) => true,
            Node::Index(head, _) => match &head.node {
                Node::Name(name) => match self.declarations.symbol(name) {
                    Some(SymbolKind::Vector(_)) => false,
                    _ => inner(head),
                },
                _ => false,
            },
            Node::Call(head, arguments) => match &head.node {
                Node::Name(name) if name == "dot" => false,
                _ => inner(head) || arguments.iter().any(inner),
            },
        }
    }

    /// An end of a range, with the fixed integers put in.
    fn at(&self, end: &Affine) -> Affine {
        let fixed = self.fixed.iter();
        fixed.fold(end.clone(), |end, (name, value)| {
            end.substituted(name, &Affine::number(*value))
        })
    }

    /// The dimension of a formula that is a point of a declared dimension.
    pub(crate) fn dimension(&self, expr: &Expr) -> Option<u8> {
        match &expr.node {
            Node::Name(name) => match self.declarations.symbol(name) {
                Some(SymbolKind::Vector(dimension)) => *dimension,
                _ => None,
            },
            Node::Index(head, _) => match &head.node {
                Node::Name(name) => match self.declarations.symbol(name) {
                    Some(SymbolKind::Family { dimension, .. }) => dimension.filter(|d| *d > 1),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        }
    }
}

/// A name as it is compared: Greek letters spelled out, without `_`.
fn spelling(name: &str) -> String {
    let mut spelled = String::new();
    for c in name.chars().filter(|c| *c != '_') {
        match greek::LETTERS.iter().find(|letter| letter.sign == c) {
            Some(letter) => spelled.push_str(letter.name),
            None => spelled.push(c),
        }
    }
    // `lambda` is a word of Python.
    for short in ["lmbda", "lamda"] {
        if let Some(rest) = spelled.strip_prefix(short) {
            return format!("lambda{rest}");
        }
    }
    spelled
}

/// Names with commas between them.
fn listed<'n>(names: impl Iterator<Item = &'n str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [] => "none".to_owned(),
        some => some.join(", "),
    }
}
