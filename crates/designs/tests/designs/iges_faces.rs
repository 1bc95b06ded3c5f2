//! Faces of IGES files written entity by entity: seams that are written twice, surfaces with borders of their own. Areas are
//! compared with closed formulas.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use torse_designs::load;
use torse_designs::unroll::{Demand, Part, parts, unroll};

/// A file while it is written; what other entities point to belongs to them.
#[derive(Default)]
struct IgesText {
    entities: Vec<(u32, u32, String)>,
}

impl IgesText {
    /// Adds an entity by its kind and form; gives the number of its entry.
    fn add(&mut self, kind: u32, form: u32, parameters: &str) -> usize {
        self.entities.push((kind, form, parameters.to_owned()));
        2 * self.entities.len() - 1
    }

    fn line(&mut self, [a, b, c]: [f64; 3], [p, q, r]: [f64; 3]) -> usize {
        self.add(110, 0, &format!("{a:?},{b:?},{c:?},{p:?},{q:?},{r:?}"))
    }

    /// Arcs about the third axis with radius 20, of a third of a turn at most.
    fn arcs(&mut self, z: f64, from: f64, to: f64) -> Vec<usize> {
        let count = ((to - from).abs() / (TAU / 3.0)).ceil();
        let step = (to - from) / count;
        let mut all = Vec::new();
        let mut start = from;
        while all.len() < count as usize {
            let weight = libm::cos(0.5 * step);
            let point = |angle: f64, radius: f64| {
                format!(
                    "{:?},{:?},{z:?}",
                    radius * libm::cos(angle),
                    radius * libm::sin(angle)
                )
            };
            let points = [
                point(start, 20.0),
                point(start + 0.5 * step, 20.0 / weight),
                point(start + step, 20.0),
            ];
            all.push(self.add(
                126,
                0,
                &format!(
                    "2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,{weight:?},1.,{},0.,1.,0.,0.,0.",
                    points.join(",")
                ),
            ));
            start += step;
        }
        all
    }

    fn finish(self) -> String {
        let last = self.entities.len();
        let mut text = format!("{:<72}S{:>7}\n", "", 1);
        let global = "1H,,1H;,4Htest,4Htest,4Htest,4Htest,32,38,6,308,15,4Htest,1.,2,2HMM,1,0.01,4Htest,1E-6,100.,,,11,0,4Htest;";
        for (k, part) in global.as_bytes().chunks(72).enumerate() {
            writeln!(text, "{:<72}G{:>7}", String::from_utf8_lossy(part), k + 1).unwrap();
        }
        let (mut parameters, mut lines) = (String::new(), 0);
        for (index, (kind, form, values)) in self.entities.iter().enumerate() {
            let (entry, first) = (2 * index + 1, lines + 1);
            let mut rest = format!("{kind},{values};");
            while !rest.is_empty() {
                let whole = rest.len() <= 64;
                let end = if whole {
                    rest.len()
                } else {
                    rest[..64].rfind(',').unwrap() + 1
                };
                lines += 1;
                writeln!(parameters, "{:<64}{entry:>8}P{lines:>7}", &rest[..end]).unwrap();
                rest.drain(..end);
            }
            let status = if index + 1 == last {
                "00000000"
            } else {
                "00010000"
            };
            writeln!(
                text,
                "{kind:>8}{first:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{status}D{entry:>7}",
                0
            )
            .unwrap();
            let count = lines + 1 - first;
            writeln!(
                text,
                "{kind:>8}{0:>8}{0:>8}{count:>8}{form:>8}{1:>24}{0:>8}D{2:>7}",
                0,
                "",
                entry + 1
            )
            .unwrap();
        }
        text += &parameters;
        text + &format!("{:<72}T{:>7}\n", "S      1G      2D      2P      1", 1)
    }

    fn part(self) -> Part {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("face.igs");
        std::fs::write(&path, self.finish()).unwrap();
        let design = load(&path).unwrap();
        assert!(design.left_out.is_empty(), "{:?}", design.left_out);
        let pieces = unroll(&design, &Demand::default()).unwrap();
        let mut made = parts(&design, &pieces).unwrap();
        assert_eq!(made.len(), 1);
        made.remove(0)
    }
}

fn check(part: &Part, area: f64) {
    let room = part.error * part.cut_length();
    assert!(
        part.error <= 0.01 && (part.area() - area).abs() <= room,
        "{} {area}",
        part.area()
    );
}

