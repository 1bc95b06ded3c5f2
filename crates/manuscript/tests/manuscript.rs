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

/// A manuscript of the folder beside these tests.
fn written(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/manuscripts");
    std::fs::read_to_string(format!("{folder}/{name}.tex")).unwrap()
}

/// The statement of a claim; what stands in its place if it has none.
fn stated(paper: &torse_syntax::derivation::Paper, id: &str) -> String {
    let mut claims = paper.claims.iter();
    let claim = claims.find(|claim| claim.entry.id.get_ref() == &format!("paper/{id}"));
    let entry = &claim.unwrap_or_else(|| unreachable!("{id}")).entry;
    let states = entry.states.as_ref().map(|states| states.get_ref().clone());
    states.unwrap_or_else(|| format!("unstated: {}", entry.unstated.clone().unwrap_or_default()))
}

#[test]
fn a_family_of_functions_is_that_of_its_members_however_they_are_printed() {
    for (name, unity) in [
        ("strip", "sum(i, 0, 3, f[i,3](t)) == 1"),
        ("strip-cases", "sum(i, 0, 3, f[i,3](t)) == 1"),
        ("strip-aligned", "f_0(t) + f_1(t) + f_2(t) + f_3(t) == 1"),
        ("strip-inline", "f_0(t) + f_1(t) + f_2(t) + f_3(t) == 1"),
    ] {
        let proposal = proposed(&written(name));
        let paper = loads(&proposal);
        let found = stated(&paper, "eq-unity")
            .replace("f[0,3]", "f_0")
            .replace("f[1,3]", "f_1");
        let found = found.replace("f[2,3]", "f_2").replace("f[3,3]", "f_3");
        assert_eq!(found, unity, "{name}\n{}", proposal.paper);
        assert!(
            proposal.paper.contains("(1 - alpha*t)*(1 - t)^2"),
            "{name}\n{}",
            proposal.paper
        );
        assert!(
            !proposal.paper.contains("line 0")
                // Points in bold letters are listed where no formula has one with a letter as its index.
                && proposal.unread.iter().all(|unread| unread.print.contains("dots")),
            "{name}: {:?}",
            proposal.unread
        );
    }
}

#[test]
fn no_row_of_a_display_is_lost() {
    let text = r"\begin{align} f(t) &= t^2, \nonumber\\ f(1) &= 1, \nonumber\\ f(2) &= 4 \label{four}\\ &= 3 + 1 \nonumber \end{align}
        \begin{equation} f(3) = 9 \end{equation} \[ f(0) = 0 \]";
    let proposal = proposed(text);
    let paper = loads(&proposal);
    assert!(
        proposal.paper.contains("\"f(t)\" = 't^2'"),
        "{}",
        proposal.paper
    );
    assert_eq!(stated(&paper, "four"), "f(2) == 4 == 3 + 1");
    assert_eq!(stated(&paper, "eq-2"), "f(3) == 9");
    assert_eq!(proposal.unnumbered, 2, "{}", proposal.claims);
    for formula in ["# states = 'f(1) == 1'", "# states = 'f(0) == 0'"] {
        assert!(proposal.claims.contains(formula), "{}", proposal.claims);
    }
}

#[test]
fn points_and_ranges_are_those_that_the_prose_declares() {
    for (print, declared) in [
        (
            r"$P_0, P_1, \dots, P_{n} \in \mathbb{R}^3$",
            "P = { family = 3, indices = [\"0..n\"] }",
        ),
        (
            r"$\{P_i\}_{i=0}^{n}$",
            "P = { family = 1, indices = [\"0..n\"] }",
        ),
    ] {
        let text = format!(
            r"Points {print}. \begin{{equation}} \mathbf q = \mathbf{{P}}_1 - \mathbf P_0 \end{{equation}}
            \begin{{equation}} \mathbf q + \mathbf{{P}}_0 = \mathbf P_1 \end{{equation}}"
        );
        let text = match print.contains("mathbf") {
            true => text,
            false => text.replace(r"\mathbf", ""),
        };
        let proposal = proposed(&text);
        loads(&proposal);
        assert!(
            proposal.paper.contains(declared),
            "{print}\n{}\n{:?}",
            proposal.paper,
            proposal.unread
        );
        assert!(proposal.unread.is_empty(), "{print}: {:?}", proposal.unread);
    }
    for (print, declared) in [
        (r"$\alpha,\beta\in[-2,1]$", "alpha = { in = \"[-2, 1]\" }"),
        (
            r"$0 \le \alpha \le \beta$",
            "alpha = { in = \"[0, beta]\" }",
        ),
        (r"$k = 1, 2, \dots$", "k = { integer = \">= 1\" }"),
        (r"$k = 0,\ldots,m$", "k = { integer = \"0..m\" }"),
        (r"$k\in\{1,\dots,m-1\}$", "k = { integer = \"1..m - 1\" }"),
        (r"$0\le k\le m$", "k = { integer = \"0..m\" }"),
    ] {
        let text = format!(
            r"For {print} we have \begin{{equation}} \binom{{m}}{{k}} + \alpha\beta = \beta\alpha + \binom{{m}}{{m-k}} \end{{equation}}"
        );
        let proposal = proposed(&text);
        loads(&proposal);
        assert!(
            proposal.paper.contains(declared),
            "{print}\n{}",
            proposal.paper
        );
    }
    // Places of a variable are no range of an index.
    let text = r"At $t = 0, 1$ and for $t\in[0,1]$ \begin{equation} t(1-t) \ge 0 \end{equation}";
    assert!(proposed(text).paper.contains("t = { in = \"[0, 1]\" }"));
}

