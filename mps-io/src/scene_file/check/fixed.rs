//! Rigid bodies at rest, and rows of points that begin on a disc.

use super::super::fixed::{Fixed, Packing};
use super::super::region::{Corners, Disc, Region};
use super::Checker;

impl Checker<'_> {
    /// A fixed body in fluid of this spacing \[m\].
    pub(super) fn fixed(&mut self, body: &Fixed, l0: f64, key: &str) {
        let spacing = body.spacing.unwrap_or(l0);
        let remedy = "give the distance of the points in metres, or leave it out for that of the fluid";
        self.positive(spacing, &format!("{key}.spacing"), remedy);
        self.region(&body.region, spacing, &format!("{key}.region"));
        let packing = format!("{key}.packing");
        match &body.packing {
            Packing::Lattice | Packing::Fitted => {}
            Packing::Rings if !self.only_in(2, &packing, "give \"lattice\" or \"fitted\"") => {}
            Packing::Rings => {
                let round = matches!(body.region, Region::Circle(_));
                let remedy = "rings fill circles: give such a region, or \"fitted\" for any other";
                self.unless(round, &packing, "is \"rings\", but the body is no circle", remedy);
            }
            Packing::Rows(disc) => self.rows(disc, &body.region, &format!("{packing}.rows")),
        }
    }

    /// Rows along a box that begin on a disc at its left end.
    pub(super) fn rows(&mut self, disc: &Disc, region: &Region, key: &str) {
        if !self.only_in(2, key, "hold a region of the body, or give \"lattice\"") {
            return;
        }
        let Disc { center, radius } = disc;
        let good = self.point(center, &format!("{key}.center"));
        self.positive(*radius, &format!("{key}.radius"), "give the radius in metres");
        let Region::Box(Corners { lower, upper }) = region else {
            let remedy = "rows are those of a box: give such a region";
            return self.unless(false, key, "needs rows, but the body is no box", remedy);
        };
        if !good || [lower, upper].iter().any(|corner| corner.len() != self.dimension) {
            return;
        }
        // The row that is farthest from the middle of the disc, and the nearest one.
        let off = |y: &f64| (y - center[1]).abs();
        let far = off(&lower[1]).max(off(&upper[1]));
        let remedy = "let the disc reach above and below the box";
        self.unless(far < *radius, key, "does not reach all rows of the box", remedy);
        let start = disc.right_of(center[1] + far).unwrap_or(center[0]);
        let (most, length) = (0.2 * (upper[0] - lower[0]), upper[0] - lower[0]);
        let apart = [start, center[0] + radius].map(|x| (x - lower[0]).abs()).into_iter().fold(0.0, f64::max);
        let what = format!("is {apart:.3e} m from the left end of the box, which is {length:.3e} m long");
        self.unless(
            apart <= most,
            key,
            what,
            "let the box begin where it touches the disc: rows are stretched by a fifth at most",
        );
    }
}
