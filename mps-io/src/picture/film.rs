//! A film as an animated PNG: plays in every browser, needs no other program.
//!
//! The format (PNG third edition, "Animation information") puts the number of frames near the start
//! of the file. Instead of asking for it in advance, each new frame goes over the end mark and the
//! number is then written again: the file is a complete film after every frame, also when the run is
//! killed.

use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use flate2::Crc;

use crate::OutputError;
use crate::raster::image::{Image, encode};

/// An animated PNG that grows by one frame at a time and repeats for ever.
///
/// Only the smallest rectangle that changed since the last frame is stored.
pub struct Film {
    path: PathBuf,
    file: File,
    fps: u16,
    /// Width and height of the first frame.
    size: Option<(u32, u32)>,
    frames: u32,
    /// Counts the chunks of the animation, as the format asks.
    sequence: u32,
    /// Where the end mark stands, and the next frame goes.
    end: u64,
    /// Pixels of the last frame.
    shown: Vec<u8>,
}

/// Signature (8 bytes) and IHDR (25 bytes) come before the number of frames.
const COUNT_AT: u64 = 33;

impl Film {
    /// Creates a film of `fps` frames a second; the first frame sets its size.
    ///
    /// # Errors
    /// The file cannot be created.
    pub fn create(path: impl AsRef<Path>, fps: u16) -> Result<Self, OutputError> {
        let path = path.as_ref().to_path_buf();
        let file = File::create(&path).map_err(OutputError::file("create", &path))?;
        let (size, shown) = (None, Vec::new());
        Ok(Self { path, file, fps: fps.max(1), size, frames: 0, sequence: 0, end: 0, shown })
    }

    /// Where the film is: with [`resume`](Self::resume) it goes on from there.
    pub fn marks(&self) -> [u64; 5] {
        let (width, height) = self.size.unwrap_or((0, 0));
        [self.end, self.frames.into(), self.sequence.into(), width.into(), height.into()]
    }

    /// Opens a film that goes on where it had these `marks`: what was filmed later is cut off.
    ///
    /// # Errors
    /// The file is not there, is shorter, or cannot be written.
    pub fn resume(path: impl AsRef<Path>, fps: u16, marks: [u64; 5]) -> Result<Self, OutputError> {
        let path = path.as_ref().to_path_buf();
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .open(&path)
            .map_err(OutputError::file("open", &path))?;
        let [end, frames, sequence, width, height] = marks;
        let [frames, sequence, width, height] = [frames, sequence, width, height].map(|mark| mark as u32);
        let cut = file.metadata().and_then(|found| {
            if found.len() < end {
                return Err(io::Error::new(io::ErrorKind::UnexpectedEof, "it is shorter than it was"));
            }
            file.set_len(end)?;
            let mut mark = Vec::new();
            chunk(&mut mark, b"IEND", &[]);
            file.seek(SeekFrom::Start(end))?;
            file.write_all(&mark)?;
            if frames > 0 { write_count(&mut file, frames) } else { Ok(()) }
        });
        cut.map_err(OutputError::file("go on with", &path))?;
        let size = (frames > 0).then_some((width, height));
        // The last picture is not known any more: the next frame is stored whole.
        Ok(Self { path, file, fps: fps.max(1), size, frames, sequence, end, shown: Vec::new() })
    }

