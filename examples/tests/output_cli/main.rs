//! What a run writes is what its scene chooses; it ends when a file asks it to; its log has levels.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

#[path = "../common/mod.rs"]
mod common;
mod leftovers;
mod stopped;

use common::{execute, fresh, words};
use mps_io::{CsvTable, Summary, find_table};
use std::path::{Path, PathBuf};
use std::process::Command;

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const TANK: &str = include_str!("../../scenes/hydrostatic-tank.toml");

/// The tank with 20 x 10 particles and these lines under `[output]`, as a file.
fn tank(name: &str, output: &str) -> PathBuf {
    let dir = fresh("output-scenes", name);
    std::fs::create_dir_all(&dir).unwrap();
    let text = TANK.replace("spacing = 5e-3", "spacing = 1e-2");
    assert_ne!(text, TANK);
    std::fs::write(dir.join("scene.toml"), format!("{text}\n[output]\n{output}\n")).unwrap();
    dir.join("scene.toml")
}

/// Runs the tank for a twentieth of a second.
fn run(name: &str, output: &str, arguments: &[&str]) -> PathBuf {
    let (scene, dir) = (tank(name, output), fresh("output", name));
    let run = ["run", scene.to_str().unwrap(), "--end-time", "0.05", "--quiet", "--threads", "1"];
    let done = execute(MPS, &dir, &[&run, arguments].concat());
    assert!(done.status.success(), "{}", words(&done.stderr));
    dir
}

/// The XML of a frame, without its numbers.
fn xml(file: &Path) -> String {
    let bytes = std::fs::read(file).unwrap();
    let end = bytes.windows(13).position(|window| window == b"<AppendedData").unwrap();
    words(&bytes[..end])
}

#[test]
fn only_chosen_fields_of_chosen_particles_are_written() {
    let all = run("all", "", &[]);
    let frame = xml(&all.join("fields/water_00003.vtu"));
    for name in ["velocity", "pressure", "density ratio", "packing", "surface", "id"] {
        assert!(frame.contains(&format!("Name=\"{name}\"")), "{name}: {frame}");
    }
    assert!(frame.contains("NumberOfPoints=\"200\"") && frame.contains("type=\"Float32\" Name=\"Points\""));

    let lower = "field_region = { box = { lower = [-1.0, -1.0], upper = [1.0, 0.05] } }\n";
    let some =
        run("some", &format!("fields = [\"id\", \"pressure\"]\nfield_precision = \"f64\"\n{lower}"), &[]);
    let frame = xml(&some.join("fields/water_00003.vtu"));
    let named = frame.lines().filter(|line| line.contains("NumberOfComponents")).count();
    // With the points and the three arrays of the cells.
    assert_eq!(named, 6, "{frame}");
    assert!(frame.contains("type=\"Float64\" Name=\"pressure\"") && frame.contains("Name=\"id\""), "{frame}");
    let count = frame.split("NumberOfPoints=\"").nth(1).unwrap().split('"').next().unwrap();
    assert!(
        (90..=110).contains(&count.parse::<usize>().unwrap()),
        "{count} of 200 particles in the lower half"
    );
    // Looking does not change what is looked at.
    let [a, b] = [&all, &some].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert_eq!(a, b);

    let polygonal =
        run("polygonal", "fields = [\"pressure\"]\nfield_form = \"vtp\"\nfield_interval = 0.025", &[]);
    let frame = xml(&polygonal.join("fields/water_00002.vtp"));
    assert!(frame.contains("type=\"PolyData\"") && frame.contains("NumberOfVerts=\"200\""), "{frame}");

    let hdf = run("hdf", "fields = []\nfield_form = \"vtkhdf\"\nfield_interval = 0.025", &[]);
    let mut files: Vec<_> =
        std::fs::read_dir(hdf.join("fields")).unwrap().map(|file| file.unwrap().file_name()).collect();
    files.sort();
    let series = ["walls.vtkhdf.series", "walls_00000.vtkhdf", "water.vtkhdf.series"];
    let frames = ["water_00000.vtkhdf", "water_00001.vtkhdf", "water_00002.vtkhdf"];
    assert_eq!(files, [series, frames].concat());
}

