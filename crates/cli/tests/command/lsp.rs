//! `torse lsp`, by a client that speaks with the real binary.

use crate::support::{add_paper, claim, mini};
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// No answer may take longer.
const PATIENCE: Duration = Duration::from_secs(120);

/// An editor, as far as the server sees one.
struct Client {
    server: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// What came while something else was waited for.
    passed: Vec<Value>,
    last: i64,
}

impl Client {
    /// Starts a server and speaks with it as far as `initialized`.
    fn new(options: &[&str]) -> Self {
        let mut client = Self::unstarted(options);
        let begun = client.ask(
            "initialize",
            json!({ "processId": null, "rootUri": null, "capabilities": {} }),
        );
        assert_eq!(begun["capabilities"]["positionEncoding"], "utf-16");
        assert_eq!(begun["serverInfo"]["name"], "torse");
        client.tell("initialized", json!({}));
        client
    }

    fn unstarted(options: &[&str]) -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_torse"))
            .arg("lsp")
            .args(options)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut output = BufReader::new(server.stdout.take().unwrap());
        let (sender, messages) = channel();
        thread::spawn(move || {
            while let Some(message) = frame(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let input = server.stdin.take();
        Self {
            server,
            input,
            messages,
            passed: vec![],
            last: 0,
        }
    }

    fn send_bytes(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().unwrap();
        // A server that has gone is seen by its exit code.
        let _ = input.write_all(bytes).and_then(|()| input.flush());
    }

    fn send_text(&mut self, text: &str) {
        self.send_bytes(format!("Content-Length: {}\r\n\r\n{text}", text.len()).as_bytes());
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send_text(
            &json!({ "jsonrpc": "2.0", "method": method, "params": params }).to_string(),
        );
    }

    /// Asks, and returns the whole answer.
    fn answer(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let id = self.last;
        self.send_text(
            &json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }).to_string(),
        );
        self.next(|message| message["id"] == id)
    }

