//! The server: what is open, what was found, and answers.

use super::documents::{Documents, Membership, file_path};
use super::frames::Frame;
use super::lines::Lines;
use super::messages::{Event, FolderJob, FolderRead, Job};
use super::protocol;
use crate::exit::{Exit, Failure};
use crate::version::VERSION;
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, LogMessage,
    Notification as _, PublishDiagnostics,
};
use lsp_types::request::{CodeActionRequest, Completion, HoverRequest, Request as _};
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CompletionParams,
    Diagnostic, DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    HoverParams, InitializeResult, LogMessageParams, MessageType, Position,
    PublishDiagnosticsParams, ServerInfo, TextEdit, Uri, WorkspaceEdit,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use torse::editing::{EditedFolder, EditorNote, KnownFindings};

/// How far the protocol has come.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Nothing but `initialize` is answered.
    Begins,
    Serves,
    /// Nothing but `exit` is done.
    ShutDown,
    Ended(Exit),
}

/// A folder of derivations of which texts are open.
#[derive(Default)]
struct Folder {
    papers: BTreeSet<String>,
    known: Arc<KnownFindings>,
    /// As it was read last.
    read: Option<Arc<EditedFolder>>,
}

/// The server; `write` takes what is sent to the editor.
pub struct Server<W> {
    write: W,
    jobs: Sender<Job>,
    phase: Phase,
    documents: Documents,
    folders: BTreeMap<PathBuf, Folder>,
    /// Ends the job that is being done.
    stop: Arc<AtomicBool>,
    /// Whether texts differ from what the worker has.
    is_changed: bool,
    /// Folders of which there is news to show.
    news: BTreeSet<PathBuf>,
    /// What the editor shows, by address.
    shown: BTreeMap<String, (Uri, Vec<Diagnostic>)>,
}

impl<W: FnMut(&[u8]) -> io::Result<()>> Server<W> {
    /// Makes a server that has no text open.
    pub fn new(jobs: Sender<Job>, write: W) -> Self {
        Self {
            write,
            jobs,
            phase: Phase::Begins,
            documents: Documents::default(),
            folders: BTreeMap::new(),
            stop: Arc::default(),
            is_changed: false,
            news: BTreeSet::new(),
            shown: BTreeMap::new(),
        }
    }

    /// Returns the exit code once the editor has left.
    pub fn ended(&self) -> Option<Exit> {
        match self.phase {
            Phase::Ended(exit) => Some(exit),
            _ => None,
        }
    }

    /// Takes an event: answers requests, and notes what is to be shown.
    ///
    /// # Errors
    /// [`Failure::Messages`] where the input makes no sense from there on, [`Failure::Print`] where nobody reads answers.
    pub fn take(&mut self, event: Event) -> Result<(), Failure> {
        if self.ended().is_some() {
            return Ok(());
        }
        match event {
            Event::Frame(Ok(Some(Frame::Message(Message::Request(request))))) => {
                self.request(request)
            }
            Event::Frame(Ok(Some(Frame::Message(Message::Notification(told))))) => {
                self.notification(told)
            }
            // Nothing is asked of the editor.
            Event::Frame(Ok(Some(Frame::Message(Message::Response(_))))) => Ok(()),
            Event::Frame(Ok(Some(Frame::Malformed(reason)))) => self.malformed(&reason),
            Event::Frame(Ok(None)) => {
                self.leave();
                Ok(())
            }
            Event::Frame(Err(error)) => Err(Failure::Messages(error)),
            Event::Read(FolderRead { derivations, read }) => {
                if let Some(folder) = self.folders.get_mut(&derivations) {
                    match read {
                        Ok(edited) => folder.read = Some(edited),
                        Err(error) => self.log(MessageType::WARNING, error.in_full())?,
                    }
                    self.news.insert(derivations);
                }
                Ok(())
            }
            Event::Decided(derivations) => {
                self.news.insert(derivations);
                Ok(())
            }
        }
    }

