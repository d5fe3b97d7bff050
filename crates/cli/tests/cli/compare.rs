//! `netcast compare`: its files, its refusals, and the same bits for any number of threads.

use serde_json::{Value, json};

use crate::workbench::{GRAPH_NET, NODES, ROPES, SMALL_NET, Workbench};

/// Two small nets; the second has the finer mesh.
fn two() -> Workbench {
    let fine = SMALL_NET.replace("mesh = \"0.5 m\"", "mesh = \"0.25 m\"").replace("A small net", "A finer net");
    Workbench::new(&[("coarse.toml", SMALL_NET), ("fine.toml", &fine)])
}

fn row<'s>(summary: &'s Value, quantity: &str) -> &'s Value {
    let rows = summary["table"].as_array().unwrap();
    rows.iter().find(|row| row["quantity"] == quantity).unwrap_or_else(|| panic!("no row {quantity}"))
}

#[test]
fn two_scenarios_give_one_table_one_page_and_two_results() {
    let workbench = two();
    let ended = workbench.succeed(&["compare", "coarse.toml", "fine.toml"]);
    assert!(ended.stdout.contains("Mass of the web, kg"), "{}", ended.stdout);
    assert!(ended.stdout.contains("results/comparison/report.html"), "{}", ended.stdout);
    assert_eq!(ended.stderr, "");

    let summary = workbench.summary("results/comparison");
    assert_eq!(summary["title"], "coarse and fine");
    assert_eq!(summary["finished"], true);
    assert_eq!(summary["designs"][1]["title"], "A finer net");
    let mesh = json!([{"path": "web.square.mesh", "values": {"coarse": "0.5 m", "fine": "0.25 m"}}]);
    assert_eq!(summary["differences"], mesh);
    for design in ["coarse", "fine"] {
        for file in
            ["summary.json", "history.csv", "fields.vtkhdf", "report.html", "manifest.json", "inputs/scenario.toml"]
        {
            assert!(workbench.path(&format!("results/comparison/{design}/{file}")).is_file(), "{design}/{file}");
        }
        let own = workbench.summary(&format!("results/comparison/{design}"));
        for (section, key) in [("opening", "area_max_m2"), ("model", "web_mass_kg"), ("tension", "max_n")] {
            assert_eq!(
                row(&summary, &format!("{section}.{key}"))["values"][design],
                own[section][key],
                "{design} {key}"
            );
        }
    }
    assert_eq!(row(&summary, "model.web_mass_kg")["best"], json!(["coarse"]));
    assert_eq!(row(&summary, "wall_time_s")["reproducible"], false);

    let csv = workbench.read("results/comparison/summary.csv");
    assert!(csv.starts_with("quantity,unit,coarse,fine\n"), "{csv}");
    assert_eq!(csv.lines().count(), 1 + summary["table"].as_array().unwrap().len());
    let page = workbench.read("results/comparison/report.html");
    for said in ["A finer net", "0.25 m", "id=\"replay-1\"", "href=\"fine/report.html\""] {
        assert!(page.contains(said), "{said}");
    }
}

#[test]
fn json_is_the_summary_and_nothing_else() {
    let workbench = two();
    let ended = workbench.succeed(&["compare", "coarse.toml", "fine.toml", "--json", "--out", "both"]);
    assert_eq!(ended.stdout, workbench.read("both/summary.json"));
    assert_eq!(serde_json::from_str::<Value>(&ended.stdout).unwrap()["designs"][0]["folder"], "coarse");
    let quiet = workbench.succeed(&["compare", "coarse.toml", "fine.toml", "--quiet", "--out", "both"]);
    assert_eq!((&quiet.stdout[..], &quiet.stderr[..]), ("", ""));
}

/// The files of a comparison without wall times, manifest and report.
fn bits(workbench: &Workbench, folder: &str) -> Vec<(String, Vec<u8>)> {
    let listing = workbench.listing().into_iter();
    let own = listing.filter_map(|(name, bytes)| Some((name.strip_prefix(&format!("{folder}/"))?.to_owned(), bytes)));
    let kept = own.filter(|(name, _)| !name.ends_with("manifest.json") && !name.ends_with("report.html"));
    kept.map(|(name, bytes)| {
        if name.ends_with("summary.json") || name.ends_with("summary.csv") {
            (name, without_clock(&String::from_utf8(bytes).unwrap()).into_bytes())
        } else {
            (name, bytes)
        }
    })
    .collect()
}

