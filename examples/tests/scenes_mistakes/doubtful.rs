//! What can be run and is most likely not meant.

use crate::common::words;
use crate::{BEAM, CHANNEL, INLET_WHOLE, SCENE, WAVES, check};

/// What can be run but is most likely not meant is said, and not refused.
#[test]
fn what_is_doubtful_is_a_warning() {
    for (scene, name, from, to, message) in [
        (
            CHANNEL,
            "walls that end at the outlet",
            "lower = [-0.05, -0.04], upper = [1.62, 0.0]",
            "lower = [-0.05, -0.04], upper = [1.5, 0.0]",
            "fluid.outlets[0].opening has no wall beside it near (1.5950, 0.0050): let the walls on both sides go on 1.000e-1 m",
        ),
        (
            CHANNEL,
            "no slip without viscosity",
            "viscosity = { compact = 1e-3 }",
            "viscosity = \"none\"",
            "walls[0].slip does nothing: the fluid has no viscosity",
        ),
        (
            CHANNEL,
            "no slip by artificial viscosity",
            "viscosity = { compact = 1e-3 }",
            "viscosity = { artificial = 0.02 }",
            "walls[0].slip drags by the artificial viscosity, here 1.0e-3 m2/s",
        ),
        (
            CHANNEL,
            "an outlet without an inlet",
            INLET_WHOLE,
            "",
            "fluid.outlets[0].absorbing lets hardly anything out",
        ),
        (
            SCENE,
            "a gap beside the gate",
            "lower = [0.212, 0.0]",
            "lower = [0.22, 0.0]",
            "fluid.bodies[1].region leaves a gap of 8.00e-3 m to gate",
        ),
        (
            SCENE,
            "a gate that hardly parts the waters",
            "upper = [0.212, 0.16]",
            "upper = [0.208, 0.16]",
            "solids[0].region is 2.00 particles of the fluid thick and needs at least 3",
        ),
        (
            SCENE,
            "few particles across",
            "spacing = 3e-3",
            "spacing = 6e-3",
            "solids[0].spacing makes 2.0 particles across",
        ),
        (
            SCENE,
            "a gate coarser than the waters",
            "spacing = 3e-3",
            "spacing = 5e-3",
            "solids[0].spacing is 1.25 spacings of the fluid: give at most 4e-3",
        ),
        (
            SCENE,
            "a slow sound",
            "expected_speed = 1.6",
            "expected_speed = 0.6",
            "fluid.expected_speed makes the sound 6.000 m/s fast",
        ),
        (
            BEAM,
            "rows longer than the run",
            "end_time = 1.0",
            "end_time = 1.0\noutput = { probe_interval = 2.0 }",
            "output.probe_interval is longer than the run of 1e0 s, and bodies alone are stepped from row to row",
        ),
        (
            WAVES,
            "a piston faster than planned",
            "period = 0.8",
            "period = 0.02",
            "fluid.expected_speed makes the sound 14.000 m/s fast, and fluid may reach 4.9",
        ),
        (
            SCENE,
            "a wall in a wall",
            "fineness = 0.5\n\n[[solids]]",
            "fineness = 0.5\n\n[[walls]]\nname = \"sill\"\n\
             shape = { region = { box = { lower = [0.1, -0.02], upper = [0.14, 0.0] } } }\n\n[[solids]]",
            "walls[0].shape overlaps sill (walls[1].shape) near (",
        ),
        (
            SCENE,
            "no floor",
            "[[0.0, 0.2], [0.0, 0.0], [0.412, 0.0], [0.412, 0.2]]",
            "[[0.0, 0.2], [0.0, 0.0], [0.212, 0.0]]",
            "fluid.bodies[1].region has 735 of 750 particles with no wall below",
        ),
    ] {
        let changed = scene.replace(from, to);
        assert_ne!(changed, scene, "{name}");
        let output = check(&name.replace(' ', "-"), &changed);
        let said = words(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        assert!(said.starts_with("warning: scene.toml:") && said.contains(message), "{name}: {said}");
    }
}
