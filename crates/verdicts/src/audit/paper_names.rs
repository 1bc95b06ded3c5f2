//! Reads a formula of the paper's text with the declarations of a claim.
//!
//! The text is set as the letter sets it, and its LaTeX is read by what the letters of the claim are printed as. Papers
//! leave out what the files have to write: the shape parameters of a basis function, the bounds of a sum the second
//! time, the place at which a curve is taken in a whole paragraph. Each is filled in from the statement, if that has
//! it in one way only.

use super::formulas::{Formulas, visit_parts};
use super::passages::split_outside_brackets;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::derivation::{Claim, latex_names};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::latex::{LatexKind, LatexNames, read_latex};
use torse_syntax::notation;
use torse_typography::quoted_formula;

/// How the paper prints the names of a claim, and what it leaves out.
#[derive(Debug)]
pub(super) struct PaperNames {
    declarations: Arc<Declarations>,
    /// The names of the statement itself, those that it reaches, and all.
    names: [LatexNames; 3],
    /// The arguments of basis functions after the first one, by the first; none if they differ.
    parameters: BTreeMap<String, Option<Vec<Expr>>>,
    /// The bounds of sums by their variables; none if they differ.
    bounds: BTreeMap<String, Option<[String; 2]>>,
}

impl PaperNames {
    /// Collects the names of a claim.
    pub(super) fn new(claim: &Claim) -> Self {
        let formulas = Formulas::new(claim);
        let all = latex_names(&claim.declarations);
        let chosen = |wanted: &dyn Fn(&str) -> bool| {
            let mut names = LatexNames::default();
            for (name, kind) in all.kinds().filter(|(name, _)| wanted(name)) {
                names.declare(name, kind.clone());
                // Words are typed without the faces of the letters.
                if let Some(printed) = all.printed(name) {
                    names.display(name, &faceless(printed));
                }
            }
            names
        };
        let own: BTreeSet<&str> = formulas.own.iter().flat_map(|tree| tree.names()).collect();
        let mut read = Self {
            declarations: Arc::clone(&claim.declarations),
            names: [
                chosen(&|name| own.contains(name)),
                chosen(&|name| formulas.names.contains(name)),
                chosen(&|_| true),
            ],
            parameters: BTreeMap::new(),
            bounds: BTreeMap::new(),
        };
        for tree in &formulas.reached {
            visit_parts(tree, &mut |part| read.note(part));
        }
        // A term of a sum may stand alone.
        for variable in read.bounds.keys() {
            for names in &mut read.names {
                if names.kind(variable).is_none() {
                    names.declare(variable, LatexKind::Number);
                }
            }
        }
        read
    }

