//! `torse studio`: serves the page of a browser on this machine, with the designs and papers of a folder.
//!
//! The page asks for the list of the files a few times a second and takes what has changed ([`folder`]); it asks for a file
//! to be written where the user saves. The server holds no state: what it answers is read anew. It listens on the loopback
//! address alone, and all that it answers lies below a path of random digits: another page, or another user of the machine,
//! does not know the path, and gets nothing ([`answer`]).

mod answer;
mod folder;
mod page;

use crate::exit::{Exit, Failure};
use crate::{terminal, watchdog};
use answer::{Asked, Studio as Served};
use clap::Args;
use folder::SharedFolder;
use page::PageFolder;
use std::io::Read;
use std::net::Ipv4Addr;
use std::path::PathBuf;
use tiny_http::{Header, Request, Response, Server};

/// Serve the page on this machine, with the designs and papers of a folder.
///
/// The page shows a file again when it is saved in an editor, and writes a file when it is saved in the page. torse listens
/// on 127.0.0.1 alone, answers below the printed address alone, and gives no file from outside of the folder.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Studio {
    /// The folder: its designs, the files that they name, and its papers
    #[arg(default_value = ".")]
    folder: PathBuf,
    /// Listen on this port; 0 takes one that is free
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    port: u16,
    /// Take the page from this folder, which `web/build` makes: target/web/site
    #[arg(long, value_name = "FOLDER")]
    page: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  torse studio                    the designs and papers of this folder
  torse studio designs --port 8080";

/// Requests that are answered at a time.
const THREADS: usize = 4;

/// The most bytes of a request's body: those of a design file.
const MAX_BODY: usize = 1 << 20;

/// Random bytes of the path.
const SECRET: usize = 16;

impl Studio {
    /// Serves until a signal ends the command.
    pub fn run(&self) -> Result<Exit, Failure> {
        let folder = SharedFolder::open(&self.folder)?;
        let page = PageFolder::find(self.page.as_deref())?;
        let failed = |reason: String| Failure::Listen {
            port: self.port,
            reason,
        };
        let server = Server::http((Ipv4Addr::LOCALHOST, self.port))
            .map_err(|error| failed(error.to_string()))?;
        let address = server.server_addr().to_ip();
        let port = address.map_or(self.port, |address| address.port());
        let mut secret = [0; SECRET];
        getrandom::fill(&mut secret).map_err(|error| failed(error.to_string()))?;
        let secret: String = secret.iter().map(|byte| format!("{byte:02x}")).collect();
        watchdog::finished();
        terminal::print(&format!("http://127.0.0.1:{port}/{secret}/\n"))?;
        let name = self.folder.display();
        terminal::remark(&format!("serving {name} on this machine; Ctrl-C ends\n"));
        let served = Served::new(port, &secret, folder, page);
        std::thread::scope(|threads| {
            for _ in 0..THREADS {
                threads.spawn(|| {
                    while let Ok(request) = server.recv() {
                        respond(&served, request);
                    }
                });
            }
        });
        Ok(Exit::AsExpected)
    }
}

/// Answers a request; a client that has gone is not a failure.
fn respond(served: &Served, mut request: Request) {
    let header = |name: &'static str| {
        let found = request.headers().iter().find(|h| h.field.equiv(name));
        found.map(|header| header.value.as_str().to_owned())
    };
    let (host, origin, matches) = (header("Host"), header("Origin"), header("If-Match"));
    let (method, url) = (request.method().to_string(), request.url().to_owned());
    let mut body = Vec::new();
    // One byte more tells that there is more.
    let most = u64::try_from(MAX_BODY + 1).unwrap_or(u64::MAX);
    if request
        .as_reader()
        .take(most)
        .read_to_end(&mut body)
        .is_err()
    {
        return;
    }
    let answer = served.answer(&Asked {
        method: &method,
        url: &url,
        host: host.as_deref(),
        origin: origin.as_deref(),
        matches: matches.as_deref(),
        body: (body.len() <= MAX_BODY).then_some(body.as_slice()),
    });
    let mut response = Response::from_data(answer.body).with_status_code(answer.status);
    for (name, value) in &answer.headers {
        if let Ok(header) = Header::from_bytes(name.as_bytes(), value.as_bytes()) {
            response.add_header(header);
        }
    }
    let _ = request.respond(response);
}
