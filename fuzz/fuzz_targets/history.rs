//! See `netcast_fuzz::history`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::history(bytes));