/// A summary without its wall time: a line, or a row in the table of a comparison.
fn without_clock(text: &str) -> String {
    if let Ok(mut summary) = serde_json::from_str::<Value>(text)
        && let Some(rows) = summary["table"].as_array_mut()
    {
        let count = rows.len();
        rows.retain(|row| row["quantity"] != "wall_time_s");
        assert_eq!(rows.len() + 1, count);
        return summary.to_string();
    }
    let kept: Vec<&str> = text.lines().filter(|line| !line.contains("wall_time_s")).collect();
    assert_eq!(kept.len() + 1, text.lines().count());
    kept.join("\n")
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let workbench = two();
    for threads in ["1", "2", "5"] {
        workbench.succeed(&["compare", "coarse.toml", "fine.toml", "--quiet", "--threads", threads, "--out", threads]);
    }
    let once = bits(&workbench, "1");
    assert!(once.iter().any(|(name, _)| name == "fine/fields.vtkhdf"));
    for threads in ["2", "5"] {
        for ((name, a), (other, b)) in once.iter().zip(bits(&workbench, threads)) {
            assert_eq!(*name, other);
            assert!(*a == b, "{name} differs on {threads} threads");
        }
    }
    // a comparison runs a design as `netcast run` does
    workbench.succeed(&["run", "fine.toml", "--quiet"]);
    assert!(workbench.read("results/fine/history.csv") == workbench.read("1/fine/history.csv"));
}

#[test]
fn a_result_folder_is_compared_without_running_it_again() {
    let workbench = two();
    workbench.succeed(&["run", "coarse.toml", "--quiet", "--set", "launch.axial_speed=25 m/s"]);
    let before = workbench.read("results/coarse/summary.json");
    workbench.succeed(&["compare", "results/coarse", "fine.toml", "--quiet", "--set", "launch.radial_speed=11 m/s"]);
    assert_eq!(workbench.read("results/comparison/coarse/summary.json"), before);
    let summary = workbench.summary("results/comparison");
    let speed = |path: &str| {
        let all = summary["differences"].as_array().unwrap();
        all.iter().find(|difference| difference["path"] == path).map(|difference| difference["values"].clone())
    };
    // the override changed the scenario and not the result
    assert_eq!(speed("launch.radial_speed"), Some(json!({"coarse": "10 m/s", "fine": "11 m/s"})));

    // its own results can be compared again, into the same folder
    let again = ["compare", "results/comparison/fine", "results/comparison/coarse", "--quiet"];
    workbench.succeed(&again);
    assert_eq!(workbench.read("results/comparison/coarse/summary.json"), before);
    assert_eq!(workbench.summary("results/comparison")["title"], "fine and coarse");
    workbench.succeed(&["report", "results/comparison"]);
}

#[test]
fn designs_are_named_after_their_files_and_a_new_comparison_replaces_an_old_one() {
    let workbench = two();
    std::fs::create_dir(workbench.path("other")).unwrap();
    std::fs::copy(workbench.path("fine.toml"), workbench.path("other/coarse.toml")).unwrap();
    let quietly = ["--quiet", "--out", "both"];
    workbench.succeed(&[&["compare", "coarse.toml", "fine.toml"], &quietly[..]].concat());
    std::fs::write(workbench.path("both/notes.md"), "keep").unwrap();
    workbench.succeed(&[&["compare", "fine.toml", "other/coarse.toml"], &quietly[..]].concat());
    let folders = |name: &str| workbench.path("both").join(name).is_dir();
    assert!(folders("fine") && folders("coarse"));
    assert_eq!(workbench.read("both/notes.md"), "keep");
    assert_eq!(workbench.summary("both/coarse")["title"], "A finer net");

    // two designs of one name get the names of their folders
    workbench.succeed(&[&["compare", "coarse.toml", "other/coarse.toml"], &quietly[..]].concat());
    assert!(folders("other_coarse") && !folders("coarse") && !folders("fine"));
}

