//! Packs the insides of the claims and the notation: they are most of a page, and few readers open more than a few
//! claims.
//!
//! Without the script a claim opens to its printed sentence; the script inserts the rest on demand.

use crate::ReportError;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Compression of the highest level: pages are written once and read often.
const LEVEL: u8 = 9;

/// The insides of the claims, in the order of the page.
#[derive(Default)]
pub(super) struct Pack(Vec<String>);

impl Pack {
    /// Packs the inside of an element, and returns its number.
    pub fn add(&mut self, inside: String) -> usize {
        self.0.push(inside);
        self.0.len() - 1
    }

    /// Returns the element that holds them: a list in JSON, compressed (RFC 1951), in base 64.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] if the list cannot be written, which does not happen for strings.
    pub fn written(&self) -> Result<String, ReportError> {
        let list = serde_json::to_vec(&self.0)?;
        let packed = miniz_oxide::deflate::compress_to_vec(&list, LEVEL);
        let text = STANDARD.encode(&packed);
        Ok(format!(
            "<script type=\"application/octet-stream\" id=\"packed\">{text}</script>\n"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_comes_out_as_it_was() {
        let mut pack = Pack::default();
        assert_eq!(pack.add("<dt>α</dt>".to_owned()), 0);
        assert_eq!(pack.add("</script>\"".to_owned()), 1);
        let element = pack.written().unwrap();
        let text = element.split(['>', '<']).nth(2).unwrap();
        let packed = STANDARD.decode(text).unwrap();
        let list = miniz_oxide::inflate::decompress_to_vec(&packed).unwrap();
        let list: Vec<String> = serde_json::from_slice(&list).unwrap();
        assert_eq!(list, ["<dt>α</dt>", "</script>\""]);
    }
}
