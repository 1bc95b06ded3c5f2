//! Statements for the kernel, written from the syntax tree.
//!
//! What the kernel is asked about is what stands in the file: the bound names of `D`, `at` and `sum` are those of the
//! text, a definition is one `Definition` over the declared symbols that it reaches, and a declared function is a
//! function. Nothing here sees what the elaborator makes of a text: of the language this module imports trees and
//! declarations alone, so that a fault of the elaborator is a statement that does not follow from the one that is
//! proved, and no theorem.
//!
//! `reach` says which declared symbols a formula depends on, `kinds` which parameters are integers, `value` writes
//! values, `function` what is applied, `defined` where all terms have values (`ranges` of indices, `applied` of
//! functions and their derivatives), `proposition` writes statements, and `sentence` puts them together. The rules are
//! those of `derivations/SEMANTICS.md`, in its order.

mod applied;
mod basis;
mod defined;
mod forms;
mod function;
mod implicit_derivative;
mod integer;
mod kinds;
mod moving;
mod premises;
mod property;
mod ranges;
mod reach;
mod rough;
mod scope;
mod sentence;
mod translation;
mod value;
mod writer;

pub use sentence::sentence;
