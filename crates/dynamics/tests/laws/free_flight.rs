//! Conservation laws that hold for any net without air.

use crate::nets;
use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::simulate::{Schedule, simulate};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::Environment;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The centre of mass falls as a stone, momentum changes by m g t, angular momentum about the falling origin stays.
    #[test]
    fn momenta_are_kept(mut net in nets::any_net(0.05), falling: bool) {
        let gravity = if falling { DVec3::new(0.0, 0.0, -9.80665) } else { DVec3::ZERO };
        net.parts.environment = Environment { gravity, mass_damping: 0.0, ..Environment::default() };
        let system = net.build();
        let mass = system.mass();
        let total: f64 = mass.iter().sum();
        let mut film = nets::Film::default();
        let schedule = Schedule::new(0.3, 0.01, 0.3 * step_limit(&system).dt.min(1e-3));
        let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
        prop_assert!(outcome.stopped.is_none());

        let sum = |f: &dyn Fn(usize) -> DVec3| (0..mass.len()).map(f).sum::<DVec3>();
        let (_, x0, v0) = &film.frames[0];
        let centre = sum(&|i| mass[i] * x0[i]) / total;
        let momentum = sum(&|i| mass[i] * v0[i]);
        let scale: f64 = (0..mass.len()).map(|i| mass[i] * v0[i].length()).sum();
        let spin = sum(&|i| mass[i] * x0[i].cross(v0[i]));
        for (t, x, v) in &film.frames {
            let fallen = 0.5 * gravity * t * t;
            let expected = centre + momentum / total * *t + fallen;
            prop_assert!((sum(&|i| mass[i] * x[i]) / total - expected).length() < 1e-9);
            let gained = sum(&|i| mass[i] * v[i]) - momentum - total * gravity * *t;
            prop_assert!(gained.length() < 1e-9 * scale, "momentum off by {}", gained.length() / scale);
            // in the frame that falls with the net there is no gravity
            let now = sum(&|i| mass[i] * (x[i] - fallen).cross(v[i] - gravity * *t));
            let size: f64 = (0..mass.len()).map(|i| mass[i] * x[i].length() * v[i].length()).sum();
            prop_assert!((now - spin).length() < 1e-9 * size, "angular momentum off by {}", (now - spin).length() / size);
        }
    }

    /// Internal damping only ever takes energy, and the balance closes.
    #[test]
    fn the_energy_balance_closes(net in nets::any_net(0.05)) {
        let system = net.build();
        let schedule = Schedule::new(0.2, 0.01, 0.2 * step_limit(&system).dt.min(1e-3));
        let outcome = simulate(&system, &net.state, &schedule, 1, &mut nets::Film::default());
        prop_assert!(outcome.ledger[Channel::RopeDamping] >= -1e-3 * outcome.balance.initial());
        prop_assert!(outcome.balance.closure() < 0.01, "closure {}", outcome.balance.closure());
    }
}
