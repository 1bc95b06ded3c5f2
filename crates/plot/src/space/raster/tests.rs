use super::*;

const RED: [f32; 3] = [0.6, 0.0, 0.0];
const BLUE: [f32; 3] = [0.0, 0.0, 0.6];
const SIDE: u32 = 8;

fn paint(sides: [[f32; 3]; 2]) -> Material {
    Material {
        sides: Some(sides),
        finish: Finish::Glossy,
        opacity: 1.0,
        cells: [0.0; 2],
        border: false,
    }
}

/// A page-filling square at the nearness `near` of each corner (left above, left below, right below, right above),
/// wound counterclockwise: its front is seen.
fn square(near: [f64; 4], normal: [f32; 3], material: u32) -> [Triangle; 2] {
    let s = f64::from(SIDE) * SAMPLES as f64;
    let at = [[0.0, 0.0], [0.0, s], [s, s], [s, 0.0]];
    let v = [0, 1, 2, 3].map(|k| Vertex {
        at: [at[k][0], at[k][1], near[k]],
        normal,
        uv: at[k].map(|c| (c / s) as f32),
        value: 0.0,
    });
    [[0, 1, 2], [0, 2, 3]].map(|ix| Triangle {
        vertices: ix.map(|k| v[k]),
        material,
    })
}

fn picture(
    triangles: Vec<Triangle>,
    materials: Vec<Material>,
    segments: Vec<Segment>,
) -> Vec<[u8; 4]> {
    let mesh = Mesh {
        triangles,
        segments,
        materials,
        map: Vec::new(),
    };
    let pixels = render(&mesh, SIDE, SIDE).unwrap();
    pixels
        .rgba
        .chunks_exact(4)
        .map(|p| [p[0], p[1], p[2], p[3]])
        .collect()
}

const TOWARDS: [f32; 3] = [0.0, 0.0, 1.0];

#[test]
fn the_nearer_square_wins_whatever_the_order() {
    let near = square([2.0; 4], TOWARDS, 0);
    let far = square([1.0; 4], TOWARDS, 1);
    let materials = vec![paint([RED; 2]), paint([BLUE; 2])];
    let expected = picture(near.to_vec(), materials.clone(), vec![]);
    for order in [[near, far], [far, near]] {
        assert_eq!(picture(order.concat(), materials.clone(), vec![]), expected);
    }
}

#[test]
fn squares_that_cross_hide_each_other_on_either_side() {
    let rising = square([0.0, 0.0, 9.0, 9.0], TOWARDS, 0);
    let falling = square([9.0, 9.0, 0.0, 0.0], TOWARDS, 1);
    let image = picture(
        [rising, falling].concat(),
        vec![paint([RED; 2]), paint([BLUE; 2])],
        vec![],
    );
    for (k, [r, _, b, _]) in image.into_iter().enumerate() {
        let right = k as u32 % SIDE >= SIDE / 2;
        assert_eq!(r > b, right, "pixel {k}");
    }
}

#[test]
fn both_sides_are_lit_alike() {
    // The same square seen from its front and, wound the other way with the opposite normal, from its back.
    for n in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.48, 0.6, 0.64]] {
        let front = square([0.0; 4], n, 0).to_vec();
        let back = front
            .iter()
            .map(|t| {
                let [a, b, c] = t.vertices.map(|v| Vertex {
                    normal: v.normal.map(|c| -c),
                    ..v
                });
                Triangle {
                    vertices: [a, c, b],
                    ..*t
                }
            })
            .collect();
        let seen = picture(front, vec![paint([RED, BLUE])], vec![]);
        assert_eq!(seen, picture(back, vec![paint([BLUE, RED])], vec![]));
        assert!(seen.iter().all(|p| p[0] > 100 && p[3] == 255), "{seen:?}");
    }
}

#[test]
fn neighbouring_triangles_leave_no_seam() {
    let image = picture(
        square([0.0; 4], TOWARDS, 0).to_vec(),
        vec![paint([RED; 2])],
        vec![],
    );
    assert!(image.iter().all(|p| *p == image[0] && p[3] == 255));
}

