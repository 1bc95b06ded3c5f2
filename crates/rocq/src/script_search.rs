//! Finds the scripts that prove theorems: each is tried alone, with a limit of time, in the order of the files.
//!
//! Only a run shows whether a tactic closes a goal. A theorem whose scripts fail gets no proof in the folder and is
//! reported as missing: a failing script says nothing against the claim.

use crate::check::PROOFS;
use crate::coqc::{Coqc, Limits, each_section, lay_out, prefixes};
use crate::folder::Folder;
use crate::kernel_error::KernelError;
use crate::modules::split;
use crate::printed;
use crate::process::{limited, run};
use crate::theorem::Theorem;
use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;
use std::time::Duration;

/// The theorems that a module may have, and what the failure of a script means.
const SCRIPTS: [(&str, &str); 3] = [
    ("proved", "the tactics find no proof"),
    ("refuted", "the tactics find no refutation"),
    ("met", "no values are found that meet all premises"),
];

/// What the failure of a printed theorem means.
const NOT_FOLLOWING: &str = "what is printed does not follow from what is proved";

/// Callback: receives the tried theorems of a section, and the failures.
pub type Found<'a> = dyn Fn(&[String], &BTreeMap<String, String>) + Sync + 'a;

/// Returns the theorems of a folder whose scripts find no proof within `seconds` each, with the reason. `found` is
/// called for each section with the tried theorems and the failures. The [library](Coqc::library) has been compiled in
/// `scratch`.
///
/// # Errors
/// [`KernelError`] if nothing can be run.
pub fn failing(
    coqc: &Coqc,
    folder: &Folder,
    scratch: &Path,
    seconds: u64,
    limits: Limits,
    found: &Found<'_>,
) -> Result<BTreeMap<String, String>, KernelError> {
    lay_out(folder, scratch)?;
    let of_section = |section: &str| {
        let failing = section_failing(coqc, folder, section, scratch, seconds, limits)?;
        let failing: BTreeMap<String, String> = failing.into_iter().collect();
        let theorems = folder.theorems_of(section);
        let names: Vec<String> = theorems.iter().map(|theorem| theorem.name()).collect();
        found(&names, &failing);
        Ok(failing)
    };
    let all = each_section(folder, limits.at_once, &|| (), &of_section)?;
    Ok(all.into_iter().flatten().collect())
}

fn section_failing(
    coqc: &Coqc,
    folder: &Folder,
    section: &str,
    scratch: &Path,
    seconds: u64,
    limits: Limits,
) -> Result<Vec<(String, String)>, KernelError> {
    let theorems = folder.theorems_of(section);
    let all = |why: &'static str| {
        let words = move |theorem: &&Theorem| (theorem.name(), why.to_owned());
        theorems.iter().map(words)
    };
    if let Some(core) = printed::proved(section) {
        coqc.run(scratch, &format!("{core}.v"), limits)?;
    }
    let statements = coqc.run(scratch, &format!("{section}.v"), limits)?;
    if !statements.status.success() {
        return Ok(all("the statement is not accepted").collect());
    }
    let forms = coqc.closed_forms(folder, section, scratch, limits)?;
    if forms.is_err() {
        return Ok(all("the definitions of the section have no closed forms").collect());
    }
    let proofs = folder.files.get(&format!("{section}{PROOFS}"));
    let is_printed = printed::proved(section).is_some();
    let head = split(proofs.map_or("", String::as_str)).head;
    let mut text = match is_printed {
        true => printed::head(section, head, &theorems),
        false => head.to_owned(),
    };
    // Printed statements are tried beside the proved ones, independently of their result.
    let proof = |theorem: &Theorem| match is_printed {
        true => printed::alone(theorem),
        false => theorem.proof.clone(),
    };
    for (place, theorem) in theorems.iter().enumerate() {
        text.push_str(&format!(
            "Definition mark_{place} := O.\nCheck mark_{place}.\n{}",
            tried(&proof(theorem), seconds)
        ));
    }
    let path = scratch.join(format!("{section}_trial.v"));
    let system = |source| KernelError::System {
        what: format!("cannot write {}", path.display()),
        source,
    };
    std::fs::write(&path, text).map_err(system)?;
    let mut command = limited("coqtop", limits.memory);
    command.args(["-q", "-w", "none"]).current_dir(scratch);
    for prefix in prefixes(scratch)? {
        command.arg("-Q").arg(&prefix).arg(&prefix);
    }
    command.stdin(File::open(&path).map_err(system)?);
    // The scripts have limits of their own, and the limit of their file is far above what any file of accepted proofs
    // takes.
    let whole = Duration::from_secs(60 + seconds * 2 * theorems.len() as u64);
    let output = run(&mut command, whole)?.text;
    let mut failed = vec![];
    for (place, theorem) in theorems.iter().enumerate() {
        let mark = |place| output.find(&format!("mark_{place}\n     : nat"));
        let to = mark(place + 1).unwrap_or(output.len());
        let part = mark(place)
            .and_then(|from| output.get(from..to))
            .unwrap_or("");
        let mut reasons = SCRIPTS.iter().filter(|(name, _)| {
            theorem.proof.contains(&format!("Theorem {name} :"))
                && !part.contains(&format!("{name}\n     : "))
        });
        if let Some((_, reason)) = reasons.next() {
            let reason = match is_printed {
                true => NOT_FOLLOWING,
                false => *reason,
            };
            failed.push((theorem.name(), reason.to_owned()));
        }
    }
    Ok(failed)
}

/// Writes a module of proofs in which every script has a limit of time, and failures are given up.
fn tried(proof: &str, seconds: u64) -> String {
    let mut text = String::new();
    let mut name = "";
    for line in proof.lines() {
        if let Some(rest) = line.strip_prefix("Theorem ") {
            name = rest.split(' ').next().unwrap_or("");
        }
        let script = line
            .strip_prefix("Proof. ")
            .and_then(|line| line.strip_suffix(". Qed."));
        match script {
            Some(script) => text.push_str(&format!(
                "Proof.\nTimeout {seconds} ({script}).\nQed.\nAbort All.\nCheck {name}.\n"
            )),
            None => {
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_script_gets_a_limit_of_time() {
        let proof = "Module a.\nTheorem proved : statement.\nProof. intros; ring. Qed.\nEnd a.\n";
        let wanted = "Module a.\nTheorem proved : statement.\nProof.\nTimeout 5 (intros; ring).\nQed.\nAbort All.\nCheck proved.\nEnd a.\n";
        assert_eq!(tried(proof, 5), wanted);
    }
}
