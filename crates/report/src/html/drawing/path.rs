//! Path data for a screen: rounded to tenths of a pixel, without points whose absence is invisible.

/// Steps of a pixel.
const GRID: f64 = 10.0;
/// Maximum distance, in pixels, of a polyline from a point that it leaves out.
const TOLERANCE: f64 = 0.04;

type Point = [f64; 2];

/// A part of a path from where the pen stands: a letter and absolute points.
struct Segment {
    letter: char,
    points: Vec<Point>,
}

/// Writes the path with relative coordinates in tenths, beginning with an absolute one so that paths can be joined;
/// none if it contains anything but the relative letters m, l, q, c and z.
pub(super) fn rounded(data: &str) -> Option<String> {
    Some(written(&thinned(parsed(data)?)))
}

fn parsed(data: &str) -> Option<Vec<Segment>> {
    let mut segments = Vec::new();
    let (mut pen, mut start) = ([0.0; 2], [0.0; 2]);
    let mut rest = data.trim_start();
    let mut letter = ' ';
    while let Some(next) = rest.chars().next() {
        if next.is_ascii_alphabetic() {
            letter = next;
            rest = &rest[1..];
        }
        let count = match letter {
            'z' => 0,
            'm' | 'l' => 1,
            'q' => 2,
            'c' => 3,
            _ => return None,
        };
        let mut points = Vec::with_capacity(count);
        for _ in 0..count {
            let (x, y);
            (x, rest) = number(rest)?;
            (y, rest) = number(rest)?;
            points.push([pen[0] + x, pen[1] + y]);
        }
        pen = points.last().copied().unwrap_or(start);
        if letter == 'm' {
            start = pen;
        }
        segments.push(Segment { letter, points });
        rest = rest.trim_start();
        // A second pair after `m` would mean `l`, and nothing follows `z` but a letter.
        if matches!(letter, 'm' | 'z') {
            letter = ' ';
        }
    }
    Some(segments)
}

/// Returns the number that a text begins with, and the rest.
fn number(text: &str) -> Option<(f64, &str)> {
    let text = text.trim_start_matches([' ', ',']);
    let end = text
        .char_indices()
        .find(|(at, c)| !(c.is_ascii_digit() || *c == '.' || (*c == '-' && *at == 0)))
        .map_or(text.len(), |(at, _)| at);
    let (number, rest) = text.split_at(end);
    Some((number.parse().ok()?, rest))
}

/// Removes points close to the line between their neighbours (Douglas and Peucker 1973).
fn thinned(segments: Vec<Segment>) -> Vec<Segment> {
    let mut thin: Vec<Segment> = Vec::with_capacity(segments.len());
    let mut run: Vec<Point> = Vec::new();
    for segment in segments {
        if segment.letter == 'l' {
            if run.is_empty() {
                run.extend(thin.last().and_then(|before| before.points.last()));
            }
            run.extend(segment.points);
            continue;
        }
        thin.extend(lines(&std::mem::take(&mut run)));
        thin.push(segment);
    }
    thin.extend(lines(&run));
    thin
}

fn lines(run: &[Point]) -> impl Iterator<Item = Segment> {
    let mut kept = vec![false; run.len()];
    keep(run, 0, run.len().saturating_sub(1), &mut kept);
    let points: Vec<Point> = run
        .iter()
        .zip(&kept)
        .skip(1)
        .filter_map(|(point, kept)| kept.then_some(*point))
        .collect();
    points.into_iter().map(|point| Segment {
        letter: 'l',
        points: vec![point],
    })
}

fn keep(run: &[Point], first: usize, last: usize, kept: &mut [bool]) {
    let mut open = vec![(first, last)];
    while let Some((first, last)) = open.pop() {
        let (Some(&a), Some(&b)) = (run.get(first), run.get(last)) else {
            return;
        };
        for end in [first, last] {
            if let Some(kept) = kept.get_mut(end) {
                *kept = true;
            }
        }
        let inner = run.iter().enumerate().take(last).skip(first + 1);
        let away = inner.map(|(at, p)| (distance(*p, a, b), at));
        let worst = away.fold((TOLERANCE, None), |(most, found), (away, at)| {
            if away > most {
                (away, Some(at))
            } else {
                (most, found)
            }
        });
        if let (_, Some(at)) = worst {
            open.extend([(first, at), (at, last)]);
        }
    }
}

