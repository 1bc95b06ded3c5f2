//! Pixels for a screen: cropped to the drawing, coarser if a page needs it, with a palette.
//!
//! A shaded view has one or two paints under many lights; a palette of 256 colours holds them with steps that are
//! hardly visible, at a third of the size.

use rustc_hash::{FxHashMap, FxHashSet};

/// Straight pixels of red, green, blue and alpha, row by row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Pixels {
    width: u32,
    height: u32,
    rgba: Vec<[u8; 4]>,
}

impl Pixels {
    /// Reads a PNG file with 8 bits for each of the four channels.
    pub fn read(png: &[u8]) -> Option<Self> {
        let mut reader = png::Decoder::new(std::io::Cursor::new(png))
            .read_info()
            .ok()?;
        let mut samples = vec![0; reader.output_buffer_size()?];
        let frame = reader.next_frame(&mut samples).ok()?;
        if (frame.color_type, frame.bit_depth) != (png::ColorType::Rgba, png::BitDepth::Eight) {
            return None;
        }
        let (rgba, _) = samples.as_chunks::<4>();
        let rgba = rgba.get(..(frame.width as usize).checked_mul(frame.height as usize)?)?;
        Some(Self {
            width: frame.width,
            height: frame.height,
            rgba: rgba.to_vec(),
        })
    }

    /// Crops to the part that is not transparent; also returns its left and its upper margin. None if all is
    /// transparent.
    pub fn cropped(&self) -> Option<([u32; 2], Self)> {
        let seen = |[_, _, _, alpha]: &[u8; 4]| *alpha > 0;
        let (mut left, mut right, mut top, mut below) = (self.width, 0, self.height, 0);
        for (y, row) in (0..).zip(self.rgba.chunks(self.width.max(1) as usize)) {
            for (x, _) in (0..).zip(row).filter(|(_, pixel)| seen(pixel)) {
                (left, right) = (left.min(x), right.max(x + 1));
                (top, below) = (top.min(y), below.max(y + 1));
            }
        }
        if right <= left {
            return None;
        }
        let rows = self.rgba.chunks(self.width.max(1) as usize);
        let rows = rows.take(below as usize).skip(top as usize);
        let rgba = rows.filter_map(|row| row.get(left as usize..right as usize));
        let part = Self {
            width: right - left,
            height: below - top,
            rgba: rgba.flatten().copied().collect(),
        };
        Some(([left, top], part))
    }

    /// Returns width and height.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Scales to `share` quarters of the pixels on a side: each new pixel is the mean of those that it covers.
    pub fn quartered(&self, share: u32) -> Self {
        let side = |length: u32| (length * share).div_ceil(4).max(1);
        let (width, height) = (side(self.width), side(self.height));
        if share >= 4 || self.rgba.is_empty() {
            return self.clone();
        }
        let across: Vec<_> = (0..width).map(|k| covered(k, width, self.width)).collect();
        let mut rgba = Vec::with_capacity(width as usize * height as usize);
        for y in 0..height {
            let rows = covered(y, height, self.height);
            for columns in &across {
                let mut sums = [0_u64; 4];
                let mut weights = 0;
                for &(row, down) in &rows {
                    for &(column, weight) in columns {
                        let at = row as usize * self.width as usize + column as usize;
                        let Some([r, g, b, a]) = self.rgba.get(at) else {
                            continue;
                        };
                        let weight = weight * down;
                        let light = weight * u64::from(*a);
                        for (sum, c) in sums.iter_mut().zip([r, g, b]) {
                            *sum += light * u64::from(*c);
                        }
                        sums[3] += light;
                        weights += weight;
                    }
                }
                let [r, g, b] = [sums[0], sums[1], sums[2]].map(|sum| mean(sum, sums[3]));
                rgba.push([r, g, b, mean(sums[3], weights)]);
            }
        }
        Self {
            width,
            height,
            rgba,
        }
    }

    /// Writes a PNG file with a palette: colours in steps of at least `finest`, as fine as 256 colours allow.
    pub fn indexed(&self, finest: u8) -> Option<Vec<u8>> {
        let mut met = FxHashSet::default();
        let colours: Vec<[u8; 4]> = self
            .rgba
            .iter()
            .filter(|pixel| met.insert(**pixel))
            .copied()
            .collect();
        (finest.max(1)..=64)
            .step_by(2)
            .find_map(|step| self.file(&Palette::from_colours(&colours, step)?))
    }

    fn file(&self, palette: &Palette) -> Option<Vec<u8>> {
        let samples = self.rgba.iter().map(|pixel| palette.places.get(pixel));
        let samples: Option<Vec<u8>> = samples.map(Option::<&u8>::copied).collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        let opaque = palette.colours.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]);
        encoder.set_palette(opaque.collect::<Vec<u8>>());
        encoder.set_trns(palette.colours.iter().map(|c| c[3]).collect::<Vec<u8>>());
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        let mut writer = encoder.write_header().ok()?;
        writer.write_image_data(&samples?).ok()?;
        writer.finish().ok()?;
        Some(file)
    }
}

