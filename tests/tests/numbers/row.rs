//! A number in its row, and the page of all rows.

use crate::exact::{Exact, claim, entries};
use torse_geometry::{Ball, Rational, exact};

/// A number that a paper prints.
#[derive(Debug, Clone)]
pub struct Printed {
    /// Its digits.
    pub text: String,
    /// How far it is from the exact number.
    pub off: String,
}

/// A number.
#[derive(Debug, Clone)]
pub struct Row {
    /// The claim in whose names it is written.
    pub claim: String,
    /// The formula, and which entry of it.
    pub what: String,
    /// The values of the symbols.
    pub at: String,
    /// Exactly.
    pub exact: String,
    /// Digits that are right.
    pub enclosure: String,
    /// The double.
    pub double: f64,
    /// How far the double is from the exact number, in units in the last place of that number.
    pub own_ulps: f64,
    /// The same, in units of the largest number of its vector or matrix.
    pub ulps: f64,
    /// What the paper prints.
    pub printed: Option<Printed>,
}

impl Row {
    pub fn name(&self) -> String {
        format!("{}: {}", self.claim, self.what)
    }
}

/// A formula of a claim, and its value in doubles.
#[derive(Default)]
pub struct Case<'a> {
    pub claim: &'a str,
    pub formula: &'a str,
    /// How the entries are called; by their numbers if there are no labels.
    pub labels: Vec<String>,
    /// The values of symbols.
    pub at: &'a [(&'a str, &'a str)],
    /// Symbols that the assumed equations determine.
    pub solved: &'a [&'a str],
    /// The numbers that the paper prints, or none of them.
    pub printed: &'a [&'a str],
    pub doubles: Vec<f64>,
    /// The size of the numbers from whose difference it comes, if that is more than all of the entries.
    pub scale: f64,
}

/// A row for each entry.
pub fn rows(case: &Case<'_>) -> Vec<Row> {
    let numbers = entries(case.claim, case.formula, case.at, case.solved);
    let name = format!("{}: {}", case.claim, case.formula);
    assert_eq!(numbers.len(), case.doubles.len(), "{name}");
    assert!(case.printed.is_empty() || case.printed.len() == numbers.len());
    let largest = numbers.iter().map(|number| size(&number.ball));
    let largest = largest.fold(case.scale, f64::max);
    let mut list = vec![];
    for (place, (number, double)) in numbers.iter().zip(&case.doubles).enumerate() {
        let what = match (case.labels.get(place), numbers.len()) {
            (Some(label), _) => label.clone(),
            (None, 1) => case.formula.to_owned(),
            (None, _) => format!("{}, {}", case.formula, place + 1),
        };
        let at: Vec<String> = (case.at.iter())
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        list.push(Row {
            claim: case.claim.to_owned(),
            what,
            at: at.join(", "),
            exact: number.text.clone(),
            enclosure: enclosure(number),
            double: *double,
            own_ulps: ulps(*double, &number.ball, size(&number.ball)),
            ulps: ulps(*double, &number.ball, largest),
            printed: case.printed.get(place).map(|text| print(text, number)),
        });
    }
    list
}

fn size(ball: &Ball) -> f64 {
    let (low, high) = ball.to_f64_bounds();
    low.abs().max(high.abs())
}

/// The distance of a double from the farther end of the enclosure, in units in the last place of numbers of that size.
fn ulps(double: f64, ball: &Ball, size: f64) -> f64 {
    let reach = |end: Rational| to_f64(&(exact(double) - end)).abs();
    let farthest = reach(ball.lower()).max(reach(ball.upper()));
    match (farthest > 0.0, size > 0.0) {
        (true, true) => farthest / (f64::EPSILON * power_of_two_below(size)),
        (true, false) => f64::INFINITY,
        (false, _) => 0.0,
    }
}

/// The greatest power of two that is not above a number.
fn power_of_two_below(size: f64) -> f64 {
    // What is left without the fraction is the power.
    f64::from_bits(size.to_bits() & !((1 << 52) - 1))
}

fn to_f64(number: &Rational) -> f64 {
    torse_algebra::rational::to_f64(number)
}

