//! `inspect`, `unroll`, `fold`, `export`, `eval`, `draw` on the real binary.

use crate::support::{measured_in, torse_in};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A folder with one file `part.toml` of this text.
fn folder(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("part.toml"), text).unwrap();
    folder
}

const CONE: &str = "
[curves.rim]
arc = { centre = [0, 0, 0], from = [60, 0, 0], to = [0, 60, 0] }
[patches.cone]
cone = \"rim\"
apex = [0, 0, 120]
range = [1, 0.5]
";

/// Two cones that no edge joins.
const TWO_CONES: &str = "
[curves]
near = { arc = { centre = [0, 0, 0], from = [60, 0, 0], to = [0, 60, 0] } }
far = { arc = { centre = [200, 0, 0], from = [260, 0, 0], to = [200, 60, 0] } }
[patches]
left = { cone = \"near\", apex = [0, 0, 120], range = [1, 0.5] }
right = { cone = \"far\", apex = [200, 0, 120], range = [1, 0.5] }
";

const TWISTED: &str = "
[curves]
a = { bezier = [[0, 0, 0], [100, 0, 0]] }
b = { bezier = [[0, 10, 0], [100, 10, 5]] }
[patches.strip]
ruled = [\"a\", \"b\"]
";

/// How a run ended.
struct Run {
    code: i32,
    output: String,
    error: String,
}

fn run(folder: &Path, arguments: &[&str]) -> Run {
    let ran = torse_in(folder, arguments);
    Run {
        code: ran.code.expect("it was not killed"),
        output: ran.out,
        error: ran.err,
    }
}

fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_good_design_is_inspected_the_same_way_twice() {
    let folder = folder(CONE);
    let first = run(folder.path(), &["inspect", "part.toml"]);
    assert_eq!(first.code, 0, "{}", first.error);
    assert!(first.output.contains("proved") && first.output.ends_with("All tolerances are met.\n"));
    assert!(first.output.lines().all(|line| line.chars().count() <= 100));
    let json = || run(folder.path(), &["inspect", "part.toml", "--format", "json"]);
    let (once, twice) = (json(), json());
    assert_eq!(once.output, twice.output);
    let report: serde_json::Value = serde_json::from_str(&once.output).unwrap();
    assert_eq!(report["patches"][0]["regular"], "proved");
    assert!((report["patches"][0]["clearance"]["low"].as_f64().unwrap() - 67.08).abs() < 1.0);
}

#[test]
fn a_missed_tolerance_ends_with_one() {
    let folder = folder(TWISTED);
    let found = run(folder.path(), &["inspect", "part.toml"]);
    assert_eq!(found.code, 1);
    assert!(found.output.contains("missed: strip is not developable"));
}

#[test]
fn what_is_not_developable_is_not_unrolled_and_nothing_is_written() {
    let folder = folder(TWISTED);
    let refused = run(folder.path(), &["unroll", "part.toml", "--to", "part.dxf"]);
    assert_eq!(refused.code, 1);
    assert!(refused.error.contains("--allow-strain"));
    // Once, not once for each that passes it on.
    let said = refused.error.matches("not developable").count();
    assert_eq!(said, 1, "{}", refused.error);
    assert_eq!(files(folder.path()), ["part.toml"]);
    let allowed = [
        "unroll",
        "part.toml",
        "--to",
        "part.dxf",
        "--allow-strain",
        "1e-3",
    ];
    let strained = run(folder.path(), &allowed);
    assert_eq!(strained.code, 0, "{}", strained.error);
    assert!(strained.output.contains("STRAINED"));
    assert_eq!(strained.output.matches(" mm, area ").count(), 1);
    let text = std::fs::read_to_string(folder.path().join("part.dxf")).unwrap();
    assert!(text.contains("not developable: lines are strained"));
}

#[test]
fn a_pattern_folds_back_to_its_design() {
    let folder = folder(CONE);
    let unrolled = run(
        folder.path(),
        &[
            "unroll",
            "part.toml",
            "--to",
            "part.dxf",
            "--rulings",
            "33",
            "--for",
            "fold",
        ],
    );
    assert_eq!(unrolled.code, 0, "{}", unrolled.error);
    let folded = run(
        folder.path(),
        &["fold", "part.toml", "--pattern", "part.dxf"],
    );
    assert_eq!(folded.code, 0, "{}{}", folded.output, folded.error);
    assert!(
        folded
            .output
            .starts_with("cone: 33 rulings of the file fold to within")
    );
    // The same from SVG.
    let unrolled = [
        "unroll",
        "part.toml",
        "--to",
        "part.svg",
        "--rulings",
        "33",
        "--for",
        "fold",
    ];
    assert_eq!(run(folder.path(), &unrolled).code, 0);
    let from_svg = ["fold", "part.toml", "--pattern", "part.svg"];
    let from_svg = run(folder.path(), &from_svg);
    assert_eq!(
        (from_svg.code, &from_svg.output),
        (0, &folded.output),
        "{}",
        from_svg.error
    );
    // The pattern of another part.
    std::fs::write(folder.path().join("other.toml"), CONE.replace("60", "70")).unwrap();
    let other = run(
        folder.path(),
        &["fold", "other.toml", "--pattern", "part.dxf"],
    );
    assert_eq!(other.code, 1);
    assert!(other.output.contains("missed: cone"));
    // What is no pattern at all.
    std::fs::write(folder.path().join("bad.dxf"), "hello").unwrap();
    let bad = run(
        folder.path(),
        &["fold", "part.toml", "--pattern", "bad.dxf"],
    );
    assert_eq!(bad.code, 4);
}

#[test]
fn every_format_is_written_and_overwritten() {
    let folder = folder(CONE);
    for ending in [
        "dxf", "svg", "stl", "obj", "ply", "3mf", "glb", "step", "stp", "iges", "igs",
    ] {
        let name = format!("part.{ending}");
        for _ in 0..2 {
            let done = run(folder.path(), &["export", "part.toml", "--to", &name]);
            assert_eq!(
                (done.code, done.output.as_str()),
                (0, ""),
                "{ending}: {}",
                done.error
            );
        }
        assert!(std::fs::metadata(folder.path().join(&name)).unwrap().len() > 400);
    }
    for ending in ["png", "svg", "html"] {
        let name = format!("picture.{ending}");
        let done = run(folder.path(), &["draw", "part.toml", "--to", &name]);
        assert_eq!(done.code, 0, "{ending}: {}", done.error);
    }
    // No drafts are left.
    assert_eq!(files(folder.path()).len(), 1 + 11 + 3);
}

#[test]
fn unknown_formats_and_names_are_mistakes_of_the_command_line() {
    let folder = folder(CONE);
    for arguments in [
        ["export", "part.toml", "--to", "part.xyz"].as_slice(),
        &["export", "part.toml", "--to", "part"],
        &["unroll", "part.toml", "--to", "part.step"],
        &[
            "unroll",
            "part.toml",
            "--to",
            "part.dxf",
            "--only",
            "cylinder",
        ],
        &[
            "unroll",
            "part.toml",
            "--to",
            "part.dxf",
            "--for",
            "fold",
            "--rulings",
            "1",
        ],
        &[
            "unroll",
            "part.toml",
            "--to",
            "part.dxf",
            "--allow-strain",
            "NaN",
        ],
        &["draw", "part.toml", "--to", "part.bmp"],
        &["fold", "part.toml", "--pattern", "part.step"],
        &["eval", "part.toml", "--at", "0.5"],
        &["eval", "part.toml", "--at", "2,0"],
        &["eval", "part.toml", "--grid", "99999999x99999999"],
        &["eval", "part.toml", "--at", "0,0", "--patch", "cylinder"],
        &["eval", "part.toml"],
        &["inspect", "part.toml", "--set", "W=90"],
    ] {
        let wrong = run(folder.path(), arguments);
        assert_eq!(wrong.code, 2, "{arguments:?}: {}", wrong.error);
        assert!(!wrong.error.is_empty() && wrong.output.is_empty());
    }
    let told = |arguments: &[&str]| {
        let wrong = run(folder.path(), arguments);
        assert_eq!(wrong.code, 2);
        wrong.error.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let of_cut = told(&["unroll", "part.toml", "--to", "part.xyz"]);
    let all = "the extensions are .dxf, .svg; .pdf with `--for bench` or `--for paper`";
    assert!(of_cut.contains(all), "{of_cut}");
    let of_paper = told(&["unroll", "part.toml", "--to", "x.y", "--for", "paper"]);
    let others = "the extensions are .pdf; .dxf with `--for cut` or `--for bend`";
    assert!(of_paper.contains(others), "{of_paper}");
    assert_eq!(files(folder.path()), ["part.toml"]);
}

#[test]
fn an_option_without_effect_is_refused_and_says_for_what_it_has_one() {
    let folder = folder(CONE);
    for (purpose, option, value, purposes) in [
        (
            "fold",
            "--kerf",
            "0.2",
            "`--for cut`, `--for bend`, `--for sew`",
        ),
        (
            "bench",
            "--kerf",
            "0.2",
            "`--for cut`, `--for bend`, `--for sew`",
        ),
        (
            "cut",
            "--rulings",
            "9",
            "`--for fold`, `--for bench`, `--for paper`",
        ),
        ("cut", "--page", "a3", "`--for bench`, `--for paper`"),
        (
            "fold",
            "--parts",
            "parts.csv",
            "`--for cut`, `--for bend`, `--for sew`, `--for bench`, `--for paper`",
        ),
    ] {
        let arguments = [
            "unroll",
            "part.toml",
            "--to",
            "out.svg",
            "--for",
            purpose,
            option,
            value,
        ];
        let wrong = run(folder.path(), &arguments);
        assert_eq!(wrong.code, 2, "{arguments:?}: {}", wrong.error);
        let words = wrong.error.split_whitespace().collect::<Vec<_>>().join(" ");
        let message = format!("`{option}` has no effect for `--for {purpose}`");
        assert!(words.contains(&message), "{words}");
        assert!(words.contains(purposes), "{words}");
    }
    let wrong = run(folder.path(), &["unroll", "part.toml", "--to", "part.pdf"]);
    assert_eq!(wrong.code, 2);
    let words = wrong.error.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("for .pdf add `--for bench` or `--for paper`"),
        "{words}"
    );
    assert_eq!(files(folder.path()), ["part.toml"]);
}

#[test]
fn a_file_in_space_has_only_the_piece_that_is_named() {
    let folder = folder(TWO_CONES);
    let size = |arguments: &[&str]| {
        let done = run(folder.path(), arguments);
        assert_eq!(done.code, 0, "{}", done.error);
        std::fs::metadata(folder.path().join("part.stl"))
            .unwrap()
            .len()
    };
    let all = size(&["export", "part.toml", "--to", "part.stl"]);
    let one = size(&["export", "part.toml", "--to", "part.stl", "--only", "left"]);
    // A header of 84 bytes, then 50 for each triangle: both cones have equally many.
    assert_eq!(all - 84, 2 * (one - 84));
    let wrong = run(
        folder.path(),
        &[
            "export",
            "part.toml",
            "--to",
            "part.stl",
            "--only",
            "middle",
        ],
    );
    assert_eq!(wrong.code, 2);
    assert!(wrong.error.contains("middle") && wrong.error.contains("left"));
}

#[test]
fn a_missing_design_ends_with_two_and_a_wrong_one_with_four_and_all_its_mistakes() {
    let folder = folder("[points]\nA = [0, 0]\nB = [1, \"q\", 2]\n[patches.p]\ncone = \"rim\"\n");
    let missing = run(folder.path(), &["inspect", "nothing.toml"]);
    assert_eq!(missing.code, 2);
    assert!(missing.error.contains("nothing.toml cannot be read"));
    for command in [
        ["inspect"].as_slice(),
        &["export", "--to", "x.stl"],
        &["draw", "--to", "x.png"],
    ] {
        let mut arguments = command.to_vec();
        arguments.push("part.toml");
        let wrong = run(folder.path(), &arguments);
        assert_eq!(wrong.code, 4);
        for message in [
            "2 numbers: 3 are wanted",
            "`q` is not declared",
            "no curve above is called `rim`",
        ] {
            assert!(wrong.error.contains(message), "{}", wrong.error);
        }
        assert!(
            wrong.error.contains("part.toml:2:5") && wrong.error.contains('^'),
            "{}",
            wrong.error
        );
    }
    assert_eq!(files(folder.path()), ["part.toml"]);
}

#[test]
fn a_target_that_cannot_be_written_ends_with_five() {
    let folder = folder(CONE);
    for arguments in [
        ["export", "part.toml", "--to", "no/such/part.stl"].as_slice(),
        &["unroll", "part.toml", "--to", "no/such/part.dxf"],
        &["draw", "part.toml", "--to", "no/such/part.png"],
    ] {
        let failed = run(folder.path(), arguments);
        assert_eq!(failed.code, 5, "{}", failed.error);
        assert!(failed.error.contains("cannot write"));
    }
    std::fs::create_dir(folder.path().join("part.stl")).unwrap();
    assert_eq!(
        run(folder.path(), &["export", "part.toml", "--to", "part.stl"]).code,
        5
    );
}

/// A run on a hostile file: it ends in seconds and in little memory, with a message that people can read.
#[track_caller]
fn refused(folder: &Path, arguments: &[&str], code: i32) {
    let started = Instant::now();
    let (ran, kilobytes) = measured_in(folder, arguments);
    let (took, name) = (started.elapsed(), arguments.join(" "));
    assert_eq!(ran.code, Some(code), "{name}: {}{}", ran.out, ran.err);
    let said = ran.err.len();
    assert!(said > 0 && said < 250_000, "{name}: {said} bytes");
    assert!(ran.out.is_empty(), "{name}: {}", ran.out);
    assert!(took < Duration::from_secs(60), "{name}: {took:?}");
    assert!(kilobytes < 1_000_000, "{name}: {kilobytes} kB");
}

#[test]
fn hostile_designs_are_refused_with_a_message_and_nothing_is_written() {
    let folder = folder(CONE);
    let many: String = (0..20_000).map(|k| format!("[points.p{k}]\n")).collect();
    let mistakes: String = (0..20_000).map(|k| format!("p{k} = 1\n")).collect();
    let designs: [(&str, Vec<u8>); 10] = [
        ("empty.toml", Vec::new()),
        ("bytes.toml", vec![0xff, 0xfe, 0x00, 0x7f]),
        ("zeros.toml", vec![0; 100_000]),
        (
            "nested.toml",
            format!("x = {}", "[".repeat(50_000)).into_bytes(),
        ),
        ("tower.toml", b"[let]\na = \"9^9^9^9^9\"\n".to_vec()),
        ("circle.toml", b"[let]\na = \"b\"\nb = \"a\"\n".to_vec()),
        ("many.toml", many.into_bytes()),
        (
            "mistakes.toml",
            format!("[points]\n{mistakes}").into_bytes(),
        ),
        (
            "long.toml",
            [CONE.as_bytes(), &vec![b'#'; 5_000_000]].concat(),
        ),
        (
            "nan.toml",
            CONE.replace("120", "nan")
                .replace("0.5", "inf")
                .into_bytes(),
        ),
    ];
    for (name, bytes) in &designs {
        std::fs::write(folder.path().join(name), bytes).unwrap();
        for arguments in [
            ["inspect", name].as_slice(),
            &["unroll", name, "--to", "x.dxf"],
            &["export", name, "--to", "x.step"],
            &["draw", name, "--to", "x.png"],
        ] {
            refused(folder.path(), arguments, 4);
        }
    }
    // More than there is room for.
    let grid = ["eval", "part.toml", "--grid", "999999999x999999999"];
    refused(folder.path(), &grid, 2);
    let rulings = [
        "unroll",
        "part.toml",
        "--to",
        "x.dxf",
        "--for",
        "fold",
        "--rulings",
        "999999999",
    ];
    refused(folder.path(), &rulings, 2);
    assert_eq!(files(folder.path()).len(), 1 + designs.len());
}

#[test]
fn hostile_patterns_are_refused_with_a_message() {
    let folder = folder(CONE);
    let unrolled = |name: &str| {
        let done = run(
            folder.path(),
            &["unroll", "part.toml", "--to", name, "--for", "fold"],
        );
        assert_eq!(done.code, 0, "{}", done.error);
        std::fs::read_to_string(folder.path().join(name)).unwrap()
    };
    let (dxf, svg) = (unrolled("part.dxf"), unrolled("part.svg"));
    let half = |text: &str| text.as_bytes()[..text.len() / 2].to_vec();
    let infinite = |text: &str| text.replace("67", "1e999").into_bytes();
    let deep = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\">{}",
        "<g>".repeat(100_000)
    );
    let entity = "<!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><svg>&b;</svg>";
    let patterns: [(&str, Vec<u8>); 8] = [
        ("half.dxf", half(&dxf)),
        ("half.svg", half(&svg)),
        ("infinite.dxf", infinite(&dxf)),
        ("infinite.svg", infinite(&svg)),
        ("zeros.dxf", vec![0; 100_000]),
        ("bytes.svg", vec![0xff; 1000]),
        ("deep.svg", deep.into_bytes()),
        ("entity.svg", entity.as_bytes().to_vec()),
    ];
    for (name, bytes) in &patterns {
        std::fs::write(folder.path().join(name), bytes).unwrap();
        refused(folder.path(), &["fold", "part.toml", "--pattern", name], 4);
    }
}

#[test]
fn values_are_printed_for_people_and_programs() {
    let folder = folder(CONE);
    let csv = run(
        folder.path(),
        &["eval", "part.toml", "--at", "0,0", "--at", "1,1"],
    );
    let lines: Vec<&str> = csv.output.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[1].starts_with("cone,0,0,60,0,0,"));
    let json = run(
        folder.path(),
        &["eval", "part.toml", "--grid", "2x2", "--format", "json"],
    );
    let rows: serde_json::Value = serde_json::from_str(&json.output).unwrap();
    assert_eq!(rows.as_array().unwrap().len(), 9);
    assert_eq!(rows[0]["point"], serde_json::json!([60.0, 0.0, 0.0]));
}

#[test]
fn the_commands_of_the_tutorial_do_what_it_says() {
    let path: PathBuf = [
        env!("CARGO_MANIFEST_DIR"),
        "..",
        "..",
        "designs",
        "TUTORIAL.md",
    ]
    .iter()
    .collect();
    let text = std::fs::read_to_string(path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (mut designs, mut commands, mut outputs) = (0, 0, 0);
    let (mut last, mut printed) = (String::new(), String::new());
    for block in text.split("```").skip(1).step_by(2) {
        let (kind, body) = block.split_once('\n').unwrap();
        if kind == "toml" {
            std::fs::write(folder.path().join("hopper.toml"), body).unwrap();
            last = body.to_owned();
            designs += 1;
            continue;
        }
        if kind == "text" {
            assert_eq!(body, printed);
            outputs += 1;
            continue;
        }
        assert_eq!(kind, "sh");
        printed.clear();
        for line in body.lines() {
            let arguments: Vec<&str> = line.strip_prefix("torse ").unwrap().split(' ').collect();
            let done = run(folder.path(), &arguments);
            assert_eq!(done.code, 0, "{line}\n{}{}", done.output, done.error);
            printed += &done.output;
            commands += 1;
        }
    }
    assert_eq!((designs, commands, outputs), (2, 13, 5));
    // What it says about G2.
    std::fs::write(
        folder.path().join("hopper.toml"),
        last.replace("\"G1\"", "\"G2\""),
    )
    .unwrap();
    let refused = run(folder.path(), &["inspect", "hopper.toml"]);
    let missed = refused
        .output
        .lines()
        .find(|line| line.starts_with("missed: "));
    let missed = missed.unwrap();
    assert!(refused.code == 1 && missed.starts_with("missed: ") && text.contains(missed));
    let page = std::fs::read_to_string(folder.path().join("hopper.html")).unwrap();
    assert!(!page.contains("http://www.w3.org/1999/xlink") && !page.contains("src=\"http"));
}

/// An angle of two flat legs, 40 and 25 mm to the corner on the middle of the sheet.
const ANGLE: &str = r#"
[curves]
a = { bezier = [[0, 0, 0], [40, 0, 0]] }
b = { bezier = [[0, 60, 0], [40, 60, 0]] }
c = { bezier = [[40, 0, 0], [40, 0, 25]] }
d = { bezier = [[40, 60, 0], [40, 60, 25]] }
[patches]
base = { ruled = ["a", "b"] }
wall = { ruled = ["c", "d"] }
[sheet]
thickness = 1.5
k-factor = 0.42
"#;

#[test]
fn each_part_has_a_file_of_its_own_that_a_cutting_service_takes() {
    let folder = folder(ANGLE);
    let list = [
        "unroll",
        "part.toml",
        "--to",
        "part.dxf",
        "--parts",
        "parts.csv",
    ];
    let done = run(folder.path(), &list);
    assert_eq!(done.code, 0, "{}", done.error);
    assert_eq!(
        files(folder.path()),
        ["part-base.dxf", "part-wall.dxf", "part.toml", "parts.csv"]
    );
    let table = std::fs::read_to_string(folder.path().join("parts.csv")).unwrap();
    assert!(
        table.contains("base,part-base.dxf,1,60.0000,40.0000,2400.0000,200.0000,0,1.5,0,"),
        "{table}"
    );
    let lint = ["lint", "part-base.dxf", "--thickness", "1.5"];
    let kept = run(folder.path(), &lint);
    assert_eq!(kept.code, 0, "{}{}", kept.output, kept.error);
    assert!(!kept.output.contains("BROKEN") && !kept.output.contains("not judged"));
    // The pattern of everything is for folding: text and rulings, two parts.
    let fold = ["unroll", "part.toml", "--to", "all.dxf", "--for", "fold"];
    assert_eq!(run(folder.path(), &fold).code, 0);
    let broken = run(folder.path(), &["lint", "all.dxf", "--format", "json"]);
    assert_eq!(broken.code, 1);
    let report: serde_json::Value = serde_json::from_str(&broken.output).unwrap();
    let broken: Vec<&str> = report["rules"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|rule| rule["outcome"] == "broken")
        .filter_map(|rule| rule["check"].as_str())
        .collect();
    for check in ["text", "closed", "doubled", "one-part"] {
        assert!(broken.contains(&check), "{broken:?}");
    }
    // Several files are no stream.
    let stream = ["unroll", "part.toml", "--to", "-", "--as", "dxf"];
    let refused = run(folder.path(), &stream);
    assert_eq!(refused.code, 2);
    assert!(refused.error.contains("--only") && refused.output.is_empty());
}

#[test]
fn a_bend_is_one_line_with_its_angle_and_its_radius() {
    let chain = "[chains.angle]\npatches = [\"base\", \"wall\"]\n";
    let folder = folder(&format!("{ANGLE}{chain}radius = 2\n"));
    for name in ["part.dxf", "part.svg"] {
        let bend = [
            "unroll",
            "part.toml",
            "--to",
            name,
            "--for",
            "bend",
            "--format",
            "json",
        ];
        let done = run(folder.path(), &bend);
        assert_eq!(done.code, 0, "{}", done.error);
        let answer: serde_json::Value = serde_json::from_str(&done.output).unwrap();
        let part = &answer["parts"]["parts"][0];
        assert!(
            (part["size"][0].as_f64().unwrap() - 63.631_194).abs() < 1e-6,
            "{part}"
        );
        assert_eq!(part["bends"].as_array().unwrap().len(), 1);
        assert!((part["bends"][0]["angle"].as_f64().unwrap() - 90.0).abs() < 1e-9);
        assert_eq!(part["bends"][0]["inside_radius"], 2.0);
    }
    let dxf = std::fs::read_to_string(folder.path().join("part.dxf")).unwrap();
    assert_eq!(dxf.matches("inside radius").count(), 1);
    assert!(dxf.contains("DASHED") && !dxf.contains("\nTEXT\n"));
    let svg = std::fs::read_to_string(folder.path().join("part.svg")).unwrap();
    assert!(svg.contains("data-inside-radius=\"2\"") && svg.contains("stroke-dasharray"));
    assert!(svg.contains("stroke-width=\"0.01\""));
    // A radius that the material does not take is missed.
    assert_eq!(run(folder.path(), &["inspect", "part.toml"]).code, 0);
    let tight = format!("{ANGLE}least-radius = 2\n{chain}radius = 2\n");
    std::fs::write(folder.path().join("part.toml"), tight).unwrap();
    let missed = run(folder.path(), &["inspect", "part.toml"]);
    assert_eq!(missed.code, 1);
    assert!(
        missed
            .output
            .contains("missed: angle: the inside radius of its edges is 1.3333 times"),
        "{}",
        missed.output
    );
    // Without a radius the growth is no number, and the edge is scored.
    std::fs::write(folder.path().join("part.toml"), format!("{ANGLE}{chain}")).unwrap();
    let sharp = [
        "unroll",
        "part.toml",
        "--to",
        "part.dxf",
        "--format",
        "json",
    ];
    let sharp = run(folder.path(), &sharp);
    let answer: serde_json::Value = serde_json::from_str(&sharp.output).unwrap();
    assert!(answer["pieces"][0]["growth"].is_null());
    assert_eq!(
        answer["parts"]["parts"][0]["sharp"]
            .as_array()
            .unwrap()
            .len(),
        1
    );
}

#[test]
fn what_is_missed_is_said_of_what_is_written() {
    let chain = "[chains.angle]\npatches = [\"base\", \"wall\"]\n";
    let folder = folder(&format!("{ANGLE}least-radius = 2\n{chain}radius = 2\n"));
    let done = run(folder.path(), &["unroll", "part.toml", "--to", "part.dxf"]);
    assert_eq!(done.code, 1, "{}", done.error);
    assert!(
        done.error
            .contains("missed: angle: the inside radius of its edges is 1.3333 times"),
        "{}",
        done.error
    );
    assert_eq!(files(folder.path()), ["part.dxf", "part.toml"]);
    // One size a part: that of the blank, not of the surface that was developed.
    assert!(
        done.output.starts_with("cut angle: ") && done.output.matches(" mm, area ").count() == 1,
        "{}",
        done.output
    );
    let exported = run(folder.path(), &["export", "part.toml", "--to", "flat.dxf"]);
    assert_eq!(exported.code, 0, "{}", exported.error);
    assert!(
        exported
            .error
            .contains("not the blank: bends have no allowance"),
        "{}",
        exported.error
    );
    let stream = run(folder.path(), &["export", "part.toml", "--to", "-"]);
    assert_eq!(stream.code, 2);
    assert!(stream.error.contains("add `--as dxf`"), "{}", stream.error);
    // A length may have a unit of its own.
    let text = format!("{ANGLE}least-radius = 1\n").replace("= 1.5", "= \"1.5 mm\"");
    std::fs::write(folder.path().join("part.toml"), text).unwrap();
    let unit = run(folder.path(), &["inspect", "part.toml"]);
    assert_eq!(unit.code, 0, "{}", unit.error);
}

#[test]
fn sheets_of_paper_are_pdf_or_svg_with_the_same_bytes_on_every_run() {
    let folder = folder(CONE);
    for (purpose, file, head) in [
        ("bench", "sheet.pdf", "%PDF-"),
        ("bench", "sheet.svg", "<svg"),
        ("paper", "pages.pdf", "%PDF-"),
    ] {
        let arguments = ["unroll", "part.toml", "--for", purpose, "--to", file];
        let bytes = || {
            let ran = run(folder.path(), &arguments);
            assert_eq!(ran.code, 0, "{}", ran.error);
            std::fs::read(folder.path().join(file)).unwrap()
        };
        let first = bytes();
        assert!(first.starts_with(head.as_bytes()), "{purpose} {file}");
        assert_eq!(first, bytes(), "{purpose} {file}");
    }
    // Pages are no drawing for a cutter, and a cut is no page.
    for (purpose, file) in [
        ("paper", "pages.dxf"),
        ("bench", "sheet.dxf"),
        ("cut", "part.pdf"),
    ] {
        let ran = run(
            folder.path(),
            &["unroll", "part.toml", "--for", purpose, "--to", file],
        );
        assert_eq!(ran.code, 2, "{}", ran.error);
        assert!(!folder.path().join(file).exists());
    }
}

#[test]
fn a_file_of_which_only_some_faces_have_patterns_is_unrolled_in_part_and_says_so() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../designs/tests/files/cone_face.step"
    );
    let step = std::fs::read_to_string(file).unwrap();
    let more = step.replace("OPEN_SHELL('',(#35))", "OPEN_SHELL('',(#35,#9035))").replace(
        "#36 = FACE_BOUND",
        "#9035 = ADVANCED_FACE('ball',(#36),#9049,.T.);\n#9049 = SPHERICAL_SURFACE('',#50,50.);\n#36 = FACE_BOUND",
    );
    let folder = folder(CONE);
    std::fs::write(folder.path().join("parts.step"), &more).unwrap();
    let arguments = [
        "unroll",
        "parts.step",
        "--to",
        "parts.dxf",
        "--format",
        "json",
    ];
    let unrolled = run(folder.path(), &arguments);
    assert_eq!(unrolled.code, 1, "{}", unrolled.error);
    assert!(folder.path().join("parts.dxf").exists());
    assert!(
        unrolled.error.contains("1 face is left out of parts") && unrolled.error.contains("ball: "),
        "{}",
        unrolled.error
    );
    let answer: serde_json::Value = serde_json::from_str(&unrolled.output).unwrap();
    assert_eq!(answer["left_out"][0]["name"], "ball");
    // What is broken is refused with the line of the reader, by `unroll` as by `inspect`.
    std::fs::write(folder.path().join("parts.step"), &more[..more.len() / 2]).unwrap();
    let [unrolled, inspected] =
        [&arguments[..4], &["inspect", "parts.step"]].map(|all| run(folder.path(), all));
    assert_eq!((unrolled.code, inspected.code), (4, 4));
    assert_eq!(unrolled.error, inspected.error);
    assert!(unrolled.error.contains("line "), "{}", unrolled.error);
}
