//! The scene as a whole, its names, probes and output.

use super::super::probes::{Measure, Probe};
use super::super::scene::SceneFile;
use super::super::suggest::advice;
use super::Checker;

/// Steps between two rows, frames or pictures are at least as many as this, or the disk is full of them.
const MOST_FRAMES: f64 = 1e5;

impl Checker<'_> {
    pub(super) fn whole(&mut self, scene: &SceneFile) {
        let only_two = "give 2: scenes in three dimensions cannot be run yet";
        self.unless(scene.dimension == 2, "dimension", format!("is {}", scene.dimension), only_two);
        if !self.problems.is_empty() {
            return;
        }
        self.positive(scene.end_time, "end_time", "give the simulated time in seconds");
        self.vector(&scene.gravity, "gravity");
        let something = "give it a [fluid], or at least one of [[solids]]";
        self.unless(
            scene.fluid.is_some() || !scene.solids.is_empty(),
            "",
            "the scene has nothing that moves",
            something,
        );
        if let Some(fluid) = &scene.fluid {
            self.fluid(fluid, &scene.gravity);
        }
        let l0 = scene.fluid.as_ref().map(|fluid| fluid.spacing);
        let no_fluid = "give the scene a [fluid], or leave the walls out";
        let no_fluid_to_feel = "give the scene a [fluid], or leave the fixed bodies out";
        self.unless(l0.is_some() || scene.walls.is_empty(), "walls", "have no fluid to hold", no_fluid);
        for (k, wall) in scene.walls.iter().enumerate() {
            self.wall(wall, l0.unwrap_or(1.0), &format!("walls[{k}]"));
        }
        for (k, solid) in scene.solids.iter().enumerate() {
            self.solid(solid, &format!("solids[{k}]"));
        }
        self.unless(
            l0.is_some() || scene.fixed.is_empty(),
            "fixed",
            "have no fluid to feel",
            no_fluid_to_feel,
        );
        for (k, body) in scene.fixed.iter().enumerate() {
            self.fixed(body, l0.unwrap_or(1.0), &format!("fixed[{k}]"));
        }
        // Probes find both by name.
        let solids =
            scene.solids.iter().enumerate().map(|(k, solid)| (format!("solids[{k}].name"), &solid.name));
        let fixed = scene.fixed.iter().enumerate().map(|(k, body)| (format!("fixed[{k}].name"), &body.name));
        self.names(solids.chain(fixed));
        let probes =
            scene.probes.iter().enumerate().map(|(k, probe)| (format!("probes[{k}].name"), &probe.name));
        self.names(probes);
        for (k, probe) in scene.probes.iter().enumerate() {
            self.probe(probe, scene, &format!("probes[{k}].measure"));
        }
        self.output(scene);
        self.watch(&scene.watch);
    }

    /// Names become parts of file names and headings of columns.
    fn names<'n>(&mut self, names: impl Iterator<Item = (String, &'n String)>) {
        let mut known: Vec<&str> = Vec::new();
        for (key, name) in names {
            let good =
                !name.trim().is_empty() && !name.contains(['/', '\\', '\n', '"']) && !name.starts_with('.');
            let what = format!("is {name:?}");
            self.unless(good, &key, &what, "give it letters, digits, spaces or dashes");
            self.unless(
                !known.contains(&name.as_str()),
                &key,
                &what,
                "another one has this name: change one",
            );
            known.push(name);
        }
    }

    fn probe(&mut self, probe: &Probe, scene: &SceneFile, key: &str) {
        let no_fluid = "give the scene a [fluid], or leave the probe out";
        let fluid = !matches!(probe.measure, Measure::Displacement(_));
        self.unless(!fluid || scene.fluid.is_some(), key, "has no fluid to measure", no_fluid);
        match &probe.measure {
            Measure::Pressure(pressure) => {
                self.point(&pressure.at, &format!("{key}.pressure.at"));
            }
            Measure::Level(level) => {
                self.point(&level.foot, &format!("{key}.level.foot"));
            }
            Measure::Front(front) => {
                self.point(&front.start, &format!("{key}.front.start"));
                let height = format!("{key}.front.height");
                self.positive(
                    front.height,
                    &height,
                    "give the height in metres, e.g. a tenth of that of the water",
                );
            }
            Measure::Force(force) => {
                let on = format!("{key}.force.on");
                self.unless(!force.on.is_empty(), &on, "names no body", "name one at least");
                let solids = scene.solids.iter().map(|solid| solid.name.as_str());
                let names: Vec<&str> =
                    solids.chain(scene.fixed.iter().map(|body| body.name.as_str())).collect();
                for (k, name) in force.on.iter().enumerate() {
                    let (what, advice) =
                        (format!("is {name:?}, and no body has this name"), advice(name, &names));
                    self.unless(names.contains(&name.as_str()), &format!("{on}[{k}]"), what, advice);
                    let twice = force.on[..k].contains(name);
                    self.unless(
                        !twice,
                        &format!("{on}[{k}]"),
                        format!("is {name:?} again"),
                        "name each body once",
                    );
                }
            }
            Measure::Displacement(displacement) => {
                let (at, named) = (format!("{key}.displacement.at"), &displacement.solid);
                let names: Vec<&str> = scene.solids.iter().map(|solid| solid.name.as_str()).collect();
                let Some(solid) = scene.solids.iter().find(|solid| solid.name == *named) else {
                    let what = format!("is {named:?}, and no solid has this name");
                    return self.unless(
                        false,
                        &format!("{key}.displacement.solid"),
                        what,
                        advice(named, &names),
                    );
                };
                if self.point(&displacement.at, &at) {
                    let inside = solid.region.contains(&displacement.at, solid.spacing);
                    let what = format!("is {:?}, outside the body {named:?}", displacement.at);
                    self.unless(inside, &at, what, "give a point of the undeformed body");
                }
            }
        }
    }

    fn output(&mut self, scene: &SceneFile) {
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
}
