//! Colour maps for a scalar on a surface.
//!
//! Both maps change lightness evenly, so that equal steps of the value look equal and the order survives grey print.

use crate::colour::Colour;

/// A map from 0..=1 to colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ColourMap {
    /// Dark violet over green to yellow, lightness rising throughout: for magnitudes such as a developability
    /// defect. Matplotlib's *viridis* (van der Walt and Smith, 2015) through the sextic fit by M. Zucker.
    #[default]
    Sequential,
    /// Blue over near-white to red, symmetric in lightness: for signed quantities such as mean curvature, on a
    /// range symmetric about zero.
    Diverging,
}

/// Coefficients of the sextic fit to viridis, constant term first, per sRGB channel.
const VIRIDIS: [[f64; 3]; 7] = [
    [0.277_727_327, 0.005_407_345, 0.334_099_805],
    [0.105_093_043, 1.404_613_530, 1.384_590_163],
    [-0.330_861_829, 0.214_847_559, 0.095_095_163],
    [-4.634_230_499, -5.799_100_973, -19.332_440_956],
    [6.228_269_936, 14.179_933_367, 56.690_552_601],
    [4.776_384_998, -13.745_145_378, -65.353_032_633],
    [-5.435_455_856, 4.645_852_612, 26.312_435_250],
];

/// Anchors of the diverging map at 0, 1/4, 1/2, 3/4, 1; both arms step evenly in lightness.
const DIVERGING: [Colour; 5] = [
    Colour::rgb(0x1f, 0x4e, 0x9e),
    Colour::rgb(0x7f, 0xa6, 0xd6),
    Colour::rgb(0xf3, 0xf1, 0xee),
    Colour::rgb(0xde, 0x8f, 0x78),
    Colour::rgb(0xa6, 0x2b, 0x25),
];

impl ColourMap {
    /// The colour at `t`, clamped to 0..=1.
    ///
    /// ```
    /// use torse_plot::ColourMap;
    /// let low = ColourMap::Sequential.at(0.0);
    /// let high = ColourMap::Sequential.at(1.0);
    /// assert!(low.luminance() < 0.03 && high.luminance() > 0.75);
    /// ```
    #[must_use]
    pub fn at(self, t: f64) -> Colour {
        let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        let channels = match self {
            ColourMap::Sequential => {
                [0, 1, 2].map(|k| VIRIDIS.iter().rev().fold(0.0, |acc, c| acc * t + c[k]))
            }
            ColourMap::Diverging => {
                let s = t * 4.0;
                let k = (s.floor() as usize).min(3);
                let (a, b, f) = (DIVERGING[k], DIVERGING[k + 1], s - k as f64);
                let blend =
                    |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * f) / 255.0;
                [blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b)]
            }
        };
        let [r, g, b] = channels.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
        Colour { r, g, b }
    }

    /// The map as `N` linear colours, for lookup per sample.
    pub(crate) fn table<const N: usize>(self) -> Vec<[f32; 3]> {
        (0..N)
            .map(|k| self.at(k as f64 / (N - 1) as f64).linear())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightness L* of CIE 1976, 0 to 100.
    fn lightness(colour: Colour) -> f64 {
        let y = f64::from(colour.luminance());
        if y > 0.008_856 {
            116.0 * libm::cbrt(y) - 16.0
        } else {
            903.3 * y
        }
    }

    #[test]
    fn lightness_of_the_sequential_map_rises_in_nearly_equal_steps() {
        let l: Vec<f64> = (0..=20)
            .map(|k| lightness(ColourMap::Sequential.at(f64::from(k) / 20.0)))
            .collect();
        let mean = (l[20] - l[0]) / 20.0;
        for pair in l.windows(2) {
            let step = pair[1] - pair[0];
            assert!(
                (0.5 * mean..1.5 * mean).contains(&step),
                "step {step}, mean {mean}"
            );
        }
    }

    #[test]
    fn the_diverging_map_is_lightest_in_the_middle_and_even_at_both_ends() {
        let l = |t: f64| lightness(ColourMap::Diverging.at(t));
        assert!(l(0.5) > 94.0);
        for k in 0..10 {
            let t = f64::from(k) / 20.0;
            assert!(l(t) < l(t + 0.05) && l(1.0 - t) < l(0.95 - t));
            assert!(
                (l(t) - l(1.0 - t)).abs() < 6.0,
                "at {t}: {} {}",
                l(t),
                l(1.0 - t)
            );
        }
    }
}
