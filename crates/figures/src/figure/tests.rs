//! The figure language: a tiny paper, drawn and spoilt.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use super::Drawing;
use miette::Diagnostic;
use std::sync::Arc;
use torse_syntax::derivation::{Figure, LoadError, Paper, Source, paper};
use torse_syntax::taxonomy::Verdict;

const HEAD: &str = r#"
[paper]
id = "tiny"
title = "A tiny paper"
authors = "torse"
venue = "a test"
claims = ["claims.toml"]
[symbols]
x = { in = "[0, 1]" }
t = {}
mu = { in = "[-1, 1]" }
k = { integer = ">= 2" }
i = { integer = "0..k" }
P = { family = "any", indices = ["0..k"] }
Q = { family = "any", indices = ["0..1", "0..1"] }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[define]
"G(x)" = 'sum(i, 0, k, B[i,k](x)*P[i])'
"#;

const CLAIM: &str = r#"
[[claim]]
id = "tiny/fig-1"
at = "Fig. 1"
kind = "figure"
printed = "Figure 1"
underspecified = "the points"
[claim.figure]
title = "A curve"
caption = "A curve."
alt = "A curve."
set = { k = '2', P = '[[0, 0], [mu, 2], [2, 0]]' }
sliders = { mu = '1/2' }
"#;

fn tiny(claims: &str) -> Result<Paper, LoadError> {
    paper(|name| {
        let text = match name {
            "paper.toml" => HEAD.to_owned(),
            _ => claims.to_owned(),
        };
        let name = format!("tiny/{name}");
        Ok(Arc::new(Source::new(name, text)))
    })
}

/// The figure of the tiny claim with these panels.
fn figure(panels: &str) -> Figure {
    let paper = tiny(&format!("{CLAIM}{panels}")).unwrap();
    paper.figures().next().unwrap().clone()
}

fn with_layer(layer: &str) -> Figure {
    figure(&format!("[[claim.figure.panel]]\nlayer = [{{ {layer} }}]"))
}

fn drawing(layer: &str) -> Drawing {
    super::drawing(&with_layer(layer)).unwrap()
}

/// The message of the error of a layer, and the text under its caret.
fn mistake(layer: &str) -> (String, String) {
    let claims = format!("{CLAIM}[[claim.figure.panel]]\nlayer = [{{ {layer} }}]");
    let error = match tiny(&claims) {
        Err(LoadError::Derivation(error)) => error,
        Err(other) => panic!("{other}"),
        Ok(paper) => super::drawing(paper.figures().next().unwrap()).unwrap_err(),
    };
    let label = error.labels().unwrap().next().unwrap();
    let under = claims
        .get(label.offset()..label.offset() + label.len())
        .unwrap();
    (error.to_string(), under.to_owned())
}

fn coordinates(drawing: &Drawing, layer: usize) -> Vec<String> {
    let layer = &drawing.panels[0].layers[layer];
    layer
        .points
        .iter()
        .flatten()
        .map(ToString::to_string)
        .collect()
}

#[test]
fn a_curve_is_the_papers_own_definition_with_the_points_that_the_figure_sets() {
    let drawn = drawing("draw = 'curve', at = 'G(x)', over = ['x']");
    // x^2 P_2 + 2 x (1 - x) P_1 with P_1 = (1/2, 2), P_2 = (2, 0).
    assert_eq!(coordinates(&drawn, 0), ["x^2 + x", "-4*x^2 + 4*x"]);
    let running = &drawn.panels[0].layers[0].running[0];
    assert_eq!(
        (
            running.range.low.to_string(),
            running.range.high.to_string()
        ),
        ("0".into(), "1".into())
    );
}

#[test]
fn sliders_stay_symbolic_in_the_interactive_version_and_their_loops_are_left_out() {
    let layer =
        "draw = 'curve', at = 'G(x)', over = ['x'], for = [{ mu = ['-1', '1'] }], label = '{mu}'";
    let figure = with_layer(layer);
    let fixed = super::drawing(&figure).unwrap();
    assert_eq!(coordinates(&fixed, 0)[0], "4*x^2 - 2*x");
    assert_eq!(coordinates(&fixed, 1)[0], "2*x");
    assert_eq!(fixed.panels[0].layers[1].label, "1");
    let free = super::interactive(&figure).unwrap().unwrap();
    assert_eq!(free.panels[0].layers.len(), 1);
    assert_eq!(coordinates(&free, 0)[0], "-2*mu*x^2 + 2*mu*x + 2*x^2");
    assert_eq!(free.sliders[0].range.low.to_string(), "-1");
}

