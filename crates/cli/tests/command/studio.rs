//! `torse studio`: what the real command answers over TCP, and what it refuses.

use crate::support::torse;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// A studio that serves, ended when it goes.
struct Serving {
    child: Child,
    /// `127.0.0.1:PORT`.
    host: String,
    /// `/SECRET/`.
    path: String,
}

/// An answer over TCP.
struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Answer {
    fn header(&self, name: &str) -> Option<&str> {
        let mut lines = self.head.lines().filter_map(|line| line.split_once(": "));
        lines.find_map(|(own, value)| own.eq_ignore_ascii_case(name).then_some(value))
    }

    fn text(&self) -> &str {
        std::str::from_utf8(&self.body).unwrap()
    }
}

impl Serving {
    fn start(folder: &Path, page: &Path) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_torse"))
            .arg("studio")
            .arg(folder)
            .arg("--page")
            .arg(page)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut output = BufReader::new(child.stdout.take().unwrap());
        output.read_line(&mut line).unwrap();
        let rest = line.trim().strip_prefix("http://").unwrap();
        let (host, path) = rest.split_at(rest.find('/').unwrap());
        Self {
            child,
            host: host.to_owned(),
            path: path.to_owned(),
        }
    }

    fn ask(&self, method: &str, url: &str, headers: &[(&str, &str)], body: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(60)))
            .unwrap();
        let mut head = format!(
            "{method} {url} HTTP/1.1\r\nConnection: close\r\nContent-Length: {}\r\n",
            body.len()
        );
        if headers.iter().all(|(name, _)| *name != "Host") {
            head += &format!("Host: {}\r\n", self.host);
        }
        for (name, value) in headers {
            head += &format!("{name}: {value}\r\n");
        }
        // A refusal may come, and the connection end, before all of a long body is sent.
        let _ = stream.write_all(&[(head + "\r\n").as_bytes(), body].concat());
        let mut whole = vec![];
        let _ = stream.read_to_end(&mut whole);
        let end = whole.windows(4).position(|w| w == b"\r\n\r\n").unwrap();
        let head = String::from_utf8(whole[..end].to_vec()).unwrap();
        Answer {
            status: head.split(' ').nth(1).unwrap().parse().unwrap(),
            head,
            body: whole[end + 4..].to_vec(),
        }
    }

    /// What is below the path.
    fn get(&self, name: &str) -> Answer {
        self.ask("GET", &format!("{}{name}", self.path), &[], b"")
    }

    fn put(&self, name: &str, tag: &str, text: &[u8]) -> Answer {
        self.ask(
            "PUT",
            &format!("{}file?name={name}", self.path),
            &[("If-Match", tag)],
            text,
        )
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A folder with a design in it and a secret beside it, and a page that stands for the real one.
fn folders() -> (TempDir, TempDir) {
    let (outer, page) = (TempDir::new().unwrap(), TempDir::new().unwrap());
    fs::create_dir_all(outer.path().join("shop/parts")).unwrap();
    fs::write(outer.path().join("secret.toml"), "secret").unwrap();
    fs::write(outer.path().join("shop/cone.toml"), "[let]\na = 1\n").unwrap();
    fs::write(outer.path().join("shop/parts/rim.svg"), "<svg/>").unwrap();
    fs::write(page.path().join("studio.html"), "the page").unwrap();
    fs::write(page.path().join("designs.wasm"), "\0asm").unwrap();
    fs::write(page.path().join("other.txt"), "other").unwrap();
    (outer, page)
}

#[test]
fn the_page_the_list_and_the_files_are_served_and_nothing_else() {
    let (outer, page) = folders();
    let serving = Serving::start(&outer.path().join("shop"), page.path());
    let shown = serving.get("");
    assert_eq!((shown.status, shown.text()), (200, "the page"));
    assert_eq!(
        shown.header("Content-Type"),
        Some("text/html; charset=utf-8")
    );
    assert_eq!(
        serving.get("designs.wasm").header("Content-Type"),
        Some("application/wasm")
    );
    let list: serde_json::Value = serde_json::from_slice(&serving.get("files").body).unwrap();
    assert_eq!(list["folder"], "shop");
    let names: Vec<&String> = list["files"].as_object().unwrap().keys().collect();
    assert_eq!(names, ["cone.toml", "parts/rim.svg"]);
    assert_eq!(serving.get("file?name=parts%2Frim.svg").text(), "<svg/>");
    for outside in [
        "file?name=..%2Fsecret.toml",
        "file?name=parts%2F..%2F..%2Fsecret.toml",
        "file?name=%2Fetc%2Fpasswd",
        "file?name=",
        "other.txt",
        "../secret.toml",
        "nothing",
    ] {
        let answer = serving.get(outside);
        assert_eq!(answer.status, 404, "{outside}");
        assert!(!answer.text().contains("secret\n"), "{outside}");
    }
}

#[test]
fn who_does_not_know_the_path_or_comes_from_elsewhere_gets_nothing() {
    let (outer, page) = folders();
    let serving = Serving::start(&outer.path().join("shop"), page.path());
    let another = Serving::start(&outer.path().join("shop"), page.path());
    assert_ne!(serving.path, another.path);
    assert!(serving.path.len() > 32, "{}", serving.path);
    assert_eq!(serving.ask("GET", "/", &[], b"").status, 404);
    assert_eq!(
        serving
            .ask("GET", &format!("{}files", another.path), &[], b"")
            .status,
        404
    );
    let files = format!("{}files", serving.path);
    // A name that somebody has pointed to this machine, and a page of somebody else.
    assert_eq!(
        serving
            .ask("GET", &files, &[("Host", "evil.example")], b"")
            .status,
        403
    );
    let elsewhere = [("Origin", "https://evil.example")];
    assert_eq!(serving.ask("GET", &files, &elsewhere, b"").status, 403);
    let here = format!("http://{}", serving.host);
    assert_eq!(
        serving.ask("GET", &files, &[("Origin", &here)], b"").status,
        200
    );
    // Refusals have the same headers as answers.
    for answer in [serving.get(""), serving.ask("GET", "/", &[], b"")] {
        let policy = answer.header("Content-Security-Policy").unwrap();
        assert!(policy.contains("frame-ancestors 'none'"), "{policy}");
        assert_eq!(answer.header("X-Content-Type-Options"), Some("nosniff"));
        assert_eq!(answer.header("Referrer-Policy"), Some("no-referrer"));
        assert_eq!(
            answer.header("Cross-Origin-Resource-Policy"),
            Some("same-origin")
        );
        assert_eq!(answer.header("Access-Control-Allow-Origin"), None);
    }
    assert!(serving.host.starts_with("127.0.0.1:"));
}

#[test]
fn a_design_is_saved_as_it_was_read_and_not_over_the_changes_of_somebody_else() {
    let (outer, page) = folders();
    let serving = Serving::start(&outer.path().join("shop"), page.path());
    let file = outer.path().join("shop/cone.toml");
    let read = serving.get("file?name=cone.toml");
    let tag = read.header("ETag").unwrap();
    let list = serving.get("files").body;
    let saved = serving.put("cone.toml", tag, b"[let]\na = 2\n");
    assert_eq!(saved.status, 200, "{}", saved.text());
    assert_eq!(fs::read_to_string(&file).unwrap(), "[let]\na = 2\n");
    assert_ne!(serving.get("files").body, list);
    // The old digest no longer counts; the new one does.
    assert_eq!(serving.put("cone.toml", tag, b"[let]\na = 3\n").status, 412);
    assert_eq!(fs::read_to_string(&file).unwrap(), "[let]\na = 2\n");
    let tag = saved.header("ETag").unwrap();
    assert_eq!(serving.put("cone.toml", tag, &[0xff, 0xfe]).status, 400);
    assert_eq!(
        serving
            .put("cone.toml", tag, &vec![b'#'; (1 << 20) + 1])
            .status,
        400
    );
    assert_eq!(serving.put("parts%2Frim.svg", tag, b"x").status, 404);
    assert_eq!(serving.put("..%2Fsecret.toml", tag, b"x").status, 404);
    assert_eq!(serving.put("new.toml", tag, b"x").status, 404);
    assert_eq!(
        serving
            .ask(
                "DELETE",
                &format!("{}file?name=cone.toml", serving.path),
                &[],
                b""
            )
            .status,
        405
    );
    assert_eq!(serving.put("cone.toml", tag, b"[let]\na = 4\n").status, 200);
    let left: Vec<_> = fs::read_dir(outer.path().join("shop")).unwrap().collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

#[test]
fn what_cannot_be_served_is_said() {
    let (outer, page) = folders();
    let page = page.path().to_str().unwrap();
    let ran = torse(&["studio", "nowhere", "--page", page]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("nowhere is not a folder"), "{}", ran.err);
    let ran = torse(&["studio", "--page", outer.path().to_str().unwrap()]);
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert!(ran.err.contains("web/build"), "{}", ran.err);
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let ran = torse(&["studio", "--page", page, "--port", &port]);
    assert_eq!(ran.code, Some(5), "{}", ran.err);
    assert!(ran.err.contains(&port), "{}", ran.err);
}
