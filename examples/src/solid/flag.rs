//! The flag of Turek and Hron (2006) without the water: behind a cylinder, under its own weight.

use super::rows::begin_at;
use crate::Failure;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Centre of the cylinder \[m\].
pub const CYLINDER: [f64; 2] = [0.2, 0.2];
/// Radius of the cylinder \[m\].
pub const RADIUS: f64 = 0.05;
/// End point A of the flag \[m\].
pub const END: [f64; 2] = [0.6, 0.2];
/// Length of the flag on its middle line \[m\].
pub const LENGTH: f64 = 0.35;
/// Its thickness \[m\].
pub const THICKNESS: f64 = 0.02;
/// Density \[kg/m^3\].
pub const DENSITY: f64 = 1000.0;
/// Young's modulus \[Pa\]: a shear modulus of 0.5 MPa.
pub const YOUNG: f64 = 1.4e6;
/// Poisson's ratio.
pub const POISSON: f64 = 0.4;
/// Gravity \[m/s^2\].
pub const GRAVITY: [f64; 2] = [0.0, -2.0];
/// Where the numbers are from.
pub const SOURCE: &str = "Turek and Hron 2006 (finite elements)";
/// CSM1: displacement of A at rest \[m\].
pub const CSM1: [f64; 2] = [-7.187e-3, -66.10e-3];
/// CSM3: mean and amplitude \[m\] and frequency \[Hz\] of the displacement of A, along x and y.
pub const CSM3: [[f64; 3]; 2] = [[-14.305e-3, 14.305e-3, 1.0995], [-63.607e-3, 65.160e-3, 1.0995]];
/// The same of the first whole swing: mean and amplitude \[m\] along x and y, from the FEATFLOW series of Turek and Hron's
/// benchmark data (level 4, time step 0.005 s). In that series mean and amplitude along x fall from 14.65 to 14.31 mm within ten
/// swings, and the published values are those of the tenth. That its time integration damps the second mode is
/// our inference.
pub const CSM3_FIRST: [[f64; 2]; 2] = [[-14.651e-3, 14.651e-3], [-64.900e-3, 64.828e-3]];
/// The end of that swing \[s\].
pub const CSM3_FIRST_END: f64 = 1.65;

/// The flag.
pub type Flag<T> = Solid<T, 2, SaintVenantKirchhoff<T>>;

/// What the flag is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rubber {
    /// Density \[kg/m^3\].
    pub density: f64,
    /// Young's modulus \[Pa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// The material of the structural tests.
pub const RUBBER: Rubber = Rubber { density: DENSITY, young: YOUNG, poisson: POISSON };

/// Where the flag is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Clamp {
    /// On the surface of the cylinder, as drawn
    Arc,
    /// On the plane x = 0.25 m that touches the cylinder
    Plane,
}

impl Clamp {
    /// As in the flag and in summaries.
    pub fn name(self) -> &'static str {
        match self {
            Self::Arc => "arc",
            Self::Plane => "plane",
        }
    }

    /// Where the line of the flag at `y` \[m\] begins.
    fn start(self, y: f64) -> f64 {
        let off = y - CYLINDER[1];
        match self {
            Self::Arc => CYLINDER[0] + (RADIUS * RADIUS - off * off).sqrt(),
            Self::Plane => END[0] - LENGTH,
        }
    }
}

/// The flag at rest and undeformed.
///
/// Its particles are those of a block whose lines are stretched, each by itself, until they begin at the clamp: by up
/// to 0.3 % for the arc. The first of each line is on the clamp and has half a volume, as in a block.
///
/// # Errors
/// If the numbers do not make a body.
pub fn flag<T: Real>(
    across: usize,
    clamp: Clamp,
    rubber: &Rubber,
    parallel: &Parallel,
) -> Result<Flag<T>, Failure> {
    let material = SaintVenantKirchhoff::new(T::of(rubber.young), T::of(rubber.poisson))?;
    flag_of(across, clamp, rubber.density, material, parallel)
}

/// The flag of any material.
///
/// # Errors
/// If the numbers do not make a body.
pub fn flag_of<T: Real, M: ConstitutiveModel<T, 2>>(
    across: usize,
    clamp: Clamp,
    density: f64,
    material: M,
    parallel: &Parallel,
) -> Result<Solid<T, 2, M>, Failure> {
    let held = [Face::lower(0)];
    let [lower, upper] = corners().map(|corner| Vector::from(corner.map(T::of)));
    let mut counts = body::counts(&lower, &upper, T::of(THICKNESS / across as f64), &held);
    counts[1] = across;
    let block = body::block(lower, upper, counts, &held)?;
    let particles = begin_at(&block, &lower, &upper, |y| clamp.start(y));
    let config = SolidConfig::default();
    Ok(Solid::new(particles, block.spacing, T::of(density), material, WendlandC2, config, parallel)?)
}

/// Lower left and upper right corner of the flag from the plane on that touches the cylinder \[m\].
pub fn corners() -> [[f64; 2]; 2] {
    let half = 0.5 * THICKNESS;
    [[END[0] - LENGTH, END[1] - half], [END[0], END[1] + half]]
}

/// The end point A.
pub fn end<T: Real>() -> Vector<T, 2> {
    Vector::from(END.map(T::of))
}

/// Gravity \[m/s^2\].
pub fn gravity<T: Real>() -> Vector<T, 2> {
    Vector::from(GRAVITY.map(T::of))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clamped_particles_are_on_the_cylinder_and_the_volume_is_that_of_the_drawing() {
        let flag = flag::<f64>(8, Clamp::Arc, &RUBBER, &Parallel::serial()).unwrap();
        let particles = flag.particles();
        let on_arc = |i: &usize| {
            let x = particles.reference_positions()[*i];
            ((x - Vector::from(CYLINDER)).norm() - RADIUS).abs() < 1e-12
        };
        assert_eq!((0..flag.len()).filter(on_arc).count(), 8);
        assert!((0..flag.len()).all(|i| on_arc(&i) == particles.is_clamped(i)));
        // What is between the plane and the arc: h L + int (r - sqrt(r^2 - y^2)) dy = h^3/(24 r) to first order.
        let exact = THICKNESS * LENGTH + THICKNESS.powi(3) / (24.0 * RADIUS);
        let volume: f64 = flag.volumes().iter().sum();
        assert!((volume / exact - 1.0).abs() < 1e-4, "{volume} {exact}");
    }
}