#[test]
fn loops_nest_and_names_of_one_loop_run_in_step() {
    let drawn = drawing(
        "draw = 'points', at = '[mu + i, t]', for = [{ mu = ['0', '1/2'], t = ['7', '8'] }, { i = ['0..k'] }]",
    );
    let all: Vec<String> = (0..6).map(|n| coordinates(&drawn, n).join(",")).collect();
    assert_eq!(all, ["0,7", "1,7", "2,7", "1/2,8", "3/2,8", "5/2,8"]);
    assert_eq!(drawn.panels[0].layers[4].round, Some(1));
}

#[test]
fn layers_through_the_same_rounds_and_through_none_have_each_their_own_values() {
    let point = "draw = 'points', at = 'G(1/2)'";
    let figure = figure(&format!(
        "[[claim.figure.panel]]\nlayer = [\n\
         {{ {point}, for = [{{ mu = ['1', '0'] }}] }},\n\
         {{ {point} }},\n\
         {{ {point}, for = [{{ mu = ['0', '1'] }}] }},\n]"
    ));
    let drawn = super::drawing(&figure).unwrap();
    // (P_1 + P_2/2)/2 with P_1 = (mu, 2), where mu is 1/2 but for the loops.
    let first = |n: usize| coordinates(&drawn, n).swap_remove(0);
    let all: Vec<String> = (0..5).map(first).collect();
    assert_eq!(all, ["1", "1/2", "3/4", "1/2", "1"]);
}

#[test]
fn indices_make_polygons_and_nets() {
    let drawn = drawing("draw = 'polygon', at = 'P[i]', over = ['i in 0..k']");
    assert_eq!(coordinates(&drawn, 0), ["0", "0", "1/2", "2", "2", "0"]);
    let net = figure(
        "symbols = { j = { integer = '0..1' } }\nnets = { Q = ['[[0, 0, 0], [0, 1, 0]]', '[[1, 0, 5], [1, 1, 7]]'] }
         [[claim.figure.panel]]\nlayer = [{ draw = 'net', at = 'Q[i,j]', over = ['i in 0..1', 'j in 0..1'] }]",
    );
    let drawn = super::drawing(&net).unwrap();
    assert_eq!(coordinates(&drawn, 0).concat(), "000010105117");
    assert_eq!(drawn.panels[0].layers[0].columns, 2);
}

#[test]
fn given_equations_are_solved() {
    let solved = figure(
        "symbols = { p = { vector = 2 } }\ngiven = ['p == G(1/2)']\nsolve_for = ['p']
         [[claim.figure.panel]]\nlayer = [{ draw = 'points', at = 'p' }]",
    );
    assert_eq!(
        coordinates(&super::drawing(&solved).unwrap(), 0),
        ["3/4", "1"]
    );
}

#[test]
fn a_bad_formula_in_a_layer_is_shown_with_its_place() {
    assert_eq!(
        mistake("draw = 'curve', at = 'G(x) + [0, zeta]', over = ['x']"),
        ("`zeta` is not declared".into(), "zeta".into())
    );
    assert_eq!(mistake("draw = 'curve', at = 'G(x', over = ['x']").1, "(");
    assert_eq!(
        mistake("draw = 'curve', at = '[x, t]', over = ['x']"),
        ("`t` has no value here".into(), "[x, t]".into())
    );
    assert_eq!(
        mistake("draw = 'curve', at = '[x, x/0]', over = ['x']").1,
        "0"
    );
    assert_eq!(
        mistake("draw = 'curve', at = '[x, x]', over = ['x in [0, y]']").1,
        "y"
    );
    assert_eq!(
        mistake("draw = 'curve', at = '[x, x]', over = ['t']").1,
        "t"
    );
}

#[test]
fn a_layer_that_does_not_fit_its_shape_is_refused() {
    let message = |layer: &str| mistake(layer).0;
    assert!(message("draw = 'curve', at = '[x, x]'").contains("one variable runs along a curve"));
    assert!(
        message("draw = 'surface', at = '[x, t]', over = ['x', 't in [0, 1]']")
            .contains("2 coordinates where 3")
    );
    assert!(message("draw = 'segments', at = '[[0, 0], [1, 0], [1, 1]]'").contains("pairs"));
    assert!(message("draw = 'points', at = '1'").contains("a number where a point"));
    assert!(message("draw = 'plane', at = '[1, 0, 0, 1]'").contains("needs intervals"));
    assert!(
        message("draw = 'points', at = '[0, 0]', for = [{ mu = ['0', '1'], t = ['0'] }]")
            .contains("fewer values")
    );
    assert!(message("draw = 'blob', at = '[0, 0]'").contains("unknown variant"));
    assert!(
        message("draw = 'polygon', at = 'P[i]', over = ['i in 0..100000000']").contains("no range")
    );
    assert!(
        message("draw = 'points', at = '[0, 0]', for = [{ t = ['0..399'] }, { mu = ['0..9'] }]")
            .contains("rounds")
    );
}

