//! The report as a table of at most 100 columns.

use super::{
    Assurance, DesignReport, JointReport, PatchReport, SeamReport, SurfaceReport, ValueBounds,
};
use crate::covers::{CoveringStrip, SurfaceCover};
use crate::lines::{columns, wrapped};
use crate::numbers::{at_most, number};

/// The longest name that is shown whole.
const MAX_NAME_CHARS: usize = 22;

/// Returns the report for people.
#[must_use]
pub fn table(report: &DesignReport) -> String {
    let mut text = format!(
        "{}: {} (lengths in {})\n\n",
        report.design, report.title, report.unit
    );
    text = wrapped("", &text.trim_end().replace('\n', " ")) + "\n";
    for reason in &report.missed {
        text.push_str(&missed_line(reason));
    }
    if !report.missed.is_empty() {
        text.push('\n');
    }
    let heads = [
        "patch",
        "developable",
        "regular",
        "from regression",
        "rulings",
        "twist",
        "radius",
        "area",
    ];
    if !report.patches.is_empty() {
        let rows = report.patches.iter().map(row);
        text.push_str(&columns(&heads, &rows.collect::<Vec<_>>()));
    }
    if !report.joints.is_empty() {
        text.push('\n');
        let heads = ["joint", "apart", "kink", "continuity", "beta values"];
        let rows = report.joints.iter().map(joint);
        text.push_str(&columns(&heads, &rows.collect::<Vec<_>>()));
    }
    if !report.seams.is_empty() {
        text.push('\n');
        let heads = ["seam", "lengths", "ease", "apart"];
        let rows = report.seams.iter().map(seam);
        text.push_str(&columns(&heads, &rows.collect::<Vec<_>>()));
    }
    if !report.surfaces.is_empty() {
        if !report.patches.is_empty() {
            text.push('\n');
        }
        let heads = [
            "surface",
            "made by",
            "degrees",
            "Gaussian curvature",
            "radius",
            "area",
        ];
        let rows = report.surfaces.iter().map(surface);
        text.push_str(&columns(&heads, &rows.collect::<Vec<_>>()));
    }
    for cover in &report.covers {
        text.push('\n');
        text.push_str(&strips(cover));
    }
    let noted = report.patches.iter().filter(|p| !p.notes.is_empty());
    for patch in noted {
        text.push('\n');
        for note in &patch.notes {
            text.push_str(&wrapped(&format!("{}: ", patch.name), note));
        }
    }
    let on_space = report.notes_on_space();
    if !on_space.is_empty() {
        text.push('\n');
    }
    for note in &on_space {
        text.push_str(&wrapped("note: ", note));
    }
    if !report.notes.is_empty() {
        text.push('\n');
    }
    for note in &report.notes {
        text.push_str(&wrapped("from ", note));
    }
    text.push('\n');
    text.push_str(&match report.missed.len() {
        0 => "All tolerances are met.\n".to_owned(),
        1 => "1 tolerance is missed.\n".to_owned(),
        count => format!("{count} tolerances are missed.\n"),
    });
    text
}

/// Several designs, one a line: how many patches and seams each has, how tightly it bends, what it misses first.
#[must_use]
pub fn overview(reports: &[DesignReport]) -> String {
    let rows: Vec<Vec<String>> = reports
        .iter()
        .map(|report| {
            let radii = report.patches.iter().filter_map(|patch| patch.radius);
            let radius = radii.fold(f64::INFINITY, f64::min);
            let missed = match report.missed.as_slice() {
                [] => "nothing".to_owned(),
                [only] => only.clone(),
                [first, rest @ ..] => format!("{first}; and {} more", rest.len()),
            };
            vec![
                shortened(&report.design),
                report.patches.len().to_string(),
                if radius.is_finite() {
                    number(radius)
                } else {
                    "flat".to_owned()
                },
                missed,
            ]
        })
        .collect();
    columns(&["design", "patches", "radius", "missed"], &rows)
}