/// A pipe of radius 20 and length 50 with a window from -0.3 to 0.3 radians and from z = 15 to 30; the seam is at 0, ends at
/// the window and goes on behind it, and all curves are one loop.
#[test]
fn an_opening_over_a_seam_that_is_written_twice_is_whole() {
    let mut text = IgesText::default();
    let at = |angle: f64, z: f64| [20.0 * libm::cos(angle), 20.0 * libm::sin(angle), z];
    let axis = text.line([0.0; 3], [0.0, 0.0, 1.0]);
    let side = text.line(at(0.0, 0.0), at(0.0, 50.0));
    let surface = text.add(120, 0, &format!("{axis},{side},0.,{TAU:?}"));
    let mut edges = text.arcs(0.0, 0.0, TAU);
    edges.push(text.line(at(0.0, 0.0), at(0.0, 15.0)));
    edges.extend(text.arcs(15.0, 0.0, -0.3));
    edges.push(text.line(at(-0.3, 15.0), at(-0.3, 30.0)));
    edges.extend(text.arcs(30.0, -0.3, 0.0));
    edges.push(text.line(at(0.0, 30.0), at(0.0, 50.0)));
    edges.extend(text.arcs(50.0, TAU, 0.0));
    edges.push(text.line(at(0.0, 50.0), at(0.0, 30.0)));
    edges.extend(text.arcs(30.0, 0.0, 0.3));
    edges.push(text.line(at(0.3, 30.0), at(0.3, 15.0)));
    edges.extend(text.arcs(15.0, 0.3, 0.0));
    edges.push(text.line(at(0.0, 15.0), at(0.0, 0.0)));
    let list: Vec<String> = edges.iter().map(usize::to_string).collect();
    let curve = text.add(102, 0, &format!("{},{}", edges.len(), list.join(",")));
    let on = text.add(142, 0, &format!("0,{surface},0,{curve},2"));
    text.add(144, 0, &format!("{surface},1,0,{on}"));
    let part = text.part();
    assert_eq!(part.openings.len(), 1);
    let window = part.openings[0].shape.area();
    assert!((window - 180.0).abs() < 0.01 * 54.0, "{window}");
    check(&part, 2000.0 * PI - 180.0);
}

#[test]
fn a_line_that_turns_between_two_angles_has_borders_of_its_own() {
    let turned = |from: [f64; 3], to: [f64; 3], angles: [f64; 2]| {
        let mut text = IgesText::default();
        let axis = text.line([0.0; 3], [0.0, 0.0, 2.0]);
        let side = text.line(from, to);
        text.add(
            120,
            0,
            &format!("{axis},{side},{:?},{:?}", angles[0], angles[1]),
        );
        text.part()
    };
    // A third of the frustum of radii 40 and 16 with the slant height 30.
    let part = turned([40.0, 0.0, 0.0], [16.0, 0.0, 18.0], [0.5, 0.5 + TAU / 3.0]);
    check(&part, PI * 56.0 * 30.0 / 3.0);
    // The whole of it, a whole cone, a part of a pipe, a part of a ring, a ring.
    check(
        &turned([40.0, 0.0, 0.0], [16.0, 0.0, 18.0], [0.0, TAU]),
        PI * 56.0 * 30.0,
    );
    check(
        &turned([0.0, 12.0, 0.0], [0.0, 0.0, 16.0], [0.0, TAU]),
        PI * 12.0 * 20.0,
    );
    check(
        &turned([20.0, 0.0, 1.0], [20.0, 0.0, 31.0], [-1.0, 1.5]),
        20.0 * 30.0 * 2.5,
    );
    check(
        &turned([20.0, 0.0, 5.0], [30.0, 0.0, 5.0], [1.0, 3.0]),
        500.0,
    );
    check(
        &turned([20.0, 0.0, 5.0], [30.0, 0.0, 5.0], [0.0, TAU]),
        PI * 500.0,
    );
}

#[test]
fn a_plane_with_a_curve_of_its_own_is_bounded_by_it() {
    let mut text = IgesText::default();
    let corners = [
        [0.0, 0.0, 4.0],
        [70.0, 0.0, 4.0],
        [70.0, 30.0, 4.0],
        [10.0, 30.0, 4.0],
    ];
    let sides = [0, 1, 2, 3].map(|k| text.line(corners[k], corners[(k + 1) % 4]).to_string());
    let curve = text.add(102, 0, &format!("4,{}", sides.join(",")));
    text.add(108, 1, &format!("0.,0.,1.,4.,{curve},0.,0.,0.,0."));
    check(&text.part(), 0.5 * (70.0 + 60.0) * 30.0);
}