#[test]
fn fields_nobody_knows_are_refused_with_the_one_that_was_meant() {
    let refused = |name: &str, output: &str, message: &str| {
        let done = Command::new(MPS).arg("check").arg(tank(name, output)).output().unwrap();
        let said = words(&done.stderr);
        assert!(!done.status.success() && said.contains(message), "{message}: {said}");
    };
    refused(
        "typed",
        "fields = [\"presure\"]",
        "presure is no choice here in output.fields[0]: did you mean `pressure`?",
    );
    refused(
        "absent",
        "fields = [\"pressure\", \"displacement\"]",
        "output.fields[1] is the displacement, which nothing in the scene has: leave it out",
    );
    refused("twice", "fields = [\"id\", \"id\"]", "output.fields[1] is the id again: name each field once");
    let thin = "field_region = { box = { lower = [0.0, 0.0], upper = [0.1, 0.0] } }";
    refused("thin", thin, "output.field_region.box has the thickness 0.000e0 m along y");
    refused(
        "form",
        "field_form = \"vtk\"",
        "vtk is no choice here in output.field_form: did you mean `vtu`?",
    );
}

/// A tank whose floor is a fixed body, with probes along a line and on the floor.
const FLOOR: &str = r#"
title = "Water on a plate"
end_time = 0.2
gravity = [0.0, -9.81]
[fluid]
spacing = 1e-2
expected_speed = 1.4
[[fluid.bodies]]
region = { box = { lower = [0.0, 0.0], upper = [0.2, 0.1] } }
[[walls]]
name = "left"
shape = { line = [[0.0, 0.15], [0.0, 0.0]] }
[[walls]]
name = "right"
shape = { line = [[0.2, 0.0], [0.2, 0.15]] }
[[fixed]]
name = "floor"
region = { box = { lower = [-0.04, -0.04], upper = [0.24, 0.0] } }
[[probes]]
name = "middle"
measure = { wall_pressure = { on = "floor", from = [0.05, 0.0], to = [0.15, 0.0] } }
[[probes]]
name = "load"
measure = { force = { on = ["floor"] } }
[[probes]]
name = "floor"
measure = { budget = { on = ["floor"] } }
[[probes]]
name = "depth"
measure = { line = { from = [0.1, 0.08], to = [0.1, 0.02], points = 3 } }
[[probes]]
name = "half"
measure = { pressure = { at = [0.1, 0.05] } }
[[probes]]
name = "flow"
measure = { line = { from = [0.1, 0.08], to = [0.1, 0.05], points = 2, of = "velocity" } }
[[probes]]
name = "point"
measure = { velocity = { at = [0.1, 0.05] } }
"#;

#[test]
fn probes_of_lines_walls_and_budgets_agree_with_the_ones_of_points_and_forces() {
    let dir = fresh("output", "floor");
    std::fs::create_dir_all(&dir).unwrap();
    let scene = dir.join("floor.toml");
    std::fs::write(&scene, FLOOR).unwrap();
    let run = ["run", scene.to_str().unwrap(), "--no-fields", "--quiet", "--threads", "1"];
    let done = execute(MPS, &dir, &run);
    assert!(done.status.success(), "{}", words(&done.stderr));
    let table = CsvTable::read(dir.join("probes.csv")).unwrap();
    let column = |name: &str| table.column(name).unwrap_or_else(|| panic!("{name}: {:?}", table.names));

    // A place of a line is what a probe of the place says.
    assert_eq!(column("depth 2 [Pa]"), column("half [Pa]"));
    assert_eq!(column("flow 2 y [m/s]"), column("point y [m/s]"));
    assert!(column("point y [m/s]").iter().any(|v| *v != 0.0));
    // At the start the pressure is that of rest.
    for (k, depth) in [(1, 0.02), (2, 0.05), (3, 0.08)] {
        let (p, exact) = (column(&format!("depth {k} [Pa]"))[0], 9810.0 * depth);
        assert!((p - exact).abs() < 0.02 * exact, "{p} Pa, {exact} Pa");
    }
    // The force is how fast the impulse grows.
    let (time, impulse, load) =
        (column("time [s]"), column("floor impulse y [N s/m]"), column("load y [N/m]"));
    for k in 1..time.len() {
        let rate = (impulse[k] - impulse[k - 1]) / (time[k] - time[k - 1]);
        assert!((rate - load[k]).abs() <= 1e-9 * load[k].abs(), "{rate} N/m and {} N/m", load[k]);
    }
    assert!(column("floor work [J/m]").iter().all(|work| *work == 0.0));
    // The load acts in the middle, whose arm is 0.1 m.
    let (moment, down) = (column("floor angular impulse [N s]"), impulse);
    assert!((moment.last().unwrap() / down.last().unwrap() - 0.1).abs() < 0.002);
    // The floor bears the weight of the water, 196.2 N/m, and as much on each part of it.
    let mean = |values: &[f64]| {
        values[values.len() / 2..].iter().sum::<f64>() / (values.len() - values.len() / 2) as f64
    };
    let (borne, pressure) = (-mean(load), mean(column("middle [Pa]")));
    assert!((borne - 196.2).abs() < 0.05 * 196.2, "{borne} N/m");
    assert!((pressure - 981.0).abs() < 0.1 * 981.0, "{pressure} Pa");
}

