//! The tests that cross rooms live in `tests/tests`; this library is empty.
