//! The control sequences that formulas may have, and what kind each is.

use super::item::TexFace;
use crate::greek;

/// What a control sequence is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CommandKind {
    /// It has no meaning, and takes so many arguments.
    Ignored(usize),
    /// A Greek letter, by its spelling in formulas.
    Greek(&'static str),
    /// Another letter.
    Letter(&'static str),
    /// A sign.
    Sign(&'static str),
    /// A named operator.
    Operator,
    /// A sum, a product or an integral.
    Big(&'static str),
    /// An ellipsis.
    Dots,
    /// It changes the face of what follows in the group.
    Switch(TexFace),
    /// It sets its argument in a face, or under an accent.
    Face(TexFace),
    /// Words.
    Words,
    /// An operator by its name in braces.
    Named,
    /// It takes a numerator and a denominator.
    Fraction,
    /// It takes two numbers.
    Binomial,
    /// A root.
    Root,
    /// So many dots over its argument.
    Dotted(usize),
    /// `\left`.
    Left,
    /// An opening bracket.
    Opening(char),
    /// `\begin`.
    Begin,
    /// Nothing that is understood.
    Unknown,
}

/// The kind of a control sequence, given without its backslash.
#[must_use]
pub fn command_kind(name: &str) -> CommandKind {
    use CommandKind::{
        Big, Binomial, Dots, Dotted, Face, Fraction, Ignored, Opening, Sign, Switch, Words,
    };
    let other = |face: &str| TexFace::Other(face.to_owned());
    let accent = |sign: &str| Face(TexFace::Accent(sign.to_owned(), Box::new(TexFace::Plain)));
    if let Some(letter) = greek::by_latex(name) {
        return CommandKind::Greek(letter.name);
    }
    match name {
        "," | ";" | ":" | "!" | ">" | " " | "displaystyle" | "textstyle" | "scriptstyle"
        | "limits" | "nolimits" | "nonumber" | "notag" | "big" | "Big" | "bigg" | "Bigg"
        | "bigl" | "bigr" | "Bigl" | "Bigr" | "biggl" | "biggr" | "Biggl" | "Biggr" | "middle"
        | "thinspace" | "medspace" | "thickspace" | "negthinspace" | "strut" | "mathstrut"
        | "allowbreak" | "nobreak" | "par" | "hfill" | "rm" | "it" | "mathord" | "mathbin"
        | "mathrel" | "mathopen" | "mathclose" | "relax" | "qedhere" => Ignored(0),
        "label" | "tag" | "hspace" | "vspace" | "phantom" | "vphantom" | "hphantom" => Ignored(1),
        "quad" | "qquad" => Sign("quad"),
        "cdot" | "bullet" => Sign("cdot"),
        "times" => Sign("times"),
        "ast" => Sign("*"),
        "div" | "slash" => Sign("/"),
        "lt" => Sign("<"),
        "gt" => Sign(">"),
        "le" | "leq" | "leqslant" => Sign("le"),
        "ge" | "geq" | "geqslant" => Sign("ge"),
        "ne" | "neq" => Sign("ne"),
        "equiv" => Sign("equiv"),
        "coloneqq" | "coloneq" | "triangleq" | "doteq" => Sign(":="),
        "in" => Sign("in"),
        "pm" => Sign("pm"),
        "mp" => Sign("mp"),
        "infty" => Sign("infty"),
        "partial" => Sign("partial"),
        "prime" => Sign("prime"),
        "top" | "intercal" => Sign("top"),
        "to" | "rightarrow" => Sign("to"),
        "implies" | "Rightarrow" | "Longrightarrow" => Sign("implies"),
        "iff" | "Leftrightarrow" | "Longleftrightarrow" => Sign("iff"),
        "land" | "wedge" => Sign(if name == "land" { "and" } else { "wedge" }),
        "lor" | "vee" => Sign(if name == "lor" { "or" } else { "vee" }),
        "neg" | "lnot" => Sign("not"),
        "not" => Sign("slashed"),
        "approx" => Sign("approx"),
        "sim" => Sign("sim"),
        "circ" => Sign("circ"),
        "parallel" => Sign("parallel"),
        "perp" => Sign("perp"),
        "forall" => Sign("forall"),
        "exists" => Sign("exists"),
        "nabla" => Sign("nabla"),
        "mid" => Sign("mid"),
        "colon" => Sign(":"),
        "ldots" | "cdots" | "dots" | "dotsc" | "dotsb" | "dotsm" | "vdots" | "ddots" => Dots,
        "sum" => Big("sum"),
        "prod" => Big("prod"),
        "int" => Big("int"),
        "frac" | "dfrac" | "tfrac" | "cfrac" => Fraction,
        "binom" | "dbinom" | "tbinom" => Binomial,
        "sqrt" => CommandKind::Root,
        "mathbf" | "boldsymbol" | "bm" | "pmb" | "vec" | "overrightarrow" | "mathbfit" => {
            Face(TexFace::Bold)
        }
        "bf" | "bfseries" | "boldmath" => Switch(TexFace::Bold),
        "mathrm" | "mathup" | "mathit" | "mathsf" | "mathtt" | "mathnormal" => {
            Face(other("mathrm"))
        }
        "mathcal" | "mathscr" => Face(other("mathcal")),
        "mathbb" | "mathfrak" => Face(other(name)),
        "hat" | "widehat" => accent("hat"),
        "tilde" | "widetilde" => accent("tilde"),
        "bar" | "overline" => accent("bar"),
        "text" | "textrm" | "mbox" | "textit" | "textnormal" | "hbox" | "intertext" => Words,
        "operatorname" | "operatorname*" | "mathop" => CommandKind::Named,
        "dot" => Dotted(1),
        "ddot" => Dotted(2),
        "dddot" => Dotted(3),
        "left" => CommandKind::Left,
        "{" | "lbrace" => Opening('{'),
        "langle" => Opening('⟨'),
        "lvert" => Opening('|'),
        "lVert" | "|" | "Vert" => Opening('‖'),
        "begin" => CommandKind::Begin,
        "ell" => CommandKind::Letter("ell"),
        "sin" | "cos" | "tan" | "cot" | "sec" | "csc" | "sinh" | "cosh" | "tanh" | "coth"
        | "exp" | "log" | "ln" | "det" | "lim" | "max" | "min" | "sup" | "inf" | "arcsin"
        | "arccos" | "arctan" | "dim" | "ker" | "arg" | "deg" | "gcd" | "limsup" | "liminf" => {
            CommandKind::Operator
        }
        _ => CommandKind::Unknown,
    }
}

/// Whether a sign compares what stands on its sides, so that a row with it may be a formula.
#[must_use]
pub fn is_relation_sign(sign: &str) -> bool {
    matches!(
        sign,
        "=" | "<" | ">" | "le" | "ge" | "ne" | "equiv" | ":=" | "in" | "approx"
    )
}
