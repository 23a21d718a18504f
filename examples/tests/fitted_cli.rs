//! Scenes whose bodies and water follow curved and inclined surfaces.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{execute, fresh, results, words};
use mps_io::CsvTable;
use std::path::Path;
use std::process::{Command, Output};

const MPS: &str = env!("CARGO_BIN_EXE_mps");
const BLOCK: &str = include_str!("../scenes/sunken-block.toml");
const FITTED: &str = "packing = \"fitted\"\n";

/// A scene as a file in a directory of its own.
fn file(name: &str, text: &str) -> std::path::PathBuf {
    let dir = fresh("fitted", name);
    std::fs::create_dir_all(&dir).unwrap();
    let file = dir.join("scene.toml");
    std::fs::write(&file, text).unwrap();
    file
}

fn check(name: &str, text: &str) -> Output {
    let file = file(name, text);
    Command::new(MPS).args(["check", "scene.toml"]).current_dir(file.parent().unwrap()).output().unwrap()
}

fn refused(name: &str, text: &str) -> String {
    let output = check(name, text);
    assert!(!output.status.success(), "{}", words(&output.stdout));
    words(&output.stderr)
}

/// Mean load over the second half of a run, over the weight of the water that the block displaces: across and upwards.
fn load(name: &str, text: &str, end: &str) -> [f64; 2] {
    let (table, _) = results(MPS, name, &["run", file(name, text).to_str().unwrap(), "--end-time", end]);
    ["x", "y"].map(|axis| {
        let column = table.column(&format!("load {axis} [N/m]")).unwrap();
        let half = &column[column.len() / 2..];
        half.iter().sum::<f64>() / half.len() as f64 / (9.81 * 1000.0 * 0.005)
    })
}

#[test]
fn a_sunken_block_weighs_as_much_less_as_archimedes_says() {
    let coarse = BLOCK.replace("spacing = 5e-3", "spacing = 1e-2");
    let [across, up] = load("fitted block", &coarse, "1");
    let [_, up_lattice] = load("block of a lattice", &coarse.replace(FITTED, ""), "1");
    assert!((up - 1.0).abs() < 0.02 && across.abs() < 0.01, "{across} {up}");
    assert!((up - 1.0).abs() < (up_lattice - 1.0).abs(), "{up} {up_lattice}");
}

/// A rubber disc that is held in its middle, beside water that rests: clamps and probes find their particles, and a run that
/// was stopped goes on with the same bits.
#[test]
fn an_elastic_disc_is_held_measured_and_resumed() {
    let disc = "{ circle = { center = [0.15, 0.1], radius = 0.04 } }";
    let scene = format!(
        "title = \"A disc in water\"\nend_time = 0.02\ngravity = [0.0, -9.81]\n\
         [fluid]\nspacing = 1e-2\nexpected_speed = 2.0\n\
         [[fluid.bodies]]\npacking = \"fitted\"\nregion = {{ difference = [{{ box = {{ lower = [0.0, 0.0], upper = [0.3, 0.2] }} }}, {disc}] }}\n\
         [[walls]]\nname = \"tank\"\nshape = {{ tank = {{ lower = [0.0, 0.0], upper = [0.3, 0.25], open = [\"top\"] }} }}\n\
         [[solids]]\nname = \"disc\"\npacking = \"fitted\"\nregion = {disc}\nspacing = 5e-3\ndensity = 3000\n\
         material = {{ neo_hookean = {{ youngs_modulus = 2e6, poissons_ratio = 0.4 }} }}\n\
         clamp = {{ region = {{ circle = {{ center = [0.15, 0.1], radius = 0.01 }} }} }}\n\
         [[probes]]\nname = \"top\"\nmeasure = {{ displacement = {{ solid = \"disc\", at = [0.15, 0.14] }} }}\n\
         [output]\nprobe_interval = 1e-3\npicture_interval = 0\n"
    );
    let path = file("disc", &scene);
    let path = path.to_str().unwrap();
    let run = |name: &str, arguments: &[&str]| {
        let dir = fresh("fitted", name);
        let quiet = ["--no-fields", "--quiet", "--threads", "1"];
        let output = execute(MPS, &dir, &[&["run", path], arguments, &quiet].concat());
        assert!(output.status.success(), "{}", words(&output.stderr));
        dir
    };
    let whole = run("whole", &[]);
    let parts = run("parts", &["--end-time", "0.008"]);
    let arguments = ["resume", parts.to_str().unwrap(), "--end-time", "0.02", "--threads", "2", "--quiet"];
    let output = Command::new(MPS).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", words(&output.stderr));
    let table = |dir: &Path| CsvTable::read(dir.join("probes.csv")).unwrap();
    let (whole, parts) = (table(&whole), table(&parts));
    assert_eq!(whole.columns, parts.columns);
    let top = whole.column("top y [m]").unwrap();
    assert!(top.iter().all(|y| y.abs() < 1e-4) && top.last().unwrap() != &0.0, "{top:?}");
}