    /// Forces the frames to the disk, where they outlast a loss of power.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn sync(&self) -> Result<(), OutputError> {
        self.file.sync_data().map_err(OutputError::file("write", &self.path))
    }

    /// Appends a frame.
    ///
    /// # Errors
    /// The frame has another size than the first one, or the disk refuses.
    pub fn push(&mut self, image: &Image) -> Result<(), OutputError> {
        let (found_width, found_height) = (image.width(), image.height());
        let (width, height) = *self.size.get_or_insert((found_width, found_height));
        if (found_width, found_height) != (width, height) {
            let path = self.path.clone();
            return Err(OutputError::FrameSize { path, width, height, found_width, found_height });
        }
        let patch = if self.shown.is_empty() {
            Patch::whole(width, height)
        } else {
            Patch::changed(&self.shown, image)
        };
        let still = encode(patch.width, patch.height, &patch.cut(image))
            .map_err(|error| OutputError::Encode { path: self.path.clone(), reason: error.to_string() })?;
        self.append(&patch, &still).map_err(OutputError::file("write", &self.path))?;
        self.shown.clear();
        self.shown.extend_from_slice(image.rgb());
        Ok(())
    }

    /// Number of frames so far.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    fn append(&mut self, patch: &Patch, still: &[u8]) -> io::Result<()> {
        // Kept only if everything is written: a gap in the sequence would spoil the film.
        let mut sequence = self.sequence;
        let mut bytes = Vec::with_capacity(still.len() + 128);
        if self.frames == 0 {
            bytes.extend_from_slice(still.get(..COUNT_AT as usize).unwrap_or_default());
            chunk(&mut bytes, b"acTL", &[&1u32.to_be_bytes(), &0u32.to_be_bytes()]);
        }
        let mut control = Vec::with_capacity(26);
        for number in [sequence, patch.width, patch.height, patch.x, patch.y] {
            control.extend_from_slice(&number.to_be_bytes());
        }
        // Delay 1 / fps; then 0, 0: leave the picture as it is, and replace the pixels of the patch.
        control.extend_from_slice(&1u16.to_be_bytes());
        control.extend_from_slice(&self.fps.to_be_bytes());
        control.extend_from_slice(&[0, 0]);
        chunk(&mut bytes, b"fcTL", &[&control]);
        sequence += 1;
        for data in pixel_data(still) {
            if self.frames == 0 {
                chunk(&mut bytes, b"IDAT", &[data]);
            } else {
                chunk(&mut bytes, b"fdAT", &[&sequence.to_be_bytes(), data]);
                sequence += 1;
            }
        }
        let next_end = self.end + bytes.len() as u64;
        chunk(&mut bytes, b"IEND", &[]);
        self.file.seek(SeekFrom::Start(self.end))?;
        self.file.write_all(&bytes)?;
        let frames = self.frames + 1;
        write_count(&mut self.file, frames)?;
        (self.end, self.frames, self.sequence) = (next_end, frames, sequence);
        Ok(())
    }
}

/// Says near the start of the file how many frames there are.
fn write_count(file: &mut File, frames: u32) -> io::Result<()> {
    let mut count = Vec::new();
    chunk(&mut count, b"acTL", &[&frames.to_be_bytes(), &0u32.to_be_bytes()]);
    file.seek(SeekFrom::Start(COUNT_AT))?;
    file.write_all(&count)
}

/// Appends length, kind, data and check sum.
fn chunk(out: &mut Vec<u8>, kind: &[u8; 4], data: &[&[u8]]) {
    let length: usize = data.iter().map(|part| part.len()).sum();
    out.extend_from_slice(&(length as u32).to_be_bytes());
    let start = out.len();
    out.extend_from_slice(kind);
    data.iter().for_each(|part| out.extend_from_slice(part));
    let mut check = Crc::new();
    check.update(&out[start..]);
    out.extend_from_slice(&check.sum().to_be_bytes());
}

/// The contents of the IDAT chunks of a PNG file.
fn pixel_data(png: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = png.get(8..).unwrap_or_default();
    std::iter::from_fn(move || {
        loop {
            let (length, after) = rest.split_first_chunk::<4>()?;
            let (kind, after) = after.split_first_chunk::<4>()?;
            let (data, after) = after.split_at_checked(u32::from_be_bytes(*length) as usize)?;
            rest = after.get(4..)?;
            if kind == b"IDAT" {
                return Some(data);
            }
        }
    })
}

/// The rectangle of a frame that is stored.
#[derive(Debug, PartialEq)]
struct Patch {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

impl Patch {
    fn whole(width: u32, height: u32) -> Self {
        Self { x: 0, y: 0, width, height }
    }

    /// The smallest rectangle that holds every changed pixel; one pixel if none changed.
    fn changed(shown: &[u8], image: &Image) -> Self {
        let row = 3 * image.width() as usize;
        let (mut top, mut bottom, mut left, mut right) = (usize::MAX, 0, usize::MAX, 0);
        for (y, (old, new)) in shown.chunks_exact(row).zip(image.rgb().chunks_exact(row)).enumerate() {
            if old == new {
                continue;
            }
            let differs = |k: &usize| old[*k] != new[*k];
            let first = (0..row).find(differs).unwrap_or(0) / 3;
            let last = (0..row).rfind(differs).unwrap_or(0) / 3;
            (top, bottom) = (top.min(y), y);
            (left, right) = (left.min(first), right.max(last));
        }
        if top == usize::MAX {
            return Self::whole(1, 1);
        }
        let (width, height) = ((right - left + 1) as u32, (bottom - top + 1) as u32);
        Self { x: left as u32, y: top as u32, width, height }
    }

    fn cut(&self, image: &Image) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(3 * self.width as usize * self.height as usize);
        for y in self.y..self.y + self.height {
            let from = 3 * (y as usize * image.width() as usize + self.x as usize);
            bytes.extend_from_slice(&image.rgb()[from..from + 3 * self.width as usize]);
        }
        bytes
    }
}
