//! Multiplies on demand, to be timed beside another library.
//!
//! Reads one request a line from the standard input and answers it with a line. `time NAME COUNT`
//! multiplies so often and answers with the nanoseconds of one product; `value NAME` answers with the number
//! of terms of the product and its value at x = 2, y = 3, z = 5, w = 7 and 11 for every other symbol.

#[path = "../benches/generated/mod.rs"]
mod generated;

use generated::Case;
use std::collections::HashMap;
use std::convert::Infallible;
use std::hint::black_box;
use std::io::{BufRead, Error, Write};
use std::time::Instant;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational};

/// Nanoseconds of one product, the mean of `count`.
fn time([a, b]: &[Polynomial; 2], count: u32) -> u128 {
    let start = Instant::now();
    for _ in 0..count {
        black_box(black_box(a) * black_box(b));
    }
    start.elapsed().as_nanos() / u128::from(count.max(1))
}

/// The number of terms of the product and its value.
fn value([a, b]: &[Polynomial; 2]) -> (usize, Rational) {
    let product = a * b;
    let value = product.evaluate(&integer(1), |symbol| {
        Ok::<_, Infallible>(integer(match symbol.to_string().as_str() {
            "x" => 2,
            "y" => 3,
            "z" => 5,
            "w" => 7,
            _ => 11,
        }))
    });
    match value {
        Ok(value) => (product.len(), value),
    }
}

fn main() -> Result<(), Error> {
    let mut known: HashMap<&str, [Polynomial; 2]> = HashMap::new();
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let words: Vec<&str> = line.split_whitespace().collect();
        let name = words.get(1).copied().unwrap_or_default();
        let case = Case::ALL.into_iter().find(|case| case.0 == name);
        let (name, case) = case.ok_or_else(|| Error::other(format!("no product {name:?}")))?;
        let factors = known.entry(name).or_insert_with(|| case.factors());
        match words.as_slice() {
            ["time", _, count] => {
                let count = count.parse().map_err(Error::other)?;
                println!("{}", time(factors, count));
            }
            ["value", _] => {
                let (terms, value) = value(factors);
                println!("{terms} {value}");
            }
            _ => return Err(Error::other(format!("no request {line:?}"))),
        }
        std::io::stdout().flush()?;
    }
    Ok(())
}
