//! Names that Rocq accepts.

use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Words of Rocq and names of its libraries that statements use: a bound variable of that name would hide them.
const TAKEN: &str = "
    as at cofix else end exists exists2 fix for forall fun if IF in let match mod return then using where with by
    Set Prop SProp Type Definition Theorem Module Section Variable Parameter Axiom Lemma End Proof Qed Import Require
    R Z N nat list bool PI IZR INR sin cos sqrt Rabs True False not and or eq true false map seq fst snd nil cons app
    length nth rev sum vsum range basis fam counted counted_fam binom factorial entry row dot cross norm det transpose identity inverse
    solve agrees_up agrees_down zeros mzeros vadd vsub vopp vscale vdiv madd msub mopp mscale mdiv mvec mmul
    Derive_n vDerive ex_derive_n smooth locally powerRZ fact linear update1 update2 statement printed corrected instance
    refuted O S I C D E le lt ge gt plus minus mult pow id left right";

static WORDS: LazyLock<BTreeSet<&str>> = LazyLock::new(|| TAKEN.split_whitespace().collect());

/// A supply of distinct names.
#[derive(Debug, Clone, Default)]
pub struct Names {
    used: BTreeSet<String>,
}

impl Names {
    /// Returns a name that looks like this one and was not returned before.
    pub fn fresh(&mut self, like: &str) -> String {
        let base = identifier(like);
        let mut name = base.clone();
        while WORDS.contains(name.as_str()) || self.used.contains(&name) {
            name.push('_');
        }
        self.used.insert(name.clone());
        name
    }

    /// Reserves the name.
    pub fn reserve(&mut self, name: &str) {
        self.used.insert(name.to_owned());
    }

    /// Frees the name.
    pub fn release(&mut self, name: &str) {
        self.used.remove(name);
    }
}

/// Makes an identifier of a text: letters, digits, underscores and primes, no digit or prime first.
#[must_use]
pub fn identifier(text: &str) -> String {
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || c == '\'' {
            c
        } else {
            '_'
        }
    };
    let name: String = text.chars().map(plain).collect();
    match name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        true => name,
        false => format!("v{name}"),
    }
}

/// Writes the words of a text in capitals, as the name of a file: `gbt-developable` becomes `GbtDevelopable`.
#[must_use]
pub fn camel(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric());
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map_or_else(String::new, |first| {
            first.to_ascii_uppercase().to_string() + letters.as_str()
        })
    };
    let name: String = words.map(capital).collect();
    match name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        true => name,
        false => format!("P{name}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_is_given_twice_and_no_word_of_rocq_at_all() {
        let mut names = Names::default();
        assert_eq!(names.fresh("x"), "x");
        assert_eq!(names.fresh("x"), "x_");
        assert_eq!(names.fresh("R"), "R_");
        assert_eq!(names.fresh("at"), "at_");
        assert_eq!(names.fresh("3.1 b"), "v3_1_b");
    }

    #[test]
    fn papers_become_words_in_capitals() {
        assert_eq!(camel("gbt-developable"), "GbtDevelopable");
        assert_eq!(camel("2d"), "P2d");
    }
}
