//! How a piece continues another: the entries `join`, `beta` and `scale`.

use super::reader::{Entries, NumberKind, Reader, Value, accepted};
use torse_geometry::prelude::Joint;

/// How a piece continues another.
#[derive(Clone, Copy)]
enum Join {
    Parametric(usize),
    Beta(usize),
}

const JOINS: [(&str, Join); 6] = [
    ("C1", Join::Parametric(1)),
    ("C2", Join::Parametric(2)),
    ("C3", Join::Parametric(3)),
    ("Farin-Boehm", Join::Parametric(2)),
    ("G1", Join::Beta(1)),
    ("G2-beta", Join::Beta(2)),
];

/// Returns the entries `join`, `beta` and `scale`.
pub fn joint(reader: &mut Reader, entries: &mut Entries<'_>) -> Option<Joint> {
    let span = entries.span.clone();
    let join = match entries.take("join") {
        Some(value) => reader.word(value, "join", &JOINS),
        None => {
            let message = format!("{} lacks `join`", entries.what);
            let help = "`join` is one of `C1`, `C2`, `C3`, `Farin-Boehm`, `G1`, `G2-beta`";
            reader.complain(&span, message, help);
            None
        }
    };
    let beta_span = entries.has("beta");
    let betas = entries
        .take("beta")
        .map(|value| plain(reader, value, "beta values"));
    let scale = entries
        .take("scale")
        .map(|value| plain(reader, value, "scale values"));
    let made = match (join?, betas) {
        (Join::Parametric(order), None) => Ok(Joint::parametric(order)),
        (Join::Parametric(_), Some(_)) => {
            debug_assert!(beta_span);
            let help = "beta values belong to `G1` and `G2-beta`";
            reader.complain(&span, "this join has no beta values", help);
            return None;
        }
        (Join::Beta(count), betas) => {
            let betas = betas.unwrap_or(Some(Vec::new()))?;
            if betas.len() != count {
                let message = format!("{} beta values: this join has {count}", betas.len());
                let help = "`beta = [gamma]` for `G1`, `beta = [gamma, lambda]` for `G2-beta`";
                reader.complain(&span, message, help);
                return None;
            }
            Joint::beta(&betas)
        }
    };
    let made = match scale {
        Some(scale) => {
            let scale = scale?;
            made.and_then(|joint| joint.scaled(&scale))
        }
        None => made,
    };
    accepted(reader, &span, made)
}

fn plain(reader: &mut Reader, value: Value<'_>, what: &str) -> Option<Vec<f64>> {
    let items = reader.list(value, what, [1, 3])?;
    let all: Vec<_> = items
        .into_iter()
        .map(|item| reader.number(item, NumberKind::None))
        .collect();
    all.into_iter().collect()
}
