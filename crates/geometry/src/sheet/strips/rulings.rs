//! The parameters of the rulings of a panel on both of its edges.

use crate::model::ChebyshevModel as Model;
use crate::sheet::{Construction, PanelKind, PanelPiece, Sheet};

/// Returns the parameters on both edges of a ruling of a piece.
pub(super) fn parameters(piece: &PanelPiece, x: f64) -> Option<[f64; 2]> {
    match piece.kind {
        PanelKind::Fan(_) => Some(piece.ranges.map(|[from, to]| from + (to - from) * x)),
        PanelKind::Arc => on_arc(&piece.sheet, x),
    }
}

fn on_arc(sheet: &Sheet, x: f64) -> Option<[f64; 2]> {
    match sheet.construction() {
        Construction::Connecting(patch) => patch.parameters_at(x),
        Construction::Ruled(_) => Some([x, x]),
        Construction::Part(part) => {
            let [from, to] = part.range();
            on_arc(part.whole(), from + (to - from) * x)
        }
        Construction::Cylinder(_)
        | Construction::Cone(_)
        | Construction::Envelope(_)
        | Construction::Tangent(_) => None,
    }
}

/// Returns the same over an interval of rulings, of the sheet of a piece over models.
pub(super) fn modelled(sheet: &Sheet<Model>, piece: &PanelPiece, x: &Model) -> Option<[Model; 2]> {
    match (piece.kind, sheet.construction()) {
        (PanelKind::Fan(_), _) => Some(piece.ranges.map(|[from, to]| {
            let [from, to] = [from, to].map(Model::exact);
            from + (to - from) * *x
        })),
        (PanelKind::Arc, Construction::Connecting(patch)) => patch.parameters(x),
        (PanelKind::Arc, Construction::Ruled(_)) => Some([*x, *x]),
        (PanelKind::Arc, Construction::Part(part)) => {
            let [from, to] = part.range();
            modelled(part.whole(), piece, &(*from + (*to - *from) * *x))
        }
        (
            PanelKind::Arc,
            Construction::Cylinder(_)
            | Construction::Cone(_)
            | Construction::Envelope(_)
            | Construction::Tangent(_),
        ) => None,
    }
}
