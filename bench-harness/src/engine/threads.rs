//! The threads that write to a child and keep the last of what it complains of; both end with their pipes.

use std::collections::VecDeque;
use std::io::{Read, Write};
use std::process::{ChildStderr, ChildStdin};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

/// A thread that writes what it is sent, until the pipe or the sender is gone.
pub(super) fn writer(mut pipe: ChildStdin) -> Sender<Vec<u8>> {
    let (sender, requests) = channel::<Vec<u8>>();
    thread::spawn(move || {
        while let Ok(request) = requests.recv() {
            if pipe
                .write_all(&request)
                .and_then(|()| pipe.flush())
                .is_err()
            {
                return;
            }
        }
    });
    sender
}

/// A thread that reads to the end of `pipe` and then hands over the last of it.
pub(super) fn tail(mut pipe: ChildStderr) -> Receiver<Vec<u8>> {
    const KEPT: usize = 4096;
    let (sender, complaints) = channel();
    thread::spawn(move || {
        let mut kept = VecDeque::with_capacity(2 * KEPT);
        let mut chunk = [0; KEPT];
        while let Ok(count @ 1..) = pipe.read(&mut chunk) {
            kept.extend(&chunk[..count]);
            kept.drain(..kept.len().saturating_sub(KEPT));
        }
        let _ = sender.send(Vec::from(kept));
    });
    complaints
}
