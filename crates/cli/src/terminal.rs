//! What the command shows: text on standard output, complaints and progress on standard error.
//!
//! Colours are written always and taken out again by anstream where nobody would see them, so that the
//! bytes of a redirected output do not depend on the terminal.

use crate::exit::Failure;
use comfy_table::{ContentArrangement, Table, presets};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, ThemeCharacters, ThemeStyles};
use owo_colors::{OwoColorize, Style};
use std::io::{ErrorKind, Write};
use std::time::Duration;
use torse_report::glossary;
use torse_syntax::taxonomy::Verdict;

/// The widest line of every text, in characters.
pub const WIDTH: u16 = 100;

/// Writes a text to standard output; a reader who has gone is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = anstream::stdout().lock();
    let written = output
        .write_all(text.as_bytes())
        .and_then(|()| output.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Print(error)),
        _ => Ok(()),
    }
}

/// Writes a text to standard error, for the reader beside the output proper.
pub fn remark(text: &str) {
    // Whoever closed standard error does not want to hear of it.
    let _ = anstream::stderr().write_all(text.as_bytes());
}

/// Shows a failure on standard error.
pub fn complain(failure: &Failure) {
    remark(&shown(failure));
}

/// A failure as text: message, place in the file with a caret, and what would help.
pub fn shown(failure: &dyn Diagnostic) -> String {
    let theme = GraphicalTheme {
        characters: ThemeCharacters {
            underline: '^',
            underbar: '^',
            ..ThemeCharacters::unicode()
        },
        styles: ThemeStyles::ansi(),
    };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(WIDTH.into())
        .with_links(false);
    let mut text = String::new();
    match handler.render_report(&mut text, failure) {
        Ok(()) => text,
        Err(_) => format!("{failure}\n"),
    }
}

/// A table without rules, columns two blanks apart, at most [`WIDTH`] wide.
pub fn table() -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(WIDTH);
    table
}

/// The lines of a table without blanks at their ends.
pub fn lines(table: &Table) -> String {
    let mut text = table.trim_fmt();
    text.push('\n');
    text
}

/// A text in lines of at most [`WIDTH`], each after `indent` blanks.
pub fn paragraph(indent: u16, text: &str) -> String {
    let mut table = table();
    table.add_row([text]);
    if let Some(column) = table.column_mut(0) {
        column.set_padding((indent, 0));
    }
    lines(&table)
}

/// The label of a verdict in its colour.
pub fn verdict(of: Verdict) -> String {
    let style = Style::new();
    let style = match of {
        Verdict::Holds | Verdict::Reproduced => style.green(),
        Verdict::Conditional | Verdict::Partial => style.cyan(),
        Verdict::Misprint => style.yellow().bold(),
        Verdict::False => style.red().bold(),
        Verdict::Undecided | Verdict::Vacuous | Verdict::Depends => style.magenta().bold(),
        Verdict::Definition | Verdict::Underspecified | Verdict::OutOfScope => style.dimmed(),
    };
    glossary::verdict(of).label.style(style).to_string()
}

/// A heading.
pub fn heading(text: &str) -> String {
    text.bold().to_string()
}

/// A progress bar on standard error: only on terminals, and only for work that takes its time.
pub struct Progress(ProgressBar);

impl Progress {
    /// Work of `steps` steps.
    pub fn new(what: &'static str, steps: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{prefix} {bar:40} {pos}/{len} {msg}") {
            bar.set_style(style);
        }
        bar.set_prefix(what);
        Progress(bar)
    }

    /// One step is done; called from any thread.
    pub fn step(&self) {
        self.0.inc(1);
        self.show();
    }

    /// What is being done now.
    pub fn doing(&self, what: &str) {
        self.0.set_message(what.to_owned());
        self.show();
    }

    /// The bar is taken away.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }

    fn show(&self) {
        const LONG: Duration = Duration::from_millis(500);
        // A bar on no terminal stays hidden whatever its target.
        if self.0.is_hidden() && self.0.elapsed() > LONG {
            self.0.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}
