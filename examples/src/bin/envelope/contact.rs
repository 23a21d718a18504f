//! Bodies that fly at each other: how fast, how unlike, and how thin they may be.

use crate::border::{Border, Breaks};
use mps_examples::Failure;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::body::block;
use mps_solid::contact::{Contact, ContactConfig, Elastic};
use mps_solid::materials::NeoHookean;
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Distance at the start over the side of a block.
const GAP: f64 = 0.05;

/// Two blocks of side 1, density 1 and the Poisson's ratio 0.3 that fly at each other.
#[derive(Clone, Copy, Debug)]
struct Crash {
    /// Closing speed over the speed of sound of the softer one, whose Young's modulus is 1.
    speed: f64,
    /// Young's modulus of the other.
    stiffness: f64,
    /// Particles along a side of the softer one, and of the other.
    counts: [usize; 2],
    /// Particles across both, along the line of the flight.
    across: [usize; 2],
    /// How far one flies past the middle of the other, along every other axis.
    offset: f64,
}

const USUAL: Crash = Crash { speed: 0.1, stiffness: 1.0, counts: [6, 6], across: [6, 6], offset: 0.3 };

impl Crash {
    /// Largest change of the energy over that at the start, until sound has run through the softer one six times.
    fn swing<const D: usize>(self) -> Result<f64, Failure>
    where
        NeoHookean<f64>: ConstitutiveModel<f64, D>,
    {
        let parallel = Parallel::serial();
        // Cells that are cubes: a block with fewer particles across is a plate.
        let body = |left: f64, which: usize, young: f64| -> Result<Solid<f64, D, NeoHookean<f64>>, Failure> {
            let mut counts = [self.counts[which]; D];
            counts[0] = self.across[which];
            let aside = which as f64 * self.offset;
            let lower = Vector::from_fn(|axis, _| if axis == 0 { left } else { aside });
            let upper =
                Vector::from_fn(|axis, _| lower[axis] + counts[axis] as f64 / self.counts[which] as f64);
            let body = block(lower, upper, counts, &[])?;
            let material = NeoHookean::new(young, 0.3)?;
            let config = SolidConfig::default();
            Ok(Solid::new(body.particles, body.spacing, 1.0, material, WendlandC2, config, &parallel)?)
        };
        let thick = self.across[0] as f64 / self.counts[0] as f64;
        let mut soft = body(0.0, 0, 1.0)?;
        let mut other = body(thick + GAP, 1, self.stiffness)?;
        let sound = soft.wave_speed();
        let closing = self.speed * sound;
        let along = |speed: f64| Vector::from_fn(|axis, _| if axis == 0 { speed } else { 0.0 });
        soft.velocities_mut().fill(along(0.5 * closing));
        other.velocities_mut().fill(along(-0.5 * closing));
        let mut contact = Contact::new(ContactConfig::default())?;
        contact.add(&soft.shape())?;
        contact.add(&other.shape())?;
        let energy = |soft: &Solid<f64, D, _>, other: &Solid<f64, D, _>, contact: &Contact<f64, D>| {
            let of = |body: &Solid<f64, D, _>| body.energy(&parallel, &Vector::zeros()).total();
            of(soft) + of(other) + contact.energy()
        };
        let (start, mut most, mut touched) = (energy(&soft, &other, &contact), 0.0_f64, false);
        while soft.time() < GAP / closing + 6.0 / sound {
            let bodies: &mut [&mut dyn Elastic<f64, D>] = &mut [&mut soft, &mut other];
            let dt = contact.max_step(&parallel, bodies)?;
            contact.advance(&parallel, bodies, |_| &[], &Vector::zeros(), dt, 1)?;
            most = most.max((energy(&soft, &other, &contact) / start - 1.0).abs());
            touched |= contact.energy() > 0.0;
        }
        if touched { Ok(most) } else { Err("the bodies have not met".into()) }
    }
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "contact-speed",
        parameter: "closing speed of two blocks of rubber that meet face to face, over their speed of sound",
        measure: "largest change of the energy over that at the start",
        bound: 0.05,
        scene: |x| Crash { speed: x, offset: 0.0, ..USUAL }.swing::<2>(),
        predicted: Some(|| Ok(1.0)),
        whole: false,
        breaks: Breaks::Refusal,
        mechanism: "a blow of the speed v makes the pressure M v/(2 c) in bodies of the modulus M = lambda + 2 mu, and contact can push back with about half of M: at v = c in a \
                    body without particles. Presumably the outermost row comes to a stand later than that, and goes deeper",
        remedy: "the error says so",
    };
    let unlike = Border { predicted: None, breaks: Breaks::Nothing, remedy: "none needed", ..base };
    vec![
        base,
        Border {
            name: "contact-speed-3d",
            parameter: "the same of two cubes",
            scene: |x| Crash { speed: x, counts: [4; 2], across: [4; 2], offset: 0.0, ..USUAL }.swing::<3>(),
            ..base
        },
        Border {
            name: "contact-corner",
            parameter: "the same of blocks that meet with seven tenths of their sides",
            scene: |x| Crash { speed: x, ..USUAL }.swing::<2>(),
            predicted: None,
            mechanism: "the corner of one is pressed into the side of the other",
            ..base
        },
        Border {
            name: "contact-stiffness",
            parameter: "modulus of one of two blocks that meet with a tenth of the speed of sound, over that of the other",
            scene: |x| Crash { stiffness: x, ..USUAL }.swing::<2>(),
            mechanism: "the softer half cell gives way, and the step is that of the harder body anyway",
            ..unlike
        },
        Border {
            name: "contact-spacing",
            parameter: "particles along a side of one of two blocks, over those of the other",
            scene: |x| {
                Crash { counts: [4, 4 * x as usize], across: [4, 4 * x as usize], ..USUAL }.swing::<2>()
            },
            whole: true,
            mechanism: "particles meet the smooth field of the other body, not its particles",
            ..unlike
        },
        Border {
            name: "contact-thin",
            parameter: "particles across a plate of rubber that meets a block with a tenth of the speed of sound",
            scene: |x| Crash { across: [6, x as usize], ..USUAL }.swing::<2>(),
            whole: true,
            breaks: Breaks::Refusal,
            mechanism: "a plate one particle thick is refused as a body; two rows are enough for contact",
            remedy: "2 particles across at least; the error says so",
            ..unlike
        },
    ]
}
