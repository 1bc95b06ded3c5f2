//! From a formula to boxes: adds brackets where an operand needs them, and chooses the notation of each construct.
//!
//! Comparing levels decides on brackets: every box has the level at which it holds together, every place of an operand
//! the level that it requires.

use crate::letters::printed_function;
use crate::math_box::{Fence, MathBox as Shown, MathChange};
use crate::names::PrintedNames;
use crate::tidy::terms;
use torse_syntax::formula::{Connective, Expr, Node, Operator, Relation};
use torse_syntax::notation::text;

/// Marks of changes: functions whose names no file can write.
pub(crate) const ADDED: &str = "+added";
pub(crate) const REMOVED: &str = "-removed";
/// Marks of the sign before a term, where the term stays; where no sign is drawn, nothing is marked.
pub(crate) const SIGN_ADDED: &str = "+sign added";
pub(crate) const SIGN_REMOVED: &str = "-sign removed";

/// How tightly a box holds together, loosest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Implies,
    Or,
    And,
    Not,
    Relation,
    Sum,
    /// Needs no brackets as a summand, but does as a factor: a dot product.
    Term,
    /// Like a term, but captures everything after it: a sum with its sign.
    Open,
    Product,
    /// Begins with a minus sign.
    Negative,
    /// Needs no brackets as a factor, but does as the base of a power.
    Power,
    Atom,
}

struct Piece {
    level: Level,
    node: Shown,
}

impl Piece {
    fn new(level: Level, node: Shown) -> Self {
        Piece { level, node }
    }

    fn at_least(self, level: Level) -> Shown {
        match self.level < level {
            true => self.node.round(),
            false => self.node,
        }
    }
}

/// Lays out the formula as boxes.
pub(crate) fn layout(formula: &Expr, names: &PrintedNames) -> Shown {
    Writer { names }.write(formula).node
}

struct Writer<'a> {
    names: &'a PrintedNames,
}

