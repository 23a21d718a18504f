//! Checkpoints: what is written comes back; what is damaged, foreign or half written is refused, and the other one is there.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use common::{directory, listing};
use mps_io::checkpoint::{Checkpoint, CheckpointError, Identity, Rotation, decode, encode};
use mps_kernel::{Section, State};
use proptest::prelude::*;
use std::path::Path;

fn identity() -> Identity {
    Identity::new("mps 0.1.0", "f64", "title = \"a tank\"\n")
}

/// Sections of several lengths, one of them empty.
fn state(seed: u8) -> Checkpoint {
    let section = |name: &str, entry: usize, length: usize| Section {
        name: name.to_owned(),
        entry,
        bytes: (0..length).map(|k| (k as u8).wrapping_mul(31).wrapping_add(seed)).collect(),
    };
    let state = State::from(vec![
        section("fluid/particles/position", 16, 16 * 21),
        section("fluid/particles/density", 8, 8 * 21),
        section("solid/history", 0, 0),
        section("time", 8, 8),
    ]);
    let settings =
        [("fields", "yes"), ("name", "a tank")].map(|(name, value)| (name.to_owned(), value.to_owned()));
    Checkpoint { identity: identity(), settings: settings.into(), state }
}

fn read(file: &[u8]) -> Result<Checkpoint, CheckpointError> {
    decode(file, Path::new("run/last.mps"))
}

#[test]
fn what_is_written_comes_back() {
    let mut rotation = Rotation::new(directory("checkpoint-back").join("checkpoint"));
    assert!(!rotation.exists());
    assert!(matches!(rotation.read(), Err(CheckpointError::None { .. })));
    for seed in 0..4 {
        rotation.write(&state(seed)).unwrap();
        assert_eq!(rotation.read().unwrap(), (state(seed), rotation.last()));
    }
    let (dir, before) =
        (rotation.last().parent().unwrap().to_path_buf(), std::fs::read(rotation.before()).unwrap());
    assert_eq!(listing(&dir), ["before.mps", "last.mps"]);
    assert_eq!(read(&before).unwrap(), state(2));
    rotation.clear().unwrap();
    assert!(listing(&dir).is_empty());
}

/// Every bit of every byte: no part of the file is without a checksum.
#[test]
fn a_flipped_bit_is_noticed_wherever_it_is() {
    let whole = encode(&state(1));
    assert_eq!(read(&whole).unwrap(), state(1));
    let mut parts = std::collections::BTreeSet::new();
    for at in 0..whole.len() {
        for bit in 0..8 {
            let mut file = whole.clone();
            file[at] ^= 1 << bit;
            match read(&file) {
                Err(CheckpointError::Damaged { part, .. }) => drop(parts.insert(part)),
                Err(CheckpointError::Version { .. }) => assert!((8..12).contains(&at), "byte {at}"),
                other => panic!("bit {bit} of byte {at}: {other:?}"),
            }
        }
    }
    let named = parts.into_iter().collect::<Vec<_>>().join(", ");
    let expected = "header, preamble, section 'fluid/particles/density', section 'fluid/particles/position', section 'time'";
    assert_eq!(named, expected);
}

#[test]
fn a_file_cut_at_any_byte_or_with_more_behind_it_is_refused() {
    let whole = encode(&state(1));
    for length in 0..whole.len() {
        let error = read(&whole[..length]).unwrap_err();
        assert!(matches!(error, CheckpointError::Damaged { .. }), "{length}: {error}");
        assert!(error.to_string().contains("run/last.mps is damaged"), "{error}");
    }
    let longer = read(&[whole.as_slice(), &[0]].concat()).unwrap_err();
    assert!(longer.to_string().contains("1 bytes follow the last section"), "{longer}");
    let cut = read(&whole[..whole.len() - 8]).unwrap_err();
    assert!(cut.to_string().contains("section 'time' ends after"), "{cut}");
}

