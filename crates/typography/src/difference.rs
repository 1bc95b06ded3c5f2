//! Marks the differences of two lines of text, for outputs without formulas.

/// The signs before and after a difference.
const MARKS: [char; 2] = ['»', '«'];

/// Longer lines, in words and signs, are not compared.
const MAX_TERMS: usize = 3_000;

/// Returns both lines with their differences marked, word by word and sign by sign.
///
/// ```
/// let [old, new] = torse_typography::difference("c (a + λ k)", "c (a + 4 λ k)");
/// assert_eq!([old.as_str(), new.as_str()], ["c (a + λ k)", "c (a + »4« λ k)"]);
/// ```
#[must_use]
pub fn difference(old: &str, new: &str) -> [String; 2] {
    let (old, new) = (tokens(old), tokens(new));
    if old.len().max(new.len()) > MAX_TERMS {
        return [old.concat(), new.concat()];
    }
    let mut kept_old = vec![false; old.len()];
    let mut kept_new = vec![false; new.len()];
    for (i, j) in common(&old, &new, |a, b| a == b) {
        if let (Some(a), Some(b)) = (kept_old.get_mut(i), kept_new.get_mut(j)) {
            (*a, *b) = (true, true);
        }
    }
    unkeep_brackets(&old, &mut kept_old);
    unkeep_brackets(&new, &mut kept_new);
    [marked(&old, &kept_old), marked(&new, &kept_new)]
}

/// Counts brackets and blanks alone between two differences as part of them.
fn unkeep_brackets(tokens: &[&str], kept: &mut [bool]) {
    let differs = kept.iter().enumerate().filter(|(_, kept)| !**kept);
    let places: Vec<usize> = differs.map(|(place, _)| place).collect();
    for pair in places.windows(2) {
        let between = pair[0] + 1..pair[1];
        let is_bracket = |token: &&str| "()[]{} \u{a0}".contains(*token);
        if tokens[between.clone()].iter().all(is_bracket) {
            kept[between].fill(false);
        }
    }
}

/// Splits into whole words and numbers, and single signs and blanks.
fn tokens(text: &str) -> Vec<&str> {
    let mut list = vec![];
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = match first.is_alphanumeric() {
            true => rest
                .find(|c: char| !c.is_alphanumeric())
                .unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (token, after) = rest.split_at_checked(end).unwrap_or((rest, ""));
        list.push(token);
        rest = after;
    }
    list
}

fn marked(tokens: &[&str], kept: &[bool]) -> String {
    let [open, close] = MARKS;
    let mut text = String::new();
    let mut inside = false;
    for (position, token) in tokens.iter().enumerate() {
        // A blank is marked only between two marked words.
        let blank = token.trim().is_empty();
        let next = kept.get(position + 1).copied().unwrap_or(true);
        let wanted = match blank {
            true => inside && !next,
            false => !kept.get(position).copied().unwrap_or(true),
        };
        if wanted != inside {
            text.push(if wanted { open } else { close });
            inside = wanted;
        }
        text.push_str(token);
    }
    if inside {
        text.push(close);
    }
    text
}

/// Returns the positions of a longest common subsequence.
pub(crate) fn common<T>(
    old: &[T],
    new: &[T],
    same: impl Fn(&T, &T) -> bool,
) -> Vec<(usize, usize)> {
    let width = new.len() + 1;
    // lengths[i * width + j] is the length of a longest common subsequence of old[i..] and new[j..].
    let mut lengths = vec![0_usize; (old.len() + 1) * width];
    let at =
        |lengths: &[usize], i: usize, j: usize| lengths.get(i * width + j).copied().unwrap_or(0);
    for (i, a) in old.iter().enumerate().rev() {
        for (j, b) in new.iter().enumerate().rev() {
            let length = match same(a, b) {
                true => at(&lengths, i + 1, j + 1) + 1,
                false => at(&lengths, i + 1, j).max(at(&lengths, i, j + 1)),
            };
            if let Some(cell) = lengths.get_mut(i * width + j) {
                *cell = length;
            }
        }
    }
    let (mut i, mut j, mut list) = (0, 0, Vec::new());
    while let (Some(a), Some(b)) = (old.get(i), new.get(j)) {
        if same(a, b) {
            list.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if at(&lengths, i + 1, j) >= at(&lengths, i, j + 1) {
            i += 1;
        } else {
            j += 1;
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_side_by_side_share_a_mark() {
        assert_eq!(
            difference("the starting generator J(0)", "the ending generator J(1)"),
            [
                "the »starting« generator J(»0«)",
                "the »ending« generator J(»1«)"
            ]
        );
        assert_eq!(difference("a b c", "a x y c"), ["a »b« c", "a »x y« c"]);
        assert_eq!(difference("", "a"), ["", "»a«"]);
    }
}
