//! Units of what is summed over a scene, in two dimensions per metre of depth, and headings of columns.

/// Of energies.
pub(super) const fn energy<const D: usize>() -> &'static str {
    if D == 2 { "J/m" } else { "J" }
}

/// Of forces.
pub(super) const fn force<const D: usize>() -> &'static str {
    if D == 2 { "N/m" } else { "N" }
}

/// Of impulses.
pub(super) const fn impulse<const D: usize>() -> &'static str {
    if D == 2 { "N s/m" } else { "N s" }
}

/// Of angular impulses.
pub(super) const fn angular_impulse<const D: usize>() -> &'static str {
    if D == 2 { "N s" } else { "N m s" }
}

/// The planes in which things turn, each by the two axes it turns from the first to the second: about z, in three dimensions
/// about x, y and z.
pub(super) const fn planes<const D: usize>() -> &'static [(usize, usize)] {
    if D == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] }
}

/// A heading for each component of a vector.
pub(super) fn each_axis<const D: usize>(name: &str, unit: &str) -> impl Iterator<Item = String> {
    AXES.iter().take(D).map(move |axis| format!("{name} {axis} [{unit}]"))
}

/// Names of the axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];
