//! Messages as the protocol frames them: headers, an empty line, and so many bytes of JSON.

use lsp_server::Message;
use std::io::{BufRead, Error, ErrorKind, Read};

/// The most bytes of the headers of a message.
const MAX_HEADERS: u64 = 8 * 1024;

/// The most bytes of a message: a text of the largest size that is read, with escapes.
const MAX_MESSAGE: u64 = 32 * 1024 * 1024;

/// What came in one frame.
#[derive(Debug)]
pub enum Frame {
    /// A message.
    Message(Message),
    /// JSON that is no message, or no JSON: the next frame is none the worse.
    Malformed(String),
}

/// Reads a frame; none at the end of the input.
///
/// # Errors
/// Input that cannot be read, and headers after which nobody knows where the next message begins.
pub fn read(input: &mut impl BufRead) -> Result<Option<Frame>, Error> {
    let Some(length) = headers(input)? else {
        return Ok(None);
    };
    let mut body = vec![];
    // Memory is used for what has come, not for what was announced.
    input.take(length).read_to_end(&mut body)?;
    if (body.len() as u64) < length {
        return Err(wrong("the input ends within a message".to_owned()));
    }
    Ok(Some(match serde_json::from_slice(&body) {
        Ok(message) => Frame::Message(message),
        Err(error) => Frame::Malformed(error.to_string()),
    }))
}

/// Reads headers, and returns the length of the message; none at the end of the input.
fn headers(input: &mut impl BufRead) -> Result<Option<u64>, Error> {
    let mut rest = input.take(MAX_HEADERS);
    let mut length = None;
    let mut is_first = true;
    loop {
        let mut line = vec![];
        rest.read_until(b'\n', &mut line)?;
        if line.is_empty() && is_first {
            return Ok(None);
        }
        is_first = false;
        let line = String::from_utf8_lossy(&line);
        let Some(line) = line.strip_suffix('\n') else {
            return Err(wrong("the headers of a message do not end".to_owned()));
        };
        let line = line.trim_end_matches('\r');
        match (line.split_once(':'), length) {
            (None, Some(length)) if line.is_empty() => return Ok(Some(length)),
            (Some((name, value)), _) => {
                if name.trim().eq_ignore_ascii_case("content-length") {
                    let value = value.trim().parse().ok();
                    let value = value.filter(|length| *length <= MAX_MESSAGE);
                    length = Some(value.ok_or_else(|| wrong(format!("`{line}` is refused")))?);
                }
            }
            (None, _) => return Err(wrong(format!("`{line}` is no header of a message"))),
        }
    }
}

fn wrong(reason: String) -> Error {
    Error::new(ErrorKind::InvalidData, reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(mut input: &[u8]) -> Vec<Result<Frame, String>> {
        let mut found = vec![];
        loop {
            match read(&mut input) {
                Ok(Some(frame)) => found.push(Ok(frame)),
                Ok(None) => return found,
                Err(error) => {
                    found.push(Err(error.to_string()));
                    return found;
                }
            }
        }
    }

    #[test]
    fn json_that_is_no_message_does_not_hide_the_next_message() {
        let input = b"Content-Length: 3\r\n\r\n{}]content-length:2\r\nContent-Type: x\r\n\r\n[]\
            Content-Length: 33\r\n\r\n{\"jsonrpc\":\"2.0\",\"method\":\"exit\"}";
        let found = all(input);
        assert!(
            matches!(
                found.as_slice(),
                [
                    Ok(Frame::Malformed(_)),
                    Ok(Frame::Malformed(_)),
                    Ok(Frame::Message(Message::Notification(_)))
                ]
            ),
            "{found:?}"
        );
    }

    #[test]
    fn headers_that_do_not_say_where_a_message_ends_are_refused() {
        let long = [b"X: ".as_slice(), &[b'x'; 10_000]].concat();
        for input in [
            b"Content-Length: 999999999999999999999\r\n\r\n".as_slice(),
            b"Content-Length: 99999999999\r\n\r\n",
            b"Content-Length: -1\r\n\r\n",
            b"Content-Type: x\r\n\r\n{}",
            b"hello\r\n",
            b"Content-Length: 9\r\n\r\n{}",
            b"Content-Length: 9",
            &long,
        ] {
            let found = all(input);
            assert!(matches!(found.as_slice(), [Err(_)]), "{found:?}");
        }
        assert!(all(b"").is_empty());
    }
}
