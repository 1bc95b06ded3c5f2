//! Loops on the widest vector registers of the machine.
//!
//! The same additions and multiplications in the same order, only more of them at a time (and never
//! fused), so the values do not depend on the machine.

use super::registers::{Arch, Simd, WithSimd};

/// Runs `f`, compiled for the machine's vector registers: call it around a whole loop.
#[inline]
pub(crate) fn widest<T>(f: impl FnOnce() -> T) -> T {
    struct Loop<F>(F);
    impl<T, F: FnOnce() -> T> WithSimd for Loop<F> {
        type Output = T;

        #[inline(always)]
        fn with_simd<S: Simd>(self, _: S) -> T {
            (self.0)()
        }
    }
    Arch::new().dispatch(Loop(f))
}
