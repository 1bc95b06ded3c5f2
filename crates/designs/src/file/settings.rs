//! What a design is called, made of and judged by.

use super::reader::{Entries, NumberKind, Reader, Value};
use super::{edges, keys};
use crate::DesignUnit;
use crate::bending::{Bending, DesignedSurface, NeutralLine};
use crate::design::{DesignView, Material, Tolerances, USUAL_RULINGS};
use toml::de::DeValue;
use torse_geometry::pattern::BendingSheet as Metal;

/// The most rulings that are shown of a patch.
pub const MAX_RULINGS: f64 = 4097.0;

/// Title and unit.
pub struct DesignHead {
    pub title: String,
    pub unit: DesignUnit,
    pub allowance: f64,
}

pub fn head(reader: &mut Reader, section: Option<Value<'_>>, file: &str) -> DesignHead {
    let mut head = DesignHead {
        title: file.strip_suffix(".toml").unwrap_or(file).to_owned(),
        unit: DesignUnit::Millimetre,
        allowance: 0.0,
    };
    let entries = section.and_then(|value| reader.entries(value, "[design]", keys::DESIGN));
    let Some(mut entries) = entries else {
        return head;
    };
    if let Some(value) = entries.take("title") {
        let span = value.span();
        if let Some((title, _)) = reader.text(value, "a title") {
            if title.chars().any(char::is_control) || title.len() > 200 {
                reader.complain(&span, "a title is one line of at most 200 bytes", "");
            }
            head.title = title;
        }
    }
    if let Some(value) = entries.take("about") {
        reader.text(value, "a description");
    }
    if let Some(value) = entries.take("unit")
        && let Some(unit) = reader.word(value, "unit", &DesignUnit::ALL)
    {
        head.unit = unit;
        reader.unit = unit.millimetres();
    }
    if let Some(value) = entries.take("allowance")
        && let Some(allowance) = edges::allowance(reader, value)
    {
        head.allowance = allowance;
    }
    head
}

/// The most bytes of the name of a material.
const MAX_MATERIAL: usize = 80;
/// The words for a neutral line that follows a standard.
const STANDARDS: [(&str, &NeutralLine); 1] = [("DIN 6935", &NeutralLine::Din6935)];
/// The most rows of a table of K-factors.
const MAX_K_ROWS: usize = 64;

/// Returns the neutral line: a K-factor, a standard, or a table of inside radius over thickness and K-factor.
fn neutral(reader: &mut Reader, value: Value<'_>) -> Option<NeutralLine> {
    let share = |k: f64| (0.0..=1.0).contains(&k);
    let span = value.span();
    match value.get_ref() {
        DeValue::String(text) if text.starts_with("DIN") => {
            reader.word(value, "standard", &STANDARDS).cloned()
        }
        DeValue::Array(_) => {
            let items = reader.list(value, "rows of K-factors", [2, MAX_K_ROWS])?;
            let rows: Option<Vec<[f64; 2]>> = items
                .into_iter()
                .map(|item| reader.numbers(item, [NumberKind::None; 2]))
                .collect();
            let rows = rows?;
            let grows = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
            let positive = rows.iter().all(|[ratio, k]| *ratio >= 0.0 && share(*k));
            if !(grows && positive) {
                let message = "a row is an inside radius over the thickness, growing, and a K-factor in [0, 1]";
                reader.complain(&span, message, "");
                return None;
            }
            Some(NeutralLine::Table(rows))
        }
        _ => reader
            .number_in(value, NumberKind::None, "[0, 1]", share)
            .map(NeutralLine::Constant),
    }
}

/// Returns what it is made of, and how its blanks are found.
pub fn metal(
    reader: &mut Reader,
    section: Option<Value<'_>>,
) -> (Option<Material>, Option<String>, Bending) {
    let mut bending = Bending::USUAL;
    let entries = section.and_then(|value| reader.entries(value, "[sheet]", keys::SHEET));
    let Some(mut entries) = entries else {
        return (None, None, bending);
    };
    if let Some(value) = entries.take("k-factor")
        && let Some(neutral) = neutral(reader, value)
    {
        bending.neutral = neutral;
    }
    if let Some(value) = entries.take("surface")
        && let Some(surface) = reader.word(value, "surface", &DesignedSurface::ALL)
    {
        bending.surface = surface;
    }
    // What is rolled has its neutral line in the middle; the K-factor of one number is told for it as well.
    let k_factor = match bending.neutral {
        NeutralLine::Constant(k) => k,
        _ => 0.5,
    };
    let mut named = None;
    if let Some(value) = entries.take("material") {
        let span = value.span();
        if let Some((text, _)) = reader.text(value, "a material") {
            if text.chars().any(char::is_control) || text.len() > MAX_MATERIAL {
                let message = format!("a material is one line of at most {MAX_MATERIAL} bytes");
                reader.complain(&span, message, "");
            }
            named = Some(text);
        }
    }
    (material(reader, &mut entries, k_factor), named, bending)
}

