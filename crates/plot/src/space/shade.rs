//! Light: two lamps and a bright sky, fixed to the viewer, on matt paint with a soft gloss (Phong 1975, with
//! Blinn's half vector).

/// Reflection of a paint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Finish {
    /// For surfaces whose colour has no meaning.
    Glossy,
    /// For surfaces whose colour encodes a value: light may darken it a little, and never bleaches it.
    Matt,
}

struct Lamp {
    /// Unit direction towards the lamp: right, up, towards the viewer.
    towards: [f32; 3],
    strength: f32,
}

/// The key light from upper left and the fill light from the right.
const LAMPS: [Lamp; 2] = [
    Lamp {
        towards: [-0.48, 0.6, 0.64],
        strength: 0.62,
    },
    Lamp {
        towards: [0.8, 0.0, 0.6],
        strength: 0.16,
    },
];
const GROUND: f32 = 0.16;
const SKY: f32 = 0.36;
const GLOSS: f32 = 0.10;
const SHARPNESS: i32 = 36;

/// Linear light from paint of linear colour `albedo` whose unit normal `n` (right, up, towards) faces the viewer.
pub(crate) fn shade(n: [f32; 3], albedo: [f32; 3], finish: Finish) -> [f32; 3] {
    let mut light = GROUND + (SKY - GROUND) * (0.5 + 0.5 * n[1]);
    let mut gloss = 0.0;
    for lamp in &LAMPS {
        let l = lamp.towards;
        light += lamp.strength * dot(n, l).max(0.0);
        // The viewer is at (0, 0, 1).
        let half = [l[0], l[1], l[2] + 1.0];
        let length = dot(half, half).sqrt();
        gloss += lamp.strength * (dot(n, half) / length).max(0.0).powi(SHARPNESS);
    }
    match finish {
        Finish::Glossy => albedo.map(|c| c * light + GLOSS * gloss),
        Finish::Matt => albedo.map(|c| c * (0.55 + 0.45 * light)),
    }
}

pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lamps_have_unit_directions() {
        for lamp in &LAMPS {
            assert!((dot(lamp.towards, lamp.towards) - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn white_paint_is_never_overexposed_by_diffuse_light() {
        for i in 0..40 {
            for j in 0..40 {
                let (a, b) = (i as f32 * 0.16, j as f32 * 0.04);
                let n = [
                    libm::sinf(b) * libm::cosf(a),
                    libm::sinf(b) * libm::sinf(a),
                    libm::cosf(b),
                ];
                let [light, ..] = shade(n, [1.0; 3], Finish::Matt);
                assert!((0.5..=1.01).contains(&light), "{n:?}: {light}");
            }
        }
    }

    #[test]
    fn a_face_turned_from_both_lamps_sees_the_sky_only() {
        let [light, ..] = shade([-0.6, -0.8, 0.0], [1.0; 3], Finish::Glossy);
        assert!((light - (GROUND + 0.1 * (SKY - GROUND))).abs() < 1e-3);
    }

    #[test]
    fn a_face_towards_the_key_light_is_brighter_than_one_turned_away() {
        let at = |n| shade(n, [0.5; 3], Finish::Glossy)[0];
        assert!(at(LAMPS[0].towards) > 2.0 * at([0.48, -0.6, 0.64]));
    }
}
