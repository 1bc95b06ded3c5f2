//! Changes that are proposed, written as the program calls its functions and counts its entries.

use super::compared;

#[test]
fn a_change_of_the_code_runs() {
    for (file, text, formula, wanted) in [
        (
            "f.py",
            "import numpy as np\ndef f(x):\n    return np.sin(x) + 1\n",
            "cos(x) + 1",
            "    return np.cos(x) + 1",
        ),
        (
            "f.py",
            "import math\ndef f(x):\n    return math.sin(x)**2 + 1\n",
            "cos(x)^2 + 1",
            "    return math.cos(x)**2 + 1",
        ),
        (
            "f.rs",
            "fn f(x: f64, y: f64) -> f64 {\n    let v = [x, y, 1.0];\n    v[0] * v[0]\n}\n",
            "x*y",
            "    v[0 + 1] * v[0]",
        ),
    ] {
        let found = compared(file, text, formula).unwrap();
        let edit = found.code_edit.unwrap();
        assert_eq!(edit.line_then.as_deref(), Some(wanted), "{text}");
        let mended = text.replace(&edit.line_now, wanted);
        let again = compared(file, &mended, formula).unwrap();
        assert!(again.code_edit.is_none(), "{again}");
    }
}

#[test]
fn the_length_of_a_change_is_that_of_all_its_lines() {
    let text = "def f(x):\n    return (x +\n            2)\n";
    let edit = compared("f.py", text, "x - 2").unwrap().code_edit.unwrap();
    assert_eq!(edit.written, "x +\n            2");
    assert_eq!(edit.length, edit.written.chars().count());
}
