//! Properties of bases: at every degree from that of the seeds on, for the values of the variables outside.

use super::said::all_of;
use super::scope::Scope;
use super::writer::Writer;
use crate::code::{Code, Level};
use crate::gap::Gap;
use crate::interval::within;
use torse_numbers::rational;
use torse_syntax::derivation::declarations::{Basis, SymbolKind};
use torse_syntax::formula::{Expr, Node, Relation};

impl Writer<'_> {
    /// A basis by its name.
    fn basis_named(&self, expr: &Expr) -> Result<(String, &Basis), Gap> {
        let Node::Name(name) = &expr.node else {
            return Err(Gap::Unread("a property of what is no basis".to_owned()));
        };
        let basis = self.names.declarations.basis(name);
        let basis = basis.ok_or_else(|| Gap::Unread(format!("`{name}` is no basis")))?;
        Ok((name.clone(), basis))
    }

    /// The functions of a list, if a name is one.
    pub fn listed(&self, expr: &Expr) -> Option<Vec<Expr>> {
        let (name, basis) = self.basis_named(expr).ok()?;
        let number = |n: u8| Expr::number(&rational::integer(i64::from(n)));
        let member = |i| {
            let indices = vec![number(i), number(basis.degree)];
            Expr::made(Node::Index(Expr::name(&name).into(), indices))
        };
        basis
            .is_list
            .then(|| (0..=basis.degree).map(member).collect())
    }

    /// That all functions of a basis are nonnegative.
    ///
    /// # Errors
    /// [`Gap`], as for the basis.
    pub fn nonnegative(&mut self, basis: &Expr, scope: &Scope) -> Result<Code, Gap> {
        if let Some(members) = self.listed(basis) {
            let mut parts = vec![];
            for member in members {
                let zero = Expr::number(&rational::integer(0));
                let compared = Node::Compare(member.into(), vec![(Relation::AtLeast, zero)]);
                parts.push(self.said(&Expr::made(compared), &scope.outside(), None)?);
            }
            return all_of(parts);
        }
        let (name, _) = self.basis_named(basis)?;
        let family = self.applied_family(&name, scope)?;
        let Family {
            function,
            i,
            k,
            lowest,
            ..
        } = family;
        let function = function.text();
        let text = format!("forall {i} {k} : Z, ({lowest} <= {k})%Z -> 0 <= {function}");
        Ok(Code::new(text, Level::Open))
    }

    /// That the functions of each degree are linearly independent on the interval.
    ///
    /// # Errors
    /// [`Gap`], as for the basis.
    pub fn independent(&mut self, basis: &Expr, scope: &Scope) -> Result<Code, Gap> {
        if self.listed(basis).is_some() {
            return Err(Gap::Construct("the independence of a list"));
        }
        let (name, _) = self.basis_named(basis)?;
        let Family {
            function,
            variable,
            i,
            k,
            c,
            lowest,
        } = self.applied_family(&name, scope)?;
        let declarations = self.names.declarations;
        let x = declarations
            .basis(&name)
            .map_or("", |basis| &basis.variable);
        let inside = match declarations.symbol(x) {
            Some(SymbolKind::Real(interval)) => within(&variable, interval),
            _ => None,
        };
        let inside = inside.map_or(String::new(), |code| format!("{} -> ", code.text()));
        let text = format!(
            "forall ({k} : Z) ({c} : Z -> R), ({lowest} <= {k})%Z -> \
             (forall {variable} : R, {inside}sum 0 {k} (fun {i} => {c} {i} * {}) = 0) -> \
             forall {i} : Z, (0 <= {i} <= {k})%Z -> {c} {i} = 0",
            function.argument()
        );
        Ok(Code::new(text, Level::Open))
    }

    /// A basis at the values of its variables outside, and names for what is quantified.
    fn applied_family(&mut self, name: &str, scope: &Scope) -> Result<Family, Gap> {
        let basis = self.names.declarations.basis(name);
        let basis = basis.ok_or_else(|| Gap::Unread(format!("`{name}` is no basis")))?;
        if basis.counters.is_some() {
            return Err(Gap::Construct(
                "a property of a basis whose step depends on the index",
            ));
        }
        let head = self.family(name, basis)?;
        let outside = scope.outside();
        let mut all = self.with_symbols(&head, &outside)?;
        for variable in std::iter::once(&basis.variable).chain(&basis.parameters) {
            all.push(self.standing(variable, &outside)?);
        }
        let mut taken: std::collections::BTreeSet<String> = all
            .iter()
            .flat_map(|code| super::scope::words(code.text()))
            .collect();
        taken.insert(head.name.clone());
        let [i, k, c] = ["i", "k", "c"].map(|like| super::writer::fresh(like, &taken));
        all.extend([Code::atom(&i), Code::atom(&k)]);
        Ok(Family {
            function: Code::apply(&head.name, &all),
            variable: self.standing(&basis.variable, &outside)?.text().to_owned(),
            i,
            k,
            c,
            lowest: basis.degree,
        })
    }
}

/// A basis at the values of its variables.
struct Family {
    function: Code,
    variable: String,
    i: String,
    k: String,
    c: String,
    lowest: u8,
}
