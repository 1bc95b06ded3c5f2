//! Evaluates the formulas of a figure with the values of its symbols.

use super::Faulty;
use super::environment::{Environment, MAX_POINTS, evaluated, fraction, wrong};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_algebra::Fraction;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::{DerivationError, Origin, Source, Written, parsed};
use torse_syntax::formula;

/// Evaluates formulas in an environment: all formulas of one reader expand a definition once.
pub(super) struct Reader<'e> {
    /// The file of the formulas.
    pub source: &'e Arc<Source>,
    environment: &'e Environment<'e>,
    evaluator: Evaluator<'e>,
}

impl<'e> Reader<'e> {
    /// Makes a reader for formulas of this environment.
    pub fn new(environment: &'e Environment<'_>) -> Self {
        Self {
            source: environment.source,
            environment,
            evaluator: environment.evaluator(),
        }
    }

    /// Makes the same reader with values for more numbers or integers.
    pub fn fixing(&self, more: &BTreeMap<String, Fraction>) -> Self {
        Self {
            source: self.source,
            environment: self.environment,
            evaluator: self.evaluator.fixing(more),
        }
    }

    /// Returns the kind of a symbol that a text names.
    pub fn declared(&self, name: &str, text: &Text) -> Faulty<&SymbolKind> {
        self.environment.declared(name, text)
    }

    /// Evaluates a formula of the file.
    pub fn value(&self, text: &Text) -> Faulty<Value> {
        let formula = parsed(self.source, text)?;
        self.evaluated(&formula)
    }

    /// Evaluates a parsed formula.
    pub fn evaluated(&self, formula: &Written) -> Faulty<Value> {
        evaluated(&self.evaluator, formula)
    }

    /// Returns the number that a formula of the file evaluates to.
    pub fn number(&self, text: &Text) -> Faulty<Fraction> {
        match self.value(text)? {
            Value::Scalar(quantity) => fraction(self.source, text, &quantity),
            other => Err(wrong(self.source, text, other.kind(), "a number")),
        }
    }

    /// Evaluates `formula`, a part of a text of the file.
    pub fn part(&self, text: &Text, formula: &str) -> Faulty<Value> {
        let offset = text.get_ref().find(formula).unwrap_or(0);
        let origin = Origin::from_spanned(self.source, text).after(offset);
        let expr = formula::parse(formula)
            .map_err(|error| Box::new(DerivationError::syntax(&origin, &error)))?;
        self.evaluated(&Written { expr, origin })
    }

    /// Returns the ends of `range`, a part of a text of the file such as `0..k`; none if it has another form, is empty,
    /// or longer than a list may be.
    pub fn integers(&self, text: &Text, range: &str) -> Faulty<Option<[i64; 2]>> {
        let Some((low, high)) = range.split_once("..") else {
            return Ok(None);
        };
        let integer = |formula: &str| -> Faulty<Option<i64>> {
            let Value::Scalar(quantity) = self.part(text, formula)? else {
                return Ok(None);
            };
            let value = fraction(self.source, text, &quantity)?.as_rational();
            let whole = value.filter(torse_algebra::Rational::is_integer);
            Ok(whole.and_then(|n| i64::try_from(n.to_integer()).ok()))
        };
        Ok(match (integer(low)?, integer(high)?) {
            (Some(low), Some(high)) if low <= high && high.saturating_sub(low) < MAX_POINTS => {
                Some([low, high])
            }
            _ => None,
        })
    }
}
