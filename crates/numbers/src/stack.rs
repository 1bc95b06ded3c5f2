//! A stack for walks over terms.
//!
//! Formulas are bounded in height and definitions in depth, so every walk over a term ends; but their product is more frames
//! than the stack of a thread holds, which is two megabytes unless the program says otherwise. So whoever walks over terms
//! does so on a stack that is as large as any of them needs.
//!
//! The stack is made on the calling thread (by the crate `stacker`), not by a thread of its own: what a thread counts or
//! keeps for itself, such as the work of a job, is the same inside and outside, and there is no thread to be had in a web page.

/// Bytes of a stack. Memory is taken only as far as a stack grows.
const STACK: usize = 256 << 20;

/// Bytes that any walk may need. A stack with as many left is as good as a new one.
const ENOUGH: usize = 128 << 20;

/// Does something that walks over terms, on a stack that is large enough for all that can be written.
///
/// On a platform whose stacks cannot be exchanged, such as WebAssembly, it is done on the stack that there is.
///
/// ```
/// use torse_numbers::stack;
/// fn depth(n: u64) -> u64 {
///     let frame = std::hint::black_box([n; 256]);
///     if n == 0 { 0 } else { 1 + depth(frame[0] - 1) }
/// }
/// // Twenty megabytes of frames on a thread of two.
/// let thread = std::thread::Builder::new().stack_size(2 << 20);
/// let deep = thread.spawn(|| stack::deep(|| depth(10_000)))?;
/// assert_eq!(deep.join().ok(), Some(10_000));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn deep<T>(job: impl FnOnce() -> T) -> T {
    stacker::maybe_grow(ENOUGH, STACK, job)
}
