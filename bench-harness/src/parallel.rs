//! Work that is not timed, spread over the machine's cores.

use anyhow::Result;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// `work` of every item, in the items' order. Stops at the first error.
pub(crate) fn map<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(&T) -> Result<R> + Sync,
) -> Result<Vec<R>> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, Result<R>)>> = Mutex::new(Vec::with_capacity(items.len()));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..cores.min(items.len()) {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(i) else { break };
                    let result = work(item);
                    if result.is_err() {
                        next.store(items.len(), Ordering::Relaxed);
                    }
                    done.lock()
                        .expect("no worker panics while it holds the lock")
                        .push((i, result));
                }
            });
        }
    });
    let mut done = done
        .into_inner()
        .expect("no worker panics while it holds the lock");
    done.sort_unstable_by_key(|(i, _)| *i);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_items() {
        let items: Vec<u64> = (0..1_000).collect();
        let squares = map(&items, |i| Ok(i * i)).expect("no error");
        assert!(
            squares
                .iter()
                .enumerate()
                .all(|(i, &square)| square == (i * i) as u64)
        );
    }

    #[test]
    fn an_error_is_passed_on() {
        let result = map(&[1, 2, 3], |i| {
            if *i == 2 {
                anyhow::bail!("two")
            } else {
                Ok(*i)
            }
        });
        assert!(result.is_err());
        assert!(
            map(&[] as &[u8], |_| Ok(()))
                .expect("nothing to do")
                .is_empty()
        );
    }
}
