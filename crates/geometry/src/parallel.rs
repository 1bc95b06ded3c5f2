//! Work on all threads with the feature `parallel`; without it the same on the calling thread.
//!
//! Values do not depend on it: whoever shares work collects it in order.

#[cfg(feature = "parallel")]
pub(crate) use rayon::{join, prelude};
#[cfg(not(feature = "parallel"))]
pub(crate) use serial::{join, prelude};

/// The names of rayon that are used here, one step after the other.
#[cfg(not(feature = "parallel"))]
mod serial {
    pub(crate) fn join<A, B>(first: impl FnOnce() -> A, second: impl FnOnce() -> B) -> (A, B) {
        (first(), second())
    }

    /// An iterator with the methods of a parallel one.
    pub(crate) struct Steps<I>(I);

    impl<I: Iterator> Steps<I> {
        pub(crate) fn with_min_len(self, _: usize) -> Self {
            self
        }

        pub(crate) fn map<T>(self, f: impl FnMut(I::Item) -> T) -> Steps<impl Iterator<Item = T>> {
            Steps(self.0.map(f))
        }

        pub(crate) fn zip<J: Iterator>(
            self,
            other: Steps<J>,
        ) -> Steps<impl Iterator<Item = (I::Item, J::Item)>> {
            Steps(self.0.zip(other.0))
        }

        pub(crate) fn enumerate(self) -> Steps<impl Iterator<Item = (usize, I::Item)>> {
            Steps(self.0.enumerate())
        }

        pub(crate) fn all(mut self, f: impl FnMut(I::Item) -> bool) -> bool {
            self.0.all(f)
        }

        pub(crate) fn for_each(self, f: impl FnMut(I::Item)) {
            self.0.for_each(f);
        }

        pub(crate) fn for_each_init<T>(
            self,
            init: impl FnOnce() -> T,
            f: impl Fn(&mut T, I::Item),
        ) {
            let mut own = init();
            self.0.for_each(|item| f(&mut own, item));
        }

        pub(crate) fn try_for_each<E>(
            mut self,
            f: impl FnMut(I::Item) -> Result<(), E>,
        ) -> Result<(), E> {
            self.0.try_for_each(f)
        }

        pub(crate) fn collect<C: FromIterator<I::Item>>(self) -> C {
            self.0.collect()
        }
    }

    pub(crate) mod prelude {
        use super::Steps;

        pub(crate) trait Shares<T> {
            fn par_iter(&self) -> Steps<std::slice::Iter<'_, T>>;
            fn par_chunks(&self, length: usize) -> Steps<std::slice::Chunks<'_, T>>;
            fn par_windows(&self, length: usize) -> Steps<std::slice::Windows<'_, T>>;
            fn par_chunks_mut(&mut self, length: usize) -> Steps<std::slice::ChunksMut<'_, T>>;
        }

        impl<T> Shares<T> for [T] {
            fn par_iter(&self) -> Steps<std::slice::Iter<'_, T>> {
                Steps(self.iter())
            }

            fn par_chunks(&self, length: usize) -> Steps<std::slice::Chunks<'_, T>> {
                Steps(self.chunks(length))
            }

            fn par_windows(&self, length: usize) -> Steps<std::slice::Windows<'_, T>> {
                Steps(self.windows(length))
            }

            fn par_chunks_mut(&mut self, length: usize) -> Steps<std::slice::ChunksMut<'_, T>> {
                Steps(self.chunks_mut(length))
            }
        }

        pub(crate) trait Counted: Iterator + Sized {
            fn into_par_iter(self) -> Steps<Self> {
                Steps(self)
            }
        }

        impl Counted for std::ops::Range<usize> {}
    }
}
