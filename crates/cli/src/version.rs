//! The version of the command.

/// The version, and the commit that it was built from where that is known.
pub const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), env!("TORSE_COMMIT"));
