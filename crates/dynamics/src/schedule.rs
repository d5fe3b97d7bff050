//! When the steps, the records and the checks of a run happen.
//!
//! The step follows from its bound alone. It divides a power of ten of a second, the *tick*, so that records at whole
//! ticks fall on steps. Any other record is taken at the step nearest to its time. So what is recorded changes no bit of
//! the motion.

/// Steps from one check of the energy to the next, at least.
const STEPS_PER_CHECK: u64 = 50;
/// Checks of a run, at most.
const MOST_CHECKS: u64 = 100_000;
/// How much larger the number of steps may become so that a smaller tick divides into steps.
const COST: f64 = 1.03;
/// The tick is at most this, s, where it holds [`FEWEST`] steps.
const LARGEST_TICK: f64 = 1e-3;
/// Fewest steps of a tick.
const FEWEST: f64 = 3.0;

/// When steps, records and checks happen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schedule {
    /// Step, s.
    pub dt: f64,
    /// Number of steps.
    pub count: u64,
    /// Time of the last step, s.
    pub end: f64,
    /// Time from one record to the next, s. A record is taken at the step nearest to its time.
    pub record_every: f64,
    tick: Tick,
}

/// A time that is a whole number of steps: a power of ten of a second, or a whole run.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Tick {
    /// Its length, s, and how many there are in a second.
    length: f64,
    per_second: f64,
    steps: u64,
}

impl Schedule {
    /// Steps not above `largest_dt` for `duration`, records each `record_every`; all in s. Where steps that divide a
    /// power of ten of a second do not end at `duration`, the step divides the duration.
    pub fn new(duration: f64, record_every: f64, largest_dt: f64) -> Schedule {
        let record_every = record_every.min(duration);
        let tick = Tick::new(largest_dt);
        let dt = tick.length / tick.steps as f64;
        let steps = (duration / dt).round();
        if steps >= 1.0 && (steps * dt - duration).abs() < 1e-12 * duration {
            return Schedule { dt, count: steps as u64, end: duration, record_every, tick };
        }
        let steps = whole(duration / largest_dt).max(1.0);
        let tick = Tick { length: duration, per_second: 0.0, steps: steps as u64 };
        Schedule { dt: duration / steps, count: steps as u64, end: duration, record_every, tick }
    }

    /// So many steps of exactly `dt`, s, each recorded.
    pub fn steps(dt: f64, count: u64) -> Schedule {
        let tick = Tick { length: dt, per_second: 0.0, steps: 1 };
        Schedule { dt, count, end: dt * count as f64, record_every: dt, tick }
    }

    /// No step: the start is recorded, as at the start of steps of `dt`.
    pub fn at_start(record_every: f64, dt: f64) -> Schedule {
        Schedule { count: 0, end: 0.0, dt, record_every, tick: Tick::new(dt) }
    }

    /// Time of a step, s.
    pub fn time(&self, step: u64) -> f64 {
        if step == self.count {
            return self.end;
        }
        let (ticks, steps) = (step / self.tick.steps, step % self.tick.steps);
        // a division rounds once: 49 / 100 is 0.49, 49 * 0.01 is not
        let is_fraction = self.tick.per_second > 1.0;
        let whole = if is_fraction { ticks as f64 / self.tick.per_second } else { ticks as f64 * self.tick.length };
        whole + steps as f64 * self.dt
    }

    /// Whether a step is recorded: the first, the last, and those nearest to the record times.
    pub fn records(&self, step: u64) -> bool {
        if step == 0 || step == self.count {
            return true;
        }
        let nearest = (step as f64 * self.dt / self.record_every).round();
        (nearest * self.record_every / self.dt).round() == step as f64
    }

    /// Whether the energy is checked at a step. That does not depend on what is recorded.
    pub fn checks(&self, step: u64) -> bool {
        step.is_multiple_of(STEPS_PER_CHECK.max(self.count / MOST_CHECKS)) || step == self.count
    }

