//! Places of a text: bytes here, lines and UTF-16 units in the protocol.

use lsp_types::{Position, Range};

/// A text with the bytes at which its lines begin.
pub struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// Finds the lines of a text; they end with `\n`, `\r\n` or `\r`.
    pub fn new(text: &'t str) -> Self {
        let bytes = text.as_bytes();
        let ends = bytes.iter().enumerate().filter(|(at, byte)| match byte {
            b'\n' => true,
            b'\r' => bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        });
        let starts = std::iter::once(0).chain(ends.map(|(at, _)| at + 1));
        Self {
            text,
            starts: starts.collect(),
        }
    }

    /// Returns the place of a byte; of one within a letter, the place of the letter, and beyond the text its end.
    pub fn position(&self, byte: usize) -> Position {
        let byte = self.text.floor_char_boundary(byte);
        let line = self
            .starts
            .partition_point(|start| *start <= byte)
            .saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or(0);
        let before = self.text.get(start..byte).unwrap_or("");
        let units = before.encode_utf16().count();
        Position {
            line: u32::try_from(line).unwrap_or(u32::MAX),
            character: u32::try_from(units).unwrap_or(u32::MAX),
        }
    }

    /// Returns the range of these bytes.
    pub fn range(&self, bytes: &std::ops::Range<usize>) -> Range {
        Range {
            start: self.position(bytes.start),
            end: self.position(bytes.end),
        }
    }

    /// Returns the byte of a place: the end of the line for a unit beyond it, the end of the text for a line beyond it, and
    /// the beginning of the letter for the second half of one.
    pub fn byte(&self, position: Position) -> usize {
        let line = usize::try_from(position.line).unwrap_or(usize::MAX);
        let Some(start) = self.starts.get(line).copied() else {
            return self.text.len();
        };
        let end = self.starts.get(line.saturating_add(1)).copied();
        let line = self
            .text
            .get(start..end.unwrap_or(self.text.len()))
            .unwrap_or("");
        let line = line.trim_end_matches(['\r', '\n']);
        let mut left = usize::try_from(position.character).unwrap_or(usize::MAX);
        for (at, letter) in line.char_indices() {
            if left < letter.len_utf16() {
                return start + at;
            }
            left -= letter.len_utf16();
        }
        start + line.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    #[test]
    fn columns_are_counted_in_units_of_utf_16() {
        // One unit, two bytes; two units, four bytes; one unit, three bytes.
        let text = "μ = 1\r\n𝜇𝜇 = ∞\n\nz";
        let lines = Lines::new(text);
        for (needle, position) in [
            ("μ", at(0, 0)),
            (" = 1", at(0, 1)),
            ("𝜇𝜇", at(1, 0)),
            (" = ∞", at(1, 4)),
            ("z", at(3, 0)),
        ] {
            let byte = text.find(needle).unwrap_or(usize::MAX);
            assert_eq!(lines.position(byte), position, "{needle}");
            assert_eq!(lines.byte(position), byte, "{needle}");
        }
        assert_eq!(lines.byte(at(1, 7)), text.find("∞").unwrap_or(0));
        assert_eq!(lines.byte(at(1, 8)), text.find("\n\nz").unwrap_or(0));
    }

    #[test]
    fn places_that_are_in_no_line_are_the_ends_of_lines() {
        let text = "ab\r\n𝜇c";
        let lines = Lines::new(text);
        assert_eq!(lines.byte(at(0, 99)), 2);
        assert_eq!(lines.byte(at(9, 0)), text.len());
        // Between the halves of a letter.
        assert_eq!(lines.byte(at(1, 1)), 4);
        assert_eq!(lines.position(5), at(1, 0));
        assert_eq!(lines.position(999), at(1, 3));
        assert_eq!(Lines::new("").byte(at(0, 0)), 0);
    }
}