    /// Asks, and returns the result.
    fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer.get("error").is_none(), "{answer}");
        answer["result"].clone()
    }

    /// The next message of this kind; others are kept.
    fn next(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.passed.iter().position(&wanted) {
            return self.passed.remove(at);
        }
        let begun = Instant::now();
        loop {
            let left = PATIENCE.saturating_sub(begun.elapsed());
            let message = self.messages.recv_timeout(left);
            let message = message.expect("the server answers");
            if wanted(&message) {
                return message;
            }
            self.passed.push(message);
        }
    }

    fn open(&mut self, path: &Path, text: &str) {
        let document =
            json!({ "uri": uri(path), "languageId": "toml", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces a range of an open text, `[line, character, line, character]`.
    fn change(&mut self, path: &Path, range: [u32; 4], text: &str) {
        let [line, character, end_line, end] = range;
        let range = json!({
            "start": { "line": line, "character": character },
            "end": { "line": end_line, "character": end },
        });
        let changes = json!([{ "range": range, "text": text }]);
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": uri(path), "version": 2 }, "contentChanges": changes }),
        );
    }

    /// Waits for diagnostics of a file that are as wanted.
    fn diagnostics(&mut self, path: &Path, wanted: impl Fn(&[Value]) -> bool) -> Vec<Value> {
        let uri = uri(path);
        let message = self.next(|message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == uri.as_str()
                && wanted(message["params"]["diagnostics"].as_array().unwrap())
        });
        message["params"]["diagnostics"].as_array().unwrap().clone()
    }

    fn at(&mut self, method: &str, path: &Path, line: u32, character: u32) -> Value {
        self.ask(
            method,
            json!({
                "textDocument": { "uri": uri(path) },
                "position": { "line": line, "character": character },
            }),
        )
    }

    fn hover(&mut self, path: &Path, line: u32, character: u32) -> String {
        let said = self.at("textDocument/hover", path, line, character);
        said["contents"]["value"].as_str().unwrap_or("").to_owned()
    }

    fn completions(&mut self, path: &Path, line: u32, character: u32) -> Vec<String> {
        let offers = self.at("textDocument/completion", path, line, character);
        let labels = offers.as_array().unwrap().iter();
        labels
            .map(|offer| offer["label"].as_str().unwrap().to_owned())
            .collect()
    }

    /// Ends as the protocol says, and returns the exit code.
    fn leave(mut self) -> Option<i32> {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        self.ended()
    }

    /// Waits for the end, and returns the exit code.
    fn ended(mut self) -> Option<i32> {
        let begun = Instant::now();
        loop {
            if let Some(status) = self.server.try_wait().unwrap() {
                return status.code();
            }
            assert!(begun.elapsed() < PATIENCE, "it did not end");
            thread::sleep(Duration::from_millis(20));
        }
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

fn frame(output: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim_end() {
            "" => break,
            header => length = header.strip_prefix("Content-Length: ")?.parse().ok()?,
        }
    }
    let mut body = vec![0; length];
    output.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

fn uri(path: &Path) -> String {
    format!("file://{}", path.to_string_lossy().replace(' ', "%20"))
}

fn codes(diagnostics: &[Value]) -> Vec<&str> {
    diagnostics
        .iter()
        .map(|of| of["code"].as_str().unwrap())
        .collect()
}

/// Whether these are the diagnostics, by their codes.
fn are<'c>(wanted: &'c [&'c str]) -> impl Fn(&[Value]) -> bool + 'c {
    move |found| codes(found) == wanted
}

#[test]
fn an_editor_sees_faults_verdicts_and_corrections_beside_the_lines() {
    // Letters of two units stand before the statement.
    let good = claim("good", "x - x == 0", "note = '𝜇𝜇'");
    let slip = "[[claim]]\nid = \"mini/slip\"\nat = \"eq. (2)\"\nkind = \"identity\"\nprinted = \"𝜇\"\n\
                states = '(x + 1)^2 == x^2 - 2*x + 1'\n";
    let text = format!("{good}{slip}");
    let folder = mini(&text);
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::new(&["--stdio"]);
    client.open(&path, &text);
    let found = client.diagnostics(&path, are(&["holds", "misprint"]));
    let [good, slip] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(
        (good["severity"].as_u64(), slip["severity"].as_u64()),
        (Some(4), Some(2))
    );
    let line = |of: &Value| of["range"]["start"]["line"].as_u64().unwrap();
    let stated = |name: &str| {
        let mut lines = text.lines();
        lines.position(|line| line.starts_with(name)).unwrap() as u64
    };
    assert_eq!(line(good), stated("states = 'x - x"));
    let slip_line = stated("states = '(x");
    assert_eq!(line(slip), slip_line);
    let message = slip["message"].as_str().unwrap();
    assert!(message.starts_with("misprint: "), "{message}");
    assert!(
        message.contains("corrected: (x + 1)^2 == x^2 + 2*x + 1"),
        "{message}"
    );

    // What `verify` says of it is said here.
    let said = crate::support::on(folder.path(), &["verify"]);
    let finding = message
        .lines()
        .next()
        .unwrap()
        .strip_prefix("misprint: ")
        .unwrap();
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words(&said.out).contains(&words(finding)),
        "{}\n{finding}",
        said.out
    );

    // The correction is offered where it belongs.
    let range = slip["range"].clone();
    let context = json!({ "diagnostics": [] });
    let actions = client.ask(
        "textDocument/codeAction",
        json!({ "textDocument": { "uri": uri(&path) }, "range": range, "context": context }),
    );
    let edit = &actions[0]["edit"]["changes"][uri(&path)][0];
    assert_eq!(edit["newText"], "'(x + 1)^2 == x^2 + 2*x + 1'");
    assert_eq!(edit["range"], range);

    // It is made as the editor would make it: then the claim holds, and nothing is offered.
    let at = |of: &Value, end: &str, what: &str| of[end][what].as_u64().unwrap() as u32;
    let places = [
        at(&range, "start", "line"),
        at(&range, "start", "character"),
        at(&range, "end", "line"),
        at(&range, "end", "character"),
    ];
    client.change(&path, places, edit["newText"].as_str().unwrap());
    client.diagnostics(&path, are(&["holds", "holds"]));
    let actions = client.ask(
        "textDocument/codeAction",
        json!({ "textDocument": { "uri": uri(&path) }, "range": range, "context": context }),
    );
    assert_eq!(actions, json!([]));

    // A fault is shown where it stands, with letters of two units before it in its line.
    let slip_line = slip_line as u32;
    client.change(
        &path,
        [slip_line, 0, slip_line, 99],
        "states = 'x == y' # 𝜇",
    );
    let found = client.diagnostics(&path, |found| codes(found).contains(&"mistake"));
    let mistake = found.iter().find(|of| of["code"] == "mistake").unwrap();
    assert!(
        mistake["message"]
            .as_str()
            .unwrap()
            .contains("`y` is not declared"),
        "{mistake}"
    );
    let wanted = json!({
        "start": { "line": slip_line, "character": 15 },
        "end": { "line": slip_line, "character": 16 },
    });
    assert_eq!(
        (&mistake["range"], mistake["severity"].as_u64()),
        (&wanted, Some(1))
    );
    client.change(&path, [slip_line, 0, slip_line, 99], "note = '𝜇', b");
    let found = client.diagnostics(&path, |found| codes(found).contains(&"mistake"));
    let start = &found[0]["range"]["start"];
    assert_eq!(
        start["line"].as_u64(),
        Some(u64::from(slip_line)),
        "{found:?}"
    );

    // A text that is closed has nothing beside it.
    client.tell(
        "textDocument/didClose",
        json!({ "textDocument": { "uri": uri(&path) } }),
    );
    client.diagnostics(&path, are(&[]));
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn a_fault_in_the_head_is_shown_there_although_another_file_is_open() {
    let text = claim("one", "a == 2", "");
    let folder = mini(&text);
    let head = folder.path().join("mini/paper.toml");
    let mut broken = fs::read_to_string(&head).unwrap();
    broken.push_str("[define]\na = '1 +'\n");
    fs::write(&head, &broken).unwrap();
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::new(&[]);
    client.open(&path, &text);
    let found = client.diagnostics(&head, are(&["mistake"]));
    let line = found[0]["range"]["start"]["line"].as_u64().unwrap();
    assert_eq!(broken.lines().nth(line as usize), Some("a = '1 +'"));
    // It is mended in the editor, and not saved.
    let mended = broken.replace("1 +", "1 + 1");
    client.open(&head, &mended);
    client.diagnostics(&head, are(&[]));
    client.diagnostics(&path, are(&["holds"]));
    // What the head names and nobody can read is a fault of the head.
    let missing = mended.replace("\"claims.toml\"", "\"claims.toml\", \"more.toml\"");
    client.tell(
        "textDocument/didChange",
        json!({
            "textDocument": { "uri": uri(&head), "version": 3 },
            "contentChanges": [{ "text": missing }],
        }),
    );
    let found = client.diagnostics(&head, are(&["mistake"]));
    assert!(
        found[0]["message"].as_str().unwrap().contains("more.toml"),
        "{found:?}"
    );
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn names_verdicts_and_keys_are_described_and_completed() {
    let text = format!(
        "[define]\n\"F(t)\" = 't^2'\n\n{}{}",
        claim("wrong", "F(x) == sqrt(x)", "expect = 'false'"),
        "[[claim]]\nid = 'mini/new'\nst\n"
    );
    let folder = mini(&text);
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::new(&[]);
    client.open(&path, &text);
    client.diagnostics(&path, |found| codes(found).contains(&"mistake"));
    // The half of a key is a fault; without it the file is read.
    let lines = |needle: &str| {
        text.lines()
            .position(|line| line.starts_with(needle))
            .unwrap() as u32
    };
    let half = text.lines().position(|line| line == "st").unwrap() as u32;
    let states = lines("states");
    client.change(&path, [half - 2, 0, half + 1, 0], "");
    client.diagnostics(&path, are(&["false"]));

    let column = |needle: &str| {
        let line = text.lines().nth(states as usize).unwrap();
        line.find(needle).unwrap() as u32
    };
    assert!(
        client
            .hover(&path, states, column("F(x)"))
            .contains("F(t) := t^2")
    );
    assert!(
        client
            .hover(&path, states, column("x)"))
            .contains("x in [0, 1]")
    );
    assert!(
        client
            .hover(&path, states, column("sqrt") + 2)
            .contains("sqrt(r)")
    );
    let found = client.hover(&path, states, column("=="));
    for part in [
        "**false**",
        "mini/wrong",
        "fails at",
        "left side",
        "evidence",
    ] {
        assert!(found.contains(part), "{part}: {found}");
    }
    let key = client.hover(&path, states, 2);
    assert!(
        key.contains("The statement in the formula language."),
        "{key}"
    );
    assert_eq!(client.hover(&path, 0, 3), "");

    let offers = client.completions(&path, states, column("F(x)"));
    for name in ["integral", "F", "x", "P"] {
        assert!(
            offers.iter().any(|offer| offer == name),
            "{name}: {offers:?}"
        );
    }
    assert!(!offers.iter().any(|offer| offer == "printed"));
    let keys = client.completions(&path, states + 1, 0);
    assert!(keys.iter().any(|key| key == "printed"), "{keys:?}");
    let kinds = client.completions(&path, lines("kind"), 10);
    assert!(kinds.iter().any(|kind| kind == "inequality"), "{kinds:?}");
    assert_eq!(client.leave(), Some(0));
}

/// Takes longer than anybody waits, with a budget without end.
const ENDLESS: &str = "(a + b + c + d + f + g)^40*(a - b + c - d + f - g)^40 == ((a + b + c + d + f + g)*(a - b + c - d + f - g))^40";

#[test]
fn the_server_answers_while_it_decides_and_an_edit_ends_what_is_void() {
    let symbols = "[symbols]\na = {}\nb = {}\nc = {}\nd = {}\nf = {}\ng = {}\n";
    let text = format!("{symbols}{}", claim("long", ENDLESS, ""));
    let folder = mini(&text);
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::new(&["--budget", "1000000000000000"]);
    client.open(&path, &text);
    let states = text
        .lines()
        .position(|line| line.starts_with("states"))
        .unwrap() as u32;
    let begun = Instant::now();
    // The folder is read before it is decided.
    let mut said = String::new();
    while said.is_empty() && begun.elapsed() < PATIENCE {
        said = client.hover(&path, states, 11);
    }
    assert!(said.contains("a, a real number"), "{said}");
    thread::sleep(Duration::from_millis(500));
    let found = client.hover(&path, states - 1, 3);
    assert!(
        found.is_empty() || found.contains("The statement as printed"),
        "{found}"
    );
    let middle = text
        .lines()
        .nth(states as usize)
        .unwrap()
        .find("==")
        .unwrap() as u32;
    let found = client.hover(&path, states, middle);
    assert!(found.contains("not decided yet"), "{found}");
    client.change(
        &path,
        [states, 0, states, 9999],
        "states = 'a + b == b + a'",
    );
    client.diagnostics(&path, are(&["holds"]));
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn messages_that_make_no_sense_are_refused_and_the_next_are_answered() {
    let folder = mini(&claim("one", "x == x", ""));
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::unstarted(&[]);
    let code = |answer: &Value| answer["error"]["code"].as_i64();
    let early = client.answer("textDocument/hover", json!({}));
    assert_eq!(code(&early), Some(-32002));
    client.ask("initialize", json!({ "capabilities": {} }));
    assert_eq!(code(&client.answer("initialize", json!({}))), Some(-32600));
    for text in ["{", "[]", "{\"id\":1}", "null", "\u{1}"] {
        client.send_text(text);
        let refused =
            client.next(|message| message["id"].is_null() && message["error"].is_object());
        assert_eq!(code(&refused), Some(-32700), "{text}");
    }
    assert_eq!(
        code(&client.answer("textDocument/hover", json!({ "position": 3 }))),
        Some(-32602)
    );
    assert_eq!(
        code(&client.answer("workspace/nothing", json!({}))),
        Some(-32601)
    );
    // Of texts that are not open there is nothing to say; changes of them are logged.
    assert_eq!(client.at("textDocument/hover", &path, 0, 0), Value::Null);
    client.change(&path, [0, 0, 0, 0], "x");
    let logged = client.next(|message| message["method"] == "window/logMessage");
    assert!(
        logged["params"]["message"]
            .as_str()
            .unwrap()
            .contains("is not open"),
        "{logged}"
    );
    // An address that is no file, and a file that belongs to no paper.
    for uri in ["untitled:Untitled-1", "file:///nowhere/at/all.toml"] {
        let document = json!({ "uri": uri, "languageId": "toml", "version": 1, "text": "[[claim" });
        client.tell("textDocument/didOpen", json!({ "textDocument": document }));
        let place =
            json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": 0 } });
        assert_eq!(client.ask("textDocument/hover", place), Value::Null);
    }
    client.tell("textDocument/didOpen", json!({ "textDocument": 3 }));
    client.next(|message| message["method"] == "window/logMessage");
    client.tell("$/setTrace", json!({ "value": "off" }));
    // A place far outside of the text.
    client.open(&path, &claim("one", "x == x", ""));
    client.diagnostics(&path, are(&["holds"]));
    client.at(
        "textDocument/completion",
        &path,
        4_000_000_000,
        4_000_000_000,
    );
    assert_eq!(client.ask("shutdown", Value::Null), Value::Null);
    assert_eq!(
        code(&client.answer("textDocument/hover", json!({}))),
        Some(-32600)
    );
    client.tell("exit", Value::Null);
    assert_eq!(client.ended(), Some(0));
}

#[test]
fn an_editor_that_is_gone_and_input_without_frames_end_the_server() {
    let mut client = Client::new(&[]);
    client.tell("exit", Value::Null);
    assert_eq!(client.ended(), Some(1), "without shutdown");
    let mut client = Client::new(&[]);
    client.input = None;
    assert_eq!(client.ended(), Some(1), "end of the input");
    let mut client = Client::new(&[]);
    client.send_bytes(b"GET / HTTP/1.1\r\n\r\n");
    assert_eq!(client.ended(), Some(5), "no frame");
    let mut client = Client::new(&[]);
    client.send_bytes(b"Content-Length: 18446744073709551615\r\n\r\n");
    assert_eq!(client.ended(), Some(5), "a length that nobody has");
}

#[test]
fn papers_that_are_not_open_are_not_decided_and_not_shown() {
    let text = claim("one", "x == x", "");
    let folder = mini(&text);
    add_paper(folder.path(), "other", "[[claim");
    let path = folder.path().join("mini/claims.toml");
    let mut client = Client::new(&[]);
    client.open(&path, &text);
    client.diagnostics(&path, are(&["holds"]));
    let other = uri(&folder.path().join("other/claims.toml"));
    assert!(
        !client
            .passed
            .iter()
            .any(|message| message["params"]["uri"] == other.as_str())
    );
    assert_eq!(client.leave(), Some(0));
}
