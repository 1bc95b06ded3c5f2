//! Where the name of a piece stands: between two rulings, clear of what else is drawn on the sheet.
//!
//! A line of letters is a rectangle. Along the middle line of two neighbouring rulings the distances from both grow or
//! shrink evenly, so the rectangle is clear of them when its two ends are; other drawings are polygons, which are
//! clipped by the rectangle.

/// The width of a letter as a share of its height, about.
const WIDE: f64 = 0.66;
/// The height of a line with what reaches below it and a margin, as a share of that of its letters.
const HIGH: f64 = 1.5;
/// Heights that are tried, as shares of the one wished for.
const HEIGHTS: [f64; 7] = [1.0, 0.85, 0.7, 0.55, 0.45, 0.35, 0.25];
/// Steps in which a line is moved along its rulings.
const STEPS: u32 = 12;

/// A place for a line of letters: the start of its base line, its height, and the direction in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LetteringPlace {
    pub at: [f64; 2],
    pub height: f64,
    pub angle: f64,
}

/// The ends of a ruling.
pub type LineEnds = [[f64; 2]; 2];

/// A drawing that is to be kept clear: a polygon, closed or not.
pub type Drawn = Vec<[f64; 2]>;

/// Returns the box of a line of letters as a polygon, to keep other lines clear of it.
pub fn frame(line: &LetteringPlace, letters: usize) -> Drawn {
    let (sine, cosine) = libm::sincos(line.angle);
    let (width, height) = (width(letters, line.height), line.height);
    let corner = |x: f64, y: f64| {
        [
            line.at[0] + x * cosine - y * sine,
            line.at[1] + x * sine + y * cosine,
        ]
    };
    vec![
        corner(0.0, 0.0),
        corner(width, 0.0),
        corner(width, height),
        corner(0.0, height),
        corner(0.0, 0.0),
    ]
}

/// Returns the place for so many letters between two rulings: as large as wished if there is room, and near the middle
/// of the sheet; where there is no room at all, on the ruling behind the middle. `None` without rulings.
pub fn place(
    rulings: &[LineEnds],
    letters: usize,
    wished: f64,
    drawn: &[Drawn],
) -> Option<LetteringPlace> {
    let count = rulings.len();
    let from_middle = |gap: usize| (2 * gap + 2).abs_diff(count);
    let mut gaps: Vec<usize> = (0..count.checked_sub(1)?).collect();
    gaps.sort_by_key(|gap| from_middle(*gap));
    for height in HEIGHTS.map(|share| share * wished) {
        for pair in gaps.iter().filter_map(|gap| rulings.get(*gap..gap + 2)) {
            if let [a, b] = pair
                && let Some(line) = between(a, b, letters, height, drawn)
            {
                return Some(line);
            }
        }
    }
    let [from, to] = upright(*rulings.get(5 * count / 8)?);
    let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
    Some(LetteringPlace {
        at: along(&[from, to], 0.1),
        height: wished.min(0.8 * length / width(letters, 1.0)),
        angle: libm::atan2(to[1] - from[1], to[0] - from[0]),
    })
}

fn width(letters: usize, height: f64) -> f64 {
    f64::from(u32::try_from(letters).unwrap_or(u32::MAX)) * WIDE * height
}

fn along([from, to]: &LineEnds, share: f64) -> [f64; 2] {
    [0, 1].map(|i| from[i] + share * (to[i] - from[i]))
}

/// Returns the line in the direction in which letters are not upside down.
fn upright([from, to]: LineEnds) -> LineEnds {
    if to[0] < from[0] {
        [to, from]
    } else {
        [from, to]
    }
}

/// Returns the place of a line of this height on the middle line of two rulings, nearest to the middle of it.
fn between(
    a: &LineEnds,
    b: &LineEnds,
    letters: usize,
    height: f64,
    drawn: &[Drawn],
) -> Option<LetteringPlace> {
    let middle = [0, 1].map(|end| along(&[a[end], b[end]], 0.5));
    let middle = upright(middle);
    let way = [0, 1].map(|i| middle[1][i] - middle[0][i]);
    let length = libm::hypot(way[0], way[1]);
    let taken = width(letters, height) / length;
    // Also clear of the rails, which may lean.
    let margin = 0.5 * HIGH * height / length;
    let free = 1.0 - taken - 2.0 * margin;
    if free.is_nan() || free < 0.0 {
        return None;
    }
    let unit = way.map(|c| c / length);
    let room = |share: f64| {
        let point = along(&middle, share);
        distance(a, point).min(distance(b, point))
    };
    let mut starts: Vec<f64> = (0..=STEPS)
        .map(|k| f64::from(k) / f64::from(STEPS))
        .collect();
    starts.sort_by(|a, b| (a - 0.5).abs().total_cmp(&(b - 0.5).abs()));
    for start in starts.into_iter().map(|share| margin + share * free) {
        if room(start).min(room(start + taken)) < 0.5 * HIGH * height {
            continue;
        }
        let [x, y] = along(&middle, start);
        let (low, high) = (0.5 * HIGH * height, taken * length);
        let local = |p: &[f64; 2]| {
            let [dx, dy] = [p[0] - x, p[1] - y];
            [dx * unit[0] + dy * unit[1], dy * unit[0] - dx * unit[1]]
        };
        let hit = |polygon: &Drawn| {
            let points: Vec<[f64; 2]> = polygon.iter().map(local).collect();
            points
                .windows(2)
                .any(|side| matches!(side, [p, q] if meets(*p, *q, [0.0, -low], [high, low])))
        };
        if drawn.iter().any(hit) {
            continue;
        }
        return Some(LetteringPlace {
            at: [x + 0.5 * height * unit[1], y - 0.5 * height * unit[0]],
            height,
            angle: libm::atan2(way[1], way[0]),
        });
    }
    None
}

