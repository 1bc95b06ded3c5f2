//! Formulas that are integers by their form: indices, degrees, bounds of sums, orders, exponents.

use super::kinds::Kind;
use super::scope::Scope;
use super::writer::Writer;
use crate::code::{Code, Level, integer_scope};
use crate::gap::Untranslatable;
use torse_numbers::{Affine, rational};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node, Operator};

impl Writer<'_> {
    /// The formula in the scope of integers, if it is made of integers by sums, differences and products.
    pub fn integer(&self, expr: &Expr, scope: &Scope) -> Option<Code> {
        match &expr.node {
            Node::Number { value, .. } if value.is_integer() => Some(Code::rational(value)),
            Node::Name(name) => {
                if let Some(local) = scope.locals.get(name) {
                    if let Some(number) = self.constant_value(expr, scope) {
                        return Some(Code::rational(&rational::integer(number)));
                    }
                    return (local.kind == Kind::Integer).then(|| local.code.clone());
                }
                if let Some(definition) = self.names.declarations.definition(name) {
                    let plain = definition.parameters.is_empty();
                    return plain.then(|| self.integer(&definition.body.expr, &scope.outside()))?;
                }
                match self.names.declarations.symbol(name)? {
                    SymbolKind::Integer { .. } => self.standing(name, scope).ok(),
                    _ => None,
                }
            }
            Node::Negative(inner) => {
                let inner = self.integer(inner, scope)?;
                let text = format!("- {}", inner.within(Level::Negative));
                Some(Code::new(text, Level::Negative))
            }
            Node::Binary(operator, a, b) => {
                // What stands for literal integers is reckoned out, what is printed is not.
                if let (Some(number), None) =
                    (self.constant_value(expr, scope), self.literal(expr, scope))
                {
                    return Some(Code::rational(&rational::integer(number)));
                }
                let (a, b) = (self.integer(a, scope)?, self.integer(b, scope)?);
                let (sign, level) = match operator {
                    Operator::Add => ("+", Level::Sum),
                    Operator::Subtract => ("-", Level::Sum),
                    Operator::Multiply => ("*", Level::Product),
                    Operator::Divide | Operator::Power => return None,
                };
                Some(Code::infix(&a, sign, &b, level))
            }
            _ => None,
        }
    }

    /// An integer as an argument.
    ///
    /// # Errors
    /// [`Untranslatable::Construct`] for what is no integer by its form.
    pub fn index(&self, expr: &Expr, scope: &Scope) -> Result<Code, Untranslatable> {
        let code = self.integer(expr, scope);
        let code = code.ok_or(Untranslatable::Construct(
            "an index that is not made of integers",
        ))?;
        Ok(Code::atom(integer_scope(&code)))
    }

    /// The number that a formula of integers is worth, through what stands for local names.
    pub fn constant_value(&self, expr: &Expr, scope: &Scope) -> Option<i64> {
        self.reckoned(expr, scope, true)
    }

    /// A literal integer, through definitions.
    pub fn literal(&self, expr: &Expr, scope: &Scope) -> Option<i64> {
        self.reckoned(expr, scope, false)
    }

    fn reckoned(&self, expr: &Expr, scope: &Scope, through_locals: bool) -> Option<i64> {
        match &expr.node {
            Node::Number { value, .. } if value.is_integer() => {
                value.numer().to_string().parse().ok()
            }
            Node::Name(name) => {
                if let Some(local) = scope.locals.get(name) {
                    let text = local.code.text().strip_suffix("%Z")?;
                    return text.parse().ok().filter(|_| through_locals);
                }
                let definition = self.names.declarations.definition(name)?;
                let plain = definition.parameters.is_empty();
                plain.then(|| {
                    self.reckoned(&definition.body.expr, &scope.outside(), through_locals)
                })?
            }
            Node::Negative(inner) => self.reckoned(inner, scope, through_locals)?.checked_neg(),
            Node::Binary(operator, a, b) => {
                let a = self.reckoned(a, scope, through_locals)?;
                let b = self.reckoned(b, scope, through_locals)?;
                match operator {
                    Operator::Add => a.checked_add(b),
                    Operator::Subtract => a.checked_sub(b),
                    Operator::Multiply => a.checked_mul(b),
                    Operator::Divide | Operator::Power => None,
                }
            }
            _ => None,
        }
    }

    /// An integer-affine form in the scope of integers.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for a symbol that the claim does not declare.
    pub fn affine(&self, form: &Affine) -> Result<String, Untranslatable> {
        let mut text = String::new();
        for (symbol, multiple) in form.multiples() {
            let name = self.symbol(symbol)?;
            text.push_str(match (multiple < 0, text.is_empty()) {
                (true, true) => "- ",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            });
            match multiple.unsigned_abs() {
                1 => text.push_str(name),
                n => text.push_str(&format!("{n} * {name}")),
            }
        }
        let constant = form.constant();
        Ok(match (text.is_empty(), constant) {
            (true, constant) => constant.to_string(),
            (false, 0) => text,
            (false, ..0) => format!("{text} - {}", constant.unsigned_abs()),
            (false, _) => format!("{text} + {constant}"),
        })
    }

    /// Whether a formula is literally the number 0, which fits every shape.
    pub fn is_zero(&self, expr: &Expr, scope: &Scope) -> bool {
        match &expr.node {
            Node::Number { value, .. } => *value == rational::integer(0),
            Node::Name(name) if !scope.locals.contains_key(name) => {
                let definition = self.names.declarations.definition(name);
                definition.is_some_and(|definition| {
                    definition.parameters.is_empty()
                        && self.is_zero(&definition.body.expr, &scope.outside())
                })
            }
            _ => false,
        }
    }
}
