//! Developables between free curves: drawn either way, one of several, closed.

use torse_designs::inspect::inspect;
use torse_designs::unroll::{Demand, unroll};
use torse_designs::{Design, read};

fn design(text: &str) -> Design {
    read("x.toml", text).unwrap_or_else(|e| panic!("{e:?}"))
}

/// Two loops in planes that lean, of a quarter turn each side in one curve of degree six.
const REDUCER: &str = r#"
[curves]
a = { bezier = [[80, 0, 0], [80, 274.28571428571428, 0], [-93.341692789968619, 98.708463949843249, 0], [-110.98319134239007, 0, 0], [-93.341692789968619, -98.708463949843249, 0], [80, -274.28571428571428, 0], [80, 0, 0]], weights = [1, 0.34999999999999992, 0.7975000000000001, 1.0857499999999998, 0.7975000000000001, 0.34999999999999992, 1] }
b = { bezier = [[70, 12, 105], [70, 183.42857142857142, 139.28571428571428], [-38.33855799373039, 73.692789968652022, 84.836990595611283], [-49.364494588993793, 12, 69.190651623301861], [-38.33855799373039, -49.692789968652029, 60.159874608150474], [70, -159.42857142857142, 70.714285714285722], [70, 12, 105]], weights = [1, 0.34999999999999992, 0.7975000000000001, 1.0857499999999998, 0.7975000000000001, 0.34999999999999992, 1] }
[patches.reducer]
connect = ["a", "b"]
"#;

/// The sum of the areas of all patches.
fn area(report: &torse_designs::inspect::DesignReport) -> f64 {
    report.patches.iter().filter_map(|patch| patch.area).sum()
}

#[test]
fn a_tube_between_two_closed_curves_closes_and_is_cut() {
    let design = design(REDUCER);
    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    // By an independent solution of 1500 rulings.
    assert!((area(&report) - 39_018.3).abs() < 0.1, "{}", area(&report));
    assert_eq!(report.joints.len(), report.patches.len());
    let pieces = unroll(&design, &Demand::default()).unwrap();
    assert_eq!(pieces.len(), 1);
    assert!((pieces[0].flat.area() - area(&report)).abs() < 1e-3);
}

#[test]
fn one_developable_of_a_tube_is_told_not_to_close() {
    let report = inspect(&design(&format!("{REDUCER}branch = 1\n"))).unwrap();
    assert!(
        report
            .missed
            .iter()
            .any(|reason| reason.contains("does not close")),
        "{:?}",
        report.missed
    );
}

