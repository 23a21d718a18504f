//! The state of a solid, out of it and into it again.

use crate::{ConstitutiveModel, Solid};
use mps_kernel::{Kernel, Real, Transfer};

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Saves the state, or restores it into a body that was built in the same way: of the same particles and material, with the
    /// same moved supports. It goes on with the same bits, for any number of threads.
    ///
    /// Deformations and forces are saved as well: found again they would let the material age by a visit that never was.
    pub fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self {
            particles,
            history,
            material: _,
            pairs: _,
            correction: _,
            kappa: _,
            kernel: _,
            config: _,
            spacing: _,
            wave_speed: _,
            stability_limit,
            mean_velocity,
            remainder,
            time,
            motions,
            placements: _,
            stale,
            inner: _,
            before: _,
            remembered: _,
            next: _,
        } = self;
        transfer.within("particles", |transfer| transfer.fixed_particles(particles));
        transfer.array("history", history);
        transfer.array("mean velocity", mean_velocity);
        transfer.array("remainder", remainder);
        transfer.value("stability limit", stability_limit);
        transfer.within("time", |transfer| time.transfer(transfer));
        transfer.flag("stale", stale);
        transfer.same("moved supports", motions.len());
        if transfer.is_restoring() {
            self.place_supports(self.time.now());
        }
    }
}
