//! Definitions that a printed statement and the proved one have in common, each shown to be equal once.
//!
//! Both writers define the names of a paper, so that two statements are convertible. But a comparison of whole
//! statements unfolds a definition at each of its occurrences, and those within it again: for a linear system whose
//! coefficients are derivatives of a curve this takes minutes a statement. Here each definition is compared with its
//! counterpart, after the definitions that occur in it were replaced; a statement is then rewritten by these equations
//! before it is compared. A definition without a counterpart stays as it is, and is unfolded.
//!
//! The proved statements may define a name twice, for numbers and for integers (`turn` and `turn_`). The second is the
//! first at `IZR u`, which is shown in the same way.

use crate::proposition::Proposition;
use crate::shared::{DEFINITIONS, Shared, words};
use crate::task::Goal;
use std::collections::BTreeSet;

/// An equation of a definition: its name as a theorem, the definition that it replaces, and the line that proves it.
#[derive(Debug, Clone)]
struct Equation {
    name: String,
    replaced: String,
    line: String,
}

impl Equation {
    /// The name of the definition that it replaces, without its place.
    fn definition(&self) -> &str {
        let replaced = &self.replaced;
        replaced.rsplit_once('.').map_or(replaced, |(_, name)| name)
    }
}

/// The equations of the shared definitions of a section.
#[derive(Debug, Clone, Default)]
pub(crate) struct SharedEquations {
    /// Between printed definitions and proved ones.
    between: Vec<Equation>,
    /// Between proved definitions for integers and for numbers.
    at_integers: Vec<Equation>,
}

impl SharedEquations {
    /// Compares the shared definitions of the printed statements with those of the proved ones.
    pub(crate) fn new(section: &str, printed: &Shared, core: &Shared) -> Self {
        let place = format!("{section}.{DEFINITIONS}");
        let there: Vec<Definition<'_>> = core
            .definitions()
            .iter()
            .map(|there| Definition::new(&place, &there.name, &there.text))
            .collect();
        let mut all = Self::default();
        for own in printed.definitions() {
            let own = Definition::new("", &own.name, &own.text);
            all.between
                .extend(own.same_as_counterpart(&there, &all.between));
        }
        for own in &there {
            all.at_integers
                .extend(own.at_integers(&there, &all.at_integers));
        }
        all
    }

    /// Returns the lines before all theorems about the statements of this section.
    pub(crate) fn lines(&self, printed: &str) -> String {
        let equations = self.between.iter().chain(&self.at_integers);
        let lines: String = equations.map(|equation| equation.line.as_str()).collect();
        match self.between.is_empty() {
            true => lines,
            false => format!("Import {printed}.{DEFINITIONS}.\n{lines}"),
        }
    }
}

/// The equations that the theorems of one claim are rewritten by.
#[derive(Debug, Clone, Default)]
pub(crate) struct Equations {
    /// The lines of the definitions that only this claim has.
    pub(crate) own: String,
    /// Between printed definitions and proved ones, in the order of the definitions.
    between: Vec<Equation>,
    /// Between proved definitions for integers and for numbers that occur in the statement.
    at_integers: Vec<Equation>,
}

