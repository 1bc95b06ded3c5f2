//! What names of Python mean: those that a file binds, those that it imports, and those that are always there.
//!
//! A name has a meaning only if exactly one thing in the whole file binds it, outside of functions and unconditionally. Whoever asks
//! for another name is told why it has none.

use super::bindings::{Import, bindings, declared_global, imported, imported_whole};
use super::meaning::{MODULES, Meaning, built_in, meaning};
use super::unsure::unsure;
use crate::grammar::{CodeNode, Text, children, within};
use std::collections::{BTreeMap, BTreeSet};

/// The names of a file.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    /// What binds each name outside of functions, once for each time.
    bound: BTreeMap<String, Vec<Bound>>,
    /// The modules of which all names are imported, with the places.
    whole: Vec<(String, usize)>,
    /// The modules within modules that are imported: `a.b`.
    inner: BTreeSet<String>,
    /// Where imports end that may give names that are read another meaning.
    last_import: usize,
    /// The line at which any name may get another meaning.
    unsure: Option<usize>,
}

/// One thing that binds a name.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Bound {
    what: What,
    position: usize,
    line: usize,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum What {
    Import {
        module: String,
        member: Option<String>,
    },
    Function,
    Value,
    /// A class, or what is bound within a statement, and perhaps not at all.
    Other,
}

/// What a name is that is sure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sure {
    /// A function of the file.
    Function,
    /// A value of the file.
    Value,
    /// Something else of the file, or a name of another file: not read.
    Unread,
    /// What is imported, or always there.
    Known(Meaning),
    /// Nothing that is known.
    Unknown,
}

/// All names of `math`, later ones of it among them.
const OF_MATH: [&str; 68] = [
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "cbrt",
    "ceil",
    "comb",
    "copysign",
    "cos",
    "cosh",
    "degrees",
    "dist",
    "e",
    "erf",
    "erfc",
    "exp",
    "exp2",
    "expm1",
    "fabs",
    "factorial",
    "floor",
    "fma",
    "fmax",
    "fmin",
    "fmod",
    "frexp",
    "fsum",
    "gamma",
    "gcd",
    "hypot",
    "inf",
    "integer",
    "isclose",
    "isfinite",
    "isinf",
    "isnan",
    "isnormal",
    "isqrt",
    "issubnormal",
    "lcm",
    "ldexp",
    "lgamma",
    "log",
    "log10",
    "log1p",
    "log2",
    "modf",
    "nan",
    "nextafter",
    "perm",
    "pi",
    "pow",
    "prod",
    "radians",
    "remainder",
    "signbit",
    "sin",
    "sinh",
    "sqrt",
    "sumprod",
    "tan",
    "tanh",
    "tau",
    "trunc",
    "ulp",
];

/// Whether all names of a module may have this one among them.
fn may_have(module: &str, name: &str, is_module: bool) -> bool {
    match module {
        "math" => OF_MATH.contains(&name),
        // Nothing of these is called like a module elsewhere.
        _ => !(is_module && MODULES.contains(&module)),
    }
}

