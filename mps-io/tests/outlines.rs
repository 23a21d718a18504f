//! Shapes from files of their own: read with their scene, refused with their place, and copied with it.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_io::scene_file::{Region, SceneFile, read};
use std::path::{Path, PathBuf};

const WEDGE: &str = "# a wedge, in millimetres\n100 0\n200 0\n200 50\n";
const SCENE: &str = r#"title = "A wedge"
end_time = 1.0

[[solids]]
name = "wedge"
region = { outline = { file = "shapes/wedge.txt", scale = 1e-3, translate = [0.5, 0.1] } }
spacing = 1e-2
density = 1100
material = { neo_hookean = { youngs_modulus = 1e7, poissons_ratio = 0.4 } }
"#;

/// A directory with a scene and a file.
fn written(name: &str, scene: &str, file: &str, content: &[u8]) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("outlines").join(name);
    let _ = std::fs::remove_dir_all(&dir);
    std::fs::create_dir_all(dir.join("shapes")).unwrap();
    std::fs::write(dir.join(file), content).unwrap();
    std::fs::write(dir.join("scene.toml"), scene).unwrap();
    dir
}

fn wedge(name: &str, content: &str) -> PathBuf {
    written(name, SCENE, "shapes/wedge.txt", content.as_bytes())
}

fn said(dir: &Path) -> String {
    let said = read(dir.join("scene.toml")).unwrap_err().to_string();
    said.replace(&format!("{}/", dir.display()), "")
}

fn region(scene: &SceneFile) -> &Region {
    &scene.solids[0].region
}

#[test]
fn a_line_from_a_file_is_the_polygon_with_its_corners() {
    let (scene, _) = read(wedge("line", WEDGE).join("scene.toml")).unwrap();
    let polygon = Region::Polygon([[0.6, 0.1], [0.7, 0.1], [0.7, 0.15]].map(Vec::from).to_vec());
    let [mine, theirs] = [region(&scene), &polygon].map(|region| region.bounds().unwrap());
    let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(near(&mine.lower, &theirs.lower) && near(&mine.upper, &theirs.upper), "{mine:?}");
    for k in 0..900 {
        let point = [0.55 + 0.007 * f64::from(k % 30), 0.08 + 0.003 * f64::from(k / 30)];
        assert_eq!(region(&scene).contains(&point, 1e-9), polygon.contains(&point, 1e-9), "{point:?}");
    }
}

#[test]
fn a_scene_takes_its_files_along_and_knows_them_again() {
    let dir = wedge("along", WEDGE);
    let (scene, _) = read(dir.join("scene.toml")).unwrap();
    let copy = dir.join("run");
    let there = scene.write_to(&copy).unwrap();
    let (again, _) = read(copy.join("scene.toml")).unwrap();
    assert_eq!(again, there);
    // From there it goes along once more, under the same name.
    let second = again.write_to(&copy.join("post-mortem")).unwrap();
    assert_eq!(second, there);
    let Region::Outline(outline) = region(&there) else { unreachable!() };
    let file = copy.join(&outline.file);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), WEDGE);
    std::fs::write(file, WEDGE.replace("50", "60")).unwrap();
    let said = said(&copy);
    assert!(said.contains("solids[0].region.outline.file") && said.contains("has the checksum "), "{said}");
    assert!(said.ends_with("bring that file back, or leave the checksum out and begin a new run"), "{said}");
}

#[test]
fn a_file_that_is_no_line_is_refused_with_the_place_in_the_scene_and_in_the_file() {
    let at = "scene.toml:6:31: solids[0].region.outline.file \"shapes/wedge.txt\"";
    for (name, content, message) in [
        (
            "word",
            "0 0\n1 0\n1 one\n",
            "has \"1 one\" in line 3: give x and y of a corner in every line of text",
        ),
        ("short", "0 0\n1 0\n", "has 2 corners: give at least 3"),
        (
            "crossing",
            "0 0\n1 1\n1 0\n0 1\n",
            "crosses itself: the side that begins in line 1 meets the one of line 3",
        ),
    ] {
        let said = said(&wedge(name, content));
        assert!(said.starts_with(&format!("{at} {message}")), "{name}: {said}");
    }
    let dir = wedge("missing", WEDGE);
    std::fs::remove_file(dir.join("shapes/wedge.txt")).unwrap();
    let said = said(&dir);
    assert!(said.starts_with(&format!("{at} cannot be read as shapes/wedge.txt: ")), "{said}");
    assert!(said.ends_with(": give the path from the directory of the scene"), "{said}");
}