#[test]
fn a_state_of_another_program_precision_or_scene_is_refused() {
    for (other, words) in [
        (
            Identity::new("mps 0.2.0", "f64", "title = \"a tank\"\n"),
            "another program (mps 0.2.0, and not mps 0.1.0)",
        ),
        (Identity::new("mps 0.1.0", "f32", "title = \"a tank\"\n"), "another precision (f32, and not f64)"),
        (Identity::new("mps 0.1.0", "f64", "title = \"a tanks\"\n"), "another scene ("),
    ] {
        let path = Path::new("run/last.mps");
        let found = read(&encode(&Checkpoint { identity: other, ..state(1) })).unwrap();
        let error = identity().check(&found.identity, path).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
        assert!(matches!(error, CheckpointError::Foreign { .. }));
    }
}

/// Whenever the program is stopped while it writes the third checkpoint: the states between the calls of the operating system.
#[test]
fn a_run_that_is_stopped_while_it_writes_has_a_checkpoint() {
    let mut rotation = Rotation::new(directory("checkpoint-stopped").join("checkpoint"));
    let part = rotation.last().with_file_name(".next.mps.part");
    let third = encode(&state(3));
    let two = |rotation: &mut Rotation| {
        rotation.clear().unwrap();
        rotation.write(&state(1)).unwrap();
        rotation.write(&state(2)).unwrap();
    };
    for length in [0, 1, third.len() / 2, third.len()] {
        two(&mut rotation);
        std::fs::write(&part, &third[..length]).unwrap();
        assert_eq!(rotation.read().unwrap().0, state(2), "{length} bytes written");
        // The next run writes over what is left.
        rotation.write(&state(4)).unwrap();
        assert_eq!(rotation.read().unwrap().0, state(4));
    }
    two(&mut rotation);
    std::fs::write(&part, &third).unwrap();
    std::fs::rename(rotation.last(), rotation.before()).unwrap();
    assert_eq!(rotation.read().unwrap(), (state(2), rotation.before()), "the last has become the one before");
    rotation.write(&state(4)).unwrap();
    assert_eq!(rotation.read().unwrap(), (state(4), rotation.last()));
    std::fs::remove_file(rotation.last()).unwrap();
    assert_eq!(rotation.read().unwrap().0, state(2), "the only one was not written over");
}

#[test]
fn a_damaged_checkpoint_leaves_the_one_before_and_two_are_told_apart() {
    let mut rotation = Rotation::new(directory("checkpoint-damaged").join("checkpoint"));
    rotation.write(&state(1)).unwrap();
    rotation.write(&state(2)).unwrap();
    let damage = |path: &Path| {
        let mut file = std::fs::read(path).unwrap();
        let middle = file.len() - 20;
        file[middle] ^= 4;
        std::fs::write(path, file).unwrap();
    };
    damage(&rotation.last());
    assert_eq!(rotation.read().unwrap(), (state(1), rotation.before()));
    // What goes on from the one before does not lose it to the damaged one.
    rotation.write(&state(3)).unwrap();
    assert_eq!(rotation.read().unwrap(), (state(3), rotation.last()));
    damage(&rotation.last());
    assert_eq!(rotation.read().unwrap(), (state(1), rotation.before()));
    damage(&rotation.before());
    let words = rotation.read().unwrap_err().to_string();
    assert!(words.contains("last.mps is damaged") && words.contains("before.mps is damaged"), "{words}");
}

proptest! {
    /// Bytes of any kind, alone or over a part of a checkpoint: refused or, where nothing changed, the state.
    #[test]
    fn nothing_read_is_a_panic_or_another_state(
        at in 0.0..1.0_f64,
        bytes in prop::collection::vec(any::<u8>(), 0..200),
        alone in any::<bool>(),
    ) {
        let mut file = encode(&state(1));
        let whole = file.clone();
        if alone {
            file = bytes;
        } else {
            let at = (at * file.len() as f64) as usize;
            for (byte, other) in file.iter_mut().skip(at).zip(bytes) {
                *byte = other;
            }
        }
        match read(&file) {
            Ok(found) => prop_assert!(file == whole && found == state(1)),
            Err(error) => prop_assert!(error.to_string().contains("run/last.mps")),
        }
    }
}
