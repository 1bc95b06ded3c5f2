//! The border between a page and a module of torse: one packet in, one packet out.
//!
//! A packet is eight bytes (the length of its head as a little-endian 32-bit number, then zeros), the head, which is JSON
//! padded with spaces to a multiple of eight bytes, and the body, which is bytes: files, or numbers that a page takes as
//! typed arrays where they lie.
//!
//! The page calls `torse_reserve` for the address of a packet of this length and writes it there, calls `torse_answer` of
//! the module, and reads the answer of `torse_answer_length` bytes at the address that it returns. Nothing else crosses
//! the border; a panic traps and ends the module, and the page starts another.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cell::RefCell;

/// The bytes before the head, and what its length is a multiple of: numbers of the body are aligned.
const ALIGNMENT: usize = 8;

thread_local! {
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for the packet of a question of so many bytes and returns its address. It stays valid until the next call
/// of `torse_reserve` or `torse_answer`.
#[unsafe(no_mangle)]
pub extern "C" fn torse_reserve(length: usize) -> *mut u8 {
    QUESTION.with_borrow_mut(|question| {
        *question = vec![0; length];
        question.as_mut_ptr()
    })
}

/// The length of the last answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn torse_answer_length() -> usize {
    ANSWER.with_borrow(Vec::len)
}

/// What is said in a packet that is an answer.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Answer {
    /// JSON.
    pub head: String,
    /// Bytes.
    pub body: Vec<u8>,
}

#[derive(Serialize)]
struct Refusal {
    error: Refused,
}

/// Why something cannot be done.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refused {
    /// In one text.
    pub text: String,
    /// What is wrong, one by one.
    pub messages: Vec<Message>,
}

/// Something that is wrong; line and column are counted from one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Message {
    /// The file, or what stands for one.
    pub file: Option<String>,
    /// The line.
    pub line: Option<usize>,
    /// The column in characters.
    pub column: Option<usize>,
    /// How many characters.
    pub length: usize,
    /// What is wrong.
    pub text: String,
    /// What would help.
    pub hint: Option<String>,
}

impl Refused {
    /// What the library says.
    #[must_use]
    pub fn new(error: &torse::Error) -> Self {
        let message = |message: torse::ErrorMessage| Message {
            line: message.place.as_ref().map(|at| at.line),
            column: message.place.as_ref().map(|at| at.column),
            file: message.place.map(|at| at.file),
            length: message.length,
            text: message.text,
            hint: message.hint,
        };
        Self {
            text: error.to_string(),
            messages: error.messages().into_iter().map(message).collect(),
        }
    }
}

impl Answer {
    /// An answer without a body.
    pub fn value(value: &impl Serialize) -> Self {
        Self::with_body(value, Vec::new())
    }

    /// An answer with a body.
    pub fn with_body(value: &impl Serialize, body: Vec<u8>) -> Self {
        match serde_json::to_string(value) {
            Ok(head) => Self { head, body },
            Err(error) => Self::refusal(&error.to_string()),
        }
    }

    /// An answer that says why there is none.
    #[must_use]
    pub fn refusal(reason: &str) -> Self {
        let head = serde_json::json!({ "error": { "text": reason, "messages": [] } });
        Self {
            head: head.to_string(),
            body: Vec::new(),
        }
    }

    /// The same with what the library says, each with its place.
    #[must_use]
    pub fn error(error: &torse::Error) -> Self {
        Self::value(&Refusal {
            error: Refused::new(error),
        })
    }

    fn packed(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(2 * ALIGNMENT + self.head.len() + self.body.len());
        let padded = self.head.len().next_multiple_of(ALIGNMENT);
        let length = u32::try_from(padded).unwrap_or(u32::MAX);
        bytes.extend_from_slice(&length.to_le_bytes());
        bytes.resize(ALIGNMENT, 0);
        bytes.extend_from_slice(self.head.as_bytes());
        bytes.resize(ALIGNMENT + padded, b' ');
        bytes.extend_from_slice(&self.body);
        bytes
    }
}

/// Takes the question apart: its head, as JSON, and its body.
fn unpacked<Q: DeserializeOwned>(packet: &[u8]) -> Result<(Q, &[u8]), String> {
    let short = || "the packet is shorter than it says".to_owned();
    let (length, rest) = packet.split_first_chunk::<4>().ok_or_else(short)?;
    let length = usize::try_from(u32::from_le_bytes(*length)).map_err(|_| short())?;
    let rest = rest.get(ALIGNMENT - 4..).ok_or_else(short)?;
    let (head, body) = rest.split_at_checked(length).ok_or_else(short)?;
    let question = serde_json::from_slice(head).map_err(|error| error.to_string())?;
    Ok((question, body))
}

/// Answers the question that was reserved and returns the address of the answer: what `torse_answer` of a module does.
pub fn answer<Q: DeserializeOwned>(answering: impl FnOnce(Q, &[u8]) -> Answer) -> *const u8 {
    // The question is let go before the next one comes, its memory with it.
    let packet = QUESTION.take();
    let answer = match unpacked(&packet) {
        Ok((question, body)) => answering(question, body),
        Err(reason) => Answer::refusal(&reason),
    };
    ANSWER.with_borrow_mut(|last| {
        *last = answer.packed();
        last.as_ptr()
    })
}

/// The files of a question, one after the other in its body: a name and a number of bytes each.
///
/// # Errors
/// Where they are longer than the body.
pub fn files<'b>(
    listed: &'b [(String, usize)],
    mut body: &'b [u8],
) -> Result<Vec<(&'b str, &'b [u8])>, String> {
    let mut files = Vec::with_capacity(listed.len());
    for (name, length) in listed {
        let (bytes, rest) = body
            .split_at_checked(*length)
            .ok_or_else(|| format!("`{name}` is longer than the packet"))?;
        files.push((name.as_str(), bytes));
        body = rest;
    }
    Ok(files)
}
