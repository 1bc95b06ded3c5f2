//! The symbols of a statement and their sets.

use crate::binder::Binder;
use crate::code::Code;
use crate::context::Context;
use crate::gap::Untranslatable;
use crate::integer::affine;
use crate::interval::within;
use std::sync::Arc;
use torse_core::Set;

/// Binds the symbols, integers first, since the index ranges of families name them.
pub(crate) fn binders(context: &mut Context<'_>) -> Result<Vec<Binder>, Untranslatable> {
    let symbols = context.symbols;
    let is_integer = |set: &Set| matches!(set, Set::Integer { .. });
    let integers = symbols.iter().filter(|(_, set)| is_integer(set));
    let others = symbols.iter().filter(|(_, set)| !is_integer(set));
    let mut binders = vec![];
    for (symbol, set) in integers.chain(others) {
        let name = context.symbol(symbol)?.to_owned();
        let symbol = Arc::clone(symbol);
        let coordinates = match set {
            Set::Vector(Some(n)) => Some((*n, 0)),
            Set::Family {
                dimension: Some(n @ 2..),
                ranges,
            } => Some((*n, ranges.len().max(1))),
            _ => None,
        };
        let Some((n, indices)) = coordinates else {
            let rocq_type = context.symbol_type(&symbol)?;
            binders.push(Binder {
                symbol,
                names: vec![name],
                rocq_type,
                together: None,
            });
            continue;
        };
        let names: Vec<String> = (1..=n)
            .map(|i| context.fresh(&format!("{name}'{i}")))
            .collect();
        let arguments: String = (0..indices).map(|i| format!(" i{i}")).collect();
        let entries: Vec<String> = names
            .iter()
            .map(|name| format!("{name}{arguments}"))
            .collect();
        let function = match indices {
            0 => String::new(),
            _ => format!("fun{arguments} => "),
        };
        binders.push(Binder {
            symbol,
            together: Some(format!(
                "let {name} := {function}[{}] in",
                entries.join("; ")
            )),
            names,
            rocq_type: format!("{}R", "Z -> ".repeat(indices)),
        });
    }
    Ok(binders)
}

/// Writes the declared sets.
pub(crate) fn domain(context: &Context<'_>) -> Result<Vec<Code>, Untranslatable> {
    let mut premises = vec![];
    for (symbol, set) in context.symbols {
        let name = context.symbol(symbol)?;
        match set {
            Set::Real(interval) => premises.extend(within(name, interval)),
            Set::Integer { least, most } => {
                let least = least
                    .as_ref()
                    .map(|form| affine(context, form))
                    .transpose()?;
                let most = most
                    .as_ref()
                    .map(|form| affine(context, form))
                    .transpose()?;
                let text = match (least, most) {
                    (Some(least), Some(most)) => format!("({least} <= {name} <= {most})%Z"),
                    (Some(least), None) => format!("({least} <= {name})%Z"),
                    (None, Some(most)) => format!("({name} <= {most})%Z"),
                    (None, None) => continue,
                };
                premises.push(Code::atom(text));
            }
            Set::Vector(_) | Set::Family { .. } => {}
        }
    }
    Ok(premises)
}
