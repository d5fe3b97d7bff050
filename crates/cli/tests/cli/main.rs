//! The `netcast` program as a user runs it: its output, its files, its exit status.

mod command_line;
mod compare;
mod contract;
mod failing_runs;
mod killed;
mod machine_says_no;
mod materials;
mod other_commands;
mod overrides;
mod result_folder;
mod same_bits;
mod workbench;
mod wrong_inputs;
