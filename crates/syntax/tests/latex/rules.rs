//! The rules one by one: what is clear, what has two readings, what is refused and why.

use crate::normal::{normal, normal_text};
use torse_syntax::derivation::{latex_names, latex_question, question};
use torse_syntax::latex::{
    LatexCondition, LatexError, LatexKind, LatexNames, LatexReading, read_latex,
};

fn names(setting: &str) -> LatexNames {
    let paper = question(
        "1 == 1",
        &format!("a, b, c, x, y, t in (-inf, inf); n, m in 0..; {setting}"),
    );
    latex_names(&paper.unwrap().claims[0].declarations)
}

fn read(print: &str, setting: &str) -> Result<LatexReading, LatexError> {
    read_latex(print, &names(setting))
}

#[track_caller]
fn is(print: &str, setting: &str, meant: &str) {
    let read = read(print, setting).unwrap_or_else(|error| unreachable!("{print}: {error}"));
    assert!(read.others.is_empty(), "{print}: {:?}", read.others);
    assert_eq!(
        normal(&read.statement.formula),
        normal_text(meant),
        "{print}"
    );
}

#[track_caller]
fn has_two_readings(print: &str, setting: &str, first: &str, second: &str) {
    let read = read(print, setting).unwrap_or_else(|error| unreachable!("{print}: {error}"));
    let others: Vec<_> = read
        .others
        .iter()
        .map(|(_, other)| normal(&other.formula))
        .collect();
    assert_eq!(
        normal(&read.statement.formula),
        normal_text(first),
        "{print}"
    );
    assert_eq!(others, [normal_text(second)], "{print}");
}

#[track_caller]
fn is_refused(print: &str, setting: &str, at: &str, says: &str) {
    let error = read(print, setting)
        .err()
        .unwrap_or_else(|| unreachable!("{print} is read"));
    assert!(error.message.contains(says), "{print}: {error}");
    assert_eq!(
        print.get(error.place.start..error.place.end),
        Some(at),
        "{print}: {error}"
    );
}

#[test]
fn a_slash_before_a_product_and_a_function_before_several_operands_have_two_readings() {
    has_two_readings("1/2x", "", "1/2*x", "1/(2*x)");
    has_two_readings(r"\sin x y", "", "sin(x)*y", "sin(x*y)");
    has_two_readings(r"\sin(x + 1)y", "", "sin(x + 1)*y", "sin((x + 1)*y)");
    has_two_readings(r"\cos x/2", "", "cos(x)/2", "cos(x/2)");
    has_two_readings(r"\sin(x)^2", "", "sin(x)^2", "sin(x^2)");
    is(r"\sin(x)y", "", "sin(x)*y");
    is(r"\sin\frac{\pi}{2}x\cos y", "", "sin(pi/2*x)*cos(y)");
    is(r"\sin^2 2x", "", "sin(2*x)^2");
    is(r"\sin -x", "", "sin(-x)");
    is(r"a/b\cdot c", "", "a/b*c");
}

#[test]
fn declarations_say_what_brackets_and_scripts_mean() {
    is("x(a + b)", "", "x*(a + b)");
    is("f(a + b)", "f: function 1", "f(a + b)");
    is("f(x)^2", "f: function 1", "f(x)^2");
    is("P_{i+1}(t)", "P[i] := i; i in 0..", "P[i+1]*t");
    is("q_{12} = 1", "q[i, j] := i; i in 0..", "q[1, 2] == 1");
    is(
        "q_{ij} = q_{i+1,j}",
        "q[i, j] := i; i, j in 0..",
        "q[i, j] == q[i+1, j]",
    );
    is("v_2", "v: vector 3", "v[2]");
    is_refused("x_1", "", "x_1", "not with this subscript");
    is_refused("q", "", "q", "`q` is not declared");
    is_refused(r"\mathbf x", "", "x", "printed as a vector");
    is_refused(
        "f^2(x)",
        "f: function 1",
        "2",
        "may be a power or a number of repetitions",
    );
    is_refused("x'", "", "x'", "is no function");
}

