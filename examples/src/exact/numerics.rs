//! What of the numerics of a problem can be chosen; the rest is as the problem has it.

use super::case::{Outcome, Pace};
use crate::scene::Viscous;
use crate::{Failure, Precision, Refused, Watch};
use clap::{Args, ValueEnum};
use mps_fluid::{Diffusion, Dpc, FluidConfig, PressureForm, Shifting};
use mps_io::Summary;
use mps_io::scene_file::{Viscosity, Weight};
use mps_kernel::weights::{Rational, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Real, ReferenceDensity};
use mps_neighbors::Parallel;
use std::sync::Arc;

/// Flags for the numerics of an exact problem. What is left out is as `validate` has it.
#[derive(Args, Clone, Debug, Default)]
pub struct Numerics {
    /// Weight of the particle sums: smooth, rational or wendland
    #[arg(long, value_name = "NAME", value_parser = weight)]
    pub weight: Option<Weight>,
    /// Effective radius over the spacing; 4 at most, as deep as the walls are
    #[arg(long, value_name = "RATIO")]
    pub radius: Option<f64>,
    /// Numerical sound speed over the speed of the problem
    #[arg(long, value_name = "RATIO")]
    pub sound_ratio: Option<f64>,
    /// Courant number
    #[arg(long, value_name = "C")]
    pub cfl: Option<f64>,
    /// Strength of the density diffusion; 0 switches it off
    #[arg(long, value_name = "DELTA")]
    pub diffusion: Option<f64>,
    /// Shift the particles towards an even distribution, in K parts a step; 0 does not
    #[arg(long, value_name = "K")]
    pub shifting: Option<u32>,
    /// Strength of the shifting, whatever its parts
    #[arg(long, value_name = "FACTOR")]
    pub shifting_strength: Option<f64>,
    /// Collisions between close particles
    #[arg(long)]
    pub dpc: bool,
    /// Correct pressure gradient and divergence by the moment matrix of each particle
    #[arg(long, conflicts_with = "plain")]
    pub corrected: bool,
    /// Do not correct them
    #[arg(long)]
    pub plain: bool,
    /// Form of the viscosity, whose size stays
    #[arg(long, value_enum)]
    pub viscosity: Option<Form>,
}

/// Form of a viscosity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// Laplacian of the velocity
    Laminar,
    /// The same between near neighbours
    Compact,
    /// Along the line of each pair
    Artificial,
}

/// A weight by its name in scene files.
fn weight(name: &str) -> Result<Weight, String> {
    match name {
        "smooth" => Ok(Weight::Smooth),
        "rational" => Ok(Weight::Rational),
        "wendland" => Ok(Weight::Wendland),
        _ => Err("give smooth, rational or wendland".to_owned()),
    }
}

impl Numerics {
    /// Refuses what no problem can be run with; what only some cannot be is refused where they are built.
    ///
    /// # Errors
    /// Names the flag, its value and what is allowed.
    pub fn check(&self) -> Result<(), Refused> {
        let within = |flag, value: Option<f64>, [low, high]: [f64; 2], remedy: &str| {
            let value = value.unwrap_or(low);
            Refused::unless((low..=high).contains(&value), flag, value, remedy)
        };
        within("--radius", self.radius, [2.0, 4.0], "give an effective radius between 2 and 4 spacings")?;
        let remedy = "give the sound speed over that of the flow, usually 10, between 1 and 1000";
        within("--sound-ratio", self.sound_ratio, [1.0, 1000.0], remedy)?;
        within("--cfl", self.cfl, [1e-3, 2.0], "give a Courant number between 0.001 and 2, e.g. 0.5")?;
        within("--diffusion", self.diffusion, [0.0, 2.0], "give a strength between 0 and 2, e.g. 0.5")?;
        let remedy = "give a factor between 0 and 10, usually 2";
        within("--shifting-strength", self.shifting_strength, [0.0, 10.0], remedy)?;
        Refused::unless_few_shifts(self.shifting.unwrap_or(0))
    }

    /// Writes what has been chosen into a summary.
    pub fn enter(&self, summary: &mut Summary) {
        let numbers = [
            ("radius", self.radius),
            ("sound_ratio", self.sound_ratio),
            ("cfl", self.cfl),
            ("diffusion", self.diffusion),
            ("shifting", self.shifting.map(f64::from)),
            ("shifting_strength", self.shifting_strength),
        ];
        for (name, value) in numbers {
            if let Some(value) = value {
                summary.set(name, value);
            }
        }
        for (name, on) in [("dpc", self.dpc), ("corrected", self.corrected), ("plain", self.plain)] {
            if on {
                summary.set(name, on);
            }
        }
        if let Some(weight) = self.weight {
            summary.set("weight", weight);
        }
        if let Some(form) = self.viscosity {
            summary.set("viscosity", format!("{form:?}").to_lowercase());
        }
    }

    /// Changes what has been chosen.
    pub(super) fn apply<T: Real, const D: usize>(&self, config: &mut FluidConfig<T, D>) {
        config.radius_ratio = self.radius.map_or(config.radius_ratio, T::of);
        config.cfl = self.cfl.map_or(config.cfl, T::of);
        config.diffusion = self.diffusion.map_or(config.diffusion, Diffusion::filter);
        if self.dpc {
            config.collisions = Some(Dpc::default());
        }
        if self.corrected {
            config.pressure_form = PressureForm::Corrected;
        }
        if self.plain {
            config.pressure_form = PressureForm::Plain;
        }
        if let Some(iterations) = self.shifting {
            let own = config.shifting.unwrap_or_default();
            config.shifting = (iterations > 0).then_some(Shifting { iterations, ..own });
        }
        if let (Some(strength), Some(shifting)) = (self.shifting_strength, &mut config.shifting) {
            shifting.strength = T::of(strength);
        }
    }