#[test]
fn a_plate_goes_on_with_fans_where_that_is_asked() {
    let plate = |more: &str| {
        format!(
            "[curves]
             lower = {{ bezier = [[0, 0, 0], [800, -250, 60], [1900, -320, 90], [3000, -150, 40]] }}
             upper = {{ bezier = [[0, 120, 620], [900, -280, 560], [2000, -420, 590], [3000, -260, 700]] }}
             [patches.plate]
             connect = [\"lower\", \"upper\"]
             {more}
             [sheet]
             thickness = 4
             least-radius = 20"
        )
    };
    let report = inspect(&design(&plate("panel = 1"))).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    assert_eq!(report.patches.len(), 3);
    assert!(
        (area(&report) - 1_748_165.0).abs() < 1.0,
        "{}",
        area(&report)
    );
    for joint in &report.joints {
        assert!(joint.kink < 1e-6 && joint.geometric >= Some(1), "{joint:?}");
    }
    // The parameters can be typed back.
    assert!(
        report.patches[0]
            .notes
            .iter()
            .any(|note| note.contains("from 0 to 0.161535915")),
        "{:?}",
        report.patches[0].notes
    );
    let pieces = unroll(&design(&plate("panel = 1")), &Demand::default()).unwrap();
    assert!((pieces[0].flat.area() - 1_748_165.0).abs() < 1.0);
    // Without being asked it is the part that touches both curves, and the note says how to go on.
    let part = inspect(&design(&plate(""))).unwrap();
    assert_eq!(part.patches.len(), 1);
    assert!(
        part.patches[0]
            .notes
            .iter()
            .any(|note| note.contains("`panel = 1`"))
    );
    assert!(read("x.toml", &plate("panel = 99")).is_err());
    assert!(read("x.toml", &plate("panel = 1\nbranch = 1")).is_err());
}

#[test]
fn curves_of_several_pieces_have_one_panel() {
    let text = r#"
[curves]
chine = { through = [[0, 0, 0], [400, 180, -40], [900, 260, -30], [1500, 200, 20]] }
sheer = { through = [[0, 40, 300], [400, 260, 260], [900, 330, 250], [1500, 260, 280]] }
[patches.side]
connect = ["chine", "sheer"]
"#;
    let report = inspect(&design(text)).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    for joint in &report.joints {
        assert!(joint.kink < 1e-4 && joint.gap < 1e-6, "{joint:?}");
    }
    assert!(unroll(&design(text), &Demand::default()).is_ok());
}

#[test]
fn a_curve_that_is_drawn_from_its_other_end_is_connected_all_the_same() {
    let text = r#"
[curves]
a = { bezier = [[0, 0, 0], [100, 80, 0], [250, 90, 0], [400, 0, 0]] }
b = { bezier = [[400, 0, 60], [250, 90, 60], [100, 80, 60], [0, 0, 60]] }
[patches.p]
connect = ["a", "b"]
"#;
    let report = inspect(&design(text)).unwrap();
    let patch = &report.patches[0];
    assert!(
        (patch.area.unwrap() - 25_590.93).abs() < 0.1,
        "{:?}",
        patch.area
    );
    assert!(
        patch.notes[0].starts_with("curve 2 runs against curve 1"),
        "{:?}",
        patch.notes
    );
}

#[test]
fn curves_in_the_form_of_an_s_have_one_developable_however_they_are_drawn() {
    let a = [
        "[0, 0, 0]",
        "[150, 120, 0]",
        "[300, -120, 0]",
        "[450, 0, 0]",
    ];
    let b = [
        "[0, 20, 80]",
        "[160, 150, 90]",
        "[310, -70, 85]",
        "[450, 60, 80]",
    ];
    let drawn = |points: [&str; 4], back: bool| {
        let mut points = points.to_vec();
        if back {
            points.reverse();
        }
        points.join(", ")
    };
    for [first, second] in [[false, false], [false, true], [true, false], [true, true]] {
        let text = format!(
            "[curves]\na = {{ bezier = [{}] }}\nb = {{ bezier = [{}] }}\n[patches.p]\nconnect = [\"a\", \"b\"]\n",
            drawn(a, first),
            drawn(b, second)
        );
        let report = inspect(&design(&text)).unwrap();
        assert!(
            report.missed.is_empty(),
            "{first} {second}: {:?}",
            report.missed
        );
        let patch = &report.patches[0];
        let area = patch.area.unwrap();
        assert!((area - 18_165.0).abs() < 1.0, "{first} {second}: {area}");
        let turned = "curve 2 runs against curve 1: it is passed from its end to its start; the developable the other way is \
                      not regular";
        let told = patch.notes.iter().any(|note| note == turned);
        assert_eq!(told, first != second, "{:?}", patch.notes);
        // The developables of the other direction can be asked for, behind those of this one.
        let count = patch.notes.iter().find_map(|note| {
            let (count, _) = note.strip_prefix("of ")?.split_once(' ')?;
            count.parse::<usize>().ok()
        });
        let beyond = count.unwrap() + 1;
        let other = inspect(&design(&format!("{text}branch = {beyond}\n"))).unwrap();
        assert!(!other.missed.is_empty());
        assert!(
            other.patches[0].notes[0].contains("the other way round"),
            "{:?}",
            other.patches[0].notes
        );
    }
}

#[test]
fn each_of_several_developables_can_be_taken() {
    let flare = |branch: &str| {
        format!(
            "[curves]
             a = {{ bezier = [[0, 0, 0], [150, 120, 0], [300, -120, 0], [450, 0, 0]] }}
             b = {{ bezier = [[0, 20, 80], [160, 150, 90], [310, -70, 85], [450, 60, 80]] }}
             [patches.p]
             connect = [\"a\", \"b\"]
             {branch}"
        )
    };
    let areas: Vec<f64> = ["branch = 1", "branch = 2"]
        .map(|branch| {
            inspect(&design(&flare(branch))).unwrap().patches[0]
                .area
                .unwrap()
        })
        .to_vec();
    assert!((areas[0] - areas[1]).abs() > 1.0, "{areas:?}");
    let best = inspect(&design(&flare(""))).unwrap().patches[0]
        .area
        .unwrap();
    assert!(areas.contains(&best), "{best} {areas:?}");
    assert!(read("x.toml", &flare("branch = 99")).is_err());
}

/// A side of a hull between two natural splines, each by its three Bezier pieces.
const SIDE: &str = r#"
[curves]
chine0 = { bezier = [[0.0, 0.0, 0.0], [130.493663451, 66.986147229, -16.832473222], [260.987326903, 133.972294458, -33.664946444], [400.0, 180.0, -40.0]] }
chine1 = { bezier = [[400.0, 180.0, -40.0], [559.844322166, 232.925155882, -47.284388675], [730.952180281, 258.13979479, -40.689457017], [900.0, 260.0, -30.0]] }
chine2 = { bezier = [[900.0, 260.0, -30.0], [1101.960182084, 262.22237343, -17.229384625], [1300.980091042, 231.111186715, 1.385307688], [1500.0, 200.0, 20.0]] }
sheer0 = { bezier = [[0.0, 40.0, 300.0], [128.81839226, 124.291330546, 284.669197074], [257.63678452, 208.582661091, 269.338394149], [400.0, 260.0, 260.0]] }
sheer1 = { bezier = [[400.0, 260.0, 260.0], [556.876622831, 316.659147911, 249.709590839], [730.200531002, 333.399877406, 246.69567805], [900.0, 330.0, 250.0]] }
sheer2 = { bezier = [[900.0, 330.0, 250.0], [1103.370561697, 325.927932038, 253.957620215], [1301.685280849, 292.963966019, 266.978810108], [1500.0, 260.0, 280.0]] }
"#;

#[test]
fn a_side_between_two_rows_of_pieces_is_one_whole_panel() {
    let side = design(&format!(
        "{SIDE}
         chine = {{ row = [\"chine0\", \"chine1\", \"chine2\"] }}
         sheer = {{ row = [\"sheer0\", \"sheer1\", \"sheer2\"] }}
         [patches.side]
         connect = [\"chine\", \"sheer\"]"
    ));
    let report = inspect(&side).unwrap();
    assert!(report.missed.is_empty(), "{:?}", report.missed);
    for joint in &report.joints {
        assert!(joint.kink < 1e-6 && joint.geometric >= Some(1), "{joint:?}");
    }
    for patch in &report.patches {
        assert!(
            patch.developable.holds() && patch.regular.holds(),
            "{patch:?}"
        );
    }
    assert_eq!(unroll(&side, &Demand::default()).unwrap().len(), 1);
}

#[test]
fn developables_of_pieces_that_do_not_meet_point_to_whole_panels() {
    let one_by_one = format!(
        "{SIDE}[patches]
         p0 = {{ connect = [\"chine0\", \"sheer0\"] }}
         p1 = {{ connect = [\"chine1\", \"sheer1\"] }}
         [chains.side]
         patches = [\"p0\", \"p1\"]"
    );
    let report = inspect(&design(&one_by_one)).unwrap();
    assert!(
        report.missed.iter().any(|reason| reason.contains("`row =")),
        "{:?}",
        report.missed
    );
}

#[test]
fn a_rectangle_and_a_round_pipe_end_with_an_answer() {
    let text = r#"
[curves]
rect = { polyline = [[0, -100, 0], [150, -100, 0], [150, 100, 0], [-150, 100, 0], [-150, -100, 0], [0, -100, 0]] }
pipe = { arc = { centre = [40, 0, 250], from = [40, -90, 250], axis = [0, 0, 1], angle = 360 } }
[patches]
duct = { connect = ["rect", "pipe"] }
"#;
    match read("duct.toml", text) {
        // Four triangles and four cones, as a sheet-metal worker would draw it.
        Ok(duct) => assert!(inspect(&duct).unwrap().missed.is_empty()),
        Err(torse_designs::DesignError::Wrong { mistakes }) => {
            let [mistake] = mistakes.as_slice() else {
                panic!("{mistakes:?}")
            };
            let help = miette::Diagnostic::help(mistake).unwrap().to_string();
            assert!(help.contains("connect piece by piece"), "{help}");
            assert!(help.matches("with curve 2 from").count() <= 2, "{help}");
        }
        Err(other) => panic!("{other:?}"),
    }
}

/// The joints of a design that are folds, and how many patches it has.
fn folded(text: &str) -> (usize, usize) {
    let report = inspect(&design(text)).unwrap();
    let folds = report.joints.iter().filter(|joint| joint.kink > 1e-6);
    (folds.count(), report.patches.len())
}

#[test]
fn a_square_to_a_circle_is_four_triangles_and_four_cones_without_a_fold() {
    let hopper = r#"
[curves]
inlet = { polyline = [[200, 0, 350], [200, 200, 350], [-200, 200, 350], [-200, -200, 350], [200, -200, 350], [200, 0, 350]] }
outlet = { arc = { centre = [0, 0, 0], from = [75, 0, 0], axis = [0, 0, 1], angle = 360 } }
[patches.hopper]
connect = ["inlet", "outlet"]
"#;
    // The triangle beside the start of the inlet is in two parts.
    assert_eq!(folded(hopper), (0, 9));
    let report = inspect(&design(hopper)).unwrap();
    let triangle = 0.5 * 400.0 * libm::hypot(125.0, 350.0);
    let triangles: Vec<f64> = report
        .patches
        .iter()
        .filter_map(|p| p.area)
        .filter(|a| (a - triangle).abs() < 1e-6)
        .collect();
    assert_eq!(triangles.len(), 3);
    // The area of a cone over a quarter of the circle, integrated with 30 digits.
    assert!(
        (area(&report) - 4.0 * triangle - 4.0 * 23_211.238_221).abs() < 0.05,
        "{}",
        area(&report)
    );
}

#[test]
fn polygons_connect_to_circles_out_of_their_middle_and_the_other_way_around() {
    let between = |inlet: &str, outlet: &str| {
        folded(&format!(
            "[curves]\ninlet = {{ polyline = {inlet} }}\noutlet = {{ arc = {outlet} }}\n[patches.p]\nconnect = ['inlet', 'outlet']\n"
        ))
    };
    let rectangle =
        "[[250, 150, 300], [-250, 150, 300], [-250, -150, 300], [250, -150, 300], [250, 150, 300]]";
    let aside = "{ centre = [50, 20, 0], from = [150, 20, 0], axis = [0, 0, 1], angle = 360 }";
    assert_eq!(between(rectangle, aside), (0, 8));
    let against = "{ centre = [0, 0, 0], from = [-60, 80, 0], axis = [0, 0, -1], angle = 360 }";
    assert_eq!(between(rectangle, against).0, 0);
    let hexagon = "[[200, 0, 300], [100, 173.2, 300], [-100, 173.2, 300], [-200, 0, 300], [-100, -173.2, 300], [100, -173.2, 300], [200, 0, 300]]";
    let round = "{ centre = [0, 0, 0], from = [80, 0, 0], axis = [0, 0, 1], angle = 360 }";
    assert_eq!(between(hexagon, round).0, 0);
}

/// The message and the help of the only mistake of a design.
fn mistake(text: &str) -> String {
    match read("x.toml", text) {
        Ok(_) => panic!("it is read"),
        Err(error) => format!("{error:?}"),
    }
}

#[test]
fn why_there_is_no_whole_panel_is_told_as_it_is() {
    let tips = mistake(
        r#"
[curves]
a = { bezier = [[0, 0, 300], [500, 0, -100], [2500, 0, -100], [3000, 0, 300]] }
b = { bezier = [[0, 0, 300], [700, 500, 150], [2300, 500, 150], [3000, 0, 300]] }
[patches.p]
connect = ["a", "b"]
panel = 1
"#,
    );
    assert!(
        tips.contains("where both curves start or end in one") && !tips.contains("split"),
        "{tips}"
    );
    let straight = mistake(
        r#"
[curves]
a1 = { bezier = [[0, 0, 0], [100, 0, 0]] }
a2 = { arc = { centre = [100, 50, 0], from = [100, 0, 0], axis = [0, 0, 1], angle = 90 } }
a = { row = ["a1", "a2"] }
b1 = { bezier = [[0, 20, 80], [100, 20, 80]] }
b2 = { arc = { centre = [100, 50, 80], from = [100, 20, 80], axis = [0, 0, 1], angle = 90 } }
b = { row = ["b1", "b2"] }
[patches.p]
connect = ["a", "b"]
"#,
    );
    assert!(
        straight.contains("two pieces lie in one plane, as parallel straight ones do"),
        "{straight}"
    );
}

#[test]
fn curves_of_too_many_pieces_are_refused_with_what_to_do() {
    let through = |y: f64| {
        let points = (0..34).map(|k| format!("[{}, {y}, {}]", 10 * k, k * k));
        points.collect::<Vec<_>>().join(", ")
    };
    let refused = mistake(&format!(
        "[curves]\na = {{ through = [{}] }}\nb = {{ through = [{}] }}\n[patches.p]\nconnect = [\"a\", \"b\"]\n",
        through(0.0),
        through(100.0)
    ));
    assert!(refused.contains("1089"), "{refused}");
    assert!(
        refused.contains("curves through fewer points, or parts of them, have fewer"),
        "{refused}"
    );
}