#[test]
fn glass_tints_what_is_behind_it_and_not_what_is_before() {
    let glass = Material {
        opacity: 0.5,
        ..paint([BLUE; 2])
    };
    let materials = vec![paint([RED; 2]), glass];
    let behind = square([1.0; 4], TOWARDS, 0);
    let [glass_near, glass_far] = [2.0, 0.0].map(|z| square([z; 4], TOWARDS, 1));
    let alone = picture(behind.to_vec(), materials.clone(), vec![]);
    let tinted = picture([glass_near, behind].concat(), materials.clone(), vec![]);
    assert_eq!(
        picture([behind, glass_near].concat(), materials.clone(), vec![]),
        tinted
    );
    assert!(tinted[0][0] < alone[0][0] && tinted[0][2] > alone[0][2]);
    assert_eq!(
        picture([glass_far, behind].concat(), materials, vec![]),
        alone
    );
}

#[test]
fn of_two_panes_the_nearer_tints_more() {
    let panes = [RED, BLUE]
        .map(|c| Material {
            opacity: 0.7,
            ..paint([c; 2])
        })
        .to_vec();
    let image = |red: f64, blue: f64| {
        let [r, b] = [(red, 0), (blue, 1)].map(|(z, m)| square([z; 4], TOWARDS, m));
        picture([r, b].concat(), panes.clone(), vec![])[0]
    };
    let ([r, _, b, _], [s, _, c, _]) = (image(1.0, 0.0), image(0.0, 1.0));
    assert!(r > b && s < c);
}

#[test]
fn panes_that_share_an_edge_through_sample_centres_do_not_overlap() {
    let pane = Material {
        opacity: 0.5,
        ..paint([BLUE; 2])
    };
    // The upper pane ends and the lower one begins in the middle of a row of samples.
    let cut = 10.5;
    let part = |clamp: fn(f64, f64) -> f64| {
        square([0.0; 4], TOWARDS, 0).map(|mut t| {
            t.vertices
                .iter_mut()
                .for_each(|v| v.at[1] = clamp(v.at[1], cut));
            t
        })
    };
    let triangles = [part(f64::min), part(f64::max)].concat();
    let image = picture(triangles, vec![pane], vec![]);
    assert!(image.iter().all(|p| p[3] == 128), "{image:?}");
}

#[test]
fn glass_alone_lets_the_paper_through() {
    let glass = Material {
        opacity: 0.5,
        ..paint([BLUE; 2])
    };
    let image = picture(square([0.0; 4], TOWARDS, 0).to_vec(), vec![glass], vec![]);
    assert!(image.iter().all(|p| p[3] == 128));
}

#[test]
fn a_stroke_shows_on_the_surface_and_not_through_it() {
    let surface = square([0.0; 4], TOWARDS, 0);
    let middle = f64::from(SIDE) * SAMPLES as f64 / 2.0;
    let stroke = |near: f64| Segment {
        ends: [[0.0, middle, near], [2.0 * middle, middle, near]],
        radii: [2.0; 2],
        colour: BLUE,
    };
    let image = |s| picture(surface.to_vec(), vec![paint([RED; 2])], vec![s]);
    let centre = (SIDE * SIDE / 2 + SIDE / 2) as usize;
    assert!(image(stroke(0.0))[centre][2] > 100);
    assert_eq!(image(stroke(-50.0))[centre][2], image(stroke(-50.0))[0][2]);
}

#[test]
fn parameter_lines_run_where_the_parameter_says() {
    let lined = Material {
        cells: [2.0, 0.0],
        ..paint([RED; 2])
    };
    let image = picture(square([0.0; 4], TOWARDS, 0).to_vec(), vec![lined], vec![]);
    for (k, p) in image.iter().enumerate() {
        // u grows to the right: the line u = 1/2 darkens the two middle columns, no other.
        let middle = (SIDE / 2 - 1..=SIDE / 2).contains(&(k as u32 % SIDE));
        assert_eq!(p[0] < image[0][0], middle, "pixel {k}");
    }
}

#[test]
fn far_too_many_samples_are_refused_before_work_begins() {
    let huge = square([0.0; 4], TOWARDS, 0).map(|mut t| {
        for v in &mut t.vertices {
            v.at[0] *= 1e3;
            v.at[1] *= 1e3;
        }
        t
    });
    let mesh = Mesh {
        triangles: huge.repeat(2000),
        materials: vec![paint([RED; 2])],
        ..Mesh::default()
    };
    let error = render(&mesh, 2048, 2048).unwrap_err();
    assert!(matches!(error, FigureError::TooMuchWork { samples, .. } if samples > WORK_LIMIT));
}
