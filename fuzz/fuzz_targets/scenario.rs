//! See `netcast_fuzz::scenario`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::scenario(bytes));
