//! The words of a post-mortem.

use super::super::World;
use super::super::units::{self, AXES};
use super::particle::Particle;
use super::ring::{Ring, Step};
use super::table::{cells, number, of, table};
use mps_fluid::explain::{Explanation, Neighbor, Other, StepExplanation};
use mps_kernel::{Kernel, Real, Vector};
use mps_solid::explain as solid;

/// Neighbours that are told.
const MOST_NEIGHBORS: usize = 30;

/// What acts on the particle, in the fluid or in a body.
pub(super) fn particle<T: Real, const D: usize, K: Kernel<T>>(
    world: &World<T, D, K>,
    particle: Particle,
    dt: f64,
) -> String {
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

/// A row of a table.
fn row(name: &str, cells: impl IntoIterator<Item = String>) -> Vec<String> {
    [name.to_owned()].into_iter().chain(cells).collect()
}

/// A row for each component of a vector.
fn components<T: Real, const D: usize>(
    name: &str,
    unit: &str,
    v: &Vector<T, D>,
) -> impl Iterator<Item = Vec<String>> {
    v.iter().zip(AXES).map(move |(x, axis)| row(&format!("{name} {axis} [{unit}]"), [of(*x)]))
}

/// Headings of a table of vectors.
fn headed<const D: usize>(first: &str) -> Vec<&str> {
    [first].into_iter().chain(AXES.into_iter().take(D)).chain(["size"]).collect()
}

/// A vector in one cell.
fn place<T: Real, const D: usize>(v: &Vector<T, D>) -> String {
    cells(v)[..D].join(", ")
}

fn fluid_particle<T: Real, const D: usize>(e: &Explanation<T, D>) -> String {
    let state = components("position", "m", &e.position)
        .chain(components("velocity", "m/s", &e.velocity))
        .chain([row("density ratio n/n0 [-]", [of(e.density)]), row("pressure [Pa]", [of(e.pressure)])]);
    let state = table(&["state", "value"], state);
    let terms = e.acceleration.terms().map(|(name, term)| row(name, cells(&term)));
    let total = [row("**sum**", cells(&e.acceleration.total()))];
    let forces = table(&headed::<D>("acceleration by [m/s2]"), terms.into_iter().chain(total));
    let rates = e.density_rate.terms().map(|(name, term)| vec![name.to_owned(), of(term)]);
    let total = [vec!["**sum**".to_owned(), of(e.density_rate.total())]];
    let rates = table(&["rate of n/n0 by [1/s]", "value"], rates.into_iter().chain(total));
    let changes = e.changes.map_or(String::new(), |changes| {
        let rows = [
            row("shift [m]", cells(&changes.shift)),
            row("collisions [m/s]", cells(&changes.collision)),
            row("relaxation of n/n0 [-]", vec![String::new(); D].into_iter().chain([of(changes.relaxation)])),
        ];
        format!("Before that, in the same step:\n\n{}\n", table(&headed::<D>("change by"), rows))
    });
    let neighbors = neighbors(&e.neighbors);
    format!("{state}\n{forces}\n{rates}\n{changes}{neighbors}")
}

fn neighbors<T: Real, const D: usize>(neighbors: &[Neighbor<T, D>]) -> String {
    let rows = neighbors.iter().take(MOST_NEIGHBORS).map(|n| {
        let who = match n.other {
            Other::Fluid(id) => format!("fluid {id}"),
            Other::Wall(a) => format!("wall {a}"),
            Other::Structure(a) => format!("structure {a}"),
        };
        let [offset, velocity, push, shear] = [n.offset, n.velocity, n.push, n.shear].map(|v| place(&v));
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

fn solid_particle<T: Real, const D: usize>(e: &solid::Explanation<T, D>) -> String {
    let stress = (0..D * D).map(|k| {
        let (a, b) = (k / D, k % D);
        row(&format!("stress P{}{} [Pa]", AXES[a], AXES[b]), [of(e.stress[(a, b)])])
    });
    let state = components("position", "m", &e.position)
        .chain(components("reference", "m", &e.reference))
        .chain(components("velocity", "m/s", &e.velocity))
        .chain([
            row("volume ratio det F [-]", [of(e.volume_ratio)]),
            row("largest stretch [-]", [of(e.stretches[0])]),
            row("smallest stretch [-]", [of(e.stretches[D - 1])]),
        ])
        .chain(stress);
    let state = table(&["state", "value"], state);
    let pairs = e.pairs.iter().map(|pair| {
        row(
            &pair.id.to_string(),
            [place(&pair.offset), of(pair.stretch)].into_iter().chain(cells(&pair.force)),
        )
    });
    let blank = [String::new(), String::new()];
    let sum = [row("**sum**", blank.into_iter().chain(cells(&e.force())))];
    let force = format!("force x [{}]", units::force::<D>());
    let headings: Vec<&str> = ["neighbour", "offset [m]", "stretch [-]", &force]
        .into_iter()
        .chain(headed::<D>("").split_off(2))
        .collect();
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
pub(super) fn steps<const D: usize>(ring: &Ring) -> String {
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
    let [energy, kinetic] = ["energy", "kinetic"].map(|name| format!("{name} [{}]", units::energy::<D>()));
    let headings = ["step", "t [s]", "dt [s]", "limit", &energy, &kinetic, "fastest", "largest pressure"];
    table(&headings, rows)
}
