//! What a loop over particles writes to: one slice or several, visited together.

/// One or several mutable slices of equal length that can be cut in two.
pub trait Fields: Send + Sized {
    /// References to one entry of every slice.
    type Item;
    /// Length of the shortest slice.
    fn len(&self) -> usize;
    /// Whether there is no entry.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Cuts every slice at `middle`.
    fn cut(self, middle: usize) -> (Self, Self);
    /// Visits the entries in order; the first one is particle `first`.
    fn for_each(self, first: usize, each: impl Fn(usize, Self::Item));
}

impl<'a, A: Send> Fields for &'a mut [A] {
    type Item = &'a mut A;

    fn len(&self) -> usize {
        <[A]>::len(self)
    }

    fn cut(self, middle: usize) -> (Self, Self) {
        self.split_at_mut(middle)
    }

    #[inline(always)]
    fn for_each(self, first: usize, each: impl Fn(usize, Self::Item)) {
        for (k, item) in self.iter_mut().enumerate() {
            each(first + k, item);
        }
    }
}

macro_rules! fields_of_tuple {
    ($($slice:ident $head:ident $tail:ident),+) => {
        impl<'a, $($slice: Send),+> Fields for ($(&'a mut [$slice],)+) {
            type Item = ($(&'a mut $slice,)+);

            #[allow(non_snake_case)]
            fn len(&self) -> usize {
                let ($($slice,)+) = self;
                usize::MAX$(.min($slice.len()))+
            }

            #[allow(non_snake_case)]
            fn cut(self, middle: usize) -> (Self, Self) {
                let ($($slice,)+) = self;
                $(let ($head, $tail) = $slice.split_at_mut(middle);)+
                (($($head,)+), ($($tail,)+))
            }

            #[inline(always)]
            #[allow(non_snake_case)]
            fn for_each(self, first: usize, each: impl Fn(usize, Self::Item)) {
                let len = self.len();
                let ($($slice,)+) = self;
                $(let mut $slice = $slice[..len].iter_mut();)+
                for k in 0..len {
                    // All iterators yield exactly `len` entries.
                    if let ($(Some($head),)+) = ($($slice.next(),)+) {
                        each(first + k, ($($head,)+));
                    }
                }
            }
        }
    };
}

fields_of_tuple!(A a0 a1, B b0 b1);
fields_of_tuple!(A a0 a1, B b0 b1, C c0 c1);
fields_of_tuple!(A a0 a1, B b0 b1, C c0 c1, E e0 e1);
fields_of_tuple!(A a0 a1, B b0 b1, C c0 c1, E e0 e1, G g0 g1);
