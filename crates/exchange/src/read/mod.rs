//! Reading files of other programs.

mod kind;

pub use kind::FileKind;
