//! Pictures as `data:` addresses.

use crate::Image;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// The picture as a `data:` address, for use in a quoted attribute.
///
/// Drawings stay text, with the few signs escaped that have a meaning in an address or an attribute: in base 64 a
/// drawing with pixels inside would carry them in base 64 twice.
pub(super) fn data_uri(image: &Image) -> String {
    let media_type = image.media_type();
    match image {
        Image::Svg(text) => format!("data:{media_type},{}", escaped(text)),
        Image::Png(bytes) => format!("data:{media_type};base64,{}", STANDARD.encode(bytes)),
    }
}

fn escaped(text: &str) -> String {
    let mut address = String::with_capacity(text.len() + text.len() / 8);
    for byte in text.bytes() {
        match byte {
            b'%' | b'#' | b'<' | b'>' | b'"' | b'\'' | b'&' | b'{' | b'}' | b'`' | b'\\' => {
                address.push_str(&format!("%{byte:02X}"));
            }
            b' '..=b'~' => address.push(char::from(byte)),
            _ => address.push_str(&format!("%{byte:02X}")),
        }
    }
    address
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_keeps_to_its_attribute_and_reads_as_before() {
        let drawing = "<svg id=\"a\">100% 'µ' &lt; #1</svg>\n";
        let address = data_uri(&Image::Svg(drawing.to_owned()));
        let content = address.strip_prefix("data:image/svg+xml,").unwrap();
        assert!(
            !content.contains(['<', '>', '"', '\'', '&', '#', '\n']),
            "{content}"
        );
        let mut bytes = Vec::new();
        let mut rest = content.bytes();
        while let Some(byte) = rest.next() {
            bytes.push(match byte {
                b'%' => {
                    let digits: Vec<u8> = rest.by_ref().take(2).collect();
                    u8::from_str_radix(std::str::from_utf8(&digits).unwrap(), 16).unwrap()
                }
                byte => byte,
            });
        }
        assert_eq!(String::from_utf8(bytes).unwrap(), drawing);
    }
}
