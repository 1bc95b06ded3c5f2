//! The end of the page: its sources, and links to its other forms.

use super::text::{Code, Doi, Text};
use crate::model::Report;
use std::fmt::{self, Write};

/// Writes the sources of the page, and the other forms of the report.
pub(super) fn write(out: &mut String, report: &Report) -> fmt::Result {
    let slug = Text(&report.slug);
    out.push_str("<h2 id=\"colophon\">Colophon</h2>\n<dl class=\"colophon\">\n");
    writeln!(
        out,
        "<dt>paper</dt><dd>{}: <em>{}</em>. {}</dd>",
        Text(&report.authors),
        Text(&report.title),
        Text(&report.venue)
    )?;
    if let Some(source) = &report.source {
        if let Some(doi) = &source.doi {
            writeln!(out, "<dt>identifier</dt><dd>{}</dd>", Doi(doi))?;
        }
        writeln!(
            out,
            "<dt>made by</dt><dd>torse {}, which gives the same bytes on every run</dd>\n\
             <dt>derivation files</dt><dd>SHA-256 <code>{}</code>, shown by {}</dd>",
            source.version,
            Text(&source.digest),
            Code(&source.command)
        )?;
    }
    let all = match report.has_neighbours {
        true => {
            ", <a href=\"verdicts.json\">verdicts for programs</a>, <a href=\"gallery.md\">all figures</a>"
        }
        false => "",
    };
    writeln!(
        out,
        "<dt>reproduce</dt><dd>{}</dd>\n\
         <dt>beside this page</dt><dd><a href=\"{slug}.pdf\">the report as PDF</a>, the corrections as a letter \
         (<a href=\"{slug}-erratum.pdf\">PDF</a>, <a href=\"{slug}-erratum.tex\">TeX</a>, <a href=\"{slug}-erratum.md\">Markdown</a>){all}</dd>\n</dl>",
        Code(&format!("torse verify {}", report.slug))
    )
}