/// Deflection of the end of a plate that is held on 10 mm, under a weight across it, after it has come to rest; the plate rises by `angle`.
fn deflection(name: &str, angle: f64, packing: &str) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let turned = |x: f64, y: f64| [0.3 + cosine * x - sine * y, 0.3 + sine * x + cosine * y];
    let corners = |x: [f64; 2], y: [f64; 2]| {
        [turned(x[0], y[0]), turned(x[1], y[0]), turned(x[1], y[1]), turned(x[0], y[1])]
    };
    let scene = format!(
        "title = \"A plate\"\nend_time = 3.0\ngravity = {:?}\n\
         [[solids]]\nname = \"plate\"\n{packing}region = {{ polygon = {:?} }}\nspacing = 5e-3\ndensity = 1000\ndamping = 6.0\n\
         material = {{ saint_venant = {{ youngs_modulus = 2e6, poissons_ratio = 0.4 }} }}\n\
         clamp = {{ region = {{ polygon = {:?} }} }}\n\
         [[probes]]\nname = \"end\"\nmeasure = {{ displacement = {{ solid = \"plate\", at = {:?} }} }}\n\
         [output]\nprobe_interval = 0.02\n",
        [0.4905 * sine, -0.4905 * cosine],
        corners([0.0, 0.2], [0.0, 0.02]),
        corners([-1e-3, 0.01], [-1e-3, 0.021]),
        turned(0.2, 0.01),
    );
    let (table, _) = results(MPS, name, &["run", file(name, &scene).to_str().unwrap()]);
    let end = |axis: &str| *table.column(&format!("end {axis} [m]")).unwrap().last().unwrap();
    end("x").hypot(end("y"))
}

/// Four particles across. The staircase of a lattice is thinner, and bends more than twice as far.
#[test]
fn an_inclined_plate_bends_as_a_level_one() {
    let level = deflection("level plate", 0.0, "");
    let angle = 30.0_f64.to_radians();
    let fitted = deflection("inclined plate", angle, FITTED) / level;
    let staircase = deflection("inclined plate of a lattice", angle, "") / level;
    assert!((fitted - 1.0).abs() < 0.05 && staircase > 1.5, "{fitted} {staircase}");
}

#[test]
fn what_overlaps_is_still_told() {
    let without_hole = BLOCK.replace(
        "    { polygon = [[0.114, 0.05], [0.21, 0.078], [0.196, 0.126], [0.1, 0.098]] },\n",
        "    { box = { lower = [0.0, 0.0], upper = [0.01, 0.01] } },\n",
    );
    assert_ne!(without_hole, BLOCK);
    assert!(
        refused("no hole", &without_hole).contains("fluid.bodies[0].region overlaps block (fixed[0].region)")
    );
    // Water of a lattice is too near to a surface that follows none.
    let lattice = BLOCK.replacen(FITTED, "", 1);
    let said = refused("water of a lattice", &lattice);
    assert!(
        said.contains("overlaps block") && said.contains("give this fluid packing = \"fitted\" too"),
        "{said}"
    );
}

#[test]
fn wrong_use_is_refused_with_a_remedy() {
    let said = refused("misspelled", &BLOCK.replacen("\"fitted\"", "\"fited\"", 1));
    assert!(said.contains("did you mean `fitted`?"), "{said}");
    let said =
        refused("thin", &BLOCK.replace("[0.196, 0.126], [0.1, 0.098]", "[0.2096, 0.0795], [0.1136, 0.0515]"));
    assert!(said.contains("fixed[0].packing cannot be \"fitted\": the shape is too thin near ("), "{said}");
    let said = refused("coarse", &BLOCK.replace("name = \"block\"", "name = \"block\"\nspacing = 1e-2"));
    assert!(said.contains("fixed[0].spacing is 2.00 spacings of the fluid: give at most 5e-3"), "{said}");
    let plate = "title = \"A plate\"\nend_time = 0.1\n[[solids]]\nname = \"plate\"\npacking = \"fitted\"\n\
                 region = { box = { lower = [0.0, 0.0], upper = [0.2, 0.02] } }\nspacing = 5e-3\ndensity = 1000\n\
                 material = { neo_hookean = { youngs_modulus = 2e6, poissons_ratio = 0.4 } }\nclamp = { sides = [\"left\"] }\n";
    let said = refused("sides", plate);
    assert!(
        said.contains("solids[0].packing is \"fitted\", but the clamp holds rows of a lattice: "),
        "{said}"
    );
}

#[test]
fn bodies_in_space_are_fitted_too() {
    let ball = "{ ball = { center = [0.1, 0.06, 0.1], radius = 0.04 } }";
    let scene = format!(
        "dimension = 3\ntitle = \"A ball in water\"\nend_time = 0.01\ngravity = [0.0, -9.81, 0.0]\n\
         [fluid]\nspacing = 2e-2\nexpected_speed = 1.5\n\
         [[fluid.bodies]]\npacking = \"fitted\"\nregion = {{ difference = [{{ box = {{ lower = [0.0, 0.0, 0.0], upper = [0.2, 0.12, 0.2] }} }}, {ball}] }}\n\
         [[walls]]\nname = \"tank\"\nshape = {{ tank = {{ lower = [0.0, 0.0, 0.0], upper = [0.2, 0.16, 0.2], open = [\"top\"] }} }}\n\
         [[fixed]]\nname = \"ball\"\npacking = \"fitted\"\nregion = {ball}\nspacing = 1e-2\n"
    );
    let output = check("ball", &scene);
    assert!(output.status.success() && output.stderr.is_empty(), "{}", words(&output.stderr));
}
