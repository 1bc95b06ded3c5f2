//! Names such as `mu_1` and `H''` in programming languages.

/// The name as an identifier of a programming language: primes become `_d1`, `_d2`, ..., and a reserved word gets a
/// trailing underscore.
pub(super) fn identifier(name: &str, reserved: &[&str]) -> String {
    let body = name.trim_end_matches('\'');
    match name.len() - body.len() {
        0 if reserved.contains(&name) => format!("{name}_"),
        0 => name.to_owned(),
        primes => format!("{body}_d{primes}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_words_and_primes_make_safe_identifiers() {
        assert_eq!(identifier("lambda", &["lambda"]), "lambda_");
        assert_eq!(identifier("H''", &[]), "H_d2");
    }
}
