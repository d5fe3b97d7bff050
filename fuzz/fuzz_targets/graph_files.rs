//! See `netcast_fuzz::graph_files`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::graph_files(bytes));
