//! The one way through a state, in both directions.

use super::{Section, StateError};
use crate::{FieldVisitor, ParticleStore};
use bytemuck::Pod;
use core::fmt::Display;
use core::slice::{Iter, from_mut};

/// Where the values go.
#[derive(Debug)]
pub(super) enum Way<'a> {
    Out(&'a mut Vec<Section>),
    In(Iter<'a, Section>),
}

/// Goes through a state and saves or restores it. Sections come back in the order in which they were saved, and none may be left out.
/// The first error ends a transfer; what follows is left alone.
#[derive(Debug)]
pub struct Transfer<'a> {
    way: Way<'a>,
    /// Names of the parts around, each with a slash behind it.
    scope: String,
    done: Result<(), StateError>,
}

impl<'a> Transfer<'a> {
    pub(super) fn new(way: Way<'a>) -> Self {
        Self { way, scope: String::new(), done: Ok(()) }
    }

    pub(super) fn finish(self) -> Result<(), StateError> {
        self.done?;
        match self.way {
            Way::In(mut left) => match left.next() {
                Some(section) => Err(StateError::Left { section: section.name.clone() }),
                None => Ok(()),
            },
            Way::Out(_) => Ok(()),
        }
    }

    /// Whether values come back; else they are saved.
    pub fn is_restoring(&self) -> bool {
        matches!(self.way, Way::In(_))
    }

    /// Whether all has gone well so far.
    pub fn is_good(&self) -> bool {
        self.done.is_ok()
    }

    /// A field of any length.
    pub fn list<F: Pod>(&mut self, name: &str, values: &mut Vec<F>) {
        if let Some(bytes) = self.pass(name, values) {
            let entries = bytes.len().checked_div(size_of::<F>()).unwrap_or(values.len());
            values.resize(entries, F::zeroed());
            bytemuck::cast_slice_mut(values).copy_from_slice(bytes);
        }
    }

    /// Values whose number stays.
    pub fn array<F: Pod>(&mut self, name: &str, values: &mut [F]) {
        let Some(bytes) = self.pass(name, values) else { return };
        if bytes.len() == size_of_val(values) {
            bytemuck::cast_slice_mut(values).copy_from_slice(bytes);
        } else {
            let found = bytes.len().checked_div(size_of::<F>()).unwrap_or(0);
            self.fail(StateError::Length { section: self.named(name), expected: values.len(), found });
        }
    }

    /// A single value.
    pub fn value<F: Pod>(&mut self, name: &str, value: &mut F) {
        self.array(name, from_mut(value));
    }

    /// Marks whose number stays.
    pub fn flags(&mut self, name: &str, values: &mut [bool]) {
        let mut marks: Vec<u8> = values.iter().map(|value| u8::from(*value)).collect();
        self.array(name, &mut marks);
        values.iter_mut().zip(marks).for_each(|(value, mark)| *value = mark != 0);
    }

    /// A single mark.
    pub fn flag(&mut self, name: &str, value: &mut bool) {
        self.flags(name, from_mut(value));
    }

    /// A number that is not restored but has to be the same: of parts, of boundaries.
    pub fn same(&mut self, name: &str, value: usize) {
        let mut saved = value as u64;
        self.value(name, &mut saved);
        if saved != value as u64 {
            self.refuse(format_args!(
                "the saved state has {saved} for '{name}' and here are {value}: restore it into a scene built like the one that was saved"
            ));
        }
    }

    /// The fields of particles whose number may have changed.
    pub fn particles(&mut self, store: &mut impl ParticleStore) {
        store.for_each_field(self);
        if self.is_good() {
            let mut lengths = Lengths { expected: store.len(), wrong: None };
            store.for_each_field(&mut lengths);
            if let Some((name, found)) = lengths.wrong {
                self.fail(StateError::Length { section: self.named(name), expected: store.len(), found });
            }
        }
    }

    /// The fields of particles whose number stays.
    pub fn fixed_particles(&mut self, store: &mut impl ParticleStore) {
        store.for_each_field(&mut Fixed(self));
    }

    /// Puts `scope` before the names of what `inner` goes through.
    pub fn within(&mut self, scope: &str, inner: impl FnOnce(&mut Self)) {
        let outside = self.scope.len();
        self.scope += scope;
        self.scope.push('/');
        inner(self);
        self.scope.truncate(outside);
    }

    /// Ends the transfer for a reason of one's own, which says what to do.
    pub fn refuse(&mut self, reason: impl Display) {
        let part = self.scope.trim_end_matches('/').to_owned();
        self.fail(StateError::Refused { part, reason: reason.to_string() });
    }

    fn named(&self, name: &str) -> String {
        format!("{}{name}", self.scope)
    }

    fn fail(&mut self, error: StateError) {
        if self.done.is_ok() {
            self.done = Err(error);
        }
    }

    /// Saves the values, or returns the bytes that were saved of them.
    fn pass<F: Pod>(&mut self, name: &str, values: &[F]) -> Option<&'a [u8]> {
        if self.done.is_err() {
            return None;
        }
        let (name, entry) = (self.named(name), size_of::<F>());
        let error = match &mut self.way {
            Way::Out(sections) => {
                sections.push(Section { name, entry, bytes: bytemuck::cast_slice(values).to_vec() });
                return None;
            }
            Way::In(sections) => match sections.next() {
                None => StateError::Missing { section: name },
                Some(found) if found.name != name => {
                    StateError::Other { expected: name, found: found.name.clone() }
                }
                Some(found)
                    if found.entry != entry || found.bytes.len().checked_rem(entry).unwrap_or(0) != 0 =>
                {
                    StateError::Entry { section: name, expected: entry, found: found.entry }
                }
                Some(found) => return Some(&found.bytes),
            },
        };
        self.fail(error);
        None
    }
}

impl FieldVisitor for Transfer<'_> {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        self.list(name, field);
    }
}

/// Lets no field change its length.
struct Fixed<'t, 'a>(&'t mut Transfer<'a>);

impl FieldVisitor for Fixed<'_, '_> {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        self.0.array(name, field);
    }
}

/// Looks for a field that has another length than the others.
struct Lengths {
    expected: usize,
    wrong: Option<(&'static str, usize)>,
}

impl FieldVisitor for Lengths {
    fn visit<F: Pod + Send + Sync>(&mut self, name: &'static str, field: &mut Vec<F>) {
        if field.len() != self.expected {
            self.wrong = Some((name, field.len()));
        }
    }
}
