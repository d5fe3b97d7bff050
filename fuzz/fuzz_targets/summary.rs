//! See `netcast_fuzz::summary`.
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| netcast_fuzz::summary(bytes));
