//! Flags a statement about nothing that the paper defines.

use super::{RaisedFlag, Subject, raised};
use torse_syntax::taxonomy::Flag;

/// Returns a statement that contains only names of the claim's own, or none.
pub(super) fn nothing_of_the_paper(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let formulas = &subject.formulas;
    let mut others = formulas
        .names
        .iter()
        .filter(|name| !formulas.local.contains(*name));
    match others.next() {
        Some(_) => vec![],
        None => {
            let evidence = "no symbol, basis or definition of the paper occurs in the statement";
            vec![raised(Flag::NothingOfThePaper, evidence)]
        }
    }
}
