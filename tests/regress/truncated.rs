//! Files of a run, cut at every byte: readers accept the rest up to its last record, or refuse it.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use netcast::report::write_report;
use netcast::results::{Checkpoint, CheckpointEvery, Fields, History, folder, read_fields, recover};
use netcast::scenario::Document;
use netcast::scenario::Source;
use netcast::{Case, RunOptions};
use tempfile::TempDir;

const SCENARIO: &str = r#"
web.square = { side = "1 m", mesh = "1 m", segments_per_mesh = 1 }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
tractor.particle.mass = "0.3 kg"
launch.radial_speed = "1 m/s"
solve = { duration = "10 ms", on_energy_error = "flag" }
record = { every = "1 ms", fields_every = "2 ms" }
"#;

fn case() -> Case {
    let source = Source { name: "scenario.toml".into(), text: SCENARIO.into() };
    let document = Document::parse(source, Path::new("."), &[]).unwrap_or_else(|errors| panic!("{errors}"));
    Case::of(document).unwrap_or_else(|errors| panic!("{errors}"))
}

fn options(resume: bool) -> RunOptions {
    // one checkpoint, at the first record after 4 ms
    RunOptions { threads: 1, resume, checkpoint_every: CheckpointEvery::Simulated(4e-3) }
}

/// The folder of a complete run, and the folder of the same run after it died at its seventh record.
fn cut_off(root: &TempDir) -> (PathBuf, PathBuf) {
    let [whole, target] = ["whole", "net"].map(|name| root.path().join(name));
    case().simulation().options(options(false)).run_to(&whole).unwrap();
    let mut records = 0;
    let die = |_| {
        records += 1;
        assert!(records < 7, "the run dies here, on purpose");
    };
    let case = case();
    let dying = case.simulation().options(options(false)).progress(die);
    let died = catch_unwind(AssertUnwindSafe(|| dying.run_to(&target)));
    assert!(died.is_err() && !target.exists());
    (whole, root.path().join("net.running"))
}

fn files_in(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
    files.map(|path| (path.clone(), fs::read(&path).unwrap())).collect()
}

/// Replaces the files of a folder. The old ones are removed first: on some file systems overwriting waits for the disk.
fn restore(folder: &Path, files: &[(PathBuf, Vec<u8>)]) {
    for (path, _) in files_in(folder) {
        fs::remove_file(path).unwrap();
    }
    for (path, content) in files {
        fs::write(path, content).unwrap();
    }
}

/// These files; the one called `name` is cut at the byte `end`.
fn cut(files: &[(PathBuf, Vec<u8>)], name: &str, end: usize) -> Vec<(PathBuf, Vec<u8>)> {
    let cut = |(path, content): &(PathBuf, Vec<u8>)| {
        let end = if path.ends_with(name) { end } else { content.len() };
        (path.clone(), content[..end].to_vec())
    };
    files.iter().map(cut).collect()
}

/// The frames of complete fields that are records: one every second row. The others are moments, which a run that died
/// lacks.
fn recorded(fields: &Fields, history: &History) -> Vec<usize> {
    let rows: Vec<f64> = history.values("time_s").unwrap().flatten().step_by(2).collect();
    (0..fields.times.len()).filter(|&frame| rows.contains(&fields.times[frame])).collect()
}

#[test]
fn a_run_that_died_is_readable_up_to_its_last_record_and_can_be_resumed() {
    let root = TempDir::new().unwrap();
    let (whole, left) = cut_off(&root);
    let told = recover(&left).unwrap();
    assert_eq!(told, ["there is no summary: the run was cut off before its end"]);
    let [history, whole_history] = [&left, &whole].map(|of| History::read(&of.join(folder::HISTORY)).unwrap());
    assert_eq!((history.rows().len(), history.rows()), (7, &whole_history.rows()[..7]));
    let [fields, all] = [&left, &whole].map(|of| read_fields(&of.join(folder::FIELDS)).unwrap());
    let frames = recorded(&all, &whole_history);
    assert_eq!(fields.times, frames[..4].iter().map(|&frame| all.times[frame]).collect::<Vec<_>>());
    assert_eq!((fields.positions(3), fields.velocities(3)), (all.positions(frames[3]), all.velocities(frames[3])));
    write_report(&left).unwrap();
    // a second recovery changes and reports nothing
    assert_eq!(recover(&left).unwrap(), [""; 0]);

    let ran = case().simulation().options(options(true)).run_to(root.path().join("net")).unwrap();
    assert!(ran.summary.finished && !left.exists());
    for file in [folder::HISTORY, folder::FIELDS] {
        assert!(fs::read(ran.folder.join(file)).unwrap() == fs::read(whole.join(file)).unwrap(), "{file}");
    }
}

