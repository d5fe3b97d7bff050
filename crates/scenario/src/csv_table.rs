//! Reads a CSV file with a header: checks its columns, reads its cells, and collects faults with their lines.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Place, Source};
use crate::dimension::{Kind, Measured, unit};
use crate::interval::Interval;
use crate::memory::available;
use crate::nearest::nearest;
use crate::path::Path;
use crate::written::Written;

/// Number of faults of one file that are reported one by one. More are only counted.
pub(crate) const MOST_FAULTS: usize = 20;

/// Memory that the values of a table take, as a multiple of its text.
const COPIES: f64 = 12.0;

/// A CSV file that a scenario names. Rows are split only when they are read, as a whole table of cells can need more
/// memory than the values made from it.
#[derive(Clone, Debug)]
pub(crate) struct CsvTable {
    source: Arc<Source>,
    path: Path,
    header: Range<usize>,
    columns: Vec<String>,
    faults: Vec<Diagnostic>,
}

#[derive(Clone)]
struct Row {
    span: Range<usize>,
    line: usize,
    cells: Vec<String>,
}

/// Iterates over the rows of a text, header first.
struct Rows<'a> {
    text: &'a str,
    reader: csv::Reader<&'a [u8]>,
    record: csv::StringRecord,
}

impl<'a> Rows<'a> {
    fn new(text: &'a str) -> Self {
        let mut settings = csv::ReaderBuilder::new();
        let settings = settings.has_headers(false).flexible(true).trim(csv::Trim::All);
        Self { text, reader: settings.from_reader(text.as_bytes()), record: csv::StringRecord::new() }
    }
}

impl Iterator for Rows<'_> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        // reading cannot fail: the text is in memory and valid UTF-8
        if !self.reader.read_record(&mut self.record).is_ok_and(|more| more) {
            return None;
        }
        let position = self.record.position()?;
        let mut start = (position.byte() as usize).min(self.text.len());
        // blank lines before a record count as its own
        let blank = self.text[start..].bytes().take_while(|byte| matches!(byte, b'\n' | b'\r')).count();
        let line = position.line() as usize + self.text[start..start + blank].matches('\n').count();
        start += blank;
        let length = self.text[start..].find(['\n', '\r']).unwrap_or(self.text.len() - start);
        Some(Row { span: start..start + length, line, cells: self.record.iter().map(str::to_string).collect() })
    }
}

impl CsvTable {
    /// Reads the file that the scenario names at `path`. `None` where it names none or the file cannot be read.
    pub(crate) fn read(
        written: &Written,
        path: &str,
        required: &[&str],
        optional: &[&str],
        found: &mut Vec<Diagnostic>,
    ) -> Option<Self> {
        let path = Path::parse(path);
        let name = written.tree.get(&path)?.value.as_text()?;
        let file = written.files.path(name.as_ref());
        let most = available().map_or(f64::MAX, |bytes| bytes / COPIES);
        let text = match written.files.text(name.as_ref(), most) {
            Ok(text) => text,
            Err(reason) => {
                found.push(written.at_value(&path, format!("cannot read {}: {reason}", file.display())));
                return None;
            }
        };
        let source = Arc::new(Source { name: file.display().to_string(), text });
        let (header, columns) = Rows::new(&source.text).next().map(|row| (row.span, row.cells)).unwrap_or_default();
        let mut table = Self { source, path, header, columns, faults: Vec::new() };
        if !table.check_header(required, optional) {
            found.append(&mut table.faults);
            return None;
        }
        Some(table)
    }

    fn check_header(&mut self, required: &[&str], optional: &[&str]) -> bool {
        let known: Vec<&str> = required.iter().chain(optional).copied().collect();
        let expected = format!("expected the columns {}", known.join(","));
        let header = self.header.clone();
        let columns = self.columns.clone();
        if let Some((message, help)) = other_form(&columns, &known) {
            self.fault(header, message, Some(help));
            return false;
        }
        let mut seen = BTreeSet::new();
        let mut faulty = 0;
        for column in &columns {
            if seen.insert(column) && known.contains(&column.as_str()) {
                continue;
            }
            faulty += 1;
            if faulty > MOST_FAULTS {
                continue;
            } else if known.contains(&column.as_str()) {
                self.fault(header.clone(), format!("column `{column}` appears twice"), None);
            } else {
                let help = nearest(column, &known).map(|near| format!("did you mean `{near}`?"));
                self.fault(header.clone(), format!("unknown column {column:?}, {expected}"), help);
            }
        }
        if faulty > MOST_FAULTS {
            self.fault(header.clone(), format!("and {} more columns like these", faulty - MOST_FAULTS), None);
        }
        for column in required.iter().filter(|column| !columns.iter().any(|found| found == *column)) {
            self.fault(header.clone(), format!("missing column `{column}`, {expected}"), None);
        }
        self.faults.is_empty()
    }

