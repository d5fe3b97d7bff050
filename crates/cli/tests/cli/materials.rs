//! Ropes of the library and ropes for single links: the output of `check`, and the inputs that a result keeps.

use crate::workbench::Workbench;

const NET: &str = r#"
[web.square]
side = "1 m"
mesh = "0.5 m"
[rope]
material = "nylon rope"
diameter = "3 mm"
[ropes.edge]
material = "polyester rope"
diameter = "5 mm"
[assign]
outline = "edge"
"inner rope 2" = "edge"
[hold]
corners = true
[solve]
duration = "2 ms"
"#;

#[test]
fn check_prints_library_values_with_their_sources() {
    let workbench = Workbench::new(&[("net.toml", NET)]);
    let said = workbench.succeed(&["check", "net.toml"]).stdout;
    for line in
        ["nylon rope: ", "  elastic_modulus  1.32 GPa (nrel)", "  strength         1860 N (nrel)", "source nrel"]
    {
        assert!(said.contains(line), "{line} in\n{said}");
    }
    assert!(!said.contains("source teijin"), "{said}");
    // a value that the user gives is not a library value
    let said = workbench.succeed(&["check", "net.toml", "--set", "rope.strength=2 kN"]).stdout;
    assert!(!said.contains("1860 N"), "{said}");
}

#[test]
fn check_lists_the_links_that_assign_can_name() {
    let workbench = Workbench::new(&[("net.toml", NET)]);
    let said = workbench.succeed(&["check", "net.toml", "--links"]).stdout;
    let rope_of = |name: &str| said.lines().find(|line| line.trim_start().starts_with(name)).unwrap().to_owned();
    assert!(rope_of("inner rope 1 ").ends_with("inner, of rope, 0.5000 m"), "{said}");
    assert!(rope_of("inner rope 2 ").ends_with("inner, of edge, 0.5000 m"), "{said}");
    assert!(!workbench.succeed(&["check", "net.toml"]).stdout.contains("inner rope 1"));
}

#[test]
fn a_result_keeps_library_values_as_numbers_with_their_sources() {
    let workbench = Workbench::new(&[("net.toml", NET)]);
    workbench.succeed(&["run", "net.toml", "--quiet", "--out", "first"]);
    let inputs = workbench.read("first/inputs/scenario.toml");
    assert!(inputs.contains("# [ropes.edge] polyester rope: density = 865 kg/m^3 (nrel)\n"), "{inputs}");
    assert!(inputs.contains("\nelastic_modulus = \"1320000000 Pa\"\n") && !inputs.contains("\nmaterial"), "{inputs}");
    workbench.succeed(&["run", "first/inputs/scenario.toml", "--quiet", "--out", "second"]);
    assert_eq!(workbench.read("first/history.csv"), workbench.read("second/history.csv"));
}
