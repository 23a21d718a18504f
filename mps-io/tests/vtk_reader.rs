//! Files of fields are read back by VTK's own reader: `MPS_PYTHON` is a Python that has it (`pip install vtk`).
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::directory;
use mps_io::{FieldFormat, FieldOptions, FieldWriter, PointCloud};
use mps_kernel::{Real, Vector};
use std::path::Path;
use std::process::Command;

/// What VTK finds in a file: time, numbers of points and vertices, and each array with its bytes.
fn read(file: &Path) -> serde_json::Value {
    let python = std::env::var("MPS_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join("vtk_reader.py");
    let output = Command::new(python).arg(script).arg(file).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// An array as the script prints it: type, components, and its bytes.
fn array(kind: &str, components: usize, bytes: impl IntoIterator<Item = u8>) -> serde_json::Value {
    let hex: String = bytes.into_iter().map(|byte| format!("{byte:02x}")).collect();
    serde_json::json!({ "type": kind, "components": components, "bytes": hex })
}

fn comes_back<T: Real, const D: usize>(
    name: &str,
    format: FieldFormat,
    compress: bool,
    single_precision: bool,
) {
    const N: usize = 300;
    let place = |k: usize| Vector::from_fn(|axis, _| T::of([k as f64 / 7.0, -0.5, (k as f64).cos()][axis]));
    let at: Vec<Vector<T, D>> = (0..N).map(place).collect();
    let pressure: Vec<T> = (0..N).map(|k| T::of((k as f64).sqrt())).collect();
    let id: Vec<u32> = (0..N as u32).rev().collect();
    // Every other particle from the end.
    let chosen: Vec<u32> = (0..N as u32).rev().step_by(2).collect();
    let options = FieldOptions { compress, single_precision, format };
    let mut writer = FieldWriter::new(directory(&format!("reader-{name}")), "fluid", options).unwrap();
    let single = single_precision || size_of::<T>() == 4;
    let kind = if single { "float" } else { "double" };
    let bytes = |x: T| {
        if single {
            (x.to_double() as f32).to_le_bytes().to_vec()
        } else {
            x.to_double().to_le_bytes().to_vec()
        }
    };

    let all: Vec<u32> = (0..N as u32).collect();
    for taken in [None, Some(&chosen)] {
        let rows = taken.unwrap_or(&all);
        let cloud = PointCloud::new(&at)
            .vector("velocity", &at)
            .scalar("pressure", &pressure)
            .integer("id", &id)
            .only(taken.map(Vec::as_slice));
        let found = read(&writer.write(0.375, &cloud).unwrap());
        assert_eq!(found["time"], 0.375);
        assert_eq!([&found["points"], &found["vertices"]], [rows.len(), rows.len()]);
        let each = rows.iter().map(|k| *k as usize);
        let padded = |k: usize| [0, 1, 2].map(|axis| at[k].get(axis).copied().unwrap_or(T::zero()));
        let places: Vec<u8> = each.clone().flat_map(padded).flat_map(bytes).collect();
        assert_eq!(found["arrays"]["Points"], array(kind, 3, places.clone()));
        assert_eq!(found["arrays"]["velocity"], array(kind, 3, places));
        assert_eq!(
            found["arrays"]["pressure"],
            array(kind, 1, each.clone().flat_map(|k| bytes(pressure[k])))
        );
        let numbers = each.flat_map(|k| id[k].to_le_bytes());
        assert_eq!(found["arrays"]["id"], array("unsigned int", 1, numbers));
    }
}

#[test]
#[ignore = "needs a Python with vtk, named by MPS_PYTHON"]
fn what_is_written_comes_back_bit_for_bit() {
    for (form, format) in [("vtu", FieldFormat::Vtu), ("vtp", FieldFormat::Vtp), ("hdf", FieldFormat::VtkHdf)]
    {
        comes_back::<f64, 2>(&format!("{form}-f64"), format, true, false);
        comes_back::<f64, 2>(&format!("{form}-f64-raw"), format, false, false);
        comes_back::<f64, 3>(&format!("{form}-f64-3d"), format, true, false);
        comes_back::<f64, 2>(&format!("{form}-single"), format, true, true);
        comes_back::<f64, 3>(&format!("{form}-single-3d"), format, true, true);
        comes_back::<f32, 2>(&format!("{form}-f32"), format, true, false);
    }
}