    /// Gives the worker what has changed, and the editor what is new.
    ///
    /// # Errors
    /// [`Failure::Print`].
    pub fn show(&mut self) -> Result<(), Failure> {
        if self.ended().is_some() {
            return Ok(());
        }
        if std::mem::take(&mut self.is_changed) {
            self.give_job();
        }
        let news = std::mem::take(&mut self.news);
        for derivations in news {
            self.publish(&derivations)?;
        }
        Ok(())
    }

    /// Ends; the code is 0 only where the editor has asked for the end.
    fn leave(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        self.phase = Phase::Ended(match self.phase {
            Phase::ShutDown => Exit::AsExpected,
            _ => Exit::Differs,
        });
    }

    fn request(&mut self, request: Request) -> Result<(), Failure> {
        let Request { id, method, params } = request;
        match (self.phase, method.as_str()) {
            (Phase::Begins, "initialize") => {
                self.phase = Phase::Serves;
                let result = InitializeResult {
                    capabilities: protocol::capabilities(),
                    server_info: Some(ServerInfo {
                        name: "torse".to_owned(),
                        version: Some(VERSION.to_owned()),
                    }),
                };
                self.answer(id, Ok(result))
            }
            (Phase::Begins, _) => {
                let reason = "`initialize` comes first".to_owned();
                self.refuse(id, ErrorCode::ServerNotInitialized, reason)
            }
            (Phase::Serves, "shutdown") => {
                self.phase = Phase::ShutDown;
                self.stop.store(true, Ordering::Relaxed);
                self.answer(id, Ok(Value::Null))
            }
            (Phase::Serves, HoverRequest::METHOD) => {
                let answer = read(params).map(|params| self.hover(&params));
                self.answer(id, answer)
            }
            (Phase::Serves, Completion::METHOD) => {
                let answer = read(params).map(|params| self.completion(&params));
                self.answer(id, answer)
            }
            (Phase::Serves, CodeActionRequest::METHOD) => {
                let answer = read(params).map(|params| self.code_actions(&params));
                self.answer(id, answer)
            }
            (Phase::Serves, "initialize") | (Phase::ShutDown | Phase::Ended(_), _) => {
                let reason = format!("`{method}` is not possible now");
                self.refuse(id, ErrorCode::InvalidRequest, reason)
            }
            (Phase::Serves, _) => {
                let reason = format!("there is no `{method}` here");
                self.refuse(id, ErrorCode::MethodNotFound, reason)
            }
        }
    }

    fn notification(&mut self, told: Notification) -> Result<(), Failure> {
        let Notification { method, params } = told;
        if method == "exit" {
            self.leave();
            return Ok(());
        }
        if self.phase != Phase::Serves {
            return Ok(());
        }
        let done = match method.as_str() {
            DidOpenTextDocument::METHOD => read(params).map(|params: DidOpenTextDocumentParams| {
                let opened = params.text_document;
                self.documents.open(opened.uri, opened.text);
            }),
            DidChangeTextDocument::METHOD => {
                read(params).and_then(|params: DidChangeTextDocumentParams| {
                    let uri = params.text_document.uri;
                    let changed = self.documents.change(&uri, params.content_changes);
                    changed.map_err(|error| error.to_string())
                })
            }
            DidCloseTextDocument::METHOD => {
                read(params).map(|params: DidCloseTextDocumentParams| {
                    self.documents.close(&params.text_document.uri);
                })
            }
            // What is on the disk may have changed.
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => Ok(()),
            _ => return Ok(()),
        };
        match done {
            Ok(()) => {
                self.is_changed = true;
                // What is being decided may be void; what is not is known when it is asked for again.
                self.stop.store(true, Ordering::Relaxed);
                Ok(())
            }
            Err(reason) => self.log(MessageType::ERROR, format!("{method}: {reason}")),
        }
    }