fn material(reader: &mut Reader, entries: &mut Entries<'_>, k_factor: f64) -> Option<Material> {
    let thickness = match entries.take("thickness") {
        Some(value) => reader.number_in(value, NumberKind::Length, "(0, infinity)", |t| t > 0.0),
        None => {
            let help = "without a thickness leave the section out";
            reader.complain(&entries.span, "[sheet] lacks `thickness`", help);
            None
        }
    };
    let least_radius = entries.take("least-radius").map_or(Some(1.0), |value| {
        reader.number_in(value, NumberKind::None, "[0, infinity)", |r| r >= 0.0)
    });
    Some(Material {
        sheet: Metal::new(thickness?, k_factor).ok()?,
        least_radius: least_radius?,
    })
}

pub fn tolerances(reader: &mut Reader, section: Option<Value<'_>>) -> Tolerances {
    let mut tolerances = Tolerances::USUAL;
    let entries = section.and_then(|value| reader.entries(value, "[tolerances]", keys::TOLERANCES));
    let Some(mut entries) = entries else {
        return tolerances;
    };
    let positive = |value: f64| value > 0.0;
    let share = |value: f64| value > 0.0 && value < 1.0;
    let angle = |value: f64| value > 0.0 && value <= 90.0;
    type Rule<'a> = (
        &'a str,
        NumberKind,
        &'a str,
        &'a dyn Fn(f64) -> bool,
        &'a mut f64,
    );
    let mut fold = 0.0;
    let rules: [Rule<'_>; 9] = [
        (
            "outline",
            NumberKind::Length,
            "(0, infinity)",
            &positive,
            &mut tolerances.outline,
        ),
        (
            "strain",
            NumberKind::None,
            "(0, 1)",
            &share,
            &mut tolerances.strain,
        ),
        (
            "twist",
            NumberKind::None,
            "(0, 90]",
            &angle,
            &mut tolerances.twist,
        ),
        (
            "clearance",
            NumberKind::Length,
            "[0, infinity)",
            &|c| c >= 0.0,
            &mut tolerances.clearance,
        ),
        (
            "gap",
            NumberKind::Length,
            "(0, infinity)",
            &positive,
            &mut tolerances.gap,
        ),
        (
            "kink",
            NumberKind::None,
            "(0, 90]",
            &angle,
            &mut tolerances.kink,
        ),
        (
            "continuity",
            NumberKind::None,
            "(0, 1)",
            &share,
            &mut tolerances.continuity,
        ),
        (
            "surface",
            NumberKind::Length,
            "(0, infinity)",
            &positive,
            &mut tolerances.surface,
        ),
        (
            "fold",
            NumberKind::Length,
            "(0, infinity)",
            &positive,
            &mut fold,
        ),
    ];
    for (key, dimension, range, inside, slot) in rules {
        if let Some(value) = entries.take(key)
            && let Some(number) = reader.number_in(value, dimension, range, inside)
        {
            *slot = number;
        }
    }
    tolerances.fold = (fold > 0.0).then_some(fold);
    tolerances
}

pub fn view(reader: &mut Reader, section: Option<Value<'_>>) -> DesignView {
    let mut view = DesignView {
        angles: None,
        rulings: USUAL_RULINGS,
    };
    let entries = section.and_then(|value| reader.entries(value, "[view]", keys::VIEW));
    let Some(mut entries) = entries else {
        return view;
    };
    let azimuth = entries.take("azimuth").and_then(|value| {
        reader.number_in(value, NumberKind::None, "[-360, 360]", |a| a.abs() <= 360.0)
    });
    let elevation = entries.take("elevation").and_then(|value| {
        reader.number_in(value, NumberKind::None, "[-90, 90]", |a| a.abs() <= 90.0)
    });
    if azimuth.is_some() || elevation.is_some() {
        view.angles = Some([azimuth.unwrap_or(-60.0), elevation.unwrap_or(25.0)]);
    }
    if let Some(value) = entries.take("rulings") {
        let range = "2, 3, .. 4097";
        let whole = |n: f64| n.fract() == 0.0 && (2.0..=MAX_RULINGS).contains(&n);
        if let Some(count) = reader.number_in(value, NumberKind::None, range, whole) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let count = count as usize;
            view.rulings = count;
        }
    }
    view
}