#[test]
fn what_cannot_be_used_is_listed_with_what_uses_it() {
    let text = r"\begin{equation} r(t) = \sum_{i=0}^{3} g_i(t) P_i \label{r} \end{equation} \begin{equation} r(0) = P_0 \label{s} \end{equation}
        \begin{equation} f_0(t) = 1 \end{equation} \begin{equation} \sum_{i=0}^{2} f_i(t) = 1 \label{sum} \end{equation}";
    let proposal = proposed(text);
    let paper = loads(&proposal);
    assert!(!proposal.paper.contains("[define]"), "{}", proposal.paper);
    for id in ["r", "s"] {
        let found = stated(&paper, id);
        assert!(
            found.contains("`r`: its definition uses `g`: it is a function of 2 variables that no formula defines"),
            "{found}"
        );
    }
    assert!(
        stated(&paper, "sum").starts_with("unstated"),
        "{}",
        proposal.claims
    );
}

#[test]
fn a_theorem_has_the_kind_of_its_formulas() {
    for (formula, kind) in [
        ("x + x = 2x", "identity"),
        ("x^2 \\ge 0", "inequality"),
        ("x + x = 2x \\quad\\text{and}\\quad x^2 \\ge 0", "identity"),
        ("x \\ne 0", "property"),
    ] {
        let text = format!("\\begin{{theorem}} We have ${formula}$. \\end{{theorem}}");
        let paper = loads(&proposed(&text));
        let found = format!("{:?}", paper.claims[0].entry.kind).to_lowercase();
        assert_eq!(found, kind, "{formula}");
    }
}

#[test]
fn every_manuscript_becomes_a_folder_that_loads() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/manuscripts");
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    names.sort();
    assert!(names.len() >= 12, "{names:?}");
    for path in names {
        let proposal = proposed(&std::fs::read_to_string(&path).unwrap());
        let paper = loads(&proposal);
        assert!(!paper.claims.is_empty(), "{path:?}");
        assert!(
            proposal.stated + proposal.to_choose > 0,
            "{path:?}\n{}",
            proposal.claims
        );
    }
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
            .unwrap_or_else(|| claim.entry.unstated.clone().unwrap_or_default())
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
    assert!(states("paper/eq-limit").contains("`lim`"));
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

/// The line of a symbol in the proposed paper.
fn declared<'p>(proposal: &'p Proposal, name: &str) -> &'p str {
    let start = format!("{name} = ");
    let mut lines = proposal.paper.lines();
    lines.find(|line| line.starts_with(&start)).unwrap_or("")
}

