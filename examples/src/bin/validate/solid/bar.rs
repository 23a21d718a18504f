//! A wave along a bar, reflected at a free and at a clamped end.

use super::scene::{RHO, V, YOUNG, solid};
use mps_examples::Failure;
use mps_examples::exact::{Case, Curve, Measure, Outcome, Pace, Plot};
use mps_io::CurvePlot;
use mps_neighbors::Parallel;
use mps_solid::body::{Face, block};
use mps_solid::materials::CorotationalHooke;

pub(crate) struct Bar;

/// Length of the bar \[m\].
const LENGTH: f64 = 1.0;
/// Height of the pulse \[m\]: small strain.
const HEIGHT: f64 = 1e-5;
/// Its width, over the length of the bar.
const WIDTH: f64 = 0.1;
/// Rows of particles.
const ROWS: usize = 4;
const LAW: &str = "analytic: wave equation (d'Alembert)";

/// The pulse in the middle of the bar, over its height.
fn pulse(x: f64) -> f64 {
    (-((x - 0.5 * LENGTH) / WIDTH).powi(2)).exp()
}

/// Speed of the wave without lateral strain \[m/s\].
fn speed() -> f64 {
    (YOUNG / RHO).sqrt()
}

/// Displacement over its height after the time in which sound runs along the bar `lengths` times. The pulse runs to
/// the right, comes back as it is from the free end, and upside down from the clamp: its images are `2 L` apart.
fn exact(x: f64, lengths: f64) -> f64 {
    let pulses = |s: f64| {
        let image = (s / (2.0 * LENGTH)).floor();
        let sign = if image.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 };
        sign * pulse(s - 2.0 * LENGTH * image)
    };
    let run = lengths * LENGTH;
    pulses(x - run) + pulses(2.0 * LENGTH - x - run)
}

impl Case for Bar {
    fn name(&self) -> &'static str {
        "bar"
    }

    fn about(&self) -> &'static str {
        "A bar of length L, nu = 0, clamped at its left end and free at its right one; a pulse exp(-((x - L/2)/0.1 L)^2) runs to the right, is \
         reflected twice and is back after 4 L/c. 4 rows. Root mean square of the difference from the wave equation, over the height of the pulse."
    }

    fn resolution(&self) -> &'static str {
        "particles along the bar"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![40, 80], vec![40, 80, 160])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let height = ROWS as f64 * LENGTH / (n as f64 - 0.5);
        let body = block(V::zeros(), V::new(LENGTH, height), [n, ROWS], &[Face::lower(0)])?;
        let mut bar = solid(&body, RHO, CorotationalHooke::new(YOUNG, 0.0)?, parallel)?;
        let along: Vec<f64> = bar.positions().iter().map(|x| x.x).collect();
        for (x, x0) in bar.positions_mut().iter_mut().zip(&along) {
            x.x += HEIGHT * pulse(*x0);
        }
        for (u, x0) in bar.velocities_mut().iter_mut().zip(&along) {
            // -c du/dx
            u.x = speed() * HEIGHT * pulse(*x0) * 2.0 * (x0 - 0.5 * LENGTH) / (WIDTH * WIDTH);
        }
        let rest = vec![V::zeros(); bar.len()];
        // From one look to the next sound runs along the bar once.
        let time = LENGTH / speed();
        let substeps = (time / bar.max_step(parallel)).ceil() as usize;
        let (mut measures, mut curves) = (Vec::new(), Vec::new());
        for (more, lengths, metric) in [(1, 1.0, "displacement at L/c"), (3, 4.0, "displacement at 4 L/c")] {
            for _ in 0..more {
                bar.advance(parallel, &rest, &V::zeros(), time, substeps)?;
            }
            let found: Vec<f64> =
                bar.positions().iter().zip(&along).map(|(x, x0)| (x.x - x0) / HEIGHT).collect();
            let squares = found.iter().zip(&along).map(|(u, x)| (u - exact(*x, lengths)).powi(2));
            let off = (squares.sum::<f64>() / found.len() as f64).sqrt();
            measures.push(Measure::new(metric, "height", off, 0.0, LAW));
            if lengths == 4.0 {
                let mut line: Vec<(f64, f64)> = along.iter().copied().zip(found).collect();
                line.sort_by(|a, b| a.0.total_cmp(&b.0));
                let (x, y) = line.into_iter().step_by(ROWS).unzip();
                curves.push(Curve { plot: "pulse", name: format!("{n} along"), x, y });
            }
        }
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let x: Vec<f64> = (0..=400).map(|k| f64::from(k) * 2.5e-3).collect();
        let y: Vec<f64> = x.iter().map(|x| exact(*x, 4.0)).collect();
        let axes =
            CurvePlot::new("Pulse along a bar, after two reflections", "x/L [-]", "u over its height [-]");
        vec![Plot { name: "pulse", axes: axes.dashed("exact", &x, &y) }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exact_wave_keeps_to_its_ends_and_comes_back() {
        let h = 1e-4;
        for lengths in [0.3, 0.5, 1.4, 1.5, 2.7, 3.3] {
            assert!(exact(0.0, lengths).abs() < 1e-9, "the clamp holds");
            assert!(
                (exact(LENGTH, lengths) - exact(LENGTH - h, lengths)).abs() < 1e-5,
                "no stress at the free end"
            );
            // u_tt = c^2 u_xx with lengths for the time.
            let by = |dx: f64, dt: f64| exact(0.6 + dx, lengths + dt);
            let (space, time) = (by(h, 0.0) + by(-h, 0.0), by(0.0, h) + by(0.0, -h));
            assert!((space - time).abs() < 1e-10);
        }
        assert!(
            (exact(0.45, 2.0) + exact(0.45, 0.0)).abs() < 1e-9
                && (exact(0.45, 4.0) - exact(0.45, 0.0)).abs() < 1e-9
        );
    }
}