    /// Reads every row with `read`, which returns `None` after it has reported a fault.
    pub(crate) fn rows<T>(
        &mut self,
        found: &mut Vec<Diagnostic>,
        mut read: impl FnMut(&mut Cells) -> Option<T>,
    ) -> Vec<T> {
        let mut read_rows = Vec::new();
        let mut more = 0;
        let source = self.source.clone();
        for row in Rows::new(&source.text).skip(1) {
            let is_reported = self.faults.len() < MOST_FAULTS;
            let (expected, count) = (self.columns.len(), row.cells.len());
            let filled =
                Row { cells: row.cells.iter().cloned().chain(empty()).take(expected).collect(), ..row.clone() };
            let mut cells = Cells { columns: &self.columns, row: &filled, is_reported, faults: Vec::new() };
            let is_read = read(&mut cells);
            if count == expected {
                read_rows.extend(is_read);
            } else {
                // its other faults follow from this one; it was read so that its id is known
                cells.faults.clear();
                cells.fault(format!("expected {expected} values, found {count}"), None);
            }
            for Fault { column, message, help } in cells.faults {
                if self.faults.len() < MOST_FAULTS {
                    let cell = column.and_then(|column| self.cell(&row, &column));
                    self.fault(cell.unwrap_or(row.span.clone()), message, help);
                } else {
                    more += 1;
                }
            }
        }
        if more > 0 {
            let end = self.source.text.len();
            self.fault(end..end, format!("and {more} more faults"), None);
        }
        found.append(&mut self.faults);
        read_rows
    }

    /// The bytes of the cell in `column`. `None` where the row has quotes, as a comma inside quotes separates no cells.
    fn cell(&self, row: &Row, column: &str) -> Option<Range<usize>> {
        let text = &self.source.text[row.span.clone()];
        let place = self.columns.iter().position(|name| name == column)?;
        let cell = text.split(',').nth(place).filter(|_| !text.contains('"'))?;
        let before: usize = text.split(',').take(place).map(|cell| cell.len() + 1).sum();
        let start = row.span.start + before + (cell.len() - cell.trim_start().len());
        Some(start..start + cell.trim().len())
    }

    /// A diagnostic about the file as a whole.
    pub(crate) fn whole(&self, message: &str) -> Diagnostic {
        Diagnostic::new(&self.path, message, Some(Place::File { source: self.source.clone(), span: 0..0 }))
    }

    /// A diagnostic about a row; row 1 follows the header.
    pub(crate) fn at_row(&self, row: usize, message: &str) -> Diagnostic {
        let span = Rows::new(&self.source.text).nth(row).map_or(0..0, |row| row.span);
        Diagnostic::new(&self.path, message, Some(Place::File { source: self.source.clone(), span }))
    }

    /// Whether the file has this column.
    pub(crate) fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|name| name == column)
    }

    /// Whether no row follows the header.
    pub(crate) fn is_empty(&self) -> bool {
        Rows::new(&self.source.text).nth(1).is_none()
    }

    fn fault(&mut self, span: Range<usize>, message: String, help: Option<String>) {
        let place = Place::File { source: self.source.clone(), span };
        self.faults.push(Diagnostic::new(&self.path, message, Some(place)).with_help_if(help));
    }
}

/// Cells without text, as many as are asked for.
fn empty() -> impl Iterator<Item = String> {
    std::iter::repeat_with(String::new)
}

/// What is wrong, and the help, where a header is in another form throughout: separated by something else than commas, or
/// with capitals.
fn other_form(columns: &[String], known: &[&str]) -> Option<(String, String)> {
    if let [whole] = columns {
        let separators = [(';', "semicolons"), ('\t', "tabs"), ('|', "bars")];
        let (mark, name) = separators.into_iter().find(|(mark, _)| whole.contains(*mark))?;
        let is_known = |name: &str| known.contains(&name.trim().to_lowercase().as_str());
        let what = format!("the values of this file are separated by {name}, not by commas");
        let help = "separate them by commas, and write decimals with a point".to_owned();
        return whole.split(mark).any(is_known).then_some((what, help));
    }
    let is_other =
        |column: &&String| !known.contains(&column.as_str()) && known.contains(&column.to_lowercase().as_str());
    let others: Vec<&String> = columns.iter().filter(is_other).collect();
    let (first, count) = (others.first()?, others.len());
    let small: Vec<String> = columns.iter().map(|column| column.to_lowercase()).collect();
    let more = if count == 1 { String::new() } else { format!(", and {} more", count - 1) };
    Some((
        format!("the names of columns are in small letters, not `{first}`{more}"),
        format!("write the header as {}", small.join(",")),
    ))
}