impl Equations {
    /// Compares the definitions of one claim; `printed` and `core` are the shared ones of both sections.
    pub(crate) fn new(
        section: &str,
        shared: &SharedEquations,
        (printed, core): (&Shared, &Shared),
        (goal, proved): (&Goal, &Goal),
    ) -> Self {
        let place = format!("{section}.{}", proved.module);
        let together = format!("{section}.{DEFINITIONS}");
        let own_of_core = core.others(proved);
        let is_own = |text: &str| own_of_core.contains(&text);
        let there: Vec<Definition<'_>> = proved
            .proposition
            .definitions
            .iter()
            .map(|(name, text)| {
                let place = if is_own(text) { &place } else { &together };
                Definition::new(place, name, text)
            })
            .collect();
        let own_of_print = printed.others(goal);
        let mut all = Self::default();
        for (name, text) in &goal.proposition.definitions {
            let equation = match own_of_print.contains(&text.as_str()) {
                true => {
                    let own = Definition::new("", name, text);
                    let equation = own.same_as_counterpart(&there, &all.between);
                    all.own.extend(equation.iter().map(|own| own.line.as_str()));
                    equation
                }
                false => shared_equation(&shared.between, name),
            };
            all.between.extend(equation);
        }
        let text = proved.proposition.universal();
        let occur: BTreeSet<&str> = words(&text).collect();
        let (mut at_integers, mut own_lines) = (vec![], String::new());
        for definition in &there {
            let equation = match is_own(definition.text) {
                true => {
                    let equation = definition.at_integers(&there, &at_integers);
                    own_lines.extend(equation.iter().map(|own| own.line.as_str()));
                    equation
                }
                false => shared_equation(&shared.at_integers, definition.name),
            };
            at_integers.extend(equation);
        }
        at_integers.retain(|equation| occur.contains(equation.definition()));
        if !at_integers.is_empty() {
            all.own.push_str(&own_lines);
        }
        all.at_integers = at_integers;
        all
    }

    /// Returns the tactics that prove a statement from a proved one; `what` is the name of both.
    pub(crate) fn follows(
        &self,
        what: &str,
        printed: &Proposition,
        core: &str,
        proved: &str,
    ) -> String {
        let text = printed.universal();
        let occur: BTreeSet<&str> = words(&text).collect();
        let between = self.between.iter().rev();
        let rewritten = together(between.filter(|own| occur.contains(own.replaced.as_str())));
        let unfolded = match rewritten {
            None => String::new(),
            Some(equations) => format!("unfold {what}; use {equations}; "),
        };
        match together(self.at_integers.iter().rev()) {
            None => format!("{unfolded}follows {proved}"),
            Some(equations) => format!(
                "{unfolded}pose proof {proved} as there; unfold {core}.{what} in there; use_at {equations} there; follows there"
            ),
        }
    }
}

/// Returns the shared equation of a definition.
fn shared_equation(shared: &[Equation], name: &str) -> Option<Equation> {
    let mut shared = shared.iter();
    shared.find(|own| own.definition() == name).cloned()
}

/// A definition of a section: where it stands, its name, and its text.
struct Definition<'t> {
    place: &'t str,
    name: &'t str,
    text: &'t str,
}

impl<'t> Definition<'t> {
    fn new(place: &'t str, name: &'t str, text: &'t str) -> Self {
        Self { place, name, text }
    }