#[test]
fn what_may_mean_another_thing_is_refused_at_its_place() {
    is_refused(
        r"\sin^{-1} x = a",
        "",
        r"\sin^{-1}",
        "may be an inverse function",
    );
    is_refused(
        r"\mathbf{u}\mathbf{v}",
        "u: vector 3; v: vector 3",
        r"u}\mathbf{v",
        "neither",
    );
    is_refused(
        r"\mathbf u\cdot \mathbf v\times \mathbf w",
        "u: vector 3; v: vector 3; w: vector 3",
        r"u\cdot \mathbf v\times \mathbf w",
        "between a number and a vector",
    );
    is_refused("x = 1 + 2 + \\ldots + n", "", "\\ldots", "ellipsis");
    is_refused(
        "x = 1, 2, \\ldots, n",
        "",
        "x = 1",
        "a range of an index alone",
    );
    is_refused(
        r"\sum_{k=0}^n x^k + k",
        "k in 0..",
        r"\sum_{k=0}^n x^k + k",
        "also occurs outside",
    );
    is_refused(r"\sum_{k=0}^n x^k + k", "", "k", "not declared");
    is_refused(r"|a|b|c|", "", "|c|", "two ways");
    is_refused(
        r"\phi = \varphi",
        "phi in (0, 1)",
        r"\varphi",
        "two letters",
    );
    is_refused(r"x + \foo", "", r"\foo", "`\\foo` is not understood");
    is_refused(r"\frac{d}{dt} t x", "", r"\frac{d}{dt}", "how far");
    is_refused("x^{(2)}", "", "(2)", "in brackets");
    is_refused("x 2", "", "2", "right behind an operand");
}

#[test]
fn conditions_are_told_from_what_is_stated() {
    let conditions = |print: &str| read(print, "").unwrap().statement.conditions;
    let range = conditions(r"x = a, \quad 0 \le t < 1");
    assert!(
        matches!(range.as_slice(), [LatexCondition::Interval { names, low: (Some(_), true), high: (Some(_), false), is_set: false }] if names == &["t"]),
        "{range:?}"
    );
    let range = conditions(r"x = a, \quad x, t \in [0, \infty)");
    assert!(
        matches!(range.as_slice(), [LatexCondition::Interval { names, low: (Some(_), true), high: (None, _), is_set: true }] if names == &["x", "t"]),
        "{range:?}"
    );
    let range = conditions(r"x = a, \quad k = 0, 1, \ldots, n");
    assert!(
        matches!(range.as_slice(), [LatexCondition::Integers { name, .. }] if name == "k"),
        "{range:?}"
    );
    let range = conditions(r"x = a \text{ if } b > c");
    assert!(
        matches!(range.as_slice(), [LatexCondition::Formula(_)]),
        "{range:?}"
    );
    let doubt = read("x = a, b > c", "").unwrap();
    assert_eq!(doubt.others.len(), 1);
    assert!(read("x = a, k = 0, 2, \\ldots, n", "").is_err());
}

#[test]
fn a_prime_of_a_function_of_a_basis_is_its_derivative_at_the_argument() {
    let mut names = names("");
    let basis = LatexKind::Basis {
        degree: None,
        variable: "t".to_owned(),
    };
    names.declare("B", basis);
    for (print, meant) in [
        ("B_{0,2}(t) = a", "B[0,2](t) == a"),
        ("B_{0,2}'(t) = a", "D(B[0,2](t), t) == a"),
        ("B_{0,2}''(t) = a", "D(B[0,2](t), t, 2) == a"),
        ("B_{0,2}'(0) = a", "at(D(B[0,2](t), t), t, 0) == a"),
        ("B_{0,2}'(0)^2 = a", "at(D(B[0,2](t), t), t, 0)^2 == a"),
        ("B_{0,2}'(2t) = a", "at(D(B[0,2](t), t), t, 2*t) == a"),
    ] {
        let read = read_latex(print, &names).unwrap();
        let formula = normal(&read.statement.formula);
        assert_eq!(formula, normal_text(meant), "{print}");
    }
    assert!(read_latex("B_{0,2}' = a", &names).is_err());
}

#[test]
fn inverse_functions_have_names_of_their_own() {
    is(
        r"\arctan x + \arccos(y) = \arcsin^2 x",
        "",
        "atan(x) + acos(y) == asin(x)^2",
    );
}

#[test]
fn the_smallest_and_the_greatest_of_numbers_stand_in_brackets() {
    is(r"\max(x, y) = y", "", "max(x, y) == y");
    is(r"\min\{a, b, c\} \le a", "", "min(a, min(b, c)) <= a");
    is(
        r"2\max\left\{x^2, 1\right\}^2 = 0",
        "",
        "2*max(x^2, 1)^2 == 0",
    );
    is_refused(r"\max_{x} y = 1", "", r"\max_{x}", "scripts of `max`");
    is_refused(r"\max(x) = 1", "", r"\max", "no list of numbers");
    is_refused(r"\max x = 1", "", r"\max", "no list of numbers");
}

