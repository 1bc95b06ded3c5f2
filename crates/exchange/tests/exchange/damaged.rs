//! Files that were damaged are read, or refused with an error, in bounded time: nothing else happens.

use proptest::prelude::*;
use torse_exchange::{Drawing, Imported, read};

/// Valid files of every format.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    let names = [
        "cone_face.step",
        "rails.step",
        "ruled_face.step",
        "ruled_face.igs",
        "rails_spline.dxf",
        "rails_poly.dxf",
        "rails.svg",
        "offsets.csv",
        "cone.obj",
    ];
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/files");
    let mut files: Vec<(&str, Vec<u8>)> = names
        .iter()
        .map(|name| (*name, std::fs::read(format!("{folder}/{name}")).unwrap()))
        .collect();
    // A few triangles of the binary mesh, with the count that fits.
    let mesh = std::fs::read(format!("{folder}/cone.stl")).unwrap();
    let mut short = mesh[..84 + 50 * 4].to_vec();
    short[80..84].copy_from_slice(&4_u32.to_le_bytes());
    files.push(("cone.stl", short));
    files.push(("text.stl", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n".to_vec()));
    files
}

/// What befalls a file.
#[derive(Debug, Clone)]
enum Damage {
    Cut(usize),
    Flip(usize, u8),
    Repeat(usize, usize),
    Drop(usize, usize),
    /// A number is replaced.
    Number(usize, &'static str),
}

fn damages() -> impl Strategy<Value = Vec<Damage>> {
    let numbers = [
        "NaN",
        "inf",
        "1e999",
        "-0",
        "99999999999999999999",
        "0",
        "-1",
        "1e-320",
        "#10",
        "",
        "4294967296",
        "1E308",
        "nan(1)",
        "0.1.2",
    ];
    let at = 0_usize..1 << 16;
    let one = prop_oneof![
        at.clone().prop_map(Damage::Cut),
        (at.clone(), any::<u8>()).prop_map(|(k, b)| Damage::Flip(k, b)),
        (at.clone(), 1_usize..400).prop_map(|(k, n)| Damage::Repeat(k, n)),
        (at.clone(), 1_usize..400).prop_map(|(k, n)| Damage::Drop(k, n)),
        (at, proptest::sample::select(numbers.to_vec()))
            .prop_map(|(k, text)| Damage::Number(k, text)),
    ];
    proptest::collection::vec(one, 1..6)
}

fn damaged(mut bytes: Vec<u8>, damages: &[Damage]) -> Vec<u8> {
    for damage in damages {
        let length = bytes.len().max(1);
        match *damage {
            Damage::Cut(k) => bytes.truncate(k % length),
            Damage::Flip(k, b) => {
                if let Some(slot) = bytes.get_mut(k % length) {
                    *slot ^= b;
                }
            }
            Damage::Repeat(k, n) => {
                let from = k % length;
                let part = bytes
                    .get(from..(from + n).min(bytes.len()))
                    .unwrap_or_default()
                    .to_vec();
                bytes.splice(from.min(bytes.len())..from.min(bytes.len()), part);
            }
            Damage::Drop(k, n) => {
                let from = (k % length).min(bytes.len());
                bytes.drain(from..(from + n).min(bytes.len()));
            }
            Damage::Number(k, text) => {
                let from = (k % length).min(bytes.len());
                let digit = |b: &u8| b.is_ascii_digit() || *b == b'.';
                let Some(start) = bytes.iter().skip(from).position(digit).map(|at| at + from)
                else {
                    continue;
                };
                let count = bytes.iter().skip(start).take_while(|b| digit(b)).count();
                bytes.splice(start..start + count, text.bytes());
            }
        }
    }
    bytes
}

/// Everything of a value is finite and can be asked for.
fn used(found: &Imported) {
    for curve in found.curves.iter().take(50) {
        if let Ok(rail) = curve.shape.rail() {
            for x in [0.0, 0.5, 1.0] {
                if let Ok(point) = rail.point(x) {
                    assert!(
                        point.iter().all(|c| c.is_finite()),
                        "{}: {point:?}",
                        curve.place
                    );
                }
            }
        }
    }
    for mesh in &found.meshes {
        assert!(mesh.mesh.vertices().iter().flatten().all(|c| c.is_finite()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_give_a_value_or_an_error(which in 0_usize..11, damages in damages()) {
        let mut files = files();
        let (name, bytes) = files.swap_remove(which % files.len());
        let bytes = damaged(bytes, &damages);
        let start = std::time::Instant::now();
        match read(name, &bytes, None) {
            Ok(found) => used(&found),
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
        let text = String::from_utf8_lossy(&bytes);
        let _ = Drawing::from_svg(&text);
        let _ = Drawing::from_dxf(&text);
        prop_assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    }
}

#[test]
fn a_file_of_many_entities_is_refused_or_read_in_time() {
    let start = std::time::Instant::now();
    let lines: String = (0..200_001)
        .map(|k| format!("0\nLINE\n8\nL\n10\n{k}\n20\n0\n11\n{k}\n21\n1\n"))
        .collect();
    let drawing = format!("0\nSECTION\n2\nENTITIES\n{lines}0\nENDSEC\n0\nEOF\n");
    let error = read("many.dxf", drawing.as_bytes(), None)
        .unwrap_err()
        .to_string();
    assert!(error.contains("more than 200000 curves"), "{error}");
    // Each block inserts the one below it a hundred times.
    let mut blocks =
        String::from("0\nBLOCK\n2\nb0\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDBLK\n");
    for k in 1..10 {
        blocks.push_str(&format!(
            "0\nBLOCK\n2\nb{k}\n0\nINSERT\n2\nb{}\n10\n0\n20\n0\n70\n10\n71\n10\n0\nENDBLK\n",
            k - 1
        ));
    }
    let drawing = format!(
        "0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nb9\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n"
    );
    let error = read("bomb.dxf", drawing.as_bytes(), None)
        .unwrap_err()
        .to_string();
    assert!(error.contains("more than"), "{error}");
    assert!(start.elapsed().as_secs() < 120, "{:?}", start.elapsed());
}
