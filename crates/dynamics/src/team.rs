//! The threads of a run.

use std::sync::Arc;

use rayon::prelude::*;

/// The threads that a net is advanced on.
#[derive(Debug, Clone, Default)]
pub struct Team(Option<Arc<rayon::ThreadPool>>);

impl Team {
    /// So many threads; the calling one alone where they cannot be had.
    pub(crate) fn of(threads: usize) -> Team {
        Team(rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok().map(Arc::new))
    }

    /// Does `work` on one of these threads. Steps taken there find the others awake, which makes them several times
    /// cheaper to share.
    pub fn lead<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Work over blocks. What it does to a block must not depend on the others' turn.
    pub(crate) fn for_each<A: Send, B: Send>(
        &self,
        one: &mut [A],
        other: &mut [B],
        work: impl Fn(usize, &mut A, &mut B) + Sync + Send,
    ) {
        match &self.0 {
            Some(pool) => {
                // one part a thread: blocks are alike, and every part costs a handshake
                let share = one.len().div_ceil(pool.current_num_threads());
                pool.install(|| {
                    let parts = one.par_chunks_mut(share).zip(other.par_chunks_mut(share)).enumerate();
                    parts.for_each(|(part, (one, other))| {
                        let blocks = one.iter_mut().zip(other).enumerate();
                        blocks.for_each(|(block, (one, other))| work(part * share + block, one, other));
                    });
                });
            }
            None => {
                let blocks = one.iter_mut().zip(other).enumerate();
                blocks.for_each(|(block, (one, other))| work(block, one, other));
            }
        }
    }
}