#[test]
fn the_letter_e_of_one_statement_is_the_exponential_function_or_asked_for() {
    for (print, setting, meant) in [
        ("e^{x+y} = e^x e^y", "", ("exp(x + y) == exp(x)*exp(y)", "")),
        (
            r"\mathrm{e}^{-x}(1 + x) \le 1",
            "",
            ("exp(-x)*(1 + x) <= 1", ""),
        ),
        ("e^2 < 1", "e in (0, 1)", ("e^2 < 1", "e in (0, 1)")),
        ("e = e", "", ("e == e", "")),
        (
            r"\sqrt{x^2} = x (x \ge 0)",
            "",
            ("sqrt(x^2) == x", "x >= 0"),
        ),
    ] {
        let read =
            latex_question(print, setting).unwrap_or_else(|error| unreachable!("{print}: {error}"));
        assert_eq!((read.0.as_str(), read.1.as_str()), meant, "{print}");
    }
    for print in ["e^2 > 7", "e^x = e x", r"\ln e = 1"] {
        let error = latex_question(print, "")
            .err()
            .map(|error| error.to_string());
        assert!(
            error
                .as_ref()
                .is_some_and(|error| error.contains("read in two ways: `")
                    && error.contains("`e` is a number of the text")),
            "{print}: {error:?}"
        );
    }
}

#[test]
fn what_stands_behind_a_factorial_belongs_to_it_or_is_refused() {
    is("n!^2 = m", "", "factorial(n)^2 == m");
    is(
        r"\frac{(2m)!}{m!^2} = \binom{2m}{m}",
        "",
        "factorial(2*m)/factorial(m)^2 == binom(2*m, m)",
    );
    is("m!^{-1} = 1", "", "factorial(m)^(-1) == 1");
    is("(n!)! = n!", "", "factorial(factorial(n)) == factorial(n)");
    is_refused("n!! = 3", "", "n!", "double factorial");
    is_refused("n!_2 = 3", "", "2", "subscript");
    is_refused("n!' = 3", "", "!'", "prime");
}

#[test]
fn what_stands_behind_a_quotient_of_differentials_is_refused() {
    let setting = "f: function 1";
    is(r"\frac{d f(x)}{dx} = 1", setting, "D(f(x), x) == 1");
    is(
        r"\left(\frac{d f(x)}{dx}\right)^2 = 1",
        setting,
        "D(f(x), x)^2 == 1",
    );
    for print in [
        r"\frac{d f(x)}{dx}^2 = 1",
        r"\frac{d}{dx}^2 f(x) = 1",
        r"\frac{d}{dx}_2 f(x) = 1",
    ] {
        let error = read(print, setting).err();
        let error = error.unwrap_or_else(|| unreachable!("{print} is read"));
        assert!(error.message.contains("script"), "{print}: {error}");
    }
    is_refused(r"\sum'_{i=0}^n x^i = 1", "", r"\sum'_{i=0}^n", "prime");
}

#[test]
fn a_row_goes_on_behind_a_sign_and_two_rows_with_relations_are_two_formulas() {
    let two = "x == y and a == b";
    is(r"\begin{aligned} x &= y \\ a &= b \end{aligned}", "", two);
    is(r"\begin{aligned} x &= y, \\ a &= b \end{aligned}", "", two);
    is(r"x = y \\ a = b", "", two);
    let one = "x == y + a - b";
    is(
        r"\begin{split} x &= y \\ &\quad + a - b \end{split}",
        "",
        one,
    );
    is(r"\begin{split} x = {}& y + \\ & a - b \end{split}", "", one);
    is(
        r"\begin{split} x = {}& y \\ & {} + a - b \end{split}",
        "",
        one,
    );
    is(
        r"\begin{split} x &= y \\ &= a \end{split}",
        "",
        "x == y == a",
    );
    let product = r"\begin{split} x &= y \\ & a \end{split}";
    is_refused(product, "", "a", "a new row");
}

#[test]
fn a_print_that_reads_as_something_else_is_refused() {
    is_refused("y = sin(x)", "s, i in (-inf, inf)", "s", "product");
    is(r"y = \sin(x)", "", "y == sin(x)");
    is_refused(r"y = 2\tfrac12", "", r"\tfrac12", "mixed number");
    is(r"y = 2 \cdot \tfrac12", "", "y == 2*(1/2)");
    is(r"y = 2\frac{x}{2}", "", "y == 2*(x/2)");
    is_refused("y = 10{,}5", "", "10{,}5", "thousands");
    is_refused(r"e^{ix} = 1", "i in (-inf, inf)", "e^{ix}", "imaginary");
    is(
        r"\sum_{i=0}^n e^{ix} = 1",
        "",
        "sum(i, 0, n, exp(i*x)) == 1",
    );
    is_refused(r"\int_0^1 dx\, x = 1", "", r"\int_0^1", "differential");
    is(r"\int_0^1 x\,dx = 1", "", "integral(x, x, 0, 1) == 1");
    is(r"\int_0^1 dx = 1", "", "integral(1, x, 0, 1) == 1");
}
