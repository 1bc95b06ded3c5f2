//! Names for new symbols of a derivation that avoid those of the family.

use std::collections::BTreeSet;

/// Names in use.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// Starts with the names of the family.
    pub fn new(taken: impl IntoIterator<Item = String>) -> Self {
        Self {
            taken: taken.into_iter().collect(),
        }
    }

    /// Returns `wanted` with as many zeros before its digits as are needed to make it new. Such a name also differs
    /// when typeset, and no output language makes it by itself, as SymPy makes `lambda_` from a reserved word.
    pub fn fresh(&mut self, wanted: &str) -> String {
        let stem = wanted.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = wanted.get(stem.len()..).unwrap_or("");
        let mut name = wanted.to_owned();
        let mut marks = 0;
        while self.taken.contains(&name) {
            marks += 1;
            name = format!("{stem}{}{digits}", "0".repeat(marks));
        }
        self.taken.insert(name.clone());
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_taken_name_gets_zeros() {
        let mut names = Names::new(["m".to_owned(), "a11".to_owned()]);
        assert_eq!(names.fresh("m"), "m0");
        assert_eq!(names.fresh("m"), "m00");
        assert_eq!(names.fresh("a11"), "a011");
        assert_eq!(names.fresh("n"), "n");
    }
}
