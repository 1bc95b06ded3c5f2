//! What names of Python mean: those that a file imports, and those that are always there.

use crate::grammar::{CodeNode, Read, Text, children};
use crate::program::operation;
use std::collections::BTreeMap;

/// The names that a file imports.
#[derive(Debug, Clone, Default)]
pub(super) struct Imports {
    /// The modules by the names that they have in the file.
    modules: BTreeMap<String, String>,
    /// Single names: the module and the name there.
    names: BTreeMap<String, (String, String)>,
    /// The modules of which all names are imported.
    whole: Vec<String>,
}

/// What a name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    /// A function of formulas, or an operation, of the same arguments.
    Function(&'static str),
    /// The number pi, and the base of the exponentials.
    Pi,
    /// The same.
    E,
    /// `Rational(p, q)`: a quotient, or a number alone.
    Quotient,
    /// What returns its argument, as far as values are concerned.
    Same,
    /// `pow(a, b)`.
    Power,
    /// `square(a)`.
    Square,
    /// SymPy's `diff`.
    Derivative,
    /// SymPy's `Integral` and `integrate`.
    Integral,
    /// SymPy's `Sum` and `Product`, with a tuple of a symbol and its bounds.
    Series(&'static str),
    /// SymPy's `symbols`.
    Symbols,
    /// `range`.
    Range,
    /// `zeros(n)` and `ones(n)`.
    Filled(i64),
}

/// The modules that are read.
const MODULES: [&str; 5] = ["math", "numpy", "sympy", "scipy.special", "fractions"];

impl Imports {
    /// Reads a statement that imports something.
    pub(super) fn add(&mut self, text: Text<'_>, node: CodeNode<'_>) -> Read<()> {
        if node.kind() == "import_statement" {
            for name in children(node) {
                let (module, alias) = renamed(text, name)?;
                self.modules.insert(alias, module);
            }
            return Ok(());
        }
        let module = text.text(text.field(node, "module_name")?).to_owned();
        for name in children(node).into_iter().skip(1) {
            if name.kind() == "wildcard_import" {
                self.whole.push(module.clone());
                continue;
            }
            let (name, alias) = renamed(text, name)?;
            let inner = format!("{module}.{name}");
            if MODULES.contains(&inner.as_str()) {
                self.modules.insert(alias, inner);
            } else {
                self.names.insert(alias, (module.clone(), name));
            }
        }
        Ok(())
    }

    /// What a name alone means, if it is imported or always there.
    pub(super) fn name(&self, name: &str) -> Option<Meaning> {
        if let Some((module, name)) = self.names.get(name) {
            return meaning(module, name);
        }
        let imported = self.whole.iter().rev();
        let mut imported = imported.filter_map(|module| meaning(module, name));
        imported.next().or_else(|| built_in(name))
    }

    /// Whether a name is a module.
    pub(super) fn is_module(&self, name: &str) -> bool {
        self.modules.contains_key(name)
    }

    /// What a name of a module means.
    pub(super) fn member(&self, module: &str, name: &str) -> Option<Meaning> {
        meaning(self.modules.get(module)?, name)
    }
}

/// A name and the name that it has in the file.
fn renamed(text: Text<'_>, node: CodeNode<'_>) -> Read<(String, String)> {
    if node.kind() == "aliased_import" {
        let name = text.text(text.field(node, "name")?);
        let alias = text.text(text.field(node, "alias")?);
        return Ok((name.to_owned(), alias.to_owned()));
    }
    let name = text.text(node).to_owned();
    Ok((name.clone(), name))
}

/// What a name of a module means, if it is read.
fn meaning(module: &str, name: &str) -> Option<Meaning> {
    use Meaning::{
        Derivative, E, Filled, Function, Integral, Pi, Power, Quotient, Same, Series, Square,
        Symbols,
    };
    if !MODULES.contains(&module) {
        return None;
    }
    if let Some(function) = elementary(name) {
        return (module != "fractions").then_some(Function(function));
    }
    Some(match (module, name) {
        ("math" | "numpy" | "sympy", "pi") => Pi,
        ("math" | "numpy", "e") | ("sympy", "E") => E,
        ("math" | "scipy.special", "comb") | ("sympy", "binomial") | ("scipy.special", "binom") => {
            Function("binom")
        }
        ("math" | "sympy" | "scipy.special", "factorial") => Function("factorial"),
        ("math", "fabs") | ("numpy", "abs" | "absolute" | "fabs") | ("sympy", "Abs") => {
            Function("abs")
        }
        ("numpy", "minimum" | "fmin") | ("sympy", "Min") => Function("min"),
        ("numpy", "maximum" | "fmax") | ("sympy", "Max") => Function("max"),
        ("math" | "numpy" | "sympy", "pow" | "power" | "Pow") => Power,
        ("numpy", "square") => Square,
        ("sympy", "Rational") | ("fractions", "Fraction") => Quotient,
        (
            "sympy",
            "S" | "Integer" | "sympify" | "simplify" | "expand" | "factor" | "together" | "cancel"
            | "trigsimp" | "nsimplify" | "apart" | "collect",
        )
        | ("numpy", "float64") => Same,
        ("sympy", "symbols" | "Symbol") => Symbols,
        ("sympy", "diff" | "Derivative") => Derivative,
        ("sympy", "integrate" | "Integral") => Integral,
        ("sympy", "Sum" | "summation") => Series("sum"),
        ("sympy", "Product" | "product") => Series("product"),
        ("numpy", "array" | "asarray") | ("sympy", "Matrix") => Function(operation::VECTOR),
        ("numpy", "copy") => Function(operation::COPY),
        ("numpy", "zeros") => Filled(0),
        ("numpy", "ones") => Filled(1),
        ("numpy" | "math", "sum" | "fsum") => Function(operation::SUM),
        ("numpy" | "math", "prod") => Function(operation::PRODUCT),
        ("numpy", "dot") => Function("dot"),
        ("numpy", "cross") => Function("cross"),
        _ => return None,
    })
}

/// Functions that have the same name everywhere.
fn elementary(name: &str) -> Option<&'static str> {
    let all = [
        "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "sqrt", "atan", "asin", "acos",
    ];
    // NumPy's names of the inverse functions.
    let name = match name {
        "arctan" => "atan",
        "arcsin" => "asin",
        "arccos" => "acos",
        own => own,
    };
    all.into_iter().find(|known| *known == name)
}

/// What a name means that is always there.
fn built_in(name: &str) -> Option<Meaning> {
    use Meaning::Function;
    Some(match name {
        "abs" => Function("abs"),
        "min" => Function("min"),
        "max" => Function("max"),
        "len" => Function(operation::LENGTH),
        "sum" => Function(operation::SUM),
        "list" | "tuple" => Function(operation::COPY),
        "float" => Meaning::Same,
        "pow" => Meaning::Power,
        "range" => Meaning::Range,
        "enumerate" => Function(operation::ENUMERATE),
        "zip" => Function(operation::ZIP),
        "reversed" => Function(operation::REVERSED),
        _ => return None,
    })
}
