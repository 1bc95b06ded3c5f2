//! Compares every arithmetic in every layout with the sum of all products of pairs of terms.

use super::*;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Distinct rows with nonzero coefficients.
type Terms = BTreeMap<Vec<u16>, Integer>;
/// The same terms in descending order, as a list of all exponents and a list of all coefficients.
type Flat = (Vec<u16>, Vec<Integer>);

fn flat(terms: &Terms) -> Flat {
    let descending = || terms.iter().rev();
    (
        descending().flat_map(|(row, _)| row.clone()).collect(),
        descending().map(|(_, c)| c.clone()).collect(),
    )
}

fn naive(a: &Terms, b: &Terms) -> Flat {
    let mut sums = Terms::new();
    for (row_a, x) in a {
        for (row_b, y) in b {
            let row = row_a.iter().zip(row_b).map(|(i, j)| i + j).collect();
            *sums.entry(row).or_insert(Integer::ZERO) += x * y;
        }
    }
    sums.retain(|_, c| !c.is_zero());
    flat(&sums)
}

/// A polynomial in `columns` variables with these integers over `denominator`, not in normal form.
fn polynomial(terms: &Terms, columns: usize, denominator: &Integer) -> Polynomial {
    let names = ["x", "y", "z", "w"].into_iter().take(columns);
    let (exponents, coefficients) = flat(terms);
    let symbols = names.map(crate::Symbol::named).collect();
    Polynomial::new(symbols, exponents, coefficients, denominator.clone())
}

