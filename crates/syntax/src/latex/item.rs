//! Mathematics as TeX lays it out: a list of items, each with a nucleus, scripts and primes. Nothing is read into it yet.

use crate::formula::Place;

/// The face or the accent of a letter.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum TexFace {
    /// As mathematics sets letters.
    Plain,
    /// Bold, or under an arrow: a vector.
    Bold,
    /// Upright, calligraphic or another face, by its command.
    Other(String),
    /// Under an accent, such as `hat`, in a plain or bold face.
    Accent(String, Box<TexFace>),
}

/// What an item is without its scripts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Nucleus {
    /// Digits, perhaps with a point.
    Number(String),
    /// A letter, a Greek letter by its spelling in formulas, or a word in a face.
    Letter(String, TexFace),
    /// A named operator, such as `sin`.
    Operator(String),
    /// A sign, by its command or character: `+`, `cdot`, `le`.
    Sign(String),
    /// Words in a formula.
    Words(String),
    /// A list between brackets, by the characters of the brackets; `.` is none, `‖` a double bar, `⟨` an angle.
    Fenced(char, Vec<TexItem>, char),
    /// Several items in braces that have scripts in common.
    Group(Vec<TexItem>),
    /// A fraction.
    Fraction(Vec<TexItem>, Vec<TexItem>),
    /// A root with its degree.
    Root(Option<Vec<TexItem>>, Vec<TexItem>),
    /// A binomial coefficient.
    Binomial(Vec<TexItem>, Vec<TexItem>),
    /// Rows of cells, by the environment.
    Grid(String, Vec<Vec<Vec<TexItem>>>),
    /// Dots over something: a derivative, by the number of dots.
    Dotted(usize, Vec<TexItem>),
    /// `sum`, `prod` or `int`.
    Big(String),
    /// An ellipsis.
    Dots,
}

/// A nucleus with scripts and primes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TexItem {
    /// The nucleus.
    pub nucleus: Nucleus,
    /// The subscript.
    pub below: Option<Vec<TexItem>>,
    /// The superscript without primes.
    pub above: Option<Vec<TexItem>>,
    /// The number of primes.
    pub primes: usize,
    /// The place in the text.
    pub place: Place,
}

impl TexItem {
    pub(super) fn new(nucleus: Nucleus, place: Place) -> Self {
        Self {
            nucleus,
            below: None,
            above: None,
            primes: 0,
            place,
        }
    }

    /// Whether there are no scripts and primes.
    #[must_use]
    pub fn is_bare(&self) -> bool {
        self.below.is_none() && self.above.is_none() && self.primes == 0
    }

    /// Whether this is the sign.
    #[must_use]
    pub fn is_sign(&self, sign: &str) -> bool {
        matches!(&self.nucleus, Nucleus::Sign(own) if own == sign)
    }

    /// The lists inside: scripts, brackets, fractions, cells.
    #[must_use]
    pub fn lists(&self) -> Vec<&[TexItem]> {
        let mut found: Vec<&[TexItem]> = match &self.nucleus {
            Nucleus::Fenced(_, list, _) | Nucleus::Group(list) | Nucleus::Dotted(_, list) => {
                vec![list]
            }
            Nucleus::Fraction(a, b) | Nucleus::Binomial(a, b) => vec![a, b],
            Nucleus::Root(degree, list) => degree
                .iter()
                .map(Vec::as_slice)
                .chain([&list[..]])
                .collect(),
            Nucleus::Grid(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
            _ => vec![],
        };
        found.extend(self.below.as_deref());
        found.extend(self.above.as_deref());
        found
    }
}

/// The place of a list, from its first item to its last one; that of `otherwise` if it is empty.
#[must_use]
pub fn place_of(list: &[TexItem], otherwise: Place) -> Place {
    match (list.first(), list.last()) {
        (Some(first), Some(last)) => first.place.to(last.place),
        _ => otherwise,
    }
}

/// Two lists that look alike: the same items at whatever places.
#[must_use]
pub fn look_alike(a: &[TexItem], b: &[TexItem]) -> bool {
    signature(a) == signature(b)
}

/// A text that two lists have in common exactly if they look alike.
#[must_use]
pub fn signature(list: &[TexItem]) -> String {
    list.iter()
        .map(item_signature)
        .collect::<Vec<_>>()
        .join(" ")
}

/// The signature of a nucleus without scripts.
#[must_use]
pub fn nucleus_signature(nucleus: &Nucleus) -> String {
    let inner = |list: &[TexItem]| format!("{{{}}}", signature(list));
    match nucleus {
        Nucleus::Number(digits) => digits.clone(),
        Nucleus::Letter(letters, face) => format!("{}:{letters}", face_signature(face)),
        Nucleus::Operator(name) | Nucleus::Big(name) => format!("\\{name}"),
        Nucleus::Sign(sign) => sign.clone(),
        Nucleus::Words(words) => format!("\"{words}\""),
        Nucleus::Fenced(open, list, close) => format!("{open}{}{close}", inner(list)),
        Nucleus::Group(list) => inner(list),
        Nucleus::Fraction(a, b) => format!("frac{}{}", inner(a), inner(b)),
        Nucleus::Root(degree, list) => {
            format!(
                "root{}{}",
                inner(degree.as_deref().unwrap_or(&[])),
                inner(list)
            )
        }
        Nucleus::Binomial(a, b) => format!("binom{}{}", inner(a), inner(b)),
        Nucleus::Grid(name, rows) => {
            let cells = rows
                .iter()
                .map(|row| row.iter().map(|cell| inner(cell)).collect::<String>());
            format!("{name}{}", cells.collect::<Vec<_>>().join(";"))
        }
        Nucleus::Dotted(count, list) => format!("dot{count}{}", inner(list)),
        Nucleus::Dots => "...".to_owned(),
    }
}

fn face_signature(face: &TexFace) -> String {
    match face {
        TexFace::Plain => String::new(),
        TexFace::Bold => "bold".to_owned(),
        TexFace::Other(name) => name.clone(),
        TexFace::Accent(name, inner) => format!("{name}-{}", face_signature(inner)),
    }
}

fn item_signature(item: &TexItem) -> String {
    let script = |sign: char, list: &Option<Vec<TexItem>>| {
        list.as_ref().map_or(String::new(), |list| {
            format!("{sign}{{{}}}", signature(list))
        })
    };
    let primes = "'".repeat(item.primes);
    let nucleus = nucleus_signature(&item.nucleus);
    format!(
        "{nucleus}{primes}{}{}",
        script('_', &item.below),
        script('^', &item.above)
    )
}
