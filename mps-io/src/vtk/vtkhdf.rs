//! VTKHDF: an unstructured grid in an HDF5 file, which every HDF5 library reads as well.
//!
//! Layout ("VTKHDF File Format" of the VTK documentation, version 2): group `VTKHDF` with the attributes `Version` and `Type`, the
//! numbers of points, cells and connectivity of its one piece, the grid itself, and the fields under `PointData`.

use std::io::Write as _;
use std::path::Path;

use hdf5_pure::{
    AttrValue, DatasetBuilder, FileBuilder, GroupBuilder, make_f32_type, make_f64_type, make_u32_type,
};

use super::encode::{Array, Frame, Kind};
use super::form::{Form, VERTEX};
use crate::OutputError;
use crate::directory::write_atomically;

/// Version of the layout; 2.0 is read by VTK 9.3 and later.
const VERSION: [i64; 2] = [2, 0];
/// Particles in a chunk, the piece of an array that is compressed by itself.
const CHUNK: u64 = 1 << 16;
/// Level of the compression: the fastest, as in the XML form.
const LEVEL: u32 = 1;

/// Writes `.vtkhdf` and the `.vtkhdf.series` that lists them for ParaView.
pub(super) struct VtkHdf {
    compress: bool,
}

impl VtkHdf {
    pub(super) fn new(compress: bool) -> Self {
        Self { compress }
    }

    /// The file in memory.
    fn bytes(&self, time: f64, frame: &Frame) -> Result<Vec<u8>, hdf5_pure::Error> {
        let mut file = FileBuilder::new();
        let mut root = file.create_group("VTKHDF");
        root.set_attr("Version", AttrValue::I64Array(VERSION.to_vec()));
        // The reader takes no other kind of text.
        root.set_attr("Type", AttrValue::AsciiString("UnstructuredGrid".to_owned()));
        let n = frame.len as i64;
        for number in ["NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"] {
            root.create_dataset(number).with_i64_data(&[n]);
        }
        self.array(&mut root, frame.len, &frame.points);
        self.packed(
            root.create_dataset("Connectivity").with_i64_data(&(0..n).collect::<Vec<_>>()),
            &[n as u64],
        );
        let offsets: Vec<i64> = (0..=n).collect();
        self.packed(root.create_dataset("Offsets").with_i64_data(&offsets), &[n as u64 + 1]);
        self.packed(root.create_dataset("Types").with_u8_data(&vec![VERTEX; frame.len]), &[n as u64]);
        let mut fields = root.create_group("PointData");
        frame.fields.iter().for_each(|field| self.array(&mut fields, frame.len, field));
        root.add_group(fields.finish());
        let mut moment = root.create_group("FieldData");
        moment.create_dataset("TimeValue").with_f64_data(&[time]);
        root.add_group(moment.finish());
        file.add_group(root.finish());
        file.finish()
    }

    fn array(&self, group: &mut GroupBuilder, len: usize, array: &Array) {
        let numbers = (len * array.components) as u64;
        let kind = match array.kind {
            Kind::Float32 => make_f32_type(),
            Kind::Float64 => make_f64_type(),
            Kind::UInt32 => make_u32_type(),
        };
        let (len, components) = (len as u64, array.components as u64);
        let shape = if components == 1 { vec![len] } else { vec![len, components] };
        let data = group.create_dataset(&array.name);
        data.with_raw_data(kind, array.bytes.clone(), numbers).with_shape(&shape);
        self.packed(data, &shape);
    }

    /// Compresses what has something to compress.
    fn packed(&self, data: &mut DatasetBuilder, shape: &[u64]) {
        if self.compress && shape.iter().all(|count| *count > 0) {
            let chunks: Vec<u64> = shape.iter().map(|count| (*count).min(CHUNK)).collect();
            data.with_chunks(&chunks).with_deflate(LEVEL);
        }
    }
}

impl Form for VtkHdf {
    fn ending(&self) -> &'static str {
        "vtkhdf"
    }

    fn list_ending(&self) -> &'static str {
        "vtkhdf.series"
    }

    fn write(&mut self, path: &Path, time: f64, frame: &Frame) -> Result<(), OutputError> {
        // A slash would be a group of its own.
        if let Some(field) = frame.fields.iter().find(|field| field.name.contains('/')) {
            let reason = "HDF5 takes a slash for a group: use another sign, or the form vtu";
            return Err(OutputError::Name { path: path.to_path_buf(), name: field.name.clone(), reason });
        }
        let bytes = self
            .bytes(time, frame)
            .map_err(|error| OutputError::Hdf { path: path.to_path_buf(), reason: error.to_string() })?;
        write_atomically(path, |out| out.write_all(&bytes))
    }

    fn list(&self, path: &Path, frames: &[(f64, String)]) -> Result<(), OutputError> {
        let files: Vec<_> =
            frames.iter().map(|(time, name)| serde_json::json!({ "name": name, "time": time })).collect();
        let list = serde_json::json!({ "file-series-version": "1.0", "files": files });
        write_atomically(path, |out| writeln!(out, "{list:#}"))
    }
}
