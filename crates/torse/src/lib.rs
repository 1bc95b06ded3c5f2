//! torse decides formulas and papers exactly, and makes developable surfaces and their flat patterns.
//!
//! This is the one library that command, Python and page stand on: texts and bytes in, values out. Errors are values with a
//! place ([`Error`]), budgets are values ([`WorkBudget`]), long work is watched and ended by a callback ([`Verifier`]).
//! Nothing panics on input, nothing is global, the same input gives the same values on every machine.
//!
//! # Is it true?
//!
//! ```
//! let decided = torse::decide("sin(x)^2 + cos(x)^2 == 1")?;
//! assert_eq!(decided.is_true(), Some(true));
//!
//! let wrong = torse::decide("(a + b)^2 == a^2 + b^2")?;
//! assert_eq!(wrong.is_true(), Some(false));
//! let witness = wrong.witness().ok_or("an exact counterexample")?;
//! assert_eq!((witness.left.as_str(), witness.right.as_str()), ("4", "2"));
//!
//! let bound = torse::decide_where("x*(1 - x) <= 1/4", "x in [0, 1]")?;
//! assert_eq!((bound.word(), bound.is_replayed()), ("holds", Some(true)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What does a paper say?
//!
//! A paper is a folder of derivation files ([`Paper::open`]), or texts that stand for them:
//!
//! ```
//! let paper = torse::Paper::read(|name| match name {
//!     "paper.toml" => Some(r#"
//!         [paper]
//!         id = "mine"
//!         title = "A paper"
//!         authors = "A. Uthor"
//!         venue = "nowhere"
//!         claims = ["claims.toml"]
//!         [symbols]
//!         x = { in = "(-inf, inf)" }
//!     "#.to_owned()),
//!     "claims.toml" => Some(r#"
//!         [[claim]]
//!         id = "mine/eq-1"
//!         at = "eq. (1)"
//!         kind = "identity"
//!         printed = "(x + 1)² = x² − 2x + 1"
//!         states = "(x + 1)^2 == x^2 - 2*x + 1"
//!     "#.to_owned()),
//!     _ => None,
//! })?;
//! let verified = paper.verify()?;
//! let outcome = verified.outcomes().next().ok_or("one claim")?;
//! assert_eq!(outcome.verdict(), torse::Verdict::Misprint);
//! let correction = outcome.correction().ok_or("a proved correction")?;
//! assert_eq!(correction.statement.text, "(x + 1)^2 == x^2 + 2*x + 1");
//! let note = paper.explain("mine/eq-1")?;
//! assert!(note.text("fails at").is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Can it be made?
//!
//! ```
//! let design = torse::Design::read("tube.toml", r#"
//!     [curves.rim]
//!     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
//!     [patches.tube]
//!     cylinder = "rim"
//!     direction = [0, 0, 30]
//! "#)?;
//! let report = design.inspect()?;
//! assert!(report.missed.is_empty() && report.patches[0].developable.holds());
//! let pattern = design.unroll()?;
//! assert!((pattern.area() - 20.0 * std::f64::consts::FRAC_PI_2 * 30.0).abs() < 1e-9);
//! let folded = design.fold("tube.dxf", &pattern.dxf()?)?;
//! assert!(folded.missed.is_empty());
//! let step = design.export("step", &Default::default())?;
//! assert!(step.starts_with(b"ISO-10303-21"));
//! # Ok::<(), torse::Error>(())
//! ```
//!
//! Without files, [`geometry`] has curves, surfaces and developables for every scalar; [`connect`] finds the developable
//! between two curves.
//!
//! # Features
//!
//! | feature | brings | default |
//! |---|---|---|
//! | `papers` | [`decide`], [`Paper`], [`Verifier`] | yes |
//! | `code` | [`compare`]: code beside the formula, with parsers in C | no |
//! | `geometry` | the module [`geometry`] | with `designs` |
//! | `designs` | [`Design`], [`connect`], [`contents`] | yes |
//! | `pdf` | PDF in the module [`report`]: the typesetter with its two hundred packages | no |
//! | `kernel` | the module [`kernel`]: statements and proofs for Rocq | no |
//! | `parallel` | the geometry works on all threads; its values are the same without | yes |
//! | `simd` | the geometry uses the widest vector registers of the machine; its values are the same without | yes |
//! | `nalgebra` | affine maps from and to those of nalgebra | no |
#![warn(missing_docs)]

#[cfg(feature = "papers")]
pub mod annotations;
#[cfg(feature = "code")]
mod comparison;
#[cfg(feature = "papers")]
mod correction_letter;
#[cfg(feature = "papers")]
mod decided;
#[cfg(feature = "designs")]
mod design;
#[cfg(feature = "papers")]
mod digests;
#[cfg(feature = "papers")]
pub mod editing;
#[cfg(any(feature = "papers", feature = "designs"))]
mod error;
#[cfg(feature = "papers")]
pub mod explanation;
#[cfg(feature = "papers")]
mod paper;
#[cfg(feature = "papers")]
mod progress;
#[cfg(feature = "papers")]
mod proposal;
#[cfg(feature = "papers")]
pub mod selection;
#[cfg(feature = "papers")]
mod verifier;

#[cfg(feature = "code")]
pub use comparison::compare;
#[cfg(feature = "papers")]
pub use correction_letter::CorrectionLetter;
#[cfg(feature = "papers")]
pub use decided::{Decided, decide, decide_where, sympy};
#[cfg(feature = "designs")]
pub use design::{Design, Pattern, connect, contents, report_text};
#[cfg(feature = "papers")]
pub use digests::{ClaimDigest, digests};
#[cfg(feature = "designs")]
pub use error::DesignFailure;
#[cfg(any(feature = "papers", feature = "designs"))]
pub use error::{Error, ErrorMessage, ErrorPlace, diagnostic_place};
#[cfg(feature = "papers")]
pub use explanation::{Explanation, ExplanationLine};
#[cfg(feature = "papers")]
pub use paper::Paper;
#[cfg(feature = "papers")]
pub use progress::{Event, Observer, Pass, unobserved};
#[cfg(feature = "papers")]
pub use proposal::propose;
#[cfg(feature = "papers")]
pub use verifier::{Verification, Verifier, WorkBudget};

#[cfg(feature = "code")]
pub use torse_code::{
    CodeEdit, CodeLanguage, CodeQuestion, CodeVerdict, Comparison, MAX_CODE_BYTES, PrintEdit,
    PrintedSide,
};
/// Design files, beneath [`Design`].
#[cfg(feature = "designs")]
pub use torse_designs as designs;
/// Files of other programs, in and out.
#[cfg(feature = "designs")]
pub use torse_exchange as exchange;
/// Curves, surfaces, developables, patterns: for every scalar.
#[cfg(feature = "geometry")]
pub use torse_geometry as geometry;
/// Manuscripts in LaTeX, read as proposals for derivation files.
#[cfg(feature = "papers")]
pub use torse_manuscript as manuscript;
/// Documents and words: PDF, HTML, JSON, letters.
#[cfg(feature = "papers")]
pub use torse_report as report;
/// Statements and proofs for the kernel of Rocq.
#[cfg(feature = "kernel")]
pub use torse_rocq as kernel;
/// Texts to trees; derivation files.
#[cfg(feature = "papers")]
pub use torse_syntax as syntax;
#[cfg(feature = "papers")]
pub use torse_syntax::derivation::undeclared_names;
#[cfg(feature = "papers")]
pub use torse_syntax::taxonomy::Verdict;
/// Outcomes and what they hold.
#[cfg(feature = "papers")]
pub use torse_verdicts as verdicts;
