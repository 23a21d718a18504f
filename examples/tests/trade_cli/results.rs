//! What counts as a result of a sweep, when it is made again, and where it comes from.

use crate::common::words;
use crate::{SWEEP, Trade, mark};
use mps_io::Value;

/// Each run says when and where it was made, whenever the tables are written.
#[test]
fn the_day_and_the_machine_are_those_of_the_runs() {
    let trade = Trade::new("origin");
    let two = SWEEP.replace("[1, 2, 4]", "[2, 3]");
    trade.good(&two, &["--quiet"]);
    let file = trade.below("across_2").join("run.json");
    let record = std::fs::read_to_string(&file).unwrap();
    let mut record: Value = record.parse().unwrap();
    let (today, here) = (record["date"].clone(), record["machine"].clone());
    assert!(today.as_str().is_some_and(|day| day.len() == 10) && here.is_string(), "{record}");
    record["date"] = "2020-02-29".into();
    record["machine"] = "a slow one, 1 cores".into();
    std::fs::write(&file, record.to_string()).unwrap();
    trade.good(&two, &["--tables", "--quiet"]);
    let table = trade.table();
    assert_eq!((&table["rows"][0]["date"], &table["rows"][1]["date"]), (&"2020-02-29".into(), &today));
    assert_eq!(table["dates"].as_array().unwrap().len(), 2);
    let text = std::fs::read_to_string(trade.out().join("trade.md")).unwrap();
    let span =
        format!("2020-02-29 to {}, **on 2 machines, whose seconds do not compare**", today.as_str().unwrap());
    assert!(text.contains(&span) && text.contains("a slow one, 1 cores"), "{text}");
    // A record of a time when neither was kept is a record.
    for key in ["date", "machine"] {
        record.as_object_mut().unwrap().remove(key);
    }
    std::fs::write(&file, record.to_string()).unwrap();
    let mark = mark(&trade.below("across_2"));
    trade.good(&two, &["--quiet"]);
    assert!(mark.exists() && trade.table()["rows"][0]["date"].is_null());
}

#[test]
fn what_failed_is_made_again_on_request_only() {
    let trade = Trade::new("again");
    let two = SWEEP.replace("[1, 2, 4]", "[1, 2]");
    trade.good(&two, &["--quiet"]);
    let [failed, done] = ["across_1", "across_2"].map(|run| mark(&trade.below(run)));
    trade.good(&two, &["--quiet"]);
    assert!(failed.exists() && done.exists());
    trade.good(&two, &["--quiet", "--retry-failed"]);
    assert!(!failed.exists() && done.exists());
}

/// A flag that the program does not have is a mistake in the sweep: nothing after it is run, and the same sweep is not taken for one with results.
#[test]
fn a_misspelt_flag_stops_at_once() {
    let trade = Trade::new("misspelt");
    let output = trade.run(&SWEEP.replace("across = [1, 2, 4]", "acros = [2, 3]"), &[]);
    let said = words(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("cantilever does not take these arguments") && said.contains("'--acros'"),
        "{said}"
    );
    assert!(said.contains("1 of 2: acros 2") && !said.contains("2 of 2"), "{said}");
    assert!(!trade.below("acros_2").join("run.json").exists());
}

#[test]
fn a_sweep_without_a_result_is_a_failure() {
    let trade = Trade::new("all-failed");
    let output = trade.run(&SWEEP.replace("[1, 2, 4]", "[0, 1]"), &["--quiet"]);
    let said = words(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("no run has a result; the first failed: --across is 0"), "{said}");
    assert_eq!(trade.table()["rows"].as_array().unwrap().len(), 2, "the tables are there all the same");
}

/// A gate that is still opening has no largest opening to compare.
#[test]
fn a_run_that_did_not_come_to_its_results_is_no_good_one() {
    let trade = Trade::new("short-gate");
    let sweep = "title = \"Short\"\nprogram = \"elastic-gate\"\ncounts = [{ metric = \"gate_x_max\", tolerance = 9 }]\n\
                 [[vary]]\nspacing = 2.5e-3\nacross = 2\nend-time = 1e-3\n";
    let output = trade.run(sweep, &["--quiet"]);
    assert_eq!(output.status.code(), Some(1), "{}", words(&output.stderr));
    assert_eq!(trade.table()["rows"][0]["failure"], "summary.json has no error of gate_x_max");
}

/// When the first run of a sweep is made, the tables have all that ended before.
#[test]
fn what_has_ended_is_in_the_tables_from_the_start() {
    let trade = Trade::new("early");
    trade.good(&SWEEP.replace("[1, 2, 4]", "[3, 4]"), &["--quiet"]);
    // The first of these is misspelt and ends everything, as an interruption would.
    let broken = SWEEP.replace("across = [1, 2, 4]", "acros = 1\n[[vary]]\nacross = [3, 4]");
    assert!(!trade.run(&broken, &["--quiet"]).status.success());
    assert_eq!(trade.table()["rows"].as_array().unwrap().len(), 2);
}
