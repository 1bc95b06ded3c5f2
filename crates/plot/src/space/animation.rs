//! Views that follow each other, as a GIF.

use std::borrow::Cow;

use gif::{DisposalMethod, Encoder, Frame, Repeat};

use crate::error::{FigureError, at_least, within};
use crate::ink::raster::RESOLUTION;
use crate::ink::scene::{Pixels, Rect};
use crate::space::camera::Projection;
use crate::space::mesh::{Builder, area_vectors};
use crate::space::raster::{SAMPLES, render};
use crate::space::vector::V3;
use crate::space::view::{Solid, View};

/// Views that are shown one by one and then backwards, for ever: on white paper, all in the place and at the scale in which
/// every one is seen whole. Of each view the solids are drawn, without their notes; what surrounds them is left out.
///
/// ```
/// use torse_plot::{Animation, Grid, Surface, View};
/// let bent = |k: f64| Grid::sample(17, 2, |u, v| [u, v, k * u * u]);
/// let views = [0.0, 0.5, 1.0].map(|k| Ok::<_, torse_plot::FigureError>(View::new().surface(Surface::new(bent(k)?))));
/// let views = views.into_iter().collect::<Result<Vec<_>, _>>()?;
/// let file = Animation { views, pause: 80, step: 5 }.gif([120, 90])?;
/// assert!(file.starts_with(b"GIF89a"));
/// # Ok::<(), torse_plot::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Animation {
    /// What is seen, from the first to the last; at least two. All are seen with the camera of the first.
    pub views: Vec<View>,
    /// How long the first and the last view are seen, in hundredths of a second.
    pub pause: u16,
    /// How long every other view is seen, in hundredths of a second.
    pub step: u16,
}

/// Room around the solids for the width of their lines, in pixels.
const ROOM: [f64; 4] = [4.0; 4];

/// Colours of the file; one number more stands for what does not change.
const MAX_COLOURS: usize = 255;
const UNCHANGED: u8 = 255;

/// Bits of a channel by which colours are told apart.
const BITS: u32 = 5;

impl Animation {
    /// Draws the file with this width and height in pixels, each 64 to 2048; the same views give the same bytes.
    ///
    /// # Errors
    /// As [`View::draw`]; [`FigureError::TooFew`] for less than two views.
    pub fn gif(&self, size: [u32; 2]) -> Result<Vec<u8>, FigureError> {
        for side in size {
            within("side of an animation", f64::from(side), 64.0, 2048.0)?;
        }
        at_least("views of an animation", 2, self.views.len())?;
        let frames = self.frames(size)?;
        let palette = Palette::of_frames(&frames);
        let indexed: Vec<Vec<u8>> = frames.iter().map(|frame| palette.indices(frame)).collect();
        let fail = |error: gif::EncodingError| FigureError::Gif(error.to_string());
        let [width, height] = size.map(|n| u16::try_from(n).unwrap_or(u16::MAX));
        let mut encoder =
            Encoder::new(Vec::new(), width, height, &palette.bytes()).map_err(fail)?;
        encoder.set_repeat(Repeat::Infinite).map_err(fail)?;
        let last = indexed.len() - 1;
        // There, and back to the one after the first.
        let order = (0..=last).chain((1..last).rev());
        let mut before: Option<&[u8]> = None;
        for index in order {
            let Some(now) = indexed.get(index) else {
                continue;
            };
            let mut frame = changed(before, now, width);
            frame.delay = if index == 0 || index == last {
                self.pause
            } else {
                self.step
            };
            encoder.write_frame(&frame).map_err(fail)?;
            before = Some(now);
        }
        encoder.into_inner().map_err(fail)
    }

    /// The colours of all views on paper, row by row.
    fn frames(&self, size: [u32; 2]) -> Result<Vec<Vec<[u8; 3]>>, FigureError> {
        let all: Vec<Solid> = self
            .views
            .iter()
            .flat_map(|view| view.solids.clone())
            .collect();
        let union = View {
            solids: all,
            ..self.views.first().cloned().unwrap_or_default()
        };
        let bounds = union.shown()?;
        let cloud: Vec<V3> = union.solids.iter().flat_map(Solid::points).collect();
        let page = Rect {
            x: 0.0,
            y: 0.0,
            w: f64::from(size[0]),
            h: f64::from(size[1]),
        };
        let axes = union.camera.resolve(&area_vectors(&union.solids), &cloud);
        let projection = Projection::fit(axes, &cloud, page.inset(ROOM));
        let draw = |view: &View| {
            view.check()?;
            let builder = Builder {
                projection: &projection,
                bounds: &bounds,
                page,
                fine: f64::from(RESOLUTION) * SAMPLES as f64,
                range: view.value_range()?,
            };
            // As fine as other pictures, so that lines are as thin; then a pixel is the mean of four.
            let [width, height] = size.map(|side| side * RESOLUTION);
            Ok(halved(&render(&builder.build(view), width, height)?))
        };
        self.views.iter().map(draw).collect()
    }
}

