//! What names of Python mean: those that a file imports, and those that are always there.

use crate::grammar::{CodeNode, Read, Text, children};
use crate::program::operation;
use std::collections::{BTreeMap, BTreeSet};

/// The names that a file imports, each with the position of the import in the file.
#[derive(Debug, Clone, Default)]
pub(super) struct Imports {
    /// The modules by the names that they have in the file.
    modules: BTreeMap<String, (String, usize)>,
    /// Single names: the module and the name there.
    names: BTreeMap<String, (String, String, usize)>,
    /// The modules of which all names are imported.
    whole: Vec<String>,
    /// The last import of all names.
    last_whole: usize,
    /// The last import of all names of a module that is not read: what was imported before it may have another meaning.
    unknown: Option<usize>,
    /// Names that may get another meaning outside of functions.
    disturbed: BTreeSet<String>,
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
    /// What makes an integer of its argument.
    Whole,
    /// The smallest or the greatest of several numbers.
    Extremum(&'static str),
    /// The smaller or the greater of two numbers.
    ExtremumOfTwo(&'static str),
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
        let position = node.start_byte();
        if node.kind() == "import_statement" {
            for name in children(node) {
                let (module, alias) = renamed(text, name)?;
                self.names.remove(&alias);
                self.modules.insert(alias, (module, position));
            }
            return Ok(());
        }
        let module = text.text(text.field(node, "module_name")?).to_owned();
        for name in children(node).into_iter().skip(1) {
            if name.kind() == "wildcard_import" {
                if MODULES.contains(&module.as_str()) {
                    self.whole.push(module.clone());
                    self.last_whole = position;
                } else {
                    self.unknown = Some(position);
                }
                continue;
            }
            let (name, alias) = renamed(text, name)?;
            let inner = format!("{module}.{name}");
            if MODULES.contains(&inner.as_str()) {
                self.names.remove(&alias);
                self.modules.insert(alias, (inner, position));
            } else {
                self.modules.remove(&alias);
                self.names.insert(alias, (module.clone(), name, position));
            }
        }
        Ok(())
    }

    /// Notes names that get a meaning outside of functions in other ways than by one definition or import.
    pub(super) fn disturb(&mut self, names: impl IntoIterator<Item = String>) {
        self.disturbed.extend(names);
    }

    /// Whether a name may have another meaning than what is written at a place.
    pub(super) fn is_hidden(&self, name: &str, position: usize) -> bool {
        self.disturbed.contains(name) || self.unknown.is_some_and(|unknown| unknown > position)
    }

    /// Whether all names of a module are imported after a place.
    pub(super) fn is_before_whole(&self, position: usize) -> bool {
        self.last_whole > position
    }

    /// The module and the name there of a name, or of a member of a module.
    pub(super) fn origin(&self, object: Option<&str>, name: &str) -> Option<(&str, String)> {
        match object {
            None => {
                let (module, own, position) = self.names.get(name)?;
                (!self.is_hidden(name, *position)).then(|| (module.as_str(), own.clone()))
            }
            Some(object) => {
                let (module, position) = self.modules.get(object)?;
                (!self.is_hidden(object, *position)).then(|| (module.as_str(), name.to_owned()))
            }
        }
    }

    /// What a name alone means, if it is imported or always there.
    pub(super) fn name(&self, name: &str) -> Option<Meaning> {
        // The last import of all names has them, or may have them with a meaning that is not read.
        let last = self.whole.last();
        if let Some((module, own, position)) = self.names.get(name) {
            let found = meaning(module, own).filter(|_| !self.is_hidden(name, *position));
            let is_last = *position > self.last_whole
                || last.is_none_or(|last| last == module || meaning(last, name) == found);
            return found.filter(|_| is_last);
        }
        if self.is_hidden(name, self.last_whole) || self.modules.contains_key(name) {
            return None;
        }
        if let Some(found) = last.and_then(|last| meaning(last, name)) {
            return Some(found);
        }
        let is_one = self.whole.windows(2).all(|pair| pair[0] == pair[1]);
        let is_numpy = last.is_some_and(|last| last == "numpy");
        // NumPy has its own of these.
        let is_other = is_numpy && matches!(name, "abs" | "min" | "max" | "pow");
        built_in(name).filter(|_| self.unknown.is_none() && is_one && !is_other)
    }

    /// Whether a name is a module.
    pub(super) fn is_module(&self, name: &str) -> bool {
        self.modules.contains_key(name)
    }

    /// What a name of a module means.
    pub(super) fn member(&self, module: &str, name: &str) -> Option<Meaning> {
        let (origin, name) = self.origin(Some(module), name)?;
        meaning(origin, &name)
    }
}

/// The names that an import gives a meaning.
pub(super) fn imported(text: Text<'_>, node: CodeNode<'_>) -> Vec<String> {
    let skipped = usize::from(node.kind() != "import_statement");
    let names = children(node).into_iter().skip(skipped);
    let names = names.filter_map(|name| renamed(text, name).ok());
    // `import a.b` gives `a` a meaning.
    names
        .map(|(_, alias)| alias.split('.').next().unwrap_or("").to_owned())
        .collect()
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
        Derivative, E, Extremum, ExtremumOfTwo, Filled, Function, Integral, Pi, Power, Quotient,
        Same, Series, Square, Symbols, Whole,
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
        ("numpy", "minimum" | "fmin") => ExtremumOfTwo("min"),
        ("numpy", "maximum" | "fmax") => ExtremumOfTwo("max"),
        ("sympy", "Min") => Extremum("min"),
        ("sympy", "Max") => Extremum("max"),
        ("sympy", "Integer") => Whole,
        ("math" | "numpy" | "sympy", "pow" | "power" | "Pow") => Power,
        ("numpy", "square") => Square,
        ("sympy", "Rational") | ("fractions", "Fraction") => Quotient,
        (
            "sympy",
            "S" | "sympify" | "simplify" | "expand" | "factor" | "together" | "cancel" | "trigsimp"
            | "nsimplify" | "apart" | "collect",
        )
        | ("numpy", "float64") => Same,
        ("sympy", "symbols" | "Symbol") => Symbols,
        ("sympy", "diff" | "Derivative") => Derivative,
        ("sympy", "integrate" | "Integral") => Integral,
        ("sympy", "Sum" | "summation") => Series(operation::SUMMED),
        ("sympy", "Product" | "product") => Series(operation::MULTIPLIED),
        ("numpy", "array" | "copy") => Function(operation::VECTOR),
        ("numpy", "asarray") => Function(operation::AS_VECTOR),
        ("sympy", "Matrix") => Function(operation::MATRIX),
        ("numpy", "zeros") => Filled(0),
        ("numpy", "ones") => Filled(1),
        ("numpy", "sum") => Function(operation::TOTAL),
        ("math", "fsum") => Function(operation::SUM),
        ("numpy", "prod") => Function(operation::TOTAL_PRODUCT),
        ("math", "prod") => Function(operation::PRODUCT),
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
        "list" | "tuple" => Function(operation::LIST),
        "float" => Meaning::Same,
        "pow" => Meaning::Power,
        "range" => Meaning::Range,
        "enumerate" => Function(operation::ENUMERATE),
        "zip" => Function(operation::ZIP),
        "reversed" => Function(operation::REVERSED),
        _ => return None,
    })
}