/// A fault of a row, or of its cell in `column`.
struct Fault {
    column: Option<String>,
    message: String,
    help: Option<String>,
}

/// The cells of one row.
pub(crate) struct Cells<'a> {
    columns: &'a [String],
    row: &'a Row,
    is_reported: bool,
    faults: Vec<Fault>,
}

impl<'a> Cells<'a> {
    /// The line of the file, counted from 1.
    pub(crate) fn line(&self) -> usize {
        self.row.line
    }

    /// Whether a fault of this row is reported and not only counted, so that help is worth searching for.
    pub(crate) fn is_reported(&self) -> bool {
        self.is_reported
    }

    /// Reports a fault of this row.
    pub(crate) fn fault(&mut self, message: String, help: Option<String>) {
        self.faults.push(Fault { column: None, message, help });
    }

    /// Reports a fault of this row's cell in `column`.
    pub(crate) fn fault_in(&mut self, column: &str, message: String, help: Option<String>) {
        self.faults.push(Fault { column: Some(column.to_owned()), message, help });
    }

    /// The text in `column`. `None` where the column is missing or the cell is empty.
    pub(crate) fn optional_text(&self, column: &str) -> Option<&'a str> {
        let place = self.columns.iter().position(|name| name == column)?;
        Some(self.row.cells[place].as_str()).filter(|text| !text.is_empty())
    }

    /// The text in `column`. Reports a fault where the cell is empty.
    pub(crate) fn text(&mut self, column: &str, expected: &str) -> Option<&'a str> {
        let text = self.optional_text(column);
        if text.is_none() {
            self.fault_in(column, format!("{column}: expected {expected}, found nothing"), None);
        }
        text
    }

    /// The number in `column`. Reports a fault where the cell is empty or its number is not finite or too large for its kind.
    pub(crate) fn number(&mut self, column: &str, kind: &Kind) -> Option<f64> {
        let text = self.text(column, "a number")?;
        self.parse(column, text, &Interval::ALL, kind)
    }

    /// The number in `column`: `Some(None)` where the cell is empty, `None` after it has reported a fault.
    pub(crate) fn optional_number(&mut self, column: &str, interval: &Interval, kind: &Kind) -> Option<Option<f64>> {
        let Some(text) = self.optional_text(column) else { return Some(None) };
        self.parse(column, text, interval, kind).map(Some)
    }

    fn parse(&mut self, column: &str, text: &str, interval: &Interval, kind: &Kind) -> Option<f64> {
        let bounded = kind.bounded(interval);
        let found: Option<f64> = text.parse().ok();
        let number = found.filter(|number| number.is_finite() && bounded.contains(*number));
        if number.is_none() {
            let is_huge = found.is_some_and(|number| number.abs() > kind.largest);
            let told = if is_huge { &bounded } else { interval };
            let expected = format!("a number {}", told.describe(Default::default()));
            let expected = expected.trim_end();
            self.fault_in(column, format!("{column}: expected {expected}, found {text:?}"), None);
        }
        number
    }

    /// The position in the columns x, y, z, m.
    pub(crate) fn position(&mut self) -> Option<[f64; 3]> {
        let [x, y, z] = ["x", "y", "z"].map(|column| self.number(column, unit::Metre::KIND));
        Some([x?, y?, z?])
    }
}

/// The ids of nodes, each with its line and its index among the nodes of the file.
#[derive(Default)]
pub(crate) struct Ids(BTreeMap<String, (usize, usize)>);

impl Ids {
    /// Whether it holds no id.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a node has this id.
    pub(crate) fn has(&self, id: &str) -> bool {
        self.0.contains_key(id)
    }

    /// Adds the id of a row. `None` after a fault: the id is missing or another row has it.
    pub(crate) fn take(&mut self, cells: &mut Cells) -> Option<String> {
        let id = cells.text("id", "a name")?.to_string();
        if let Some((line, _)) = self.0.get(&id) {
            cells.fault_in("id", format!("node {id:?} is already in line {line}"), None);
            return None;
        }
        self.0.insert(id.clone(), (cells.line(), self.0.len()));
        Some(id)
    }

    /// The index of the node that a row names in `column`.
    pub(crate) fn find(&self, cells: &mut Cells, column: &str) -> Option<usize> {
        let id = cells.text(column, "the id of a node")?;
        match self.0.get(id) {
            Some((_, place)) => Some(*place),
            None => {
                let help = if cells.is_reported() { self.suggest(id) } else { None };
                cells.fault_in(column, format!("{column}: unknown node {id:?}"), help);
                None
            }
        }
    }

    /// The most similar id, as a help.
    pub(crate) fn suggest(&self, id: &str) -> Option<String> {
        nearest(id, self.0.keys()).map(|near| format!("did you mean {near:?}?"))
    }
}
