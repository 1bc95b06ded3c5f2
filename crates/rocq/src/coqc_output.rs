//! Reads what `coqc` and `coqchk` write: the theorem that an error is about, and lists of axioms.

/// Returns the line of the first error: `File "./P/S.v", line 12, characters 0-31:`.
pub(crate) fn error_line(text: &str) -> Option<usize> {
    let (_, rest) = text.split_once(", line ")?;
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok()
}

/// Returns the module in which a line stands, counted from 1.
pub(crate) fn module_at(text: &str, line: usize) -> Option<String> {
    let opened = |line: &str| Some(line.strip_prefix("Module ")?.strip_suffix('.')?.to_owned());
    text.lines().take(line).filter_map(opened).last()
}

/// Returns the axioms of a `Print Assumptions`: the words before the colons of its list.
pub(crate) fn assumptions(text: &str) -> Vec<String> {
    let Some((_, list)) = text.split_once("Axioms:") else {
        return vec![];
    };
    let names = list
        .lines()
        .filter(|line| !line.starts_with(char::is_whitespace));
    let mut names: Vec<String> = names
        .filter_map(|line| Some(line.split([':', ' ']).next()?.to_owned()))
        .filter(|name| !name.is_empty())
        .collect();
    names.sort();
    names
}

/// Returns the axioms of the summary of `coqchk`: the lines indented below `* Axioms:`.
pub(crate) fn listed_axioms(text: &str) -> Vec<String> {
    let Some((_, list)) = text.split_once("* Axioms:") else {
        return vec![];
    };
    let indented = |line: &&str| line.starts_with("    ");
    let names = list.lines().skip(1).take_while(indented);
    let mut names: Vec<String> = names.map(|line| line.trim().to_owned()).collect();
    names.sort();
    names
}

/// Returns the first lines that are not blank: what a message shows.
pub(crate) fn first_lines(text: &str) -> String {
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .take(12)
        .collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_its_theorem() {
        let proofs = "From Torse Require Import Defs.\n\nModule one.\nProof.\nEnd one.\n\nModule two.\nProof.\n";
        let error = "File \"./P/S_proofs.v\", line 8, characters 0-6:\nError: no.";
        let module = error_line(error).and_then(|line| module_at(proofs, line));
        assert_eq!(module.as_deref(), Some("two"));
    }

    #[test]
    fn axioms_are_read_off_the_list() {
        let text =
            "x : y\nAxioms:\nB.classic : forall P : Prop, P \\/ ~ P\nA.sig\n  : forall P,\n    P\n";
        assert_eq!(assumptions(text), ["A.sig", "B.classic"]);
        assert_eq!(assumptions("Closed under the global context"), [""; 0]);
    }

    #[test]
    fn axioms_are_read_off_the_summary_of_the_separate_checker() {
        let text = "CONTEXT SUMMARY\n===\n\n* Theory: Set is predicative\n\n* Axioms:\n    B.classic\n    A.sig\n\n* Constants: none\n";
        assert_eq!(listed_axioms(text), ["A.sig", "B.classic"]);
        assert_eq!(listed_axioms("* Axioms: <none>\n"), [""; 0]);
    }
}
