//! All figures of the repository: drawn, small enough for a report, and movable where they promise it.

#![allow(clippy::unwrap_used, reason = "tests")]

use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;
use torse_figures::{Plate, plates};
use torse_plot::{Bounds, Content};
use torse_syntax::derivation::load;

static PLATES: LazyLock<Vec<Plate>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = load(&folder).unwrap();
    papers
        .iter()
        .flat_map(|paper| plates(paper).unwrap())
        .collect()
});

/// What fits into a report, in bytes.
const BUDGET: usize = 300 * 1024;

#[test]
fn every_figure_is_drawn_and_fits_into_a_report() {
    PLATES.par_iter().for_each(|plate| {
        let picture = plate
            .draw()
            .unwrap_or_else(|error| unreachable!("{}: {error}", plate.name()));
        let sizes = [picture.svg.len(), picture.png().unwrap().len()];
        assert!(
            sizes.iter().all(|size| *size < BUDGET),
            "{}: {sizes:?} bytes",
            plate.name()
        );
    });
}

#[test]
fn panels_that_are_compared_have_the_same_box_or_the_same_axes() {
    let mut compared = 0;
    for plate in PLATES.iter() {
        let figure = plate.figure().unwrap();
        let panels = plate.drawing().panels.iter().zip(&figure.panels);
        let panels: Vec<_> = panels.collect();
        for pair in panels.windows(2) {
            let [(first, a), (second, b)] = pair else {
                continue;
            };
            if first.entry != second.entry {
                continue;
            }
            let same = match (&a.content, &b.content) {
                (Content::View(a), Content::View(b)) => {
                    a.bounds == b.bounds && a.bounds != Bounds::Data
                }
                (Content::Plot(a), Content::Plot(b)) => {
                    a.x.range.is_some() && (&a.x.range, &a.y.range) == (&b.x.range, &b.y.range)
                }
                _ => false,
            };
            assert!(same, "{}: {} and {}", plate.name(), a.caption, b.caption);
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared} pairs of panels");
}

#[test]
fn every_figure_of_the_papers_has_a_plate() {
    let count = |slug: &str| {
        let own = |plate: &&Plate| plate.drawing().claims == [plate.drawing().id.clone()];
        let ids = PLATES.iter().filter(own).map(|plate| &plate.drawing().id);
        ids.filter(|id| id.starts_with(&format!("{slug}/fig-")))
            .count()
    };
    assert_eq!(count("gbt-developable"), 21);
    assert_eq!(count("gbt-surfaces"), 27);
    assert_eq!(count("hermite-developable"), 14);
}

#[test]
fn fingerprints_tell_all_figures_apart_and_stay() {
    let prints: BTreeSet<u64> = PLATES.iter().map(|p| p.fingerprint().unwrap()).collect();
    assert_eq!(prints.len(), PLATES.len());
    assert!(
        PLATES
            .iter()
            .all(|p| prints.contains(&p.clone().fingerprint().unwrap()))
    );
}

#[test]
fn an_interactive_bicubic_patch_interpolates_the_corners_of_its_net_for_all_slider_values() {
    let plate = PLATES
        .iter()
        .find(|p| p.name() == "gbt-surfaces-fig-3")
        .unwrap();
    let moving = plate.interactive().unwrap().unwrap();
    // mu and nu enter linearly in each direction: nine monomials.
    assert_eq!(moving.monomials().len(), 9);
    let [patch, net] = moving.parts() else {
        unreachable!("a patch and a net")
    };
    for values in [[-1.0; 4], [0.3, -0.8, 1.0, 0.5]] {
        let (patch, net) = (moving.points(patch, &values), moving.points(net, &values));
        for (a, b) in [(patch.first(), net.first()), (patch.last(), net.last())] {
            let gap = a
                .unwrap()
                .iter()
                .zip(b.unwrap())
                .map(|(x, y)| (x - y).abs());
            assert!(gap.fold(0.0, f64::max) < 1e-12);
        }
    }
}

#[test]
fn an_interactive_curve_agrees_with_the_printed_one_at_its_values() {
    let plate = PLATES
        .iter()
        .find(|p| p.name() == "gbt-developable-fig-2a")
        .unwrap();
    let moving = plate.interactive().unwrap().unwrap();
    let curve = moving
        .parts()
        .iter()
        .find(|p| p.shape == torse_plot::Shape::Curve)
        .unwrap();
    // G(1/2) of the cubic with mu = nu = 1, by hand: g = (r, 1/2 - r, 1/2 - r, r) with r = (1 - s)^2/2, s = sqrt(1/2).
    let r = (1.0 - 0.5_f64.sqrt()).powi(2) / 2.0;
    let middle = moving.points(curve, &[1.0, 1.0])[32];
    let expected = [2.5, 6.0 * (0.5 - r)];
    assert!((middle[0] - expected[0]).abs() < 1e-12 && (middle[1] - expected[1]).abs() < 1e-12);
}

#[test]
fn captions_say_what_was_assumed_and_what_was_replaced() {
    for plate in PLATES.iter() {
        let caption = plate.caption();
        for said in plate
            .drawing()
            .assumes
            .iter()
            .chain(&plate.drawing().stand_in)
        {
            assert!(caption.contains(said.as_str()), "{}: {said}", plate.name());
        }
    }
}
