//! The PNG writer: the scene drawn with anti-aliasing at two pixels per unit.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, Pixmap, PixmapPaint, PremultipliedColorU8, Stroke,
    StrokeDash, Transform,
};

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::ink::font::Fonts;
use crate::ink::scene::{Glyph, Item, Pixels, Scene, Turn};

/// Pixels of the PNG per unit of the page.
pub(crate) const RESOLUTION: u32 = 2;

/// Draw the scene on white paper and encode it.
pub(crate) fn write(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    let (w, h) = (scene.width * RESOLUTION, scene.height * RESOLUTION);
    let mut page =
        Pixmap::new(w, h).ok_or_else(|| FigureError::Png(format!("{w} by {h} pixels")))?;
    page.fill(tiny_skia::Color::WHITE);
    for item in &scene.items {
        draw(&mut page, item)?;
    }
    // The page is opaque, so that alpha can go.
    let rgb: Vec<u8> = page
        .pixels()
        .iter()
        .flat_map(|p| [p.red(), p.green(), p.blue()])
        .collect();
    encode(w, h, png::ColorType::Rgb, &rgb)
}

fn draw(page: &mut Pixmap, item: &Item) -> Result<(), FigureError> {
    let scale = Transform::from_scale(RESOLUTION as f32, RESOLUTION as f32);
    match item {
        Item::Fill {
            path,
            colour,
            alpha,
        } => {
            page.fill_path(
                path,
                &paint(*colour, *alpha),
                FillRule::Winding,
                scale,
                None,
            );
        }
        Item::Stroke { path, line, alpha } => {
            page.stroke_path(
                path,
                &paint(line.colour, *alpha),
                &stroke(line),
                scale,
                None,
            );
        }
        Item::Type {
            glyphs,
            colour,
            rim,
        } => {
            let fonts = Fonts::get()?;
            let outlines: Vec<_> = glyphs
                .iter()
                .filter_map(|g| {
                    Some((
                        fonts.outline(g.style, g.id)?,
                        placement(g).post_concat(scale),
                        g.size,
                    ))
                })
                .collect();
            if *rim > 0.0 {
                for (path, place, size) in &outlines {
                    let line = Line::solid(Colour::PAPER, rim * 1000.0 / size);
                    page.stroke_path(
                        path,
                        &paint(Colour::PAPER, 1.0),
                        &stroke(&line),
                        *place,
                        None,
                    );
                }
            }
            for (path, place, _) in &outlines {
                page.fill_path(path, &paint(*colour, 1.0), FillRule::Winding, *place, None);
            }
        }
        Item::Image { x, y, pixels, .. } => {
            let (x, y) = ((x * RESOLUTION) as i32, (y * RESOLUTION) as i32);
            if let Some(image) = pixmap(pixels) {
                page.draw_pixmap(
                    x,
                    y,
                    image.as_ref(),
                    &PixmapPaint::default(),
                    Transform::identity(),
                    None,
                );
            }
        }
    }
    Ok(())
}

fn paint(colour: Colour, alpha: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.r, colour.g, colour.b, (alpha * 255.0).round() as u8);
    paint
}

fn stroke(line: &Line) -> Stroke {
    let lengths: Vec<f32> = line
        .dash
        .pattern()
        .iter()
        .map(|d| d * line.width as f32)
        .collect();
    Stroke {
        width: line.width as f32,
        line_cap: LineCap::Butt,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(lengths, 0.0),
        ..Stroke::default()
    }
}

fn placement(glyph: &Glyph) -> Transform {
    let s = (glyph.size / 1000.0) as f32;
    let (x, y) = (glyph.x as f32, glyph.y as f32);
    match glyph.turn {
        Turn::Across => Transform::from_row(s, 0.0, 0.0, s, x, y),
        Turn::Upwards => Transform::from_row(0.0, -s, s, 0.0, x, y),
        Turn::Along(way) => {
            let [cosine, sine] = way.map(|c| s * c as f32);
            Transform::from_row(cosine, sine, -sine, cosine, x, y)
        }
    }
}

fn pixmap(pixels: &Pixels) -> Option<Pixmap> {
    let mut map = Pixmap::new(pixels.width, pixels.height)?;
    for (to, from) in map.pixels_mut().iter_mut().zip(pixels.rgba.chunks_exact(4)) {
        if let &[r, g, b, a] = from {
            let times = |c: u8| ((u16::from(c) * u16::from(a) + 127) / 255) as u8;
            *to = PremultipliedColorU8::from_rgba(times(r), times(g), times(b), a).unwrap_or(*to);
        }
    }
    Some(map)
}

/// The image with its PNG file, coarsened to colour steps of at most 6/255 as far as the file would otherwise be larger
/// than `budget` bytes. Smooth shading costs most of a file; a step of 2 saves a quarter and nobody sees it.
pub(crate) fn compress(pixels: Pixels, budget: usize) -> Result<(Pixels, Vec<u8>), FigureError> {
    let file = |p: &Pixels| encode(p.width, p.height, png::ColorType::Rgba, &p.rgba);
    let mut coarse = (file(&pixels)?, None);
    for step in 2..=6u8 {
        if coarse.0.len() <= budget {
            break;
        }
        let mut rgba = pixels.rgba.clone();
        for pixel in rgba.chunks_exact_mut(4) {
            for sample in pixel.iter_mut().take(3) {
                *sample = (*sample / step * step).saturating_add(step / 2);
            }
        }
        let candidate = Pixels { rgba, ..pixels };
        coarse = (file(&candidate)?, Some(candidate));
    }
    let (png, coarse) = coarse;
    Ok((coarse.unwrap_or(pixels), png))
}

/// A PNG file of 8-bit samples.
pub(crate) fn encode(
    width: u32,
    height: u32,
    colour: png::ColorType,
    samples: &[u8],
) -> Result<Vec<u8>, FigureError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Balanced);
    // Measured on the gallery: no filter is 10 to 20 % smaller than every other, and twice as fast. Flat
    // colours and slow gradients repeat whole pixels, which filters hide from the compressor.
    encoder.set_filter(png::Filter::NoFilter);
    // 96 units of the page to the inch.
    let per_metre = (f64::from(96 * RESOLUTION) / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    let fail = |e: png::EncodingError| FigureError::Png(e.to_string());
    let mut writer = encoder.write_header().map_err(fail)?;
    writer.write_image_data(samples).map_err(fail)?;
    writer.finish().map_err(fail)?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise() -> Pixels {
        let mut state = 1u32;
        let rgba = (0..64 * 64 * 4).map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        });
        Pixels {
            width: 64,
            height: 64,
            rgba: rgba.collect(),
        }
    }

    #[test]
    fn an_image_within_its_budget_is_kept_exactly() {
        assert_eq!(compress(noise(), 100_000).unwrap().0, noise());
    }

    #[test]
    fn an_image_beyond_its_budget_is_changed_by_at_most_three_and_its_alpha_by_nothing() {
        let (coarse, png) = compress(noise(), 1000).unwrap();
        let exact = compress(noise(), usize::MAX).unwrap().1;
        assert!(png.len() < exact.len());
        for (k, (a, b)) in coarse.rgba.iter().zip(noise().rgba).enumerate() {
            assert!(a.abs_diff(b) <= if k % 4 == 3 { 0 } else { 3 }, "{a} {b}");
        }
    }
}
