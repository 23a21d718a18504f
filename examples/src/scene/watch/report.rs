//! The words of a post-mortem.

use super::super::World;
use super::particle::Particle;
use super::ring::{Ring, Step};
use super::table::{cells, number, of, table};
use mps_fluid::explain::{Explanation, Neighbor, Other, StepExplanation};
use mps_kernel::{Kernel, Real};
use mps_solid::explain as solid;

/// Neighbours that are told.
const MOST_NEIGHBORS: usize = 30;

/// What acts on the particle, in the fluid or in a body.
pub(super) fn particle<T: Real, K: Kernel<T>>(world: &World<T, K>, particle: Particle, dt: f64) -> String {
    let found = match particle {
        Particle::Fluid(id) => world.fluid().and_then(|fluid| {
            let i = fluid.particles().id.iter().position(|other| *other == id)?;
            Some(fluid_particle(&fluid.explain(i, T::of(dt))?))
        }),
        Particle::Solid { body, id } => world.solid(body).and_then(|solid| {
            let i = solid.particles().ids().iter().position(|other| *other == id)?;
            Some(solid_particle(&solid.explain(i)?))
        }),
    };
    found.unwrap_or_else(|| format!("{particle} could not be explained: it is no longer there.\n"))
}

fn fluid_particle<T: Real>(e: &Explanation<T, 2>) -> String {
    let state = [
        ("position x [m]", e.position[0]),
        ("position y [m]", e.position[1]),
        ("velocity x [m/s]", e.velocity[0]),
        ("velocity y [m/s]", e.velocity[1]),
        ("density ratio n/n0 [-]", e.density),
        ("pressure [Pa]", e.pressure),
    ];
    let state = table(&["state", "value"], state.map(|(name, value)| vec![name.to_owned(), of(value)]));
    let row = |name: &str, cells: [String; 3]| [vec![name.to_owned()], cells.into()].concat();
    let terms = e.acceleration.terms().map(|(name, term)| row(name, cells(&term)));
    let total = [row("**sum**", cells(&e.acceleration.total()))];
    let forces = table(&["acceleration by [m/s2]", "x", "y", "size"], terms.into_iter().chain(total));
    let rates = e.density_rate.terms().map(|(name, term)| vec![name.to_owned(), of(term)]);
    let total = [vec!["**sum**".to_owned(), of(e.density_rate.total())]];
    let rates = table(&["rate of n/n0 by [1/s]", "value"], rates.into_iter().chain(total));
    let changes = e.changes.map_or(String::new(), |changes| {
        let rows = [
            row("shift [m]", cells(&changes.shift)),
            row("collisions [m/s]", cells(&changes.collision)),
            row("relaxation of n/n0 [-]", [String::new(), String::new(), of(changes.relaxation)]),
        ];
        format!("Before that, in the same step:\n\n{}\n", table(&["change by", "x", "y", "size"], rows))
    });
    let neighbors = neighbors(&e.neighbors);
    format!("{state}\n{forces}\n{rates}\n{changes}{neighbors}")
}

fn neighbors<T: Real>(neighbors: &[Neighbor<T, 2>]) -> String {
    let rows = neighbors.iter().take(MOST_NEIGHBORS).map(|n| {
        let who = match n.other {
            Other::Fluid(id) => format!("fluid {id}"),
            Other::Wall(a) => format!("wall {a}"),
            Other::Structure(a) => format!("structure {a}"),
        };
        let [offset, velocity, push, shear] = [n.offset, n.velocity, n.push, n.shear].map(|v| {
            let [x, y, _] = cells(&v);
            format!("{x}, {y}")
        });
        vec![who, of(n.distance), offset, velocity, of(n.density), of(n.pressure), push, shear]
    });
    let headings = [
        "neighbour",
        "distance [m]",
        "offset [m]",
        "velocity [m/s]",
        "n/n0 [-]",
        "p [Pa]",
        "push [m/s2]",
        "shear [m/s2]",
    ];
    let shown = neighbors.len().min(MOST_NEIGHBORS);
    format!("The {shown} nearest of {} neighbours:\n\n{}", neighbors.len(), table(&headings, rows))
}

fn solid_particle<T: Real>(e: &solid::Explanation<T, 2>) -> String {
    let state = [
        ("position x [m]", e.position[0]),
        ("position y [m]", e.position[1]),
        ("reference x [m]", e.reference[0]),
        ("reference y [m]", e.reference[1]),
        ("velocity x [m/s]", e.velocity[0]),
        ("velocity y [m/s]", e.velocity[1]),
        ("volume ratio det F [-]", e.volume_ratio),
        ("largest stretch [-]", e.stretches[0]),
        ("smallest stretch [-]", e.stretches[1]),
        ("stress Pxx [Pa]", e.stress[(0, 0)]),
        ("stress Pxy [Pa]", e.stress[(0, 1)]),
        ("stress Pyx [Pa]", e.stress[(1, 0)]),
        ("stress Pyy [Pa]", e.stress[(1, 1)]),
    ];
    let state = table(&["state", "value"], state.map(|(name, value)| vec![name.to_owned(), of(value)]));
    let pairs = e.pairs.iter().map(|pair| {
        let [x, y, size] = cells(&pair.force);
        let [dx, dy, _] = cells(&pair.offset);
        vec![pair.id.to_string(), format!("{dx}, {dy}"), of(pair.stretch), x, y, size]
    });
    let total = cells(&e.force());
    let blank = || String::new();
    let sum = [[vec!["**sum**".to_owned(), blank(), blank()], total.into()].concat()];
    let headings = ["neighbour", "offset [m]", "stretch [-]", "force x [N/m]", "y", "size"];
    let pairs = table(&headings, pairs.chain(sum));
    format!("As it was before what failed:\n\n{state}\n{pairs}")
}

/// The limits of the step, and who sets them.
pub(super) fn limits<T: Real>(step: &StepExplanation<T>) -> String {
    let limits = step.limits;
    let row = |name: &str, dt: T, by: String| {
        let acts = if name == step.limit.name() { "**acts**" } else { "" };
        vec![name.to_owned(), of(dt), by, acts.to_owned()]
    };
    let ((fastest, v), (driven, a)) = (step.fastest, step.most_accelerated);
    let rows = [
        row("sound", limits.sound, format!("fluid particle {fastest}, {} m/s", of(v))),
        row("viscosity", limits.viscosity, String::new()),
        row("acceleration", limits.acceleration, format!("fluid particle {driven}, {} m/s2", of(a))),
        row("diffusion", limits.diffusion, String::new()),
    ];
    table(&["limit", "step [s]", "by", ""], rows)
}

/// The last steps, with time and length to the last bit.
pub(super) fn steps(ring: &Ring) -> String {
    let rows = ring.steps().iter().map(|step| {
        let Step { count, time, dt, limit, energy, kinetic, fastest, pressure } = step;
        vec![
            count.to_string(),
            format!("{time:e}"),
            format!("{dt:e}"),
            limit.map_or("", |limit| limit.name()).to_owned(),
            if energy.is_nan() { String::new() } else { number(*energy) },
            number(*kinetic),
            format!("{}, {} m/s", fastest.0, number(fastest.1)),
            format!("fluid particle {}, {} Pa", pressure.0, number(pressure.1)),
        ]
    });
    let headings =
        ["step", "t [s]", "dt [s]", "limit", "energy [J/m]", "kinetic [J/m]", "fastest", "largest pressure"];
    table(&headings, rows)
}
