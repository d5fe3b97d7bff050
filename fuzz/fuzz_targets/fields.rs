//! See `netcast_fuzz::fields`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::fields(bytes));
