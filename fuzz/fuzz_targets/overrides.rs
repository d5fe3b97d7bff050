//! See `netcast_fuzz::overrides`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::overrides(bytes));