/// Twenty places of the middle, and a power of ten that bounds how far the number may be from it.
fn enclosure(number: &Exact) -> String {
    const PLACES: u32 = 20;
    let ball = &number.ball;
    let shown = decimal(&ball.midpoint(), PLACES);
    let ten = torse_algebra::rational::integer(10);
    let shown_value: Rational = {
        let scale = ten.pow(PLACES as i32);
        (ball.midpoint() * scale.clone()).round() / scale
    };
    let off = |end: Rational| {
        let distance = end - shown_value.clone();
        if distance < torse_algebra::rational::integer(0) {
            -distance
        } else {
            distance
        }
    };
    let (low, high) = (off(ball.lower()), off(ball.upper()));
    let radius = if low > high { low } else { high };
    if radius == torse_algebra::rational::integer(0) {
        return shown;
    }
    let mut exponent = -60;
    while ten.pow(exponent) < radius {
        exponent += 1;
    }
    format!("{shown} ± 1e{exponent}")
}

/// A number rounded to places behind the point, without zeros at the end.
fn decimal(number: &Rational, places: u32) -> String {
    let ten = torse_algebra::rational::integer(10);
    let scaled = (number.clone() * ten.pow(places as i32))
        .round()
        .to_integer();
    let text = scaled.to_string();
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => ("-", digits),
        None => ("", text.as_str()),
    };
    let digits = format!("{digits:0>width$}", width = places as usize + 1);
    let (whole, behind) = digits.split_at(digits.len() - places as usize);
    let behind = behind.trim_end_matches('0');
    match behind.is_empty() {
        true => format!("{sign}{whole}"),
        false => format!("{sign}{whole}.{behind}"),
    }
}

fn print(text: &str, number: &Exact) -> Printed {
    let digits = text.replace('.', "");
    let places = text.split_once('.').map_or(0, |(_, behind)| behind.len());
    let value = torse_algebra::rational::integer(digits.parse::<i64>().expect("a decimal"))
        / torse_algebra::rational::integer(10).pow(places as i32);
    let off = to_f64(&(number.ball.midpoint() - value)).abs();
    let off = match off > 1e-25 {
        true => format!("{off:.1e}"),
        false => "0".to_owned(),
    };
    Printed {
        text: text.to_owned(),
        off,
    }
}

/// All rows as a page.
pub fn page(parts: &[(&str, Vec<Row>)]) -> String {
    let mut text = String::from(
        "# The numbers of the papers, twice\n\n\
        Each number is computed by two routes that share nothing. *Exact* is what the engine makes of the formulas in the derivation files, with an\n\
        enclosure; *double* is what the evaluators of `geometry` and the decompositions of nalgebra give, which read no file. *ulps* is the distance\n\
        between the two in units in the last place of the number, and in brackets of the largest number of its vector or matrix, where that differs.\n\
        Where a paper prints the number, *off* is how far the print is from it. A [test](../tests/tests/numbers/main.rs) computes this page anew.\n",
    );
    for (heading, rows) in parts {
        let prints = rows.iter().any(|row| row.printed.is_some());
        text.push_str(&format!("\n## {heading}\n"));
        let mut before = "";
        for row in rows {
            if row.claim != before {
                let at = &claim(&row.claim).entry.at;
                text.push_str(&format!("\n### {at}\n\n`{}`\n\n", row.claim));
                text.push_str("| number | exact | enclosure | double | ulps |");
                text.push_str(if prints { " printed | off |\n" } else { "\n" });
                text.push_str("|---|---|---|---|---|");
                text.push_str(if prints { "---|---|\n" } else { "\n" });
                before = &row.claim;
            }
            let at = match row.at.is_empty() {
                true => String::new(),
                false => format!(" at {}", row.at),
            };
            let own = shown(row.own_ulps);
            let ulps = match shown(row.ulps) {
                other if other == own => own,
                other => format!("{own} ({other})"),
            };
            text.push_str(&format!(
                "| `{}`{at} | `{}` | {} | {:?} | {ulps} |",
                row.what, row.exact, row.enclosure, row.double
            ));
            if prints {
                let printed = row.printed.as_ref();
                let (digits, off) = printed.map_or(("", ""), |of| (&of.text, &of.off));
                text.push_str(&format!(" {digits} | {off} |"));
            }
            text.push('\n');
        }
    }
    text
}

fn shown(ulps: f64) -> String {
    match ulps.is_finite() {
        true if ulps == 0.0 => "0".to_owned(),
        true => format!("{ulps:.1}"),
        false => "-".to_owned(),
    }
}
