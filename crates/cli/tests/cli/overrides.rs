//! `--set`: overrides of scenario values on the command line.

use crate::workbench::Workbench;

#[test]
fn an_override_takes_effect_and_is_kept_among_the_inputs() {
    let workbench = Workbench::with_net();
    let set =
        ["--set", "launch.axial_speed=\"30 m/s\"", "--set", "launch.radial_speed=0", "--set", "environment.gravity=0"];
    let mut arguments = vec!["run", "net.toml", "--quiet"];
    arguments.extend(set);
    workbench.succeed(&arguments);
    // without gravity and tension the masses start at 30 m/s and never become faster
    let tractor = &workbench.summary("results/net")["points"]["tractor"];
    assert!((tractor["peak_speed_m_s"].as_f64().unwrap() - 30.0).abs() < 1e-9, "{tractor}");
    assert!(workbench.read("results/net/inputs/scenario.toml").contains("30"));
}

#[test]
fn a_whole_variant_can_be_replaced() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet", "--set", "stow={bag={radius=\"0.2 m\"}}"]);
    assert!(workbench.read("results/net/inputs/scenario.toml").contains("[stow.bag]"));
}

#[test]
fn the_last_of_two_overrides_counts() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet", "--set", "title=first", "--set", "title=second"]);
    assert_eq!(workbench.summary("results/net")["title"], "second");
}

#[test]
fn wrong_overrides_are_shown_as_they_were_given_and_nothing_is_written() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    for (set, said) in [
        ("launch.axal_speed=60 m/s", "did you mean `axial_speed`?"),
        ("lunch.axial_speed=60 m/s", "did you mean `launch`?"),
        ("launch.axial_speed=60 kg", "which is a mass"),
        ("launch.axial_speed=60 m/z", "unknown unit \"z\""),
        ("launch.axial_speed", "expected path=value"),
        ("stow.bag.radius=0.2 m", "found `scale` and `bag`"),
        ("contact={}", "not available in this version yet"),
        ("web.sqare.side=2", "did you mean `square`?"),
        ("solve.on_energy_error=flga", "did you mean \"flag\"?"),
        ("tractors.0.corner=1.5", "corner"),
        ("solve.duration=-1 s", "greater than 0"),
    ] {
        let ended = workbench.netcast(&["run", "net.toml", "--set", set]);
        assert_eq!(ended.status, 2, "{set}: {}", ended.stderr);
        assert!(ended.stderr.contains(said), "{set}: {}", ended.stderr);
        assert!(ended.stderr.contains(&format!("in --set {set}")), "{set}: {}", ended.stderr);
        assert!(ended.stderr.contains("nothing was written"), "{set}: {}", ended.stderr);
    }
    assert!(workbench.listing() == before, "something was written");
}