impl Writer<'_> {
    fn inner(&self, expr: &Expr) -> Shown {
        self.write(expr).node
    }

    fn operand(&self, expr: &Expr, level: Level) -> Shown {
        self.write(expr).at_least(level)
    }

    fn listed(&self, items: &[Expr]) -> Shown {
        Shown::joined(items.iter().map(|item| self.inner(item)), ',')
    }

    fn write(&self, expr: &Expr) -> Piece {
        match &expr.node {
            Node::Number { .. } => Piece::new(Level::Atom, Shown::Number(text(expr))),
            Node::Name(name) => self.named(name, 0, vec![]),
            Node::Call(head, arguments) => self.call(head, arguments),
            Node::Index(head, indices) => self.index(head, indices),
            Node::Negative(inner) => self.negative(inner),
            Node::Binary(Operator::Add | Operator::Subtract, ..) => self.sum(expr),
            Node::Binary(Operator::Multiply, a, b) => self.product(a, b),
            Node::Binary(Operator::Divide, a, b) => {
                let fraction = Shown::Fraction(Box::new(self.inner(a)), Box::new(self.inner(b)));
                Piece::new(Level::Power, fraction)
            }
            Node::Binary(Operator::Power, a, b) => self.power(a, b),
            Node::List(items) => Piece::new(Level::Atom, self.list(items)),
            Node::Compare(first, rest) => {
                let mut nodes = vec![self.operand(first, Level::Sum)];
                for (relation, side) in rest {
                    nodes.push(Shown::Sign(sign(*relation)));
                    nodes.push(self.operand(side, Level::Sum));
                }
                Piece::new(Level::Relation, Shown::row(nodes))
            }
            Node::Join(connective, a, b) => self.join(*connective, a, b),
            Node::Not(inner) => self.denied("not", inner),
        }
    }

    fn named(&self, name: &str, primes: usize, indices: Vec<Shown>) -> Piece {
        let node = self.names.name(name, primes, indices);
        let level = match &node {
            Shown::Row(nodes) => match nodes.last() {
                Some(Shown::Fenced(..)) => Level::Power,
                _ => Level::Sum,
            },
            Shown::Scripts { primes, above, .. } if *primes > 0 || above.is_some() => Level::Power,
            _ => Level::Atom,
        };
        Piece::new(level, node)
    }

    fn negative(&self, inner: &Expr) -> Piece {
        let sign = marked_sign(inner, Shown::Sign('−'));
        let piece = self.write(inner);
        let level = piece.level.min(Level::Negative);
        match piece.level < Level::Term || piece.level == Level::Negative {
            true => Piece::new(Level::Negative, Shown::row([sign, piece.node.round()])),
            false => Piece::new(level, Shown::row([sign, piece.node])),
        }
    }

    fn sum(&self, expr: &Expr) -> Piece {
        let mut nodes = Vec::new();
        for (operator, term) in terms(expr) {
            let minus = operator == Operator::Subtract;
            let mark = mark_of(&term);
            let inner = mark.map_or(&term, |(_, inner)| inner);
            let piece = self.write(inner);
            let loose = piece.level < Level::Term || piece.level == Level::Negative;
            let term = match loose {
                true => piece.node.round(),
                false => piece.node,
            };
            let sign = match (nodes.is_empty(), minus) {
                (true, false) => None,
                (_, true) => Some(Shown::Sign('−')),
                (false, false) => Some(Shown::Sign('+')),
            };
            let sign = sign.map(|sign| marked_sign(inner, sign));
            match mark {
                // A sign belongs to its term.
                Some((mark, _)) => {
                    let whole = Shown::row(sign.into_iter().chain([term]));
                    nodes.push(Shown::Marked(mark, Box::new(whole)));
                }
                None => nodes.extend(sign.into_iter().chain([term])),
            }
        }
        Piece::new(Level::Sum, Shown::row(nodes))
    }

    fn product(&self, a: &Expr, b: &Expr) -> Piece {
        let left = self.operand(a, Level::Product);
        let right = self.write(b);
        let (level, right) = match right.level {
            Level::Open => (Level::Open, right.node),
            level if level >= Level::Power => (Level::Product, right.node),
            _ => (Level::Product, right.node.round()),
        };
        let dotted = right.begins_with_digit() || (left.ends_with_number() && right.is_fraction());
        let nodes = match dotted {
            true => vec![left, Shown::Sign('·'), right],
            false => vec![left, right],
        };
        Piece::new(level, Shown::row(nodes))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let above = self.inner(exponent);
        // sin²(x)
        if let Node::Call(head, arguments) = &base.node
            && let Node::Name(name) = &head.node
            && let Some(printed) = printed_function(name)
        {
            let head = Shown::Function(printed.to_owned()).scripted(0, None, Some(above));
            let arguments = self.listed(arguments).round();
            return Piece::new(Level::Power, Shown::row([head, arguments]));
        }
        let base = self.operand(base, Level::Atom);
        Piece::new(Level::Power, base.scripted(0, None, Some(above)))
    }

    fn index(&self, head: &Expr, indices: &[Expr]) -> Piece {
        // A[1][2] has one subscript, 1, 2.
        let mut all: Vec<&Expr> = indices.iter().collect();
        let mut head = head;
        while let Node::Index(inner, more) = &head.node {
            all.splice(0..0, more);
            head = inner;
        }
        if let Node::Call(function, arguments) = &head.node
            && let (Node::Name(name), [forms, symbols]) = (&function.node, arguments.as_slice())
            && name == "coefficients"
            && let (Node::List(forms), Node::List(symbols)) = (&forms.node, &symbols.node)
            && let ([form], [symbol]) = (forms.as_slice(), symbols.as_slice())
        {
            // The only entry.
            return self.rate(form, symbol);
        }
        let all: Vec<Shown> = all.iter().map(|index| self.inner(index)).collect();
        match &head.node {
            Node::Name(name) => self.named(name, 0, all),
            _ => {
                let head = self.operand(head, Level::Atom);
                let below = (!all.is_empty()).then(|| Shown::joined(all, ','));
                let head = match head {
                    taken @ Shown::Scripts { below: Some(_), .. } => taken.round(),
                    free => free,
                };
                Piece::new(Level::Atom, head.scripted(0, below, None))
            }
        }
    }

    fn list(&self, items: &[Expr]) -> Shown {
        match rows(items) {
            Some(rows) => Shown::Matrix(Fence::Round, self.cells(&rows)),
            None => self.listed(items).round(),
        }
    }

    fn cells(&self, rows: &[&[Expr]]) -> Vec<Vec<Shown>> {
        let cells = |row: &&[Expr]| row.iter().map(|cell| self.inner(cell)).collect();
        rows.iter().map(cells).collect()
    }

    fn join(&self, connective: Connective, a: &Expr, b: &Expr) -> Piece {
        // `and` and `or` group to the left, `implies` to the right.
        let (level, left, right, sign) = match connective {
            Connective::And => (Level::And, Level::And, Level::Not, "and"),
            Connective::Or => (Level::Or, Level::Or, Level::And, "or"),
            Connective::Implies => (Level::Implies, Level::Or, Level::Implies, "implies"),
        };
        let sign = [Shown::Gap, Shown::word(sign), Shown::Gap];
        let nodes = [self.operand(a, left)]
            .into_iter()
            .chain(sign)
            .chain([self.operand(b, right)]);
        Piece::new(level, Shown::row(nodes))
    }

    /// Writes `not`: the statement does not hold everywhere.
    fn denied(&self, words: &str, inner: &Expr) -> Piece {
        let words = Shown::word(words);
        let nodes = [words, Shown::Gap, self.operand(inner, Level::Relation)];
        Piece::new(Level::Not, Shown::row(nodes))
    }

    fn call(&self, head: &Expr, arguments: &[Expr]) -> Piece {
        if let Node::Name(name) = &head.node {
            if let Some(piece) = self.special(name, arguments) {
                return piece;
            }
            let function = match printed_function(name) {
                Some(printed) => Shown::Function(printed.to_owned()),
                None => self.names.name(name, 0, vec![]),
            };
            let arguments = self.listed(arguments).round();
            return Piece::new(Level::Atom, Shown::row([function, arguments]));
        }
        if let (Node::Call(d, derivative), [value]) = (&head.node, arguments)
            && matches!(&d.node, Node::Name(name) if name == "D")
            && let Some(piece) = self.derivative_at(derivative, value)
        {
            return piece;
        }
        let head = match &head.node {
            Node::Index(..) => self.inner(head),
            _ => self.operand(head, Level::Atom),
        };
        let arguments = self.listed(arguments).round();
        Piece::new(Level::Atom, Shown::row([head, arguments]))
    }

    /// Writes the functions of the language with a notation of their own, and its predicates in words.
    fn special(&self, name: &str, arguments: &[Expr]) -> Option<Piece> {
        let atom = |node| Piece::new(Level::Atom, node);
        let boxed = |expr| Box::new(self.inner(expr));
        let raised = |m, above| {
            let base = self.operand(m, Level::Atom);
            Piece::new(Level::Power, base.scripted(0, None, Some(above)))
        };
        let property = |words: &str, of: &Expr| {
            let nodes = [self.inner(of), Shown::Gap, Shown::word(words)];
            Piece::new(Level::Relation, Shown::row(nodes))
        };
        Some(match (name, arguments) {
            (ADDED, [x]) => self.marked(MathChange::Added, x),
            (REMOVED, [x]) => self.marked(MathChange::Removed, x),
            (SIGN_ADDED | SIGN_REMOVED, [x]) => self.write(x),
            ("sqrt", [x]) => atom(Shown::Root(boxed(x))),
            ("binom", [n, k]) => atom(Shown::Binomial(boxed(n), boxed(k))),
            ("norm", [v]) => atom(Shown::Fenced(Fence::Length, boxed(v))),
            ("abs", [x]) => atom(Shown::Fenced(Fence::Bars, boxed(x))),
            ("factorial", [n]) => {
                let nodes = [self.operand(n, Level::Atom), Shown::Sign('!')];
                Piece::new(Level::Power, Shown::row(nodes))
            }
            ("identity", [n]) => atom(Shown::italic("I").scripted(0, Some(self.inner(n)), None)),
            ("sum", [variable, from, to, body]) => {
                let below = [self.inner(variable), Shown::Sign('='), self.inner(from)];
                let sum = Shown::Sum {
                    below: Box::new(Shown::row(below)),
                    above: Some(boxed(to)),
                };
                let nodes = [sum, self.operand(body, Level::Open)];
                Piece::new(Level::Open, Shown::row(nodes))
            }
            ("product", [variable, from, to, body]) => {
                let below = [self.inner(variable), Shown::Sign('='), self.inner(from)];
                let sign = Shown::Sign('∏');
                let sign = sign.scripted(0, Some(Shown::row(below)), Some(self.inner(to)));
                let nodes = [sign, self.operand(body, Level::Product)];
                Piece::new(Level::Open, Shown::row(nodes))
            }
            ("integral", [body, variable, from, to]) => {
                let sign = Shown::Sign('∫');
                let sign = sign.scripted(0, Some(self.inner(from)), Some(self.inner(to)));
                let nodes = [
                    sign,
                    self.operand(body, Level::Term),
                    Shown::italic("d"),
                    self.inner(variable),
                ];
                Piece::new(Level::Open, Shown::row(nodes))
            }
            ("dot" | "cross", [a, b]) => {
                let sign = if name == "dot" { '·' } else { '×' };
                let nodes = [
                    self.operand(a, Level::Power),
                    Shown::Sign(sign),
                    self.operand(b, Level::Power),
                ];
                Piece::new(Level::Term, Shown::row(nodes))
            }
            ("det", [matrix]) => {
                if let Node::List(items) = &matrix.node
                    && let Some(rows) = rows(items)
                {
                    return Some(atom(Shown::Matrix(Fence::Bars, self.cells(&rows))));
                }
                let nodes = [
                    Shown::Function("det".to_owned()),
                    self.inner(matrix).round(),
                ];
                atom(Shown::row(nodes))
            }
            ("transpose", [m]) => raised(m, Shown::Sign('⊤')),
            ("inverse", [m]) => {
                raised(m, Shown::row([Shown::Sign('−'), Shown::Number("1".into())]))
            }
            ("solve", [m, b]) => {
                let inverse = Shown::row([Shown::Sign('−'), Shown::Number("1".into())]);
                let inverse = self
                    .operand(m, Level::Atom)
                    .scripted(0, None, Some(inverse));
                let nodes = [inverse, self.operand(b, Level::Power)];
                Piece::new(Level::Product, Shown::row(nodes))
            }
            ("coefficients", [forms, symbols]) => self.rate(forms, symbols),
            ("at", [body, variable, value]) => {
                let fenced = Shown::Fenced(Fence::Behind, boxed(body));
                let at = [self.inner(variable), Shown::Sign('='), self.inner(value)];
                let node = fenced.scripted(0, Some(Shown::row(at)), None);
                Piece::new(Level::Power, node)
            }
            ("agrees", [value, printed]) => {
                let nodes = [
                    self.operand(value, Level::Sum),
                    Shown::Sign('≈'),
                    self.operand(printed, Level::Sum),
                ];
                Piece::new(Level::Relation, Shown::row(nodes))
            }
            ("fails", [inner]) => self.denied("not everywhere", inner),
            ("nonnegative", [of]) => property("is nowhere negative", of),
            ("independent", [of]) => property("is linearly independent", of),
            ("variation_diminishing", [of]) => property("diminishes variation", of),
            ("variation_diminishing", [of, least, most]) => {
                let piece = property("diminishes variation at the degrees", of);
                let range = [self.inner(least), Shown::Sign('–'), self.inner(most)];
                let nodes = std::iter::once(piece.node).chain(range);
                Piece::new(Level::Relation, Shown::row(nodes))
            }
            ("D", [function, variable]) => self.derivative(function, variable, None),
            ("D", [function, variable, order]) => match plain_integer(order) {
                Some(1) => self.derivative(function, variable, None),
                _ => self.derivative(function, variable, Some(self.inner(order))),
            },
            _ => return None,
        })
    }

    fn marked(&self, mark: MathChange, inner: &Expr) -> Piece {
        let piece = self.write(inner);
        Piece::new(piece.level, Shown::Marked(mark, Box::new(piece.node)))
    }

    /// Writes the derivative of forms with respect to symbols in which they are linear: a quotient of differentials, or
    /// the operator before a formula with operators of its own, which can be broken there.
    fn rate(&self, forms: &Expr, symbols: &Expr) -> Piece {
        let part =
            |expr: &Expr| Shown::row([Shown::Sign('∂'), self.operand(only(expr), Level::Power)]);
        let over = |above| Shown::Fraction(Box::new(above), Box::new(part(symbols)));
        let whole = self.write(only(forms));
        if whole.level < Level::Power {
            let operator = over(Shown::Sign('∂'));
            return Piece::new(Level::Open, Shown::row([operator, whole.node.round()]));
        }
        Piece::new(Level::Power, over(part(forms)))
    }

    /// Writes `dⁿF/dxⁿ`, or the operator before its argument.
    fn derivative(&self, function: &Expr, variable: &Expr, order: Option<Shown>) -> Piece {
        // With several arguments, or a derivative already taken, the derivative is partial.
        let partial = match &function.node {
            Node::Call(head, arguments) => {
                matches!(&head.node, Node::Name(name) if name == "D") || arguments.len() > 1
            }
            _ => false,
        };
        let d = || match partial {
            true => Shown::Sign('∂'),
            false => Shown::word("d"),
        };
        let above = d().scripted(0, None, order.clone());
        let below = self.inner(variable).scripted(0, None, order);
        let below = Shown::row([d(), below]);
        let quotient = |of: Shown| {
            Shown::Fraction(
                Box::new(Shown::row([above.clone(), of])),
                Box::new(below.clone()),
            )
        };
        match &function.node {
            Node::Name(_) => Piece::new(Level::Power, quotient(self.inner(function))),
            // At plain variables the function may be written without arguments.
            Node::Call(head, arguments)
                if matches!(&head.node, Node::Name(name) if name != "D" && printed_function(name).is_none())
                    && arguments.iter().all(|x| matches!(x.node, Node::Name(_))) =>
            {
                let arguments = self.listed(arguments).round();
                let nodes = [quotient(self.inner(head)), arguments];
                Piece::new(Level::Power, Shown::row(nodes))
            }
            _ => {
                let operand = self.write(function);
                let whole = operand.level >= Level::Power || operand.level == Level::Open;
                let operand = match whole {
                    true => operand.node,
                    false => operand.node.round(),
                };
                let operator = Shown::Fraction(Box::new(above.clone()), Box::new(below.clone()));
                Piece::new(Level::Open, Shown::row([operator, operand]))
            }
        }
    }

    /// Writes `F''(0)` for a named function or member of a family and at most three derivatives by its own variable, a
    /// quotient of partial differentials for a derivative by a parameter, else the derivative with a bar.
    fn derivative_at(&self, derivative: &[Expr], value: &Expr) -> Option<Piece> {
        let (function, variable, order) = match derivative {
            [function, variable] => (function, variable, Some(1)),
            [function, variable, order] => (function, variable, plain_integer(order)),
            _ => return None,
        };
        let at = self.inner(value);
        // Primes are for the function's own variable: at another name it is a derivative by a parameter.
        let by_parameter = matches!(value.node, Node::Name(_)) && value.node != variable.node;
        if by_parameter && matches!(function.node, Node::Name(_)) {
            let order = derivative.get(2).map(|order| self.inner(order));
            let above = Shown::Sign('∂').scripted(0, None, order.clone());
            let below = self.inner(variable).scripted(0, None, order);
            let fraction = Shown::Fraction(
                Box::new(Shown::row([above, self.inner(function)])),
                Box::new(Shown::row([Shown::Sign('∂'), below])),
            );
            return Some(Piece::new(Level::Power, Shown::row([fraction, at.round()])));
        }
        if let Some(primes @ 1..=3) = order
            && let Some((name, indices)) = member(function)
        {
            let indices = indices.iter().map(|index| self.inner(index)).collect();
            let head = self.names.name(name, primes as usize, indices);
            return Some(Piece::new(Level::Atom, Shown::row([head, at.round()])));
        }
        let rate = self.special("D", derivative)?;
        let place = Shown::row([self.inner(variable), Shown::Sign('='), at]);
        let fenced = Shown::Fenced(Fence::Behind, Box::new(rate.node));
        Some(Piece::new(
            Level::Power,
            fenced.scripted(0, Some(place), None),
        ))
    }
}

