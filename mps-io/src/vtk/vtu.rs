//! VTK's XML form of unstructured grids, and the collection ParaView opens.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use super::appended::Appended;
use super::encode::{Frame, Kind};
use super::form::{Form, VERTEX};
use crate::OutputError;
use crate::directory::write_atomically;

/// Writes `.vtu` and `.pvd`.
pub(super) struct Vtu {
    appended: Appended,
    cells: Cells,
}

/// The cells stand first in the appended section and stay there for the next frame: their number
/// rarely changes, and compressing them again would take a third of the time.
#[derive(Default)]
struct Cells {
    /// Number of cells, and bytes they take; `None` before the first frame.
    written: Option<(usize, usize)>,
    /// Where connectivity, offsets and types begin.
    at: [usize; 3],
}

impl Vtu {
    pub(super) fn new(compress: bool) -> Self {
        Self { appended: Appended::new(compress), cells: Cells::default() }
    }

    /// Fills the appended section and returns the XML that stands before it.
    fn describe(&mut self, time: f64, frame: &Frame) -> std::io::Result<String> {
        let n = frame.len;
        let cells = self.cells(n)?;
        let data = &mut self.appended;
        let mut xml = String::from("<?xml version=\"1.0\"?>\n");
        xml += "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"";
        xml += if data.is_compressed() { " compressor=\"vtkZLibDataCompressor\">\n" } else { ">\n" };
        xml += "  <UnstructuredGrid>\n    <FieldData>\n";
        // ParaView shows this time even when a single frame is opened without its collection.
        let _ = writeln!(
            xml,
            "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time:e}</DataArray>"
        );
        xml += "    </FieldData>\n";
        let _ = writeln!(xml, "    <Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{n}\">\n      <Points>");
        let points = &frame.points;
        array(&mut xml, name(points.kind), "Points", 3, data.push(&points.bytes)?);
        xml += "      </Points>\n      <Cells>\n";
        array(&mut xml, "Int64", "connectivity", 1, cells[0]);
        array(&mut xml, "Int64", "offsets", 1, cells[1]);
        array(&mut xml, "UInt8", "types", 1, cells[2]);
        xml += "      </Cells>\n      <PointData>\n";
        for field in &frame.fields {
            array(&mut xml, name(field.kind), &field.name, field.components, data.push(&field.bytes)?);
        }
        xml += "      </PointData>\n    </Piece>\n  </UnstructuredGrid>\n";
        Ok(xml)
    }

    /// Makes the appended section hold the cells of `n` particles and nothing else.
    fn cells(&mut self, n: usize) -> std::io::Result<[usize; 3]> {
        let (data, cells) = (&mut self.appended, &mut self.cells);
        if let Some((count, length)) = cells.written
            && count == n
        {
            data.truncate(length);
        } else {
            data.truncate(0);
            cells.written = None;
            let wide =
                |from: i64| -> Vec<u8> { (from..from + n as i64).flat_map(i64::to_le_bytes).collect() };
            cells.at = [data.push(&wide(0))?, data.push(&wide(1))?, data.push(&vec![VERTEX; n])?];
            cells.written = Some((n, data.bytes.len()));
        }
        Ok(cells.at)
    }
}

impl Form for Vtu {
    fn ending(&self) -> &'static str {
        "vtu"
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
    // Writing into a String cannot fail.
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
