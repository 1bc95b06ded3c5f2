//! Derivation files while they are written: what is wrong, what was found, what a name means, what may stand at the cursor.
//!
//! This is what an editor shows beside the text, without the protocol of any editor. A folder is read with texts that are
//! not saved ([`EditedFolder`]); claims are decided once for what they rest on ([`KnownFindings`]), and a
//! [`Verifier`](crate::Verifier) that is stopped ends the work at once. Places are bytes of the text of a file.

mod completion;
mod cursor;
mod folder;
mod hover;
mod keys;
mod notes;

pub use completion::{CompletionKind, EditorCompletion};
pub use folder::{EditedFolder, KnownFindings};
pub use hover::EditorHover;
pub use notes::{EditorNote, EditorNoteLevel, TextRewrite};
