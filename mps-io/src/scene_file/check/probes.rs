//! What is measured.

use super::super::fixed::{Fixed, Packing};
use super::super::probes::{LineProbe, Measure, Probe, WallPressureProbe};
use super::super::scene::SceneFile;
use super::super::suggest::advice;
use super::Checker;

impl Checker<'_> {
    pub(super) fn probe(&mut self, probe: &Probe, scene: &SceneFile, key: &str) {
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
            Measure::Velocity(velocity) => {
                self.point(&velocity.at, &format!("{key}.velocity.at"));
            }
            Measure::Line(line) => self.line_of_places(line, &format!("{key}.line")),
            Measure::WallPressure(wall) => {
                let key = format!("{key}.wall_pressure");
                if !self.only_in(2, &key, "give a probe of force on the fixed body") {
                    return;
                }
                let names: Vec<&str> = scene.fixed.iter().map(|body| body.name.as_str()).collect();
                let what = format!("is {:?}, and no fixed body has this name", wall.on);
                let known = names.contains(&wall.on.as_str());
                self.unless(known, &format!("{key}.on"), what, advice(&wall.on, &names));
                self.ends(&wall.from, &wall.to, &key);
                let on = scene.fixed.iter().find(|body| body.name == wall.on);
                let fluid = scene.fluid.as_ref().map(|fluid| fluid.spacing);
                if let (Some(body), Some(l0)) = (on, fluid) {
                    self.whole_rows(wall, body, body.spacing.unwrap_or(l0), &format!("{key}.to"));
                }
            }
            Measure::Force(force) => self.bodies(&force.on, scene, &format!("{key}.force.on")),
            Measure::Budget(budget) => self.bodies(&budget.on, scene, &format!("{key}.budget.on")),
            Measure::Displacement(displacement) => {
                let (place, named) = (format!("{key}.displacement.at"), &displacement.solid);
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
                if self.point(&displacement.at, &place) {
                    // A margin would widen what a difference takes away as well.
                    let (at, margin) = (&displacement.at, 1e-6 * solid.spacing);
                    let near = || solid.region.surface()?.nearest(at).map(|foot| -foot.depth);
                    let inside = solid.region.contains(at, margin)
                        || near().is_some_and(|apart| apart <= solid.spacing);
                    let what = format!("is {:?}, outside the body {named:?}", displacement.at);
                    self.unless(inside, &place, what, "give a point of the undeformed body");
                }
            }
        }
    }

    fn line_of_places(&mut self, line: &LineProbe, key: &str) {
        let points = format!("is {}", line.points);
        let few = "give 2 to 100: each is a column, or one per dimension";
        self.unless((2..=100).contains(&line.points), &format!("{key}.points"), points, few);
        self.ends(&line.from, &line.to, key);
    }

    /// Every point behind a wall bears what a spacing of it does: a part of a spacing would be counted whole, or not at all. Rings and
    /// rows are fitted to their body, and their points nearly a spacing apart.
    fn whole_rows(&mut self, wall: &WallPressureProbe, body: &Fixed, spacing: f64, key: &str) {
        let square: f64 = wall.from.iter().zip(&wall.to).map(|(a, b)| (b - a) * (b - a)).sum();
        let cells = square.sqrt() / spacing;
        let even = matches!(body.packing, Packing::Lattice | Packing::Fitted);
        let whole = cells > 0.5 && (cells - cells.round()).abs() < 0.01;
        let what = format!("is {cells:.2} spacings of the body from `from`");
        self.unless(whole || !even, key, what, "give a whole number of them, 1 at least");
    }

    /// The ends of a line.
    fn ends(&mut self, from: &[f64], to: &[f64], key: &str) {
        let [first, last] =
            [("from", from), ("to", to)].map(|(end, at)| self.point(at, &format!("{key}.{end}")));
        if first && last {
            self.unless(
                from != to,
                &format!("{key}.to"),
                format!("is {to:?}, as `from`"),
                "give another point",
            );
        }
    }

    /// Names of bodies, elastic or fixed.
    fn bodies(&mut self, on: &[String], scene: &SceneFile, key: &str) {
        self.unless(!on.is_empty(), key, "names no body", "name one at least");
        let solids = scene.solids.iter().map(|solid| solid.name.as_str());
        let names: Vec<&str> = solids.chain(scene.fixed.iter().map(|body| body.name.as_str())).collect();
        for (k, name) in on.iter().enumerate() {
            let key = format!("{key}[{k}]");
            let what = format!("is {name:?}, and no body has this name");
            self.unless(names.contains(&name.as_str()), &key, what, advice(name, &names));
            self.unless(!on[..k].contains(name), &key, format!("is {name:?} again"), "name each body once");
        }
    }
}
