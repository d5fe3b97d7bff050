//! The threads of a run.

use std::sync::Arc;

use rayon::prelude::*;

/// The threads that a net is advanced on.
#[derive(Debug, Clone, Default)]
pub struct Team(Option<Arc<rayon::ThreadPool>>);

impl Team {
    /// A pool of `threads` threads; the calling thread alone where no pool can be made.
    pub(crate) fn of(threads: usize) -> Team {
        Team(rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok().map(Arc::new))
    }

    /// Runs `work` on one of these threads. Steps taken there find the others awake, which makes them several times
    /// cheaper to share.
    pub fn lead<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Runs `work` on every block. Its result must not depend on the order in which blocks come.
    pub(crate) fn for_each<A: Send, B: Send>(
        &self,
        first: &mut [A],
        second: &mut [B],
        work: impl Fn(usize, &mut A, &mut B) + Sync + Send,
    ) {
        match &self.0 {
            Some(pool) => {
                // one part a thread: blocks are alike, and every part costs a handshake
                let share = first.len().div_ceil(pool.current_num_threads());
                pool.install(|| {
                    let parts = first.par_chunks_mut(share).zip(second.par_chunks_mut(share)).enumerate();
                    parts.for_each(|(part, (first, second))| {
                        let blocks = first.iter_mut().zip(second).enumerate();
                        blocks.for_each(|(block, (first, second))| work(part * share + block, first, second));
                    });
                });
            }
            None => {
                let blocks = first.iter_mut().zip(second).enumerate();
                blocks.for_each(|(block, (first, second))| work(block, first, second));
            }
        }
    }
}
