//! Static equilibrium by Newton's method, the load in steps.

use super::{MatrixError, Stiffness};
use crate::{ConstitutiveModel, Solid, SolidError};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::Parallel;

/// How an equilibrium is sought.
///
/// From the positions at hand, which need not be in equilibrium, the load is raised from what keeps them
/// there to the whole. Each part of it is reached by Newton's method with the exact tangent; where that
/// fails (a particle turned inside out, an unstable state, too many iterations) the part is halved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newton {
    /// Largest residual force over the load, both as root of the sum of squares over the particles \[-\].
    /// Default `1e-9`. What the rounding of the positions changes in the forces is always allowed.
    pub tolerance: f64,
    /// Most iterations for one part of the load. Default 15.
    pub iterations: usize,
    /// Smallest part of the load that is tried \[-\]. Default `1/1024`.
    pub smallest: f64,
}

impl Default for Newton {
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 15, smallest: 1.0 / 1024.0 }
    }
}

/// How an equilibrium was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// Solutions of the linear system, those of failed attempts included.
    pub iterations: usize,
    /// Parts in which the load was raised.
    pub parts: usize,
    /// Residual force over the load, see [`Newton::tolerance`].
    pub residual: f64,
}

impl Newton {
    /// Moves the body to its equilibrium under the force on every particle \[N\], which keeps size and
    /// direction, and gravity \[m/s^2\]. Its velocities are zero then, and its material has settled ([`ConstitutiveModel::settle`]).
    ///
    /// # Errors
    /// If the length of `force` or a field of `self` is unusable or nothing can move (nothing has changed then),
    /// or if no equilibrium is found for the whole load: the body is left, at rest, in that of the part
    /// which the error names.
    pub fn equilibrium<const D: usize, M, K>(
        &self,
        solid: &mut Solid<f64, D, M, K>,
        parallel: &Parallel,
        force: &[Vector<f64, D>],
        gravity: &Vector<f64, D>,
    ) -> Result<Equilibrium, MatrixError>
    where
        M: ConstitutiveModel<f64, D>,
        K: Kernel<f64>,
    {
        self.validate()?;
        let mut stiffness = Stiffness::new(solid)?;
        stiffness.freedoms.check("force", force)?;
        let load = stiffness.freedoms.gather(|i, axis| force[i][axis] + solid.masses()[i] * gravity[axis]);
        let value = norm(&load);
        if !value.is_finite() {
            return Err(
                SolidError::Parameter { name: "force", must: "finite on every particle", value }.into()
            );
        }
        solid.refresh(parallel)?;
        solid.settle_material(parallel)?;
        let start = imbalance(&stiffness, solid, &load);
        let size = value.max(norm(&start));
        let mut found = Equilibrium { iterations: 0, parts: 0, residual: 0.0 };
        let (mut factor, mut part) = (0.0, 1.0_f64);
        let mut settled = solid.particles.position.clone();
        while factor < 1.0 && size > 0.0 {
            let next = (factor + part).min(1.0);
            let held: Vec<_> =
                load.iter().zip(&start).map(|(load, start)| load - (1.0 - next) * start).collect();
            match self.settle(&mut stiffness, solid, parallel, &held, size) {
                Ok((residual, iterations)) => {
                    found.iterations += iterations;
                    found.parts += 1;
                    found.residual = residual;
                    (factor, part) = (next, part * 2.0);
                    settled.copy_from_slice(&solid.particles.position);
                }
                Err(failure) => {
                    solid.particles.position.copy_from_slice(&settled);
                    solid.refresh(parallel)?;
                    found.iterations += failure.iterations;
                    part *= 0.5;
                    if part < self.smallest {
                        solid.rest();
                        solid.settle_material(parallel)?;
                        let Failure { residual, reason, .. } = failure;
                        return Err(MatrixError::NoEquilibrium { factor, residual, reason });
                    }
                }
            }
        }
        solid.rest();
        solid.settle_material(parallel)?;
        Ok(found)
    }

    /// Newton's method under one load. Gives the residual and the number of iterations.
    fn settle<const D: usize, M, K>(
        &self,
        stiffness: &mut Stiffness<D>,
        solid: &mut Solid<f64, D, M, K>,
        parallel: &Parallel,
        load: &[f64],
        size: f64,
    ) -> Result<(f64, usize), Failure>
    where
        M: ConstitutiveModel<f64, D>,
        K: Kernel<f64>,
    {
        let mut residual = f64::NAN;
        for iterations in 0..=self.iterations {
            let failed = |e: MatrixError| Failure { iterations, residual, reason: e.to_string() };
            let force = imbalance(stiffness, solid, load);
            let now = norm(&force) / size;
            if now <= self.tolerance + stiffness.rounding(&solid.particles.position) / size {
                return Ok((now, iterations));
            }
            stiffness.update(solid).map_err(failed)?;
            let step = stiffness.solve_unknowns(force).map_err(failed)?;
            for (x, step) in solid.particles.position.iter_mut().zip(&step) {
                *x += step;
            }
            solid.refresh(parallel).map_err(|e| failed(e.into()))?;
            residual = now;
        }
        let reason = format!("no convergence in {} iterations", self.iterations);
        Err(Failure { iterations: self.iterations, residual, reason })
    }

    fn validate(&self) -> Result<(), SolidError> {
        let check = |name, must, value: f64, good: bool| {
            if good { Ok(()) } else { Err(SolidError::Parameter { name, must, value }) }
        };
        let (tolerance, smallest) = (self.tolerance, self.smallest);
        check("tolerance", "between 0 and 1 (usual: 1e-9)", tolerance, tolerance > 0.0 && tolerance < 1.0)?;
        check(
            "smallest",
            "positive and at most 1 (usual: 1/1024)",
            smallest,
            smallest > 0.0 && smallest <= 1.0,
        )?;
        check("iterations", "at least 1 (usual: 15)", self.iterations as f64, self.iterations > 0)
    }
}

/// An attempt that led nowhere.
struct Failure {
    iterations: usize,
    residual: f64,
    reason: String,
}

/// Load and internal forces together, on what can move.
fn imbalance<const D: usize, M, K>(
    stiffness: &Stiffness<D>,
    solid: &Solid<f64, D, M, K>,
    load: &[f64],
) -> Vec<f64>
where
    M: ConstitutiveModel<f64, D>,
{
    let inner = stiffness.freedoms.gather(|i, axis| solid.particles.force[i][axis]);
    inner.iter().zip(load).map(|(inner, load)| inner + load).collect()
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
