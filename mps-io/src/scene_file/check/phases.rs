//! Fluid, walls and bodies.

use super::super::fluid::{Diffusion, Fluid, InitialPressure, Tension, Viscosity, Weight};
use super::super::region::{Corners, Filling, Region};
use super::super::solids::{Clamp, InitialVelocity, Side, Solid};
use super::super::walls::{Motion, Wall};
use super::Checker;

impl Checker<'_> {
    pub(super) fn fluid(&mut self, fluid: &Fluid, gravity: &[f64]) {
        self.positive(
            fluid.spacing,
            "fluid.spacing",
            "give the distance of the particles in metres, e.g. 5e-3",
        );
        self.positive(fluid.density, "fluid.density", "give the density in kg/m3, of water 1000");
        match (fluid.sound_speed, fluid.expected_speed) {
            (Some(speed), None) => self.positive(speed, "fluid.sound_speed", "give about ten times the largest speed of the flow in m/s"),
            (None, Some(speed)) => self.positive(speed, "fluid.expected_speed", "give the largest speed of the flow in m/s, e.g. sqrt(2 g H) for water of the height H"),
            (Some(_), Some(_)) => self.unless(false, "fluid.expected_speed", "is given beside `sound_speed`", "keep one: the sound speed is ten times the expected speed"),
            (None, None) => self.unless(false, "fluid", "has no speed", "add `expected_speed`, the largest speed of the flow in m/s, e.g. sqrt(2 g H) for water of the height H"),
        }
        match fluid.viscosity {
            Viscosity::None => {}
            Viscosity::Artificial(alpha) => self.within(
                alpha,
                [0.0, 10.0],
                "fluid.viscosity.artificial",
                "give a strength from 0 to 10, usually 0.02",
            ),
            Viscosity::Laminar(nu) => self.within(
                nu,
                [0.0, 1e6],
                "fluid.viscosity.laminar",
                "give the kinematic viscosity in m2/s, of water 1e-6",
            ),
            Viscosity::Compact(nu) => {
                let key = "fluid.viscosity.compact";
                self.within(nu, [0.0, 1e6], key, "give the kinematic viscosity in m2/s, of water 1e-6");
                let smooth = fluid.numerics.weight == Weight::Smooth;
                let remedy = "its weight, over the square of the distance, has to stay finite: give \"laminar\", or the weight \"smooth\"";
                self.unless(smooth, key, "does not go with this weight", remedy);
            }
        }
        let numerics = &fluid.numerics;
        self.within(
            numerics.radius,
            [2.0, 6.0],
            "fluid.numerics.radius",
            "give 2 to 6 spacings, usually 3 or 4",
        );
        if let Diffusion::Filter(delta) = numerics.diffusion {
            self.within(
                delta,
                [0.0, 2.0],
                "fluid.numerics.diffusion.filter",
                "give a strength from 0 to 2, usually 0.5",
            );
        }
        self.within(
            numerics.cfl,
            [1e-6, 2.0],
            "fluid.numerics.cfl",
            "give a Courant number from 0 to 2, usually 0.5",
        );
        self.within(
            f64::from(numerics.shifting),
            [0.0, 100.0],
            "fluid.numerics.shifting",
            "give the parts of a shift, usually 5, or 0 for none",
        );
        self.within(
            numerics.background_pressure,
            [0.0, 1e15],
            "fluid.numerics.background_pressure",
            "give a pressure in Pa, 0 with a free surface",
        );
        let most = if numerics.tension == Tension::Keep { 0.03 } else { 0.0 };
        self.within(
            numerics.density_relaxation,
            [0.0, most],
            "fluid.numerics.density_relaxation",
            "give 0 with a free surface, about 0.01 with tension = \"keep\", at most 0.03",
        );
        self.openings(fluid);
        self.unless(
            !fluid.bodies.is_empty(),
            "fluid.bodies",
            "are none",
            "add at least one of [[fluid.bodies]]",
        );
        for (k, body) in fluid.bodies.iter().enumerate() {
            let key = format!("fluid.bodies[{k}]");
            self.region(&body.region, fluid.spacing, &format!("{key}.region"));
            self.vector(&body.velocity, &format!("{key}.velocity"));
            if body.pressure == InitialPressure::ReleasedColumn {
                let down = matches!(gravity, [0.0, g] | [0.0, g, 0.0] if *g < 0.0);
                let good = down && matches!(body.region, Region::Box(_));
                let remedy = "it is that of a box under gravity along -y: give such a region and gravity, or \"hydrostatic\"";
                self.unless(good, &format!("{key}.pressure"), "is \"released_column\"", remedy);
            }
        }
    }

    pub(super) fn wall(&mut self, wall: &Wall, l0: f64, key: &str) {
        self.within(
            wall.fineness,
            [0.25, 1.0],
            &format!("{key}.fineness"),
            "give the spacing of the points over that of the fluid, from 0.25 to 1",
        );
        if wall.fineness > 0.0 && l0 > 0.0 {
            self.wall_shape(&wall.shape, wall.fineness * l0, &format!("{key}.shape"));
        }
        match &wall.motion {
            None => {}
            Some(Motion::Steady(steady)) => {
                self.point(&steady.velocity, &format!("{key}.motion.steady.velocity"));
                self.within(
                    steady.until.unwrap_or(0.0),
                    [0.0, f64::MAX],
                    &format!("{key}.motion.steady.until"),
                    "give a time in seconds, not negative",
                );
            }
            Some(Motion::Oscillation(oscillation)) => {
                self.point(&oscillation.amplitude, &format!("{key}.motion.oscillation.amplitude"));
                self.positive(
                    oscillation.period,
                    &format!("{key}.motion.oscillation.period"),
                    "give the period in seconds",
                );
            }
        }
    }

    pub(super) fn solid(&mut self, solid: &Solid, key: &str) {
        let at = |name: &str| format!("{key}.{name}");
        self.positive(solid.spacing, &at("spacing"), "give the distance of the particles in metres");
        self.positive(solid.density, &at("density"), "give the density in kg/m3, of rubber 1100");
        self.region(&solid.region, solid.spacing, &at("region"));
        let (law, constants) =
            (at(&format!("material.{}", solid.material.key())), solid.material.elasticity());
        self.positive(
            constants.youngs_modulus,
            &format!("{law}.youngs_modulus"),
            "give the modulus in Pa: rubber about 1e7, steel 2e11",
        );
        let nu = constants.poissons_ratio;
        let between = "give a ratio between -1 and 0.5, both excluded: nearly incompressible is 0.49";
        self.unless(nu > -1.0 && nu < 0.5, &format!("{law}.poissons_ratio"), format!("is {nu}"), between);
        let a_box = matches!(solid.region, Region::Box(_));
        match &solid.clamp {
            None => {}
            Some(Clamp::Sides(sides)) => {
                self.sides(sides, &at("clamp.sides"));
                let remedy =
                    "sides are those of a box: give a region to hold instead, clamp = { region = ... }";
                self.unless(a_box, &at("clamp"), "names sides, but the body is no box", remedy);
                self.unless(
                    !sides.is_empty(),
                    &at("clamp"),
                    "names no side",
                    "name one, or leave the clamp out",
                );
            }
            Some(Clamp::Disc(_)) if solid.packing == Filling::Fitted => {}
            Some(Clamp::Disc(disc)) => self.rows(disc, &solid.region, &at("clamp.disc")),
            Some(Clamp::Region(held)) => {
                let before = self.problems.len();
                // It is not filled, and may be as large as one likes.
                self.shape(held, &at("clamp.region"));
                if self.problems.len() == before && !overlap(held, &solid.region) {
                    self.unless(
                        false,
                        &at("clamp.region"),
                        "is outside the body",
                        "let it cover the part of the body that is held",
                    );
                }
            }
        }
        let rows = matches!(solid.clamp, Some(Clamp::Sides(_) | Clamp::Disc(_)));
        let remedy = "rows that begin on a side or a disc are not fitted to the other sides: give a region to hold, clamp = { region = ... }, or leave packing out";
        let held = "is \"fitted\", but the clamp holds rows of a lattice";
        self.unless(!rows || solid.packing == Filling::Lattice, &at("packing"), held, remedy);
        self.within(
            solid.ambient_pressure.unwrap_or(0.0),
            [0.0, 1e15],
            &at("ambient_pressure"),
            "give a pressure in Pa, or leave it out for the background pressure of the fluid",
        );
        self.within(
            solid.damping,
            [0.0, 1e9],
            &at("damping"),
            "give it in 1/s, not negative: about the angular frequency of the slowest swing",
        );
        match &solid.velocity {
            None => {}
            Some(InitialVelocity::Uniform(velocity)) => {
                self.point(velocity, &at("velocity.uniform"));
            }
            Some(InitialVelocity::FirstMode(_)) => {
                let left = solid.clamp == Some(Clamp::Sides(vec![Side::Left]));
                let remedy =
                    "it is that of a box held on its left side: give such a body, or a uniform velocity";
                self.unless(a_box && left, &at("velocity"), "is \"first_mode\"", remedy);
            }
        }
    }
}

/// Whether the boxes around two regions have something in common.
fn overlap(a: &Region, b: &Region) -> bool {
    let (Some(a), Some(b)) = (a.bounds(), b.bounds()) else { return false };
    let apart = |a: &Corners, b: &Corners| a.upper.iter().zip(&b.lower).any(|(high, low)| high < low);
    !apart(&a, &b) && !apart(&b, &a)
}
