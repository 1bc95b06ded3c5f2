//! What two lines of a drawing do to each other: lie on each other, meet, come close.

use crate::polygon::distance;
use crate::segment_crossings::carrier_crossings;
use torse_geometry::pattern::Segment;

/// The most pairs that are looked at.
const MAX_PAIRS: usize = 50_000_000;
/// Lines that stand for an arc: its chords are no farther from it than a share of about 1/1000 of its radius.
const ARC_CHORDS: u32 = 64;

/// A line of a contour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// How far it is at most from the arc it stands for.
    pub off: f64,
    /// The contour, and the number of the chord there.
    pub contour: usize,
    pub number: usize,
}

/// The chords of a contour.
pub(super) fn chords(contour: usize, segments: &[Segment], all: &mut Vec<Chord>) {
    let start = all.len();
    for segment in segments {
        let steps = if segment.is_line() { 1 } else { ARC_CHORDS };
        let part = segment.part(0.0, 1.0 / f64::from(steps));
        let mut from = segment.from;
        for k in 1..=steps {
            let to = segment.point(f64::from(k) / f64::from(steps));
            all.push(Chord {
                from,
                to,
                off: part.sagitta() * (1.0 + 1e-9),
                contour,
                number: all.len() - start,
            });
            from = to;
        }
    }
}

impl Chord {
    fn low(&self, axis: usize) -> f64 {
        self.from[axis].min(self.to[axis])
    }

    fn high(&self, axis: usize) -> f64 {
        self.from[axis].max(self.to[axis])
    }

    /// Returns the distance from another that it does not cross, and the point where it is.
    pub(super) fn gap(&self, other: &Self) -> (f64, [f64; 2]) {
        let (own, others) = (self.line(), other.line());
        let ends = [
            (others.distance(self.from), self.from),
            (others.distance(self.to), self.to),
            (own.distance(other.from), other.from),
            (own.distance(other.to), other.to),
        ];
        ends.into_iter()
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap_or((f64::INFINITY, self.from))
    }

    fn line(&self) -> Segment {
        Segment::line(self.from, self.to)
    }
}

/// Calls for each pair of chords whose boxes are no farther apart than `reach`; false where there were too many to look
/// at all of them.
pub(super) fn for_pairs(
    chords: &[Chord],
    reach: f64,
    mut look: impl FnMut(&Chord, &Chord),
) -> bool {
    let mut order: Vec<usize> = (0..chords.len()).collect();
    let low = |index: &usize| chords.get(*index).map_or(0.0, |chord| chord.low(0));
    order.sort_by(|a, b| low(a).total_cmp(&low(b)).then(a.cmp(b)));
    let mut looked = 0;
    for (place, index) in order.iter().enumerate() {
        let Some(first) = chords.get(*index) else {
            continue;
        };
        for other in order.iter().skip(place + 1) {
            let Some(second) = chords.get(*other) else {
                continue;
            };
            if second.low(0) > first.high(0) + reach {
                break;
            }
            looked += 1;
            if looked > MAX_PAIRS {
                return false;
            }
            if second.low(1) > first.high(1) + reach || first.low(1) > second.high(1) + reach {
                continue;
            }
            look(first, second);
        }
    }
    true
}

/// Points of an arc that are looked at.
const SAMPLES: u32 = 64;

/// Returns how long two lines or arcs lie on each other within a distance, and a point of it; nothing where they only
/// touch.
pub(super) fn shared(a: &Segment, b: &Segment, within: f64) -> Option<(f64, [f64; 2])> {
    // What one shares with the other is seen from the shorter.
    let (short, long) = if a.length() <= b.length() {
        (a, b)
    } else {
        (b, a)
    };
    let (from, to) = if short.is_line() && long.is_line() {
        along_line(short, long, within)?
    } else {
        longest_run(|share| long.distance(short.point(share)) <= within)?
    };
    let length = (to - from) * short.length();
    // Lines that leave one point in nearly one direction are close to each other there, and are two lines.
    let meets = |share: f64| {
        let point = short.point(share);
        [long.from, long.to]
            .iter()
            .any(|end| distance(*end, point) <= within)
    };
    let tip = (from <= 0.0 && meets(0.0)) || (to >= 1.0 && meets(1.0));
    let enough = !tip || to - from >= 0.5;
    (enough && length > 4.0 * within).then(|| (length, short.point(0.5 * (from + to))))
}

/// Returns the points, two at most, in which lines and arcs meet that do not lie on each other.
pub(super) fn meetings(a: &Segment, b: &Segment) -> Vec<[f64; 2]> {
    let candidates = carrier_crossings(a, b, 0.0, f64::INFINITY);
    let size = a.length().max(b.length()) + libm::hypot(a.from[0], a.from[1]);
    let rounding = 1e-11 * size;
    let on_both =
        |point: &[f64; 2]| a.distance(*point) <= rounding && b.distance(*point) <= rounding;
    candidates.into_iter().filter(on_both).collect()
}

/// Returns the shares of a line between which it runs along a longer one.
fn along_line(short: &Segment, long: &Segment, within: f64) -> Option<(f64, f64)> {
    let [x, y] = [0, 1].map(|i| long.to[i] - long.from[i]);
    let length = libm::hypot(x, y);
    let place = |p: [f64; 2]| {
        let [dx, dy] = [p[0] - long.from[0], p[1] - long.from[1]];
        [(dx * x + dy * y) / length, (dy * x - dx * y) / length]
    };
    let ([s, s_off], [t, t_off]) = (place(short.from), place(short.to));
    if s == t {
        return None;
    }
    // The shares at which it passes the ends of the other.
    let share = |end: f64| ((end - s) / (t - s)).clamp(0.0, 1.0);
    let (mut from, mut to) = (share(0.0), share(length));
    if from > to {
        (from, to) = (to, from);
    }
    let off = |share: f64| (s_off + share * (t_off - s_off)).abs();
    (off(from) <= within && off(to) <= within).then_some((from, to))
}

/// Returns the longest run of equally spaced shares at which something holds.
fn longest_run(holds: impl Fn(f64) -> bool) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64)> = None;
    let mut run: Option<(f64, f64)> = None;
    for k in 0..=SAMPLES {
        let share = f64::from(k) / f64::from(SAMPLES);
        run = holds(share).then(|| (run.map_or(share, |(from, _)| from), share));
        if let Some((from, to)) = run
            && best.is_none_or(|(low, high)| to - from > high - low)
        {
            best = Some((from, to));
        }
    }
    best
}