/// The colour of a pixel on white paper.
fn on_paper(pixel: &[u8]) -> [u8; 3] {
    let &[r, g, b, a] = pixel else {
        return [255; 3];
    };
    let a = u32::from(a);
    [r, g, b].map(|c| {
        let mixed = (u32::from(c) * a + 255 * (255 - a) + 127) / 255;
        u8::try_from(mixed).unwrap_or(255)
    })
}

/// The picture on paper with half as many pixels each way.
fn halved(pixels: &Pixels) -> Vec<[u8; 3]> {
    let columns = usize::try_from(pixels.width).unwrap_or(usize::MAX).max(2);
    let rows: Vec<&[u8]> = pixels.rgba.chunks_exact(4 * columns).collect();
    let pairs = rows.chunks_exact(2).flat_map(|rows| {
        let [upper, lower] = [0, 1].map(|k| rows.get(k).copied().unwrap_or_default());
        upper.chunks_exact(8).zip(lower.chunks_exact(8))
    });
    let mean = |(upper, lower): (&[u8], &[u8])| {
        let four = upper.chunks_exact(4).chain(lower.chunks_exact(4));
        let mut sums = [2_u32; 3];
        for colour in four.map(on_paper) {
            for (sum, c) in sums.iter_mut().zip(colour) {
                *sum += u32::from(c);
            }
        }
        sums.map(|sum| u8::try_from(sum / 4).unwrap_or(255))
    };
    pairs.map(mean).collect()
}

/// The box of the pixels that differ from those before, with what is the same in it left as it is; all where there are
/// none before, and one pixel where nothing differs.
fn changed<'p>(before: Option<&[u8]>, now: &'p [u8], width: u16) -> Frame<'p> {
    let columns = usize::from(width).max(1);
    let height = u16::try_from(now.len() / columns).unwrap_or(u16::MAX);
    let frame = Frame {
        dispose: DisposalMethod::Keep,
        ..Frame::default()
    };
    let Some(before) = before else {
        return Frame {
            width,
            height,
            buffer: Cow::Borrowed(now),
            ..frame
        };
    };
    let [mut left, mut right, mut top, mut bottom] = [columns, 0, usize::from(height), 0];
    for (place, _) in before
        .iter()
        .zip(now)
        .enumerate()
        .filter(|(_, (a, b))| a != b)
    {
        let (x, y) = (place % columns, place / columns);
        (left, right) = (left.min(x), right.max(x));
        (top, bottom) = (top.min(y), bottom.max(y));
    }
    if left > right {
        [left, right, top, bottom] = [0; 4];
    }
    let mut buffer = Vec::with_capacity((right - left + 1) * (bottom - top + 1));
    for row in top..=bottom {
        let range = row * columns + left..=row * columns + right;
        let old = before.get(range.clone()).unwrap_or_default();
        let new = now.get(range).unwrap_or_default();
        let pixels = old.iter().zip(new);
        buffer.extend(pixels.map(|(old, new)| if old == new { UNCHANGED } else { *new }));
    }
    let short = |n: usize| u16::try_from(n).unwrap_or(u16::MAX);
    Frame {
        left: short(left),
        top: short(top),
        width: short(right - left + 1),
        height: short(bottom - top + 1),
        transparent: Some(UNCHANGED),
        buffer: Cow::Owned(buffer),
        ..frame
    }
}

/// The colours that occur most, and for each cell of colours the nearest of them.
struct Palette {
    colours: Vec<[u8; 3]>,
    nearest: Vec<u8>,
}

/// The cell of a colour.
fn cell(colour: [u8; 3]) -> usize {
    let part = |c: u8| usize::from(c >> (8 - BITS));
    let [r, g, b] = colour;
    (part(r) << (2 * BITS)) | (part(g) << BITS) | part(b)
}