    /// Returns what stands between the name and the value: the arguments and the types.
    fn head(&self) -> &'t str {
        let rest = self.text.strip_prefix("Definition ").unwrap_or(self.text);
        let rest = rest.strip_prefix(self.name).unwrap_or(rest);
        rest.split(" :=").next().unwrap_or(rest)
    }

    /// Returns the arguments, each with its type.
    fn arguments(&self) -> Vec<(&'t str, &'t str)> {
        let parts = self.head().split(['(', ')']);
        parts
            .filter_map(|part| part.split_once(" : "))
            .filter(|(name, _)| !name.is_empty())
            .collect()
    }

    /// Whether both define the same name. Names of variants of a definition end in underscores.
    fn is_variant(&self, other: &Definition<'_>) -> bool {
        self.name.trim_end_matches('_') == other.name.trim_end_matches('_')
    }

    /// Returns the equation of a printed definition and the proved one with the same arguments, if there is one.
    fn same_as_counterpart(
        &self,
        there: &[Definition<'_>],
        earlier: &[Equation],
    ) -> Option<Equation> {
        let other = there
            .iter()
            .find(|other| other.is_variant(self) && other.head() == self.head())?;
        let value = format!("{}.{}", other.place, other.name);
        Some(self.equation("same", self.name.to_owned(), &value, earlier))
    }

    /// Returns the equation of a proved definition for integers and the one for numbers, if this is the first.
    fn at_integers(&self, there: &[Definition<'_>], earlier: &[Equation]) -> Option<Equation> {
        let arguments = self.arguments();
        let is_for_numbers = |other: &&Definition<'_>| {
            let others = other.arguments();
            let pairs = || arguments.iter().zip(&others);
            let is_real =
                |((_, own), (_, other)): &(&(_, &str), &(_, &str))| *own == "Z" && *other == "R";
            other.is_variant(self)
                && arguments.len() == others.len()
                && pairs().any(|pair| is_real(&pair))
                && pairs().all(|pair| is_real(&pair) || pair.0.1 == pair.1.1)
        };
        let other = there.iter().find(is_for_numbers)?;
        let others = other.arguments();
        let values = arguments
            .iter()
            .zip(&others)
            .map(|((name, own), (_, other))| match own == other {
                true => format!(" {name}"),
                false => format!(" (IZR {name})"),
            });
        let names: Vec<&str> = arguments.iter().map(|(name, _)| *name).collect();
        let value = format!(
            "(fun {} => {}.{}{})",
            names.join(" "),
            other.place,
            other.name,
            values.collect::<String>()
        );
        let whole = format!("{}.{}", self.place, self.name);
        Some(self.equation("at", whole, &value, earlier))
    }

    /// Writes the line that proves the definition equal to a value, or to itself if they differ, after the `earlier`
    /// equations were used in it.
    fn equation(&self, end: &str, replaced: String, value: &str, earlier: &[Equation]) -> Equation {
        let name = format!("{}_{end}", self.name);
        let used: BTreeSet<&str> = words(self.text).filter(|word| *word != self.name).collect();
        let earlier = earlier.iter();
        let by = together(earlier.filter(|equation| used.contains(equation.definition())));
        let by = by.map_or_else(String::new, |equations| format!(" by {equations}"));
        Equation {
            line: format!("Definition {name} := ltac:(same {replaced} {value}{by}).\n"),
            name,
            replaced,
        }
    }
}

/// Writes the names of equations as one term; none if there are none.
fn together<'e>(equations: impl Iterator<Item = &'e Equation>) -> Option<String> {
    let names: Vec<&str> = equations.map(|equation| equation.name.as_str()).collect();
    match names.as_slice() {
        [] => None,
        [one] => Some((*one).to_owned()),
        several => Some(format!("({})", several.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: &str = "Definition point (k : R) (u : R) : R :=\n  k * u.";
    const TURN: &str = "Definition turn (k : R) (u : R) : R :=\n  point k u ^ 2.";

    #[test]
    fn a_definition_is_compared_after_those_in_it() {
        let there = [
            Definition::new(
                "S.m",
                "point",
                "Definition point (k : R) (u : Z) : R :=\n  k * IZR u.",
            ),
            Definition::new(
                "S.m",
                "point_",
                "Definition point_ (k : R) (u : R) : R :=\n  k * u.",
            ),
            Definition::new("S.Definitions", "turn", TURN),
        ];
        let point = Definition::new("", "point", POINT).same_as_counterpart(&there, &[]);
        let point = point.expect("one of them has the same arguments");
        assert_eq!(
            point.line,
            "Definition point_same := ltac:(same point S.m.point_).\n"
        );
        let turn = Definition::new("", "turn", TURN).same_as_counterpart(&there, &[point]);
        assert_eq!(
            turn.expect("it has a counterpart").line,
            "Definition turn_same := ltac:(same turn S.Definitions.turn by point_same).\n"
        );
        let other = Definition::new("", "size", "Definition size (u : R) : R :=\n  u.");
        assert!(other.same_as_counterpart(&there, &[]).is_none());
    }

    #[test]
    fn a_definition_for_integers_is_the_one_for_numbers_there() {
        let there = [
            Definition::new("S.m", "turn", TURN),
            Definition::new(
                "S.m",
                "turn_",
                "Definition turn_ (k : R) (u : Z) : R :=\n  k.",
            ),
        ];
        let [numbers, integers] = there.each_ref().map(|own| own.at_integers(&there, &[]));
        assert!(numbers.is_none());
        assert_eq!(
            integers.expect("there is one for numbers").line,
            "Definition turn__at := ltac:(same S.m.turn_ (fun k u => S.m.turn k (IZR u))).\n"
        );
    }
}
