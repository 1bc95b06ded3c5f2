//! Balls against an independent implementation (dashu-float, correctly rounded) and against exact
//! rational arithmetic.

use dashu_float::round::{Round, mode};
use dashu_float::{Context, FBig, Repr};
use num_traits::{Signed, Zero};
use proptest::prelude::*;
use std::cmp::Ordering;
use torse_numbers::rational::{integer, ratio, to_f64};
use torse_numbers::{Ball, ExactError, Integer, Rational, Scalar, ZeroTest};

fn power_of_two(exponent: isize) -> Rational {
    let magnitude = Rational::from_integer(Integer::ONE << exponent.unsigned_abs());
    if exponent >= 0 {
        magnitude
    } else {
        magnitude.recip()
    }
}

fn units(n: i64, bits: usize) -> Rational {
    integer(n) * power_of_two(-(bits as isize))
}

fn at_most(a: &Rational, b: &Rational) -> bool {
    a <= b
}

/// `inner` lies in `outer`.
fn is_inside(inner: &Ball, outer: &Ball) -> bool {
    at_most(&outer.lower(), &inner.lower()) && at_most(&inner.upper(), &outer.upper())
}

fn exact<R: Round>(value: &FBig<R>) -> Rational {
    Rational::from_integer(value.repr().significand().clone())
        * power_of_two(value.repr().exponent())
}

/// What the independent implementation makes of one argument, rounded down and rounded up.
macro_rules! rounded_both_ways {
    ($digits:expr, |$context:ident| $pair:expr) => {{
        let down = |$context: Context<mode::Down>| $pair;
        let up = |$context: Context<mode::Up>| $pair;
        let (below_s, below_c) = down(Context::new($digits));
        let (above_s, above_c) = up(Context::new($digits));
        (
            (
                exact(&below_s.unwrap().value()),
                exact(&above_s.unwrap().value()),
            ),
            (
                exact(&below_c.unwrap().value()),
                exact(&above_c.unwrap().value()),
            ),
        )
    }};
}

fn assert_inside(ball: &Ball, (below, above): (Rational, Rational)) {
    assert!(
        ball.contains(&below) && ball.contains(&above),
        "{ball} does not contain [{below}, {above}]"
    );
}

fn rational() -> impl Strategy<Value = Rational> {
    (any::<i64>(), 1..=i64::MAX, -100_isize..100)
        .prop_map(|(n, d, e)| Rational::new(n.into(), d.into()) * power_of_two(e))
}

/// Two rationals of any order and something between them.
fn interval_and_point() -> impl Strategy<Value = (Rational, Rational, Rational)> {
    (rational(), rational(), 0_i64..=16).prop_map(|(a, b, t)| {
        let inside = &a + (&b - &a) * Rational::new(t.into(), 16.into());
        (a, b, inside)
    })
}

#[test]
fn pi_is_the_unit_interval_around_pi_whatever_was_asked_before() {
    for bits in (0..200).chain([333, 1000, 5000, 64, 3, 0]) {
        let ball = Ball::pi(bits);
        assert_eq!(ball.width(), units(1, bits));
        let below = exact(&Context::<mode::Down>::new(bits + 80).pi::<2>(None).value());
        let above = exact(&Context::<mode::Up>::new(bits + 80).pi::<2>(None).value());
        assert!(below < above);
        assert_inside(&ball, (below, above));
    }
}

#[test]
fn quarter_turns_at_integers_are_exact() {
    for n in -9..=9_i64 {
        let (s, c) = Ball::from_rational(&integer(n), 30).quarter_turn().unwrap();
        let (exact_s, exact_c) = integer(n).quarter_turn().unwrap();
        assert_eq!((s.width(), c.width()), (Rational::zero(), Rational::zero()));
        assert_eq!((s.lower(), c.lower()), (exact_s, exact_c));
    }
}