    /// Has the worker read and decide what is open.
    fn give_job(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        self.stop = Arc::default();
        let mut open: BTreeMap<PathBuf, (BTreeSet<String>, BTreeMap<String, String>)> =
            BTreeMap::new();
        for document in self.documents.all() {
            if let Some(of) = self.documents.membership(document) {
                let (papers, texts) = open.entry(of.derivations).or_default();
                papers.insert(of.paper);
                texts.insert(of.name, document.text.clone());
            }
        }
        // Of what is closed nothing is shown.
        for (derivations, folder) in &mut self.folders {
            let left = open.get(derivations).map(|(papers, _)| papers.clone());
            folder.papers = left.unwrap_or_default();
            self.news.insert(derivations.clone());
        }
        let mut folders = vec![];
        for (derivations, (papers, unsaved)) in open {
            let folder = self.folders.entry(derivations.clone()).or_default();
            folder.papers.clone_from(&papers);
            let known = Arc::clone(&folder.known);
            folders.push(FolderJob {
                derivations,
                papers,
                unsaved,
                known,
            });
        }
        let stop = Arc::clone(&self.stop);
        // The worker lives as long as the server.
        let _ = self.jobs.send(Job { folders, stop });
    }

    /// Shows what is known of a folder, where that is not shown already.
    fn publish(&mut self, derivations: &Path) -> Result<(), Failure> {
        let notes = self.notes(derivations);
        let mut files: BTreeMap<&str, Vec<&EditorNote>> = BTreeMap::new();
        for note in &notes {
            files.entry(&note.source.name).or_default().push(note);
        }
        let mut now: BTreeMap<String, (Uri, Vec<Diagnostic>)> = BTreeMap::new();
        for (name, notes) in files {
            let Some(uri) = self.documents.address(&derivations.join(name)) else {
                continue;
            };
            let Some(source) = notes.first().map(|note| &note.source) else {
                continue;
            };
            let lines = Lines::new(&source.text);
            let found = notes.iter().map(|note| protocol::diagnostic(note, &lines));
            now.insert(uri.as_str().to_owned(), (uri, found.collect()));
        }
        // What is shown of this folder and is no longer known.
        let old: Vec<(String, Uri)> = self
            .shown
            .iter()
            .filter(|(key, (uri, _))| {
                let path = file_path(uri);
                !now.contains_key(*key) && path.is_some_and(|path| path.starts_with(derivations))
            })
            .map(|(key, (uri, _))| (key.clone(), uri.clone()))
            .collect();
        for (key, uri) in old {
            self.shown.remove(&key);
            self.tell_diagnostics(uri, vec![])?;
        }
        for (key, (uri, diagnostics)) in now {
            let same = self
                .shown
                .get(&key)
                .is_some_and(|(_, shown)| *shown == diagnostics);
            if !same {
                self.shown.insert(key, (uri.clone(), diagnostics.clone()));
                self.tell_diagnostics(uri, diagnostics)?;
            }
        }
        Ok(())
    }

    fn notes(&self, derivations: &Path) -> Vec<EditorNote> {
        let folder = self.folders.get(derivations);
        folder.map_or_else(Vec::new, |folder| match &folder.read {
            Some(read) => read.notes(&folder.papers, &folder.known),
            None => vec![],
        })
    }

    fn tell_diagnostics(&mut self, uri: Uri, diagnostics: Vec<Diagnostic>) -> Result<(), Failure> {
        let params = PublishDiagnosticsParams {
            uri,
            diagnostics,
            version: None,
        };
        self.tell(PublishDiagnostics::METHOD, params)
    }

    /// The open text at an address, and the folder that it belongs to.
    fn open(&self, uri: &Uri) -> Option<(&str, Membership, &Folder)> {
        let document = self.documents.get(uri)?;
        let of = self.documents.membership(document)?;
        let folder = self.folders.get(&of.derivations)?;
        Some((&document.text, of, folder))
    }

    fn hover(&self, params: &HoverParams) -> Option<lsp_types::Hover> {
        let place = &params.text_document_position_params;
        let (text, of, folder) = self.open(&place.text_document.uri)?;
        let lines = Lines::new(text);
        let byte = lines.byte(place.position);
        let read = folder.read.as_ref()?;
        let said = read.hover(&of.name, text, byte, &folder.known)?;
        Some(protocol::hover(said, &lines))
    }