/// All layouts of the product by one arithmetic.
fn layouts<K: Coefficients>(
    kind: &K,
    columns: usize,
    (rows_a, a): (&[u16], &[K::Factor]),
    (rows_b, b): (&[u16], &[K::Factor]),
) -> Vec<(&'static str, Flat)>
where
    K::Factor: Clone,
{
    let highest = highest(rows_a, rows_b, columns).unwrap();
    let widths = widths(&highest);
    let (left, right) = (|| (rows_a, a.to_vec()), || (rows_b, b.to_vec()));
    let mut results = vec![
        ("chosen", terms(kind, &highest, left(), right())),
        (
            "64 bits",
            sparse_terms::<u64, K>(kind, &widths, left(), right()),
        ),
        (
            "128 bits",
            sparse_terms::<u128, K>(kind, &widths, left(), right()),
        ),
        (
            "rows",
            sparse_terms::<Box<[u16]>, K>(kind, &widths, left(), right()),
        ),
        (
            "one hash",
            sparse_terms::<Clash, K>(kind, &widths, left(), right()),
        ),
    ];
    let cells: usize = highest.iter().map(|top| usize::from(*top) + 1).product();
    if cells <= 1 << 16 {
        let table = dense::product(kind, &highest, cells, (rows_a, a), (rows_b, b));
        results.push(("table", table));
    }
    results
}

/// A row that has the same hash as every other.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Clash(u64);

impl Row for Clash {
    fn pack(exponents: &[u16], widths: &[u32]) -> Self {
        Self(u64::pack(exponents, widths))
    }

    fn unpack(&self, widths: &[u32], into: &mut Vec<u16>) {
        self.0.unpack(widths, into);
    }

    fn plus(&self, other: &Self) -> Self {
        Self(self.0.plus(&other.0))
    }

    fn hash(&self) -> u64 {
        u64::MAX
    }
}

/// Asserts that each arithmetic that accepts the factors gives the naive product in each layout.
fn assert_naive(a: &Terms, b: &Terms, columns: usize) {
    let expected = naive(a, b);
    let ((rows_a, x), (rows_b, y)) = (flat(a), flat(b));
    let mut results = layouts(&Integers, columns, (&rows_a, &x), (&rows_b, &y));
    if let Some((x, y)) = Words::factors(&x, &y) {
        results.extend(layouts(&Words, columns, (&rows_a, &x), (&rows_b, &y)));
    }
    if let Some((x, y)) = DoubleWords::factors(&x, &y) {
        results.extend(layouts(&DoubleWords, columns, (&rows_a, &x), (&rows_b, &y)));
    }
    // A product of small numbers, so that fractions can be reduced, in all powers up to a length above which sums are
    // brought over the common denominator.
    let denominators = [(30_030_u32, 1), (30_030, 90)];
    for (base, power) in denominators {
        let denominator = Integer::from(base).pow(power);
        let (p, q) = (
            polynomial(a, columns, &denominator),
            polynomial(b, columns, &denominator),
        );
        let kind = Quotients::new(&p, &q);
        let (x, y) = (Quotients::factors(&p), Quotients::factors(&q));
        results.extend(layouts(&kind, columns, (&rows_a, &x), (&rows_b, &y)));
    }
    for (layout, result) in results {
        assert!(result == expected, "{layout}");
    }
}

fn coefficient() -> impl Strategy<Value = Integer> {
    prop_oneof![
        4 => (-3_i64..=3).prop_map(Integer::from),
        1 => any::<i64>().prop_map(Integer::from),
        1 => prop::sample::select(vec![i64::MIN, i64::MAX, -i64::MAX]).prop_map(Integer::from),
    ]
}

fn long_coefficient() -> impl Strategy<Value = Integer> {
    prop_oneof![
        coefficient(),
        any::<i128>().prop_map(Integer::from),
        prop::sample::select(vec![i128::MIN, i128::MAX, 1 << 126, -(1 << 126), -1 << 64])
            .prop_map(Integer::from),
        any::<[u8; 40]>().prop_map(|bytes| Integer::from_le_bytes(&bytes)),
    ]
}

fn factor(
    coefficient: impl Strategy<Value = Integer>,
    columns: usize,
    top: u16,
    terms: usize,
) -> impl Strategy<Value = Terms> {
    let row = prop::collection::vec(0..=top, columns);
    prop::collection::vec((row, coefficient), 1..terms).prop_map(|terms| {
        let terms = terms.into_iter().filter(|(_, c)| !c.is_zero());
        let mut terms: Terms = terms.collect();
        if terms.is_empty() {
            terms.insert(vec![0; 3], Integer::ONE);
        }
        terms
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn all_arithmetics_and_layouts_give_the_naive_product_where_rows_collide(
        a in factor(coefficient(), 3, 4, 40), b in factor(coefficient(), 3, 4, 40),
    ) {
        assert_naive(&a, &b, 3);
    }

    #[test]
    fn all_arithmetics_and_layouts_give_the_naive_product_where_rows_are_far_apart(
        a in factor(coefficient(), 3, 900, 40), b in factor(coefficient(), 3, 900, 12),
    ) {
        assert_naive(&a, &b, 3);
    }

    #[test]
    fn coefficients_at_the_ends_of_the_machine_integers_do_not_overflow(
        a in factor(long_coefficient(), 3, 2, 20), b in factor(long_coefficient(), 3, 2, 20),
    ) {
        assert_naive(&a, &b, 3);
    }

    #[test]
    fn a_product_of_two_words_each_is_what_big_integers_say(x in ends(), y in ends()) {
        let mut sum = DoubleWords.zero();
        DoubleWords.add_product(&mut sum, &x, &y);
        let expected = Integer::from(x) * Integer::from(y);
        prop_assert_eq!(DoubleWords.is_zero(&sum), expected.is_zero());
        prop_assert_eq!(DoubleWords.value(sum), expected);
    }

    #[test]
    fn sums_of_four_words_carry_as_big_integers_do(factors in prop::collection::vec((ends(), ends()), 0..16)) {
        let mut sum = DoubleWords.zero();
        let mut expected = Integer::ZERO;
        for (x, y) in &factors {
            // Of 125 bits, so that all sixteen fit.
            let (x, y) = (x >> 3, y >> 3);
            DoubleWords.add_product(&mut sum, &x, &y);
            expected += Integer::from(x) * Integer::from(y);
        }
        prop_assert_eq!(DoubleWords.is_zero(&sum), expected.is_zero());
        prop_assert_eq!(DoubleWords.value(sum), expected);
    }
}

/// Integers of two words, often at an end of a range.
fn ends() -> impl Strategy<Value = i128> {
    let special = vec![
        i128::MIN,
        i128::MAX,
        0,
        1,
        -1,
        1 << 64,
        -(1 << 64),
        (1 << 64) - 1,
    ];
    prop_oneof![any::<i128>(), prop::sample::select(special)]
}

#[test]
fn the_bounds_admit_the_largest_sums_that_fit_and_no_larger_ones() {
    // Of n = 2^k - 1 products of one row.
    let equal = |c: i128, count: usize| vec![Integer::from(c); count];
    // 62 + 62 + 3 bits make 127, the largest sum of a word pair.
    let (words, more) = (equal((1 << 62) - 1, 7), equal((1 << 62) - 1, 8));
    assert!(Words::factors(&words, &words).is_some());
    assert!(Words::factors(&more, &more).is_none());
    let (words, more) = (equal(-(1 << 125), 7), equal(-(1 << 125), 8));
    assert!(DoubleWords::factors(&words, &words).is_some());
    assert!(DoubleWords::factors(&more, &more).is_none());
    // All products of n terms x^i and n terms x^j with i + j fixed fall into one row.
    let ascending: Terms = (0..7)
        .map(|i| (vec![i], Integer::from(-(1_i128 << 125))))
        .collect();
    let (rows, c) = flat(&ascending);
    let (x, y) = DoubleWords::factors(&c, &c).unwrap();
    let expected = naive(&ascending, &ascending);
    for (layout, result) in layouts(&DoubleWords, 1, (&rows, &x), (&rows, &y)) {
        assert!(result == expected, "{layout}");
    }
}

#[test]
fn products_of_many_ranges_are_naive_products() {
    let mut state = 1_u64;
    let mut next = move |modulus: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 20) % modulus
    };
    // Evenly spread rows, and rows in few clusters, which defeat evenly spaced pivots.
    for clustered in [false, true] {
        let mut factor = |count: usize| -> Terms {
            let rows = (0..count).map(|_| {
                let wide = if clustered { 1 + 5000 * next(2) } else { 5001 };
                let row = [next(wide), next(40), next(3)].map(|e| e as u16);
                (row.to_vec(), Integer::from(next(9) + 1) - Integer::from(5))
            });
            rows.filter(|(_, c)| !c.is_zero()).collect()
        };
        let (a, b) = (factor(120), factor(400));
        assert_naive(&a, &b, 3);
    }
}

#[test]
fn a_product_that_cancels_to_few_terms_has_no_zero_coefficients() {
    // (x - 1)(x^n + ... + 1) in each layout, and over both ends of the range of exponents.
    let all: Terms = (0..700).map(|i| (vec![i], Integer::ONE)).collect();
    let step: Terms = [(vec![1], Integer::ONE), (vec![0], Integer::NEG_ONE)].into();
    assert_eq!(naive(&all, &step).0, [700, 0]);
    assert_naive(&all, &step, 1);
}

#[test]
fn unrelated_denominators_are_kept_as_fractions_and_related_ones_are_not() {
    let factor = |first: i64, related: bool| {
        let terms = (0..40).map(|i| {
            let denominator = if related {
                1 << (i % 20)
            } else {
                first + 2 * i
            };
            let c = crate::rational::ratio(2 * i + 1, denominator).unwrap();
            &Polynomial::named("x").power(i as u32) * &Polynomial::constant(&c)
        });
        terms.fold(Polynomial::zero(), |sum, term| &sum + &term)
    };
    let (a, b) = (factor(1_000_000_007, false), factor(2_000_000_011, false));
    assert!(Quotients::if_faster(&a, &b).is_some());
    let smooth = factor(1, true);
    assert!(Quotients::if_faster(&smooth, &smooth).is_none());
    // The product of values is the value of the product.
    let at = |p: &Polynomial| p.substituted(|_| Some(Polynomial::integer(3)));
    assert_eq!(at(&(&a * &b)), &at(&a) * &at(&b));
    // And the sum of the products by single terms is the product.
    let by_terms = b.terms().map(|term| {
        let power =
            Polynomial::named("x").power(term.powers.first().map_or(0, |(_, e)| u32::from(*e)));
        (&a * &power).scaled(&term.coefficient)
    });
    let sum = by_terms.fold(Polynomial::zero(), |sum, p| &sum + &p);
    assert_eq!(sum, &a * &b);
}

#[test]
fn exponents_up_to_the_largest_are_added_exactly() {
    let x = |e: u32| &Polynomial::named("x").power(e) + &Polynomial::named("y").power(e / 2);
    let product = &x(40_000) * &x(25_535);
    assert_eq!(product.degree_in(&crate::Symbol::named("x")), u16::MAX);
    assert_eq!(product.degree_in(&crate::Symbol::named("y")), 32_767);
    assert_eq!(product.len(), 4);
}

#[test]
#[should_panic(expected = "a power with an exponent above 65535")]
fn a_larger_exponent_is_refused_not_wrapped() {
    let _ = Polynomial::named("x").power(65_536);
}

#[test]
fn a_well_filled_box_goes_by_the_table_and_a_scattered_or_vast_one_does_not() {
    let cells = dense::cells::<i128>;
    assert_eq!(cells(&[6, 6, 6], 64, 64), Some(343));
    assert_eq!(cells(&[6, 6, 6], 9, 9), None);
    assert_eq!(cells(&[1400, 1500, 1600], 64, 64), None);
    assert_eq!(cells(&[u16::MAX; 9], usize::MAX, 2), None);
    // However many products there are, there is room for this many cells of 16 bytes, and for half as many of 32.
    assert_eq!(cells(&[127, 127, 127], 5000, 5000), Some(1 << 21));
    assert_eq!(
        dense::cells::<[i128; 2]>(&[127, 127, 127], 5000, 5000),
        None
    );
}