#[test]
fn the_letter_e_with_exponents_alone_is_the_exponential_function() {
    let base = r"Let $x\in[0,1]$ and $y\in\mathbb{R}$.
        \begin{equation} e^{x+y} = e^x e^y \label{add} \end{equation}
        \begin{equation} (1 - x) e^{-x}(1 + x) \le 1 \label{at-most} \end{equation}";
    for text in [base.to_owned(), base.replace("e^", r"\mathrm{e}^")] {
        let proposal = proposed(&text);
        let paper = loads(&proposal);
        assert_eq!(declared(&proposal, "e"), "", "{}", proposal.paper);
        assert_eq!(stated(&paper, "add"), "exp(x + y) == exp(x)*exp(y)");
        assert_eq!(stated(&paper, "at-most"), "(1 - x)*exp(-x)*(1 + x) <= 1");
        assert_eq!(
            declared(&proposal, "x"),
            "x = { in = \"[0, 1]\" } # line 1",
            "{}",
            proposal.paper
        );
        assert_eq!(
            declared(&proposal, "y"),
            "y = { in = \"(-inf, inf)\" } # line 1"
        );
    }
    // Beside an e without an exponent nothing says which it is.
    for more in [
        "$e + 1$ is the length.",
        r"\begin{equation} \ln e = 1 \end{equation}",
    ] {
        let proposal = proposed(&format!("{base} {more}"));
        let paper = loads(&proposal);
        assert!(
            stated(&paper, "add").contains("several readings"),
            "{}",
            proposal.claims
        );
        for reading in [
            "# states = 'exp(x + y) == exp(x)*exp(y)' # `e` is the base of the exponential function",
            "# states = 'e^(x + y) == e^x*e^y' # `e` is a number of the text",
        ] {
            assert!(proposal.claims.contains(reading), "{}", proposal.claims);
        }
    }
    // An eccentricity is a number, if the text says so, and else one of both.
    let ellipse = r"\begin{equation} b^2 = a^2 - a^2 e^2 \label{axis} \end{equation}";
    let proposal = proposed(&format!(r"Let $e\in[0,1)$. {ellipse}"));
    assert_eq!(declared(&proposal, "e"), "e = { in = \"[0, 1)\" } # line 1");
    assert_eq!(stated(&loads(&proposal), "axis"), "b^2 == a^2 - a^2*e^2");
    assert!(stated(&loads(&proposed(ellipse)), "axis").contains("several readings"));
    let proposal = proposed(r"\begin{equation} eg \le e^2 + g^2 \label{gauss} \end{equation}");
    assert!(
        declared(&proposal, "e").contains("the base of the exponential function is exp(1)"),
        "{}",
        proposal.paper
    );
}

#[test]
fn real_numbers_of_the_text_are_no_integers() {
    for (print, name, range) in [
        (r"$x\in[0,1]$", "x", "x = { in = \"[0, 1]\" } # line 1"),
        (r"$k\in[0,1]$", "k", "k = { in = \"[0, 1]\" } # line 1"),
        (r"$0 \le x \le 1$", "x", "x = { in = \"[0, 1]\" } # line 1"),
        (r"$x \ge 0$", "x", "x = { in = \"[0, inf)\" } # line 1"),
        (
            r"$x\in\mathbb{R}$",
            "x",
            "x = { in = \"(-inf, inf)\" } # line 1",
        ),
        (
            "$x$",
            "x",
            "x = {} # which numbers? the text gives no range; in an exponent an integer belongs",
        ),
        // Letters of indices, where the text does not say real numbers.
        (r"$0\le n\le 4$", "n", "n = { integer = \"0..4\" } # line 1"),
        (
            r"$n\in\mathbb{N}$",
            "n",
            "n = { integer = \">= 1\" } # line 1",
        ),
        (
            "$n$",
            "n",
            "n = { integer = \">= 0\" } # which integers? the text gives no range",
        ),
    ] {
        let text = format!(
            r"For {print} \begin{{equation}} a^{name} {name}^2 = {name} a^{name} \end{{equation}}"
        );
        let proposal = proposed(&text);
        loads(&proposal);
        assert_eq!(declared(&proposal, name), range, "{print}");
    }
    // What only integers can be against real numbers of the text is asked.
    let text = r"For $k \in [0, 4]$ \begin{equation} \binom{4}{k} = \binom{4}{4 - k} \label{binom} \end{equation}";
    let proposal = proposed(text);
    assert_eq!(declared(&proposal, "k"), "");
    let why = stated(&loads(&proposal), "binom");
    assert!(
        why.contains("line 1 says that it is a real number of [0, 4]"),
        "{why}"
    );
}

#[test]
fn a_condition_in_brackets_behind_a_formula_is_its_condition() {
    for print in [
        r"\sqrt{x^2} = x \quad (x \ge 0)",
        r"\sqrt{x^2} = x (x \ge 0)",
    ] {
        let proposal = proposed(&format!(
            r"\begin{{equation}} {print} \label{{root}} \end{{equation}}"
        ));
        assert_eq!(
            stated(&loads(&proposal), "root"),
            "sqrt(x^2) == x",
            "{}",
            proposal.claims
        );
        assert!(
            proposal.claims.contains("assume = ['x >= 0']"),
            "{}",
            proposal.claims
        );
    }
}

#[test]
fn members_of_a_family_may_be_declared_one_by_one() {
    let text = r"Let $\mathbf p_0,\mathbf p_1,\mathbf p_2\in\mathbb{R}^2$ and
        \begin{equation} \mathbf{r}(t) = \sum_{i=0}^{2} t^i \mathbf p_i \end{equation}
        \begin{equation} \mathbf r(0) = \mathbf p_0 \label{first} \end{equation}";
    let proposal = proposed(text);
    assert!(proposal.unread.is_empty(), "{:?}", proposal.unread);
    assert_eq!(stated(&loads(&proposal), "first"), "r(0) == p[0]");
    assert!(
        declared(&proposal, "p").starts_with("p = { family = 2, indices = [\"0..2\"] }"),
        "{}",
        proposal.paper
    );
}