#[test]
fn a_binary_table_has_the_numbers_of_the_text() {
    let text = run("text", "", &["--no-fields"]);
    let binary = run("binary", "probe_form = \"npy\"", &["--no-fields"]);
    assert!(!binary.join("probes.csv").exists());
    let numbers = |dir: &Path| find_table(dir, "probes").unwrap().0;
    assert_eq!(numbers(&text), numbers(&binary));
    let plot = Command::new(MPS).arg("plot").arg(&binary).args(["--column", "level"]).output().unwrap();
    assert!(plot.status.success() && binary.join("columns.png").exists(), "{}", words(&plot.stderr));
    let longer = |dir: &Path| {
        let on = Command::new(MPS)
            .arg("resume")
            .arg(dir)
            .args(["--end-time", "0.08", "--quiet"])
            .output()
            .unwrap();
        assert!(on.status.success(), "{}", words(&on.stderr));
    };
    [&text, &binary].into_iter().for_each(|dir| longer(dir));
    assert_eq!(numbers(&text), numbers(&binary));
    assert!(numbers(&text).columns[0].last().unwrap() >= &0.08);
}

#[test]
fn a_run_does_not_replace_the_scene_that_somebody_wrote() {
    let scene = tank("own directory", "");
    let text = format!("# A remark.\n{}", std::fs::read_to_string(&scene).unwrap());
    std::fs::write(&scene, &text).unwrap();
    let run = ["run", scene.to_str().unwrap(), "--end-time", "0.01", "--quiet", "--no-fields"];
    let output = execute(MPS, scene.parent().unwrap(), &run);
    let said = words(&output.stderr);
    assert!(!output.status.success() && said.contains("would replace its scene"), "{said}");
    assert_eq!(std::fs::read_to_string(&scene).unwrap(), text);
    // Under another name it may stay there.
    let renamed = scene.with_file_name("tank.toml");
    std::fs::rename(&scene, &renamed).unwrap();
    let run = ["run", renamed.to_str().unwrap(), "--end-time", "0.01", "--quiet", "--no-fields"];
    assert!(execute(MPS, scene.parent().unwrap(), &run).status.success() && scene.exists());
    assert_eq!(std::fs::read_to_string(&renamed).unwrap(), text);
}

/// A probe that finds nothing is refused by `check` as by `run`, which touches nothing of the run before.
#[test]
fn a_run_that_cannot_begin_leaves_the_one_before_alone() {
    let scene =
        FLOOR.replace("from = [0.05, 0.0], to = [0.15, 0.0]", "from = [0.05, 0.05], to = [0.15, 0.05]");
    assert_ne!(scene, FLOOR);
    let dir = run("before", "", &["--no-fields"]);
    let file = dir.with_file_name("no point.toml");
    std::fs::write(&file, scene).unwrap();
    let file = file.to_str().unwrap();
    let check = Command::new(MPS).args(["check", file]).output().unwrap();
    let run = execute(MPS, &dir, &["run", file, "--quiet"]);
    for output in [check, run] {
        let said = words(&output.stderr);
        assert!(!output.status.success() && said.contains("has no point of its body behind it"), "{said}");
    }
    let resumed =
        Command::new(MPS).arg("resume").arg(&dir).args(["--end-time", "0.06", "--quiet"]).output().unwrap();
    assert!(resumed.status.success(), "{}", words(&resumed.stderr));
}

/// A run with fewer results leaves none of an earlier one to be taken for its own.
#[test]
fn results_of_an_earlier_run_are_removed() {
    let dir = run("again", "", &[]);
    let left = |dir: &Path| {
        let names = ["film.png", "fields/water.pvd", "picture_000000ms.png", "probe_level.png"];
        names.map(|name| dir.join(name).exists())
    };
    assert_eq!(left(&dir), [true; 4]);
    std::fs::write(dir.join("picture_of_mine.png"), "").unwrap();
    let scene = tank("again", "").with_file_name("fewer.toml");
    let text = std::fs::read_to_string(scene.with_file_name("scene.toml")).unwrap();
    std::fs::write(&scene, text.replace("name = \"level\"", "name = \"height\"")).unwrap();
    let run = ["run", scene.to_str().unwrap(), "--end-time", "0.01", "--quiet", "--no-fields"];
    assert!(execute(MPS, &dir, &run).status.success());
    assert_eq!(left(&dir), [false; 4]);
    assert!(dir.join("probe_height.png").exists() && dir.join("picture_of_mine.png").exists());
}

