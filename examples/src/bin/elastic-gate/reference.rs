//! What others have measured and computed for this case.

/// Free end of the gate in the experiment: time \[s\], x and y displacement \[m\].
/// Antoci, Gallati, Sibilla 2007, Computers & Structures 85:879-890, digitised (+-0.5 mm).
pub(crate) const EXPERIMENT: &[(f64, f64, f64)] = &[
    (0.04, 0.01254, 0.00111),
    (0.08, 0.03400, 0.01004),
    (0.12, 0.04395, 0.01507),
    (0.16, 0.04639, 0.01709),
    (0.20, 0.04417, 0.01601),
    (0.24, 0.04299, 0.01388),
    (0.28, 0.04115, 0.01283),
    (0.32, 0.04004, 0.01203),
    (0.36, 0.03739, 0.01095),
];

/// Largest displacements in the experiment \[m\].
pub(crate) const EXPERIMENT_MAXIMUM: Maximum =
    Maximum { x: 0.0464, y: 0.0171, source: "Antoci, Gallati, Sibilla 2007 (experiment)" };

/// When it is as far open \[s\].
pub(crate) const EXPERIMENT_MAXIMUM_TIME: f64 = 0.16;

/// Largest displacements of the free end in a published run \[m\].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Maximum {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) source: &'static str,
}

/// SPH-VCPM with 12 MPa, 0.4.
pub(crate) const NG_2020: Maximum = Maximum { x: 0.03895, y: 0.01371, source: "Ng et al. 2020 (SPH-VCPM)" };
/// ISPH-SPH with 7.8 MPa, 0.4.
pub(crate) const KHAYYER_2018: Maximum =
    Maximum { x: 0.04270, y: 0.01482, source: "Khayyer et al. 2018 (ISPH-SPH)" };
/// Riemann SPH with 7.8 MPa, 0.47 at a spacing of 2.5 mm.
pub(crate) const SPHINXSYS: Maximum =
    Maximum { x: 0.04583, y: 0.01959, source: "SPHinXsys (Riemann SPH, 2.5 mm)" };
