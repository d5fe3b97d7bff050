//! Readers accept or refuse any input without panic: the corpus of fuzz/, inputs too large for it, and damaged files of
//! netcast.

use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

use netcast::results::read_journal;
use netcast_fuzz::{TARGETS, Target, fields, graph_files, history, landmarks, overrides, scenario, summary, units};
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// The longest time for an input of a megabyte, in a debug build on a busy machine. A reader that hangs takes hours.
const PATIENCE: Duration = Duration::from_secs(60);

fn corpus(target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target)
}

/// Every input of the corpus, with its name.
fn inputs(target: &str) -> Vec<(String, Vec<u8>)> {
    let folder = corpus(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let mut inputs: Vec<_> = paths
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(&path).unwrap()))
        .collect();
    inputs.sort();
    assert!(inputs.len() >= 8, "{target} has only {} inputs", inputs.len());
    inputs
}

#[test]
fn the_corpus_is_read_or_refused() {
    let mut panicked = Vec::new();
    for (target, run) in TARGETS {
        for (name, bytes) in inputs(target) {
            if catch_unwind(|| run(&bytes)).is_err() {
                panicked.push(format!("{target}/{name}"));
            }
        }
    }
    assert!(panicked.is_empty(), "{} inputs panicked, see above: {panicked:#?}", panicked.len());
}

/// The valid seeds have the present format; otherwise readers would refuse them at their first bytes.
#[test]
fn the_plain_journal_of_the_corpus_is_read_completely() {
    let (_, lost) = read_journal(&corpus("journal").join("plain")).unwrap();
    assert_eq!(lost, 0);
    assert!(read_journal(&corpus("journal").join("an_older_version")).is_err());
}

/// Inputs of a megabyte, too large for the repository. Every target reads each of them.
#[test]
fn a_megabyte_of_anything_is_read_or_refused_in_time() {
    let mega = 1 << 20;
    let repeat = |unit: &str| unit.repeat(mega / unit.len());
    let hostile = [
        ("one line", repeat("a")),
        ("one number", repeat("9")),
        ("one unit", format!("1 {}", repeat("m"))),
        ("one unit expression", format!("1 m{}", repeat("/m"))),
        ("lines", repeat("a\n")),
        ("lines of a table", repeat("n1,0,0,0\n")),
        ("assignments", repeat("a = 1\n")),
        ("assignments of other keys", (0..mega / 16).map(|key| format!("k{key} = {key}\n")).collect()),
        ("headers", (0..mega / 16).map(|key| format!("[k{key}]\n")).collect()),
        ("blank lines", repeat("\n")),
        ("carriage returns", repeat("\r")),
        ("spaces", repeat(" ")),
        ("commas", repeat(",")),
        ("dots", repeat("a.")),
        ("equals signs", repeat("=")),
        ("quotes", repeat("\"")),
        ("quotes and commas", repeat("\",")),
        ("backslashes", format!("a = \"{}\"", repeat("\\"))),
        ("opening brackets", repeat("[")),
        ("opening braces", repeat("{\"a\":")),
        ("inline tables", format!("a = {}", repeat("{a="))),
        ("nul bytes", repeat("\0")),
        ("wide letters", repeat("🕸")),
        ("numbers in a list", format!("a = [{}]", repeat("1,"))),
    ];
    thread::scope(|scope| {
        for (target, run) in TARGETS {
            let hostile = &hostile;
            scope.spawn(move || {
                for (name, text) in hostile {
                    let clock = Instant::now();
                    run(text.as_bytes());
                    assert!(clock.elapsed() < PATIENCE, "{target}: {name}: {:?}", clock.elapsed());
                }
            });
        }
    });
}

/// The files of a chain of `rows` nodes: nodes, ropes, stowed positions. `rope` gives the row of the rope that ends at a node.
fn chain(rows: usize, rope: impl Fn(usize) -> String) -> Vec<u8> {
    let nodes: String = (0..rows).map(|node| format!("n{node},{node},0,0\n")).collect();
    let ropes: String = (1..rows).map(rope).collect();
    format!("id,x,y,z\n{nodes}\u{1c}a,b\n{ropes}\u{1c}id,x,y,z\n{nodes}").into_bytes()
}

/// Every unknown name was compared with every known name, although only the first twenty mistakes are reported.
#[test]
fn a_table_of_unknown_names_is_refused_in_time() {
    let clock = Instant::now();
    graph_files(&chain(20_000, |node| format!("m{node},k{node}\n")));
    assert!(clock.elapsed() < PATIENCE, "{:?}", clock.elapsed());
}

