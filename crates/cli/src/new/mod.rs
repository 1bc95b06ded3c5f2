//! `torse new`: a folder of derivation files to start from.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::{input, terminal};
use clap::Args;
use std::path::{Path, PathBuf};
use torse_manuscript::{ManuscriptError, Proposal};
use torse_report::write_file;
use torse_syntax::derivation::schema::DERIVATION_SCHEMA;

/// The files of a new folder; `NAME` stands for its name.
const FILES: [(&str, &str); 2] = [
    ("paper.toml", include_str!("paper.toml")),
    ("claims.toml", include_str!("claims.toml")),
];

/// The schema of derivation files, beside the folders of papers.
const SCHEMA: &str = "schema.json";

/// The line by which editors find it.
const SCHEMA_LINE: &str = "#:schema ../schema.json\n";

/// Write a folder of derivation files to start from.
///
/// With `--from`, torse reads one LaTeX file. Each numbered equation and each theorem becomes a claim with its words and
/// its place; if the print has one meaning, the claim has a statement, and if it has two, both stand in comments. torse
/// lists what it does not understand, with line and column, and the files that the text includes, which it does not read.
///
/// Without `--from`, the folder contains a basis with a shape parameter, two curves, four claims about them and a figure;
/// comments say what to change. Beside the folder torse puts the schema of these files, for editors, unless a file of that
/// name is there. torse never overwrites an existing file.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct New {
    /// The name of the folder: lower-case letters, digits and hyphens
    #[arg(value_name = "PAPER", value_parser = name)]
    paper: String,
    /// Read this manuscript in LaTeX; - for standard input
    #[arg(long, value_name = "FILE")]
    from: Option<PathBuf>,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse new my-paper
  torse new my-paper --from paper.tex && torse verify my-paper
  torse new my-paper --derivations my-papers && torse verify my-paper --derivations my-papers";

/// Checks that a name can begin an id and be the name of a report.
fn name(text: &str) -> Result<String, String> {
    let known = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let hyphen = text.starts_with('-') || text.ends_with('-');
    if text.is_empty() || hyphen || text == "summary" || !text.chars().all(known) {
        return Err("a name is made of small letters, digits and hyphens".to_owned());
    }
    Ok(text.to_owned())
}

impl New {
    /// Writes the files and lists them.
    pub fn run(&self) -> Result<Exit, Failure> {
        let derivations = self.derivations.place()?;
        let folder = derivations.join(&self.paper);
        if folder.exists() {
            return Err(Failure::Exists { path: folder });
        }
        let proposal = self.from.as_deref().map(|path| self.propose(path));
        let (files, more) = match proposal.transpose()? {
            Some(proposal) => {
                let more = summary(&proposal);
                let files = [
                    ("paper.toml", proposal.paper),
                    ("claims.toml", proposal.claims),
                ];
                (files, more)
            }
            None => {
                let named =
                    |(file, text): (&'static str, &str)| (file, text.replace("NAME", &self.paper));
                (FILES.map(named), String::new())
            }
        };
        let mut written = String::new();
        for (file, text) in files {
            let path = folder.join(file);
            write_file(&path, format!("{SCHEMA_LINE}{text}").as_bytes())?;
            written.push_str(&format!("{}\n", path.display()));
        }
        let schema = derivations.join(SCHEMA);
        if !schema.exists() {
            write_file(&schema, DERIVATION_SCHEMA.as_bytes())?;
            written.push_str(&format!("{}\n", schema.display()));
        }
        terminal::print(&format!("{written}{more}"))?;
        Ok(Exit::AsExpected)
    }

    /// Reads a manuscript.
    fn propose(&self, path: &Path) -> Result<Proposal, Failure> {
        let text = input::text(path)?;
        let manuscript = torse_manuscript::manuscript(&text).map_err(|error| {
            let place = match &error {
                ManuscriptError::Expansion { place, .. } => place.start,
                ManuscriptError::TooLong => 0,
            };
            let before = text.get(..place).unwrap_or(&text);
            Failure::Manuscript {
                path: path.to_owned(),
                line: before.matches('\n').count() + 1,
                reason: error.to_string(),
            }
        })?;
        Ok(torse::propose(&manuscript, &self.paper))
    }
}

/// What a person has to look at.
fn summary(proposal: &Proposal) -> String {
    let mut text = format!(
        "\n{} stated or defined, {} to choose, {} not understood\n",
        proposal.stated,
        proposal.to_choose,
        proposal.unread.len()
    );
    if proposal.unnumbered > 0 {
        text.push_str(&format!(
            "{} without a number, listed at the end of claims.toml\n",
            proposal.unnumbered
        ));
    }
    for unread in &proposal.unread {
        text.push_str(&format!(
            "{}:{} {}\n",
            unread.line, unread.column, unread.why
        ));
    }
    text
}
