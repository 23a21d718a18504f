//! VTK's XML, as an unstructured grid or as polygonal data, and the collection ParaView opens.
//!
//! Both have the same arrays; what differs is what the cells are called, and that those of polygonal data have no types of their own.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use super::appended::Appended;
use super::encode::{Frame, Kind};
use super::form::{Form, VERTEX};
use crate::OutputError;
use crate::directory::write_atomically;

/// What a file says it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DataSet {
    /// `.vtu`: cells of any type.
    UnstructuredGrid,
    /// `.vtp`: vertices, and lines, strips and polygons, of which there are none.
    PolyData,
}

impl DataSet {
    /// VTK's name of it.
    fn name(self) -> &'static str {
        match self {
            Self::UnstructuredGrid => "UnstructuredGrid",
            Self::PolyData => "PolyData",
        }
    }

    /// The attribute that counts its cells, and the element that has them.
    fn cells(self) -> [&'static str; 2] {
        match self {
            Self::UnstructuredGrid => ["NumberOfCells", "Cells"],
            Self::PolyData => ["NumberOfVerts", "Verts"],
        }
    }
}

/// Writes `.vtu` or `.vtp`, and `.pvd`.
pub(super) struct Xml {
    data_set: DataSet,
    appended: Appended,
    cells: Cells,
}

/// The cells stand first in the appended section and stay there for the next frame: their number
/// rarely changes, and compressing them again would take a third of the time.
#[derive(Default)]
struct Cells {
    /// Number of cells, and bytes they take; `None` before the first frame.
    written: Option<(usize, usize)>,
    /// Their arrays: type, name, and where they begin.
    arrays: Vec<(&'static str, &'static str, usize)>,
}

impl Xml {
    pub(super) fn new(data_set: DataSet, compress: bool) -> Self {
        Self { data_set, appended: Appended::new(compress), cells: Cells::default() }
    }

    /// Fills the appended section and returns the XML that stands before it.
    fn describe(&mut self, time: f64, frame: &Frame) -> std::io::Result<String> {
        let n = frame.len;
        self.keep_cells(n)?;
        let set = self.data_set.name();
        let [count, element] = self.data_set.cells();
        let data = &mut self.appended;
        let compressor = if data.is_compressed() { " compressor=\"vtkZLibDataCompressor\"" } else { "" };
        let mut xml = String::from("<?xml version=\"1.0\"?>\n");
        // Writing into a String cannot fail, here and below.
        let _ = writeln!(
            xml,
            "<VTKFile type=\"{set}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"{compressor}>"
        );
        let _ = writeln!(xml, "  <{set}>\n    <FieldData>");
        // ParaView shows this time even when a single frame is opened without its collection.
        let _ = writeln!(
            xml,
            "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time:e}</DataArray>"
        );
        xml += "    </FieldData>\n";
        let _ = writeln!(xml, "    <Piece NumberOfPoints=\"{n}\" {count}=\"{n}\">\n      <Points>");
        let points = &frame.points;
        array(&mut xml, name(points.kind), "Points", 3, data.push(&points.bytes)?);
        let _ = writeln!(xml, "      </Points>\n      <{element}>");
        for (kind, name, offset) in &self.cells.arrays {
            array(&mut xml, kind, name, 1, *offset);
        }
        let _ = writeln!(xml, "      </{element}>\n      <PointData>");
        for field in &frame.fields {
            array(&mut xml, name(field.kind), &field.name, field.components, data.push(&field.bytes)?);
        }
        let _ = writeln!(xml, "      </PointData>\n    </Piece>\n  </{set}>");
        Ok(xml)
    }

    /// Makes the appended section hold the cells of `n` particles and nothing else.
    fn keep_cells(&mut self, n: usize) -> std::io::Result<()> {
        let (data, cells) = (&mut self.appended, &mut self.cells);
        if let Some((count, length)) = cells.written
            && count == n
        {
            data.truncate(length);
            return Ok(());
        }
        data.truncate(0);
        cells.written = None;
        cells.arrays.clear();
        let wide = |from: i64| -> Vec<u8> { (from..from + n as i64).flat_map(i64::to_le_bytes).collect() };
        cells.arrays.push(("Int64", "connectivity", data.push(&wide(0))?));
        cells.arrays.push(("Int64", "offsets", data.push(&wide(1))?));
        if self.data_set == DataSet::UnstructuredGrid {
            cells.arrays.push(("UInt8", "types", data.push(&vec![VERTEX; n])?));
        }
        cells.written = Some((n, data.bytes.len()));
        Ok(())
    }
}

impl Form for Xml {
    fn ending(&self) -> &'static str {
        match self.data_set {
            DataSet::UnstructuredGrid => "vtu",
            DataSet::PolyData => "vtp",
        }
    }

    fn list_ending(&self) -> &'static str {
        "pvd"
    }

    fn write(&mut self, path: &Path, time: f64, frame: &Frame) -> Result<(), OutputError> {
        let xml = self.describe(time, frame).map_err(OutputError::file("prepare", path))?;
        write_atomically(path, |out| {
            out.write_all(xml.as_bytes())?;
            out.write_all(b"  <AppendedData encoding=\"raw\">\n_")?;
            out.write_all(&self.appended.bytes)?;
            out.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
        })
    }

    fn list(&self, path: &Path, frames: &[(f64, String)]) -> Result<(), OutputError> {
        write_atomically(path, |out| {
            out.write_all(b"<?xml version=\"1.0\"?>\n")?;
            out.write_all(b"<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n")?;
            out.write_all(b"  <Collection>\n")?;
            for (time, file) in frames {
                let file = escape(file);
                writeln!(out, "    <DataSet timestep=\"{time:e}\" group=\"\" part=\"0\" file=\"{file}\"/>")?;
            }
            out.write_all(b"  </Collection>\n</VTKFile>\n")
        })
    }
}

fn array(xml: &mut String, kind: &str, name: &str, components: usize, offset: usize) {
    let name = escape(name);
    let _ = writeln!(
        xml,
        "        <DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>"
    );
}

/// VTK's name of a kind of number.
fn name(kind: Kind) -> &'static str {
    match kind {
        Kind::Float32 => "Float32",
        Kind::Float64 => "Float64",
        Kind::UInt32 => "UInt32",
    }
}

/// Text as the value of an XML attribute.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
