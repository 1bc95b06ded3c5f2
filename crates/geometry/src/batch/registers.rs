//! The widest vector registers of the machine with the feature `simd`; without it registers of one number.
//!
//! Additions and multiplications are the same in the same order, so the values do not depend on it.

#[cfg(not(feature = "simd"))]
pub(crate) use one::{Arch, Simd, WithSimd, bytemuck};
#[cfg(feature = "simd")]
pub(crate) use pulp::{Arch, Simd, WithSimd, bytemuck};

/// The names of pulp that are used here, for registers of one number.
#[cfg(not(feature = "simd"))]
mod one {
    #![allow(non_camel_case_types, reason = "the names of pulp")]

    use std::fmt::Debug;
    use std::ops::{Add, Div, Mul, Neg, Sub};

    /// A register.
    pub(crate) trait Register: Copy + Debug + Send + Sync {
        fn numbers(registers: &[Self]) -> &[f64];
        fn numbers_mut(registers: &mut [Self]) -> &mut [f64];
    }

    impl Register for f64 {
        fn numbers(registers: &[Self]) -> &[f64] {
            registers
        }

        fn numbers_mut(registers: &mut [Self]) -> &mut [f64] {
            registers
        }
    }

    /// What the machine does with registers.
    pub(crate) trait Simd: Copy + Debug + Send + Sync {
        type f64s: Register
            + Add<Output = Self::f64s>
            + Sub<Output = Self::f64s>
            + Mul<Output = Self::f64s>
            + Div<Output = Self::f64s>
            + Neg<Output = Self::f64s>;
        const F64_LANES: usize;

        fn splat_f64s(self, value: f64) -> Self::f64s;
        fn as_simd_f64s(column: &[f64]) -> (&[Self::f64s], &[f64]);
        fn as_mut_simd_f64s(column: &mut [f64]) -> (&mut [Self::f64s], &mut [f64]);

        #[inline(always)]
        fn add_f64s(self, a: Self::f64s, b: Self::f64s) -> Self::f64s {
            a + b
        }

        #[inline(always)]
        fn sub_f64s(self, a: Self::f64s, b: Self::f64s) -> Self::f64s {
            a - b
        }

        #[inline(always)]
        fn mul_f64s(self, a: Self::f64s, b: Self::f64s) -> Self::f64s {
            a * b
        }

        #[inline(always)]
        fn div_f64s(self, a: Self::f64s, b: Self::f64s) -> Self::f64s {
            a / b
        }

        #[inline(always)]
        fn neg_f64s(self, a: Self::f64s) -> Self::f64s {
            -a
        }
    }

    /// A loop over registers.
    pub(crate) trait WithSimd {
        type Output;
        fn with_simd<S: Simd>(self, simd: S) -> Self::Output;
    }

    /// The machine.
    #[derive(Debug, Clone, Copy)]
    pub(crate) struct Arch;

    impl Arch {
        #[inline(always)]
        pub(crate) fn new() -> Self {
            Self
        }

        #[inline(always)]
        pub(crate) fn dispatch<W: WithSimd>(self, work: W) -> W::Output {
            work.with_simd(self)
        }
    }

    impl Simd for Arch {
        type f64s = f64;
        const F64_LANES: usize = 1;

        #[inline(always)]
        fn splat_f64s(self, value: f64) -> f64 {
            value
        }

        #[inline(always)]
        fn as_simd_f64s(column: &[f64]) -> (&[f64], &[f64]) {
            (column, &[])
        }

        #[inline(always)]
        fn as_mut_simd_f64s(column: &mut [f64]) -> (&mut [f64], &mut [f64]) {
            (column, &mut [])
        }
    }

    pub(crate) mod bytemuck {
        use super::Register;

        #[inline(always)]
        pub(crate) fn cast_slice<R: Register>(registers: &[R]) -> &[f64] {
            R::numbers(registers)
        }

        #[inline(always)]
        pub(crate) fn cast_slice_mut<R: Register>(registers: &mut [R]) -> &mut [f64] {
            R::numbers_mut(registers)
        }
    }
}
