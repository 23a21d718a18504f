//! One file a frame and a list of them with their times.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use mps_kernel::{Real, Transfer};

use super::cloud::PointCloud;
use super::encode::Frame;
use super::form::Form;
use super::vtkhdf::VtkHdf;
use super::xml::{DataSet, Xml};
use crate::OutputError;
use crate::directory::prepare_output;

/// How fields are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldOptions {
    /// zlib-compress the values: smaller files, slower writing. Default: true.
    pub compress: bool,
    /// Write `f64` values as `f32`: half the size, enough for pictures. Turn it off when the files
    /// are compared with another run or continued from. Default: true.
    pub single_precision: bool,
    /// Form of the files. Default: VTK's XML.
    pub format: FieldFormat,
}

impl Default for FieldOptions {
    fn default() -> Self {
        Self { compress: true, single_precision: true, format: FieldFormat::default() }
    }
}

/// A form of files that VTK and ParaView read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FieldFormat {
    /// VTK's XML, an unstructured grid: frames `name_00012.vtu`, listed in `name.pvd`.
    #[default]
    Vtu,
    /// VTK's XML, polygonal data: frames `name_00012.vtp`, listed in `name.pvd`. For readers and filters that take surfaces and points
    /// only; a byte a particle less.
    Vtp,
    /// HDF5: frames `name_00012.vtkhdf`, listed in `name.vtkhdf.series`. For those who read fields with HDF5 libraries too; VTK 9.3 or
    /// later.
    VtkHdf,
}

impl FieldFormat {
    const ALL: [Self; 3] = [Self::Vtu, Self::Vtp, Self::VtkHdf];

    fn form(self, compress: bool) -> Box<dyn Form + Send> {
        match self {
            Self::Vtu => Box::new(Xml::new(DataSet::UnstructuredGrid, compress)),
            Self::Vtp => Box::new(Xml::new(DataSet::PolyData, compress)),
            Self::VtkHdf => Box::new(VtkHdf::new(compress)),
        }
    }
}

/// Writes the frames `name_00000.vtu`, `name_00001.vtu`, ... and the collection `name.pvd`, or the same in
/// [another form](FieldFormat).
///
/// Both appear whole or not at all and the collection is rewritten after each frame: ParaView can
/// open a running job and reload it. Frames of an earlier run in the same directory are overwritten
/// as the new run reaches their numbers; the collection lists only the new ones. The list of one that wrote the series in another
/// form is removed, so that nobody opens it for the new one; its frames are left.
pub struct FieldWriter {
    dir: PathBuf,
    name: String,
    frames: Vec<(f64, String)>,
    single_precision: bool,
    form: Box<dyn Form + Send>,
}

impl FieldWriter {
    /// A writer into `dir`, which is created if it is missing.
    ///
    /// # Errors
    /// The directory cannot be created or written to, a list in another form cannot be removed from it, or `name` cannot be a file name.
    pub fn new(dir: impl AsRef<Path>, name: &str, options: FieldOptions) -> Result<Self, OutputError> {
        let dir = dir.as_ref().to_path_buf();
        if name.is_empty() || name.contains(['/', '\\', '\0', ':']) {
            let reason = "a series needs a name without '/', '\\' and ':'; use for instance \"fluid\"";
            return Err(OutputError::Name { path: dir, name: name.to_owned(), reason });
        }
        prepare_output(&dir)?;
        let FieldOptions { compress, single_precision, format } = options;
        let form = format.form(compress);
        let writer = Self { dir, name: name.to_owned(), frames: Vec::new(), single_precision, form };
        writer.remove_other_lists()?;
        Ok(writer)
    }

    /// Removes what an earlier run in another form has left for readers to open.
    fn remove_other_lists(&self) -> Result<(), OutputError> {
        for other in FieldFormat::ALL {
            let list = self.list(other.form(false).list_ending());
            if list == self.collection() {
                continue;
            }
            match std::fs::remove_file(&list) {
                Err(error) if error.kind() != ErrorKind::NotFound => {
                    return Err(OutputError::file("remove the list of an earlier run", &list)(error));
                }
                _ => {}
            }
        }
        Ok(())
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
        self.form.write(&path, time, &Frame::of(cloud, self.single_precision))?;
        self.frames.push((time, file));
        self.form.list(&self.collection(), &self.frames)?;
        Ok(path)
    }

    /// Saves the times of the frames, or goes back to those there were: frames written later are written over.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let mut times: Vec<f64> = self.frames.iter().map(|(time, _)| *time).collect();
        transfer.list("times", &mut times);
        self.frames = times.into_iter().enumerate().map(|(k, time)| (time, self.file_name(k))).collect();
    }

    fn file_name(&self, frame: usize) -> String {
        format!("{}_{frame:05}.{}", self.name, self.form.ending())
    }

    /// Number of frames written so far.
    pub fn frames(&self) -> usize {
        self.frames.len()
    }

    /// The file to open in ParaView.
    pub fn collection(&self) -> PathBuf {
        self.list(self.form.list_ending())
    }

    fn list(&self, ending: &str) -> PathBuf {
        self.dir.join(format!("{}.{ending}", self.name))
    }
}

fn check<T: Real, const D: usize>(path: &Path, cloud: &PointCloud<'_, T, D>) -> Result<(), OutputError> {
    let particles = cloud.positions.len();
    for (k, (name, values)) in cloud.fields.iter().enumerate() {
        if values.len() != particles {
            let (field, found) = (name.clone(), values.len());
            return Err(OutputError::FieldLength { field, expected: particles, found });
        }
        if cloud.fields[..k].iter().any(|(earlier, _)| earlier == name) {
            let reason = "another field of the same frame has it, and readers keep only one of them";
            return Err(OutputError::Name { path: path.to_path_buf(), name: name.clone(), reason });
        }
    }
    match cloud.chosen.and_then(|chosen| chosen.iter().find(|i| **i as usize >= particles)) {
        Some(&particle) => Err(OutputError::NoParticle { particle, particles }),
        None => Ok(()),
    }
}
