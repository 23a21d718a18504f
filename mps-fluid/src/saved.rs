//! The state of a fluid, out of it and into it again.

use crate::budget::Books;
use crate::exchange::Exchange;
use crate::open::OpenBoundaries;
use crate::rates::Rates;
use crate::terms::Viscosity;
use crate::turn::{Stage, Turn};
use crate::{Boundary, EnergyBudget, Fluid, Limit};
use mps_kernel::{Kernel, Real, Transfer};
use mps_neighbors::{Domain, Parallel};

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Saves the state, or restores it into a fluid that was built in the same way: with the same parameters, walls and openings, and
    /// books if it had some. It goes on with the same bits, for any number of threads.
    ///
    /// Refused between [`begin_step`](Self::begin_step) and [`finish_step`](Self::finish_step), and after a step that failed: the particles are
    /// then neither before nor after it. Restored are only values; parameters, and the speeds of inlets, are those of the new fluid, but for the
    /// Courant number, which may have been changed on the way: to go on with another one, set it afterwards.
    pub fn transfer(&mut self, parallel: &Parallel, transfer: &mut Transfer<'_>) {
        let Self {
            config,
            kernel: _,
            viscosity: _,
            domain,
            reference: _,
            eos: _,
            particles,
            boundary,
            search,
            rates,
            exchange,
            open,
            books,
            time,
            steps,
            last_dt,
            limit,
            stable_courant: _,
            compressibility,
            compressibility_seen,
            turn,
            starts: _,
        } = self;
        if turn.stage != Stage::Between && !transfer.is_restoring() {
            transfer.refuse("a step has begun and is not finished: save the state between two steps");
        }
        transfer.within("particles", |transfer| transfer.particles(particles));
        transfer.within("boundary", |transfer| boundary.transfer(transfer));
        transfer.within("rows", |transfer| search.transfer(parallel, domain, boundary, transfer));
        transfer.same("open boundaries", usize::from(open.is_some()));
        if let Some(open) = open {
            transfer.within("open", |transfer| open.transfer(transfer));
        }
        transfer.same("books", usize::from(books.is_some()));
        if let Some(books) = books {
            transfer.within("books", |transfer| books.transfer(transfer));
        }
        transfer.within("time", |transfer| time.transfer(transfer));
        transfer.value("steps", steps);
        transfer.value("last step", last_dt);
        transfer.value("Courant number", &mut config.cfl);
        transfer.within("limit", |transfer| limit.transfer(transfer));
        for (name, both) in [("", compressibility), ("largest ", compressibility_seen)] {
            transfer.value(&format!("{name}Mach number"), &mut both.mach);
            transfer.value(&format!("{name}density deviation"), &mut both.density);
        }
        if transfer.is_restoring() {
            // Found anew in every step.
            *rates = Rates::default();
            rates.resize(particles.position.len());
            *exchange = Exchange::default();
            *turn = Turn::default();
        }
    }
}

impl Limit {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let known = [Self::Sound, Self::Viscosity, Self::Acceleration, Self::Diffusion];
        let mut number = known.iter().position(|limit| limit == self).map_or(0, |k| k as u64);
        transfer.value("number", &mut number);
        match known.get(number as usize) {
            Some(limit) => *self = *limit,
            None => transfer.refuse(format!("there is no limit of the step with the number {number}")),
        }
    }
}

impl<T: Real, const D: usize> Boundary<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { position, velocity, acceleration, volume, shear: _, force, reactive, too_late: _ } = self;
        transfer.array("position", position);
        transfer.array("velocity", velocity);
        transfer.array("acceleration", acceleration);
        transfer.array("volume", volume);
        transfer.array("force", force);
        transfer.same("first reactive point", reactive.start);
        transfer.same("end of the reactive points", reactive.end);
    }
}

impl<T: Real, const D: usize> OpenBoundaries<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // What the speeds have changed by, and who leaves, is of the present step.
        let Self { inlets, outlets, beyond, speed, change: _, leaving: _, inflow, next_id, passed } = self;
        transfer.same("inlets", inlets.len());
        transfer.same("outlets", outlets.len());
        transfer.array("pressure beyond", beyond);
        transfer.array("speed", speed);
        transfer.value("inflow", inflow);
        transfer.value("next id", next_id);
        transfer.array("passed", passed);
    }
}

impl<T: Real, const D: usize> Books<T, D> {
    fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        // Of the present step: accelerations from outside that have not acted yet, and working space.
        let Self { budget, field, power: _ } = self;
        let EnergyBudget { viscosity, diffusion, collisions, shifting, relaxation, boundary, field: outside } =
            budget;
        transfer.value("viscosity", viscosity);
        transfer.value("diffusion", diffusion);
        transfer.value("collisions", collisions);
        transfer.value("shifting", shifting);
        transfer.value("relaxation", relaxation);
        transfer.value("boundary", boundary);
        transfer.value("field", outside);
        transfer.list("field of the step", field);
    }
}
