//! Operators by value and by reference: short numbers are computed by [`machine`], others by the inner type.

use super::{Inner, Integer, Rational, machine};
use num_traits::{Num, One, Signed, Zero};
use std::iter::{Product, Sum};
use std::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};

macro_rules! operator {
    ($($trait:ident $method:ident, $assign:ident $assign_method:ident;)*) => {$(
        impl $trait for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, other: Rational) -> Rational {
                match machine::$method(&self, &other) {
                    Some(short) => short,
                    None => Rational(self.0.$method(other.0)),
                }
            }
        }

        impl $trait<&Rational> for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, other: &Rational) -> Rational {
                match machine::$method(&self, other) {
                    Some(short) => short,
                    None => Rational(self.0.$method(&other.0)),
                }
            }
        }

        impl $trait<Rational> for &Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, other: Rational) -> Rational {
                match machine::$method(self, &other) {
                    Some(short) => short,
                    None => Rational((&self.0).$method(other.0)),
                }
            }
        }

        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, other: &Rational) -> Rational {
                match machine::$method(self, other) {
                    Some(short) => short,
                    None => Rational((&self.0).$method(&other.0)),
                }
            }
        }

        impl $assign for Rational {
            #[inline]
            fn $assign_method(&mut self, other: Rational) {
                match machine::$method(self, &other) {
                    Some(short) => *self = short,
                    None => self.0.$assign_method(other.0),
                }
            }
        }

        impl $assign<&Rational> for Rational {
            #[inline]
            fn $assign_method(&mut self, other: &Rational) {
                match machine::$method(self, other) {
                    Some(short) => *self = short,
                    None => self.0.$assign_method(&other.0),
                }
            }
        }
    )*};
}

operator! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
    Div div, DivAssign div_assign;
    Rem rem, RemAssign rem_assign;
}

/// Products and quotients with integers.
macro_rules! scaling {
    ($($trait:ident $method:ident;)*) => {$(
        impl $trait<Integer> for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, n: Integer) -> Rational {
                Rational(self.0.$method(n))
            }
        }

        impl $trait<&Integer> for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, n: &Integer) -> Rational {
                Rational(self.0.$method(n))
            }
        }

        impl $trait<&Integer> for &Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, n: &Integer) -> Rational {
                Rational((&self.0).$method(n))
            }
        }
    )*};
}

scaling! {
    Mul mul;
    Div div;
}

impl Neg for Rational {
    type Output = Rational;
    #[inline]
    fn neg(self) -> Rational {
        Rational(-self.0)
    }
}

impl Neg for &Rational {
    type Output = Rational;
    #[inline]
    fn neg(self) -> Rational {
        Rational(-&self.0)
    }
}

impl Zero for Rational {
    #[inline]
    fn zero() -> Self {
        Self(Inner::zero())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.numer().is_zero()
    }
}

impl One for Rational {
    #[inline]
    fn one() -> Self {
        Self(Inner::one())
    }

    #[inline]
    fn is_one(&self) -> bool {
        self.numer().is_one() && self.denom().is_one()
    }
}

impl Num for Rational {
    type FromStrRadixErr = super::RationalError;

    /// Text such as `-22/7` in a base from 2 to 36.
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        super::text::parsed(text, |part| Integer::from_str_radix(part, radix).ok())
    }
}

impl Signed for Rational {
    fn abs(&self) -> Self {
        Self::in_lowest_terms(Signed::abs(self.numer()), self.denom().clone())
    }

    fn abs_sub(&self, other: &Self) -> Self {
        if self > other {
            self - other
        } else {
            Self::zero()
        }
    }

    fn signum(&self) -> Self {
        Self::from_integer(Signed::signum(self.numer()))
    }

    #[inline]
    fn is_positive(&self) -> bool {
        Signed::is_positive(self.numer())
    }

    #[inline]
    fn is_negative(&self) -> bool {
        Signed::is_negative(self.numer())
    }
}

impl Sum for Rational {
    fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers.fold(Self::zero(), |sum, q| sum + q)
    }
}

impl<'a> Sum<&'a Rational> for Rational {
    fn sum<I: Iterator<Item = &'a Self>>(numbers: I) -> Self {
        numbers.fold(Self::zero(), |sum, q| sum + q)
    }
}

impl Product for Rational {
    fn product<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers.fold(Self::one(), |product, q| product * q)
    }
}

impl<'a> Product<&'a Rational> for Rational {
    fn product<I: Iterator<Item = &'a Self>>(numbers: I) -> Self {
        numbers.fold(Self::one(), |product, q| product * q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::integer;
    use proptest::prelude::*;

    /// A fraction as a pair of machine integers, for a second way to compute.
    fn pair() -> impl Strategy<Value = (i128, i128)> {
        (-2000_i128..2000, 1_i128..2000)
    }

    fn number((n, d): (i128, i128)) -> Rational {
        Rational::new(n.into(), d.into())
    }

    proptest! {
        #[test]
        fn operators_agree_with_fractions_of_machine_integers(x in pair(), y in pair()) {
            let ((a, b), (c, d)) = (x, y);
            let (p, q) = (number(x), number(y));
            prop_assert_eq!(&p + &q, number((a * d + c * b, b * d)));
            prop_assert_eq!(&p - &q, number((a * d - c * b, b * d)));
            prop_assert_eq!(&p * &q, number((a * c, b * d)));
            prop_assert_eq!(-&p, number((-a, b)));
            prop_assert_eq!(p.abs() * p.signum(), p.clone());
            prop_assert_eq!(p.is_negative(), a < 0);
            prop_assert_eq!(p.cmp(&q), (a * d).cmp(&(c * b)));
            if c != 0 {
                prop_assert_eq!(&p / &q, Rational::new((a * d).into(), (b * c).into()));
                prop_assert_eq!((&p / &q).trunc() * &q + &p % &q, p.clone());
                prop_assert_eq!(q.recip() * &q, integer(1));
            }
        }

        #[test]
        fn operators_by_value_by_reference_and_in_place_agree(x in pair(), y in pair()) {
            let (p, q) = (number(x), number(y));
            macro_rules! same {
                ($op:tt, $assign:tt) => {{
                    let expected = &p $op &q;
                    let (mut by_value, mut by_reference) = (p.clone(), p.clone());
                    by_value $assign q.clone();
                    by_reference $assign &q;
                    let all = [p.clone() $op q.clone(), p.clone() $op &q, &p $op q.clone(), by_value, by_reference];
                    prop_assert!(all.iter().all(|found| *found == expected));
                }};
            }
            same!(+, +=);
            same!(-, -=);
            same!(*, *=);
            if !q.is_zero() {
                same!(/, /=);
                same!(%, %=);
            }
            prop_assert_eq!([&p, &q].into_iter().sum::<Rational>(), &p + &q);
            prop_assert_eq!([&p, &q].into_iter().product::<Rational>(), &p * &q);
        }

        #[test]
        fn powers_are_repeated_products(x in pair(), exponent in 0_i32..9) {
            let p = number(x);
            let expected: Rational = std::iter::repeat_n(&p, exponent as usize).product();
            prop_assert_eq!(p.pow(exponent), expected.clone());
            if !p.is_zero() {
                prop_assert_eq!(p.pow(-exponent), expected.recip());
            }
        }
    }
}