/// A palette of stepped colours, with the index of each colour of a picture.
struct Palette {
    colours: Vec<[u8; 4]>,
    places: FxHashMap<[u8; 4], u8>,
}

impl Palette {
    /// Makes a palette for these colours, in order of first use; none if 256 do not suffice.
    fn from_colours(colours: &[[u8; 4]], step: u8) -> Option<Self> {
        let mut numbers: FxHashMap<[u8; 4], u8> = FxHashMap::default();
        let (mut own, mut places) = (vec![], FxHashMap::default());
        for colour in colours {
            let coarse = coarser(*colour, step);
            let number = match numbers.get(&coarse) {
                Some(number) => *number,
                None => {
                    let next = u8::try_from(own.len()).ok()?;
                    own.push(coarse);
                    numbers.insert(coarse, next);
                    next
                }
            };
            places.insert(*colour, number);
        }
        Some(Self {
            colours: own,
            places,
        })
    }
}

/// Returns the old pixels under the new one `k` of `new`, with the covered part of each.
fn covered(k: u32, new: u32, old: u32) -> Vec<(u32, u64)> {
    let (from, to) = (
        u64::from(k) * u64::from(old),
        u64::from(k + 1) * u64::from(old),
    );
    let new = u64::from(new);
    (from / new..to.div_ceil(new))
        .map(|pixel| {
            let part = ((pixel + 1) * new).min(to) - (pixel * new).max(from);
            (u32::try_from(pixel).unwrap_or(u32::MAX), part)
        })
        .collect()
}

fn mean(sum: u64, weights: u64) -> u8 {
    match weights {
        0 => 0,
        weights => u8::try_from((sum + weights / 2) / weights).unwrap_or(u8::MAX),
    }
}

/// Rounds a colour to a grid; half transparent pixels lie on edges, where colours are least visible.
fn coarser([r, g, b, a]: [u8; 4], step: u8) -> [u8; 4] {
    let near = |value: u8, step: u8| {
        let (value, step) = (u16::from(value), u16::from(step));
        u8::try_from((value + step / 2) / step * step).unwrap_or(u8::MAX)
    };
    let alpha = near(a, 51);
    let step = match alpha {
        0 => return [0; 4],
        255 => step,
        _ => step.saturating_mul(3),
    };
    [near(r, step), near(g, step), near(b, step), alpha]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc with decreasing shade on a transparent background.
    fn disc() -> Pixels {
        let rgba = (0..64 * 64).map(|k: i32| {
            let (x, y) = (k % 64 - 40, k / 64 - 30);
            let inside = x * x + y * y < 400;
            [0, (120 + x * 2) as u8, 200, if inside { 255 } else { 0 }]
        });
        Pixels {
            width: 64,
            height: 64,
            rgba: rgba.collect(),
        }
    }

    #[test]
    fn what_is_drawn_is_cropped_and_keeps_its_place() {
        let ([left, top], part) = disc().cropped().unwrap();
        assert_eq!((left, top, part.size()), (21, 11, [39, 39]));
        let at = |p: &Pixels, x: u32, y: u32| p.rgba[(y * p.width + x) as usize];
        assert_eq!(at(&part, 19, 19), at(&disc(), 40, 30));
        let nothing = Pixels {
            rgba: vec![[9, 9, 9, 0]; 4],
            width: 2,
            height: 2,
        };
        assert!(nothing.cropped().is_none());
    }

    #[test]
    fn fewer_pixels_are_means_and_nothing_bleeds_from_what_is_not_seen() {
        let half = disc().quartered(2);
        assert_eq!(half.size(), [32, 32]);
        assert_eq!(half.rgba[15 * 32 + 20], [0, 121, 200, 255]);
        assert!(half.rgba.iter().all(|[_, _, b, a]| *a == 0 || *b == 200));
        assert_eq!(disc().quartered(3).size(), [48, 48]);
        assert_eq!(disc().quartered(4), disc());
    }

    #[test]
    fn a_file_with_a_palette_holds_the_picture_within_its_steps() {
        let file = disc().indexed(4).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(&file));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut samples = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut samples).unwrap();
        for (found, [r, g, b, a]) in samples.chunks(4).zip(disc().rgba) {
            assert_eq!(found[3], a);
            let near = found.iter().zip([r, g, b]).all(|(x, y)| x.abs_diff(y) <= 2);
            assert!(a == 0 || near, "{found:?} {r} {g} {b}");
        }
    }
}
