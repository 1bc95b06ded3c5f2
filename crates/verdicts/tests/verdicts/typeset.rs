//! What `torse derive` writes for LaTeX: its form, and where there is a TeX it is typeset.

#[path = "../../../../tests/support/derived.rs"]
mod cases;

use std::process::Command;
use torse_verdicts::derive::{Language, print};

/// The commands of LaTeX and amsmath that formulas are written with.
const COMMANDS: [&str; 31] = [
    "begin",
    "end",
    "frac",
    "left",
    "right",
    "sqrt",
    "sin",
    "cos",
    "exp",
    "pi",
    "cdot",
    "times",
    "mathbf",
    "mathrm",
    "operatorname",
    "text",
    "lambda",
    "mu",
    "nu",
    "gamma",
    "alpha",
    "beta",
    "delta",
    "neq",
    "ne",
    "geq",
    "ge",
    "leq",
    "le",
    "quad",
    "prime",
];

/// What is wrong with the form of a text, if anything.
fn fault(text: &str) -> Option<String> {
    let (mut braces, mut fences) = (0_i32, 0_i32);
    let mut open: Vec<String> = vec![];
    let mut letters = text.char_indices().peekable();
    while let Some((place, letter)) = letters.next() {
        match letter {
            // The rest of the line is a remark.
            '%' => while letters.next_if(|(_, c)| *c != '\n').is_some() {},
            '{' => braces += 1,
            '}' => braces -= 1,
            '\\' => {
                let mut name = String::new();
                while let Some((_, c)) = letters.next_if(|(_, c)| c.is_ascii_alphabetic()) {
                    name.push(c);
                }
                if name.is_empty() {
                    letters.next();
                    continue;
                }
                if !COMMANDS.contains(&name.as_str()) {
                    return Some(format!("\\{name} is no known command"));
                }
                let argument = || {
                    let rest = text.get(place + 1 + name.len()..)?;
                    Some(rest.strip_prefix('{')?.split_once('}')?.0.to_owned())
                };
                match name.as_str() {
                    "left" => fences += 1,
                    "right" => fences -= 1,
                    "begin" => open.extend(argument()),
                    "end" if open.pop() != argument() => {
                        return Some("an environment ends that is not open".to_owned());
                    }
                    _ => {}
                }
            }
            _ => {}
        }
        if braces < 0 || fences < 0 {
            return Some("a brace or fence is closed that is not open".to_owned());
        }
    }
    let whole = braces == 0 && fences == 0 && open.is_empty();
    (!whole).then(|| "a brace, a fence or an environment is never closed".to_owned())
}

#[test]
fn every_derivation_has_the_form_of_latex() {
    for (name, derivation) in cases::derived() {
        let text = print(&derivation, Language::Latex);
        assert_eq!(fault(&text), None, "{name}\n{text}");
        let dollars = text.matches('$').count();
        assert_eq!(dollars % 2, 0, "{name}\n{text}");
    }
}

#[test]
fn what_has_not_the_form_of_latex_is_seen() {
    for text in [
        r"\frac{1}{2",
        r"x}",
        r"\left( x",
        r"\unknown",
        r"\begin{align*} x \end{align}",
    ] {
        assert!(fault(text).is_some(), "{text}");
    }
    assert_eq!(fault("\\left( \\frac{1}{2} \\right)_{i} % }\n"), None);
}

#[test]
fn every_derivation_is_typeset_where_there_is_a_tex() {
    let runs = |tex: &&str| Command::new(tex).arg("--version").output().is_ok();
    let Some(tex) = ["pdflatex", "lualatex"].into_iter().find(runs) else {
        println!("no pdflatex and no lualatex here: the form alone was looked at");
        return;
    };
    let folder = std::env::temp_dir().join(format!("torse-derive-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let bodies: Vec<String> = cases::derived()
        .iter()
        .map(|(_, derivation)| print(derivation, Language::Latex))
        .collect();
    let document = format!(
        "\\documentclass{{article}}\n\\usepackage{{amsmath}}\n\\begin{{document}}\n{}\\end{{document}}\n",
        bodies.join("\n")
    );
    std::fs::write(folder.join("derived.tex"), document).unwrap();
    let run = Command::new(tex)
        .args(["-interaction=nonstopmode", "-halt-on-error", "derived.tex"])
        .current_dir(&folder)
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&run.stdout).into_owned();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(run.status.success(), "{told}");
}
