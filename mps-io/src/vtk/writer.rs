//! One file a frame and the collection that lists them with their times.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use mps_kernel::{Real, Transfer};

use super::appended::Appended;
use super::cloud::{PointCloud, Values};
use crate::OutputError;
use crate::directory::{prepare_output, write_atomically};

/// VTK's number for a cell that is a single vertex.
const VERTEX: u8 = 1;

/// How fields are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldOptions {
    /// zlib-compress the values: smaller files, slower writing. Default: true.
    pub compress: bool,
    /// Write `f64` values as `f32`: half the size, enough for pictures. Turn it off when the files
    /// are compared with another run or continued from. Default: true.
    pub single_precision: bool,
}

impl Default for FieldOptions {
    fn default() -> Self {
        Self { compress: true, single_precision: true }
    }
}

/// Writes the frames `name_00000.vtu`, `name_00001.vtu`, ... and the collection `name.pvd`.
///
/// Both appear whole or not at all and the collection is rewritten after each frame: ParaView can
/// open a running job and reload it. Frames of an earlier run in the same directory are overwritten
/// as the new run reaches their numbers; the collection lists only the new ones.
pub struct FieldWriter {
    dir: PathBuf,
    name: String,
    frames: Vec<(f64, String)>,
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

impl FieldWriter {
    /// A writer into `dir`, which is created if it is missing.
    ///
    /// # Errors
    /// The directory cannot be created or written to, or `name` cannot be a file name.
    pub fn new(dir: impl AsRef<Path>, name: &str, options: FieldOptions) -> Result<Self, OutputError> {
        let dir = dir.as_ref().to_path_buf();
        if name.is_empty() || name.contains(['/', '\\', '\0', ':']) {
            let reason = "a series needs a name without '/', '\\' and ':'; use for instance \"fluid\"";
            return Err(OutputError::Name { path: dir, name: name.to_owned(), reason });
        }
        prepare_output(&dir)?;
        let appended = Appended::new(options.compress, options.single_precision);
        Ok(Self { dir, name: name.to_owned(), frames: Vec::new(), appended, cells: Cells::default() })
    }

    /// Writes the cloud at `time` (s) as the next frame and returns the path of its file.
    ///
    /// # Errors
    /// A field has not one value for each particle, two fields share a name, or the disk refuses.
    pub fn write<T: Real, const D: usize>(
        &mut self,
        time: f64,
        cloud: &PointCloud<'_, T, D>,
    ) -> Result<PathBuf, OutputError> {
        let file = self.file_name(self.frames.len());
        let path = self.dir.join(&file);
        check(&path, cloud)?;
        let xml = self.describe(time, cloud).map_err(OutputError::file("prepare", &path))?;
        let bytes = &self.appended.bytes;
        write_atomically(&path, |out| {
            out.write_all(xml.as_bytes())?;
            out.write_all(b"  <AppendedData encoding=\"raw\">\n_")?;
            out.write_all(bytes)?;
            out.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
        })?;
        self.frames.push((time, file));
        self.write_collection()?;
        Ok(path)
    }

    /// Saves the times of the frames, or goes back to those there were: frames written later are written over.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let mut times: Vec<f64> = self.frames.iter().map(|(time, _)| *time).collect();
        transfer.list("times", &mut times);
        self.frames = times.into_iter().enumerate().map(|(k, time)| (time, self.file_name(k))).collect();
    }

    fn file_name(&self, frame: usize) -> String {
        format!("{}_{frame:05}.vtu", self.name)
    }

    /// Number of frames written so far.
    pub fn frames(&self) -> usize {
        self.frames.len()
    }

    /// The file to open in ParaView.
    pub fn collection(&self) -> PathBuf {
        self.dir.join(format!("{}.pvd", self.name))
    }

    /// Fills the appended section and returns the XML that stands before it.
    fn describe<T: Real, const D: usize>(
        &mut self,
        time: f64,
        cloud: &PointCloud<'_, T, D>,
    ) -> std::io::Result<String> {
        let cells = self.cells(cloud.len())?;
        let data = &mut self.appended;
        let real = data.real_type::<T>();
        let n = cloud.len();
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
        array(&mut xml, real, "Points", 3, data.vectors(cloud.positions)?);
        xml += "      </Points>\n      <Cells>\n";
        array(&mut xml, "Int64", "connectivity", 1, cells[0]);
        array(&mut xml, "Int64", "offsets", 1, cells[1]);
        array(&mut xml, "UInt8", "types", 1, cells[2]);
        xml += "      </Cells>\n      <PointData>\n";
        for (name, values) in &cloud.fields {
            let kind = if matches!(values, Values::Integer(_)) { "UInt32" } else { real };
            array(&mut xml, kind, name, values.components(), data.values(values)?);
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
            cells.at = [
                data.wide_integers(0..n as i64)?,
                data.wide_integers(1..n as i64 + 1)?,
                data.octets(std::iter::repeat_n(VERTEX, n))?,
            ];
            cells.written = Some((n, data.bytes.len()));
        }
        Ok(cells.at)
    }

    fn write_collection(&self) -> Result<(), OutputError> {
        write_atomically(&self.collection(), |out| {
            out.write_all(b"<?xml version=\"1.0\"?>\n")?;
            out.write_all(b"<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n")?;
            out.write_all(b"  <Collection>\n")?;
            for (time, file) in &self.frames {
                let file = escape(file);
                writeln!(out, "    <DataSet timestep=\"{time:e}\" group=\"\" part=\"0\" file=\"{file}\"/>")?;
            }
            out.write_all(b"  </Collection>\n</VTKFile>\n")
        })
    }
}

fn check<T: Real, const D: usize>(path: &Path, cloud: &PointCloud<'_, T, D>) -> Result<(), OutputError> {
    for (k, (name, values)) in cloud.fields.iter().enumerate() {
        if values.len() != cloud.len() {
            let (field, expected, found) = (name.clone(), cloud.len(), values.len());
            return Err(OutputError::FieldLength { field, expected, found });
        }
        if cloud.fields[..k].iter().any(|(earlier, _)| earlier == name) {
            let reason = "another field of the same frame has it, and readers keep only one of them";
            return Err(OutputError::Name { path: path.to_path_buf(), name: name.clone(), reason });
        }
    }
    Ok(())
}

fn array(xml: &mut String, kind: &str, name: &str, components: usize, offset: usize) {
    let name = escape(name);
    // Writing into a String cannot fail.
    let _ = writeln!(
        xml,
        "        <DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>"
    );
}

/// Text as the value of an XML attribute.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
