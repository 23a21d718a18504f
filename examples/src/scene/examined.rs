//! Scenes that have been read, filled with particles and examined.

use super::dimension::AnyLayout;
use super::{Diagnosis, run};
use crate::{Common, Failure};
use mps_io::scene_file::{SceneError, SceneFile, Source};
use std::path::PathBuf;

/// A scene with its particles, and what can be seen to be wrong with it.
pub struct Examined {
    /// The file it was read from.
    file: PathBuf,
    scene: SceneFile,
    layout: AnyLayout,
    diagnosis: Diagnosis,
}

impl Examined {
    /// Fills a scene with particles, and looks for what is wrong with it.
    ///
    /// # Errors
    /// Every part that has no particles or cannot be a body.
    pub fn new(scene: SceneFile, source: &Source) -> Result<Self, Failure> {
        let layout = AnyLayout::new(&scene, source)?;
        let diagnosis = layout.diagnose(&scene, source)?;
        Ok(Self { file: source.name().into(), scene, layout, diagnosis })
    }

    /// What was found.
    pub fn diagnosis(&self) -> &Diagnosis {
        &self.diagnosis
    }

    /// The scene, if it can be run.
    ///
    /// # Errors
    /// Everything for which it cannot.
    pub fn without_refusals(self) -> Result<Self, SceneError> {
        let refusals = &self.diagnosis.refusals;
        if refusals.is_empty() { Ok(self) } else { Err(SceneError::Refused(refusals.clone())) }
    }

    /// Numbers of particles of the fluid, points of the walls, and particles of the elastic bodies.
    pub fn counts(&self) -> [usize; 3] {
        self.layout.counts()
    }

    /// What to say of a run called `name` whose fields may not find room where it writes.
    pub fn short_of_disk(&self, common: &Common, name: &str) -> Option<String> {
        self.layout.short_of_disk(&self.scene, common, name)
    }

    /// What a run will be and cost, measured by its first steps, as text.
    ///
    /// # Errors
    /// If the scene cannot be built or breaks in its first steps.
    pub fn plan(&self, common: &Common) -> Result<String, Failure> {
        self.layout.plan(&self.scene, &self.diagnosis, common)
    }

    /// Runs the scene, and writes its results to the directory of `common`, else to that of the scene, else to
    /// `out/<name>`. Every `interval` seconds of wall time it writes a checkpoint there, none for zero; one more at a signal,
    /// and at the end.
    ///
    /// # Errors
    /// What breaks the run off. What has been computed until then is kept. A scene file whose place the results would take is left as it is.
    pub fn run(&self, name: &str, common: &Common, interval: f64) -> Result<(), Failure> {
        run::begin((&self.scene, &self.file), &self.layout, name, common, interval)
    }
}
