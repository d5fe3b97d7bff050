//! When steps and records of a run happen.

/// When steps and records happen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schedule {
    /// Step, s.
    pub dt: f64,
    /// Number of steps.
    pub count: u64,
    /// Steps from one record to the next.
    pub steps_per_record: u64,
    /// Time from one record to the next, s.
    pub record_every: f64,
    /// Time of the last step, s.
    pub end: f64,
}

impl Schedule {
    /// A step not above `largest_dt` that divides `record_every`, and `duration` too if one that is little smaller does;
    /// else the run ends at the whole step nearest to `duration`.
    pub fn new(duration: f64, record_every: f64, largest_dt: f64) -> Schedule {
        let record_every = record_every.min(duration);
        let records = duration / record_every;
        let fewest = (record_every / largest_dt).ceil().max(1.0);
        // steps a record, such that the duration is a whole number of them
        let ends_on_time = |steps: &f64| ((records * steps).round() / (records * steps) - 1.0).abs() < 1e-12;
        let more = (0.02 * fewest + 100.0).min(10_000.0);
        let steps_per_record = (0..more as u64).map(|i| fewest + i as f64).find(ends_on_time);
        let steps = steps_per_record.unwrap_or(fewest);
        let dt = record_every / steps;
        let count = (records * steps).round().max(1.0);
        let end = if steps_per_record.is_some() { duration } else { count * dt };
        Schedule { dt, count: count as u64, steps_per_record: steps as u64, record_every, end }
    }

    /// No step: the start is recorded, as at the start of steps of `dt`.
    pub fn at_start(record_every: f64, dt: f64) -> Schedule {
        Schedule { dt, count: 0, steps_per_record: 1, record_every, end: 0.0 }
    }

    /// Time of a step, s. Records fall on whole multiples of `record_every`.
    pub fn time(&self, step: u64) -> f64 {
        if step == self.count {
            return self.end;
        }
        let (records, steps) = (step / self.steps_per_record, step % self.steps_per_record);
        // a division rounds once: 49 / 100 is 0.49, 49 * 0.01 is not
        let rate = (1.0 / self.record_every).round();
        let whole =
            if rate * self.record_every == 1.0 { records as f64 / rate } else { records as f64 * self.record_every };
        whole + steps as f64 * self.dt
    }

    /// Whether a step is recorded.
    pub fn records(&self, step: u64) -> bool {
        step.is_multiple_of(self.steps_per_record) || step == self.count
    }
}
