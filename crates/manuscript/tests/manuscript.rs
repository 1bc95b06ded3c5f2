//! Manuscripts: what is found in them, and what is proposed.

#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use torse_manuscript::{ManuscriptError, Proposal, manuscript, propose};

const BLENDED: &str = include_str!("../../cli/tests/manuscript/blended.tex");

fn proposed(text: &str) -> Proposal {
    propose(&manuscript(text).unwrap(), "paper")
}

/// Loads the proposed files as a paper.
fn loads(proposal: &Proposal) -> torse_syntax::derivation::Paper {
    let read = |name: &str| {
        let text = if name == "paper.toml" {
            &proposal.paper
        } else {
            &proposal.claims
        };
        Ok(std::sync::Arc::new(torse_syntax::derivation::Source::new(
            name,
            text.as_str(),
        )))
    };
    torse_syntax::derivation::paper(read)
        .unwrap_or_else(|error| unreachable!("{error:?}\n{}\n{}", proposal.paper, proposal.claims))
}

#[test]
fn a_manuscript_of_two_pages_becomes_a_folder_that_loads() {
    let found = manuscript(BLENDED).unwrap();
    assert_eq!(
        (found.title.as_str(), found.authors.as_str()),
        ("A blended basis of degree two", "A. Uthor")
    );
    let places: Vec<String> = found
        .items
        .iter()
        .map(|item| format!("{} {}", item.kind, item.number.clone().unwrap_or_default()))
        .collect();
    assert_eq!(
        places,
        [
            "Definition 1",
            "equation 1",
            "equation 2",
            "equation 3",
            "equation 4",
            "equation 5",
            "equation 6",
            "equation 7",
            "Theorem 2",
            "equation 8",
            "equation 9",
            "equation 10",
            "equation 11",
            "equation 12",
            "equation 13"
        ]
    );
    let theorem = &found.items[8].printed;
    assert!(
        theorem.contains("of Definition 1 are nonnegative") && theorem.contains("compare (7)"),
        "{theorem}"
    );
    let proposal = proposed(BLENDED);
    let paper = loads(&proposal);
    let states = |id: &str| {
        let claim = paper
            .claims
            .iter()
            .find(|claim| claim.entry.id.get_ref() == id)
            .unwrap();
        claim
            .entry
            .states
            .as_ref()
            .map(|states| states.get_ref().clone())
            .unwrap_or_else(|| claim.entry.out_of_scope.clone().unwrap_or_default())
    };
    assert_eq!(states("paper/eq-unity"), "sum(i, 0, 2, b[i,2](t)) == 1");
    assert_eq!(states("paper/eq-middle"), "b[0,2](1/2) == 1/4 + lambda/8");
    assert_eq!(states("paper/eq-bound"), "b[1,2](t) <= (2 + lambda)/4");
    assert_eq!(
        states("paper/eq-first"),
        "r'(0) == (2 - lambda)*(p[1] - p[0])"
    );
    assert_eq!(states("paper/eq-b0"), "");
    assert!(states("paper/eq-angle").contains("several readings"));
    assert!(states("paper/eq-limit").contains("not stated yet"));
    assert!(
        proposal.claims.contains("# states = 'cos(omega*t)/2 <= 1'")
            && proposal.claims.contains("# states = 'cos(omega*t/2) <= 1'")
            || proposal.claims.contains("# states = 'cos(omega)*t/2 <= 1'"),
        "{}",
        proposal.claims
    );
    assert!(
        proposal
            .paper
            .contains("lambda = { in = \"[-1, 1]\" } # line 18"),
        "{}",
        proposal.paper
    );
    assert!(
        proposal.paper.contains("t = { in = \"[0, 1]\" } # line 18"),
        "{}",
        proposal.paper
    );
    assert_eq!(proposal.unread.len(), 1, "{:?}", proposal.unread);
    assert_eq!(proposal.unread[0].line, 73);
}

