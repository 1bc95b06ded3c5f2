//! Derivations as code: control points and results become plain variables, `Q[m-2]` is `Q_m_2`.

use super::Derivation;
use std::fmt::Write as _;
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation;

/// A derivation whose points and results are variables.
pub(super) struct Code {
    /// The given points: formula and variable.
    pub points: Vec<(Expr, Expr)>,
    /// Names with their values, in an order in which they can be computed.
    pub values: Vec<(Expr, Expr)>,
    /// The results: formula and variable.
    pub results: Vec<(Expr, Expr)>,
    /// The conditions.
    pub conditions: Vec<Expr>,
}

impl Code {
    pub fn from_derivation(derivation: &Derivation) -> Self {
        let named = |formula: &Expr| (formula.clone(), Expr::name(&variable(formula)));
        let points: Vec<(Expr, Expr)> = derivation.points.iter().map(named).collect();
        let lines = derivation.lines.iter();
        let results: Vec<(Expr, Expr)> = lines
            .clone()
            .filter(|line| !line.is_abbreviation())
            .map(|line| named(&line.left))
            .collect();
        let known: Vec<(Expr, Expr)> = points.iter().chain(&results).cloned().collect();
        let values = lines
            .map(|line| (replaced(&line.left, &known), replaced(&line.right, &known)))
            .collect();
        let conditions = derivation.conditions.iter();
        let conditions = conditions.map(|c| replaced(c, &known)).collect();
        Self {
            points,
            values,
            results,
            conditions,
        }
    }
}

/// A point or a derivative as an identifier: `Q[m-2]` is `Q_m_2`, `G''(0)` is `G_d2_0`.
fn variable(formula: &Expr) -> String {
    let text = match &formula.node {
        Node::Call(head, arguments) => {
            let head = notation::sympy(head);
            let arguments = arguments.iter().map(notation::text);
            format!("{head}_{}", arguments.collect::<Vec<_>>().join("_"))
        }
        _ => notation::text(formula),
    };
    let mut name = String::new();
    for c in text.chars() {
        match c {
            c if c.is_ascii_alphanumeric() => name.push(c),
            ']' | ')' => {}
            _ if name.ends_with('_') => {}
            _ => name.push('_'),
        }
    }
    name
}

/// Replaces formulas that have a variable by the variable.
fn replaced(formula: &Expr, known: &[(Expr, Expr)]) -> Expr {
    if let Some((_, name)) = known.iter().find(|(whole, _)| whole == formula) {
        return name.clone();
    }
    formula.with_parts(|part| replaced(part, known))
}

/// Joins the texts with commas.
fn listed(items: impl IntoIterator<Item = String>) -> String {
    items.into_iter().collect::<Vec<_>>().join(", ")
}

fn texts(items: &[(Expr, Expr)]) -> String {
    listed(
        items
            .iter()
            .map(|(formula, _)| format!("`{}`", notation::text(formula))),
    )
}

/// A function on doubles: one coordinate of the points in, one coordinate of the results out.
pub(super) fn rust(derivation: &Derivation) -> String {
    let code = Code::from_derivation(derivation);
    let names = |items: &[(Expr, Expr)]| listed(items.iter().map(|(_, v)| notation::rust(v)));
    let numbers = derivation.degrees.iter().chain(&derivation.parameters);
    let numbers = numbers.map(|n| format!("{}: f64", notation::rust(&Expr::name(n))));
    let points = format!("points: [f64; {}]", code.points.len());
    let mut text = format!(
        "/// {}.\n///\n/// One coordinate of the points {} in, one coordinate of {} out.\n",
        derivation.title,
        texts(&code.points),
        texts(&code.results)
    );
    let conditions = derivation.conditions.iter();
    let conditions = listed(conditions.map(|c| format!("`{}`", notation::text(c))));
    if !conditions.is_empty() {
        let _ = writeln!(text, "///\n/// Where {conditions}.");
    }
    text.push_str("#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]\n");
    let _ = writeln!(
        text,
        "pub fn {}({}) -> [f64; {}] {{",
        function(derivation),
        listed(numbers.chain([points])),
        code.results.len()
    );
    let _ = writeln!(text, "    let [{}] = points;", names(&code.points));
    for (name, value) in &code.values {
        let (name, value) = (notation::rust(name), notation::rust(value));
        let _ = writeln!(text, "    let {name} = {value};");
    }
    let _ = writeln!(text, "    [{}]\n}}", names(&code.results));
    text
}

/// Returns the name of the function: the head of the results.
fn function(derivation: &Derivation) -> &'static str {
    let of_curve = derivation
        .lines
        .iter()
        .any(|line| matches!(line.left.node, Node::Call(..)));
    if of_curve {
        "end_derivatives"
    } else {
        "next_points"
    }
}

/// The names that a module may import from SymPy.
const IMPORTED: [&str; 9] = [
    "Ge", "Ne", "Rational", "cos", "exp", "pi", "sin", "sqrt", "sympify",
];

/// A module that defines every symbol and computes the results symbolically.
pub(super) fn sympy(derivation: &Derivation) -> String {
    let code = Code::from_derivation(derivation);
    let points = code.points.iter().map(|(_, name)| notation::text(name));
    let mut body = symbols(&derivation.degrees, "integer=True, positive=True");
    body += &symbols(&derivation.parameters, "real=True");
    body += &symbols(&points.collect::<Vec<_>>(), "real=True");
    body.push('\n');
    for (name, value) in &code.values {
        let (name, value) = (notation::sympy(name), notation::sympy(value));
        let _ = writeln!(body, "{name} = {value}");
    }
    let results = code.results.iter().map(|(formula, variable)| {
        let (formula, variable) = (notation::text(formula), notation::sympy(variable));
        format!("    \"{formula}\": {variable},\n")
    });
    let _ = write!(body, "\nresults = {{\n{}}}\n", results.collect::<String>());
    let conditions = code.conditions.iter().map(notation::sympy);
    let _ = writeln!(body, "conditions = [{}]", listed(conditions));
    let word = |c: char| !c.is_ascii_alphanumeric() && c != '_';
    let needed = IMPORTED
        .iter()
        .filter(|name| body.split(word).any(|w| w == **name));
    let imported = listed(needed.chain(&["symbols"]).map(ToString::to_string));
    format!(
        "\"\"\"{}.\"\"\"\n\nfrom sympy import {imported}\n\n{body}",
        derivation.title
    )
}

/// The definition of symbols with these names.
fn symbols(names: &[String], assumptions: &str) -> String {
    if names.is_empty() {
        return String::new();
    }
    let left = listed(names.iter().map(|n| notation::sympy(&Expr::name(n))));
    format!("{left} = symbols(\"{}\", {assumptions})\n", names.join(" "))
}
