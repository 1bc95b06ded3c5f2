//! Output of the command: text on standard output, errors and progress on standard error.
//!
//! Colours are always written, and anstream removes them if the output is not a terminal, so the bytes of a redirected
//! output do not depend on the terminal.

use crate::exit::Failure;
use clap::error::ErrorKind;
use comfy_table::{ContentArrangement, Table, presets};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, ThemeCharacters, ThemeStyles};
use owo_colors::{OwoColorize, Style};
use std::io::{IsTerminal, Write};
use std::time::Duration;
use torse_report::glossary;
use torse_syntax::taxonomy::Verdict;

/// Maximum length of a line, in characters.
pub const WIDTH: u16 = 100;

/// Writes a text to standard output; a closed pipe is not a failure.
pub fn print(text: &str) -> Result<(), Failure> {
    write_to(anstream::stdout().lock(), text.as_bytes())
}

/// Writes bytes to standard output as they are; a closed pipe is not a failure.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    write_to(std::io::stdout().lock(), bytes)
}

fn write_to(mut output: impl Write, bytes: &[u8]) -> Result<(), Failure> {
    match output.write_all(bytes).and_then(|()| output.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::Print(error)),
        _ => Ok(()),
    }
}

/// Writes a text to standard error.
pub fn remark(text: &str) {
    // If standard error is closed, the text is lost.
    let _ = anstream::stderr().write_all(text.as_bytes());
}

/// Says on standard error how long a run took, to a reader at a terminal: what is written to a file or a pipe is the same on
/// every run.
pub fn tell_time(time: Duration) {
    if std::io::stderr().is_terminal() {
        remark(&format!("done in {}\n", in_minutes(time)));
    }
}

/// Writes a time in whole seconds, and in minutes from one minute on; a shorter one with a decimal.
fn in_minutes(time: Duration) -> String {
    match time.as_secs() {
        0..10 => format!("{:.1} s", time.as_secs_f64()),
        seconds @ 10..60 => format!("{seconds} s"),
        seconds => format!("{} min {} s", seconds / 60, seconds % 60),
    }
}

/// Shows a failure on standard error.
pub fn complain(failure: &Failure) {
    remark(&shown(failure));
}

/// Writes a failure as text: message, place in the file with a caret, and help.
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
        // Related failures come below empty headings.
        Ok(()) => text.replace("\nError: \n", "\n"),
        Err(_) => format!("{failure}\n"),
    }
}

/// Writes an error of the command line in the style of all others.
pub fn usage(error: &clap::Error) -> String {
    let text = error.render().ansi().to_string();
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return text;
    }
    let text = text.replacen("error:", "×", 1).replacen("tip:", "help:", 1);
    format!("  {text}")
}

/// Makes a table without rules, with columns two blanks apart, at most [`WIDTH`] wide.
pub fn table() -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(WIDTH);
    table
}

/// Returns the lines of a table without trailing blanks.
pub fn lines(table: &Table) -> String {
    let mut text = table.trim_fmt();
    text.push('\n');
    text
}

/// Breaks a text into lines of at most [`WIDTH`], each after `indent` blanks.
pub fn paragraph(indent: u16, text: &str) -> String {
    let mut table = table();
    table.add_row([text]);
    if let Some(column) = table.column_mut(0) {
        column.set_padding((indent, 0));
    }
    lines(&table)
}

/// Returns the label of a verdict in its colour.
pub fn verdict(verdict: Verdict) -> String {
    let style = Style::new();
    let style = match verdict {
        Verdict::Holds | Verdict::Reproduced => style.green(),
        Verdict::Conditional | Verdict::Partial => style.cyan(),
        Verdict::Misprint => style.yellow().bold(),
        Verdict::False => style.red().bold(),
        Verdict::Undecided | Verdict::Vacuous | Verdict::Depends => style.magenta().bold(),
        Verdict::Definition | Verdict::Underspecified | Verdict::OutOfScope => style.dimmed(),
    };
    glossary::verdict(verdict).label.style(style).to_string()
}

pub fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        // The first word is the noun: "remarks of ours".
        _ => match what.split_once(' ') {
            Some((word, rest)) => format!("{count} {word}s {rest}"),
            None => format!("{count} {what}s"),
        },
    }
}

/// A heading.
pub fn heading(text: &str) -> String {
    text.bold().to_string()
}

/// A progress bar on standard error: only on terminals, and only for long work.
pub struct Progress(ProgressBar);

impl Progress {
    /// Starts a bar for `steps` steps.
    pub fn new(what: &'static str, steps: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
        if let Ok(style) =
            ProgressStyle::with_template("{prefix} {bar:30} {pos}/{len}  {elapsed}  {msg}")
        {
            bar.set_style(style);
        }
        bar.set_prefix(what);
        Progress(bar)
    }

    /// Counts one step; may be called from any thread.
    pub fn step(&self) {
        self.0.inc(1);
        self.show();
    }

    /// Shows the current work.
    pub fn doing(&self, what: &str) {
        self.0.set_message(what.to_owned());
        self.show();
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }

    fn show(&self) {
        const LONG: Duration = Duration::from_millis(500);
        // Without a terminal the bar stays hidden, whatever its target.
        if self.0.is_hidden() && self.0.elapsed() > LONG {
            self.0.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::in_minutes;
    use std::time::Duration;

    #[test]
    fn a_time_is_told_in_the_units_of_a_reader() {
        let told = [400, 9_940, 10_000, 59_999, 60_000, 252_000].map(Duration::from_millis);
        assert_eq!(
            told.map(in_minutes),
            ["0.4 s", "9.9 s", "10 s", "59 s", "1 min 0 s", "4 min 12 s"]
        );
    }
}