/// Returns the entry of a list of one.
fn only(expr: &Expr) -> &Expr {
    match &expr.node {
        Node::List(items) => match items.as_slice() {
            [one] => one,
            _ => expr,
        },
        _ => expr,
    }
}

/// Marks the sign before a term, if it changed and the term did not.
fn marked_sign(term: &Expr, sign: Shown) -> Shown {
    let mark = match &term.node {
        Node::Call(head, _) => match &head.node {
            Node::Name(name) if name == SIGN_ADDED => MathChange::Added,
            Node::Name(name) if name == SIGN_REMOVED => MathChange::Removed,
            _ => return sign,
        },
        _ => return sign,
    };
    Shown::Marked(mark, Box::new(sign))
}

fn mark_of(expr: &Expr) -> Option<(MathChange, &Expr)> {
    match &expr.node {
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [inner]) if name == ADDED => Some((MathChange::Added, inner)),
            (Node::Name(name), [inner]) if name == REMOVED => Some((MathChange::Removed, inner)),
            _ => None,
        },
        _ => None,
    }
}

fn sign(relation: Relation) -> char {
    match relation {
        Relation::Equal => '=',
        Relation::Different => '≠',
        Relation::Less => '<',
        Relation::AtMost => '≤',
        Relation::Greater => '>',
        Relation::AtLeast => '≥',
    }
}

/// Returns the rows of a matrix: a list of lists of one nonzero length.
fn rows(items: &[Expr]) -> Option<Vec<&[Expr]>> {
    let rows: Vec<&[Expr]> = items
        .iter()
        .map(|item| match &item.node {
            Node::List(row) => Some(row.as_slice()),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let width = rows.first()?.len();
    (width > 0 && rows.iter().all(|row| row.len() == width)).then_some(rows)
}

fn plain_integer(expr: &Expr) -> Option<u32> {
    match &expr.node {
        Node::Number { decimals: None, .. } => text(expr).parse().ok(),
        _ => None,
    }
}

/// Writes a name, or a member of a named family, with its indices.
fn member(expr: &Expr) -> Option<(&str, &[Expr])> {
    match &expr.node {
        Node::Name(name) => Some((name, &[])),
        Node::Index(head, indices) => match &head.node {
            Node::Name(name) => Some((name, indices)),
            _ => None,
        },
        _ => None,
    }
}
