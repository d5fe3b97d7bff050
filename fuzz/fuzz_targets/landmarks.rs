//! See `netcast_fuzz::landmarks`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::landmarks(bytes));
