//! Inlets and outlets.

use super::super::fluid::Fluid;
use super::super::openings::{Inlet, Outlet};
use super::super::region::Corners;
use super::super::solids::Side;
use super::Checker;

/// Spacings beyond which an opening is refused: what lies behind it would not fit into memory.
const MOST_WIDE: f64 = 1e5;

impl Checker<'_> {
    pub(super) fn openings(&mut self, fluid: &Fluid) {
        let l0 = fluid.spacing;
        if self.dimension != 2 {
            let remedy = "leave it out, or let a moved wall push the fluid";
            let inlets = (0..fluid.inlets.len()).map(|k| format!("fluid.inlets[{k}]"));
            for key in inlets.chain((0..fluid.outlets.len()).map(|k| format!("fluid.outlets[{k}]"))) {
                self.only_in(2, &key, remedy);
            }
            return;
        }
        for (k, Inlet { opening, toward, mean_speed, profile: _, ramp }) in fluid.inlets.iter().enumerate() {
            let key = format!("fluid.inlets[{k}]");
            self.opening(opening, *toward, l0, &key);
            let remedy = "give the mean speed in m/s, above zero: `toward` says where the fluid goes";
            self.positive(*mean_speed, &format!("{key}.mean_speed"), remedy);
            let remedy = "give the time in seconds, or 0 for full speed from the start on";
            self.within(*ramp, [0.0, f64::MAX], &format!("{key}.ramp"), remedy);
        }
        for (k, Outlet { opening, toward, pressure, absorbing: _ }) in fluid.outlets.iter().enumerate() {
            let key = format!("fluid.outlets[{k}]");
            self.opening(opening, *toward, l0, &key);
            let remedy = "give a pressure in Pa, or leave it out for the background pressure";
            self.within(pressure.unwrap_or(0.0), [0.0, 1e15], &format!("{key}.pressure"), remedy);
        }
    }

    /// Refuses what is not flat across the way of the fluid, or on what no lattice fits.
    fn opening(&mut self, Corners { lower, upper }: &Corners, toward: Side, l0: f64, key: &str) {
        let opening = format!("{key}.opening");
        self.sides(&[toward], &format!("{key}.toward"));
        let points = [(lower, "lower"), (upper, "upper")]
            .map(|(point, name)| self.point(point, &format!("{opening}.{name}")));
        if points != [true, true] || l0 <= 0.0 {
            return;
        }
        for (axis, name) in ["x", "y", "z"].iter().enumerate().take(self.dimension) {
            let length = upper[axis] - lower[axis];
            if axis == toward.axis() {
                let what = format!("is {length:.3e} m thick along {name}, where the fluid goes");
                let remedy = "give both corners the same number there, or another `toward`";
                self.unless(length == 0.0, &opening, what, remedy);
            } else {
                let cells = length / l0;
                let whole = (0.5..MOST_WIDE).contains(&cells) && (cells - cells.round()).abs() < 0.01;
                let what = format!("is {cells:.2} spacings wide along {name}");
                self.unless(whole, &opening, what, "give a whole number from 1 to 1e5");
            }
        }
    }
}