#[test]
fn a_quarter_turn_over_an_interval_reaches_its_turning_points_exactly() {
    let range = |lo, hi| Ball::from_bounds(&lo, &hi, 40).quarter_turn().unwrap();
    let half = ratio(1, 2).unwrap();
    let (s, c) = range(half.clone(), integer(1) + &half);
    assert_eq!(s.upper(), integer(1));
    assert!(s.contains(&ratio(70_711, 100_000).unwrap()) && !s.contains(&ratio(7, 10).unwrap()));
    assert!(c.contains_zero() && !c.contains(&ratio(3, 4).unwrap()));
    let (s, c) = range(integer(2), integer(4) + &half);
    assert_eq!((s.lower(), c.upper()), (integer(-1), integer(1)));
    assert!(s.upper() < integer(1) && c.lower() == integer(-1));
    let (s, c) = range(integer(-7), integer(12));
    assert_eq!(
        (s.lower(), s.upper(), c.lower(), c.upper()),
        (integer(-1), integer(1), integer(-1), integer(1))
    );
}

#[test]
fn near_zero_no_digit_of_the_sine_is_lost() {
    // sin(2^-300) = 2^-300 - 2^-900 / 6 + ...
    let tiny = power_of_two(-300);
    let (s, c) = Ball::from_rational(&tiny, 1000).sin_cos();
    let cubic = &tiny - &tiny * &tiny * &tiny * ratio(1, 6).unwrap();
    assert!(s.width() <= units(3, 1000) && c.width() <= units(3, 1000));
    assert!((s.lower() - &cubic).abs() <= units(3, 1000));
    assert!((c.lower() - (integer(1) - &tiny * &tiny / integer(2))).abs() <= units(3, 1000));
}

#[test]
fn an_angle_of_three_hundred_digits_is_reduced_exactly() {
    let googols = Rational::from_integer(Integer::from(10).pow(300));
    let (s, c) = Ball::from_rational(&googols, 100).sin_cos();
    let argument = Repr::<2>::new(Integer::from(10).pow(300), 0);
    let (sine, cosine) = rounded_both_ways!(160, |context| context.sin_cos(&argument, None));
    assert_inside(&s, sine);
    assert_inside(&c, cosine);
    assert!(s.width() <= units(3, 100) && c.width() <= units(3, 100));
}

#[test]
fn division_by_a_ball_around_zero_is_refused() {
    let one = Ball::from_rational(&integer(1), 20);
    for (lo, hi) in [(0, 0), (-1, 1), (0, 1), (-1, 0)] {
        let divisor = Ball::from_bounds(&integer(lo), &integer(hi), 20);
        assert!(matches!(
            one.divided_by(&divisor),
            Err(ExactError::DivisionByZero { .. })
        ));
    }
}

#[test]
fn a_ball_with_negative_numbers_has_no_square_root() {
    let ball = Ball::from_bounds(&ratio(-1, 1 << 20).unwrap(), &integer(1), 20);
    assert!(matches!(ball.sqrt(), Err(ExactError::NoSquareRoot { .. })));
    let root = Ball::from_rational(&integer(2), 100).sqrt().unwrap();
    assert_eq!(root.decimal(25), "1.4142135623730950488016887...");
    let three = Ball::from_rational(&integer(9), 100).sqrt().unwrap();
    assert_eq!((three.lower(), three.upper()), (integer(3), integer(3)));
}

#[test]
fn signs_are_told_only_when_they_are_known() {
    let ball = |lo, hi| Ball::from_bounds(&integer(lo), &integer(hi), 10);
    assert_eq!(ball(1, 2).sign(), Some(Ordering::Greater));
    assert_eq!(ball(-2, -1).sign(), Some(Ordering::Less));
    assert_eq!(ball(0, 0).sign(), Some(Ordering::Equal));
    for (lo, hi) in [(0, 1), (-1, 0), (-1, 1)] {
        assert_eq!(ball(lo, hi).sign(), None);
        assert!(!ball(lo, hi).is_known_zero() && !ball(lo, hi).is_known_nonzero());
    }
    assert!(ball(0, 0).is_known_zero() && ball(1, 2).is_known_nonzero());
    assert!(ball(0, 1).overlaps(&ball(1, 2)) && !ball(0, 1).overlaps(&ball(2, 3)));
}