#[test]
fn all_mistakes_are_reported_at_once_and_nothing_is_written() {
    let workbench = Workbench::new(&[
        ("net.toml", SMALL_NET),
        ("bad.toml", &SMALL_NET.replace("side = \"2 m\"", "side = \"2 kg\"")),
        ("worse.toml", &SMALL_NET.replace("[rope]", "[roope]")),
        ("reported.toml", "[net]\nopening.area_max_m = 2\n[nett]\n"),
    ]);
    let before = workbench.listing();
    let ended = workbench.netcast(&[
        "compare",
        "net.toml",
        "./net.toml",
        "bad.toml",
        "worse.toml",
        "none.toml",
        "--reported",
        "reported.toml",
    ]);
    assert_eq!(ended.status, 2);
    for said in [
        "./net.toml is named twice",
        "bad.toml:4:8",
        "did you mean `rope`?",
        "cannot read none.toml",
        "`opening.area_max_m` is no quantity",
        "did you mean `opening.area_max_m2`?",
        "no design is called `nett`",
        "missing key `source`",
        "nothing was written",
    ] {
        assert!(ended.stderr.contains(said), "{said}: {}", ended.stderr);
    }
    for (arguments, said) in [
        (&["compare", "net.toml"][..], "expected 2 to 12 designs to compare, found 1"),
        (&["compare", "net.toml", "."], "expected a scenario or a result folder that netcast wrote"),
        (&["compare", "net.toml", "bad.toml", "--set", "rope.colour=red"], "in --set rope.colour=red"),
        (&["compare"], "<SCENARIO>..."),
    ] {
        let ended = workbench.netcast(arguments);
        assert_eq!(ended.status, 2, "{arguments:?}");
        assert!(ended.stderr.contains(said), "{arguments:?}: {}", ended.stderr);
    }
    assert!(workbench.listing() == before, "something was written");

    // a folder that netcast did not write is refused before anything is run
    std::fs::create_dir(workbench.path("thesis")).unwrap();
    std::fs::write(workbench.path("thesis/chapter.tex"), "").unwrap();
    std::fs::write(workbench.path("other.toml"), SMALL_NET).unwrap();
    let ended = workbench.netcast(&["compare", "net.toml", "other.toml", "--out", "thesis"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("was not written by netcast"), "{}", ended.stderr);
}

#[test]
fn a_failed_design_is_compared_up_to_its_failure() {
    let diverges = SMALL_NET
        .replace("elastic_modulus = \"5 GPa\"", "elastic_modulus = \"5 GPa\"\ndamping_ratio = 0")
        .replace("duration = \"50 ms\"", "duration = \"0.6 s\"\nstep_fraction = 0.99");
    let workbench = Workbench::new(&[("net.toml", SMALL_NET), ("torn.toml", &diverges)]);
    let ended = workbench.netcast(&["compare", "net.toml", "torn.toml"]);
    assert_eq!(ended.status, 3, "{}", ended.stderr);
    assert!(ended.stderr.contains("torn failed:") && !ended.stderr.contains("net failed:"), "{}", ended.stderr);
    let summary = workbench.summary("results/comparison");
    assert_eq!((&summary["finished"], &summary["designs"][0]["finished"]), (&json!(false), &json!(true)));
    assert!(summary["designs"][1]["failure"].is_string());
    for row in summary["table"].as_array().unwrap() {
        assert!(!row["best"].as_array().unwrap().contains(&json!("torn")), "{}", row["quantity"]);
    }
    assert!(workbench.read("results/comparison/report.html").contains("<b>torn</b>: "));
}

#[test]
fn reported_numbers_stand_beside_the_results() {
    let reported = "source = \"A test\"\n[fine]\nmodel.web_mass_kg = 0.5\ntension.max_where = \"inner\"\n";
    let workbench = two();
    std::fs::write(workbench.path("reported.toml"), reported).unwrap();
    workbench.succeed(&[
        "compare",
        "coarse.toml",
        "fine.toml",
        "--quiet",
        "--reported",
        "reported.toml",
        "--out",
        "both",
    ]);
    let summary = workbench.summary("both");
    assert_eq!(summary["reported"], "A test");
    let mass = row(&summary, "model.web_mass_kg");
    assert_eq!(mass["reported"], json!({"fine": 0.5}));
    let expected = 100.0 * (mass["values"]["fine"].as_f64().unwrap() / 0.5 - 1.0);
    assert!((mass["deviation_percent"]["fine"].as_f64().unwrap() - expected).abs() < 1e-9);
    assert!(workbench.read("both/summary.csv").starts_with("quantity,unit,coarse,fine,fine_reported\n"));
    assert_eq!(workbench.read("both/inputs/reported.toml"), reported);
}

#[test]
fn graph_files_of_one_name_are_compared_by_their_content() {
    let workbench = Workbench::new(&[("net.toml", GRAPH_NET), ("nodes.csv", NODES), ("ropes.csv", ROPES)]);
    std::fs::create_dir(workbench.path("wide")).unwrap();
    for (name, text) in
        [("net.toml", GRAPH_NET), ("nodes.csv", &NODES.replace("n1,1,1", "n1,1.5,1.5")), ("ropes.csv", ROPES)]
    {
        std::fs::write(workbench.path("wide").join(name), text).unwrap();
    }
    workbench.succeed(&["compare", "net.toml", "wide/net.toml", "--quiet", "--out", "both"]);
    let summary = workbench.summary("both");
    let paths: Vec<&Value> = summary["differences"].as_array().unwrap().iter().map(|d| &d["path"]).collect();
    assert_eq!(paths, ["inputs/nodes.csv"]);
}

#[test]
fn variants_of_one_file_are_the_runs_with_those_values_byte_for_byte() {
    let workbench = Workbench::new(&[("net.toml", SMALL_NET)]);
    let vary = ["--vary", "launch.axial_speed=\"20 m/s\",30 m/s", "--vary", "solve.duration=10ms,20ms"];
    let ended = workbench.succeed(&[&["compare", "net.toml", "--quiet"][..], &vary].concat());
    assert_eq!(ended.stderr, "");
    let summary = workbench.summary("results/comparison");
    let names: Vec<&str> =
        summary["designs"].as_array().unwrap().iter().map(|design| design["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), 4);
    assert_eq!(names[2], "axial_speed=30 m_s, duration=10ms");
    workbench.succeed(&[
        "run",
        "net.toml",
        "--quiet",
        "--set",
        "launch.axial_speed=30 m/s",
        "--set",
        "solve.duration=10ms",
        "--out",
        "alone",
    ]);
    for file in ["history.csv", "fields.vtkhdf", "inputs/scenario.toml"] {
        let of = |folder: &str| std::fs::read(workbench.path(&format!("{folder}/{file}"))).unwrap();
        assert!(of(&format!("results/comparison/{}", names[2])) == of("alone"), "{file}");
    }

    let refused = workbench.netcast(&["compare", "net.toml", "--vary", "solve.duration=1,2,3,4,5,6,7,8,9,10,11,12,13"]);
    assert_eq!(refused.status, 2);
    assert!(refused.stderr.contains("13 variants of each scenario; a comparison has at most 12"), "{}", refused.stderr);
    let refused = workbench.netcast(&["compare", "net.toml"]);
    assert!(refused.stderr.contains("--vary tractor.particle.mass="), "{}", refused.stderr);
}

/// A spreadsheet would have run the name.
#[test]
fn a_design_whose_name_is_a_formula_is_a_text_in_the_table() {
    let workbench = Workbench::new(&[("=cmd|' !A1.toml", SMALL_NET), ("b.toml", SMALL_NET)]);
    workbench.succeed(&["compare", "=cmd|' !A1.toml", "b.toml", "--quiet", "--set", "solve.duration=5ms"]);
    let csv = workbench.read("results/comparison/summary.csv");
    assert!(csv.starts_with("quantity,unit,'=cmd|' !A1,b\n"), "{}", csv.lines().next().unwrap());
}

/// It exited with 1 and named a hidden folder that was gone.
#[test]
fn a_damaged_result_is_refused_by_its_path_before_anything_runs() {
    let workbench = two();
    workbench.succeed(&["run", "fine.toml", "--quiet", "--out", "result", "--set", "solve.duration=5ms"]);
    for file in ["history.csv", "fields.vtkhdf", "landmarks.json", "summary.json"] {
        let path = workbench.path(&format!("result/{file}"));
        let whole = std::fs::read(&path).unwrap();
        std::fs::write(&path, &whole[..whole.len() / 2]).unwrap();
        let ended = workbench.netcast(&["compare", "coarse.toml", "result"]);
        assert_eq!(ended.status, 2, "{file}: {}", ended.stderr);
        assert!(ended.stderr.contains(&format!("result/{file}")), "{}", ended.stderr);
        assert!(ended.stderr.contains("nothing was written"), "{}", ended.stderr);
        std::fs::write(&path, whole).unwrap();
    }
}
