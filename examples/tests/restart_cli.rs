//! Runs that are stopped, killed or fail, and go on: the results are those of a run in one piece, to the last bit.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, words};
use mps_io::checkpoint::Rotation;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

const MPS: &str = env!("CARGO_BIN_EXE_mps");

/// An interval of checkpoints, in seconds of wall time, that has always passed.
const ALWAYS: &str = "1e-9";

/// A scene of the gallery, shortened to `end` seconds, as a file.
fn scene(name: &str, changes: &[(&str, &str)], end: &str) -> PathBuf {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    let mut text = std::fs::read_to_string(file).unwrap();
    let old = text.lines().find(|line| line.starts_with("end_time")).unwrap().to_owned();
    for (from, to) in changes.iter().chain(&[(old.as_str(), format!("end_time = {end}").as_str())]) {
        assert_eq!(text.matches(from).count(), 1, "{name} has {from}");
        text = text.replace(from, to);
    }
    let dir = fresh("restart-scenes", &format!("{name}-{end}"));
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join(name);
    std::fs::write(&file, text).unwrap();
    file
}

/// Two waters and a gate, with intervals of their own so that the end may change.
fn reservoirs(end: &str) -> PathBuf {
    let output = "spacing = 5e-3\n# sqrt";
    let intervals = "clamp = { sides = [\"bottom\"] }\n\n[output]\nprobe_interval = 2e-4\nframe_interval = 4e-3\nfield_interval = 4e-3\n";
    let changes = [("spacing = 4e-3\n# sqrt", output), ("clamp = { sides = [\"bottom\"] }\n", intervals)];
    scene("two-reservoirs.toml", &changes, end)
}

/// The channel with a slower flow that comes up to speed at once.
fn channel(end: &str) -> PathBuf {
    let changes = [
        ("mean_speed = 2.0", "mean_speed = 0.2"),
        ("ramp = 2.0", "ramp = 0.1"),
        ("sound_speed = 40.0", "sound_speed = 4.0"),
        ("background_pressure = 8000.0", "background_pressure = 80.0"),
    ];
    scene("turek-hron.toml", &changes, end)
}

