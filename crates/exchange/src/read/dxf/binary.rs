//! Binary DXF as the text of the same groups.
//!
//! After 22 bytes that name the format come groups: a code and a value, whose kind the code tells (Autodesk's DXF
//! reference, "Group codes in numerical order"). Old files have codes of one byte, 255 before those of two; files since
//! R13 have codes of two bytes. Numbers are little-endian. Text has at least as many digits of each number as tell it from
//! its neighbours.

use crate::read::error::{ReadResult, at_line};
use std::fmt::Write;

/// What the file begins with.
pub(in crate::read) const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// How a value is written.
#[derive(Clone, Copy)]
enum ValueKind {
    /// Bytes up to a zero.
    Text,
    /// Eight bytes.
    Double,
    /// So many bytes with a sign.
    Whole(usize),
    /// A count and bytes.
    Bytes,
}

fn kind_of(code: i32) -> Option<ValueKind> {
    Some(match code {
        0..=9 | 100..=105 | 300..=309 | 320..=369 | 390..=399 | 410..=419 | 430..=439 => {
            ValueKind::Text
        }
        470..=481 | 999 | 1000..=1003 | 1005..=1009 => ValueKind::Text,
        10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => ValueKind::Double,
        60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
            ValueKind::Whole(2)
        }
        90..=99 | 420..=429 | 440..=459 | 1071 => ValueKind::Whole(4),
        160..=169 => ValueKind::Whole(8),
        290..=299 => ValueKind::Whole(1),
        310..=319 | 1004 => ValueKind::Bytes,
        _ => return None,
    })
}

/// The groups that are read, one after the other.
struct Source<'b> {
    bytes: &'b [u8],
    at: usize,
    line: usize,
}

impl<'b> Source<'b> {
    fn take(&mut self, count: usize) -> ReadResult<&'b [u8]> {
        let end = self.at.saturating_add(count);
        let Some(taken) = self.bytes.get(self.at..end) else {
            let reason = "the binary file ends in the middle of a group";
            return Err(at_line(self.line, reason));
        };
        self.at = end;
        Ok(taken)
    }

    fn whole(&mut self, count: usize) -> ReadResult<i64> {
        let taken = self.take(count)?;
        let mut all = if taken.last().is_some_and(|byte| *byte >= 128) {
            [0xff; 8]
        } else {
            [0; 8]
        };
        for (slot, byte) in all.iter_mut().zip(taken) {
            *slot = *byte;
        }
        Ok(i64::from_le_bytes(all))
    }

    fn double(&mut self) -> ReadResult<f64> {
        let mut all = [0; 8];
        all.copy_from_slice(self.take(8)?);
        Ok(f64::from_le_bytes(all))
    }

    fn text(&mut self) -> ReadResult<&'b [u8]> {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let Some(length) = rest.iter().position(|byte| *byte == 0) else {
            return Err(at_line(self.line, "a text of the binary file has no end"));
        };
        let taken = self.take(length)?;
        self.at += 1;
        Ok(taken)
    }

    fn code(&mut self, wide: bool) -> ReadResult<i32> {
        let code = if wide {
            self.whole(2)?
        } else {
            match self.take(1)? {
                [255] => self.whole(2)?,
                taken => i64::from(taken.first().copied().unwrap_or_default()),
            }
        };
        i32::try_from(code).map_err(|_| at_line(self.line, "no group code"))
    }
}

/// The text of a binary DXF file; its lines are those of the same file as text.
///
/// # Errors
/// A group code that means nothing, and a file that ends in the middle, with the line that the text would have.
pub(in crate::read) fn text_of(bytes: &[u8]) -> ReadResult<String> {
    let body = bytes.strip_prefix(SENTINEL).unwrap_or_default();
    // The first group is `0 SECTION`: a second zero is the rest of its code.
    let wide = body.get(1) == Some(&0);
    let mut source = Source {
        bytes: body,
        at: 0,
        line: 1,
    };
    let mut text = String::with_capacity(2 * body.len());
    while source.at < body.len() {
        let code = source.code(wide)?;
        let Some(kind) = kind_of(code) else {
            let reason = format!("{code} is no group code of a binary DXF file");
            return Err(at_line(source.line, reason));
        };
        // Writing to a string does not fail.
        let _ = match kind {
            ValueKind::Text => {
                let value = String::from_utf8_lossy(source.text()?);
                let one_line = value.replace(['\n', '\r'], " ");
                writeln!(text, "{code}\n{one_line}")
            }
            ValueKind::Double => {
                let value = source.double()?;
                writeln!(text, "{code}\n{value:?}")
            }
            ValueKind::Whole(count) => {
                let value = source.whole(count)?;
                writeln!(text, "{code}\n{value}")
            }
            ValueKind::Bytes => {
                let count = source.take(1)?.first().copied().unwrap_or_default();
                source.take(usize::from(count))?;
                writeln!(text, "{code}\n")
            }
        };
        source.line += 2;
        if text.ends_with("0\nEOF\n") {
            break;
        }
    }
    Ok(text)
}