/// Each point behind a wall bears what a spacing of it does, so that there has to be one to every spacing.
#[test]
fn a_wall_whose_pressure_is_measured_has_a_point_to_every_spacing() {
    let ends = "from = [0.05, 0.0], to = [0.15, 0.0]";
    for (name, other, message) in [
        (
            "part",
            "from = [0.05, 0.0], to = [0.155, 0.0]",
            "wall_pressure.to is 10.50 spacings of the body from `from`",
        ),
        (
            "beyond",
            "from = [0.15, 0.0], to = [0.26, 0.0]",
            "has 9 points of its body at the surface for a length of 11 spacings",
        ),
        ("whole", "from = [0.05, 0.0], to = [0.16, 0.0]", ""),
    ] {
        let file = tank(name, "").with_file_name("floor.toml");
        std::fs::write(&file, FLOOR.replace(ends, other)).unwrap();
        let check = Command::new(MPS).arg("check").arg(&file).output().unwrap();
        let said = words(&check.stderr);
        assert!(check.status.success() == message.is_empty() && said.contains(message), "{name}: {said}");
    }
}

/// Walls that move have a frame with every one of the water, those that stand still have one.
#[test]
fn a_piston_moves_in_paraview() {
    const WAVES: &str = include_str!("../../scenes/wave-maker.toml");
    let scene = tank("piston", "").with_file_name("waves.toml");
    let coarse = WAVES.replace("spacing = 5e-3", "spacing = 1e-2").replace("[-0.02, 0.0]", "[-0.04, 0.0]");
    std::fs::write(
        &scene,
        format!("{coarse}\n[output]\nfield_interval = 0.05\npicture_interval = 0\nframe_interval = 0\n"),
    )
    .unwrap();
    let dir = fresh("output", "piston");
    let run = ["run", scene.to_str().unwrap(), "--end-time", "0.2", "--quiet"];
    let done = execute(MPS, &dir, &run);
    assert!(done.status.success(), "{}", words(&done.stderr));
    let frames = |name: &str| {
        let list = std::fs::read_to_string(dir.join(format!("fields/{name}.pvd"))).unwrap();
        list.matches("timestep=").count()
    };
    assert_eq!([frames("moving walls"), frames("walls")], [frames("water"), 1]);
    let frame = |k: usize| std::fs::read(dir.join(format!("fields/moving walls_{k:05}.vtu"))).unwrap();
    assert!(frames("water") >= 4 && frame(0) != frame(3));
}

/// Bodies alone are stepped from row to row: the last row is at the end, and every frame is there once, however times are rounded.
#[test]
fn bodies_alone_end_at_the_end_and_are_written_once() {
    let beam = include_str!("../../scenes/heavy-beam.toml");
    let file = tank("beam", "").with_file_name("beam.toml");
    std::fs::write(&file, format!("{beam}\n[output]\nframe_interval = 0\npicture_interval = 0\n")).unwrap();
    let dir = fresh("output", "beam");
    let run = ["run", file.to_str().unwrap(), "--end-time", "0.1", "--quiet"];
    let done = execute(MPS, &dir, &run);
    assert!(done.status.success(), "{}", words(&done.stderr));
    let time = CsvTable::read(dir.join("probes.csv")).unwrap().columns[0].clone();
    assert!(time.len() == 801 && (time[800] / 0.1 - 1.0).abs() < 1e-12, "{} rows", time.len());
    let list = std::fs::read_to_string(dir.join("fields/solid beam.pvd")).unwrap();
    assert_eq!(list.matches("timestep=").count(), 41);
}

#[test]
fn the_log_has_what_its_level_asks_for() {
    let log = |name: &str, level: &[&str]| {
        let dir = run(name, "", &[level, &["--no-fields"]].concat());
        let steps = Summary::read(dir.join("summary.json")).unwrap().steps as usize;
        (std::fs::read_to_string(dir.join("run.log")).unwrap_or_default(), steps)
    };
    let lines = |text: &str, level: &str| text.lines().filter(|line| line.contains(level)).count();
    let (info, _) = log("info", &[]);
    assert!(info.contains("begins") && info.contains("completed") && info.contains("percent=50"), "{info}");
    assert_eq!([lines(&info, " DEBUG "), lines(&info, " TRACE ")], [0, 0]);
    let (trace, steps) = log("trace", &["--log", "trace"]);
    assert_eq!(lines(&trace, " TRACE "), steps);
    assert!(lines(&trace, " DEBUG ") > 50 && lines(&trace, " INFO ") == lines(&info, " INFO "));
    assert_eq!(log("off", &["--log", "off"]).0, "");
}
