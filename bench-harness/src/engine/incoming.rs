//! Bytes from a child process, waited for no longer than a deadline allows.

use std::io::Read;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread;
use std::time::Instant;

/// No reply is a longer line.
const LONGEST_LINE: usize = 16 << 20;
/// Bytes read at a time.
const CHUNK: usize = 1 << 16;
/// Chunks that may wait to be looked at; a child that writes more waits itself.
const WAITING: usize = 16;

/// The output of a child, read by a thread that ends with the pipe or with this value.
#[derive(Debug)]
pub(super) struct Incoming {
    chunks: Receiver<Vec<u8>>,
    buffer: Vec<u8>,
}

/// Why what was waited for did not come.
#[derive(Debug)]
pub(super) enum Stop {
    /// The deadline passed.
    Late,
    /// The pipe was closed when only this had come.
    Ended(Vec<u8>),
    /// A line that does not end; this is how it begins.
    Endless(Vec<u8>),
}

impl Incoming {
    /// Begins to read `pipe`.
    pub(super) fn from(pipe: impl Read + Send + 'static) -> Self {
        let (sender, chunks) = sync_channel(WAITING);
        thread::spawn(move || pump(pipe, &sender));
        Self {
            chunks,
            buffer: Vec::new(),
        }
    }

    /// The next line, without its end.
    pub(super) fn line(&mut self, deadline: Instant) -> Result<Vec<u8>, Stop> {
        let mut looked_at = 0;
        loop {
            if let Some(place) = self.buffer[looked_at..].iter().position(|&b| b == b'\n') {
                let mut line = self.take(looked_at + place + 1);
                line.pop();
                return Ok(line);
            }
            looked_at = self.buffer.len();
            if looked_at > LONGEST_LINE {
                return Err(Stop::Endless(self.take(looked_at)));
            }
            self.wait(deadline)?;
        }
    }

    /// The next `count` bytes.
    pub(super) fn exactly(&mut self, count: usize, deadline: Instant) -> Result<Vec<u8>, Stop> {
        while self.buffer.len() < count {
            self.wait(deadline)?;
        }
        Ok(self.take(count))
    }

    fn take(&mut self, count: usize) -> Vec<u8> {
        let rest = self.buffer.split_off(count);
        std::mem::replace(&mut self.buffer, rest)
    }

    fn wait(&mut self, deadline: Instant) -> Result<(), Stop> {
        let left = deadline.saturating_duration_since(Instant::now());
        match self.chunks.recv_timeout(left) {
            Ok(chunk) => {
                self.buffer.extend_from_slice(&chunk);
                Ok(())
            }
            Err(RecvTimeoutError::Timeout) => Err(Stop::Late),
            Err(RecvTimeoutError::Disconnected) => {
                Err(Stop::Ended(std::mem::take(&mut self.buffer)))
            }
        }
    }
}

fn pump(mut pipe: impl Read, sender: &SyncSender<Vec<u8>>) {
    let mut chunk = vec![0; CHUNK];
    while let Ok(count @ 1..) = pipe.read(&mut chunk) {
        if sender.send(chunk[..count].to_vec()).is_err() {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;
    use std::time::Duration;

    fn soon() -> Instant {
        Instant::now() + Duration::from_secs(5)
    }

    #[test]
    fn lines_and_blocks_follow_each_other() {
        let mut incoming = Incoming::from(Cursor::new(b"one\n\x01\x02\ntwo\n".to_vec()));
        assert_eq!(incoming.line(soon()).unwrap(), b"one");
        assert_eq!(incoming.exactly(3, soon()).unwrap(), [1, 2, b'\n']);
        assert_eq!(incoming.line(soon()).unwrap(), b"two");
        assert!(matches!(incoming.line(soon()), Err(Stop::Ended(rest)) if rest.is_empty()));
    }

    #[test]
    fn what_came_before_the_end_is_kept() {
        let mut incoming = Incoming::from(Cursor::new(b"half".to_vec()));
        assert!(matches!(incoming.line(soon()), Err(Stop::Ended(rest)) if rest == b"half"));
    }

    #[test]
    fn a_line_without_end_is_given_up() {
        let endless = std::io::repeat(b'x');
        let mut incoming = Incoming::from(endless);
        assert!(matches!(incoming.line(soon()), Err(Stop::Endless(_))));
    }
}
