//! A run into a folder: written as it goes, swapped in when it is complete.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use netcast_dynamics::simulate::StepError;
use netcast_results::{
    Checkpoint, Checkpoints, Machine, Manifest, ResultError, ResultFolder, SecondRun, Summary, folder, require_room,
};

use crate::case::Case;
use crate::error::RunError;
use crate::progress::{Interrupted, Progress, Tell};
use crate::resume::left_behind;
use crate::simulate::{Ended, RunOptions, Simulation, Start, Watchers, fields_every};
use crate::verdict::Failure;

/// A run that was carried out into a folder, to its end or not.
#[derive(Debug)]
pub struct Ran {
    /// Its summary, as in summary.json.
    pub summary: Summary,
    /// The result folder.
    pub folder: PathBuf,
    /// Why it failed; what was computed is in the folder all the same.
    pub failure: Option<Failure>,
    /// Whether it can go on from where it stopped.
    pub can_resume: bool,
}

impl Simulation<'_> {
    /// Carries the run out and writes its results to `target`. While it runs, what it has is in `<target>.running`, and
    /// outlasts a crash.
    ///
    /// # Errors
    /// [`RunError`], with nothing written, where `target` cannot be written or there is nothing to resume;
    /// [`RunError::CutOff`] where results cannot be written any more. A run that goes wrong on the way is no error: it
    /// is a [`Ran`] with a [`Failure`].
    pub fn run_to(self, target: impl AsRef<Path>) -> Result<Ran, RunError> {
        let clock = Instant::now();
        let Simulation { case, options, mut watchers, mut progress, interrupted } = self;
        let input_hash = case.inputs().hash();
        require_room(target.as_ref(), written_bytes(case))?;
        let (folder, mut checkpoint) = if options.resume {
            left_behind(target.as_ref(), case.inputs(), &input_hash)?
        } else {
            (ResultFolder::running(target.as_ref())?, None)
        };
        let manifest = Manifest::new(input_hash.clone(), Machine::this(), options.threads);
        let wall_time_before = checkpoint.as_ref().map_or(Duration::ZERO, Checkpoint::wall_time);
        let mut second = checkpoint.as_ref().and_then(|checkpoint| checkpoint.second_run.clone());
        let again = |second: &SecondRun| case.with_step_fraction(second.step_fraction);
        let mut case_now = second.as_ref().map_or_else(|| case.clone(), again);
        let mut attempt = Attempt { folder, manifest, options: &options, wall_time_before, clock };
        loop {
            let ended =
                attempt.carry_out(&case_now, &second, checkpoint.take(), &mut watchers, &mut *progress, &*interrupted);
            let ended = ended?;
            let Some(next) = ended.second_run(case, second.is_none()) else {
                return attempt.end(ended, second.as_ref());
            };
            drop(ended);
            // what follows is no continuation of what was there
            attempt.folder.forget_checkpoint()?;
            case_now = again(&next);
            second = Some(next);
        }
    }
}

/// A run into a folder, at one step.
struct Attempt<'o> {
    folder: ResultFolder,
    manifest: Manifest,
    options: &'o RunOptions,
    wall_time_before: Duration,
    clock: Instant,
}

impl Attempt<'_> {
    /// Runs `case` to its end, from `checkpoint` where there is one.
    fn carry_out<'c>(
        &mut self,
        case: &'c Case,
        second: &Option<SecondRun>,
        checkpoint: Option<Checkpoint>,
        watchers: &mut Watchers,
        progress: &mut Tell,
        interrupted: &Interrupted,
    ) -> Result<Ended<'c>, RunError> {
        let Self { folder, manifest, options, .. } = self;
        begin(folder.path(), case, manifest)?;
        let start = Start::of(case, options.threads, progress, interrupted);
        let end_s = start.schedule().time(start.schedule().count);
        let mut tell = |time_s: f64| progress(Progress::Running { time_s, end_s });
        let recorder = start.recorder(&mut tell, interrupted)?;
        let checkpoints = Checkpoints {
            every: options.checkpoint_every,
            input_hash: manifest.input_hash.clone(),
            wall_time_before: self.wall_time_before,
            clock: self.clock,
            second_run: second.clone(),
        };
        let recorder = match &checkpoint {
            None => recorder.keep_in(folder.path(), checkpoints)?,
            Some(checkpoint) => {
                let other = |_| ResultError::NotCheckpoint { path: folder.path().join(folder::CHECKPOINT) };
                checkpoint.snapshot.check(&case.model().system, start.schedule()).map_err(other)?;
                recorder.go_on_in(folder.path(), checkpoints, checkpoint)?
            }
        };
        // from here on there is something to lose
        folder.keep();
        let ended = start.simulate(recorder, watchers, checkpoint.as_ref(), options.threads);
        ended.map_err(|error| self.cut_off(error.into()))
    }

    /// Writes what the run comes to and puts its folder in its place.
    fn end(mut self, ended: Ended, second: Option<&SecondRun>) -> Result<Ran, RunError> {
        self.manifest.wall_time_s = (self.wall_time_before + self.clock.elapsed()).as_secs_f64();
        let kept = self.folder.path().to_path_buf();
        let ran = publish(ended, self.folder, &self.manifest, second);
        ran.map_err(|source| RunError::CutOff { source: Box::new(source), folder: kept })
    }

    fn cut_off(&self, source: RunError) -> RunError {
        RunError::CutOff { source: Box::new(source), folder: self.folder.path().to_path_buf() }
    }
}

/// Writes what the run comes to and puts its folder in its place.
fn publish(
    ended: Ended,
    mut folder: ResultFolder,
    manifest: &Manifest,
    second: Option<&SecondRun>,
) -> Result<Ran, RunError> {
    let (failure, warnings) = ended.verdict(second);
    // a run that was interrupted can go on; any other ended, or would end in the same way again
    let can_resume = matches!(ended.outcome.stopped, Some(StepError::Interrupted { .. }));
    if can_resume {
        folder.goes_on();
    }
    let summary = ended.summary(manifest.wall_time_s, warnings);
    let folder = complete(folder, &summary, manifest)?;
    Ok(Ran { summary, folder, failure, can_resume })
}

/// Writes what a result folder has before its run begins; first of all, whose folder it is.
pub(crate) fn begin(folder: &Path, case: &Case, manifest: &Manifest) -> Result<(), RunError> {
    manifest.write(&folder.join(folder::MANIFEST))?;
    case.inputs().write(folder)?;
    case.landmarks().write(&folder.join(folder::LANDMARKS))?;
    Ok(())
}

/// Writes what a result folder has once its run is over, and puts it in its place.
pub(crate) fn complete(folder: ResultFolder, summary: &Summary, manifest: &Manifest) -> Result<PathBuf, RunError> {
    summary.write(&folder.path().join(folder::SUMMARY))?;
    manifest.write(&folder.path().join(folder::MANIFEST))?;
    netcast_report::write_report(folder.path())?;
    Ok(folder.publish()?)
}

/// Bytes that the fields of a run take at its end: the frames as they came, and the file that is made of them.
pub(crate) fn written_bytes(case: &Case) -> f64 {
    let (model, schedule) = (case.model(), case.schedule());
    let nodes = model.system.mass().len() as f64;
    let cells = (model.system.segments().len() + model.system.membranes().len()) as f64;
    let frames = schedule.record_count() as f64 / fields_every(model) as f64 + 1.0;
    let bodies = model.system.bodies().len() as f64;
    2.0 * frames * (1.0 + 6.0 * nodes + cells + 4.0 * bodies) * size_of::<f64>() as f64
}
