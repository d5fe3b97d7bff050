//! See `netcast_fuzz::journal`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::journal(bytes));
