//! Powers by repeated squaring.

/// `base` to the power of `exponent`; `one` is the power zero.
pub(crate) fn power<T: Clone>(base: &T, exponent: u32, one: T, times: impl Fn(&T, &T) -> T) -> T {
    let mut result = one;
    let (mut base, mut rest) = (base.clone(), exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            result = times(&result, &base);
        }
        rest /= 2;
        if rest > 0 {
            base = times(&base, &base);
        }
    }
    result
}
