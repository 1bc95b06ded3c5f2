//! Pictures, and what is said of them.

use crate::paper;
use crate::support::HTML;
use torse_report::{gallery, model::Report};

#[test]
fn figures_say_what_was_assumed_and_what_replaced_in_page_and_gallery() {
    let sample = paper::sample();
    let figures = paper::figures();
    let gallery = gallery(&[(&sample, &figures)]).unwrap();
    for (what, text) in [("page", HTML.as_str()), ("gallery", gallery.as_str())] {
        for verdict in ["reproduced", "partial", "underspecified"] {
            assert!(text.contains(verdict), "{what}: {verdict}");
        }
        assert!(
            text.contains("Assumed:") && text.contains("the view; the range of"),
            "{what}"
        );
        assert!(text.contains("Not printed, replaced by our own:"), "{what}");
        assert!(!text.contains("<script>alert"), "{what}");
    }
    for figure in &figures {
        let link = format!("<img src=\"figures/{}.png\" width=", figure.name);
        assert!(gallery.contains(&link), "{}", figure.name);
    }
}

#[test]
fn a_figure_of_the_paper_has_its_number_and_a_picture_of_ours_another() {
    let numbers = |at: &str| -> Vec<String> {
        let mut sample = paper::sample();
        for outcome in &mut sample.claims {
            if outcome.claim.id == "sample/fig-1" {
                outcome.claim.at = at.to_owned();
            }
        }
        let report = Report::new(&sample, &paper::figures());
        report.figures.into_iter().map(|of| of.number).collect()
    };
    assert_eq!(
        numbers("Fig. 2 (a) (its caption is missing)"),
        ["2(a)", "E1", "E2"]
    );
    assert_eq!(numbers("Sect. 3.1, Figure 12"), ["12", "E1", "E2"]);
    assert_eq!(numbers("Figs. 9–10"), ["E1", "E2", "E3"]);
    assert!(HTML.contains("<figcaption>Figure 1. ") && HTML.contains("<figcaption>Figure E1. "));
    assert!(HTML.contains(">Figure 1</a>"), "a mention");
}

#[test]
fn the_gallery_links_a_figure_that_moves_to_its_place_in_the_report_and_no_other() {
    let (sample, figures) = (paper::sample(), paper::figures());
    let report = Report::new(&sample, &figures);
    let gallery = gallery(&[(&sample, &figures)]).unwrap();
    let entries: Vec<&str> = gallery.split("<img ").skip(1).collect();
    assert_eq!(entries.len(), figures.len());
    let mut moving = 0;
    for ((entry, figure), view) in entries.iter().zip(&figures).zip(&report.figures) {
        let moves = figure.interactive.is_some() || figure.torse.is_some();
        let link = format!("<a href=\"sample.html#{}\">", view.anchor);
        assert_eq!(entry.contains(&link), moves, "{}", figure.name);
        assert!(HTML.contains(&format!("id=\"{}\"", view.anchor)));
        moving += usize::from(moves);
    }
    assert!((1..figures.len()).contains(&moving), "{moving}");
}

#[test]
fn a_figure_with_sliders_carries_its_nets_as_json() {
    let start = "<script type=\"application/json\">";
    assert_eq!(HTML.matches(start).count(), 1);
    let (_, after) = HTML.split_once(start).unwrap();
    let (data, _) = after.split_once("</script>").unwrap();
    let data: serde_json::Value = serde_json::from_str(data).unwrap();
    let arch = paper::arch().unwrap();
    let parts = data["parts"].as_array().unwrap();
    assert_eq!(parts.len(), arch.parts().len());
    for (part, of) in parts.iter().zip(arch.parts()) {
        for (net, points) in part["nets"].as_array().unwrap().iter().zip(&of.nets) {
            let numbers: Vec<f64> = net
                .as_array()
                .unwrap()
                .iter()
                .map(|n| n.as_f64().unwrap())
                .collect();
            let close = numbers
                .iter()
                .zip(points.iter().flatten())
                .all(|(a, b)| (a - b).abs() < 1e-4);
            assert!(numbers.len() == 3 * points.len() && close);
        }
    }
}