#[test]
fn decimal_text_prints_no_digit_that_is_not_certain() {
    let between = |lo: (i64, i64), hi: (i64, i64), digits| {
        Ball::from_bounds(&ratio(lo.0, lo.1).unwrap(), &ratio(hi.0, hi.1).unwrap(), 40)
            .decimal(digits)
    };
    assert_eq!(between((1, 4), (1, 4), 5), "0.25");
    assert_eq!(between((1, 4), (1, 4), 1), "0.2...");
    assert_eq!(between((-100, 1), (-100, 1), 3), "-100");
    assert_eq!(between((100, 1), (100, 1), 0), "100");
    assert_eq!(between((-1, 300), (-1, 400), 2), "-0.00...");
    assert_eq!(between((-1, 300), (-1, 400), 3), "[-0.004, -0.002]");
    assert_eq!(between((-1, 300), (1, 400), 2), "[-0.01, 0.01]");
    assert_eq!(between((0, 1), (1, 400), 2), "0.00...");
    assert_eq!(between((-1, 400), (0, 1), 2), "[-0.01, 0.00]");
    assert_eq!(
        between((4_570_791, 100_000), (4_570_799, 100_000), 4),
        "45.7079..."
    );
    assert_eq!(
        between((4_570_791, 100_000), (4_570_801, 100_000), 4),
        "[45.7079, 45.7081]"
    );
    assert_eq!(format!("{:.3}", Ball::pi(20)), "3.141...");
    assert_eq!(Ball::pi(20).to_string(), "3.141592...");
}

#[test]
fn double_bounds_hold_at_the_ends_of_the_range_of_doubles() {
    let bounds = |q: Rational| Ball::from_rational(&q, 1200).to_f64_bounds();
    let smallest = f64::from_bits(1);
    assert_eq!(bounds(power_of_two(-1074)), (smallest, smallest));
    assert_eq!(bounds(power_of_two(-1075)), (0.0, smallest));
    assert_eq!(bounds(-power_of_two(-1080)), (-smallest, 0.0));
    assert_eq!(bounds(power_of_two(1024)), (f64::MAX, f64::INFINITY));
    assert_eq!(bounds(-power_of_two(2000)), (f64::NEG_INFINITY, -f64::MAX));
    assert_eq!(
        bounds(power_of_two(1024) - power_of_two(971)),
        (f64::MAX, f64::MAX)
    );
}

#[test]
fn a_request_for_too_many_bits_is_answered_with_the_most_there_are() {
    let third = Ball::from_rational(&ratio(1, 3).unwrap(), usize::MAX);
    assert_eq!(third.bits(), Ball::MAX_BITS);
    assert!(third.contains(&ratio(1, 3).unwrap()));
    assert_eq!(third.with_bits(usize::MAX), third);
}

