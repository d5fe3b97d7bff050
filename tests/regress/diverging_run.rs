//! A run that diverges between two records until f64 overflows: the results before are kept and readable.

use crate::support::examples;
use netcast::Case;

#[test]
fn a_run_that_overflows_keeps_its_results() {
    // without damping and near the stability limit the energy grows at every slack-taut event
    let overrides =
        ["rope.damping_ratio=0", "solve.step_fraction=0.9", "solve.on_energy_error=flag"].map(str::to_owned);
    let case = Case::read(examples().join("04_square_net/square_net.toml"), &overrides).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("run");
    let ran = case.simulation().threads(1).run_to(&target).unwrap();
    println!("{}", ran.failure.as_ref().expect("it diverges"));
    assert!(ran.failure.is_some() && !ran.summary.finished);
    let summary = netcast::results::Summary::read(&target.join("summary.json")).unwrap();
    assert!(summary.energy.closure.is_finite());
    assert!(netcast::results::read_fields(&target.join("fields.vtkhdf")).unwrap().times.len() > 1);
}
