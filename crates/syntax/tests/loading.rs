//! Folders of derivations: what is wrong is told all at once, what is right is loaded, and nothing outside is read.

#![allow(clippy::unwrap_used)]

use miette::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{
    LoadError, Loaded, MAX_BYTES, OneByOne, Piece, Provenance, load, load_all,
};

/// A folder of its own for each test, taken away afterwards.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("torse-loading-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(path.join("mini")).unwrap();
        let folder = Self(path);
        folder.head("['claims.toml']", "");
        folder
    }

    fn head(&self, claims: &str, more: &str) {
        let head = format!(
            "[paper]\nid = 'mini'\ntitle = 't'\nauthors = 'a'\nvenue = 'v'\nclaims = {claims}\n{more}"
        );
        self.write("mini/paper.toml", &head);
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn load(&self) -> Loaded {
        load_all(&self.0).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn claim(id: &str, states: &str, more: &str) -> String {
    format!(
        "[[claim]]\nid = '{id}'\nat = 'Sect. 1'\nkind = 'identity'\nprinted = 'p'\nstates = '{states}'\n{more}\n"
    )
}

/// The loaded ids, and each mistake as `message|text under the caret`.
fn told(loaded: &Loaded) -> (Vec<String>, Vec<String>) {
    let claims = loaded.papers.iter().flat_map(|paper| &paper.claims);
    let ids = claims.map(|claim| claim.entry.id.get_ref().clone());
    let told = loaded.errors.iter().map(|error| match error {
        LoadError::Derivation(error) => {
            let label = error.labels().unwrap().next().unwrap();
            let code = error.source_code().unwrap();
            let under = code.read_span(label.inner(), 0, 0).unwrap();
            let under = String::from_utf8(under.data().to_vec()).unwrap();
            format!("{error}|{under}")
        }
        other => other.to_string(),
    });
    (ids.collect(), told.collect())
}

#[test]
fn all_mistakes_of_a_folder_are_told_and_the_good_claims_are_loaded() {
    let folder = Folder::new("all");
    folder.head(
        "['one.toml', 'two.toml', 'broken.toml', 'none.toml']",
        "[symbols]\nx = {}\n",
    );
    let one = [
        claim("mini/good", "x == x", ""),
        claim("mini/syntax", "x = x", ""),
        claim("mini/twice", "x == x +", "assume = ['x >']"),
        claim("mini/field", "x == x", "asume = ['x > 0']"),
        claim("other/id", "x == x", ""),
    ];
    folder.write("mini/one.toml", &one.concat());
    let two = [
        claim("mini/alone", "x == x", "given = ['x == 1']"),
        claim("mini/good", "x == x", ""),
        claim(
            "mini/last",
            "x == x",
            "uses = ['mini/syntax', 'mini/nowhere']",
        ),
        "[sybols]\ny = {}\n".to_owned(),
    ];
    folder.write("mini/two.toml", &two.concat());
    folder.write("mini/broken.toml", "[[claim]\n");
    let loaded = folder.load();
    let (ids, told) = told(&loaded);
    assert_eq!(ids, ["mini/good", "mini/last"]);
    let expected = [
        "unknown field `asume`",
        "`=` does not belong in a formula|=",
        "expected a number, a name or a bracket, found the end",
        "expected a number, a name or a bracket, found the end",
        "the id `other/id` does not begin with `mini/`|other/id",
        "unknown section `sybols`",
        "`given` and `solve_for` go together",
        "the id `mini/good` is used twice",
        "unclosed array table",
        "none.toml",
        "no claim has the id `mini/nowhere`|mini/nowhere",
    ];
    for (told, expected) in told.iter().zip(expected) {
        assert!(told.contains(expected), "{told} is not {expected}");
    }
    assert_eq!(told.len(), expected.len(), "{told:#?}");
    assert!(loaded.left_out.contains(&"mini/twice".to_owned()));
    assert!(load(&folder.0).is_err());
}

#[test]
fn what_rests_on_a_wrong_declaration_is_left_out_without_a_word() {
    let folder = Folder::new("rests");
    let declared = "[symbols]\nx = {}\ny = { in = '[0 1]' }\n\n[define]\n'F(z)' = 'z +'\nG = 'F(1) + 2'\nH = 'x'\n\n";
    let claims = [
        claim("mini/by-symbol", "y == 1", ""),
        claim("mini/by-definition", "F(x) == 1", ""),
        claim("mini/by-another", "G == 1", ""),
        claim("mini/by-derivative", "x == 1", "assume = [\"F''(0) == 1\"]"),
        claim("mini/good", "H == x", ""),
    ];
    folder.write(
        "mini/claims.toml",
        &(declared.to_owned() + &claims.concat()),
    );
    let loaded = folder.load();
    let (ids, told) = told(&loaded);
    assert_eq!(ids, ["mini/good"]);
    assert_eq!(told.len(), 2, "{told:#?}");
    assert!(
        told[0].starts_with("`[0 1]` is not an interval"),
        "{}",
        told[0]
    );
    assert!(told[1].starts_with("expected a number"), "{}", told[1]);
    assert_eq!(loaded.left_out.len(), 4);
}

#[test]
fn malformed_ranges_are_mistakes_and_empty_ones_are_not() {
    for wrong in [
        "in = '[0 1]'",
        "in = '0, 1'",
        "in = '(inf, 0)'",
        "in = '(0, -inf)'",
        "in = '[0, x]'",
        "in = '[0, 2*x)'",
        "in = '[0, 1/0]'",
        "in = '[0, 2*]'",
        "in = '['",
        "in = ''",
        "integer = '2'",
        "integer = '0..'",
        "integer = '>= 1/2'",
        "integer = '0..nothing'",
        "integer = '0..x'",
        "family = 3, indices = ['0..a']",
        "family = 3, indices = ['>= 1']",
        "in = '[0, 1]', integer = '>= 0'",
        "in = 3",
        "near = '[0, 1]'",
    ] {
        let folder = Folder::new("ranges");
        let symbols = format!("[symbols]\na = {{}}\nx = {{ {wrong} }}\n\n");
        folder.write(
            "mini/claims.toml",
            &(symbols + &claim("mini/a", "x == x", "")),
        );
        let (ids, told) = told(&folder.load());
        assert_eq!((ids.len(), told.len()), (0, 1), "{wrong}: {told:#?}");
    }
    for right in [
        "in = '[1, 0]'",
        "in = '(0, 0)'",
        "in = '[-pi/2, pi/2]'",
        "in = '(-inf, inf)'",
        "in = '[0, 3/4*pi - 1)'",
        "in = '[0, sqrt(2)]'",
        "in = '(a, a + 1)'",
        "integer = '5..2'",
        "integer = '>= k'",
        "vector = 'any'",
        "family = 3, indices = ['0..k', '3..1']",
    ] {
        let folder = Folder::new("ranges-right");
        let symbols = format!("[symbols]\nk = {{ integer = '>= 1' }}\nx = {{ {right} }}\n\n");
        folder.write(
            "mini/claims.toml",
            &(symbols + &claim("mini/a", "x == x", "")),
        );
        let (ids, told) = told(&folder.load());
        assert_eq!((ids.len(), told.len()), (1, 0), "{right}: {told:#?}");
    }
}

#[test]
fn names_that_no_formula_can_write_are_not_declared() {
    for wrong in [
        "[symbols]\n'a b' = {}\n",
        "[symbols]\n'x\u{bd}' = {}\n",
        "[symbols]\npi = {}\n",
        "[symbols]\nand = {}\n",
        "[define]\n'2' = '1'\n",
        "[define]\n'F(1)' = '1'\n",
        "[define]\n'F(z, z)' = 'z'\n",
        "[define]\n'pi' = '3'\n",
        "[basis.B]\nvariable = 't t'\ndegree = 0\nseeds = ['1']\nstep = ['t', '1-t']\n",
    ] {
        let folder = Folder::new("names");
        folder.write(
            "mini/claims.toml",
            &format!("{wrong}\n{}", claim("mini/a", "1 == 1", "")),
        );
        let (ids, told) = told(&folder.load());
        assert_eq!((ids.len(), told.len()), (1, 1), "{wrong}: {told:#?}");
    }
}

#[test]
fn a_step_that_depends_on_the_index_names_index_and_degree() {
    for (names, message) in [
        ("index = 'i'", "needs both `index` and `order`"),
        ("order = 'k'", "needs both `index` and `order`"),
        ("index = 'i'\norder = 'i'", "two names"),
        ("index = 'i i'\norder = 'k'", "cannot be a name"),
    ] {
        let folder = Folder::new("counters");
        let basis = format!(
            "[basis.B]\nvariable = 't'\ndegree = 0\nseeds = ['1']\nstep = ['t', '1-t']\n{names}\n"
        );
        let claims = format!("{basis}\n{}", claim("mini/a", "1 == 1", ""));
        folder.write("mini/claims.toml", &claims);
        let (_, told) = told(&folder.load());
        assert!(
            matches!(told.as_slice(), [one] if one.contains(message)),
            "{names}: {told:#?}"
        );
    }
}

#[test]
fn files_and_ids_stay_in_the_papers_folder() {
    let folder = Folder::new("outside");
    folder.write("secret.toml", "secret words");
    for name in [
        "../secret.toml",
        "/etc/passwd",
        "../../../../../../etc/passwd",
        "z/../../secret.toml",
        "./claims.toml",
        "",
        "..",
        "a\\..\\b",
    ] {
        folder.head(&format!("['{name}']"), "");
        let (_, told) = told(&folder.load());
        assert_eq!(told.len(), 1);
        assert!(
            told[0].contains("is not a file in the paper's folder"),
            "{}",
            told[0]
        );
    }
    folder.head("['claims.toml']", "");
    for id in [
        "mini/../../x",
        "mini/z/../x",
        "mini/",
        "mini",
        "mini/.",
        "mini/a..b",
        "mini/a b",
        "/x",
        "mini//x",
    ] {
        folder.write("mini/claims.toml", &claim(id, "1 == 1", ""));
        let (ids, told) = told(&folder.load());
        assert_eq!((ids.len(), told.len()), (0, 1), "{id}: {told:#?}");
        assert!(told[0].ends_with(&format!("|{id}")), "{}", told[0]);
    }
}

#[test]
fn the_id_of_a_paper_is_a_plain_name() {
    let folder = Folder::new("id");
    folder.write("mini/claims.toml", "");
    let head = |id: &str| {
        format!(
            "[paper]\nid = '{id}'\ntitle = 't'\nauthors = 'a'\nvenue = 'v'\nclaims = ['claims.toml']\n"
        )
    };
    for id in [
        "../../evil",
        "/tmp/evil",
        "..",
        ".",
        ".hidden",
        "a/b",
        "a\\b",
        "a..b",
        "",
        "a b",
        "\u{e9}",
    ] {
        folder.write("mini/paper.toml", &head(id));
        let (_, told) = told(&folder.load());
        assert_eq!(told.len(), 1, "{id}: {told:#?}");
        assert!(
            told[0].contains("cannot be the id of a paper"),
            "{}",
            told[0]
        );
        assert!(told[0].ends_with(&format!("|'{id}'")), "{}", told[0]);
    }
    let mut before = "mini";
    for id in ["mini", "gbt-surfaces", "volume_2.1"] {
        fs::rename(folder.path(before), folder.path(id)).unwrap();
        folder.write(&format!("{id}/paper.toml"), &head(id));
        before = id;
        let (_, told) = told(&folder.load());
        assert!(told.is_empty(), "{told:#?}");
    }
}

/// Asserts that the claims file of a folder is refused for this reason, and that no text of it is shown.
fn refused(folder: &Folder, reason: &str) {
    let (ids, told) = told(&folder.load());
    assert_eq!((ids.len(), told.len()), (0, 1), "{told:#?}");
    assert!(told[0].contains(reason), "{}", told[0]);
}

#[test]
fn what_is_no_plain_file_of_a_fair_size_is_refused() {
    let folder = Folder::new("plain");
    refused(&folder, "No such file");
    fs::create_dir(folder.path("mini/claims.toml")).unwrap();
    refused(&folder, "not a regular file");
    fs::remove_dir(folder.path("mini/claims.toml")).unwrap();
    let large = "#".repeat(usize::try_from(MAX_BYTES).unwrap() + 1);
    folder.write("mini/claims.toml", &large);
    refused(&folder, "4194305 bytes; at most 4194304 are read");
    fs::write(folder.path("mini/claims.toml"), b"\xff\xfe").unwrap();
    refused(&folder, "utf-8");
}

#[cfg(unix)]
#[test]
fn pipes_devices_and_links_out_of_the_folder_are_refused() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new("links");
    let claims = folder.path("mini/claims.toml");
    let pipe = std::process::Command::new("mkfifo").arg(&claims).status();
    if pipe.is_ok_and(|status| status.success()) {
        refused(&folder, "not a regular file");
        fs::remove_file(&claims).unwrap();
    }
    symlink("/dev/zero", &claims).unwrap();
    refused(&folder, "not a regular file");
    fs::remove_file(&claims).unwrap();
    folder.write("secret.toml", &claim("mini/a", "1 == 1", ""));
    symlink(folder.path("secret.toml"), &claims).unwrap();
    refused(&folder, "a link out of the paper's folder");
    fs::remove_file(&claims).unwrap();
    folder.write("mini/real.toml", &claim("mini/a", "1 == 1", ""));
    symlink(Path::new("real.toml"), &claims).unwrap();
    assert_eq!(told(&folder.load()).0, ["mini/a"]);
    fs::remove_file(folder.path("mini/paper.toml")).unwrap();
    symlink("/dev/zero", folder.path("mini/paper.toml")).unwrap();
    refused(&folder, "not a regular file");
}

/// A folder with these claims in one file, and what is told of it.
fn told_of(name: &str, claims: &[String]) -> (Loaded, Vec<String>) {
    let folder = Folder::new(name);
    folder.head(
        "['claims.toml']",
        "[symbols]\nx = {}\nnu = { in = '[-1, 1]' }\n",
    );
    folder.write("mini/claims.toml", &claims.concat());
    let loaded = folder.load();
    let (_, told) = told(&loaded);
    (loaded, told)
}

#[test]
fn a_hypothesis_says_whether_it_is_printed_and_where_or_ours_and_why() {
    let more = "assume = ['x > 0', { states = 'x < 3', printed = \"p\\n\" }, { states = 'x < 2', printed = 'p', in = 'mini/b' }, { states = 'x < 1', ours = 'because' }]\n\
                symbols = { nu = { in = '(0, 1]', printed = 'p', printed_in = 'mini/b' }, y = { ours = 'a line' } }";
    let claims = [
        claim("mini/a", "x == x", more),
        claim("mini/b", "x == x", ""),
    ];
    let (loaded, told) = told_of("provenance", &claims);
    assert_eq!(told, Vec::<String>::new());
    let a = &loaded.papers[0].claims[0];
    let from = a.assumptions.iter().map(|h| match &h.provenance {
        Provenance::Stated => "stated".to_owned(),
        Provenance::Printed(quote) => format!("{} in {}", quote.words.trim(), quote.claim),
        Provenance::Ours { reason } => format!("ours: {reason}"),
    });
    assert_eq!(
        from.collect::<Vec<_>>(),
        ["stated", "p in mini/a", "p in mini/b", "ours: because"]
    );
    let narrowed = a.declarations.range("nu").unwrap();
    assert!(matches!(
        &narrowed.outer,
        Some(SymbolKind::Real(interval)) if interval.lower.as_ref().unwrap().closed
    ));
    assert_eq!(narrowed.provenance.quote().unwrap().claim, "mini/b");
    let new = a.declarations.range("y").unwrap();
    assert!(new.outer.is_none() && new.provenance.is_ours());
    assert!(
        loaded.papers[0].claims[1]
            .declarations
            .range("nu")
            .is_none()
    );
}

#[test]
fn a_quote_that_is_not_printed_is_a_mistake_at_its_words() {
    let assume = |table: &str| claim("mini/a", "x == x", &format!("assume = [{table}]"));
    for (table, expected) in [
        (
            "{ states = 'x > 0', printed = 'P' }",
            "`P` is not in the print of `mini/a`|P",
        ),
        (
            "{ states = 'x > 0', printed = 'p', in = 'mini/c' }",
            "no claim has the id `mini/c`, so these words are in no print|p",
        ),
        (
            "{ states = 'x > 0', printed = 'p', ours = 'o' }",
            "a hypothesis is `printed` or `ours`, not both|o",
        ),
        (
            "{ states = 'x > 0', in = 'mini/a' }",
            "this names a claim, but no words of it are quoted|mini/a",
        ),
        (
            "{ states = 'x > 0', ours = ' ' }",
            "the reason is missing| ",
        ),
        (
            "{ states = 'x > 0', printed = '' }",
            "an empty quote says nothing|''",
        ),
        (
            "{ states = 'x > 0' }",
            "nothing says where this is from|'x > 0'",
        ),
        (
            "{ states = 'x > ', ours = 'o' }",
            "expected a number, a name or a bracket, found the end of the formula|",
        ),
        (
            "{ state = 'x > 0', ours = 'o' }",
            "unknown field `state`, expected one of `states`, `printed`, `in`, `ours`|state",
        ),
        (
            "3",
            "invalid type: integer `3`, expected a formula, or a table with `states` and `printed` or `ours`|3",
        ),
    ] {
        let (_, told) = told_of("quotes", &[assume(table)]);
        assert_eq!(told, [expected], "{table}");
    }
    let answered = "answers = [{ flag = 'one-degree', quote = 'q' }]";
    let (_, told) = told_of("answers", &[claim("mini/a", "x == x", answered)]);
    assert_eq!(told, ["`q` is not in the print of `mini/a`|q"]);
    let unknown = "answers = [{ flag = 'one-degre', quote = 'p' }]";
    let (_, told) = told_of("answers", &[claim("mini/a", "x == x", unknown)]);
    assert!(
        told[0].starts_with("unknown variant `one-degre`"),
        "{told:?}"
    );
}

#[test]
fn a_range_of_a_paper_names_the_claim_that_prints_it() {
    for (range, expected) in [
        ("printed = 'p', printed_in = 'mini/a'", None),
        (
            "printed = 'q', printed_in = 'mini/a'",
            Some("`q` is not in the print of `mini/a`|q"),
        ),
        (
            "printed = 'p'",
            Some("nothing says where this is printed|p"),
        ),
        ("ours = 'o'", None),
    ] {
        let folder = Folder::new("ranges");
        let symbols = format!("[symbols]\nx = {{ in = '[0, 1]', {range} }}\n");
        folder.head("['claims.toml']", &symbols);
        folder.write("mini/claims.toml", &claim("mini/a", "x == x", ""));
        let (_, told) = told(&folder.load());
        assert_eq!(told, expected.into_iter().collect::<Vec<_>>(), "{range}");
    }
}

#[test]
fn readings_are_claims_that_add_to_the_fields_of_the_sentence() {
    let head = "[[claim]]\nid = 'mini/a'\nat = ''\nkind = 'property'\nprinted = 'p'\nassume = ['x > 0']\nlet = { c = '1' }\n";
    let literal = "[[claim.readings]]\nname = 'literal'\nsays = 'one'\nstates = 'x == c'\n";
    let other = "[[claim.readings]]\nname = 'other'\nsays = 'two'\nstates = 'x == d'\nassume = ['x < 1']\nlet = { d = 'c' }\n";
    let (loaded, told) = told_of("readings", &[[head, literal, other].concat()]);
    assert_eq!(told, Vec::<String>::new());
    let claim = &loaded.papers[0].claims[0];
    assert!(claim.statement.is_none());
    let [one, two] = claim.readings.as_slice() else {
        panic!("{:?}", claim.readings);
    };
    assert_eq!((one.name.as_str(), two.says.as_str()), ("literal", "two"));
    assert_eq!(
        (one.claim.assumptions.len(), two.claim.assumptions.len()),
        (1, 2)
    );
    assert!(one.claim.declarations.definition("d").is_none());
    assert!(two.claim.declarations.definition("c").is_some() && two.claim.statement.is_some());

    let states = format!("{head}states = 'x == 1'\n{literal}{other}");
    for (claims, expected) in [
        (
            format!("{head}{literal}"),
            "a single reading belongs in `states`|literal",
        ),
        (
            format!("{head}{literal}{literal}"),
            "each reading has a name of its own|literal",
        ),
        (
            states,
            "a sentence with `readings` has no `states` of its own|x == 1",
        ),
    ] {
        let (_, told) = told_of("readings", &[claims]);
        assert_eq!(told, [expected]);
    }
}

#[test]
fn parts_are_called_after_their_sentence_and_used_together() {
    let part = |id: &str, of: &str| claim(id, "x == x", &format!("part_of = '{of}'"));
    let user = claim(
        "mini/b",
        "x == x",
        "uses = ['mini/a']\nassume = [{ states = 'x > 0', printed = 'p', in = 'mini/a' }]",
    );
    let good = [
        part("mini/a.one", "mini/a"),
        part("mini/a.two", "mini/a"),
        user,
    ];
    let (loaded, told) = told_of("parts", &good);
    assert_eq!(told, Vec::<String>::new());
    let claims = &loaded.papers[0].claims;
    assert_eq!(claims[2].uses, ["mini/a.one", "mini/a.two"]);
    assert_eq!(claims[0].sentence_id().unwrap(), "mini/a");

    let (_, told) = told_of("parts", &[part("mini/a.one", "mini/b")]);
    assert_eq!(told, ["`mini/a.one` is no part of `mini/b`|mini/b"]);
    let (_, told) = told_of(
        "parts",
        &[part("mini/a.one", "mini/a"), claim("mini/a", "x == x", "")],
    );
    assert_eq!(told, ["`mini/a` is a claim itself|mini/a"]);
}

#[test]
fn a_finding_is_words_with_formulas_in_braces() {
    let finding = |text: &str| claim("mini/a", "x == x", &format!("finding = '{text}'"));
    let (loaded, told) = told_of(
        "finding",
        &[finding("$x^{2}$ is {x^2 : 3}, {x}{x : degrees}")],
    );
    assert_eq!(told, Vec::<String>::new());
    let finding_of = |loaded: &Loaded| loaded.papers[0].claims[0].author_note.clone().unwrap();
    let pieces = finding_of(&loaded)
        .pieces
        .into_iter()
        .map(|piece| match piece {
            Piece::Words(words) => words,
            Piece::Hole(_, form) => format!("{form:?}"),
        });
    assert_eq!(
        pieces.collect::<Vec<_>>(),
        ["$x^{2}$ is ", "Digits(3)", ", ", "Plain", "Degrees"]
    );
    for (text, expected) in [
        ("is {x", "this `{` is not matched|{"),
        ("is x}", "this `}` is not matched|}"),
        ("is $x", "this `$` is not matched|$"),
        ("is {x : many}", "`many` is not a format of a number| many"),
        (
            "is {x +}",
            "expected a number, a name or a bracket, found the end of the formula|",
        ),
        (" ", "this says nothing| "),
    ] {
        let (_, told) = told_of("finding", &[finding(text)]);
        assert_eq!(told, [expected], "{text}");
    }
}

#[test]
fn names_are_displayed_as_the_paper_prints_them() {
    let (loaded, told) = told_of(
        "display",
        &[claim("mini/a", "x == x", "display = { x = '$\\xi$' }")],
    );
    assert_eq!(told, Vec::<String>::new());
    let claim_of = |loaded: &Loaded| Arc::clone(&loaded.papers[0].claims[0].declarations);
    assert_eq!(claim_of(&loaded).display("x"), Some("$\\xi$"));
    assert_eq!(claim_of(&loaded).display("nu"), None);
    for (display, expected) in [
        (
            "y = '$y$'",
            "`y` is not declared, so it is not displayed|$y$",
        ),
        ("x = 'xi'", "`xi` is not mathematics: write `$...$`|xi"),
    ] {
        let claim = claim("mini/a", "x == x", &format!("display = {{ {display} }}"));
        let (_, told) = told_of("display", &[claim]);
        assert_eq!(told, [expected]);
    }
}

#[test]
fn papers_that_are_loaded_one_by_one_are_those_that_are_loaded_together() {
    let folder = Folder::new("one-by-one");
    let paper = |slug: &str, claims: &str| {
        fs::create_dir_all(folder.path(slug)).unwrap();
        let head = format!(
            "[paper]\nid = '{slug}'\ntitle = 't'\nauthors = 'a'\nvenue = 'v'\nclaims = ['claims.toml']\n[symbols]\nx = {{}}\n"
        );
        folder.write(&format!("{slug}/paper.toml"), &head);
        folder.write(&format!("{slug}/claims.toml"), claims);
    };
    let part = |id: &str, states: &str| claim(id, states, "part_of = 'later/b'");
    let quoting = |words: &str, of: &str| {
        format!("given = [{{ states = 'x > 0', printed = '{words}', in = '{of}' }}]")
    };
    let uses = "uses = ['later/b', 'later/nothing', 'nowhere/a', 'bare']";
    paper(
        "first",
        &[
            claim("first/a", "x == x", uses),
            claim("first/b", "x == x", &quoting("p", "later/a")),
            claim("first/c", "x == x", &quoting("q", "later/b")),
            claim("first/d", "x == x", "uses = ['later/wrong', 'last/a']"),
            // Not its own, and in nobody's way.
            claim("later/a", "x == x", ""),
        ]
        .concat(),
    );
    paper(
        "later",
        &[
            claim("later/a", "x == x", "uses = ['first/a']"),
            part("later/b.1", "x == x"),
            part("later/b.2", "x == x"),
            part("later/b.3", "x + == x"),
            claim("later/wrong", "x + == x", ""),
            claim("later/a", "x == x", ""),
        ]
        .concat(),
    );
    folder.write("mini/claims.toml", "");
    fs::create_dir_all(folder.path("renamed")).unwrap();
    let head = fs::read_to_string(folder.path("later/paper.toml")).unwrap();
    folder.write("renamed/paper.toml", &head);
    fs::create_dir_all(folder.path("unreadable")).unwrap();
    folder.write("unreadable/paper.toml", "[");
    let together = folder.load();
    let mut one_by_one = OneByOne::find(&folder.0).unwrap();
    let slugs = one_by_one.slugs().to_vec();
    assert_eq!(slugs, ["first", "later", "mini", "renamed", "unreadable"]);
    assert!(one_by_one.has("mini") && !one_by_one.has("nowhere"));
    let mut apart = Loaded {
        papers: vec![],
        errors: vec![],
        left_out: vec![],
    };
    for slug in &slugs {
        let loaded = one_by_one.load(slug);
        apart.papers.extend(loaded.papers);
        apart.errors.extend(loaded.errors);
        apart.left_out.extend(loaded.left_out);
    }
    let sorted = |loaded: &Loaded| {
        let (ids, mut mistakes) = told(loaded);
        mistakes.sort();
        (ids, mistakes)
    };
    assert_eq!(sorted(&apart), sorted(&together));
    assert_eq!(apart.left_out, together.left_out);
    let rests_on = |loaded: &Loaded| {
        let claims = loaded
            .papers
            .iter()
            .flat_map(torse_syntax::derivation::Paper::rests_on);
        claims.collect::<Vec<_>>()
    };
    assert_eq!(rests_on(&apart), rests_on(&together));
    let (ids, mistakes) = told(&together);
    assert_eq!(
        ids.iter().filter(|id| *id == "later/a").count(),
        1,
        "{ids:?}"
    );
    for mistake in [
        "the folder of the paper `later` is called `renamed`: both have one name|",
        "no claim has the id `later/nothing`|",
        "the id `later/a` is used twice|",
    ] {
        assert!(
            mistakes.iter().any(|told| told.starts_with(mistake)),
            "{mistake}: {mistakes:?}"
        );
    }
    let first = &together.papers[0].claims[0];
    assert!(
        first
            .uses
            .starts_with(&["later/b.1".to_owned(), "later/b.2".to_owned()])
    );
}

#[test]
fn names_of_functions_of_values_are_not_declared_anew() {
    let folder = Folder::new("functions");
    folder.head(
        "['claims.toml']",
        "[symbols]\nx = {}\nlog = { function = 1 }\nsin = {}\n[define]\n'asin(x)' = 'x'\n'product(x)' = '2*x'\n",
    );
    folder.write(
        "mini/claims.toml",
        &claim("mini/a", "product(x) == 2*x", ""),
    );
    let (ids, told) = told(&folder.load());
    assert_eq!(ids, ["mini/a"]);
    let taken = ["log", "asin"].map(|name| {
        format!("`{name}` is a function of the language and cannot be declared anew: choose another name")
    });
    let told: Vec<&str> = told
        .iter()
        .filter_map(|one| one.split('|').next())
        .collect();
    assert_eq!(told, taken);
}

#[test]
fn an_end_of_an_interval_may_have_commas_in_brackets() {
    let folder = Folder::new("commas");
    folder.head(
        "['claims.toml']",
        "[symbols]\nm = { integer = '>= 0' }\nx = { in = '[sum(i, 0, m, i), max(m, 10)]' }\ny = { in = '[1, 2, 3]' }\n",
    );
    folder.write("mini/claims.toml", &claim("mini/a", "x <= x", ""));
    let loaded = folder.load();
    let (ids, told) = told(&loaded);
    assert_eq!(ids, ["mini/a"]);
    assert_eq!(told.len(), 1, "{told:?}");
    let SymbolKind::Real(interval) = loaded.papers[0].declarations.symbol("x").unwrap() else {
        panic!("a number is declared");
    };
    let text = |end: &Option<torse_syntax::derivation::declarations::End>| {
        let formula = &end.as_ref().unwrap().formula;
        formula.origin.text(formula.expr.place).unwrap().to_owned()
    };
    assert_eq!(text(&interval.above), "sum(i, 0, m, i)");
    assert_eq!(text(&interval.below), "max(m, 10)");
}