proptest! {
    #[test]
    fn quarter_turns_enclose_the_correctly_rounded_values(
        numerator in any::<i64>(), places in 0_isize..80, bits in 0_usize..400,
    ) {
        let x = integer(numerator) * power_of_two(-places);
        let (s, c) = Ball::from_rational(&x, bits).quarter_turn().unwrap();
        let argument = Repr::<2>::new(numerator.into(), -places);
        let (sine, cosine) = rounded_both_ways!(bits + 100, |context| context.sin_cos_unit(&argument, 4, None));
        assert_inside(&s, sine);
        assert_inside(&c, cosine);
        // An argument that the precision holds exactly, and one that it holds to one unit.
        let most = if bits as isize >= places { 2 } else { 4 };
        prop_assert!(s.width() <= units(most, bits) && c.width() <= units(most, bits));
    }

    #[test]
    fn sines_and_cosines_enclose_the_correctly_rounded_values(
        numerator in any::<i64>(), places in 0_isize..80, bits in 80_usize..400,
    ) {
        let (s, c) = Ball::from_rational(&(integer(numerator) * power_of_two(-places)), bits).sin_cos();
        let argument = Repr::<2>::new(numerator.into(), -places);
        let (sine, cosine) = rounded_both_ways!(bits + 100, |context| context.sin_cos(&argument, None));
        assert_inside(&s, sine);
        assert_inside(&c, cosine);
        prop_assert!(s.width() <= units(3, bits) && c.width() <= units(3, bits));
    }

    #[test]
    fn a_quarter_turn_over_an_interval_contains_that_of_each_point(
        (a, b, inside) in interval_and_point(), bits in 0_usize..150,
    ) {
        // Scale down so that intervals shorter than a period occur as well.
        for scale in [1_i64, 1 << 40] {
            let scale = ratio(1, scale).unwrap();
            let (s, c) = Ball::from_bounds(&(&a * &scale), &(&b * &scale), bits).quarter_turn().unwrap();
            let (s_in, c_in) = Ball::from_rational(&(&inside * &scale), 300).quarter_turn().unwrap();
            prop_assert!(is_inside(&s_in, &s));
            prop_assert!(is_inside(&c_in, &c));
        }
    }

    #[test]
    fn arithmetic_on_balls_contains_that_on_their_points(
        (a, b, x) in interval_and_point(), (c, d, y) in interval_and_point(),
        bits in 0_usize..120, other_bits in 0_usize..120, exponent in 0_u32..6,
    ) {
        let ball_x = Ball::from_bounds(&a, &b, bits);
        let ball_y = Ball::from_bounds(&c, &d, other_bits);
        let larger = bits.max(other_bits);
        prop_assert!((&ball_x + &ball_y).contains(&(&x + &y)));
        prop_assert!((&ball_x - &ball_y).contains(&(&x - &y)));
        prop_assert!((-&ball_x).contains(&-&x));
        prop_assert!(ball_x.abs().contains(&x.abs()));
        prop_assert!(ball_x.scaled(&y).contains(&(&x * &y)));
        prop_assert!(ball_x.powi(exponent).contains(&num_traits::pow(x.clone(), exponent as usize)));
        prop_assert!(ball_x.hull(&ball_y).contains(&x) && ball_x.hull(&ball_y).contains(&y));
        let product = &ball_x * &ball_y;
        prop_assert!(product.contains(&(&x * &y)));
        prop_assert_eq!(product.bits(), larger);
        let bound = ball_x.abs().upper() * ball_y.width() + ball_y.abs().upper() * ball_x.width();
        prop_assert!(product.width() <= bound + units(2, larger));
        if let Ok(quotient) = ball_x.divided_by(&ball_y) {
            prop_assert!(quotient.contains(&(&x / &y)));
        } else {
            prop_assert!(ball_y.contains_zero());
        }
    }

    #[test]
    fn exact_arguments_give_results_of_the_stated_width(a in any::<i32>(), b in any::<i32>(), bits in 16_usize..120) {
        let (x, y) = (Rational::new(a.into(), (1 << 16).into()), Rational::new(b.into(), (1 << 16).into()));
        let (ball_x, ball_y) = (Ball::from_rational(&x, bits), Ball::from_rational(&y, bits));
        prop_assert!(ball_x.width().is_zero());
        prop_assert!((&ball_x + &ball_y).width().is_zero());
        prop_assert!((&ball_x * &ball_y).width() <= units(1, bits));
        if !y.is_zero() {
            prop_assert!(ball_x.divided_by(&ball_y).unwrap().width() <= units(1, bits));
        }
        let root = ball_x.abs().sqrt().unwrap();
        prop_assert!(root.width() <= units(1, bits));
        prop_assert!(root.lower() * root.lower() <= x.abs() && x.abs() <= root.upper() * root.upper());
    }

    #[test]
    fn the_exponential_of_a_sum_is_the_product_and_narrow(a in -40_i64..40, b in -40_i64..40, d in 1_i64..30, bits in 16_usize..300) {
        let exp = |n: i64| Ball::from_rational(&ratio(n, d).unwrap(), bits + 200).exp().unwrap().with_bits(bits);
        let (x, y, sum) = (exp(a), exp(b), exp(a + b));
        prop_assert!((&x * &y).overlaps(&sum));
        prop_assert!(sum.width() <= units(2, bits));
        prop_assert!(a >= b || x.lower() <= y.upper());
    }

    #[test]
    fn the_exponential_of_a_ball_holds_those_of_its_numbers((a, b, inside) in interval_and_point(), bits in 8_usize..120) {
        prop_assume!(a.abs() < integer(1000) && b.abs() < integer(1000));
        let of_one = Ball::from_rational(&inside, bits).exp().unwrap();
        let of_all = Ball::from_bounds(&a, &b, bits).exp().unwrap();
        prop_assert!(of_one.overlaps(&of_all));
        prop_assert!(!of_one.lower().is_negative());
    }

    #[test]
    fn multiplication_of_balls_is_as_tight_as_its_corners(
        a in -20_i64..20, b in -20_i64..20, c in -20_i64..20, d in -20_i64..20,
    ) {
        let product = Ball::from_bounds(&integer(a), &integer(b), 0) * Ball::from_bounds(&integer(c), &integer(d), 0);
        let corners = [a * c, a * d, b * c, b * d];
        prop_assert_eq!(Some(product.lower()), corners.iter().min().map(|&n| integer(n)));
        prop_assert_eq!(Some(product.upper()), corners.iter().max().map(|&n| integer(n)));
    }

    #[test]
    fn double_bounds_are_the_neighbouring_doubles(q in rational()) {
        let ball = Ball::from_rational(&q, 300);
        let (below, above) = ball.to_f64_bounds();
        prop_assert!(at_most(&exact_double(below), &ball.lower()));
        prop_assert!(at_most(&ball.upper(), &exact_double(above)));
        prop_assert!(exact_double(below.next_up()) > ball.lower());
        prop_assert!(exact_double(above.next_down()) < ball.upper());
        prop_assert!((to_f64(&q) - below).abs() <= 2.0 * (below.next_up() - below));
    }

    #[test]
    fn printed_digits_begin_every_number_of_the_ball((a, b, inside) in interval_and_point(), digits in 0_usize..30) {
        let text = Ball::from_bounds(&a, &b, 100).decimal(digits);
        let value = |text: &str| {
            let places = text.split_once('.').map_or(0, |(_, fraction)| fraction.len());
            let all: Integer = text.replace('.', "").parse().unwrap();
            Rational::new(all, Integer::from(10).pow(places))
        };
        if let Some(bounds) = text.strip_prefix('[') {
            let (lo, hi) = bounds.trim_end_matches(']').split_once(", ").unwrap();
            prop_assert!(at_most(&value(lo), &inside) && at_most(&inside, &value(hi)));
        } else if let Some(cut) = text.strip_suffix("...") {
            let step = Rational::new(Integer::ONE, Integer::from(10).pow(digits));
            let magnitude = value(cut.trim_start_matches('-'));
            prop_assert!(magnitude <= inside.abs() && inside.abs() <= magnitude + step);
            prop_assert!(inside.is_negative() == cut.starts_with('-') || inside.is_zero());
        } else {
            prop_assert_eq!(value(&text), inside);
        }
    }
}

