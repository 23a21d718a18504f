//! Who is paired with whom, as rows of indices.

use crate::NeighborError;

/// Rows a block holds. Fixed: neither memory nor order may depend on the number of threads.
pub(crate) const BLOCK: usize = 256;

/// For every particle the ascending indices of its neighbours.
///
/// Rows are compressed (one after the other, without gaps) in blocks of 256. A block is found by
/// one thread and stays where it is, so that indices are written once: no counting pass before and
/// no copy after the search. All buffers are kept, with some headroom, for the next search.
///
/// Built by [`build_within`](Rows::build_within), [`build_between`](Rows::build_between) or
/// [`transpose_of`](Rows::transpose_of).
#[derive(Clone, Debug, Default)]
pub struct Rows {
    len: usize,
    /// The first `len.div_ceil(BLOCK)` are in use.
    blocks: Vec<Block>,
}

/// Up to 256 compressed rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block {
    /// Row `k` of the block is `indices[starts[k]..starts[k + 1]]`.
    pub(crate) starts: Vec<usize>,
    /// Behind the last row there is spare room.
    pub(crate) indices: Vec<u32>,
}

impl Rows {
    /// Number of rows.
    #[inline]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no row.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Number of entries of all rows; within one set every pair counts twice.
    pub fn pairs(&self) -> usize {
        self.used().iter().map(Block::pairs).sum()
    }

    /// The neighbours of `i`, ascending.
    #[inline]
    pub fn row(&self, i: usize) -> &[u32] {
        let block = &self.blocks[i / BLOCK];
        let k = i % BLOCK;
        &block.indices[block.starts[k]..block.starts[k + 1]]
    }

    /// Bytes of all buffers, spare room included.
    pub fn bytes(&self) -> usize {
        let block =
            |b: &Block| b.starts.capacity() * size_of::<usize>() + b.indices.capacity() * size_of::<u32>();
        self.blocks.capacity() * size_of::<Block>() + self.blocks.iter().map(block).sum::<usize>()
    }

    /// Entry `i` of row `j` becomes entry `j` of row `i`: what was seen now sees. `targets` is the
    /// size of the set the entries of `rows` name. Runs on the calling thread.
    ///
    /// # Errors
    /// If an entry is not below `targets`; there are no rows then.
    pub fn transpose_of(&mut self, rows: &Rows, targets: usize) -> Result<(), NeighborError> {
        self.resize(targets);
        for (b, block) in self.used_mut().iter_mut().enumerate() {
            block.starts.resize((targets - b * BLOCK).min(BLOCK) + 2, 0);
        }
        // Counts go two places further: after the running sum, row k begins at starts[k + 1], and
        // after its entries are placed it ends there, which is where row k + 1 begins.
        for (row, j) in rows.entries() {
            if j as usize >= targets {
                self.resize(0);
                return Err(NeighborError::NoTarget { row, particle: j, targets });
            }
            self.blocks[j as usize / BLOCK].starts[j as usize % BLOCK + 2] += 1;
        }
        for block in self.used_mut() {
            let mut sum = 0;
            for start in &mut block.starts {
                sum += *start;
                *start = sum;
            }
            block.reserve(0, sum);
        }
        for (row, j) in rows.entries() {
            let block = &mut self.blocks[j as usize / BLOCK];
            let place = &mut block.starts[j as usize % BLOCK + 1];
            block.indices[*place] = row as u32;
            *place += 1;
        }
        for block in self.used_mut() {
            block.starts.pop();
        }
        Ok(())
    }

    /// All entries as (row, index).
    fn entries(&self) -> impl Iterator<Item = (usize, u32)> {
        (0..self.len).flat_map(|row| self.row(row).iter().map(move |&j| (row, j)))
    }

    fn used(&self) -> &[Block] {
        &self.blocks[..self.len.div_ceil(BLOCK)]
    }

    pub(crate) fn used_mut(&mut self) -> &mut [Block] {
        &mut self.blocks[..self.len.div_ceil(BLOCK)]
    }

    /// Makes room for `len` rows and forgets what they held.
    pub(crate) fn resize(&mut self, len: usize) {
        self.len = len;
        let used = len.div_ceil(BLOCK);
        if self.blocks.len() < used {
            self.blocks.resize_with(used, Block::default);
        }
        for block in &mut self.blocks {
            block.starts.clear();
        }
    }
}

impl Block {
    /// Entries of all rows.
    pub(crate) fn pairs(&self) -> usize {
        self.starts.last().copied().unwrap_or(0)
    }

    /// Makes sure that `more` entries fit behind the first `len`.
    #[inline]
    pub(crate) fn reserve(&mut self, len: usize, more: usize) {
        if self.indices.len() < len + more {
            self.grow(len + more);
        }
    }

    /// Headroom of a quarter, so that rows that grow a little do not move every time. A vector left to
    /// itself would double.
    #[cold]
    fn grow(&mut self, least: usize) {
        let room = least + least / 4 + 64;
        self.indices.reserve_exact(room - self.indices.len());
        self.indices.resize(room, 0);
    }
}
