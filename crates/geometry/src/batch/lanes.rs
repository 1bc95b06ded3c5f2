//! A vector register as a scalar.
//!
//! What is written for scalars runs on a whole register of parameters at once, with the operations of f64 in the
//! same order and never fused: every lane has the bits that f64 alone would have, on every machine.

use super::registers::{Simd, bytemuck};
use crate::coordinate::Coordinate;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};
use torse_algebra::{ExactError, Rational, Scalar};

/// Numbers that are computed side by side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lanes<V: Simd> {
    simd: V,
    values: V::f64s,
}

impl<V: Simd> Lanes<V> {
    /// The same number in all lanes.
    #[inline(always)]
    pub(super) fn all(simd: V, value: f64) -> Self {
        let values = simd.splat_f64s(value);
        Self { simd, values }
    }

    /// Register `index` of a column of numbers; zeros beyond its end.
    #[inline(always)]
    pub(super) fn load(simd: V, column: &[f64], index: usize) -> Self {
        let (registers, _) = V::as_simd_f64s(column);
        match registers.get(index) {
            Some(values) => Self {
                simd,
                values: *values,
            },
            None => Self::all(simd, 0.0),
        }
    }

    /// Into register `index` of a column.
    #[inline(always)]
    pub(super) fn store(self, column: &mut [f64], index: usize) {
        let (registers, _) = V::as_mut_simd_f64s(column);
        if let Some(slot) = registers.get_mut(index) {
            *slot = self.values;
        }
    }

    #[inline(always)]
    fn lanes(&self) -> &[f64] {
        bytemuck::cast_slice(std::slice::from_ref(&self.values))
    }

    #[inline(always)]
    fn like(&self, value: f64) -> Self {
        Self::all(self.simd, value)
    }

    #[inline(always)]
    fn with(self, values: V::f64s) -> Self {
        Self { values, ..self }
    }
}

impl<V: Simd> Add for Lanes<V> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(self.simd.add_f64s(self.values, other.values))
    }
}

impl<V: Simd> Sub for Lanes<V> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(self.simd.sub_f64s(self.values, other.values))
    }
}

impl<V: Simd> Mul for Lanes<V> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(self.simd.mul_f64s(self.values, other.values))
    }
}

impl<V: Simd> Neg for Lanes<V> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.with(self.simd.neg_f64s(self.values))
    }
}

impl<V: Simd> Scalar for Lanes<V> {
    fn constant(&self, q: &Rational) -> Self {
        self.like(0.0.constant(q))
    }

    /// Never refused: in lanes whose divisor is zero the result is not finite, and whoever divides looks at
    /// these one by one.
    #[inline(always)]
    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        Ok(self.with(self.simd.div_f64s(self.values, divisor.values)))
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let (mut sines, mut cosines) = (self.like(0.0), self.like(0.0));
        let slots = bytemuck::cast_slice_mut(std::slice::from_mut(&mut sines.values));
        let others = bytemuck::cast_slice_mut(std::slice::from_mut(&mut cosines.values));
        for ((x, sine), cosine) in self
            .lanes()
            .iter()
            .zip::<&mut [f64]>(slots)
            .zip::<&mut [f64]>(others)
        {
            (*sine, *cosine) = x.quarter_turn()?;
        }
        Ok((sines, cosines))
    }
}

impl<V: Simd> Coordinate for Lanes<V> {
    #[inline(always)]
    fn is_finite(&self) -> bool {
        self.lanes().iter().all(|x| x.is_finite())
    }

    /// The sign that all lanes have.
    fn sign(&self) -> Option<Ordering> {
        let mut signs = self.lanes().iter().map(Coordinate::sign);
        let first = signs.next()?;
        first.filter(|_| signs.all(|sign| sign == first))
    }

    /// That of the first lane.
    fn approximate(&self) -> f64 {
        self.lanes().first().copied().unwrap_or(f64::NAN)
    }

    #[inline(always)]
    fn times_two_to(&self, power: i32) -> Self {
        let mut product = *self;
        for factor in crate::coordinate::powers_of_two(power) {
            product = product * self.like(factor);
        }
        product
    }

    #[inline(always)]
    fn zero(&self) -> Self {
        self.like(0.0)
    }

    #[inline(always)]
    fn one(&self) -> Self {
        self.like(1.0)
    }

    #[inline(always)]
    fn natural(&self, n: usize) -> Self {
        self.like(0.0.natural(n))
    }
}