#[test]
fn a_file_cut_at_any_byte_is_read_up_to_its_last_complete_record_or_refused() {
    let root = TempDir::new().unwrap();
    let (whole, left) = cut_off(&root);
    let (history, fields) =
        (History::read(&whole.join(folder::HISTORY)).unwrap(), read_fields(&whole.join(folder::FIELDS)).unwrap());
    let records = recorded(&fields, &history);
    let files = files_in(&left);
    let mut read = 0;
    for name in [folder::HISTORY, folder::FIELDS_PART] {
        let (_, content) = files.iter().find(|(path, _)| path.ends_with(name)).unwrap();
        for end in 0..content.len() {
            restore(&left, &cut(&files, name, end));
            let told = match recover(&left) {
                Ok(told) => told,
                Err(refused) => {
                    assert!(refused.to_string().contains(name), "{refused}");
                    continue;
                }
            };
            read += 1;
            let found = History::read(&left.join(folder::HISTORY)).unwrap();
            assert!(
                found.columns() == history.columns() && history.rows().starts_with(found.rows()),
                "{name} at {end}"
            );
            let frames = read_fields(&left.join(folder::FIELDS)).unwrap();
            for frame in 0..frames.times.len() {
                let of_whole = records[frame];
                assert_eq!(frames.times[frame], fields.times[of_whole], "{name} at {end}");
                assert_eq!(frames.positions(frame), fields.positions(of_whole), "{name} at {end}");
                assert_eq!(frames.tensions(frame), fields.tensions(of_whole), "{name} at {end}");
            }
            // an incomplete record is reported; a cut between two records leaves none
            let cut_inside = match name {
                folder::HISTORY => content[end - 1] != b'\n',
                _ => told.iter().any(|told| told.contains("are no whole frame")),
            };
            assert_eq!(told.iter().any(|told| told.starts_with(name)), cut_inside, "{name} at {end}: {told:?}");
        }
    }
    assert!(read > 1000, "{read} of the cuts were read");
}

#[test]
fn a_run_is_resumed_only_from_files_with_all_records_of_its_checkpoint() {
    let root = TempDir::new().unwrap();
    let (whole, left) = cut_off(&root);
    let target = root.path().join("net");
    let files = files_in(&left);
    let (mut resumed, mut refused) = (0, 0);
    for name in [folder::HISTORY, folder::FIELDS_PART, folder::CHECKPOINT] {
        let (path, content) = files.iter().find(|(path, _)| path.ends_with(name)).unwrap();
        // readers are tried at every byte, whole runs at about every hundredth
        for end in (0..content.len()).step_by(97) {
            fs::create_dir_all(&left).unwrap();
            restore(&left, &cut(&files, name, end));
            match case().simulation().options(options(true)).run_to(&target) {
                Ok(ran) => {
                    assert_ne!(name, folder::CHECKPOINT);
                    for file in [folder::HISTORY, folder::FIELDS] {
                        let [one, other] = [&whole, &ran.folder].map(|of| fs::read(of.join(file)).unwrap());
                        assert!(one == other, "{name} cut at {end}: {file} differs");
                    }
                    fs::remove_dir_all(&target).unwrap();
                    resumed += 1;
                }
                Err(error) => {
                    assert!(error.to_string().contains(name), "{name} cut at {end}: {error}");
                    assert!(fs::read(path).unwrap() == content[..end], "{name} cut at {end} was touched");
                    refused += 1;
                }
            }
        }
    }
    assert!(resumed > 5 && refused > 20, "{resumed} went on, {refused} were refused");
}

#[test]
fn a_checkpoint_with_a_byte_missing_or_changed_is_refused() {
    let root = TempDir::new().unwrap();
    let (_, left) = cut_off(&root);
    let path = left.join(folder::CHECKPOINT);
    let content = fs::read(&path).unwrap();
    let (_, input_hash) = Checkpoint::read(&path).unwrap();
    assert_eq!(input_hash.len(), 64);
    let is_refused = |bytes: &[u8]| {
        Checkpoint::from_bytes(bytes, &path).is_err_and(|error| error.to_string().contains(folder::CHECKPOINT))
    };
    for end in 0..content.len() {
        assert!(is_refused(&content[..end]), "cut at {end}");
    }
    for byte in 0..content.len() {
        let mut changed = content.clone();
        changed[byte] ^= 0x10;
        assert!(is_refused(&changed), "byte {byte} changed");
    }
    assert!(is_refused(&[&content[..], b"\0"].concat()));
}

#[test]
fn a_finished_result_with_a_torn_history_is_read_up_to_the_tear() {
    let root = TempDir::new().unwrap();
    let (whole, _) = cut_off(&root);
    assert_eq!(recover(&whole).unwrap(), [""; 0]);
    let path = whole.join(folder::HISTORY);
    let content = fs::read(&path).unwrap();
    let kept = History::read(&path).unwrap().rows().len() - 1;
    fs::write(&path, &content[..content.len() - 5]).unwrap();
    let told = recover(&whole).unwrap();
    assert!(told.len() == 1 && told[0].contains(&format!("are no whole row; {kept} rows kept")), "{told:?}");
    write_report(&whole).unwrap();
}
