//! See `netcast_fuzz::units`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::units(bytes));