    /// Notes what the paper may leave out of a formula.
    fn note(&mut self, part: &Expr) {
        let Node::Call(head, arguments) = &part.node else {
            return;
        };
        match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [variable, low, high, _]) if name == "sum" => {
                let bounds = [notation::text(low), notation::text(high)];
                let known = self.bounds.entry(notation::text(variable));
                let known = known.or_insert_with(|| Some(bounds.clone()));
                if known.as_ref() != Some(&bounds) {
                    *known = None;
                }
            }
            (Node::Index(..), [place, parameters @ ..]) if !parameters.is_empty() => {
                let parameters: Vec<Expr> = parameters.iter().map(Expr::placeless).collect();
                let known = self.parameters.entry(notation::text(place));
                let known = known.or_insert_with(|| Some(parameters.clone()));
                if known.as_ref() != Some(&parameters) {
                    *known = None;
                }
            }
            _ => {}
        }
    }

    /// The formula with numbers for those variables of sums that are no names of the claim.
    pub(super) fn with_numbers(&self, tree: &Expr) -> Expr {
        if let Node::Name(name) = &tree.node
            && self.declarations.symbol(name).is_none()
            && let Some(place) = self.bounds.keys().position(|variable| variable == name)
        {
            let number = i64::try_from(place).unwrap_or(0) + 1;
            return Expr::number(&torse_algebra::rational::integer(number));
        }
        tree.with_parts(|part| self.with_numbers(part))
    }

    /// The readings of a formula; none if it is not understood.
    pub(super) fn readings(&self, text: &str) -> Vec<Expr> {
        // A product may be continued with a cross behind the end of a line, and the place of a curve be left out.
        let continued = text.replace('×', " ");
        let without_place = text.replace("(u)", "");
        let bounded = self.bounded(text);
        for names in &self.names {
            for text in [text, &bounded, &continued, &without_place] {
                let Ok(read) = read_latex(&quoted_formula(text), names) else {
                    continue;
                };
                let others = read.others.into_iter().map(|(_, other)| other);
                let all = [read.statement].into_iter().chain(others);
                let all = all.map(|own| self.completed(&own.formula));
                // The variables of a sum in the formula are bound by it.
                return all
                    .flat_map(|tree| [self.with_numbers(&tree), tree])
                    .collect();
            }
        }
        let inside = text
            .strip_prefix('(')
            .and_then(|text| text.strip_suffix(')'));
        let entries = inside.map(|text| split_outside_brackets(text, ","));
        let entries = entries.filter(|entries| entries.len() > 1);
        let entries = entries.and_then(|entries| {
            let first = |text: &str| self.readings(text.trim()).into_iter().next();
            entries
                .into_iter()
                .map(first)
                .collect::<Option<Vec<Expr>>>()
        });
        entries
            .map(|entries| Expr::made(Node::List(entries)))
            .into_iter()
            .collect()
    }

    /// The text with the bounds of its sums that have none.
    fn bounded(&self, text: &str) -> String {
        let mut text = text.to_owned();
        for (variable, bounds) in &self.bounds {
            if let Some([low, high]) = bounds {
                let with = format!("sum_{{{variable}={low}}}^{{{high}}} ");
                text = text.replace(&format!("sum_{variable} "), &with);
            }
        }
        text
    }

    /// The formula with the parameters of its basis functions, each of the family that has its degree.
    fn completed(&self, tree: &Expr) -> Expr {
        let tree = tree.with_parts(|part| self.completed(part));
        let Node::Call(head, arguments) = &tree.node else {
            return tree;
        };
        let (Node::Index(family, indices), [place]) = (&head.node, arguments.as_slice()) else {
            return tree;
        };
        let (Node::Name(family), [_, degree]) = (&family.node, indices.as_slice()) else {
            return tree;
        };
        let Some(family) = self.family(family, degree) else {
            return tree;
        };
        let mut arguments = vec![place.clone()];
        let basis = self.declarations.basis(family);
        if basis.is_some_and(|basis| !basis.parameters.is_empty())
            && let Some(Some(parameters)) = self.parameters.get(&notation::text(place))
        {
            arguments.extend(parameters.iter().cloned());
        }
        let head = Expr::made(Node::Index(Arc::new(Expr::name(family)), indices.clone()));
        Expr::made(Node::Call(Arc::new(head), arguments))
    }

    /// Of the families that are printed with one letter, the one that has functions of this degree: the one that
    /// begins with the greatest degree.
    fn family(&self, read: &str, degree: &Expr) -> Option<&str> {
        let declarations = &self.declarations;
        let letter = |name: &str| {
            let display = declarations.display(name);
            display.map_or_else(
                || name.to_owned(),
                |display| display.trim_matches('$').to_owned(),
            )
        };
        let degree = match &degree.node {
            Node::Number { value, .. } if value.is_integer() => value.to_integer().try_into().ok(),
            _ => None,
        };
        let alike = declarations
            .bases()
            .filter(|(name, _)| letter(name) == letter(read));
        let fits = alike.filter(|(_, basis)| {
            let least = i64::from(basis.degree);
            degree.is_none_or(|degree: i64| least <= degree)
        });
        fits.max_by_key(|(_, basis)| basis.degree)
            .map(|(name, _)| name)
    }
}

/// The printed form of a name with no face: of `\mathbf{p}_0` only `p_0`.
fn faceless(printed: &str) -> String {
    let letters = printed.replace("\\mathbf{", "{");
    letters
        .replace("\\boldsymbol{", "{")
        .replace("\\mathrm{", "{")
}
