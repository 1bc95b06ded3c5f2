//! SHA-256 (FIPS 180-4): fingerprints of statements and proofs.

/// The digest of these parts, each with its length before it, as hexadecimal digits.
#[must_use]
pub fn digest(parts: &[&str]) -> String {
    let mut bytes = vec![];
    for part in parts {
        bytes.extend((part.len() as u64).to_be_bytes());
        bytes.extend(part.as_bytes());
    }
    sha256(&bytes)
        .iter()
        .map(|word| format!("{word:08x}"))
        .collect()
}

/// The first 32 bits of the fractional parts of a root of the first primes: the constants of the standard.
fn constants<const N: usize>(root: fn(f64) -> f64) -> [u32; N] {
    let is_prime = |n: &u32| (2..*n).all(|d| !n.is_multiple_of(d));
    let mut primes = (2..).filter(is_prime);
    std::array::from_fn(|_| {
        let root = root(f64::from(primes.next().unwrap_or(2)));
        // 32 bits after the point are exact: roots below 20 leave 48 bits for the fraction.
        ((root.fract()) * 4_294_967_296.0) as u32
    })
}

fn sha256(message: &[u8]) -> [u32; 8] {
    let constants_of_rounds: [u32; 64] = constants(f64::cbrt);
    let mut state: [u32; 8] = constants(f64::sqrt);
    let mut padded = message.to_vec();
    padded.push(0x80);
    while padded.len() % 64 != 56 {
        padded.push(0);
    }
    padded.extend((message.len() as u64 * 8).to_be_bytes());
    for block in padded.chunks_exact(64) {
        let mut words: Vec<u32> = block
            .chunks_exact(4)
            .map(|four| {
                four.iter()
                    .fold(0, |word, byte| word << 8 | u32::from(*byte))
            })
            .collect();
        let mut round = state;
        for constant in constants_of_rounds {
            let first = words.remove(0);
            let [a, b, c, d, e, f, g, h] = round;
            let sum1 = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
            let choice = (e & f) ^ (!e & g);
            let one = [sum1, choice, constant, first]
                .into_iter()
                .fold(h, u32::wrapping_add);
            let sum0 = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
            let majority = (a & b) ^ (a & c) ^ (b & c);
            let two = sum0.wrapping_add(majority);
            round = [one.wrapping_add(two), a, b, c, d.wrapping_add(one), e, f, g];
            // words[i] is now the word i + 1 of the schedule of sixteen.
            if let [second, .., ninth, _, _, _, _, fourteenth, _] = words.as_slice() {
                let small0 = second.rotate_right(7) ^ second.rotate_right(18) ^ (second >> 3);
                let small1 =
                    fourteenth.rotate_right(17) ^ fourteenth.rotate_right(19) ^ (fourteenth >> 10);
                let next = [small0, *ninth, small1]
                    .into_iter()
                    .fold(first, u32::wrapping_add);
                words.push(next);
            }
        }
        for (old, new) in state.iter_mut().zip(round) {
            *old = old.wrapping_add(new);
        }
    }
    state
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digests_are_those_of_the_standard() {
        let hex = |text: &str| -> String {
            sha256(text.as_bytes())
                .iter()
                .map(|word| format!("{word:08x}"))
                .collect()
        };
        assert_eq!(
            hex("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
        assert_eq!(
            hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
        );
    }

    #[test]
    fn parts_are_told_apart() {
        assert_ne!(digest(&["ab", "c"]), digest(&["a", "bc"]));
    }
}