impl Palette {
    fn of_frames(frames: &[Vec<[u8; 3]>]) -> Self {
        let mut cells = vec![(0_u64, [0_u64; 3]); 1 << (3 * BITS)];
        for colour in frames.iter().flatten().copied() {
            if let Some((count, sums)) = cells.get_mut(cell(colour)) {
                *count += 1;
                for (sum, c) in sums.iter_mut().zip(colour) {
                    *sum += u64::from(c);
                }
            }
        }
        let mean = |(count, sums): &(u64, [u64; 3])| {
            sums.map(|sum| u8::try_from((sum + count / 2) / (*count).max(1)).unwrap_or(255))
        };
        let mut used: Vec<usize> = (0..cells.len())
            .filter(|index| cells.get(*index).is_some_and(|(count, _)| *count > 0))
            .collect();
        // The most frequent first; of equals the darker. The sort is stable.
        used.sort_by_key(|index| {
            std::cmp::Reverse(cells.get(*index).map_or(0, |(count, _)| *count))
        });
        let kept = used.iter().take(MAX_COLOURS);
        let colours: Vec<[u8; 3]> = kept
            .filter_map(|index| cells.get(*index))
            .map(mean)
            .collect();
        let mut nearest = vec![0; cells.len()];
        for index in used {
            let (Some(found), Some(slot)) = (cells.get(index), nearest.get_mut(index)) else {
                continue;
            };
            let own = mean(found);
            let away = |colour: &[u8; 3]| -> u32 {
                let parts = colour.iter().zip(own);
                parts.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
            };
            let best = colours
                .iter()
                .enumerate()
                .min_by_key(|(_, colour)| away(colour));
            *slot = best.map_or(0, |(place, _)| u8::try_from(place).unwrap_or(0));
        }
        Self { colours, nearest }
    }

    fn indices(&self, frame: &[[u8; 3]]) -> Vec<u8> {
        let index = |colour: &[u8; 3]| self.nearest.get(cell(*colour)).copied().unwrap_or(0);
        frame.iter().map(index).collect()
    }

    /// All 256 colours, so that the last number is one.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.as_flattened().to_vec();
        bytes.resize(3 * (MAX_COLOURS + 1), 0);
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Grid, Surface};
    use gif::{ColorOutput, DecodeOptions};

    const SIZE: [u32; 2] = [90, 70];

    fn bending(shares: &[f64]) -> Animation {
        let view = |k: &f64| {
            let grid = Grid::sample(17, 2, |u, v| [u, v, k * u * u]).unwrap();
            View::new().surface(Surface::new(grid).lines(8, 0))
        };
        Animation {
            views: shares.iter().map(view).collect(),
            pause: 60,
            step: 4,
        }
    }

    /// The pictures that a viewer shows, one after the other, with their delays.
    fn shown(file: &[u8]) -> Vec<(u16, Vec<[u8; 3]>)> {
        let mut options = DecodeOptions::new();
        options.set_color_output(ColorOutput::RGBA);
        let mut decoder = options.read_info(file).unwrap();
        let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
        let mut canvas = vec![[0; 3]; width * height];
        let mut pictures = vec![];
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            let place = |k: usize| {
                let (x, y) = (k % usize::from(frame.width), k / usize::from(frame.width));
                (y + usize::from(frame.top)) * width + x + usize::from(frame.left)
            };
            for (k, pixel) in frame.buffer.chunks_exact(4).enumerate() {
                if pixel[3] == 255 {
                    canvas[place(k)] = [pixel[0], pixel[1], pixel[2]];
                }
            }
            pictures.push((frame.delay, canvas.clone()));
        }
        pictures
    }

    #[test]
    fn the_views_are_shown_there_and_back_and_the_file_has_the_same_bytes_again() {
        let animation = bending(&[0.0, 0.3, 0.6, 1.0]);
        let file = animation.gif(SIZE).unwrap();
        assert_eq!(file, animation.gif(SIZE).unwrap());
        let pictures = shown(&file);
        let delays: Vec<u16> = pictures.iter().map(|(delay, _)| *delay).collect();
        assert_eq!(delays, [60, 4, 4, 60, 4, 4]);
        assert_eq!(pictures[1].1, pictures[5].1);
        assert_eq!(pictures[2].1, pictures[4].1);
        for (k, (_, picture)) in pictures.iter().enumerate().take(4) {
            for (_, other) in pictures.iter().take(k) {
                assert_ne!(picture, other);
            }
        }
    }

    #[test]
    fn what_is_shown_are_the_pixels_that_were_rendered_to_within_a_cell_of_colours() {
        let animation = bending(&[0.0, 1.0]);
        let frames = animation.frames(SIZE).unwrap();
        let pictures = shown(&animation.gif(SIZE).unwrap());
        for (frame, (_, picture)) in frames.iter().zip(&pictures) {
            let white = frame.iter().filter(|pixel| **pixel == [255; 3]).count();
            assert!(white > 500 && white < 6000, "{white}");
            assert_eq!(frame.len(), picture.len());
            for (rendered, shown) in frame.iter().zip(picture) {
                let away = rendered
                    .iter()
                    .zip(shown)
                    .map(|(a, b)| a.abs_diff(*b))
                    .max();
                assert!(away.unwrap() <= 1 << (9 - BITS), "{rendered:?} {shown:?}");
            }
        }
    }

    #[test]
    fn one_view_is_no_animation() {
        let error = bending(&[1.0]).gif(SIZE).unwrap_err();
        assert!(
            matches!(
                error,
                FigureError::TooFew {
                    needed: 2,
                    got: 1,
                    ..
                }
            ),
            "{error}"
        );
    }
}
