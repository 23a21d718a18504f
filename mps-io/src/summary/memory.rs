//! How much memory the process has used.

/// Largest resident memory of this process so far (bytes); `None` where the system does not tell.
pub fn peak_memory_bytes() -> Option<u64> {
    // Linux: "VmHWM:     123456 kB", the high water mark.
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}
