//! Two bodies that may meet, or one that may meet itself.

use super::candidates::{Candidates, Watch};
use super::field::{Facing, contact_distance, radius};
use super::member::Member;
use super::{ContactConfig, ContactError};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows};

/// One body of a pairing, looking at the other.
#[derive(Clone, Debug)]
pub(crate) struct Side<T: Real, const D: usize> {
    pub(crate) body: usize,
    /// The other body, as seen from here.
    pub(crate) facing: Facing<T>,
    pub(crate) candidates: Candidates,
    /// For every particle of the body, `A_i K/2 d_i/s` \[N/m^D\].
    pub(crate) push: Vec<T>,
    /// For the particles with candidates, their push and the energy of their overlap.
    pub(crate) found: Vec<(T, T)>,
    /// Forces on the particles with candidates \[N\].
    pub(crate) force: Vec<Vector<T, D>>,
}

#[derive(Clone, Debug)]
pub(crate) struct Pairing<T: Real, const D: usize> {
    /// One side for a body with itself.
    pub(crate) sides: Vec<Side<T, D>>,
    /// `K` \[Pa/m\]: half a spacing of each material, in series.
    pub(crate) stiffness: T,
    /// Largest eigenvalue of contact over the masses \[1/s^2\].
    pub(crate) rate2: T,
    /// Distance of the outermost particles where surfaces touch \[m\].
    pub(crate) touch: T,
    /// Distance within which particles count as near \[m\].
    near: T,
    /// Distance to which candidates are searched \[m\]: until the next search nobody comes near who is not among them.
    reach: T,
    watch: Watch<T, D>,
    cells: Cells<T, D>,
    rows: [Rows; 2],
    pub(crate) energy: T,
    /// Deepest overlap \[m\].
    pub(crate) overlap: T,
}

impl<T: Real, const D: usize> Pairing<T, D> {
    /// Bodies number `a` and `b` of `members`; `a == b` for one with itself.
    pub(crate) fn new(members: &[Member<T, D>], [a, b]: [usize; 2], config: &ContactConfig<T>) -> Self {
        let (one, other) = (&members[a], &members[b]);
        let spacings = [one.spacing.to_double(), other.spacing.to_double()];
        let radius = T::of(radius::<D>(spacings));
        let half = T::of(0.5);
        let stiffness = T::one() / (half * one.spacing / one.modulus + half * other.spacing / other.modulus);
        // Of itself a body sees the surface only.
        let deep = if a == b { 1 } else { usize::MAX };
        let side = |body: usize, [seen, from]: [f64; 2]| Side {
            body,
            facing: Facing::new::<D>([seen, from], deep),
            candidates: Candidates::default(),
            push: vec![T::zero(); members[body].volume.len()],
            found: Vec::new(),
            force: Vec::new(),
        };
        let mut sides = vec![side(a, [spacings[1], spacings[0]])];
        if a != b {
            sides.push(side(b, spacings));
        }
        let stiffening = sides.iter().fold(1.0, |most: f64, side| most.max(side.facing.stiffening));
        let inertia = T::one() / (one.density * one.spacing) + T::one() / (other.density * other.spacing);
        let touch = T::of(contact_distance(spacings));
        let skin = config.skin * touch;
        Self {
            sides,
            stiffness,
            rate2: stiffness * inertia * T::of(stiffening),
            touch,
            near: radius + skin * half,
            reach: radius + skin * T::of(1.5),
            watch: Watch::new(skin),
            cells: Cells::new(),
            rows: [Rows::default(), Rows::default()],
            energy: T::zero(),
            overlap: T::zero(),
        }
    }

    /// The two bodies, the same one twice for one with itself.
    pub(crate) fn bodies(&self) -> [usize; 2] {
        [self.sides[0].body, self.sides[self.sides.len() - 1].body]
    }

    /// Whether there is anybody who might touch.
    pub(crate) fn has_candidates(&self) -> bool {
        !self.sides[0].candidates.particles().is_empty()
    }

    /// Whether anybody is near at these positions, for which the candidates were searched. Whoever else is a candidate hangs on
    /// when that was, and must change nothing: a body that was restored would go on in another way.
    pub(crate) fn is_near(&self, parallel: &Parallel, positions: [&[Vector<T, D>]; 2]) -> bool {
        let candidates = &self.sides[0].candidates;
        let near2 = self.near * self.near;
        let found = |k: usize| {
            let (i, row) = candidates.row(k);
            let x = positions[0][i];
            row.iter().any(|&j| (positions[1][j as usize] - x).norm_squared() <= near2)
        };
        parallel.fold(candidates.particles().len(), false, &found, &|a, b| a | b)
    }

    /// Brings the candidates up to date.
    pub(crate) fn search(
        &mut self,
        parallel: &Parallel,
        members: &[Member<T, D>],
        positions: [&[Vector<T, D>]; 2],
    ) -> Result<(), ContactError> {
        let [a, b] = self.bodies();
        // A body with itself is one set.
        let sets = [positions[0], if a == b { &[] } else { positions[1] }];
        if a != b && members[a].gap(&members[b]) > self.reach {
            if self.has_candidates() {
                self.forget();
            }
            self.watch.expire();
            return Ok(());
        }
        if !self.watch.expired(parallel, sets) {
            return Ok(());
        }
        self.forget();
        self.find(parallel, members, positions).map_err(|source| ContactError::Search {
            body: a,
            other: b,
            source,
        })?;
        self.watch.renew(sets);
        for side in &mut self.sides {
            let len = side.candidates.particles().len();
            side.found.resize(len, (T::zero(), T::zero()));
            side.force.resize(len, Vector::zeros());
        }
        Ok(())
    }

    fn find(
        &mut self,
        parallel: &Parallel,
        members: &[Member<T, D>],
        positions: [&[Vector<T, D>]; 2],
    ) -> Result<(), mps_neighbors::NeighborError> {
        let [there, back] = &mut self.rows;
        self.cells.build(parallel, &Open, positions[1], self.reach)?;
        if let [side, other] = self.sides.as_mut_slice() {
            there.build_between(parallel, &Open, &self.cells, positions[0], positions[1], self.reach)?;
            back.transpose_of(there, positions[1].len())?;
            side.candidates.fill(there, |_, _| true);
            other.candidates.fill(back, |_, _| true);
        } else {
            let side = &mut self.sides[0];
            let bonds = members[side.body].bonds.as_ref();
            there.build_within(parallel, &Open, &self.cells, positions[0], self.reach)?;
            side.candidates.fill(there, |i, j| bonds.is_some_and(|bonds| bonds.can_meet(i, j)));
        }
        Ok(())
    }

    /// Leaves no candidates and no pushes.
    fn forget(&mut self) {
        for side in &mut self.sides {
            for &i in side.candidates.particles() {
                side.push[i as usize] = T::zero();
            }
            side.candidates.clear();
            side.found.clear();
            side.force.clear();
        }
        (self.energy, self.overlap) = (T::zero(), T::zero());
    }
}