    /// The viscosity of a problem in the form that has been chosen.
    pub(super) fn viscous<T: Real, const D: usize>(
        &self,
        own: Viscosity,
        config: &FluidConfig<T, D>,
        reference: &ReferenceDensity<T>,
    ) -> Viscous<T> {
        // An artificial one of 1 (`ArtificialViscosity`) in m2/s.
        let unit = (config.sound_speed * config.spacing).to_double() / (2.0 * (D as f64 + 2.0));
        let chosen = self.viscosity.map_or(own, |form| in_form(form, own, unit));
        Viscous::new::<D>(&chosen, config.sound_speed, reference)
    }
}

/// A viscosity of the same size in another form, if it is not of this form. `unit`: an artificial one of 1 \[m^2/s\].
fn in_form(form: Form, own: Viscosity, unit: f64) -> Viscosity {
    let size = match own {
        Viscosity::None => return own,
        Viscosity::Artificial(alpha) => alpha * unit,
        Viscosity::Laminar(nu) | Viscosity::Compact(nu) => nu,
    };
    match (form, own) {
        (Form::Artificial, Viscosity::Artificial(_)) => own,
        (Form::Artificial, _) => Viscosity::Artificial(size / unit),
        (Form::Laminar, _) => Viscosity::Laminar(size),
        (Form::Compact, _) => Viscosity::Compact(size),
    }
}

/// With which numerics and in which precision a problem is solved.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The numerics.
    pub numerics: Numerics,
    /// The scalar type.
    pub precision: Precision,
    /// Who may want the run to end.
    pub watch: Arc<Watch>,
}

impl Default for Choice {
    /// As `validate` has it.
    fn default() -> Self {
        Self { numerics: Numerics::default(), precision: Precision::F64, watch: Arc::new(Watch::nobody()) }
    }
}

/// A problem that can be solved with any scalar type and weight.
pub(super) trait Problem {
    /// As [`Case::run`](super::Case::run).
    fn solve<T: Real, K: Kernel<T>>(
        &self,
        weight: K,
        resolution: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure>;
}

impl Choice {
    /// Solves a problem whose own weight is `own`.
    pub(super) fn solve(
        &self,
        own: Weight,
        problem: &impl Problem,
        n: usize,
        pace: Pace,
        parallel: &Parallel,
    ) -> Result<Outcome, Failure> {
        let weight = self.numerics.weight.unwrap_or(own);
        match self.precision {
            Precision::F32 => with_weight::<f32>(weight, problem, n, pace, parallel),
            Precision::F64 => with_weight::<f64>(weight, problem, n, pace, parallel),
        }
    }
}

fn with_weight<T: Real>(
    weight: Weight,
    problem: &impl Problem,
    n: usize,
    pace: Pace,
    parallel: &Parallel,
) -> Result<Outcome, Failure> {
    match weight {
        Weight::Smooth => problem.solve::<T, _>(WendlandGradient, n, pace, parallel),
        Weight::Rational => problem.solve::<T, _>(Rational, n, pace, parallel),
        Weight::Wendland => problem.solve::<T, _>(WendlandC2, n, pace, parallel),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_form_of_a_viscosity_changes_and_its_size_stays() {
        let unit = 0.25;
        assert_eq!(in_form(Form::Laminar, Viscosity::Artificial(0.2), unit), Viscosity::Laminar(0.05));
        assert_eq!(in_form(Form::Artificial, Viscosity::Compact(0.05), unit), Viscosity::Artificial(0.2));
        assert_eq!(in_form(Form::Artificial, Viscosity::Artificial(0.3), unit), Viscosity::Artificial(0.3));
        assert_eq!(in_form(Form::Compact, Viscosity::None, unit), Viscosity::None);
    }

    #[test]
    fn only_what_is_chosen_is_changed() {
        let own = FluidConfig::<f64, 2>::water(0.1, 10.0);
        let with = |numerics: Numerics| {
            let mut config = own.clone();
            numerics.apply(&mut config);
            config
        };
        assert_eq!(with(Numerics::default()), own);
        let numerics = Numerics { diffusion: Some(0.0), shifting: Some(3), ..Numerics::default() };
        let shifting = Some(Shifting { iterations: 3, ..Shifting::default() });
        assert_eq!(with(numerics), FluidConfig { diffusion: Diffusion::None, shifting, ..own.clone() });
        // A strength without shifting is none.
        assert_eq!(with(Numerics { shifting_strength: Some(3.0), ..Numerics::default() }), own);
    }

    #[test]
    fn what_cannot_be_run_is_refused() {
        let refused = |numerics: Numerics| numerics.check().is_err();
        assert!(!refused(Numerics::default()));
        assert!(refused(Numerics { radius: Some(5.0), ..Numerics::default() }));
        assert!(refused(Numerics { cfl: Some(f64::NAN), ..Numerics::default() }));
        assert!(refused(Numerics { shifting: Some(1000), ..Numerics::default() }));
    }
}
