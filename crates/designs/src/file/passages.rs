//! What passes through sheets: a patch or a chain, found by its name when all of them are read.

use super::reader::{Named, Reader};
use crate::design::{Chain, Mark, MarkedOpening, Patch};
use torse_syntax::similar::similar;

/// Gives each opening for what passes through the patches that it names.
pub fn resolved(reader: &mut Reader, patches: &mut Named<Patch>, chains: &[Chain]) {
    let names: Vec<String> = patches.iter().map(|(name, _)| name.clone()).collect();
    let find = |name: &str| -> Option<Vec<usize>> {
        let chain = chains.iter().find(|chain| chain.name == name);
        chain.map(|chain| chain.patches.clone()).or_else(|| {
            let index = names.iter().position(|known| known == name);
            index.map(|index| vec![index])
        })
    };
    for (index, (own, patch)) in patches.iter_mut().enumerate() {
        let marks = patch.iter_mut().flat_map(|patch| &mut patch.marks);
        for mark in marks {
            let Mark::Opening(MarkedOpening::Passed {
                name,
                place,
                patches,
            }) = mark
            else {
                continue;
            };
            match find(name) {
                None => {
                    let known = names.iter().chain(chains.iter().map(|chain| &chain.name));
                    let near = similar(name, known.map(String::as_str));
                    let help = near.map(|near| format!("did you mean `{near}`?"));
                    let message = format!("no patch and no chain is called `{name}`");
                    reader.complain(place, message, &help.unwrap_or_default());
                }
                Some(found) if found.contains(&index) => {
                    let message = format!("`{name}` does not pass through `{own}`, of which it is");
                    reader.complain(place, message, "");
                }
                Some(found) => *patches = found,
            }
        }
    }
}
