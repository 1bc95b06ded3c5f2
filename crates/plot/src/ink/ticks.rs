//! Round tick positions and their labels.

/// Ticks of an axis: multiples of 1, 2 or 5 times a power of ten; of 4 times one where no other shows three of them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ticks {
    /// Positions, ascending, inside the range.
    pub at: Vec<f64>,
    /// Labels, one per position; they show the position divided by `10^exponent`.
    pub labels: Vec<String>,
    /// Common power of ten, 0 when the figures are handy without.
    pub exponent: i32,
}

impl Ticks {
    /// About `wanted` ticks (2 to 20) on `low..high`, which must be finite and not empty; `room` is how many labels find
    /// room at most. Axes with equal `(high - low) / wanted` get equal steps, unless that makes less than three ticks.
    pub(crate) fn new(low: f64, high: f64, wanted: f64, room: f64) -> Ticks {
        let wanted = wanted.clamp(2.0, 20.0);
        let largest = low.abs().max(high.abs());
        let order = libm::log10(largest).floor() as i32;
        let exponent = if (-2..=3).contains(&order) { 0 } else { order };
        // Work on numbers of moderate size: 10^-exponent itself may not be a finite f64.
        let unit = |x: f64| x / 10f64.powi(exponent / 2) / 10f64.powi(exponent - exponent / 2);
        let (a, b) = (unit(low), unit(high));
        let raw = (b - a) / wanted;
        let decade = libm::log10(raw).floor() as i32;
        let power = 10f64.powi(decade);
        // The roundest step near the raw one: at most a third more ticks than wanted, and one. Two ticks do not show a scale:
        // where there is room for three, the next finer step that makes as many is taken.
        let slack = 1e-9 * (b - a);
        let range = |step: f64| {
            let first = ((a - slack) / step).ceil();
            (first, ((b + slack) / step).floor() - first)
        };
        let steps = [10.0, 5.0, 2.0, 1.0];
        let near = steps.iter().rfind(|f| **f * power >= raw * 0.75);
        let near = *near.unwrap_or(&10.0);
        let ticks = |factor: f64| range(factor * power).1 + 1.0;
        let mut finer = [10.0, 5.0, 4.0, 2.0, 1.0, 0.5, 0.4, 0.2].into_iter();
        let shown = finer.find(|f| *f < near && ticks(*f) >= 3.0 && ticks(*f) <= room);
        let factor = match shown {
            Some(finer) if ticks(near) < 3.0 => finer,
            _ => near,
        };
        let shift = match factor {
            10.0 => 1,
            1.0.. => 0,
            _ => -1,
        };
        let decimals = (-decade - shift).clamp(0, 15) as usize;
        let step = factor * power;
        let (first, count) = range(step);
        let count = count.clamp(0.0, 40.0) as usize;
        let values: Vec<f64> = (0..=count).map(|k| (first + k as f64) * step).collect();
        let back = |x: f64| x * 10f64.powi(exponent / 2) * 10f64.powi(exponent - exponent / 2);
        Ticks {
            at: values.iter().map(|&x| back(x).clamp(low, high)).collect(),
            labels: values.iter().map(|&x| format_tick(x, decimals)).collect(),
            exponent,
        }
    }

    /// `label` with the common power of ten, if there is one.
    pub(crate) fn title(&self, label: &str) -> String {
        match (self.exponent, label.is_empty()) {
            (0, _) => label.to_owned(),
            (e, true) => format!("$\\times 10^{{{e}}}$"),
            (e, false) => format!("{label} $/\\,10^{{{e}}}$"),
        }
    }
}

fn format_tick(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    match text.strip_prefix('-') {
        Some(positive) if zero => positive.to_owned(),
        Some(positive) => format!("−{positive}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_unit_interval_is_cut_at_fifths() {
        let ticks = Ticks::new(0.0, 1.0, 5.0, 8.0);
        assert_eq!(ticks.labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(ticks.title("$t$"), "$t$");
    }

    #[test]
    fn tiny_numbers_share_a_power_of_ten() {
        let ticks = Ticks::new(0.0, 4e-17, 4.0, 8.0);
        assert_eq!(ticks.labels, ["0", "1", "2", "3", "4"]);
        assert_eq!(ticks.title("defect"), "defect $/\\,10^{-17}$");
    }

    #[test]
    fn where_there_is_room_for_three_ticks_there_are_three() {
        let labels = |low, high, wanted, room| Ticks::new(low, high, wanted, room).labels;
        assert_eq!(labels(-3.0, 7.0, 3.0, 5.0), ["−2", "0", "2", "4", "6"]);
        assert_eq!(labels(0.1, 14.9, 2.0, 4.0), ["4", "8", "12"]);
        assert_eq!(labels(0.0, 1.3, 1.4, 3.0), ["0.0", "0.5", "1.0"]);
        assert_eq!(
            labels(0.05, 0.14, 2.0, 5.0),
            ["0.06", "0.08", "0.10", "0.12", "0.14"]
        );
        assert_eq!(labels(-3.0, 7.0, 2.0, 2.0), ["0", "5"]);
    }

    #[test]
    fn zero_has_no_sign_and_minus_is_the_mathematical_one() {
        assert_eq!(Ticks::new(-1.0, 1.0, 2.0, 3.0).labels, ["−1", "0", "1"]);
    }

    proptest! {
        #[test]
        fn ticks_are_few_ascending_and_inside(low in -1e3..1e3f64, span in 1e-3..1e3f64, scale in -300..300i32, n in 2..12usize) {
            let s = 10f64.powi(scale);
            let (low, high) = (low * s, (low + span) * s);
            let room = (2 * n + 2) as f64;
            let ticks = Ticks::new(low, high, n as f64, room);
            prop_assert!(ticks.at.len() > 2, "{:?}", ticks);
            let most = ((4 * n + 4) / 3).max(2 * n + 2);
            prop_assert!(ticks.at.len() <= most, "{:?}", ticks);
            prop_assert!(ticks.at.iter().all(|x| (low..=high).contains(x)));
            prop_assert!(ticks.at.windows(2).all(|w| w[0] < w[1]), "{:?}", ticks);
            prop_assert!(ticks.labels.windows(2).all(|w| w[0] != w[1]), "{:?}", ticks);
        }
    }
}