#[test]
fn layers_of_one_panel_live_in_one_space() {
    let layers = "[[claim.figure.panel]]\nlayer = [{ draw = 'points', at = '[0, 0]' }, { draw = 'points', at = '[0, 0, 0]' }]";
    let error = super::drawing(&figure(layers)).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("a point of the plane, as in the first layer")
    );
}

#[test]
fn the_verdict_of_a_figure_follows_from_what_was_assumed_or_replaced() {
    let panel = "[[claim.figure.panel]]\nlayer = [{ draw = 'points', at = 'P[1]' }]";
    for (fields, verdict) in [
        ("", Verdict::Reproduced),
        ("assumes = ['the view']", Verdict::Partial),
        (
            "assumes = ['the view']\nstand_in = ['the points']",
            Verdict::Underspecified,
        ),
    ] {
        let paper = tiny(&format!("{CLAIM}{fields}\n{panel}")).unwrap();
        let figure = paper.figures().next().unwrap();
        assert_eq!(figure.verdict(), verdict, "{fields}");
    }
}

#[test]
fn a_figure_of_its_own_has_an_id_of_its_own() {
    let own = "[[figure]]\ntitle = ''\ncaption = ''\nalt = ''\n[[figure.panel]]\nlayer = [{ draw = 'points', at = '[0, 0]' }]";
    assert!(tiny(own).unwrap_err().to_string().contains("`id`"));
    let twice = format!(
        "{CLAIM}panel = []\n{}",
        own.replace("title = ''", "id = 'tiny/fig-1'\ntitle = ''")
    );
    assert!(tiny(&twice).unwrap_err().to_string().contains("used twice"));
    let paper = tiny(&own.replace(
        "title = ''",
        "id = 'tiny/own'\nclaims = ['tiny/fig-1']\ntitle = ''",
    ))
    .unwrap();
    let drawn = super::drawing(paper.figures().next().unwrap()).unwrap();
    assert_eq!((drawn.id.as_str(), drawn.claims.len()), ("tiny/own", 1));
}

/// The developable of the tiny figure.
fn torse(
    entry: &str,
) -> Result<Option<super::Torse>, Box<torse_syntax::derivation::DerivationError>> {
    let panel = "[[claim.figure.panel]]\nlayer = [{ draw = 'curve', at = 'G(x)', over = ['x'] }]";
    let paper = tiny(&format!("{CLAIM}\n{panel}\n[claim.figure.torse]\n{entry}")).unwrap();
    super::torse(paper.figures().next().unwrap())
}

#[test]
fn a_developable_leaves_its_sliders_symbolic_and_follows_what_it_sets() {
    let piece =
        "piece = [{ draw = 'envelope', at = ['[1, x, mu*x, t]'], over = 'x', along = '[0, 2]' }]";
    let torse = torse(&format!(
        "view = [0, 30]\nsliders = {{ mu = '[-1, 0, 1/2]' }}\nset = {{ t = '2*mu' }}\n{piece}"
    ));
    let torse = torse.unwrap().unwrap();
    let texts = |fractions: &[torse_algebra::Fraction]| -> Vec<String> {
        fractions.iter().map(ToString::to_string).collect()
    };
    assert_eq!(
        texts(&torse.pieces[0].curves[0]),
        ["1", "x", "mu*x", "2*mu"]
    );
    let slider = &torse.sliders[0];
    let numbers = [
        slider.range.low.clone(),
        slider.start.clone(),
        slider.range.high.clone(),
    ];
    assert_eq!(texts(&numbers), ["-1", "0", "1/2"]);
}

#[test]
fn a_developable_wants_three_numbers_a_slider_and_the_curves_of_its_kind() {
    let entry = |sliders: &str, at: &str| {
        format!(
            "view = [0, 30]\nsliders = {{ mu = '{sliders}' }}\npiece = [{{ draw = 'ruled', at = [{at}], over = 'x', along = '[0, 1]' }}]"
        )
    };
    let fine = "'[x, 0, mu]', '[x, 1, mu]'";
    assert!(torse(&entry("[-1, 0, 1]", fine)).is_ok());
    for (sliders, at) in [
        ("[-1, 1]", fine),
        ("1", fine),
        ("[-1, 0, 1]", "'[x, 0, mu]'"),
        ("[-1, 0, 1]", "'[x, 0, mu, 1]', '[x, 1, mu, 1]'"),
        ("[-1, 0, 1]", "'[x, 0, t]', '[x, 1, mu]'"),
    ] {
        assert!(torse(&entry(sliders, at)).is_err(), "{sliders} {at}");
    }
}
