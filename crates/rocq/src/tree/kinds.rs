//! Which parameters of definitions and bases are integers: those that stand in an index, a degree, a bound of a sum, an
//! order, an exponent, or at such a place of another definition. All others are values of the shape that they are
//! called with.

use super::reach::{Bound, Names, with};
use crate::shape::Shape;
use torse_syntax::formula::{Expr, Node, Operator};

/// What a bound name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// An integer, of type `Z`.
    Integer,
    /// A number, a vector or a matrix.
    Value(Shape),
}

impl Kind {
    /// The type in Rocq.
    pub fn rocq_type(self) -> &'static str {
        match self {
            Self::Integer => "Z",
            Self::Value(shape) => shape.rocq_type(),
        }
    }

    /// A real number.
    pub const NUMBER: Self = Self::Value(Shape::Number);

    fn integer(is_integer: bool) -> Self {
        match is_integer {
            true => Self::Integer,
            false => Self::NUMBER,
        }
    }
}

/// How deep definitions are looked through.
const MAX_DEPTH: usize = 80;

impl Names<'_> {
    /// The kinds of the parameters of a definition.
    pub fn kinds_of_definition(&self, name: &str) -> Vec<Kind> {
        self.kinds_of_definition_at(name, 0)
    }

    fn kinds_of_definition_at(&self, name: &str, depth: usize) -> Vec<Kind> {
        let Some(definition) = self.declarations.definition(name) else {
            return vec![];
        };
        let kind = |parameter: &String| {
            let uses = || {
                let search = Search {
                    names: self,
                    name: parameter,
                    depth: depth + 1,
                };
                depth < MAX_DEPTH && search.finds(&definition.body.expr, false, &Bound::new())
            };
            Kind::integer(definition.indexed || uses())
        };
        definition.parameters.iter().map(kind).collect()
    }

    /// The kinds of the variable and the shape parameters of a basis.
    pub fn kinds_of_basis(&self, name: &str) -> Vec<Kind> {
        self.kinds_of_basis_at(name, 0)
    }

    fn kinds_of_basis_at(&self, name: &str, depth: usize) -> Vec<Kind> {
        let Some(basis) = self.declarations.basis(name) else {
            return vec![];
        };
        let counters = basis.counters.iter().flat_map(|(i, k)| [i, k]);
        let counters: Bound = counters.cloned().collect();
        let kind = |parameter: &String| {
            let search = Search {
                names: self,
                name: parameter,
                depth: depth + 1,
            };
            let in_seeds = || {
                let mut seeds = basis.seeds.iter();
                seeds.any(|seed| search.finds(&seed.expr, false, &Bound::new()))
            };
            let in_step = || {
                let mut step = [&basis.step.0, &basis.step.1].into_iter();
                !counters.contains(parameter)
                    && step.any(|factor| search.finds(&factor.expr, false, &Bound::new()))
            };
            Kind::integer(depth < MAX_DEPTH && (in_seeds() || in_step()))
        };
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        names.map(kind).collect()
    }

    /// The kinds of the parameters of what is applied.
    fn kinds_of_function(&self, head: &Expr, bound: &Bound, depth: usize) -> Vec<Kind> {
        match &head.node {
            Node::Name(name) if !bound.contains(name) => {
                if let Some(definition) = self.declarations.definition(name) {
                    return match definition.parameters.is_empty() {
                        true if depth < MAX_DEPTH => {
                            self.kinds_of_function(&definition.body.expr, &Bound::new(), depth + 1)
                        }
                        _ => self.kinds_of_definition_at(name, depth),
                    };
                }
                let base = name.trim_end_matches('\'');
                match base.len() < name.len() {
                    true => self.kinds_of_function(&Expr::name(base), bound, depth),
                    false => vec![],
                }
            }
            Node::Call(inner, arguments) => {
                match (self.built_in(inner, bound), arguments.as_slice()) {
                    (Some("D" | "at"), [function, ..]) => {
                        self.kinds_of_function(function, bound, depth)
                    }
                    _ => vec![],
                }
            }
            _ => vec![],
        }
    }
}

/// The search for a name where an integer is wanted.
struct Search<'n, 'a> {
    names: &'n Names<'a>,
    name: &'n str,
    depth: usize,
}

impl Search<'_, '_> {
    /// Whether the name stands where an integer is wanted; `wanted` says whether the formula itself does.
    fn finds(&self, expr: &Expr, wanted: bool, bound: &Bound) -> bool {
        match &expr.node {
            Node::Name(name) => wanted && name == self.name && !bound.contains(name),
            Node::Negative(inner) => self.finds(inner, wanted, bound),
            Node::Binary(operator, a, b) => match operator {
                Operator::Add | Operator::Subtract | Operator::Multiply => {
                    self.finds(a, wanted, bound) || self.finds(b, wanted, bound)
                }
                Operator::Divide => self.finds(a, false, bound) || self.finds(b, false, bound),
                Operator::Power => self.finds(a, false, bound) || self.finds(b, true, bound),
            },
            Node::Index(head, indices) => {
                self.finds(head, false, bound) || self.any(indices, true, bound)
            }
            Node::Call(head, arguments) => self.call(head, arguments, bound),
            _ => expr
                .parts()
                .into_iter()
                .any(|e| self.finds(e, false, bound)),
        }
    }

    fn any(&self, exprs: &[Expr], wanted: bool, bound: &Bound) -> bool {
        exprs.iter().any(|e| self.finds(e, wanted, bound))
    }

    fn call(&self, head: &Expr, arguments: &[Expr], bound: &Bound) -> bool {
        if let Node::Index(family, indices) = &head.node
            && let Node::Name(name) = &family.node
            && self.names.basis(name, bound).is_some()
        {
            let kinds = self.names.kinds_of_basis_at(name, self.depth);
            return self.any(indices, true, bound) || self.given(arguments, &kinds, bound);
        }
        let finds = |e: &Expr, wanted| self.finds(e, wanted, bound);
        match (self.names.built_in(head, bound), arguments) {
            (Some("sum" | "product"), [index, low, high, term]) => {
                finds(low, true)
                    || finds(high, true)
                    || self.finds(term, false, &with(bound, index))
            }
            (Some("integral"), [body, variable, low, high]) => {
                finds(low, false)
                    || finds(high, false)
                    || self.finds(body, false, &with(bound, variable))
            }
            (Some("at"), [inner, variable, point]) => {
                finds(point, false) || self.finds(inner, false, &with(bound, variable))
            }
            (Some("D"), [inner, rest @ ..]) => {
                finds(inner, false) || rest.get(1).is_some_and(|order| finds(order, true))
            }
            (Some("binom"), [n, j]) => finds(n, false) || finds(j, true),
            (Some("factorial" | "identity"), [n]) => finds(n, true),
            (Some(_), _) => self.any(arguments, false, bound),
            (None, _) => {
                let kinds = self.names.kinds_of_function(head, bound, self.depth);
                self.finds(head, false, bound) || self.given(arguments, &kinds, bound)
            }
        }
    }

    /// Arguments for parameters of these kinds.
    fn given(&self, arguments: &[Expr], kinds: &[Kind], bound: &Bound) -> bool {
        let wanted = |place: usize| kinds.get(place) == Some(&Kind::Integer);
        let mut arguments = arguments.iter().enumerate();
        arguments.any(|(place, argument)| self.finds(argument, wanted(place), bound))
    }
}
