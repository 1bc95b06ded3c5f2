//! What hypotheses and statements say, as propositions.

use super::function::put_in;
use super::scope::Scope;
use super::value::zero;
use super::writer::{Value, Writer};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::shape::Shape;
use torse_numbers::Rational;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// What `fails` is about: the premises of the claim, under its binders.
pub(super) struct Domain<'c> {
    /// Writes `forall symbols, premises -> the statement`.
    pub denied: &'c dyn Fn(&mut Writer<'_>, &Expr, &Scope) -> Result<Code, Untranslatable>,
}

impl Writer<'_> {
    /// What a statement says; `domain` is what `fails` is about, where it may stand: as the statement, or joined to the
    /// rest of it by `and`.
    ///
    /// # Errors
    /// [`Untranslatable`] for what has no translation.
    pub fn translate_statement(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        domain: Option<&Domain<'_>>,
    ) -> Result<Code, Untranslatable> {
        match &expr.node {
            Node::Compare(first, rest) => {
                let mut parts = vec![];
                let mut left: &Expr = first;
                for (relation, right) in rest {
                    parts.push(self.compared(*relation, left, right, scope)?);
                    left = right;
                }
                all_of(parts)
            }
            Node::Join(Connective::And, ..) => {
                let mut parts = vec![];
                self.conjuncts(expr, scope, domain, &mut parts)?;
                all_of(parts)
            }
            Node::Join(connective, a, b) => {
                let (a, b) = (
                    self.translate_statement(a, scope, None)?,
                    self.translate_statement(b, scope, None)?,
                );
                Ok(match connective {
                    Connective::Implies => {
                        let text = format!("{} -> {}", a.below(Level::Open), b.within(Level::Open));
                        Code::new(text, Level::Open)
                    }
                    _ => Code::infix_right(&a, "\\/", &b, Level::Either),
                })
            }
            Node::Not(inner) => {
                let inner = self.translate_statement(inner, scope, None)?;
                Ok(Code::new(format!("~ ({})", inner.text()), Level::Relation))
            }
            Node::Name(name) if !scope.locals.contains_key(name) => {
                let definition = self.names.declarations.definition(name);
                let definition = definition.filter(|d| d.parameters.is_empty());
                let definition = definition
                    .ok_or_else(|| Untranslatable::Unread(format!("`{name}` is no statement")))?;
                self.translate_statement(&definition.body.expr, &scope.outside(), domain)
            }
            Node::Call(head, arguments) => {
                let name = self.names.built_in(head, &scope.bound());
                match (name, arguments.as_slice()) {
                    (Some("at"), [inner, variable, point]) => {
                        let reach = self.reach(inner, scope);
                        let binding = self.binding(variable, &reach, scope)?;
                        let (value, _) = self.argument(point, binding.kind, scope)?;
                        let body = self.translate_statement(inner, &binding.scope, None)?;
                        Ok(put_in(
                            &binding.name,
                            binding.kind.rocq_type(),
                            &body,
                            &value,
                        ))
                    }
                    (Some("agrees"), [value, printed]) => self.agrees(value, printed, scope),
                    (Some("fails"), [inner]) => {
                        let domain = domain.ok_or(Untranslatable::Unread(
                            "`fails` below another word, or among the hypotheses".to_owned(),
                        ))?;
                        let text = (domain.denied)(self, inner, scope)?;
                        Ok(Code::new(format!("~ ({})", text.text()), Level::Relation))
                    }
                    (Some("nonnegative"), [basis]) => self.nonnegative(basis, scope),
                    (Some("independent"), [basis]) => self.independent(basis, scope),
                    (Some("variation_diminishing"), _) => Err(Untranslatable::Theory(
                        "total positivity and variation diminution",
                    )),
                    _ => Err(Untranslatable::Unread(
                        "a value where a statement is wanted".to_owned(),
                    )),
                }
            }
            _ => Err(Untranslatable::Unread(
                "a value where a statement is wanted".to_owned(),
            )),
        }
    }

    /// `and` is written without brackets, whichever way it was read, and a chain of comparisons is one of them.
    fn conjuncts(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        domain: Option<&Domain<'_>>,
        parts: &mut Vec<Code>,
    ) -> Result<(), Untranslatable> {
        match &expr.node {
            Node::Join(Connective::And, a, b) => {
                self.conjuncts(a, scope, domain, parts)?;
                self.conjuncts(b, scope, domain, parts)
            }
            Node::Compare(first, rest) => {
                let mut left: &Expr = first;
                for (relation, right) in rest {
                    parts.push(self.compared(*relation, left, right, scope)?);
                    left = right;
                }
                Ok(())
            }
            Node::Name(name) if !scope.locals.contains_key(name) => {
                let definition = self.names.declarations.definition(name);
                match definition.filter(|d| d.parameters.is_empty()) {
                    Some(definition) => {
                        self.conjuncts(&definition.body.expr, &scope.outside(), domain, parts)
                    }
                    None => Err(Untranslatable::Unread(format!("`{name}` is no statement"))),
                }
            }
            _ => {
                parts.push(self.translate_statement(expr, scope, domain)?);
                Ok(())
            }
        }
    }

    fn compared(
        &mut self,
        relation: Relation,
        left: &Expr,
        right: &Expr,
        scope: &Scope,
    ) -> Result<Code, Untranslatable> {
        let (x, y) = (self.value(left, scope)?, self.value(right, scope)?);
        let (a, b) = match (x.shape, y.shape) {
            (a, b) if a == b => (x.code, y.code),
            (shape, Shape::Number) if self.is_zero(right, scope) => (x.code, zero(shape)),
            (Shape::Number, shape) if self.is_zero(left, scope) => (zero(shape), y.code),
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
        Ok(compare(&a, sign, &b))
    }

    /// Printed decimals, entry by entry. A number without a point is read with as many digits as the decimal that has the
    /// fewest; where there are none it is exact.
    fn agrees(
        &mut self,
        value: &Expr,
        printed: &Expr,
        scope: &Scope,
    ) -> Result<Code, Untranslatable> {
        let Value { code, shape } = self.value(value, scope)?;
        let entries: Vec<Code> = match shape {
            Shape::Number => vec![code],
            Shape::Vector(n) => {
                let entry =
                    |i: usize| Code::apply("entry", &[code.clone(), Code::atom(i.to_string())]);
                (1..=n).map(entry).collect()
            }
            Shape::Matrix(..) => {
                return Err(Untranslatable::Construct("printed decimals of a matrix"));
            }
        };
        let printed = match &printed.node {
            Node::List(items) => items.iter().map(Printed::read).collect(),
            _ => Printed::read(printed).map(|one| vec![one]),
        };
        let printed: Vec<Printed> = printed
            .ok_or_else(|| Untranslatable::Unread("a formula among printed numbers".to_owned()))?;
        if entries.len() != printed.len() {
            let what = "as many printed numbers as entries are wanted";
            return Err(Untranslatable::Shapes(what.to_owned()));
        }
        let digits = printed.iter().filter_map(|p| p.decimals);
        let fewest = digits.filter(|d| *d > 0).min();
        let mut all = vec![];
        for (entry, printed) in entries.iter().zip(&printed) {
            let number = Code::rational(&printed.value);
            all.push(match printed.decimals.filter(|d| *d > 0).or(fewest) {
                None => compare(entry, "=", &number),
                Some(digits) => {
                    let head = match printed.negative {
                        true => "agrees_down",
                        false => "agrees_up",
                    };
                    let digits = Code::atom(digits.to_string());
                    Code::apply(head, &[entry.clone(), number, digits])
                }
            });
        }
        let mut all = all.into_iter();
        let first = all.next().ok_or(Untranslatable::Construct(
            "an empty list of printed numbers",
        ))?;
        Ok(all.fold(first, |before, one| {
            Code::infix_right(&before, "/\\", &one, Level::Both)
        }))
    }
}

/// A comparison.
pub(super) fn compare(left: &Code, sign: &str, right: &Code) -> Code {
    Code::infix(
        &Code::atom(left.within(Level::Sum)),
        sign,
        right,
        Level::Relation,
    )
}

/// All of these, in this order.
pub(super) fn all_of(mut parts: Vec<Code>) -> Result<Code, Untranslatable> {
    let last = parts
        .pop()
        .ok_or(Untranslatable::Construct("an empty conjunction"))?;
    Ok(parts.iter().rfold(last, |rest, part| {
        Code::infix_right(part, "/\\", &rest, Level::Both)
    }))
}

/// A printed number.
struct Printed {
    value: Rational,
    decimals: Option<u32>,
    negative: bool,
}

impl Printed {
    fn read(expr: &Expr) -> Option<Self> {
        let (inner, negative) = match &expr.node {
            Node::Negative(inner) => (&**inner, true),
            _ => (expr, false),
        };
        let Node::Number { value, decimals } = &inner.node else {
            return None;
        };
        Some(Self {
            value: if negative {
                -value.clone()
            } else {
                value.clone()
            },
            decimals: *decimals,
            negative,
        })
    }
}
