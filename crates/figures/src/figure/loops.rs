//! Loops: `for = [{ mu = ["1", "0"], nu = ["1", "0"] }, { i = ["0", "1"] }]`.
//!
//! Names of one table run in step, tables are nested. The values of a round are fixed one after the other, so
//! that an inner loop may use an outer one.

use super::Faulty;
use super::environment::{Environment, complaint};
use super::reader::Reader;
use std::collections::BTreeMap;
use toml::Spanned;
use torse_algebra::Fraction;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::schema::figure::Loop;
use torse_syntax::derivation::{DerivationError, Origin};
use torse_syntax::formula::Place;

/// The most rounds of the loops of one panel or layer.
const MAX_ROUNDS: usize = 400;

/// One round of nested loops.
#[derive(Clone)]
pub(super) struct Round<'a> {
    pub environment: Environment<'a>,
    /// The texts of the values, for captions.
    pub values: BTreeMap<String, String>,
    /// The round of the outermost loop; none without a loop.
    pub number: Option<usize>,
}

impl<'a> Round<'a> {
    /// Makes the only round without a loop.
    pub fn only(environment: Environment<'a>) -> Self {
        Self {
            environment,
            values: BTreeMap::new(),
            number: None,
        }
    }

    /// Returns the rounds of loops inside this round. Loops over a name in `free` are left out.
    pub fn rounds(&self, loops: &[Loop], free: &[String]) -> Faulty<Vec<Round<'a>>> {
        let mut rounds = vec![Round {
            number: None,
            ..self.clone()
        }];
        for names in loops
            .iter()
            .filter(|l| !l.keys().any(|name| free.contains(name)))
        {
            let mut inner = vec![];
            for round in &rounds {
                inner.extend(round.steps(names)?);
                if let Some(list) = names.values().next()
                    && inner.len() > MAX_ROUNDS
                {
                    return Err(round.fault(list, format!("more than {MAX_ROUNDS} rounds")));
                }
            }
            rounds = inner;
        }
        Ok(rounds)
    }

    fn steps(&self, names: &Loop) -> Faulty<Vec<Round<'a>>> {
        let mut lists = vec![];
        for (name, list) in names {
            lists.push((name, list, self.values_of(name, list)?));
        }
        let length = lists.iter().map(|(_, _, values)| values.len()).max();
        let mut steps = vec![];
        for step in 0..length.unwrap_or(0) {
            let mut round = self.clone();
            round.number = self.number.or(Some(step));
            for (name, list, values) in &lists {
                let Some((value, text)) = values.get(step) else {
                    let message = format!(
                        "`{name}` has fewer values than the other names of the same loop: {}",
                        values.len()
                    );
                    return Err(self.fault(list, message));
                };
                round.environment.fix(name, value.clone());
                round.values.insert((*name).clone(), text.clone());
            }
            steps.push(round);
        }
        Ok(steps)
    }

    /// Returns the values of a name, each with its text: numbers, and ranges of integers such as `0..k`.
    fn values_of(&self, name: &str, list: &Spanned<Vec<Text>>) -> Faulty<Vec<(Fraction, String)>> {
        let environment = &self.environment;
        let reader = Reader::new(environment);
        let mut values = vec![];
        for text in list.get_ref() {
            environment.declared(name, text)?;
            if text.get_ref().contains("..") {
                let [low, high] = reader.integers(text, text.get_ref())?.ok_or_else(|| {
                    let message =
                        format!("`{}` is no range of integers with values", text.get_ref());
                    Box::new(complaint(environment.source, text, message))
                })?;
                values.extend((low..=high).map(|n| (Fraction::integer(n), n.to_string())));
            } else {
                values.push((reader.number(text)?, text.get_ref().clone()));
            }
            if values.len() > MAX_ROUNDS {
                return Err(self.fault(list, format!("more than {MAX_ROUNDS} rounds")));
            }
        }
        Ok(values)
    }

    fn fault(&self, list: &Spanned<Vec<Text>>, message: String) -> Box<DerivationError> {
        let range = list.span();
        let origin = Origin::range(self.environment.source, range.start, range.end);
        Box::new(DerivationError::at(&origin, Place::default(), message))
    }

    /// Whether both rounds belong to the same outer round and have the same values.
    pub fn is_like(&self, other: &Self) -> bool {
        self.environment.fixed() == other.environment.fixed()
    }

    /// Replaces `{name}` in a text by the values of this round.
    pub fn filled(&self, template: &str) -> String {
        self.values
            .iter()
            .fold(template.to_owned(), |text, (name, value)| {
                text.replace(&format!("{{{name}}}"), value)
            })
    }
}
