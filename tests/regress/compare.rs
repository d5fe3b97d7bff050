//! Whole comparisons: the shipped one, and one with the largest number of designs.

use std::path::PathBuf;

use crate::support::examples;
use netcast::{Lineup, MOST, RunOptions, compare};

/// Reading fails if a reported number names an unknown web or an unknown quantity.
#[test]
fn the_numbers_of_the_paper_are_quantities_of_its_webs() {
    let webs = ["01_traditional_web/traditional_web", "02_topological_web/topological_web", "03_space_web/space_web"];
    let webs: Vec<PathBuf> = webs.iter().map(|web| examples().join(format!("{web}.toml"))).collect();
    let folder = examples().join("07_three_webs");
    let lineup = Lineup::read(&webs, &[], &[], Some(&folder.join("reported.toml"))).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(lineup.names().collect::<Vec<_>>(), ["traditional_web", "topological_web", "space_web"]);

    // the command in the README names the same scenarios
    let readme = std::fs::read_to_string(folder.join("README.md")).unwrap();
    for web in &webs {
        let path = web.strip_prefix(examples()).unwrap();
        assert!(readme.contains(&format!("examples/{}", path.display())), "{}", path.display());
    }
}

#[test]
fn twelve_designs_are_distinct_in_table_and_page() {
    let folder = tempfile::tempdir().unwrap();
    let net = std::fs::read_to_string(examples().join("04_square_net/square_net.toml")).unwrap();
    let designs: Vec<PathBuf> = (0..MOST)
        .map(|i| {
            let path = folder.path().join(format!("speed_{}.toml", 20 + i));
            std::fs::write(
                &path,
                net.replace("axial_speed = \"20 m/s\"", &format!("axial_speed = \"{} m/s\"", 20 + i)),
            )
            .unwrap();
            path
        })
        .collect();
    let lineup =
        Lineup::read(&designs, &["solve.duration=20 ms".to_owned()], &[], None).unwrap_or_else(|e| panic!("{e}"));
    let target = folder.path().join("comparison");
    let compared = compare(&lineup, &target, &RunOptions { threads: 2, ..RunOptions::default() }, &|_| {}, &|| false)
        .unwrap_or_else(|e| panic!("{e}"));
    assert!(compared.failures.is_empty() && compared.comparison.finished);

    let [difference] = &compared.comparison.differences[..] else { panic!("{:?}", compared.comparison.differences) };
    assert_eq!((&difference.path[..], difference.values.len()), ("launch.axial_speed", MOST));
    // the fastest design travels farthest
    let travel = compared.comparison.table.iter().find(|row| row.quantity == "points.tractor.peak_travel_m").unwrap();
    assert_eq!(travel.best, ["speed_31"]);

    let page = std::fs::read_to_string(target.join("report.html")).unwrap();
    for design in 0..MOST {
        assert!(
            page.contains(&format!("id=\"replay-{design}\"")) && page.contains(&format!("--curve-{design}:")),
            "{design}"
        );
    }
    assert!(page.len() < 18_000_000, "{} bytes", page.len());
}