/// Returns the distance of a point from the line through two others.
fn distance([p, q]: &LineEnds, point: [f64; 2]) -> f64 {
    let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
    ((point[0] - p[0]) * dy - (point[1] - p[1]) * dx).abs() / libm::hypot(dx, dy)
}

/// Returns whether a segment meets a box (Liang and Barsky).
fn meets(p: [f64; 2], q: [f64; 2], low: [f64; 2], high: [f64; 2]) -> bool {
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for i in 0..2 {
        let way = q[i] - p[i];
        if way == 0.0 {
            if p[i] < low[i] || p[i] > high[i] {
                return false;
            }
            continue;
        }
        let (a, b) = ((low[i] - p[i]) / way, (high[i] - p[i]) / way);
        enters = enters.max(a.min(b));
        leaves = leaves.min(a.max(b));
    }
    enters <= leaves
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ruling(y: f64, low: f64, high: f64) -> LineEnds {
        [[low, y], [high, y]]
    }

    /// Returns the distance of the box of a line from a horizontal ruling.
    fn clear_of(line: &LetteringPlace, y: f64) -> f64 {
        let frame = frame(line, 5);
        let each = frame.iter().map(|corner| corner[1] - y);
        if each.clone().all(|d| d > 0.0) || each.clone().all(|d| d < 0.0) {
            each.map(f64::abs).fold(f64::INFINITY, f64::min)
        } else {
            0.0
        }
    }

    #[test]
    fn a_name_stands_between_two_rulings_near_the_middle() {
        let rulings: Vec<LineEnds> = (0..9)
            .map(|k| ruling(f64::from(k) * 10.0, 0.0, 100.0))
            .collect();
        let line = place(&rulings, 5, 5.0, &[]).unwrap();
        assert_eq!((line.height, line.angle), (5.0, 0.0));
        assert!(line.at[1] > 30.0 && line.at[1] < 50.0, "{line:?}");
        assert!(rulings.iter().all(|r| clear_of(&line, r[0][1]) > 1.0));
    }

    #[test]
    fn a_name_gets_smaller_where_rulings_are_near_and_avoids_marks() {
        let rulings: Vec<LineEnds> = (0..9)
            .map(|k| ruling(f64::from(k) * 2.0, 0.0, 100.0))
            .collect();
        let line = place(&rulings, 5, 5.0, &[]).unwrap();
        assert!(line.height < 2.0 && rulings.iter().all(|r| clear_of(&line, r[0][1]) > 0.1));
        // A mark right there.
        let mark = frame(&line, 5);
        let other = place(&rulings, 5, 5.0, std::slice::from_ref(&mark)).unwrap();
        let [low, high] = [0, 2].map(|k| mark[k]);
        for side in frame(&other, 5).windows(2) {
            assert!(!meets(side[0], side[1], low, high), "{other:?}");
        }
    }

    #[test]
    fn a_name_has_a_place_even_where_there_is_no_room() {
        let rulings = [ruling(0.0, 0.0, 1.0), ruling(1e-3, 0.0, 1.0)];
        let line = place(&rulings, 5, 5.0, &[]).unwrap();
        assert!(line.height > 0.0 && line.height < 0.5);
        assert_eq!(place(&[], 5, 5.0, &[]), None);
    }

    #[test]
    fn segments_meet_boxes_that_they_cross_without_ending_in_them() {
        let unit = ([0.0, 0.0], [1.0, 1.0]);
        for (p, q, expected) in [
            ([-1.0, 0.5], [2.0, 0.5], true),
            ([-1.0, 1.5], [2.0, 1.5], false),
            ([0.2, 0.2], [0.8, 0.8], true),
            ([-1.0, 0.9], [0.2, 2.2], false),
            ([0.5, -1.0], [0.5, 2.0], true),
            ([3.0, 0.5], [2.0, 0.5], false),
        ] {
            assert_eq!(meets(p, q, unit.0, unit.1), expected, "{p:?} {q:?}");
        }
    }
}
