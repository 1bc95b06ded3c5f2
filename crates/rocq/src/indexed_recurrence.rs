//! Bases whose step depends on index and degree of the function, such as splines on any knots.
//!
//! `counted` of the library takes the two factors of the step as functions of index and degree. The premises are that
//! every factor with a nonzero coefficient is defined, from the degree of the seeds up to the given degree:
//! SEMANTICS.md, the row of the bases. So that degree has to be a number.

use crate::code::{Code, Level};
use crate::context::{Context, Kind, Local};
use crate::defined::Premises;
use crate::gap::Untranslatable;
use crate::integer::literal;
use torse_core::{Family, Node, Term, Variable};
use torse_syntax::formula::Operator;

impl Context<'_> {
    /// Writes the argument of a family for a variable of this kind.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value of the term, and if an integer is required.
    pub fn argument_of(&mut self, argument: &Term, kind: &Kind) -> Result<Code, Untranslatable> {
        match kind {
            Kind::Integer => self.index(argument),
            Kind::Value(_) => self.number(argument),
        }
    }

    /// Writes a factor of the step as a function of index and degree.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value of the factor.
    pub fn factor(
        &mut self,
        (index, degree): &(Variable, Variable),
        factor: &Term,
    ) -> Result<Code, Untranslatable> {
        let i = self.bind(index, Kind::Integer);
        let k = self.bind(degree, Kind::Integer);
        let body = self.number(factor);
        self.release(degree);
        self.release(index);
        let text = format!("fun {i} {k} => {}", body?.text());
        Ok(Code::new(text, Level::Open))
    }

    /// Adds the premises under which all factors that are used up to this degree have values; the variables of the
    /// family are in scope.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values of the factors, and for degrees that are not numbers.
    pub fn factors_defined(
        &mut self,
        family: &Family,
        (index, degree): &(Variable, Variable),
        highest: &Term,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let highest = literal(highest).or_else(|| self.constant_value(highest));
        let highest = highest.ok_or(Untranslatable::Construct(
            "a basis of symbolic degree whose step depends on the index",
        ))?;
        let integer = |number: i64| Local {
            code: Code::atom(format!("{number}%Z")),
            kind: Kind::Integer,
        };
        for k in i64::from(family.degree) + 1..=highest {
            self.bind_to(degree, integer(k));
            for i in 0..=k {
                self.bind_to(index, integer(i));
                if i < k {
                    self.defined(&family.step.0, premises)?;
                }
                if i > 0 {
                    self.defined(&family.step.1, premises)?;
                }
            }
        }
        Ok(())
    }

    /// Returns the integer value of a term whose variables stand for literal integers.
    #[must_use]
    pub fn constant_value(&self, term: &Term) -> Option<i64> {
        match &*term.node {
            Node::Variable(variable) => {
                let local = self.local(variable).ok()?;
                let text = local.code.text().strip_suffix("%Z")?;
                text.parse().ok().filter(|_| local.kind == Kind::Integer)
            }
            Node::Negative(inner) => self.constant_value(inner)?.checked_neg(),
            Node::Opened { body, .. } => self.constant_value(body),
            Node::Binary(operator, a, b) => {
                let (a, b) = (self.constant_value(a)?, self.constant_value(b)?);
                match operator {
                    Operator::Add => a.checked_add(b),
                    Operator::Subtract => a.checked_sub(b),
                    Operator::Multiply => a.checked_mul(b),
                    Operator::Divide | Operator::Power => None,
                }
            }
            _ => literal(term),
        }
    }
}