fn row(patch: &PatchReport) -> Vec<String> {
    let regular = match patch.apexes.is_empty() {
        true => patch.regular.words().to_owned(),
        false => format!("{}, apex", patch.regular.words()),
    };
    vec![
        shortened(&patch.name),
        match (patch.developable, patch.twist.high) {
            (Assurance::Within, Some(high)) => format!("within {}°", at_most(high)),
            (known, _) => known.words().to_owned(),
        },
        regular,
        // Rulings that are only nearly parallel to a plane of their neighbours meet no edge.
        match patch.developable {
            Assurance::ByConstruction | Assurance::Proved => {
                patch.clearance.map_or("no edge".to_owned(), bounds)
            }
            _ => "-".to_owned(),
        },
        format!(
            "{} to {}",
            number(patch.rulings[0]),
            number(patch.rulings[1])
        ),
        format!("{}°", number(patch.twist_measured[0])),
        match (patch.radius, patch.regular.holds()) {
            (Some(radius), _) => number(radius),
            (None, true) => "flat".to_owned(),
            (None, false) => "-".to_owned(),
        },
        patch.area.map_or("-".to_owned(), number),
    ]
}

fn seam(seam: &SeamReport) -> Vec<String> {
    let [one, other] = &seam.edges;
    vec![
        if seam.offset == 0.0 {
            format!("{one} - {other}")
        } else {
            format!("{one} - {other} from {:.4} of its length", seam.offset)
        },
        format!(
            "{} and {}",
            number(seam.lengths[0]),
            number(seam.lengths[1])
        ),
        number(seam.ease),
        number(seam.apart[0]),
    ]
}

fn surface(surface: &SurfaceReport) -> Vec<String> {
    let [u, v] = surface.degrees;
    vec![
        shortened(&surface.name),
        surface.kind.to_owned(),
        format!("{u} x {v}"),
        match surface.gaussian {
            Some([low, high]) => format!("{} to {}", number(low), number(high)),
            None => "unbounded".to_owned(),
        },
        surface.radius.map_or("-".to_owned(), number),
        number(surface.area),
    ]
}

/// Returns the strips of a cover.
fn strips(cover: &SurfaceCover) -> String {
    let across = if cover.along == "u" { "v" } else { "u" };
    let row = |strip: &CoveringStrip| {
        vec![
            shortened(&strip.name),
            format!("{} to {}", number(strip.range[0]), number(strip.range[1])),
            format!("at most {}", at_most(strip.distance)),
            strip.fold.map_or("-".to_owned(), |[least, most]| {
                format!("{}° to {}°", number(least), number(most))
            }),
        ]
    };
    let edges = format!("{across} of edges");
    let heads = ["strip", edges.as_str(), "from surface", "fold to next"];
    let rows = cover.strips.iter().map(row);
    let mut text = columns(&heads, &rows.collect::<Vec<_>>());
    let fewer = match (cover.strips.len(), cover.fewest) {
        (1, _) => "",
        (_, true) => "; with one less along these curves no cover was found",
        (_, false) => "; whether fewer would do was not searched to the end",
    };
    let (many, covers) = match cover.strips.len() {
        1 => ("one strip".to_owned(), "covers"),
        count => (format!("{count} strips"), "cover"),
    };
    let note = format!(
        "{many} along {} {covers} `{}` within {} mm, proved both ways{fewer}. Fold angles are measured",
        cover.along,
        cover.surface,
        number(cover.within)
    );
    text.push_str(&wrapped(&format!("{}: ", cover.name), &note));
    text
}

fn joint(joint: &JointReport) -> Vec<String> {
    let [first, second] = &joint.patches;
    let betas: Vec<String> = joint
        .betas
        .iter()
        .filter(|list| !list.is_empty())
        .map(|list| {
            list.iter()
                .map(|b| number(*b))
                .collect::<Vec<_>>()
                .join(", ")
        })
        .collect();
    vec![
        format!("{} | {}", shortened(first), shortened(second)),
        number(joint.gap),
        format!("{}°", number(joint.kink)),
        joint.smoothness(),
        betas.join("; "),
    ]
}

fn shortened(name: &str) -> String {
    let count = name.chars().count();
    if count <= MAX_NAME_CHARS {
        return name.to_owned();
    }
    let kept: String = name.chars().take(MAX_NAME_CHARS - 1).collect();
    kept + "…"
}

fn bounds(bounds: ValueBounds) -> String {
    match (bounds.low, bounds.high) {
        (Some(low), Some(high)) if low == high => number(low),
        (Some(low), Some(high)) => format!("{} to {}", number(low), number(high)),
        (Some(low), None) => format!("over {}", number(low)),
        (None, Some(high)) => format!("at most {}", number(high)),
        (None, None) => "unknown".to_owned(),
    }
}

/// Returns what is said of a tolerance that is missed, in lines of at most 100 columns.
#[must_use]
pub fn missed_line(reason: &str) -> String {
    wrapped("missed: ", reason)
}
