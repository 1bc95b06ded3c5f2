//! A page with the patches to turn and their pattern beside them: one file, no network.

use super::{grids, lines, samples};
use crate::design::Design;
use crate::error::DesignError;
use crate::inspect::{inspect, table};
use crate::space_openings::openings_in_space;
use crate::unroll::{Demand, PatternSummary, drawing, unroll};
use serde::Serialize;
use torse_exchange::svg;

const TEMPLATE: &str = include_str!("page.html");
/// Steps along the rails and along the rulings.
const ALONG: usize = 48;
const ACROSS: usize = 4;
/// Steps of a surface, each way.
const WAYS: usize = 24;

/// A patch for the viewer.
#[derive(Serialize)]
struct PageShape<'d> {
    name: &'d str,
    rows: usize,
    columns: usize,
    /// Every so many rows a ruling is drawn.
    every: usize,
    points: Vec<[f64; 3]>,
}

/// Returns the page: what `inspect` found, the patches, the pattern with what it promises.
///
/// # Errors
/// As [`inspect`], [`DesignError::Patch`].
///
/// ```
/// use torse_designs::{draw::page, unroll::Demand};
/// let design = torse_designs::read("tube.toml", r#"
///     [design]
///     title = "A <tube>"
///     [curves.rim]
///     arc = { centre = [0, 0, 0], from = [20, 0, 0], to = [0, 20, 0] }
///     [patches.tube]
///     cylinder = "rim"
///     direction = [0, 0, 30]
/// "#)?;
/// let html = page(&design, &Demand::default())?;
/// assert!(html.contains("<h1>A &lt;tube&gt;</h1>") && html.contains("id=\"OUTLINE\""));
/// assert!(!html.contains("https://"));
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn page(design: &Design, demand: &Demand) -> Result<String, DesignError> {
    let every = (ALONG / lines(design)).max(1);
    let mut shapes = Vec::new();
    let openings = openings_in_space(design).unwrap_or_default();
    for (index, patch) in design.patches.iter().enumerate() {
        let own: Vec<_> = openings.iter().filter(|own| own.patch == index).collect();
        if !own.is_empty() {
            let parts = grids(patch, &own, [ALONG, ACROSS])?.into_iter();
            shapes.extend(parts.map(|part| PageShape {
                name: &patch.name,
                rows: part.rows,
                columns: part.columns,
                // Where it begins and ends.
                every: part.rows,
                points: part.points.iter().map(|p| p.map(rounded)).collect(),
            }));
            continue;
        }
        let points = samples(patch, ALONG, ACROSS)?;
        shapes.push(PageShape {
            name: &patch.name,
            rows: ALONG + 1,
            columns: ACROSS + 1,
            every,
            points: points.iter().map(|p| p.map(rounded)).collect(),
        });
    }
    for surface in &design.surfaces {
        for part in &surface.parts {
            shapes.push(PageShape {
                name: &surface.name,
                rows: WAYS + 1,
                columns: WAYS + 1,
                every: WAYS / 8,
                points: super::grid(surface, part, WAYS, WAYS)?
                    .iter()
                    .map(|p| p.map(rounded))
                    .collect(),
            });
        }
    }
    let (pattern, promise) = match unroll(design, demand) {
        Ok(pieces) => {
            let text = svg(&drawing(design, &pieces)?)?;
            (text, PatternSummary::new(design, &pieces).text())
        }
        Err(error) => (String::new(), format!("No pattern: {error}\n")),
    };
    // A script ends at the first `</`, whatever stands around it.
    let data = serde_json::to_string(&shapes).unwrap_or_else(|_| "[]".to_owned());
    let data = data.replace("</", "<\\/");
    let report = table(&inspect(design)?);
    let mut html = String::with_capacity(TEMPLATE.len() + data.len() + pattern.len());
    for (k, part) in TEMPLATE.split("@@").enumerate() {
        if k % 2 == 0 {
            html.push_str(part);
            continue;
        }
        html.push_str(&match part {
            "title" => escaped(&design.title),
            "pattern" => pattern.clone(),
            "kind" if design.has_tool_bends() => {
                "The development, without bend allowance,".to_owned()
            }
            "kind" => "The flat pattern".to_owned(),
            "promise" => escaped(&promise),
            "report" => escaped(&report),
            "shapes" => data.clone(),
            other => other.to_owned(),
        });
    }
    Ok(html)
}

/// As many digits as a screen shows.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse::<f64>().unwrap_or(value) + 0.0
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