/// Runs a scene in one piece.
fn whole(name: &str, scene: &Path) -> PathBuf {
    let dir = fresh("restart", name);
    let output = execute(MPS, &dir, &["run", scene.to_str().unwrap(), "--quiet", "--threads", "1"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    dir
}

fn start(arguments: &[&str]) -> Child {
    let command = &mut Command::new(MPS);
    command.args(arguments).args(["--quiet"]).stderr(Stdio::piped()).spawn().unwrap()
}

fn begin(scene: &Path, dir: &Path, interval: &str) -> Child {
    let places = [scene, dir].map(|path| path.to_str().unwrap());
    start(&["run", places[0], "--out", places[1], "--checkpoint", interval, "--threads", "2"])
}

fn go_on(dir: &Path, more: &[&str]) -> Output {
    Command::new(MPS).arg("resume").arg(dir).arg("--quiet").args(more).output().unwrap()
}

fn resumed(dir: &Path, more: &[&str]) {
    let output = go_on(dir, more);
    assert!(output.status.success(), "{}", words(&output.stderr));
}

/// Waits until something has come about, or the program has ended.
fn wait_until(come_about: impl Fn() -> bool, child: &mut Child) {
    while !come_about() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Whether a run has begun to write the third of its fields.
fn on_its_way(dir: &Path) -> bool {
    let mut names = std::fs::read_dir(dir.join("fields")).into_iter().flatten();
    names.any(|entry| entry.unwrap().file_name().to_str().unwrap().ends_with("_00002.vtu"))
}

fn signal(child: &Child, name: &str) {
    assert!(Command::new("kill").args([name, &child.id().to_string()]).status().unwrap().success());
}

fn last(dir: &Path) -> PathBuf {
    dir.join("checkpoint").join("last.mps")
}

/// Tables and fields are the same files; the film has as many frames.
fn assert_same(one: &Path, other: &Path) {
    let read = |dir: &Path, file: &str| std::fs::read(dir.join(file)).unwrap();
    assert!(read(one, "probes.csv") == read(other, "probes.csv"), "probes.csv");
    let mut names: Vec<_> =
        std::fs::read_dir(one.join("fields")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert!(names.len() > 3);
    for name in names {
        let name = format!("fields/{}", name.to_str().unwrap());
        assert!(read(one, &name) == read(other, &name), "{name}");
    }
    // The number of frames stands behind the header of the picture and the length and name of its chunk.
    let frames = |dir: &Path| read(dir, "film.png")[41..45].to_vec();
    assert_eq!(frames(one), frames(other), "frames of the film");
}

#[test]
fn a_run_that_was_stopped_by_a_signal_goes_on_with_the_same_bits() {
    let scenes = [
        ("gate", reservoirs("0.04")),
        ("piston", scene("wave-maker.toml", &[("spacing = 5e-3", "spacing = 1e-2")], "0.3")),
        ("plate", scene("cantilever.toml", &[], "0.2")),
    ];
    for (k, (name, scene)) in scenes.iter().enumerate() {
        let one = whole(name, scene);
        let dir = fresh("restart", &format!("{name}-stopped"));
        // A checkpoint before every step makes the run slow, so that it is still on its way when the signal comes.
        let mut child = begin(scene, &dir, ALWAYS);
        wait_until(|| on_its_way(&dir), &mut child);
        signal(&child, if k == 0 { "-INT" } else { "-TERM" });
        let output = child.wait_with_output().unwrap();
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains("stopped by a signal"), "{name}: {said}");
        assert!(said.contains(&format!("go on with `mps resume {}`", dir.display())), "{said}");
        // The stop has kept its own state, not that of the step before.
        let kept = kept_time(&dir);
        assert_eq!(kept.is_some(), *name != "plate", "{name}: the time of the water");
        if let Some(kept) = kept {
            assert!(said.contains(&format!("t = {kept:e} s")), "{name}: {kept:e} s were kept: {said}");
        }
        // What has been computed until then is there.
        assert!(dir.join("summary.json").exists() && dir.join("energies.png").exists(), "{name}");
        resumed(&dir, &["--threads", "3"]);
        assert_same(&one, &dir);
    }
}

/// A channel with an elastic flag is prolonged, after particles have entered and left.
#[test]
fn a_channel_goes_on_with_the_same_bits() {
    let one = whole("channel", &channel("0.5"));
    let dir = whole("channel-begun", &channel("0.3"));
    let (checkpoint, _) = Rotation::new(dir.join("checkpoint")).read().unwrap();
    let mut sections = checkpoint.state.sections().iter();
    let passed = sections.find(|section| section.name == "wet/scene/fluid/open/passed").unwrap();
    for count in passed.bytes.chunks(8) {
        assert!(u64::from_ne_bytes(count.try_into().unwrap()) > 50, "{:?}", passed.bytes);
    }
    resumed(&dir, &["--end-time", "0.5", "--threads", "3"]);
    assert_same(&one, &dir);
}

/// Simulated time of the checkpoint that a resumed run would begin with.
fn kept_time(dir: &Path) -> Option<f64> {
    let (checkpoint, _) = Rotation::new(dir.join("checkpoint")).read().ok()?;
    let time =
        checkpoint.state.sections().iter().find(|section| section.name == "wet/scene/fluid/time/now")?;
    Some(f64::from_ne_bytes(time.bytes.as_slice().try_into().unwrap()))
}

/// Kills a run of a scene up to `kills` times, each after at most `longest` milliseconds, and lets it go on to its end. Returns how often it was alive to be killed.
///
/// With an interval that has always passed there is a checkpoint before every step, each before anything is written of its state: none of
/// what has been written may be beyond it, and most kills hit a program that is writing one.
fn killed(name: &str, end: &str, kills: usize, longest: u64) -> usize {
    let scene = reservoirs(end);
    let one = whole(&format!("{name}-whole"), &scene);
    let dir = fresh("restart", name);
    let (mut random, mut kept, mut alive) = (7_u64, None, 0);
    for _ in 0..kills {
        let mut child = match kept {
            Some(_) => start(&["resume", dir.to_str().unwrap(), "--checkpoint", ALWAYS, "--threads", "2"]),
            None => begin(&scene, &dir, ALWAYS),
        };
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        std::thread::sleep(Duration::from_millis(longest / 10 + (random >> 33) % (longest * 9 / 10)));
        alive += usize::from(child.try_wait().unwrap().is_none());
        // SIGKILL; it may have come to its end before.
        let _ = child.kill();
        let said = words(&child.wait_with_output().unwrap().stderr);
        // That the gate is thin for so coarse a water is known.
        assert!(said.lines().all(|line| line.starts_with("warning: ")), "{said}");
        let time = kept_time(&dir);
        assert!(time >= kept, "a checkpoint of {kept:?} s was there, and now of {time:?}");
        kept = time;
        let table = std::fs::read_to_string(dir.join("probes.csv")).unwrap_or_default();
        let rows = table.split_inclusive('\n').skip(1).filter(|row| row.ends_with('\n'));
        if let Some(written) = rows.last().and_then(|row| row.split(',').next()) {
            let written: f64 = written.parse().unwrap();
            assert!(kept.unwrap() >= written, "{written} s had been written and {kept:?} s were kept");
        }
    }
    assert!(kept.unwrap() > 0.0, "it got somewhere between the kills");
    resumed(&dir, &[]);
    assert_same(&one, &dir);
    alive
}

#[test]
fn a_run_that_is_killed_at_any_moment_loses_an_interval_at_most() {
    killed("killed", "0.05", 8, 1000);
}

#[test]
#[ignore = "takes minutes"]
fn two_hundred_kills_lose_nothing() {
    // Long enough for a machine that has nothing else to do.
    let alive = killed("killed-often", "2.0", 250, 400);
    assert!(alive >= 200, "killed {alive} times");
}

#[test]
fn a_run_goes_on_beyond_its_end() {
    let one = whole("longer-whole", &reservoirs("0.02"));
    let dir = whole("longer", &reservoirs("0.0123"));
    resumed(&dir, &["--end-time", "0.02"]);
    assert_same(&one, &dir);
}

/// The shell lets no file grow beyond 600 KiB: the film does not fit, the state does.
#[test]
fn a_run_whose_output_fails_is_kept_as_it_was_before() {
    let scene = reservoirs("0.02");
    let one = whole("full-whole", &scene);
    let dir = fresh("restart", "full");
    let script = "trap '' XFSZ; ulimit -f 600; exec \"$0\" run \"$1\" --out \"$2\" --quiet --threads 1";
    let output = Command::new("bash").args(["-c", script, MPS]).arg(&scene).arg(&dir).output().unwrap();
    let said = words(&output.stderr);
    assert!(!output.status.success() && said.contains("film.png"), "{said}");
    assert!(said.contains("The last good checkpoint, of t = ") && last(&dir).exists(), "{said}");
    resumed(&dir, &[]);
    assert_same(&one, &dir);
}

#[test]
fn what_cannot_be_gone_on_from_is_refused_with_the_reason() {
    let refused = |dir: &Path, reason: &str| {
        let output = go_on(dir, &[]);
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains(reason), "{reason}: {said}");
    };
    let nothing = fresh("restart", "nothing");
    refused(&nothing, "there is no checkpoint in");
    let dir = whole("refused", &reservoirs("0.004"));
    let path = dir.join("scene.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("density = 1100", "density = 1101")).unwrap();
    refused(&dir, "belongs to another scene");
    // Its form does not matter.
    std::fs::write(&path, format!("# a comment\n{text}")).unwrap();
    resumed(&dir, &[]);
    let table = dir.join("probes.csv");
    let rows = std::fs::read_to_string(&table).unwrap();
    std::fs::write(&table, rows.lines().take(3).collect::<Vec<_>>().join("\n")).unwrap();
    refused(&dir, "the checkpoint is of a run with");
    std::fs::write(&table, rows).unwrap();
    for file in [last(&dir), dir.join("checkpoint").join("before.mps")] {
        let mut bytes = std::fs::read(&file).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(&file, bytes).unwrap();
    }
    refused(&dir, "no checkpoint can be used");
    refused(&dir, "does not have its checksum");
}

/// A damaged last checkpoint: the one before does, and costs an interval only.
#[test]
fn the_one_before_is_used_where_the_last_is_damaged() {
    let scene = reservoirs("0.02");
    let one = whole("before-whole", &scene);
    let dir = fresh("restart", "before");
    let mut child = begin(&scene, &dir, ALWAYS);
    wait_until(|| on_its_way(&dir), &mut child);
    signal(&child, "-TERM");
    assert!(!child.wait().unwrap().success(), "it had ended before");
    let bytes = std::fs::read(last(&dir)).unwrap();
    std::fs::write(last(&dir), &bytes[..bytes.len() / 3]).unwrap();
    resumed(&dir, &[]);
    assert_same(&one, &dir);
}