#[test]
fn the_exponential_has_the_digits_of_the_tables() {
    let exp = |n, d| {
        let x = Ball::from_rational(&ratio(n, d).unwrap(), 400);
        x.exp().unwrap().decimal(50)
    };
    assert_eq!(exp(0, 1), "1");
    assert_eq!(
        exp(1, 1),
        "2.71828182845904523536028747135266249775724709369995..."
    );
    assert_eq!(
        exp(-1, 1),
        "0.36787944117144232159552377016146086744581113103176..."
    );
    assert_eq!(
        exp(1, 2),
        "1.64872127070012814684865078781416357165377610071014..."
    );
    assert_eq!(&exp(10, 1)[..17], "22026.46579480671");
    let far = |n: i64| Ball::from_rational(&integer(n), 64).exp();
    assert!(matches!(far(1 << 20), Err(ExactError::TooLarge { .. })));
    let small = far(-(1 << 20)).unwrap();
    assert!(small.contains_zero() && small.is_within(60));
}

fn exact_double(x: f64) -> Rational {
    let bits = x.abs().to_bits();
    let (exponent, fraction) = ((bits >> 52) as isize, bits & ((1 << 52) - 1));
    let (significand, place) = if exponent == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, exponent - 1075)
    };
    let magnitude = Rational::from_integer(significand.into()) * power_of_two(place);
    if x < 0.0 { -magnitude } else { magnitude }
}
