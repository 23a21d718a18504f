//! From a state to the bytes of a file.

use super::{Checkpoint, Identity, MAGIC, ORDER_MARK, PREAMBLE, VERSION};
use mps_kernel::Section;
use xxhash_rust::xxh3::xxh3_128;

/// The bytes of a checkpoint before its sections.
pub(super) fn head(checkpoint: &Checkpoint) -> Vec<u8> {
    let Checkpoint { identity: Identity { program, precision, scene }, settings, state } = checkpoint;
    let mut head = Vec::with_capacity(PREAMBLE + 128 * state.sections().len());
    head.extend(MAGIC);
    head.extend(VERSION.to_le_bytes());
    head.extend([0; 4]);
    head.extend(ORDER_MARK.to_ne_bytes());
    text(&mut head, program);
    text(&mut head, precision);
    head.extend(scene.to_le_bytes());
    head.extend((settings.len() as u32).to_le_bytes());
    for (name, value) in settings {
        text(&mut head, name);
        text(&mut head, value);
    }
    head.extend((state.sections().len() as u32).to_le_bytes());
    for Section { name, entry, bytes } in state.sections() {
        text(&mut head, name);
        head.extend((*entry as u32).to_le_bytes());
        head.extend((bytes.len() as u64).to_le_bytes());
        head.extend(xxh3_128(bytes).to_le_bytes());
    }
    let length = (head.len() - PREAMBLE) as u32;
    head[PREAMBLE - 4..PREAMBLE].copy_from_slice(&length.to_le_bytes());
    let sum = xxh3_128(&head);
    head.extend(sum.to_le_bytes());
    head
}

fn text(head: &mut Vec<u8>, text: &str) {
    head.extend((text.len() as u32).to_le_bytes());
    head.extend(text.as_bytes());
}

/// A checkpoint as one piece of memory.
pub fn encode(checkpoint: &Checkpoint) -> Vec<u8> {
    let mut whole = head(checkpoint);
    checkpoint.state.sections().iter().for_each(|section| whole.extend(&section.bytes));
    whole
}
