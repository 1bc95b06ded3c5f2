//! Designs of several pieces, as workshops make them: measured, cut, folded back, with their sheets.

use std::path::{Path, PathBuf};
use torse_designs::bench::{PaperSize, bench_sheets, tiled_parts};
use torse_designs::fold::fold_text;
use torse_designs::inspect::inspect;
use torse_designs::lint::{LintDemand, LintRules, lint};
use torse_designs::load;
use torse_designs::openings::openings;
use torse_designs::unroll::{Demand, Purpose, drawing, parts, unroll};
use torse_exchange::dxf;
use torse_geometry::Surface;
use torse_geometry::vector::{norm, sub};

fn path(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../designs/workshop");
    folder.join(name).with_extension("toml")
}

/// All of it for a design, and how many parts it has.
fn whole_way(name: &str) -> usize {
    let design = load(&path(name)).unwrap();
    let report = inspect(&design).unwrap();
    assert!(report.missed.is_empty(), "{name}: {:?}", report.missed);
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let pattern = dxf(&drawing(&design, &pieces).unwrap()).unwrap();
    let folded = fold_text(&design, "pattern.dxf", &pattern).unwrap();
    assert!(folded.missed.is_empty(), "{name}: {:?}", folded.missed);
    assert_eq!(folded.pieces.len(), pieces.len());
    let parts = parts(&design, &pieces).unwrap();
    let thickness = design.metal.map_or(1.0, |metal| metal.sheet.thickness());
    for part in &parts {
        let cut = dxf(&part.drawing(Purpose::Cut).unwrap()).unwrap();
        let rules = LintRules::published().unwrap();
        let demand = LintDemand {
            thickness: Some(thickness),
            unit: None,
        };
        let judged = lint("part.dxf", cut.as_bytes(), &rules, &demand).unwrap();
        assert!(judged.passes(), "{name} {}: {}", part.name, judged.text());
    }
    let sheets = bench_sheets(&design, &pieces, &parts, PaperSize::A4).unwrap();
    let tiled = tiled_parts(&design, &pieces, &parts, PaperSize::A4).unwrap();
    assert_eq!((sheets.len(), tiled.len()), (parts.len(), parts.len()));
    // Both edges of every seam say so on their sheets.
    let rows: Vec<&Vec<String>> = sheets
        .iter()
        .flat_map(|sheet| &sheet.tables)
        .filter(|table| table.title.starts_with("Edges"))
        .flat_map(|table| &table.rows)
        .collect();
    for seam in &design.seams {
        let [one, other] = [0, 1].map(|end| {
            let name = &seam.edges[end].text;
            let row = rows.iter().find(|row| row[1] == *name);
            row.unwrap_or_else(|| panic!("{name}: {rows:?}"))
        });
        assert!(
            one[4].split(", ").any(|label| label == other[0]),
            "{one:?} {other:?}"
        );
        assert!(
            other[4].split(", ").any(|label| label == one[0]),
            "{one:?} {other:?}"
        );
    }
    parts.len()
}

#[test]
fn an_elbow_of_five_gores_goes_the_whole_way() {
    assert_eq!(whole_way("gored-elbow"), 5);
}

#[test]
fn a_branch_of_three_pipes_goes_the_whole_way() {
    assert_eq!(whole_way("y-branch"), 3);
}

#[test]
fn a_transition_with_flanges_goes_the_whole_way() {
    assert_eq!(whole_way("flanged-transition"), 5);
}

#[test]
fn a_hull_of_three_panels_a_side_goes_the_whole_way() {
    assert_eq!(whole_way("hull"), 6);
}

#[test]
fn a_tent_of_eight_gores_goes_the_whole_way() {
    assert_eq!(whole_way("tent"), 8);
}

