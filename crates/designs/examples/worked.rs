//! Makes the pictures, patterns and reports of the worked designs anew:
//!
//! ```text
//! cargo run -p torse-designs --example worked -- designs
//! ```
//!
//! For each `NAME.toml` of the folder it writes `NAME.png`, `NAME.dxf` and `NAME.txt`, the same bytes on every run.

use std::error::Error;
use std::path::PathBuf;
use torse_designs::export::bytes;
use torse_designs::inspect::{inspect, table};
use torse_designs::unroll::{Demand, PartsList, PatternSummary, parts, unroll};
use torse_designs::{DesignError, draw, load};
use torse_exchange::write_file;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args()
        .nth(1)
        .ok_or("name the folder of the designs")?;
    let mut designs: Vec<PathBuf> = std::fs::read_dir(&folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<std::io::Result<_>>()?;
    designs.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    designs.sort();
    for path in designs {
        let design = match load(&path) {
            Err(DesignError::Wrong { mistakes }) => {
                for mistake in mistakes {
                    eprintln!("{:?}", miette::Report::new(mistake));
                }
                continue;
            }
            other => other?,
        };
        let demand = Demand::default();
        let mut text = table(&inspect(&design)?);
        text.push('\n');
        let pieces = unroll(&design, &demand)?;
        let patterns = PatternSummary::new(&design, &pieces);
        text.push_str(&PartsList::new(&design, &parts(&design, &pieces)?).text(&patterns));
        write_file(&path.with_extension("txt"), text.as_bytes())?;
        write_file(
            &path.with_extension("dxf"),
            &bytes(&design, "dxf", &demand)?,
        )?;
        write_file(
            &path.with_extension("png"),
            &draw::picture(&design, &demand)?.png()?,
        )?;
        println!("{}", design.name);
    }
    Ok(())
}
