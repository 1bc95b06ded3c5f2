//! The rails of a sheet: those of the patch that it is.

use super::Rail;
use super::surface::{Construction, Sheet};
use crate::coordinate::Coordinate;
use crate::error::Result;
use crate::model::ChebyshevModel;
use crate::surface::{EndKinds, Rails};
use torse_algebra::{Ball, Jet};

/// Evaluates an expression for the patch of a construction, whichever it is.
macro_rules! each_construction {
    ($construction:expr, $patch:ident => $value:expr) => {
        match $construction {
            Construction::Ruled($patch) => $value,
            Construction::Cylinder($patch) => $value,
            Construction::Cone($patch) => $value,
            Construction::Envelope($patch) => $value,
            Construction::Tangent($patch) => $value,
            Construction::Connecting($patch) => $value,
            Construction::Part($patch) => $value,
        }
    };
}

/// A connecting patch has rails over these scalars alone, hence no sheet has them over all.
macro_rules! rails_over {
    ($($scalar:ty),*) => {$(
        impl Rails<$scalar> for Sheet<$scalar> {
            fn rail_jets(&self, x: &$scalar, order: usize) -> Result<[[Jet<$scalar>; 3]; 2]> {
                each_construction!(&self.construction, patch => patch.rail_jets(x, order))
            }

            fn ruling_ends(&self, x: &$scalar) -> Result<[[$scalar; 3]; 2]> {
                each_construction!(&self.construction, patch => patch.ruling_ends(x))
            }

            fn ends_and_slopes(&self, x: &$scalar) -> Result<[[[$scalar; 3]; 2]; 2]> {
                each_construction!(&self.construction, patch => patch.ends_and_slopes(x))
            }

            fn is_developable_by_construction(&self) -> bool {
                match &self.construction {
                    Construction::Ruled(_) => self.exact,
                    Construction::Part(part) => part.is_developable_by_construction(),
                    Construction::Cylinder(_)
                    | Construction::Cone(_)
                    | Construction::Envelope(_)
                    | Construction::Tangent(_)
                    | Construction::Connecting(_) => true,
                }
            }

            fn end_kinds(&self) -> EndKinds {
                match &self.construction {
                    Construction::Ruled(patch) => ruled_kinds(patch.first(), patch.second()),
                    Construction::Cylinder(patch) => patch.end_kinds(),
                    Construction::Cone(patch) => patch.end_kinds(),
                    Construction::Part(part) => part.end_kinds(),
                    Construction::Connecting(patch) => {
                        let (first, second) = patch.curves();
                        EndKinds::of_ordinary([first.end_kinds(), second.end_kinds()])
                    }
                    Construction::Envelope(_) | Construction::Tangent(_) => EndKinds::default(),
                }
            }
        }
    )*};
}

rails_over!(f64, Ball, ChebyshevModel);

/// Returns the kinds of the ends of a patch between two rails.
fn ruled_kinds<S: Coordinate + PartialEq>(first: &Rail<S>, second: &Rail<S>) -> EndKinds {
    let [p, q] = [first, second].map(Rail::end_points);
    let kinds = [first.end_kinds(), second.end_kinds()];
    EndKinds::new(
        kinds,
        [0, 1].map(|end| p[end].is_some() && p[end] == q[end]),
    )
}