/// A field file with each byte changed, and cut at each byte. The reader panicked at an impossible number of nodes, and
/// accepted segments whose nodes did not exist.
#[test]
fn a_damaged_field_file_is_read_or_refused() {
    let whole = &fs::read(corpus("fields").join("plain")).expect("it is in the corpus");
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for first in 0..threads {
            scope.spawn(move || {
                for place in (first..whole.len()).step_by(threads) {
                    fields(&whole[..place]);
                    for change in [0x01, 0x80, 0xff] {
                        let mut damaged = whole.clone();
                        damaged[place] ^= change;
                        fields(&damaged);
                    }
                }
            });
        }
    });
}

/// Damage to a text.
#[derive(Clone, Debug)]
enum Mishap {
    LineLost(Index),
    LineTwice(Index),
    LinesSwapped(Index, Index),
    Byte(Index, u8),
    Cut(Index),
    Replaced(Index, &'static str),
}

/// Replacements for a word of a scenario.
const WORDS: &[&str] = &[
    "\"1 kg\"",
    "\"1 m/s\"",
    "\"90 deg\"",
    "1e308",
    "5e-324",
    "-0.0",
    "0",
    "-1",
    "nan",
    "inf",
    "\"1e999 m\"",
    "true",
    "[]",
    "{}",
    "[[]]",
    "\"\"",
    "\"n1\"",
    "4294967295",
    "9223372036854775807",
    "\"1\u{a0}m\"",
    "1979-05-27",
    "=",
    "\"",
    "#",
];

impl Mishap {
    fn any() -> impl Strategy<Value = Mishap> {
        let index = any::<Index>;
        prop_oneof![
            index().prop_map(Mishap::LineLost),
            index().prop_map(Mishap::LineTwice),
            (index(), index()).prop_map(|(one, other)| Mishap::LinesSwapped(one, other)),
            (index(), any::<u8>()).prop_map(|(place, byte)| Mishap::Byte(place, byte)),
            index().prop_map(Mishap::Cut),
            (index(), select(WORDS)).prop_map(|(place, word)| Mishap::Replaced(place, word)),
        ]
    }

    /// The text with this damage.
    fn apply(&self, text: &[u8]) -> Vec<u8> {
        let mut lines: Vec<&[u8]> = text.split_inclusive(|&byte| byte == b'\n').collect();
        let (bytes, count) = (text.len(), lines.len());
        if bytes == 0 {
            return Vec::new();
        }
        match self {
            Mishap::LineLost(line) => drop(lines.remove(line.index(count))),
            Mishap::LineTwice(line) => lines.insert(line.index(count), lines[line.index(count)]),
            Mishap::LinesSwapped(one, other) => lines.swap(one.index(count), other.index(count)),
            Mishap::Byte(place, byte) => {
                let mut text = text.to_vec();
                text[place.index(bytes)] = *byte;
                return text;
            }
            Mishap::Cut(place) => return text[..place.index(bytes)].to_vec(),
            Mishap::Replaced(place, word) => {
                let words: Vec<_> = words(text).collect();
                let Some(range) = words.get(place.index(words.len().max(1))) else { return text.to_vec() };
                return [&text[..range.start], word.as_bytes(), &text[range.end..]].concat();
            }
        }
        lines.concat()
    }
}

/// The places of words between blanks, line breaks and commas.
fn words(text: &[u8]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
    let parts = text.split(|byte| matches!(byte, b' ' | b'\n' | b','));
    let at = move |part: &[u8]| part.as_ptr() as usize - text.as_ptr() as usize;
    parts.filter(|part| !part.is_empty()).map(move |part| at(part)..at(part) + part.len())
}

/// The valid inputs of the corpus, each with its target.
fn valid_inputs() -> Vec<(Target, Vec<u8>)> {
    let whole = |target: &str, run: Target, starts: &[&str]| {
        let inputs = inputs(target).into_iter().filter(|(name, _)| starts.iter().any(|start| name.starts_with(start)));
        inputs.map(|(_, bytes)| (run, bytes)).collect::<Vec<_>>()
    };
    [
        whole("scenario", scenario, &["example_", "template_", "square"]),
        whole("graph_files", graph_files, &["plain", "example"]),
        whole("overrides", overrides, &["plain"]),
        whole("units", units, &["plain"]),
        whole("history", history, &["plain"]),
        whole("summary", summary, &["plain"]),
        whole("landmarks", landmarks, &["plain"]),
    ]
    .concat()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    /// The targets assert that nothing panics and that a refusal names a place.
    #[test]
    fn damaged_valid_inputs_are_read_or_refused(
        (run, text) in select(valid_inputs()),
        mishaps in prop::collection::vec(Mishap::any(), 1..4),
    ) {
        run(&mishaps.iter().fold(text, |text, mishap| mishap.apply(&text)));
    }
}
