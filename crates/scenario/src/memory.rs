//! How much memory is available. The system would kill a process that asks for more, without a message.

use std::fs;
use std::path::Path;

/// Bytes that this process can still allocate: the least that the machine, its control groups and the limit of its
/// address space leave. `None` where the system does not say.
pub fn available() -> Option<f64> {
    let machine = number_after(&fs::read_to_string("/proc/meminfo").ok()?, "MemAvailable:").map(|kib| 1024.0 * kib);
    [machine, addresses(), control_groups()].into_iter().flatten().reduce(f64::min)
}

/// Bytes that the limit of the address space (`ulimit -v`) leaves.
fn addresses() -> Option<f64> {
    let limit = number_after(&fs::read_to_string("/proc/self/limits").ok()?, "Max address space")?;
    let taken = number_after(&fs::read_to_string("/proc/self/status").ok()?, "VmSize:")?;
    Some((limit - 1024.0 * taken).max(0.0))
}

/// Bytes that the tightest control group of this process leaves. Containers limit memory in this way.
fn control_groups() -> Option<f64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let own = groups.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let left = |group: &Path| {
        let limit: f64 = fs::read_to_string(group.join("memory.max")).ok()?.trim().parse().ok()?;
        // the system frees pages of files when memory is short, so only anonymous pages count
        let taken = number_after(&fs::read_to_string(group.join("memory.stat")).ok()?, "anon ")?;
        Some((limit - taken).max(0.0))
    };
    let root = Path::new("/sys/fs/cgroup");
    root.join(own).ancestors().take_while(|group| group.starts_with(root)).filter_map(left).reduce(f64::min)
}

/// The number that follows `key` at the start of a line.
fn number_after(text: &str, key: &str) -> Option<f64> {
    text.lines().find_map(|line| line.strip_prefix(key))?.split_whitespace().next()?.parse().ok()
}

/// A number of bytes in words, in MB or GB.
pub fn in_words(bytes: f64) -> String {
    match bytes {
        bytes if bytes >= 1e9 => format!("{:.1} GB", 1e-9 * bytes),
        bytes => format!("{:.0} MB", (1e-6 * bytes).ceil()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_from_files_of_the_kernel() {
        let text =
            "MemTotal:  24689580 kB\nMemAvailable:   22000000 kB\nMax address space  unlimited  unlimited bytes\n";
        assert_eq!(number_after(text, "MemAvailable:"), Some(22e6));
        assert_eq!(number_after(text, "Max address space"), None);
        assert_eq!(number_after(text, "VmSize:"), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn this_machine_has_memory() {
        let available = available().expect("Linux says how much memory is available");
        assert!((1e7..1e15).contains(&available), "{available}");
    }

    #[test]
    fn bytes_are_given_in_mb_or_gb() {
        assert_eq!([in_words(12.0), in_words(4.25e8), in_words(1.84e10)], ["1 MB", "425 MB", "18.4 GB"]);
    }
}
