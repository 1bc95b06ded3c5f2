//! What is answered to a request: a file of the page, the list, a file of the folder, or a refusal.

use super::folder::{SharedFolder, Unsaved, fingerprint};
use super::page::PageFolder;

/// A request, as far as it counts.
pub struct Asked<'r> {
    pub method: &'r str,
    /// The path with what follows `?`.
    pub url: &'r str,
    pub host: Option<&'r str>,
    pub origin: Option<&'r str>,
    /// The digest of `If-Match`.
    pub matches: Option<&'r str>,
    /// None where it is too long.
    pub body: Option<&'r [u8]>,
}

/// An answer.
#[derive(Debug)]
pub struct Answered {
    pub status: u16,
    pub headers: Vec<(&'static str, String)>,
    pub body: Vec<u8>,
}

/// What is served, and at which address.
pub struct Studio {
    /// `/SECRET/`, below which everything lies.
    path: String,
    hosts: [String; 2],
    folder: SharedFolder,
    page: PageFolder,
}

/// Headers of every answer: the page may not be framed, guessed at, or kept, and says nowhere where it comes from. What it
/// may load and run stands in the page.
const HEADERS: [(&str, &str); 6] = [
    (
        "Content-Security-Policy",
        "frame-ancestors 'none'; base-uri 'none'; form-action 'none'; object-src 'none'",
    ),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Cache-Control", "no-store"),
];

impl Studio {
    pub fn new(port: u16, secret: &str, folder: SharedFolder, page: PageFolder) -> Self {
        Self {
            path: format!("/{secret}/"),
            hosts: ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}")),
            folder,
            page,
        }
    }

    /// Answers.
    pub fn answer(&self, asked: &Asked<'_>) -> Answered {
        // A name that somebody else has pointed to this machine is not ours, and a page from elsewhere gets nothing.
        let is_ours = |host: &str| self.hosts.iter().any(|own| own == host);
        let from_here = |origin: &str| origin.strip_prefix("http://").is_some_and(is_ours);
        if !asked.host.is_some_and(is_ours) || !asked.origin.is_none_or(from_here) {
            return refusal(403, "not from this page");
        }
        let Some(wanted) = asked.url.strip_prefix(&self.path) else {
            return refusal(404, "torse prints the address at which it serves");
        };
        let (wanted, query) = wanted.split_once('?').unwrap_or((wanted, ""));
        match (asked.method, wanted, query.strip_prefix("name=")) {
            ("GET", "files", None) => match serde_json::to_vec(&self.folder.list()) {
                Ok(list) => answered(200, "application/json", list),
                Err(error) => refusal(500, &error.to_string()),
            },
            ("GET", "file", Some(name)) => self.file(&decoded(name)),
            ("PUT", "file", Some(name)) => self.saved(&decoded(name), asked),
            ("GET", name, None) => match self.page.read(name) {
                Some((bytes, kind)) => answered(200, kind, bytes),
                None => refusal(404, "there is no such file"),
            },
            _ => refusal(405, "this is not served"),
        }
    }

    fn file(&self, name: &str) -> Answered {
        match self.folder.read(name) {
            None => refusal(404, "the folder has no such file"),
            Some(bytes) => {
                let tag = fingerprint(&bytes);
                // Whatever it is, a browser does not run it.
                let mut answer = answered(200, "application/octet-stream", bytes);
                answer.headers.push(("ETag", format!("\"{tag}\"")));
                answer
            }
        }
    }

    fn saved(&self, name: &str, asked: &Asked<'_>) -> Answered {
        let tag = asked.matches.map(|tag| tag.trim_matches('"'));
        let (Some(before), Some(text)) = (tag, asked.body) else {
            return refusal(
                400,
                "a text of at most 1 MiB and the digest of the file are wanted",
            );
        };
        match self.folder.save(name, before, text) {
            Ok(after) => {
                let mut answer = answered(200, "text/plain; charset=utf-8", vec![]);
                answer.headers.push(("ETag", format!("\"{after}\"")));
                answer
            }
            Err(Unsaved::Absent) => refusal(404, "the folder has no such design"),
            Err(Unsaved::Changed) => refusal(412, "the file has changed since it was read"),
            Err(Unsaved::NoText) => refusal(400, "this is no text"),
            Err(Unsaved::Refused(reason)) => refusal(500, &reason),
        }
    }
}

fn answered(status: u16, kind: &str, body: Vec<u8>) -> Answered {
    let always = HEADERS
        .iter()
        .map(|(name, value)| (*name, (*value).to_owned()));
    Answered {
        status,
        headers: always.chain([("Content-Type", kind.to_owned())]).collect(),
        body,
    }
}

fn refusal(status: u16, reason: &str) -> Answered {
    answered(
        status,
        "text/plain; charset=utf-8",
        format!("{reason}\n").into_bytes(),
    )
}

/// The text of a query's value, `%2F` for `/`; what is no UTF-8 names no file.
fn decoded(value: &str) -> String {
    let mut bytes = Vec::with_capacity(value.len());
    let mut rest = value.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let code = match (first, after) {
            (b'%', [high, low, ..]) => {
                let digit = |byte: &u8| char::from(*byte).to_digit(16);
                let code = digit(high)
                    .zip(digit(low))
                    .map(|(high, low)| 16 * high + low);
                code.and_then(|code| u8::try_from(code).ok())
            }
            _ => None,
        };
        bytes.push(code.unwrap_or(*first));
        rest = if code.is_some() {
            after.get(2..).unwrap_or_default()
        } else {
            after
        };
    }
    String::from_utf8(bytes).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::decoded;

    #[test]
    fn queries_are_decoded_once() {
        for (query, text) in [
            ("a%20b.toml", "a b.toml"),
            ("p%2Fpaper.toml", "p/paper.toml"),
            ("%252e%252e", "%2e%2e"),
            ("%E2%82%AC", "€"),
            ("100%", "100%"),
            ("%+1", "%+1"),
            ("%ff", ""),
        ] {
            assert_eq!(decoded(query), text, "{query}");
        }
    }
}