    fn completion(&self, params: &CompletionParams) -> Vec<lsp_types::CompletionItem> {
        let place = &params.text_document_position;
        let offers = self
            .open(&place.text_document.uri)
            .and_then(|(text, of, folder)| {
                let byte = Lines::new(text).byte(place.position);
                Some(folder.read.as_ref()?.completions(&of.name, text, byte))
            });
        let offers = offers.into_iter().flatten();
        offers.map(protocol::completion).collect()
    }

    /// Offers the corrected statements of a range.
    fn code_actions(&self, params: &CodeActionParams) -> Vec<CodeActionOrCommand> {
        let uri = &params.text_document.uri;
        let Some((text, of, _)) = self.open(uri) else {
            return vec![];
        };
        let lines = Lines::new(text);
        let is_near =
            |start: Position, end: Position| start <= params.range.end && params.range.start <= end;
        let notes = self.notes(&of.derivations);
        let notes = notes.iter().filter(|note| {
            let range = lines.range(&note.range);
            // Of a text that has changed since, nothing is known.
            note.source.name == of.name
                && note.source.text == text
                && is_near(range.start, range.end)
        });
        let actions = notes.filter_map(|note| {
            let rewrite = note.correction.as_ref()?;
            let edit = TextEdit {
                range: lines.range(&rewrite.range),
                new_text: rewrite.text.clone(),
            };
            #[allow(clippy::mutable_key_type, reason = "the protocol's own type")]
            let changes = HashMap::from([(uri.clone(), vec![edit])]);
            Some(CodeActionOrCommand::CodeAction(CodeAction {
                title: format!("Write the corrected statement {}", rewrite.text),
                kind: Some(CodeActionKind::QUICKFIX),
                diagnostics: Some(vec![protocol::diagnostic(note, &lines)]),
                edit: Some(WorkspaceEdit {
                    changes: Some(changes),
                    ..WorkspaceEdit::default()
                }),
                ..CodeAction::default()
            }))
        });
        actions.collect()
    }

    fn answer(
        &mut self,
        id: RequestId,
        answer: Result<impl Serialize, String>,
    ) -> Result<(), Failure> {
        let answer = answer
            .and_then(|answer| serde_json::to_value(answer).map_err(|error| error.to_string()));
        match answer {
            Ok(result) => {
                let response = Response {
                    id,
                    response_result: Ok(result),
                };
                self.send(&Message::Response(response))
            }
            Err(reason) => self.refuse(id, ErrorCode::InvalidParams, reason),
        }
    }

    fn refuse(&mut self, id: RequestId, code: ErrorCode, reason: String) -> Result<(), Failure> {
        self.send(&Message::Response(Response::new_err(
            id,
            code as i32,
            reason,
        )))
    }

    /// Says that a frame held no message; there is no id to answer to.
    fn malformed(&mut self, reason: &str) -> Result<(), Failure> {
        let code = ErrorCode::ParseError as i32;
        let error = json!({ "code": code, "message": reason });
        let text = json!({ "jsonrpc": "2.0", "id": null, "error": error }).to_string();
        let frame = format!("Content-Length: {}\r\n\r\n{text}", text.len());
        (self.write)(frame.as_bytes()).map_err(Failure::Print)
    }

    fn log(&mut self, typ: MessageType, message: String) -> Result<(), Failure> {
        self.tell(LogMessage::METHOD, LogMessageParams { typ, message })
    }

    fn tell(&mut self, method: &str, params: impl Serialize) -> Result<(), Failure> {
        let params = serde_json::to_value(params).unwrap_or_default();
        let method = method.to_owned();
        self.send(&Message::Notification(Notification { method, params }))
    }

    fn send(&mut self, message: &Message) -> Result<(), Failure> {
        let mut frame = vec![];
        message.write(&mut frame).map_err(Failure::Print)?;
        (self.write)(&frame).map_err(Failure::Print)
    }
}

/// Reads the parameters of a message.
fn read<T: DeserializeOwned>(params: Value) -> Result<T, String> {
    serde_json::from_value(params).map_err(|error| error.to_string())
}
