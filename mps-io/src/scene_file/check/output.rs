//! What is written.

use super::super::choice::Field;
use super::super::scene::SceneFile;
use super::Checker;

/// Steps between two rows, frames or pictures are at least as many as this, or the disk is full of them.
const MOST_FRAMES: f64 = 1e5;

impl Checker<'_> {
    pub(super) fn output(&mut self, scene: &SceneFile) {
        let (output, end) = (&scene.output, scene.end_time);
        if let Some(interval) = output.probe_interval {
            self.positive(interval, "output.probe_interval", "give the time between two rows in seconds");
        }
        for (name, interval) in [
            ("probe_interval", output.probe_interval),
            ("frame_interval", output.frame_interval),
            ("field_interval", output.field_interval),
            ("picture_interval", output.picture_interval),
        ] {
            let interval = interval.unwrap_or(0.0);
            let key = format!("output.{name}");
            let enough = format!("give at least {:e} s, or 0 for none", end / MOST_FRAMES);
            let good = interval == 0.0 || interval >= end / MOST_FRAMES;
            self.unless(good, &key, format!("is {interval}"), enough);
        }
        if let Some(view) = &output.view {
            self.corners(view, "output.view");
        }
        if let Some(region) = &output.field_region {
            self.shape(region, "output.field_region");
        }
        self.fields(scene);
        for (name, scale) in
            [("pressure_scale", output.pressure_scale), ("strain_scale", output.strain_scale)]
        {
            self.positive(
                scale.unwrap_or(1.0),
                &format!("output.{name}"),
                "give the value at the end of the colours",
            );
        }
    }

    /// Fields nothing in the scene has, and those that are named again.
    fn fields(&mut self, scene: &SceneFile) {
        let (fluid, bodies) = (scene.fluid.is_some(), !scene.solids.is_empty());
        let chosen = scene.output.fields.as_deref().unwrap_or_default();
        for (k, field) in chosen.iter().enumerate() {
            let key = format!("output.fields[{k}]");
            let owned =
                fluid && Field::OF_FLUIDS.contains(field) || bodies && Field::OF_BODIES.contains(field);
            let what = format!("is the {}, which nothing in the scene has", field.name());
            self.unless(owned, &key, what, "leave it out");
            let twice = chosen[..k].contains(field);
            self.unless(!twice, &key, format!("is the {} again", field.name()), "name each field once");
        }
    }
}
