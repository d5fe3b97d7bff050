//! The names of what a result folder holds.

/// The scenario as resolved, with the files it names.
pub const INPUTS: &str = "inputs";
/// The run in numbers.
pub const SUMMARY: &str = "summary.json";
/// The table of a comparison.
pub const SUMMARY_CSV: &str = "summary.csv";
/// One row a record step.
pub const HISTORY: &str = "history.csv";
/// Every node and rope at every record step.
pub const FIELDS: &str = "fields.vtkhdf";
/// What of the fields has a meaning.
pub const LANDMARKS: &str = "landmarks.json";
/// The page to look at.
pub const REPORT: &str = "report.html";
/// Pictures for documents, where they were asked for.
pub const PICTURES: &str = "pictures";
/// Who ran what, where and when.
pub const MANIFEST: &str = "manifest.json";

/// The run as it stands, where it did not end.
pub const CHECKPOINT: &str = "checkpoint";
/// The fields of a run that is under way.
pub const FIELDS_PART: &str = "fields.part";
/// What marks the folder of a run that is under way, and keeps other runs out.
pub const LOCK: &str = "lock";

/// All that a result folder may hold of ours, the folders of a comparison's designs apart.
pub const OURS: [&str; 12] = [
    INPUTS,
    SUMMARY,
    SUMMARY_CSV,
    HISTORY,
    FIELDS,
    LANDMARKS,
    REPORT,
    PICTURES,
    MANIFEST,
    CHECKPOINT,
    FIELDS_PART,
    LOCK,
];
