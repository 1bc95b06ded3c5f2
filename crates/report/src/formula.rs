//! Formulas: which of them the typesetter can set, and where a long one may be broken.
//!
//! A formula reaches the typesetter as a string that it evaluates. One that does not evaluate must cost
//! its own mathematics only, not the report, and the typesetter stops at the first error without saying
//! which string it was in. So a probe document holds all formulas; if it fails, it is halved until the
//! offenders stand alone: one extra compilation when all is well, a logarithmic number for each offender.

use crate::ReportError;
use crate::world::MemoryWorld;
use typst::foundations::Output;

const PROBE: &str = include_str!("../assets/probe.typ");

/// For each formula, whether a document of type `D` that contains it compiles.
pub(crate) fn usable<D: Output>(formulas: &[String]) -> Result<Vec<bool>, ReportError> {
    let mut verdicts = Vec::with_capacity(formulas.len());
    search::<D>(formulas, &mut verdicts)?;
    Ok(verdicts)
}

fn search<D: Output>(formulas: &[String], verdicts: &mut Vec<bool>) -> Result<(), ReportError> {
    if probe(formulas)?.compile::<D>("the formulas").is_ok() {
        verdicts.extend(formulas.iter().map(|_| true));
    } else if formulas.len() <= 1 {
        verdicts.extend(formulas.iter().map(|_| false));
    } else {
        let (first, second) = formulas.split_at(formulas.len() / 2);
        search::<D>(first, verdicts)?;
        search::<D>(second, verdicts)?;
    }
    Ok(())
}

/// The world of the document that holds nothing but `formulas`, each a block.
pub(crate) fn probe(formulas: &[String]) -> Result<MemoryWorld, ReportError> {
    let data = serde_json::to_vec(formulas)?;
    MemoryWorld::new(PROBE, &[], [("formulas.json".to_owned(), data)])
}

/// The pieces between which a long formula may be broken: it is cut before each relation and each plus
/// or minus that stands inside of at most `depth` brackets, and of these such as only group.
///
/// The pieces, joined, are the formula. An operator that has no left operand (a sign) does not cut, nor does
/// anything inside of quotes, scripts or the arguments of a function.
pub(crate) fn pieces(formula: &str, depth: usize) -> Vec<String> {
    let mut pieces = Vec::new();
    let mut piece = String::new();
    // For each open bracket, whether it only groups.
    let mut brackets: Vec<bool> = Vec::new();
    let mut quoted = false;
    // What the last visible character was decides whether an operator has a left operand.
    let mut last = Last::Nothing;
    let mut before = ' ';
    for character in formula.chars() {
        if quoted {
            quoted = character != '"';
            last = Last::Operand;
        } else {
            match character {
                '"' => quoted = true,
                '(' | '[' | '{' => {
                    brackets.push(matches!(before, ' ' | '(' | '[' | '{'));
                    last = Last::Operator;
                }
                ')' | ']' | '}' => {
                    brackets.pop();
                    last = Last::Operand;
                }
                _ if breaks_before(character) => {
                    let inside = brackets.len() <= depth && brackets.iter().all(|groups| *groups);
                    if inside && matches!(last, Last::Operand) {
                        pieces.push(std::mem::take(&mut piece));
                    }
                    last = Last::Operator;
                }
                ',' | ';' | '_' | '^' | '/' | '!' | ':' | '*' => last = Last::Operator,
                _ if character.is_whitespace() => {}
                _ => last = Last::Operand,
            }
        }
        before = character;
        piece.push(character);
    }
    pieces.push(piece);
    pieces
}

enum Last {
    Nothing,
    Operand,
    Operator,
}

fn breaks_before(character: char) -> bool {
    matches!(
        character,
        '+' | '-' | '−' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '±'
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use typst_html::HtmlDocument;
    use typst_layout::PagedDocument;

    #[test]
    fn a_formula_is_cut_before_relations_and_sums_outside_of_brackets() {
        assert_eq!(
            pieces("f(x + 1) = a - b/(c + d) <= 2", 0),
            ["f(x + 1) ", "= a ", "- b/(c + d) ", "<= 2"]
        );
    }

    #[test]
    fn a_bracket_that_groups_is_cut_at_its_depth_and_arguments_and_scripts_never() {
        let formula = "x ((a + b) (c - d) + e)^(n + 1) g_(i - 1) (u + v) f(p + q)";
        assert_eq!(pieces(formula, 0), [formula]);
        assert_eq!(
            pieces(formula, 1),
            [
                "x ((a + b) (c - d) ",
                "+ e)^(n + 1) g_(i - 1) (u ",
                "+ v) f(p + q)"
            ]
        );
        assert_eq!(pieces(formula, 2).len(), 5);
    }

    #[test]
    fn signs_exponents_and_quoted_text_do_not_cut() {
        for whole in [
            "-a",
            "e^-x",
            "x_-1",
            "\"a + b\"",
            "a dot.c (b - c)",
            "3 * -x",
        ] {
            assert_eq!(pieces(whole, 0), [whole]);
        }
    }

    #[test]
    fn the_pieces_joined_are_the_formula_even_where_brackets_do_not_match() {
        for formula in ["", ")+(a+b", "a = (b + c", "\"open + quote", "a --> b"] {
            assert_eq!(pieces(formula, 1).concat(), formula);
        }
    }

    #[test]
    fn formulas_that_do_not_evaluate_are_found_and_the_others_are_kept() {
        let formulas = [
            "x^2",
            "no_such_name",
            "frac(1,",
            "#panic()",
            "a + b",
            "sqrt(2)",
        ]
        .map(str::to_owned);
        let expected = [true, false, false, false, true, true];
        assert_eq!(usable::<PagedDocument>(&formulas).unwrap(), expected);
        assert_eq!(usable::<HtmlDocument>(&formulas).unwrap(), expected);
    }
}
