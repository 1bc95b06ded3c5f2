//! The verdicts as JSON, written claim by claim from lines that [`crate::finding_json`] has made: memory does not grow with
//! their number.

use crate::ReportError;
use crate::glossary::{self, VERDICTS};
use serde::Deserialize;
use std::io::Write;
use torse_syntax::taxonomy::{Kind, Verdict};

/// Spaces before what stands one level deeper.
const INDENT: usize = 2;

/// Writes what [`crate::verdicts_json`] writes, byte for byte, from lines of [`crate::finding_json`].
///
/// ```
/// let mut json = torse_report::VerdictsWriter::new(vec![])?;
/// json.add(r#"{"id":"p/1","kind":"identity","verdict":"holds","readings":[]}"#)?;
/// let text = String::from_utf8(json.finish()?)?;
/// let begin = "{\n  \"claims\": [\n    {\n      \"id\": \"p/1\",";
/// assert!(text.starts_with(begin), "{text}");
/// assert!(text.contains("\"readings\": []\n    }\n  ],\n  \"totals\": {\n    \"claims\": 1,"), "{text}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct VerdictsWriter<W> {
    out: W,
    written: usize,
    /// By verdict, in the order of the tables; without remarks of ours.
    claims: Vec<(Verdict, usize)>,
    remarks: usize,
    proved: usize,
    conditional: usize,
}

/// What counts of a claim.
#[derive(Deserialize)]
struct Counted<'l> {
    kind: &'l str,
    verdict: &'l str,
}

impl<W: Write> VerdictsWriter<W> {
    /// Begins the list.
    ///
    /// # Errors
    /// [`ReportError::Stream`] if `out` fails.
    pub fn new(mut out: W) -> Result<Self, ReportError> {
        out.write_all(b"{\n  \"claims\": [")?;
        Ok(Self {
            out,
            written: 0,
            claims: VERDICTS.map(|verdict| (verdict, 0)).to_vec(),
            remarks: 0,
            proved: 0,
            conditional: 0,
        })
    }

    /// Adds a claim: one object of JSON without blanks between its parts.
    ///
    /// # Errors
    /// [`ReportError::Json`] for what is no such object, [`ReportError::Stream`] if the output fails.
    pub fn add(&mut self, claim: &str) -> Result<(), ReportError> {
        let counted: Counted<'_> = serde_json::from_str(claim)?;
        let is = |verdict| glossary::verdict(verdict).key == counted.verdict;
        let is_conditional = is(Verdict::Conditional);
        if counted.kind == glossary::kind(Kind::Remark).key {
            self.remarks += 1;
            self.proved += usize::from(is(Verdict::Holds) || is_conditional);
            self.conditional += usize::from(is_conditional);
        } else {
            let mut rows = self.claims.iter_mut();
            let row = rows.find(|(verdict, _)| glossary::verdict(*verdict).key == counted.verdict);
            if let Some((_, count)) = row {
                *count += 1;
            }
        }
        let separator = if self.written == 0 {
            "\n    "
        } else {
            ",\n    "
        };
        self.out.write_all(separator.as_bytes())?;
        self.out.write_all(indented(claim, 2).as_bytes())?;
        self.written += 1;
        Ok(())
    }

    /// Ends the list with the totals, and returns the output.
    ///
    /// # Errors
    /// [`ReportError::Stream`] if the output fails.
    pub fn finish(mut self) -> Result<W, ReportError> {
        let end = if self.written == 0 { "]" } else { "\n  ]" };
        let occurring = self.claims.iter().filter(|(_, count)| *count > 0);
        let rows: Vec<String> = occurring
            .map(|(verdict, count)| {
                let key = glossary::verdict(*verdict).key;
                format!("\n      \"{key}\": {count}")
            })
            .collect();
        let verdicts = match rows.is_empty() {
            true => "{}".to_owned(),
            false => format!("{{{}\n    }}", rows.join(",")),
        };
        let total: usize = self.claims.iter().map(|(_, count)| count).sum();
        let (remarks, proved, conditional) = (self.remarks, self.proved, self.conditional);
        write!(
            self.out,
            "{end},\n  \"totals\": {{\n    \"claims\": {total},\n    \"verdicts\": {verdicts},\n    \"remarks\": {{\n      \
             \"total\": {remarks},\n      \"proved\": {proved},\n      \"conditional\": {conditional}\n    }}\n  }}\n}}\n"
        )?;
        self.out.flush()?;
        Ok(self.out)
    }
}

/// Breaks JSON without blanks into lines, as `serde_json` does: a line for each member, empty lists and objects on one.
fn indented(compact: &str, depth: usize) -> String {
    let mut text = String::with_capacity(2 * compact.len());
    let mut depth = depth;
    let (mut quoted, mut escaped) = (false, false);
    let line = |text: &mut String, depth: usize| {
        text.push('\n');
        text.extend(std::iter::repeat_n(' ', INDENT * depth));
    };
    let mut characters = compact.trim_end().chars().peekable();
    while let Some(character) = characters.next() {
        if quoted {
            text.push(character);
            quoted = escaped || character != '"';
            escaped = !escaped && character == '\\';
            continue;
        }
        match character {
            '{' | '[' => {
                text.push(character);
                match characters.next_if(|next| matches!(next, '}' | ']')) {
                    Some(end) => text.push(end),
                    None => {
                        depth += 1;
                        line(&mut text, depth);
                    }
                }
            }
            '}' | ']' => {
                depth = depth.saturating_sub(1);
                line(&mut text, depth);
                text.push(character);
            }
            ',' => {
                text.push(character);
                line(&mut text, depth);
            }
            ':' => text.push_str(": "),
            _ => {
                quoted = character == '"';
                text.push(character);
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    #[test]
    fn lines_are_broken_as_the_serialiser_breaks_them() {
        let value = json!({
            "a": [], "b": {}, "c": [1, [2.5, null]], "d": { "e": "x\"{[,:\\", "f\\": "\\\"" }, "g": [{}, [], "é\n"],
        });
        let expected = serde_json::to_string_pretty(&value).unwrap();
        assert_eq!(indented(&value.to_string(), 0), expected);
    }

    #[test]
    fn what_is_no_claim_is_refused() {
        let mut json = VerdictsWriter::new(vec![]).unwrap();
        for line in ["", "{", "[]", r#"{"id":"p/1"}"#] {
            assert!(
                matches!(json.add(line), Err(ReportError::Json(_))),
                "{line}"
            );
        }
        let text = String::from_utf8(json.finish().unwrap()).unwrap();
        assert_eq!(text, crate::verdicts_json(&[]).unwrap());
        assert!(serde_json::from_str::<Value>(&text).is_ok());
    }
}
