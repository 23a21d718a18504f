//! The state of a coupled scene, out of it and into it again.

use crate::scene::Body;
use crate::{Budget, Interface, Scene};
use mps_fluid::Viscosity;
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Scene<T, D, K, V, P> {
    /// Saves the state, or restores it into a scene that was built in the same way, with the same structures in the same order. It
    /// goes on with the same bits, for any number of threads.
    ///
    /// There is a state between two steps only: the sub-steps of the structures belong to the step of the fluid around them. After a step that
    /// failed saving is refused, and where a structure has no [`transfer`](crate::Structure::transfer).
    pub fn transfer(&mut self, parallel: &Parallel, transfer: &mut Transfer<'_>) {
        let Self { fluid, bodies, budget, substeps, audit_interval: _, min_substeps: _, max_substeps: _ } =
            self;
        transfer.within("fluid", |transfer| fluid.transfer(parallel, transfer));
        transfer.same("structures", bodies.len());
        for (index, body) in bodies.iter_mut().enumerate() {
            transfer.within(&format!("structure {index}"), |transfer| body.transfer(transfer));
        }
        transfer.within("budget", |transfer| budget.transfer(transfer));
        let mut taken = *substeps as u64;
        transfer.value("sub-steps", &mut taken);
        *substeps = taken as usize;
    }
}

impl<T: Real, const D: usize> Body<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // The start of a step is taken anew in every step.
        let Self { structure, interface, range, force, start: _, impulse } = self;
        transfer.same("first point of the boundary", range.start);
        transfer.within("body", |transfer| structure.transfer(transfer));
        transfer.within("interface", |transfer| interface.transfer(transfer));
        transfer.array("force", force);
        transfer.value("impulse", impulse);
    }
}

impl<T: Real, const D: usize> Interface<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // Registered once, from the undeformed body.
        let Self { surface: _, normal, wetted, visible: _, rows: _, radius: _ } = self;
        transfer.array("normal", normal);
        transfer.flags("wetted", wetted);
    }
}

impl<T: Real, const D: usize> Budget<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { impulse, work, residual, audits } = self;
        transfer.value("impulse", impulse);
        transfer.value("work", work);
        transfer.value("residual", residual);
        transfer.value("audits", audits);
    }
}
