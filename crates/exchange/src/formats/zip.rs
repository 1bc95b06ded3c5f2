//! ZIP archives of deflated parts, with the date of the format's epoch (1980-01-01).

use crate::error::{ExchangeError, Result};
use miniz_oxide::deflate::compress_to_vec;

const DATE: u16 = 0x0021;
const VERSION: u16 = 20;
/// The method of deflated parts.
const DEFLATED: u16 = 8;
/// How hard it is tried, of 10: beyond, a mesh shrinks by another hundredth and takes twice as long.
const LEVEL: u8 = 6;

/// The archive of these named parts.
pub(super) fn archive(parts: &[(&str, &[u8])]) -> Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut directory = Vec::new();
    for (name, data) in parts {
        let offset = word(file.len())?;
        let packed = compress_to_vec(data, LEVEL);
        let mut common = Vec::new();
        for half in [VERSION, 0, DEFLATED, 0, DATE] {
            common.extend(half.to_le_bytes());
        }
        for full in [checksum(data), word(packed.len())?, word(data.len())?] {
            common.extend(full.to_le_bytes());
        }
        common.extend(half(name.len()).to_le_bytes());
        common.extend([0, 0]);

        file.extend(b"PK\x03\x04");
        file.extend(&common);
        file.extend(name.as_bytes());
        file.extend(packed);

        directory.extend(b"PK\x01\x02");
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&common);
        // No comment, one disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let start = word(file.len())?;
    file.extend(&directory);
    file.extend(b"PK\x05\x06\0\0\0\0");
    for _ in 0..2 {
        file.extend(half(parts.len()).to_le_bytes());
    }
    file.extend(word(directory.len())?.to_le_bytes());
    file.extend(start.to_le_bytes());
    file.extend([0, 0]);
    Ok(file)
}

/// Names and counts are ours and short.
fn half(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}

fn word(n: usize) -> Result<u32> {
    u32::try_from(n).map_err(|_| ExchangeError::TooMany {
        what: "bytes of an archive",
        given: n,
        most: 0xffff_ffff,
    })
}

/// CRC-32 (polynomial 0x04c11db7, reflected), four bits at a time.
fn checksum(data: &[u8]) -> u32 {
    const POLYNOMIAL: u32 = 0xedb8_8320;
    let mut table = [0_u32; 16];
    for (slot, n) in table.iter_mut().zip(0_u32..) {
        *slot = (0..4).fold(n, |r, _| (r >> 1) ^ (POLYNOMIAL & (r & 1).wrapping_neg()));
    }
    let step = |r: u32| (r >> 4) ^ table.get((r & 15) as usize).copied().unwrap_or(0);
    !data
        .iter()
        .fold(!0_u32, |r, byte| step(step(r ^ u32::from(*byte))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_of_the_digits_is_the_published_one() {
        assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(checksum(b""), 0);
    }
}
