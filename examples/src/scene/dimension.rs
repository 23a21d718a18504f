//! Where the number of dimensions of a file becomes that of the code: what is below is generic over it, what is above does not
//! know it.

use super::run::{Origin, Plan, run_plan};
use super::{Diagnosis, Layout, diagnose, disk, plan};
use crate::{Common, Failure};
use mps_io::scene_file::{SceneFile, Source};
use mps_neighbors::Parallel;

/// All points of a scene in its dimension.
pub(super) enum AnyLayout {
    /// In two dimensions.
    Plane(Layout<2>),
    /// In three.
    Space(Layout<3>),
}

/// Does something with the points, whatever their dimension.
macro_rules! with {
    ($any:expr, $layout:ident => $does:expr) => {
        match $any {
            AnyLayout::Plane($layout) => $does,
            AnyLayout::Space($layout) => $does,
        }
    };
}

impl AnyLayout {
    /// As [`Layout::new`].
    pub(super) fn new(scene: &SceneFile, source: &Source) -> Result<Self, Failure> {
        let parallel = Parallel::all_cores()?;
        Ok(match scene.dimension {
            3 => Self::Space(Layout::new(scene, source, &parallel)?),
            _ => Self::Plane(Layout::new(scene, source, &parallel)?),
        })
    }

    /// Numbers of particles of the fluid, points of the walls, and particles of the elastic bodies.
    pub(super) fn counts(&self) -> [usize; 3] {
        with!(self, layout => [layout.fluid_len(), layout.walls_len(), layout.solids_len()])
    }

    pub(super) fn diagnose(&self, scene: &SceneFile, source: &Source) -> Result<Diagnosis, Failure> {
        let parallel = Parallel::all_cores()?;
        with!(self, layout => diagnose(scene, source, layout, &parallel))
    }

    pub(super) fn short_of_disk(&self, scene: &SceneFile, common: &Common, name: &str) -> Option<String> {
        with!(self, layout => disk::short_of_disk(scene, layout, common, name))
    }

    pub(super) fn plan(
        &self,
        scene: &SceneFile,
        diagnosis: &Diagnosis,
        common: &Common,
    ) -> Result<String, Failure> {
        with!(self, layout => plan::plan(scene, layout, diagnosis, common))
    }

    pub(super) fn run_plan(&self, plan: Plan<'_>, from: Origin<'_>) -> Result<(), Failure> {
        with!(self, layout => run_plan(plan, layout, from))
    }
}