#[test]
fn macros_are_expanded_and_those_without_an_end_are_an_error() {
    let text = r"\newcommand{\sq}[2][2]{#2^{#1}} \def\half#1{\frac{#1}{2}} \DeclareMathOperator{\F}{F}
        \begin{equation} \sq{x} + \sq[3]{y} = \half{x} \end{equation}";
    assert!(
        proposed(text)
            .claims
            .contains("states = 'x^2 + y^3 == x/2'")
    );
    for text in [
        r"\def\a{\a}\a",
        r"\newcommand{\a}{\a\a}\a",
        r"\def\a{\b}\def\b{\a x}$\b$",
        r"\newcommand{\a}[1]{\a{#1#1}}\a{x}",
    ] {
        let error = manuscript(text).unwrap_err();
        assert!(
            matches!(error, ManuscriptError::Expansion { .. }),
            "{error}"
        );
    }
}

#[test]
fn what_is_not_understood_is_listed_with_its_line_and_column() {
    let text = "Text.\n\\input{other}\n\\begin{equation}\n  a = b + \\unknown c\n\\end{equation}\n\\begin{equation}\nf(x+1) = g\n\\end{equation}";
    let proposal = proposed(text);
    let places: Vec<(usize, usize)> = proposal
        .unread
        .iter()
        .map(|unread| (unread.line, unread.column))
        .collect();
    assert_eq!(places, [(2, 1), (4, 11)]);
    assert!(
        proposal
            .claims
            .contains("# 4:11 `\\unknown` is not understood"),
        "{}",
        proposal.claims
    );
    // A product or a call.
    assert!(
        proposal.claims.contains("# states = 'f*(x + 1) == g'")
            && proposal.claims.contains("# states = 'f(x + 1) == g'"),
        "{}",
        proposal.claims
    );
    loads(&proposal);
}

#[test]
fn numbers_of_equations_and_theorems_are_those_that_latex_prints() {
    let text = r"\newtheorem{thm}{Theorem}[section]\newtheorem{lem}[thm]{Lemma}\newtheorem*{note}{Note}\numberwithin{equation}{section}
        \section{One}\begin{thm}A\end{thm}\begin{lem}\label{l}B\end{lem}\begin{note}C\end{note}
        \section*{Not counted}\section{Two}\begin{align}a&=b\\c&=d\nonumber\\e&=f+g\\&=h\end{align}
        \begin{equation*}x=y\end{equation*}\begin{equation}\tag{A}x=y\end{equation}\begin{lem}see \ref{l}\end{lem}";
    let found = manuscript(text).unwrap();
    let numbers: Vec<String> = found
        .items
        .iter()
        .map(|item| format!("{} {}", item.kind, item.number.clone().unwrap_or_default()))
        .collect();
    assert_eq!(
        numbers,
        [
            "Theorem 1.1",
            "Lemma 1.2",
            "Note ",
            "equation 2.1",
            "equation 2.2",
            "equation A",
            "Lemma 2.1"
        ]
    );
    assert_eq!(found.items[4].printed, "e = f + g = h");
    assert_eq!(found.items[6].printed, "see 1.2");
}

proptest! {
    #[test]
    fn any_text_is_read_and_its_proposal_loads(parts in prop::collection::vec(prop::sample::select(&PARTS[..]), 0..40)) {
        let text = parts.join(" ");
        if let Ok(found) = manuscript(&text) {
            loads(&propose(&found, "paper"));
        }
    }

    #[test]
    fn any_bytes_are_read(text in ".{0,300}") {
        let _ = manuscript(&text).map(|found| propose(&found, "paper"));
    }
}

const PARTS: [&str; 40] = [
    "\\begin{equation}",
    "\\end{equation}",
    "\\begin{theorem}",
    "\\end{theorem}",
    "\\section{A}",
    "\\label{a}",
    "\\ref{a}",
    "$",
    "\\[",
    "\\]",
    "{",
    "}",
    "f(t) = t^2",
    "a = b",
    "x",
    "=",
    "\\newcommand{\\a}{b}",
    "\\a",
    "\\frac{1}{2}",
    "\\sum_{i=0}^n P_i",
    "\\mathbf{r}(t)",
    "f'(t)",
    "t \\in [0,1]",
    "\\\\",
    "&",
    "'",
    "\"",
    "%\n",
    "\n\n",
    "\\begin{align}",
    "\\end{align}",
    "\\def\\b#1{#1}",
    "\\b",
    "\\sin x",
    "\\hat x",
    "P_{ij} = 1",
    "b_0(t) = 1",
    "b_i(t)",
    "n(n-1)",
    "words",
];