/// The distance of a point from a segment.
fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let share = if square > 0.0 {
        ((along[0] * from[0] + along[1] * from[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    libm::hypot(from[0] - share * along[0], from[1] - share * along[1])
}

fn written(segments: &[Segment]) -> String {
    let snap = |p: &Point| p.map(|c| (c * GRID).round() as i64);
    let (mut out, mut last) = (String::new(), ' ');
    let (mut pen, mut start) = ([0, 0], [0, 0]);
    for Segment { letter, points } in segments {
        let from = if *letter == 'm' { [0, 0] } else { pen };
        let steps: Vec<[i64; 2]> = points
            .iter()
            .map(|p| {
                let to = snap(p);
                [to[0] - from[0], to[1] - from[1]]
            })
            .collect();
        if *letter == 'l' && steps.iter().all(|step| *step == [0, 0]) {
            continue;
        }
        let letter = if *letter == 'm' { 'M' } else { *letter };
        if letter != last || letter == 'M' {
            out.push(letter);
        } else if steps.iter().flatten().next().is_none_or(|c| *c >= 0) {
            out.push(' ');
        }
        last = letter;
        for (k, c) in steps.iter().flatten().enumerate() {
            if k > 0 && *c >= 0 {
                out.push(' ');
            }
            out.push_str(&tenths(*c));
        }
        pen = points.last().map_or(start, snap);
        if letter == 'M' {
            start = pen;
        }
    }
    out
}

/// Writes a number of tenths, without needless zeros.
pub(super) fn tenths(value: i64) -> String {
    let sign = if value < 0 { "-" } else { "" };
    let (whole, part) = (value.unsigned_abs() / 10, value.unsigned_abs() % 10);
    match (whole, part) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, part) => format!("{sign}.{part}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_rounded_where_they_end_so_that_no_error_adds_up() {
        let steps = " 0.04 0.2".repeat(10);
        let path = rounded(&format!("m0 0l{}", steps.trim_start())).unwrap();
        // Ten steps on one line, to (0.4, 2).
        assert_eq!(path, "M0 0l.4 2");
    }

    #[test]
    fn a_bend_stays_and_a_closed_contour_returns() {
        assert_eq!(
            rounded("m80.43 200.14l127.08 -64 0 -124.14 -127.08 64zm1 1l2 0").unwrap(),
            "M80.4 200.1l127.1-64 0-124.1-127.1 64zM81.4 201.1l2 0"
        );
        assert_eq!(
            rounded("m1 2c0.1 0.2 0.3 0.4 0.5 0.6").unwrap(),
            "M1 2c.1.2.3.4.5.6".replace("c.1.2.3.4.5.6", "c.1 .2 .3 .4 .5 .6")
        );
    }

    #[test]
    fn a_curve_of_many_points_keeps_those_that_it_needs() {
        let mut data = "m0 0l".to_owned();
        let (mut x, mut y) = (0.0_f64, 0.0_f64);
        for k in 1..=400 {
            let turn = f64::from(k) / 400.0 * std::f64::consts::PI;
            let (to_x, to_y) = (100.0 * (1.0 - libm::cos(turn)), 100.0 * libm::sin(turn));
            data.push_str(&format!(" {:.2} {:.2}", to_x - x, to_y - y));
            (x, y) = (to_x, to_y);
        }
        let path = rounded(&data.replacen("l ", "l", 1)).unwrap();
        assert!(
            path.len() < data.len() / 5,
            "{} of {}",
            path.len(),
            data.len()
        );
    }

    #[test]
    fn other_letters_and_words_are_refused() {
        for data in [
            "M0 0",
            "m0",
            "m0 0a1 1 0 0 0 2 2",
            "m0 0 1 1",
            "m0 x",
            "m0 0\"/>",
        ] {
            assert!(rounded(data).is_none(), "{data}");
        }
    }
}
