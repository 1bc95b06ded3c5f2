//! The laws of the library, each checked in two independent ways.

mod agreement;
mod developables;
mod files;
mod hostile;
mod identities;
mod joins;
mod surfaces;
