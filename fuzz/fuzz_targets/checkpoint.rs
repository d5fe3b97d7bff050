//! See `netcast_fuzz::checkpoint`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::checkpoint(bytes));