#[test]
fn numbers_of_an_outline_are_checked_as_all_others() {
    for (name, from, to, message) in [
        (
            "scale",
            "1e-3",
            "0.0",
            "scene.toml:6:59: solids[0].region.outline.scale is 0: give a factor above zero",
        ),
        (
            "shift",
            "[0.5, 0.1]",
            "[0.5]",
            "scene.toml:6:77: solids[0].region.outline.translate has 1 of 2 numbers",
        ),
        (
            "key",
            "scale",
            "scales",
            "scales is no key here in solids[0].region.outline: did you mean `scale`?",
        ),
    ] {
        let dir = written(name, &SCENE.replace(from, to), "shapes/wedge.txt", WEDGE.as_bytes());
        let said = said(&dir);
        assert!(said.contains(message), "{name}: {said}");
    }
}

/// A box from the origin as STL, each side of two triangles.
fn brick([a, b, c]: [f64; 3]) -> String {
    let mut text = "solid brick\n".to_owned();
    let corner =
        |k: usize| [a * f64::from(k as u8 & 1), b * f64::from(k as u8 >> 1 & 1), c * f64::from(k as u8 >> 2)];
    for [p, q, r, s] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
        for triangle in [[p, q, r], [p, r, s]] {
            text += " facet normal 0 0 0\n  outer loop\n";
            for [x, y, z] in triangle.map(corner) {
                text += &format!("   vertex {x} {y} {z}\n");
            }
            text += "  endloop\n endfacet\n";
        }
    }
    text + "endsolid brick\n"
}

#[test]
fn a_surface_from_a_file_is_the_box_that_it_encloses() {
    let scene = SCENE.replace("end_time", "dimension = 3\nend_time").replace("[0.5, 0.1]", "[0.5, 0.1, 0.0]");
    let name = |file: &str| scene.replace("shapes/wedge.txt", file);
    let brick = brick([200.0, 100.0, 40.0]);
    let dir = written("brick", &name("brick.stl"), "brick.stl", brick.as_bytes());
    let (read, _) = read(dir.join("scene.toml")).unwrap();
    let whole = Region::between([0.5, 0.1, 0.0], [0.7, 0.2, 0.04]);
    for k in 0..20_u32.pow(3) {
        // Some of the points are on the surface.
        let [i, j, l] = [k % 20, k / 20 % 20, k / 400].map(f64::from);
        let point = [0.47 + 0.015 * i, 0.08 + 0.01 * j, -0.01 + 0.005 * l];
        assert_eq!(region(&read).contains(&point, 1e-6), whole.contains(&point, 1e-6), "{point:?}");
    }

    let at = "scene.toml:7:31: solids[0].region.outline.file \"leaky.stl\"";
    let hole = brick.replacen(" facet", " no", 1).replacen(
        "   vertex 0 0 0\n   vertex 0 100 0\n   vertex 200 100 0\n  endloop\n",
        "",
        1,
    );
    let turned =
        brick.replacen("   vertex 0 0 0\n   vertex 0 100 0\n", "   vertex 0 100 0\n   vertex 0 0 0\n", 1);
    for (content, message) in [
        (hole, "is not closed: there is a hole along the edge from (0.5000, 0.1000, 0.0000) to "),
        (turned, "has triangles that face different ways: on both sides of the edge "),
        ("100 0\n200 0\n".to_owned(), "is no STL: give an STL surface"),
    ] {
        let said = said(&written("leaky", &name("leaky.stl"), "leaky.stl", content.as_bytes()));
        assert!(said.starts_with(&format!("{at} {message}")), "{said}");
    }
}