    /// Records of the whole run, at most.
    pub fn record_count(&self) -> u64 {
        let by_time = (self.end / self.record_every).ceil() as u64;
        by_time.min(self.count) + 1
    }
}

impl Tick {
    /// Of the powers of ten that hold enough steps the smallest that costs little, at most [`LARGEST_TICK`] where that
    /// holds enough.
    fn new(largest_dt: f64) -> Tick {
        let steps = |exponent: i32| power_of_ten(exponent) / largest_dt;
        let mut exponent = -15;
        while steps(exponent) < FEWEST {
            exponent += 1;
        }
        let costs = |exponent: i32| whole(steps(exponent)) > COST * steps(exponent);
        while costs(exponent) && power_of_ten(exponent + 1) <= LARGEST_TICK {
            exponent += 1;
        }
        let (length, per_second) = (power_of_ten(exponent), power_of_ten(-exponent));
        Tick { length, per_second, steps: whole(steps(exponent)) as u64 }
    }
}

/// The least whole number of steps that is no smaller than `steps`, but for rounding.
fn whole(steps: f64) -> f64 {
    (steps * (1.0 - 1e-12)).ceil()
}

/// Ten to the power of `exponent`, rounded once.
fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().expect("a number")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_stays_below_its_bound_and_loses_little() {
        for i in 0..2000 {
            let bound = 1e-9 * 1.01_f64.powi(i);
            let schedule = Schedule::new(power_of_ten(bound.log10().ceil() as i32 + 3), bound, bound);
            assert!(schedule.dt <= bound, "{bound}");
            // three to a tick at worst, where that is a millisecond
            assert!(schedule.dt > 0.74 * bound, "{bound} {}", schedule.dt);
        }
    }

    #[test]
    fn a_duration_that_no_tick_divides_is_met() {
        let schedule = Schedule::new(1.23456789, 1e-3, 3.71e-5);
        assert_eq!(schedule.time(schedule.count), 1.23456789);
        assert!(schedule.dt <= 3.71e-5 && (schedule.dt * schedule.count as f64 - schedule.end).abs() < 1e-12);
    }

    #[test]
    fn the_step_does_not_depend_on_what_is_recorded() {
        let with = |every: f64| Schedule::new(1.2, every, 3.71e-5);
        for every in [1e-4, 1e-3, 2.5e-3, 0.01, 0.7, 5.0] {
            assert_eq!((with(every).dt, with(every).count), (with(1.0).dt, with(1.0).count));
        }
    }

    #[test]
    fn records_at_whole_milliseconds_fall_on_their_times() {
        let schedule = Schedule::new(0.3, 2e-3, 3.71e-5);
        let times: Vec<f64> = (0..=schedule.count).filter(|&s| schedule.records(s)).map(|s| schedule.time(s)).collect();
        assert_eq!(times.len(), 151);
        assert!(times.iter().enumerate().all(|(i, &time)| time == i as f64 * 2.0 / 1000.0), "{times:?}");
    }

    #[test]
    fn records_between_steps_are_taken_at_the_nearest() {
        let schedule = Schedule::new(0.01, 7e-5, 3.71e-5);
        let times: Vec<f64> = (0..=schedule.count).filter(|&s| schedule.records(s)).map(|s| schedule.time(s)).collect();
        for (i, time) in times.iter().enumerate().take(times.len() - 1) {
            assert!((time - i as f64 * 7e-5).abs() <= 0.5 * schedule.dt * (1.0 + 1e-9), "{i} {time}");
        }
        assert!(times.len() as u64 <= schedule.record_count() + 1);
    }

    #[test]
    fn a_record_interval_below_the_step_records_every_step() {
        let schedule = Schedule::new(0.01, 1e-6, 3.71e-5);
        assert!((0..=schedule.count).all(|step| schedule.records(step)));
        assert_eq!(schedule.record_count(), schedule.count + 1);
    }
}