#[test]
fn a_branch_pipe_with_its_saddle_goes_the_whole_way_and_fits_its_hole() {
    assert_eq!(whole_way("saddle-branch"), 2);
    let design = load(&path("saddle-branch")).unwrap();
    let pieces = unroll(&design, &Demand::default()).unwrap();
    let main = pieces
        .iter()
        .find(|piece| piece.piece.name == "main")
        .unwrap();
    let holes = openings(&design, &main.piece, &main.flat).unwrap();
    let [hole] = holes.as_slice() else {
        panic!("{holes:?}")
    };
    assert!(hole.proved && hole.error <= design.tolerances.outline);
    let contour = hole.shape.contour();
    // The saddle edge of the branch in space, laid on the pattern of the main pipe, is the contour of its hole.
    let mut seen = 0;
    for patch in design
        .patches
        .iter()
        .filter(|patch| patch.name.starts_with("branch"))
    {
        for k in 0..8 {
            let point = patch.sheet.point(f64::from(k) / 8.0, 1.0).unwrap();
            let place = main
                .flat
                .locate_in_space(point, design.tolerances.gap)
                .unwrap();
            let point = main.flat.flatten(place).unwrap();
            let near = contour.iter().map(|segment| segment.distance(point));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near <= hole.error + 2.0 * design.tolerances.gap, "{near}");
            seen += 1;
        }
    }
    assert_eq!(seen, 128);
    // Of the closed form: r^2 times the integral of cos^2/sqrt(1 - (r/R)^2 sin^2).
    let steps = 512;
    let angle = |k: i32| 2.0 * std::f64::consts::PI * f64::from(k) / f64::from(steps);
    let share = |t: f64| libm::cos(t).powi(2) / (1.0 - (0.5 * libm::sin(t)).powi(2)).sqrt();
    let mean = (0..steps).map(|k| share(angle(k))).sum::<f64>() / f64::from(steps);
    let area = 625.0 * 2.0 * std::f64::consts::PI * mean;
    assert!(
        (hole.shape.area() - area).abs() < 0.5,
        "{} {area}",
        hole.shape.area()
    );
}

/// The whole way of a surface in strips, and the proved distances beside those of samples: of points of strips from the surface
/// between their edges, found on a fine grid.
fn strips_go_the_whole_way(name: &str, count: usize) {
    assert_eq!(whole_way(name), count);
    let design = load(&path(name)).unwrap();
    let cover = &design.covers[0];
    assert!(cover.fewest && cover.strips.len() == count);
    let surface = &design.surfaces[0].parts[0];
    for strip in &cover.strips {
        assert!(strip.distance <= cover.within);
        let mut far = 0.0_f64;
        for patch in &strip.patches {
            let sheet = &design.patches[*patch].sheet;
            for (u, v) in (0..=8).flat_map(|i| (0..=4).map(move |j| (i, j))) {
                let point = sheet.point(f64::from(u) / 8.0, f64::from(v) / 4.0).unwrap();
                let mut nearest = f64::INFINITY;
                for (i, j) in (0..=400).flat_map(|i| (0..=24).map(move |j| (i, j))) {
                    let along = f64::from(i) / 400.0;
                    let [from, to] = strip.range;
                    let across = from + (to - from) * f64::from(j) / 24.0;
                    let at = if cover.along == "u" {
                        [along, across]
                    } else {
                        [across, along]
                    };
                    nearest =
                        nearest.min(norm(&sub(&surface.point(&at[0], &at[1]).unwrap(), &point)));
                }
                far = far.max(nearest);
            }
        }
        // A grid is a little farther away than the surface, by half of its diagonal at most.
        assert!(
            far > 0.3 * strip.distance && far < strip.distance + 8.0,
            "{name}: {far} {strip:?}"
        );
    }
}

#[test]
fn a_dome_in_strips_goes_the_whole_way() {
    strips_go_the_whole_way("dome-strips", 5);
}

#[test]
fn a_hull_in_strakes_goes_the_whole_way() {
    strips_go_the_whole_way("hull-strips", 6);
}

#[test]
fn a_saddle_in_strips_goes_the_whole_way() {
    strips_go_the_whole_way("saddle-strips", 4);
}

#[test]
fn every_design_of_the_workshop_is_tested() {
    let folder = path("x").parent().unwrap().to_owned();
    let files = std::fs::read_dir(folder).unwrap();
    let designs = files.filter(|file| {
        let path = file.as_ref().unwrap().path();
        path.extension().is_some_and(|e| e == "toml")
    });
    assert_eq!(designs.count(), 9);
}
