//! The scene as a whole, and its names.

use super::super::fluid::Fluid;
use super::super::scene::SceneFile;
use super::super::walls::Slip;
use super::Checker;

/// Bytes of the longest name: with what is put before and behind it it is the name of a file.
const LONGEST: usize = 200;

impl Checker<'_> {
    pub(super) fn whole(&mut self, scene: &SceneFile) {
        let good = [2, 3].contains(&scene.dimension);
        self.unless(good, "dimension", format!("is {}", scene.dimension), "give 2 or 3");
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
            self.law_of_the_wall(scene, fluid);
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
            // The columns of a line are numbered.
            let numbered = probe.name.rsplit_once(' ').filter(|(_, number)| number.parse::<u32>().is_ok());
            let unlike = numbered.is_none_or(|(stem, _)| scene.probes.iter().all(|other| other.name != stem));
            let remedy = "a column of the probe without the number may have this name: change one";
            self.unless(unlike, &format!("probes[{k}].name"), format!("is {:?}", probe.name), remedy);
            self.probe(probe, scene, &format!("probes[{k}].measure"));
        }
        self.output(scene);
        self.watch(&scene.watch);
    }

    /// Its viscosity, if there is something with such a slip.
    fn law_of_the_wall(&mut self, scene: &SceneFile, fluid: &Fluid) {
        let walls = scene.walls.iter().map(|wall| wall.slip);
        let bodies = scene.fixed.iter().map(|body| body.slip);
        let key = "fluid.wall_viscosity";
        let water = "give that of water, 1e-6";
        self.within(fluid.wall_viscosity, [0.0, 1e6], key, water);
        for (k, _) in scene.solids.iter().enumerate().filter(|(_, solid)| solid.slip == Slip::Law) {
            let remedy = "its drag is held over the sub-steps of a body, which has not been tried: give \"free\" or \"none\"";
            self.unless(false, &format!("solids[{k}].slip"), "is \"law\"", remedy);
        }
        let known = (0.0..=1e6).contains(&fluid.wall_viscosity);
        if known && walls.chain(bodies).any(|slip| slip == Slip::Law) {
            // Beyond that the layers of the fluid are thicker than a particle.
            let most = 0.25 * fluid.spacing * fluid.sound();
            let what = format!(
                "is {}, and the law of the wall holds up to {most:e} at this spacing",
                fluid.wall_viscosity
            );
            let remedy =
                "give that of water, 1e-6, or the walls slip = \"none\" and the fluid a laminar viscosity";
            self.unless(fluid.wall_viscosity <= most || most <= 0.0, key, what, remedy);
        }
    }

    /// Names become parts of file names and headings of columns.
    fn names<'n>(&mut self, names: impl Iterator<Item = (String, &'n String)>) {
        let mut known: Vec<&str> = Vec::new();
        for (key, name) in names {
            let named = !name.trim().is_empty() && !name.starts_with('.');
            let plain = !name.contains(|c: char| c.is_control() || "/\\:\"".contains(c));
            let good = named && plain && name.len() <= LONGEST;
            let what = format!("is {name:?}");
            self.unless(good, &key, &what, "give it letters, digits, spaces or dashes, at most 200");
            self.unless(
                !known.contains(&name.as_str()),
                &key,
                &what,
                "another one has this name: change one",
            );
            known.push(name);
        }
    }
}
