//! Files of other kinds get one line that says what they are.

use torse_designs::{DesignError, Ending, read};

/// The beginning of a file, and what it is.
const FILES: [(&str, &str); 12] = [
    (
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=POINT('');\n",
        "a STEP file",
    ),
    ("0\nSECTION\n2\nENTITIES\n0\nLINE\n", "a DXF drawing"),
    ("999\nby hand\n  0\nSECTION\n  2\nHEADER\n", "a DXF drawing"),
    (
        "<?xml version=\"1.0\"?>\n<!-- a > b -->\n<svg:svg xmlns:svg=\"http://www.w3.org/2000/svg\"/>\n",
        "an SVG drawing",
    ),
    ("station,x,y,z\n0,0,0,0\n1,400,180,-40\n", "a CSV table"),
    ("0;1,5;2\n1;2,5;3\n", "a CSV table"),
    (
        "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "an OBJ mesh",
    ),
    (
        "solid cone\n facet normal 0 0 1\n  outer loop\n",
        "an STL mesh",
    ),
    ("{\n  \"points\": [1, 2]\n}\n", "a JSON file"),
    (
        "<!DOCTYPE html>\n<html><body></body></html>",
        "an HTML page",
    ),
    ("%PDF-1.7\n", "a PDF document"),
    (
        "CASCADE Topology V1, (c) Matra-Datavision\n",
        "a BREP model of OpenCASCADE",
    ),
];

#[test]
fn a_file_of_another_kind_is_named_in_one_line() {
    for (text, kind) in FILES {
        let error = read("part", text).unwrap_err();
        assert!(
            matches!(error, DesignError::OtherKind { .. }),
            "{kind}: {error:?}"
        );
        assert_eq!(error.ending(), Ending::BadFile);
        let words = error.to_string();
        assert!(words.contains(kind) && !words.contains('\n'), "{words}");
    }
    let iges = format!("{:72}S      1\n{:72}G      1\n", "", "1H,,1H;,");
    let words = read("part", &iges).unwrap_err().to_string();
    assert!(words.contains("an IGES file"), "{words}");
}

#[test]
fn an_empty_file_of_another_program_is_told_to_be_empty() {
    for name in ["part.step", "part.DXF", "part.igs", "part.svg"] {
        for text in ["", " \n"] {
            let error =
                torse_designs::load_with_settings(name.as_ref(), text.as_bytes(), &[]).unwrap_err();
            assert!(
                error
                    .to_string()
                    .contains(&format!("{name} is an empty file")),
                "{error}"
            );
        }
    }
}

#[test]
fn a_design_with_a_mistake_stays_a_design() {
    for text in [
        "",
        "# nothing\n",
        "[curves]\na = 1,2\n",
        "x, y\n",
        "curves = [1, 2]\n",
        "[points]\nA = [0, 0, 0]\nB, C\n",
        "{ a = 1 }\n",
        "solid = 3\n",
        "v = 1\n",
    ] {
        let error = read("part.toml", text).unwrap_err();
        assert!(
            matches!(error, DesignError::Wrong { .. }),
            "{text:?}: {error}"
        );
    }
}
