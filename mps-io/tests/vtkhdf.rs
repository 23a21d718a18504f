//! VTKHDF files have the layout of the VTK documentation, and every number in its bits. That VTK's own reader agrees is tested in
//! `vtk_reader.rs`, where there is one.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{directory, listing};
use hdf5_pure::File;
use mps_io::{FieldFormat, FieldOptions, FieldWriter, OutputError, PointCloud};
use mps_kernel::{Tensor, Vector};

const HDF: FieldOptions =
    FieldOptions { compress: true, single_precision: false, format: FieldFormat::VtkHdf };

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn every_number_is_where_the_layout_says_with_its_bits() {
    for (name, n, compress) in
        [("none", 0_usize, true), ("few", 5, true), ("raw", 9, false), ("many", 70_000, true)]
    {
        let dir = directory(&format!("hdf-{name}"));
        let at: Vec<Vector<f64, 2>> = (0..n).map(|k| Vector::from([k as f64 / 7.0, -1e-300])).collect();
        let pressure: Vec<f64> =
            (0..n).map(|k| if k == 3 { f64::INFINITY } else { (k as f64).sqrt() }).collect();
        let stress: Vec<Tensor<f64, 2>> = (0..n).map(|k| Tensor::repeat(k as f64)).collect();
        let id: Vec<u32> = (0..n as u32).map(|k| u32::MAX - k).collect();
        let cloud = PointCloud::new(&at)
            .vector("velocity", &at)
            .scalar("pressure", &pressure)
            .tensor("stress", &stress)
            .integer("id", &id);
        let mut writer = FieldWriter::new(&dir, "fluid", FieldOptions { compress, ..HDF }).unwrap();
        let path = writer.write(0.125, &cloud).unwrap();
        assert_eq!(path, dir.join("fluid_00000.vtkhdf"));

        let file = File::open(&path).unwrap();
        let root = file.group("VTKHDF").unwrap().attrs().unwrap();
        assert_eq!(root["Version"].to_i64s().unwrap(), [2, 0]);
        assert_eq!(root["Type"].as_str().unwrap(), "UnstructuredGrid");
        let set = |name: &str| file.dataset(&format!("VTKHDF/{name}")).unwrap();
        for number in ["NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"] {
            assert_eq!(set(number).read::<i64>().unwrap(), [n as i64]);
        }
        assert!(set("Connectivity").read::<i64>().unwrap().into_iter().eq(0..n as i64));
        assert!(set("Offsets").read::<i64>().unwrap().into_iter().eq(0..=n as i64));
        assert_eq!(set("Types").read::<u8>().unwrap(), vec![1; n]);
        let padded: Vec<f64> = at.iter().flat_map(|r| [r[0], r[1], 0.0]).collect();
        for vectors in ["Points", "PointData/velocity"] {
            assert_eq!(set(vectors).shape().unwrap(), [n as u64, 3]);
            assert_eq!(bits(&set(vectors).read_f64().unwrap()), bits(&padded));
        }
        assert_eq!(bits(&set("PointData/pressure").read_f64().unwrap()), bits(&pressure));
        assert_eq!(set("PointData/stress").shape().unwrap(), [n as u64, 9]);
        assert_eq!(set("PointData/id").read::<u32>().unwrap(), id);
        assert_eq!(set("FieldData/TimeValue").read_f64().unwrap(), [0.125]);
    }
}

#[test]
fn the_series_lists_every_frame() {
    let dir = directory("hdf-series");
    let at = [Vector::<f64, 3>::new(1.0, 2.0, 3.0)];
    let mut writer = FieldWriter::new(&dir, "fluid", HDF).unwrap();
    for time in [0.0, 1.0 / 3.0, 1e-7] {
        writer.write(time, &PointCloud::new(&at)).unwrap();
    }
    let text = std::fs::read_to_string(writer.collection()).unwrap();
    let series: serde_json::Value = serde_json::from_str(&text).unwrap();
    let times: Vec<f64> =
        series["files"].as_array().unwrap().iter().map(|file| file["time"].as_f64().unwrap()).collect();
    assert_eq!(times, [0.0, 1.0 / 3.0, 1e-7]);
    assert_eq!(series["files"][2]["name"], "fluid_00002.vtkhdf");
    let files = ["fluid.vtkhdf.series", "fluid_00000.vtkhdf", "fluid_00001.vtkhdf", "fluid_00002.vtkhdf"];
    assert_eq!(listing(&dir), files);
}

#[test]
fn what_hdf5_cannot_name_is_refused() {
    let at = [Vector::<f64, 2>::new(1.0, 2.0)];
    let mut writer = FieldWriter::new(directory("hdf-name"), "fluid", HDF).unwrap();
    let error = writer.write(0.0, &PointCloud::new(&at).scalar("velocity [m/s]", &[1.0])).unwrap_err();
    assert!(matches!(error, OutputError::Name { .. }), "{error}");
}
