//! Manuscripts in LaTeX, read as proposals for derivation files.
//!
//! [`manuscript`] reads a text: it expands the macros (`macros`), and finds sections, theorems, numbered equations and
//! labels ([`Manuscript`]). [`propose`] concludes what the letters stand for, reads the formulas by
//! `torse_syntax::latex`, and writes the files of a folder ([`Proposal`]). What is read in two ways is written twice, for the author to choose;
//! what is not understood is listed with its line and column. Nothing is decided here.
//!
//! ```
//! let text = r"\begin{document} \begin{equation} \label{eq:square} (a + b)^2 = a^2 + b^2 \end{equation} \end{document}";
//! let manuscript = torse_manuscript::manuscript(text)?;
//! let proposal = torse_manuscript::propose(&manuscript, "squares");
//! assert!(proposal.claims.contains("states = '(a + b)^2 == a^2 + b^2'"));
//! # Ok::<(), torse_manuscript::ManuscriptError>(())
//! ```
#![warn(missing_docs)]

mod declared;
mod document;
mod index;
mod linear;
mod macros;
mod meaning;
mod numbering;
mod occurrences;
mod proposal;
mod switches;
mod symbols;
mod words;

pub use document::{Manuscript, ManuscriptFormula, ManuscriptItem, manuscript};
pub use macros::ManuscriptError;
pub use meaning::{MAX_FORMULAS, Unread};
pub use proposal::{Proposal, propose, propose_without};