#[test]
fn a_number_and_a_bold_vector_may_have_the_same_letter() {
    let text = r"\begin{equation} |a+b| \le |a| + |b| \label{numbers} \end{equation}
        \begin{equation} \mathbf a\cdot\mathbf b = \mathbf b\cdot\mathbf a \label{vectors} \end{equation}";
    let proposal = proposed(text);
    let paper = loads(&proposal);
    assert!(proposal.unread.is_empty(), "{:?}", proposal.unread);
    assert_eq!(stated(&paper, "numbers"), "abs(a + b) <= abs(a) + abs(b)");
    assert_eq!(
        stated(&paper, "vectors"),
        "dot(a_vector, b_vector) == dot(b_vector, a_vector)"
    );
}

/// The statements of the numbered equations.
fn equations(body: &str) -> Vec<(String, String)> {
    let text = format!(
        "\\documentclass{{article}}\n\\begin{{document}}\nLet $x, y, a, b$ be real numbers.\n{body}"
    );
    let paper = loads(&proposed(&text));
    let claims = paper.claims.iter();
    let claims = claims.map(|claim| {
        claim
            .entry
            .id
            .get_ref()
            .trim_start_matches("paper/")
            .to_owned()
    });
    claims.map(|id| (id.clone(), stated(&paper, &id))).collect()
}

#[track_caller]
fn has(body: &str, wanted: &[&str]) {
    let found = equations(&format!("{body}\n\\end{{document}}\n"));
    let found: Vec<&str> = found.iter().map(|(_, states)| states.as_str()).collect();
    assert_eq!(found, wanted, "{body}");
}

#[test]
fn a_formula_over_several_rows_is_read_whole() {
    let square = "(a + b)^2 == a^2 + 2*a*b + b^2";
    has(
        r"\begin{align} (a+b)^2 = {}& a^2 + 2ab \\ & {} + b^2 \end{align}",
        &[square],
    );
    has(
        r"\begin{align} (a+b)^2 = {}& a^2 + 2ab \nonumber\\ & {} + b^2 \end{align}",
        &[square],
    );
    has(
        r"\begin{align} (a+b)^2 &= a^2 + 2ab + \\ & b^2 \end{align}",
        &[square],
    );
    has(
        r"\begin{equation}\begin{split} (a+b)^2 &= a^2 \\ &\quad + 2ab + b^2 \end{split}\end{equation}",
        &[square],
    );
    let less = "(a - b)^2 == a^2 - 2*a*b + b^2";
    has(
        r"\begin{align} (a+b)^2 &= a^2 + 2ab + b^2 \\ (a-b)^2 &= a^2 - 2ab + b^2 \end{align}",
        &[square, less],
    );
    has(
        r"\begin{equation}\begin{aligned} (a+b)^2 &= a^2 + 2ab + b^2 \\ (a-b)^2 &= a^2 - 2ab + b^2 \end{aligned}\end{equation}",
        &[&format!("{square} and {less}")],
    );
}

#[test]
fn what_tex_does_not_typeset_is_not_read() {
    let kept = r"\begin{equation} x + y = y + x \end{equation}";
    let other = r"\begin{equation} a + b = ab \end{equation}";
    has(
        &format!(r"\iffalse {other} \fi {kept}"),
        &["x + y == y + x"],
    );
    has(
        &format!(r"\iftrue {kept} \else {other} \fi"),
        &["x + y == y + x"],
    );
    has(
        &format!(r"\newif\ifdraft \drafttrue \ifdraft {kept} \else {other} \fi"),
        &["x + y == y + x"],
    );
    has(
        &format!(r"\newif\ifdraft \ifdraft {other} \iffalse a \fi \else {kept} \fi"),
        &["x + y == y + x"],
    );
    has(
        r"\begin{equation} x = y \iff y = x \end{equation}",
        &["(x == y implies y == x) and (y == x implies x == y)"],
    );
    let behind = equations(&format!("{kept}\n\\end{{document}}\n{other}"));
    assert_eq!(behind.len(), 1, "{behind:?}");
    let unknown = proposed(&format!(
        "\\begin{{document}}{kept} \\ifx a b {other} \\fi\\end{{document}}"
    ));
    assert!(
        unknown
            .unread
            .iter()
            .any(|unread| unread.why.contains("ifx")),
        "{:?}",
        unknown.unread
    );
}

#[test]
fn a_macro_lasts_to_the_end_of_its_group() {
    has(
        r"\newcommand{\k}{7} {\renewcommand{\k}{9} \begin{equation} x + y = \k y \end{equation}} \begin{equation} x + y = \k x \end{equation}",
        &["x + y == 9*y", "x + y == 7*x"],
    );
}
