//! Names with their scripts, primes and arguments.
//!
//! | print | reading |
//! |---|---|
//! | `P_i`, `Q_{i,j}`, `Q_{ij}` | members of a declared family, with as many indices as it has |
//! | `B_i^n(t)`, `B_{i,n}(t)` | function i of degree n of a declared basis |
//! | `v_2` | the coordinate of a declared vector |
//! | `f(x)`, `f'(x)`, `f''(x)` | a declared function and its derivatives |
//! | `x(a + b)` | a product, for a declared number |
//! | `X_u`, `X_{uv}` | the derivative of a declared function by its parameters, at these |
//! | `e^x` | `exp(x)`, where no `e` is declared; two readings where it is [`LatexKind::NumberOrBase`] |

use super::base::is_letter_e;
use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem, place_of};
use super::names::{FoundName, LatexKind, parts, spelled};
use super::reader::{Line, ReadTerm, Reader, Shape, Term, integer_at};
use crate::formula::{Expr, Node, Place};
use std::sync::Arc;

impl Reader<'_> {
    /// Reads a letter with what belongs to it.
    pub fn name(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let Some(item) = line.peek() else {
            return Err(LatexError::new(line.place(), "an operand is missing"));
        };
        let place = item.place;
        if let Some(index) = self.is_bound(item) {
            line.next += 1;
            if item.below.is_some() || item.primes > 0 {
                return Err(LatexError::new(
                    place,
                    format!("the index `{index}` has a script"),
                ));
            }
            return self.with_power(named(&index, place, Shape::Number), item.above.as_deref());
        }
        if let Some(term) = self.constant(line, item)? {
            return Ok(term);
        }
        let found = match &item.nucleus {
            Nucleus::Operator(letters) => {
                let (name, kind) = (
                    letters.clone(),
                    self.names
                        .kind(letters)
                        .cloned()
                        .unwrap_or(LatexKind::Number),
                );
                let below = item.below.as_deref().map(parts).unwrap_or_default();
                FoundName {
                    name,
                    kind,
                    below,
                    above: item.above.as_deref(),
                    primes: item.primes,
                }
            }
            _ => self.names.find(item)?,
        };
        line.next += 1;
        if found.primes > 0
            && !matches!(
                found.kind,
                LatexKind::Function { .. } | LatexKind::Basis { .. } | LatexKind::Family { .. }
            )
        {
            return Err(LatexError::new(
                place,
                format!("`{}` is no function, and has a prime", found.name),
            ));
        }
        match found.kind.clone() {
            LatexKind::Number | LatexKind::NumberOrBase => self.plain(found, place, Shape::Number),
            LatexKind::Matrix => self.entries(found, place, 2),
            LatexKind::Vector => self.entries(found, place, 1),
            LatexKind::Open => {
                let brackets = line.is_before_bracket();
                let says = ["a product", "a function with its argument"];
                if brackets && self.choose(format!("call {}", found.name), place, says) == 1 {
                    let head = named(&found.name, place, Shape::Number).expr;
                    return self.called(line, head, Shape::Number, &found, 1);
                }
                self.plain(found, place, Shape::Number)
            }
            LatexKind::Family { indices, is_vector } => {
                self.member(&found, place, indices, is_vector)
            }
            LatexKind::Basis { degree, variable } => {
                self.basis(line, &found, place, degree, &variable)
            }
            LatexKind::Function {
                parameters,
                is_vector,
            } => self.applied(line, &found, place, &parameters, is_vector),
        }
    }

    /// `\pi`, and `e` with an exponent.
    fn constant(
        &mut self,
        line: &mut Line<'_>,
        item: &TexItem,
    ) -> Result<Option<Term>, LatexError> {
        let Nucleus::Letter(letters, face) = &item.nucleus else {
            return Ok(None);
        };
        let is_plain = matches!(face, TexFace::Plain)
            || matches!(face, TexFace::Other(name) if name == "mathrm");
        let bare = item.below.is_none() && item.primes == 0;
        if letters == "pi" && is_plain && bare && self.names.kind("pi").is_none() {
            line.next += 1;
            return self
                .with_power(
                    named("pi", item.place, Shape::Number),
                    item.above.as_deref(),
                )
                .map(Some);
        }
        let says = [
            "`e` is the base of the exponential function",
            "`e` is a number of the text",
        ];
        let is_base = is_letter_e(item)
            && match self.names.kind("e") {
                None => item.above.is_some(),
                Some(LatexKind::NumberOrBase) => {
                    self.choose("base e".to_owned(), item.place, says) == 0
                }
                Some(_) => false,
            };
        if !is_base {
            return Ok(None);
        }
        line.next += 1;
        let exponent = match item.above.as_deref() {
            Some(above) => self.value(above, item.place, "the exponent")?,
            None => integer_at(1, item.place),
        };
        Ok(Some(Term::call(
            "exp",
            vec![exponent],
            item.place,
            Shape::Number,
        )))
    }

    fn with_power(&mut self, term: Term, above: Option<&[TexItem]>) -> ReadTerm {
        match above {
            None => Ok(term),
            Some(above) => self.raised(term, above),
        }
    }

    /// A name that takes no index.
    fn plain(&mut self, found: FoundName<'_>, place: Place, shape: Shape) -> ReadTerm {
        if !found.below.is_empty() {
            let message = format!("`{}` is declared, but not with this subscript", found.name);
            return Err(LatexError::new(place, message));
        }
        self.with_power(named(&found.name, place, shape), found.above)
    }

    /// A vector or a matrix, or one of its entries.
    fn entries(&mut self, found: FoundName<'_>, place: Place, wanted: usize) -> ReadTerm {
        let shape = if wanted == 1 {
            Shape::Vector
        } else {
            Shape::Matrix
        };
        if found.below.is_empty() {
            return self.plain(found, place, shape);
        }
        let indices = self.indices(&found.below, wanted, place)?;
        let head = named(&found.name, place, shape).expr;
        let entry = Term::number(Node::Index(Arc::new(head), indices), place);
        self.with_power(entry, found.above)
    }

    /// Reads indices between commas, or two letters or digits side by side for two.
    fn indices(
        &mut self,
        below: &[&[TexItem]],
        wanted: usize,
        place: Place,
    ) -> Result<Vec<Expr>, LatexError> {
        let wrong = |found: usize| {
            LatexError::new(
                place,
                format!("{found} indices stand where {wanted} belong"),
            )
        };
        if below.len() == wanted {
            return below
                .iter()
                .map(|part| self.value(part, place, "the index"))
                .collect();
        }
        let [only] = below else {
            return Err(wrong(below.len()));
        };
        let mut single = vec![];
        for item in *only {
            match &item.nucleus {
                Nucleus::Number(digits) if item.is_bare() && !digits.contains('.') => {
                    for (at, digit) in digits.chars().enumerate() {
                        let place = Place {
                            start: item.place.start + at,
                            end: item.place.start + at + 1,
                        };
                        single.push(TexItem::new(Nucleus::Number(digit.to_string()), place));
                    }
                }
                Nucleus::Letter(..) if item.is_bare() => single.push(item.clone()),
                _ => return Err(wrong(1)),
            }
        }
        if single.len() != wanted {
            return Err(wrong(single.len()));
        }
        single
            .iter()
            .map(|item| self.value(std::slice::from_ref(item), place, "the index"))
            .collect()
    }

    /// A member of a family; a superscript is the last index where the subscripts are too few.
    fn member(
        &mut self,
        found: &FoundName<'_>,
        place: Place,
        wanted: usize,
        is_vector: bool,
    ) -> ReadTerm {
        let shape = if is_vector {
            Shape::Vector
        } else {
            Shape::Number
        };
        if found.primes > 0 {
            return Err(LatexError::new(
                place,
                format!("`{}` is a family, and has a prime", found.name),
            ));
        }
        let (mut below, mut above) = (found.below.clone(), found.above);
        if below.len() + 1 == wanted
            && let Some(last) = above.take()
        {
            below.push(last);
        }
        if below.is_empty() {
            return Err(LatexError::new(
                place,
                format!("`{}` is a family, and has no index here", found.name),
            ));
        }
        let indices = self.indices(&below, wanted, place)?;
        let head = named(&found.name, place, shape).expr;
        let member = Term::new(Node::Index(Arc::new(head), indices), place, shape);
        self.with_power(member, above)
    }

    /// A function of a basis.
    fn basis(
        &mut self,
        line: &mut Line<'_>,
        found: &FoundName<'_>,
        place: Place,
        degree: Option<u8>,
        variable: &str,
    ) -> ReadTerm {
        let (mut below, mut above) = (found.below.clone(), found.above);
        let mut indices = match (below.len(), degree) {
            (1, Some(_)) if above.is_none() => self.indices(&below, 1, place)?,
            (1, _) => {
                let before = below.clone();
                match above.take() {
                    Some(order) => below.push(order),
                    None if degree.is_none()
                        && before.first().is_some_and(|part| part.len() == 2) => {}
                    None => {
                        return Err(LatexError::new(
                            place,
                            format!(
                                "`{}` is a basis: its functions have an index and a degree",
                                found.name
                            ),
                        ));
                    }
                }
                self.indices(&below, 2, place)?
            }
            (2, _) => self.indices(&below, 2, place)?,
            _ => {
                return Err(LatexError::new(
                    place,
                    format!(
                        "`{}` is a basis: its functions have an index and a degree",
                        found.name
                    ),
                ));
            }
        };
        if let (1, Some(degree)) = (indices.len(), degree) {
            indices.push(integer_at(u64::from(degree), place));
        }
        if above.is_some() {
            return Err(
                LatexError::new(place, "an exponent before the argument may be a degree")
                    .with_help("write the power around the call"),
            );
        }
        let head = named(&found.name, place, Shape::Number).expr;
        let member = Expr {
            node: Node::Index(Arc::new(head), indices),
            place,
        };
        match (line.is_before_bracket(), found.primes) {
            (true, 0) => self.called(line, member, Shape::Number, found, usize::MAX),
            (true, _) => self.member_derivative(line, member, variable, found.primes, place),
            (false, 0) => Ok(Term {
                expr: member,
                shape: Shape::Number,
            }),
            (false, _) => Err(LatexError::new(
                place,
                format!("the derivative of `{}` has no argument here", found.name),
            )),
        }
    }

    /// The derivative of a member of a basis by the variable of the basis, at the argument behind it:
    /// `at(D(B[i,n](t), t), t, x)`, and without `at` where x is t.
    fn member_derivative(
        &mut self,
        line: &mut Line<'_>,
        member: Expr,
        variable: &str,
        primes: usize,
        place: Place,
    ) -> ReadTerm {
        let bracket = self.arguments(line, place)?;
        let [argument] = bracket.arguments.as_slice() else {
            return Err(LatexError::new(
                place,
                "a member of a basis has one argument",
            ));
        };
        let by = named(variable, place, Shape::Number).expr;
        let own = Node::Call(Arc::new(member), vec![by.clone()]);
        let own = Term::number(own, place).expr;
        let order = u64::try_from(primes).unwrap_or(u64::MAX);
        let derivative = Term::derivative(own, variable, order, place, Shape::Number);
        let is_own = matches!(&argument.node, Node::Name(name) if name == variable);
        let derivative = match is_own {
            true => derivative,
            false => {
                let arguments = vec![derivative.expr, by, argument.clone()];
                Term::call("at", arguments, place, Shape::Number)
            }
        };
        self.with_power(derivative, bracket.above)
    }

    /// A function with its argument, its derivatives and its partial derivatives.
    fn applied(
        &mut self,
        line: &mut Line<'_>,
        found: &FoundName<'_>,
        place: Place,
        parameters: &[String],
        is_vector: bool,
    ) -> ReadTerm {
        let shape = if is_vector {
            Shape::Vector
        } else {
            Shape::Number
        };
        let brackets = line.is_before_bracket();
        // Scripts that the function's first parameters stand for: `B_i^n(t)` for `B(i, n, t)`.
        let scripts: Vec<&[TexItem]> = found.below.iter().copied().chain(found.above).collect();
        if !scripts.is_empty() && found.primes == 0 && brackets {
            let given = line.peek().map_or(0, |next| match &next.nucleus {
                Nucleus::Fenced(_, inner, _) => parts(inner).len(),
                _ => 0,
            });
            if given + scripts.len() == parameters.len() {
                let arguments = self.indices(&scripts, scripts.len(), place)?;
                let head = named(&found.name, place, shape).expr;
                return self.finished_with(line, head, arguments, shape, place);
            }
        }
        let primed = format!("{}{}", found.name, "'".repeat(found.primes));
        if let Some(above) = found.above.filter(|_| brackets) {
            let error = LatexError::new(
                place_of(above, place),
                format!(
                    "an exponent of the function `{}` before its argument may be a power or a number of repetitions",
                    found.name
                ),
            );
            return Err(error.with_help("write the exponent behind the argument"));
        }
        if let [below] = found.below.as_slice() {
            let Some(variables) = self.partials(below, parameters) else {
                return Err(LatexError::new(
                    place,
                    format!("`{}` is declared, but not with this subscript", found.name),
                ));
            };
            return self.partial(line, &primed, &variables, parameters, shape, place, found);
        }
        if !found.below.is_empty() {
            return Err(LatexError::new(
                place,
                format!(
                    "`{}` is declared, but not with these subscripts",
                    found.name
                ),
            ));
        }
        if !brackets {
            // Papers leave the argument out: it is the parameter.
            if parameters.is_empty()
                || parameters.iter().any(|name| {
                    self.names.kind(name) != Some(&LatexKind::Number) || self.bound.contains(name)
                })
            {
                return Err(LatexError::new(
                    place,
                    format!("the function `{}` has no argument here", found.name),
                ));
            }
            let arguments = parameters
                .iter()
                .map(|name| named(name, place, Shape::Number).expr);
            let head = named(&primed, place, shape).expr;
            let call = Node::Call(Arc::new(head), arguments.collect());
            return self.with_power(Term::new(call, place, shape), found.above);
        }
        let head = named(&primed, place, shape).expr;
        self.called(line, head, shape, found, parameters.len())
    }

    /// The parameters that a subscript names, one letter each, if it names nothing else.
    fn partials(&self, below: &[TexItem], parameters: &[String]) -> Option<Vec<String>> {
        let letter = |item: &TexItem| match &item.nucleus {
            Nucleus::Letter(letters, TexFace::Plain)
                if item.is_bare() && parameters.contains(letters) =>
            {
                Some(letters.clone())
            }
            _ => None,
        };
        below
            .iter()
            .map(letter)
            .collect::<Option<Vec<String>>>()
            .filter(|found| !found.is_empty())
    }

    /// A derivative by parameters: at the arguments behind it, or at the parameters.
    #[expect(
        clippy::too_many_arguments,
        reason = "one call, of values that belong to no type"
    )]
    fn partial(
        &mut self,
        line: &mut Line<'_>,
        primed: &str,
        variables: &[String],
        parameters: &[String],
        shape: Shape,
        place: Place,
        found: &FoundName<'_>,
    ) -> ReadTerm {
        let mut function = named(primed, place, shape).expr;
        let mut variables = variables.iter().peekable();
        while let Some(variable) = variables.next() {
            let mut order = 1_u64;
            while variables.next_if(|next| *next == variable).is_some() {
                order += 1;
            }
            function = Term::derivative(function, variable, order, place, shape).expr;
        }
        if line.is_before_bracket() {
            return self.called(line, function, shape, found, parameters.len());
        }
        if parameters.iter().any(|name| {
            self.names.kind(name) != Some(&LatexKind::Number) || self.bound.contains(name)
        }) {
            return Err(LatexError::new(
                place,
                format!("the derivative of `{}` has no argument here", found.name),
            ));
        }
        let arguments = parameters
            .iter()
            .map(|name| named(name, place, Shape::Number).expr);
        Ok(Term::new(
            Node::Call(Arc::new(function), arguments.collect()),
            place,
            shape,
        ))
    }

    /// Reads the arguments behind a function.
    fn called(
        &mut self,
        line: &mut Line<'_>,
        head: Expr,
        shape: Shape,
        found: &FoundName<'_>,
        most: usize,
    ) -> ReadTerm {
        let start = head.place;
        let Some(TexItem {
            nucleus: Nucleus::Fenced(_, inner, _),
            ..
        }) = line.peek()
        else {
            return Err(LatexError::new(
                start,
                format!("the function `{}` has no argument", found.name),
            ));
        };
        let given = parts(inner).len();
        if given > most {
            return Err(LatexError::new(
                start,
                format!(
                    "`{}` has {given} arguments here and {most} where it is defined",
                    found.name
                ),
            ));
        }
        self.finished_with(line, head, vec![], shape, start)
    }

    /// Takes the bracket of arguments, behind those that are there already, with what stands behind it.
    fn finished_with(
        &mut self,
        line: &mut Line<'_>,
        head: Expr,
        mut arguments: Vec<Expr>,
        shape: Shape,
        start: Place,
    ) -> ReadTerm {
        let bracket = self.arguments(line, start)?;
        arguments.extend(bracket.arguments);
        let call = Node::Call(Arc::new(head), arguments);
        self.with_power(Term::new(call, bracket.place, shape), bracket.above)
    }

    /// Takes the bracket of arguments.
    fn arguments<'i>(
        &mut self,
        line: &mut Line<'i>,
        start: Place,
    ) -> Result<Bracket<'i>, LatexError> {
        let Some(item) = line.peek() else {
            return Err(LatexError::new(start, "the function has no argument"));
        };
        let Nucleus::Fenced('(', inner, ')') = &item.nucleus else {
            return Err(LatexError::new(
                start,
                "the function has no argument in round brackets",
            ));
        };
        line.next += 1;
        let arguments = parts(inner)
            .into_iter()
            .map(|part| self.value(part, item.place, "the argument"))
            .collect::<Result<_, _>>()?;
        if item.primes > 0 || item.below.is_some() {
            return Err(LatexError::new(
                item.place,
                "this script behind the argument is not understood",
            ));
        }
        Ok(Bracket {
            arguments,
            above: item.above.as_deref(),
            place: start.to(item.place),
        })
    }
}

/// The arguments in the bracket behind a function.
struct Bracket<'i> {
    arguments: Vec<Expr>,
    /// The exponent of the bracket.
    above: Option<&'i [TexItem]>,
    /// The function with its bracket.
    place: Place,
}

/// A name as a formula.
pub(super) fn named(name: &str, place: Place, shape: Shape) -> Term {
    Term::new(Node::Name(name.to_owned()), place, shape)
}

/// The spelling of a lone letter.
pub(super) fn lone_letter(list: &[TexItem]) -> Option<String> {
    match list {
        [only] if only.is_bare() => spelled(only).ok().map(|(letters, _)| letters),
        _ => None,
    }
}
