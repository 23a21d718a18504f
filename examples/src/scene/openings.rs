//! Inlets and outlets from their description, which exist in two dimensions only.

use super::lattice::{Place, fill};
use super::vector;
use mps_fluid as physics;
use mps_io::scene_file::{Corners, Fluid, Inlet, Outlet, Region, Side};
use mps_kernel::{Real, Vector};

fn opening<T: Real, const D: usize>(
    Corners { lower, upper }: &Corners,
    toward: Side,
) -> physics::Opening<T, D> {
    let axis = toward.axis();
    let (lower, upper) = (vector::<T, D>(lower), vector::<T, D>(upper));
    physics::Opening { axis, at: lower[axis], forward: toward.is_upper(), lower, upper }
}

pub(super) fn inlet<T: Real, const D: usize>(inlet: &Inlet) -> physics::Inlet<T, D> {
    let Inlet { opening: corners, toward, mean_speed: mean, profile, ramp } = inlet.clone();
    let side = 1 - toward.axis();
    let (low, width) = (corners.lower[side], corners.upper[side] - corners.lower[side]);
    let speed = move |place: &Vector<T, D>, time: T| {
        let time = time.to_double();
        let risen = if time < ramp { 0.5 * (1.0 - (core::f64::consts::PI * time / ramp).cos()) } else { 1.0 };
        T::of(risen * mean * profile.at((place[side].to_double() - low) / width))
    };
    physics::Inlet::new(opening(&corners, toward), speed)
}

/// In a fluid of this background pressure \[Pa\].
pub(super) fn outlet<T: Real, const D: usize>(outlet: &Outlet, background: f64) -> physics::Outlet<T, D> {
    let Outlet { opening: corners, toward, pressure, absorbing } = outlet;
    physics::Outlet {
        opening: opening(corners, *toward),
        pressure: T::of(pressure.unwrap_or(background)),
        absorbing: *absorbing,
    }
}

/// What lies behind the plane of an opening: the stack of points of an inlet, the zone of an outlet.
#[derive(Clone, Debug)]
pub struct Behind<const D: usize> {
    /// Key of the opening in the file.
    pub key: String,
    /// Its points at the start \[m\].
    pub places: Vec<Place<D>>,
    /// The two ends \[m\] up to which walls have to stand beside it.
    pub ends: [Place<D>; 2],
    /// How far those are from the plane \[m\].
    pub depth: f64,
}

/// All of them, inlets first.
pub(super) fn behind<const D: usize>(fluid: &Fluid) -> Vec<Behind<D>> {
    let (l0, radius) = (fluid.spacing, fluid.numerics.radius);
    let inlets = fluid.inlets.iter().enumerate().map(|(k, inlet)| {
        // Against the way of the fluid.
        let layers = radius.ceil() + 1.0;
        part(format!("fluid.inlets[{k}]"), &inlet.opening, inlet.toward, [-layers * l0; 2], l0)
    });
    let outlets = fluid.outlets.iter().enumerate().map(|(k, outlet)| {
        let layers = (2.0 * radius + 1.0).floor();
        let depths = [layers * l0, (layers + radius) * l0];
        part(format!("fluid.outlets[{k}]"), &outlet.opening, outlet.toward, depths, l0)
    });
    inlets.chain(outlets).collect()
}

/// From the plane to the first depth, counted along the way of the fluid, and with walls to the second \[m\].
fn part<const D: usize>(
    key: String,
    corners: &Corners,
    toward: Side,
    [filled, walled]: [f64; 2],
    l0: f64,
) -> Behind<D> {
    let (axis, sign) = (toward.axis(), if toward.is_upper() { 1.0 } else { -1.0 });
    let Corners { mut lower, mut upper } = corners.clone();
    let plane = lower[axis];
    let to = plane + sign * filled;
    (lower[axis], upper[axis]) = (plane.min(to), plane.max(to));
    // The outermost row of points, in the last layer that has a wall.
    let deepest = plane + sign * (walled - 0.5 * l0 * walled.signum());
    let end = |side: f64| {
        let mut place = [side; D];
        place[axis] = deepest;
        place
    };
    let ends = [end(lower[1 - axis] + 0.5 * l0), end(upper[1 - axis] - 0.5 * l0)];
    let places = fill(&Region::Box(Corners { lower, upper }), l0);
    Behind { key: format!("{key}.opening"), places, ends, depth: walled.abs() }
}
