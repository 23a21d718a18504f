//! From a value to a colour.

/// A colour map; the first four are uniform to the eye and readable without colour vision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ColorMap {
    /// Dark blue, green, yellow: the default for any quantity.
    #[default]
    Viridis,
    /// Dark blue to yellow with little else; closest to grey.
    Cividis,
    /// Dark blue, magenta, yellow: stands out beside `Viridis`.
    Plasma,
    /// Black, red, yellow.
    Inferno,
    /// Light to dark blue: water.
    Blues,
    /// Light to dark red and brown: strain, stress.
    OrangeRed,
    /// Blue, white, red: quantities with a sign; choose a range that is symmetric about zero.
    BlueRed,
    /// The improved rainbow, for comparison with pictures drawn in a rainbow.
    Turbo,
}

impl ColorMap {
    /// The colour at `fraction` of the range: 0 is the lower end, 1 the upper; others are clamped.
    pub fn color(self, fraction: f64) -> [u8; 3] {
        let t = if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.5 };
        let (gradient, t) = match self {
            Self::Viridis => (colorous::VIRIDIS, t),
            Self::Cividis => (colorous::CIVIDIS, t),
            Self::Plasma => (colorous::PLASMA, t),
            Self::Inferno => (colorous::INFERNO, t),
            // The lightest fifth of these two is close to the white of the paper.
            Self::Blues => (colorous::BLUES, 0.2 + 0.8 * t),
            Self::OrangeRed => (colorous::ORANGE_RED, 0.2 + 0.8 * t),
            Self::BlueRed => (colorous::RED_BLUE, 1.0 - t),
            Self::Turbo => (colorous::TURBO, t),
        };
        gradient.eval_continuous(t).into_array()
    }

    /// All 256 colours from the lower to the upper end.
    pub(super) fn table(self) -> Vec<[u8; 3]> {
        (0..=255).map(|k| self.color(f64::from(k) / 255.0)).collect()
    }
}
