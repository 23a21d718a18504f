//! A body that is looked at while it comes to rest, and may be left on the way.

use crate::Failure;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::{ConstitutiveModel, Relaxation, Settled, Solid, SolidParticles};

/// [`Solid::relax`] under gravity \[m/s^2\] alone, with a look before every step. The first look that fails ends the search; the body is then where it
/// was at the start.
///
/// # Errors
/// That of the look, or of the search.
pub fn settle<T: Real, M: ConstitutiveModel<T, 2>>(
    solid: &mut Solid<T, 2, M>,
    parallel: &Parallel,
    gravity: &Vector<T, 2>,
    relaxation: &Relaxation<T>,
    mut look: impl FnMut(&SolidParticles<T, 2>) -> Result<(), Failure>,
) -> Result<Settled<T>, Failure> {
    let mut looked = Ok(());
    let found = solid.relax(
        parallel,
        gravity,
        |particles, load| {
            if looked.is_ok() {
                looked = look(particles);
            }
            if looked.is_err() {
                // The search cannot be called off, and gives up under a load that is no number.
                load.fill(Vector::repeat(T::of(f64::NAN)));
            }
        },
        relaxation,
    );
    looked?;
    Ok(found?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::flag::{Clamp, RUBBER, flag, gravity};

    #[test]
    fn a_look_that_fails_ends_the_search_at_once() {
        let parallel = Parallel::new(1).unwrap();
        let mut solid = flag::<f64>(2, Clamp::Plane, &RUBBER, &parallel).unwrap();
        let start = solid.positions().to_vec();
        let mut looks = 0;
        let found = settle(&mut solid, &parallel, &gravity(), &Relaxation::default(), |_| {
            looks += 1;
            if looks < 7 { Ok(()) } else { Err("enough".into()) }
        });
        assert_eq!(found.unwrap_err().to_string(), "enough");
        assert_eq!(looks, 7);
        assert_eq!(solid.positions(), start);
    }
}
