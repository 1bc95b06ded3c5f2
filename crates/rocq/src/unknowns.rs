//! Unknowns as functions of a symbol, as `implicit_derivative` makes them.

use crate::code::Code;
use std::sync::Arc;

/// The type of such a function.
pub const FUNCTION: &str = "R -> R";

/// An unknown as a function.
#[derive(Debug, Clone)]
pub struct Function {
    /// The declared name of the unknown, or of the family that it is a member of.
    pub unknown: Arc<str>,
    /// The name of the function.
    pub name: String,
    /// The unknown itself: `A`, or `P 2`.
    pub own: Code,
}

/// The unknowns as functions of one symbol.
#[derive(Debug, Clone)]
pub struct Along {
    /// The declared name of the symbol, or of the family that it is a member of.
    pub symbol: Arc<str>,
    /// The symbol itself: `p0`, or `Q (m - 1)`.
    pub own: Code,
    /// The variable that it is where it moves: a symbol is hidden by a variable of its name.
    pub variable: String,
    /// The functions.
    pub functions: Vec<Function>,
    /// What stands for declared names where the symbol is the variable.
    pub moved: Vec<(Arc<str>, String)>,
    /// Whether the symbol or an unknown is a member of a family.
    pub has_members: bool,
}
