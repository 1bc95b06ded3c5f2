//! Sine and cosine of a quarter turn on f64, without branches that depend on the platform's library.
//!
//! `sin(pi y/2)` and `cos(pi y/2)` for `y` in [0, 1/2] are their Taylor polynomials in `y^2`; the terms
//! left out are below `(pi/4)^18/19! < 10^-18`. The upper half of the unit interval is reflected: there
//! `1 - x` is exact, so the ends are exact too. The same operations run on every machine, so equal
//! parameters give equal bits everywhere; two units in the last place bound the error (a test compares
//! with balls).

/// `(-1)^n (pi/2)^(2n+1) / (2n+1)!` for `n = 0 .. 8`.
const SINE: [f64; 9] = [
    std::f64::consts::FRAC_PI_2,
    -0.645_964_097_506_246_3,
    0.079_692_626_246_167_05,
    -0.004_681_754_135_318_688,
    0.000_160_441_184_787_359_83,
    -3.598_843_235_212_085e-6,
    5.692_172_921_967_927e-8,
    -6.688_035_109_811_468e-10,
    6.066_935_731_106_195_5e-12,
];

/// `pi/2` minus the f64 nearest to it.
const SINE_TAIL: f64 = 6.123_233_995_736_766e-17;

/// `(-1)^n (pi/2)^(2n) / (2n)!` for `n = 0 .. 9`.
const COSINE: [f64; 10] = [
    1.0,
    -1.233_700_550_136_169_7,
    0.253_669_507_901_048_03,
    -0.020_863_480_763_352_96,
    0.000_919_260_274_839_426_6,
    -2.520_204_237_306_060_7e-5,
    4.710_874_778_818_172e-7,
    -6.386_603_083_791_852e-9,
    6.565_963_114_979_473e-11,
    -5.294_400_200_734_623e-13,
];

/// `(sin(pi x/2), cos(pi x/2))` for `x` in [0, 1].
#[inline(always)]
pub(crate) fn of_unit(x: f64) -> (f64, f64) {
    let upper = x > 0.5;
    let y = if upper { 1.0 - x } else { x };
    let square = y * y;
    let [first, sine_rest @ ..] = &SINE;
    let [_, cosine_rest @ ..] = &COSINE;
    let sine = y * first + y * (SINE_TAIL + square * horner(sine_rest, square));
    let cosine = 1.0 + square * horner(cosine_rest, square);
    if upper {
        (cosine, sine)
    } else {
        (sine, cosine)
    }
}

#[inline(always)]
fn horner<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = coefficients[N - 1];
    for c in coefficients.iter().rev().skip(1) {
        sum = sum * x + c;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact_ball;
    use proptest::prelude::*;
    use torse_algebra::{Ball, Rational, Scalar, rational::to_f64};

    #[test]
    fn the_coefficients_are_the_taylor_coefficients_rounded() {
        let half_pi = Ball::pi(300) * Ball::from_rational(&Rational::new(1.into(), 2.into()), 300);
        let mut term = half_pi.one_like();
        for n in 0..19_usize {
            let sign = if n / 2 % 2 == 0 { 1.0 } else { -1.0 };
            let table: &[f64] = if n % 2 == 0 { &COSINE } else { &SINE };
            assert_eq!(table[n / 2], sign * to_f64(&term.midpoint()), "order {n}");
            term = term
                * half_pi.clone()
                * Ball::from_rational(&Rational::new(1.into(), (n + 1).into()), 300);
        }
        let tail = half_pi - exact_ball(SINE[0], 300);
        assert_eq!(SINE_TAIL, to_f64(&tail.midpoint()));
    }

    #[test]
    fn the_ends_are_exact() {
        assert_eq!((of_unit(0.0), of_unit(1.0)), ((0.0, 1.0), (1.0, 0.0)));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn values_are_within_two_units_in_the_last_place(x in prop_oneof![0.0..=1.0_f64, 0.0..1e-9_f64, 0.4999..0.5001_f64]) {
            let (sine, cosine) = of_unit(x);
            let (s, c) = exact_ball(x, 300).quarter_turn().unwrap();
            for (value, ball) in [(sine, s), (cosine, c)] {
                let nearest = to_f64(&ball.midpoint());
                let ulp = nearest.next_up() - nearest;
                prop_assert!((value - nearest).abs() <= 2.0 * ulp, "{value} {nearest}");
            }
        }
    }
}
