//! No sweep and no step takes more instructions than the table says, nor fewer.
//!
//! Needs valgrind, hence not among the tests that run anywhere: `cargo test -p mps-benches --test counts -- --ignored`.
//! A test, so that it counts the program that was built for the tests.

use std::process::Command;

#[test]
#[ignore = "needs valgrind"]
fn every_count_is_the_one_in_the_table() {
    let checked = Command::new(env!("CARGO_BIN_EXE_count")).arg("check").status();
    assert!(checked.is_ok_and(|status| status.success()), "see above");
}