impl Names {
    /// The names of a file with these statements.
    pub(super) fn new(text: Text<'_>, root: CodeNode<'_>) -> Self {
        let statements = children(root);
        let mut names = Self::default();
        let mut all = bindings(text, &statements);
        all.extend(declared_global(text, root));
        let mut outside: BTreeMap<String, usize> = BTreeMap::new();
        for (name, node) in &all {
            let first = outside.entry(name.clone()).or_insert(usize::MAX);
            *first = node.start_byte().min(*first);
        }
        let line = |node: CodeNode<'_>| node.start_position().row + 1;
        let is_at_top = |node: CodeNode<'_>| {
            statements.iter().any(|own| {
                let inner = match own.kind() {
                    "expression_statement" => children(*own).first().copied(),
                    "decorated_definition" => own.child_by_field_name("definition"),
                    _ => None,
                };
                *own == node || inner == Some(node)
            })
        };
        for (name, node) in all {
            let whats = match node.kind() {
                _ if !is_at_top(node) => vec![What::Other],
                "function_definition" => vec![What::Function],
                "assignment" => vec![What::Value],
                "import_statement" | "import_from_statement" => {
                    let own = imported(text, node).into_iter();
                    let own = own.filter(|import| import.name == name);
                    let what = |Import { module, member, .. }| What::Import { module, member };
                    own.map(what).collect()
                }
                _ => vec![What::Other],
            };
            let own = names.bound.entry(name).or_default();
            for what in whats {
                let bound = Bound {
                    what,
                    position: node.start_byte(),
                    line: line(node),
                };
                if !own.contains(&bound) {
                    own.push(bound);
                }
            }
        }
        for node in within(root).filter(|node| node.kind().starts_with("import_")) {
            names.note(text, node);
        }
        names.whole.sort_by_key(|(_, position)| *position);
        names.unsure = unsure(text, root, &outside).map(line);
        names
    }

    /// Notes an import.
    fn note(&mut self, text: Text<'_>, node: CodeNode<'_>) {
        let position = node.start_byte();
        let whole = imported_whole(text, node);
        let imports = imported(text, node);
        let module = |import: &Import| match &import.member {
            Some(member) => MODULES.contains(&format!("{}.{member}", import.module).as_str()),
            None => false,
        };
        let is_read = imports.iter().any(|import| {
            let first = |path: &str| path.split('.').next().map(str::to_owned);
            let mut roots = MODULES.iter().map(|own| first(own));
            module(import) || roots.any(|own| own == first(&import.module))
        });
        if is_read || whole.is_some() {
            self.last_import = self.last_import.max(position);
        }
        self.whole.extend(whole.map(|module| (module, position)));
        self.inner
            .extend(imports.into_iter().filter_map(|import| import.inner));
    }

    /// Whether an import that matters comes after a place: what is computed there may have used other names.
    pub(super) fn is_before_imports(&self, position: usize) -> bool {
        self.last_import > position
    }

    /// The names of functions of the file.
    pub(super) fn functions(&self) -> BTreeSet<String> {
        let is_function = |all: &Vec<Bound>| all.iter().any(|own| own.what == What::Function);
        let functions = self.bound.iter().filter(|(_, all)| is_function(all));
        functions.map(|(name, _)| name.clone()).collect()
    }

    /// The one thing that binds a name; none if nothing does, and the reason if it is not sure.
    fn only(&self, name: &str) -> Result<Option<&Bound>, String> {
        if let Some(line) = self.unsure {
            return Err(format!(
                "what names mean in this file is not sure: line {line} may change it"
            ));
        }
        let Some(all) = self.bound.get(name) else {
            return Ok(None);
        };
        let [first, rest @ ..] = all.as_slice() else {
            return Ok(None);
        };
        let is_import = matches!(first.what, What::Import { .. });
        if rest
            .iter()
            .any(|other| !is_import || other.what != first.what)
        {
            let mut lines: Vec<usize> = all.iter().map(|bound| bound.line).collect();
            lines.sort_unstable();
            let lines: Vec<String> = lines.iter().map(usize::to_string).collect();
            return Err(format!(
                "`{name}` gets a meaning more than once in this file: in lines {}",
                lines.join(", ")
            ));
        }
        let own = match &first.what {
            What::Import {
                module,
                member: Some(member),
            } => meaning(module, member),
            _ => None,
        };
        let last = all.iter().map(|bound| bound.position).max().unwrap_or(0);
        for (module, position) in &self.whole {
            let is_same = own.is_some() && meaning(module, name) == own;
            let is_module = matches!(first.what, What::Import { member: None, .. });
            if *position > last && !is_same && may_have(module, name, is_module) {
                return Err(format!(
                    "`{name}` may get another meaning from all the names of `{module}` that are imported after it"
                ));
            }
        }
        Ok(Some(first))
    }

    /// What a name alone is, or why that is not sure.
    pub(super) fn name(&self, name: &str) -> Result<Sure, String> {
        if let Some(bound) = self.only(name)? {
            return Ok(match &bound.what {
                What::Function => Sure::Function,
                What::Value => Sure::Value,
                What::Other => {
                    return Err(format!(
                        "`{name}` gets its meaning in line {}, in a way that is not read",
                        bound.line
                    ));
                }
                What::Import {
                    module,
                    member: Some(member),
                } => meaning(module, member).map_or(Sure::Unread, Sure::Known),
                What::Import { member: None, .. } => Sure::Unread,
            });
        }
        // The last import of all names has it, or may have it with a meaning that is not read.
        let last = self.whole.last().map(|(module, _)| module.as_str());
        if let Some(found) = last.and_then(|last| meaning(last, name)) {
            return Ok(Sure::Known(found));
        }
        let mut modules = self.whole.iter().map(|(module, _)| module.as_str());
        let is_one = modules.all(|module| MODULES.contains(&module) && Some(module) == last);
        let is_numpy = last == Some("numpy");
        // NumPy has its own of these.
        let is_other = is_numpy && matches!(name, "abs" | "min" | "max" | "pow");
        let found = built_in(name).filter(|_| is_one && !is_other);
        Ok(found.map_or(Sure::Unknown, Sure::Known))
    }

    /// The module that `a` or `a.b` is, if it is one, or why that is not sure.
    pub(super) fn module(&self, object: &str) -> Result<Option<String>, String> {
        let (first, rest) = match object.split_once('.') {
            Some((first, rest)) => (first, Some(rest)),
            None => (object, None),
        };
        if !self.bound.get(first).is_some_and(|all| {
            let mut all = all.iter();
            all.any(|bound| matches!(bound.what, What::Import { .. }))
        }) {
            return Ok(None);
        }
        let Some(Bound {
            what: What::Import { module, member },
            ..
        }) = self.only(first)?
        else {
            return Ok(None);
        };
        let path = match member {
            Some(member) => format!("{module}.{member}"),
            None => module.clone(),
        };
        let is_module = member.is_none() || MODULES.contains(&path.as_str());
        Ok(match rest {
            None => is_module.then_some(path),
            Some(_) => self.inner.contains(object).then(|| object.to_owned()),
        })
    }

    /// The module and the name there of a name, or of a member of a module.
    pub(super) fn origin(&self, object: Option<&str>, name: &str) -> Option<(String, String)> {
        match object {
            Some(object) => Some((self.module(object).ok()??, name.to_owned())),
            None => match &self.only(name).ok()??.what {
                What::Import {
                    module,
                    member: Some(member),
                } => Some((module.clone(), member.clone())),
                _ => None,
            },
        }
    }
}
