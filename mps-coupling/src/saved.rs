//! The state of a coupled scene, out of it and into it again.

use crate::scene::Body;
use crate::{Budget, Handed, Interface, Scene};
use mps_fluid::{Push, Viscosity};
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Scene<T, D, K, V, P> {
    /// Saves the state, or restores it into a scene that was built in the same way, with the same structures in the same order. It
    /// goes on with the same bits, for any number of threads.
    ///
    /// There is a state between two steps only: the sub-steps of the structures belong to the step of the fluid around them. After a step that
    /// failed saving is refused, and where a structure has no [`transfer`](crate::Structure::transfer).
    pub fn transfer(&mut self, parallel: &Parallel, transfer: &mut Transfer<'_>) {
        let Self {
            fluid,
            bodies,
            budget,
            substeps,
            broken,
            audit_interval: _,
            min_substeps: _,
            max_substeps: _,
            refuse_contacts: _,
            // Of the bodies as they were added.
            contacts: _,
        } = self;
        transfer.within("fluid", |transfer| fluid.transfer(parallel, transfer));
        transfer.same("structures", bodies.len());
        for (index, body) in bodies.iter_mut().enumerate() {
            transfer.within(&format!("structure {index}"), |transfer| body.transfer(transfer));
        }
        transfer.within("budget", |transfer| budget.transfer(transfer));
        let mut taken = *substeps as u64;
        transfer.value("sub-steps", &mut taken);
        *substeps = taken as usize;
        // A state that can be saved is one that is whole.
        *broken &= !(transfer.is_restoring() && transfer.is_good());
    }
}

impl<T: Real, const D: usize> Body<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // Found anew in every step.
        let Self { structure, interface, range, force, start: _, swept: _ } = self;
        transfer.same("first point of the boundary", range.start);
        transfer.within("body", |transfer| structure.transfer(transfer));
        transfer.within("interface", |transfer| interface.transfer(transfer));
        transfer.array("force", force);
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
        // Whether the books are kept, and about which point, is said where the scene is built.
        let Self { center: _, handed, fluid, residual, audits } = self;
        for (index, handed) in handed.iter_mut().enumerate() {
            transfer.within(&format!("structure {index}"), |transfer| handed.transfer(transfer));
        }
        if let Some(fluid) = fluid {
            transfer_push("fluid", fluid, transfer);
        }
        transfer.value("residual", residual);
        transfer.value("audits", audits);
    }
}

impl<const D: usize> Handed<D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { push, work, off_line, size } = self;
        transfer_push("handed", push, transfer);
        transfer.value("work", work);
        transfer.value("off the lines", off_line);
        transfer.value("size of the impulses", &mut size[0]);
        transfer.value("size of their moments", &mut size[1]);
    }
}

fn transfer_push<const D: usize>(name: &str, push: &mut Push<f64, D>, transfer: &mut Transfer<'_>) {
    let Push { force, moment } = push;
    transfer.within(name, |transfer| {
        transfer.value("impulse", force);
        transfer.value("angular impulse", moment);
    });
}
