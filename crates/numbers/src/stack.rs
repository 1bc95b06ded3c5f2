//! A large stack for recursion over terms.
//!
//! Formulas are bounded in height and definitions in depth, so every recursion over a term ends. But the product of
//! the two bounds is more frames than the default stack of a thread (two megabytes) holds. Code that recurses over
//! terms therefore runs on a stack large enough for the deepest term.
//!
//! The crate `stacker` makes that stack on the calling thread, not on a thread of its own. So thread-local state,
//! such as the work counted for a job, is the same inside and outside, and the code also works in a web page, where
//! no thread can be started.

/// Size of the stack in bytes. The system provides memory only for the part that is used.
const STACK: usize = 256 << 20;

/// A stack with this many bytes left is used as it is: no recursion over terms needs more.
const MIN_FREE: usize = 128 << 20;

/// Runs `job` on a stack that is large enough for a recursion over any term.
///
/// On platforms where stacks cannot be exchanged, such as WebAssembly, the job runs on the current stack.
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
    stacker::maybe_grow(MIN_FREE, STACK, job)
}
