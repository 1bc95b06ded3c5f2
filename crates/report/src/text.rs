//! Makes strings safe to show: nothing hidden, nothing that acts on its surroundings.

/// Spells out as `‹U+202E›` every invisible character that would act on the text around it: control characters other
/// than the line break, and the marks that change the direction of writing.
pub(crate) fn visible(text: &str) -> String {
    replace(text, |character| !acts_unseen(character))
}

/// Puts a text on one line of Markdown, with the signs of HTML as entities and each further sign as `mark` writes it.
pub(crate) fn escape_markdown(text: &str, mark: impl Fn(char) -> Option<String>) -> String {
    let mut plain = String::with_capacity(text.len());
    for character in visible(text).chars() {
        match character {
            '&' => plain.push_str("&amp;"),
            '<' => plain.push_str("&lt;"),
            '>' => plain.push_str("&gt;"),
            '\n' => plain.push(' '),
            _ => match mark(character) {
                Some(written) => plain.push_str(&written),
                None => plain.push(character),
            },
        }
    }
    plain
}

/// Spells out every character that `keep` refuses as `‹U+E0F6›`.
pub(crate) fn replace(text: &str, keep: impl Fn(char) -> bool) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        if keep(character) {
            shown.push(character);
        } else {
            shown.push_str(&format!("‹U+{:04X}›", u32::from(character)));
        }
    }
    shown
}

fn acts_unseen(character: char) -> bool {
    (character.is_control() && character != '\n')
        || matches!(
            character,
            '\u{061C}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{FEFF}' | '\u{FFF9}'..='\u{FFFB}'
        )
}

/// Writes decimals for readers: no row of zeros, a minus sign, an ellipsis.
pub(crate) fn decimal(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = match first.is_ascii_digit() {
            true => rest
                .find(|c: char| !c.is_ascii_digit() && c != '.')
                .unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (number, after) = rest.split_at(end);
        let digits = number.trim_end_matches('.');
        let zero = digits.contains('.') && digits.chars().all(|c| matches!(c, '0' | '.'));
        match (number, first) {
            (_, '-') => shown.push('−'),
            _ if zero => shown.push('0'),
            _ if number.ends_with("...") => {
                shown.push_str(digits);
                shown.push('…');
            }
            _ => shown.push_str(number),
        }
        rest = after;
    }
    shown
}

/// Makes an identifier of letters, digits and hyphens, for links: other characters become hyphens.
pub(crate) fn anchor(text: &str) -> String {
    let plain = |character: char| {
        if character.is_ascii_alphanumeric() {
            character
        } else {
            '-'
        }
    };
    text.chars().map(plain).collect()
}

/// Returns the name of a claim: its id without the paper's slug.
pub(crate) fn name(id: &str) -> &str {
    id.split_once('/').map_or(id, |(_, name)| name)
}

/// Returns the text if it has at most `length` characters; otherwise its beginning, up to a whole word, and an
/// ellipsis.
pub(crate) fn beginning(text: &str, length: usize) -> String {
    let Some((cut, _)) = text.char_indices().nth(length) else {
        return text.to_owned();
    };
    let (start, _) = text.split_at(cut);
    let words = start.rsplit_once(' ').map_or(start, |(words, _)| words);
    format!("{words} …")
}

/// Merges each run of equal steps, or of equal pairs and triples, into one, followed by its count.
#[must_use]
pub fn counted(steps: &[String]) -> Vec<String> {
    let bare = |step: &String| step.trim_end_matches('.').to_owned();
    let steps: Vec<String> = steps.iter().map(bare).collect();
    let mut list = Vec::new();
    let mut rest = steps.as_slice();
    while !rest.is_empty() {
        let repeats = |period: usize| {
            let first = rest.get(..period).unwrap_or_default();
            rest.chunks_exact(period)
                .take_while(|chunk| *chunk == first)
                .count()
        };
        // The shortest pattern that covers most.
        let best = (1..=3_usize.min(rest.len()))
            .map(|period| (period, repeats(period)))
            .filter(|(_, times)| *times > 1)
            .max_by_key(|(period, times)| (period * times, std::cmp::Reverse(*period)));
        let (period, times) = best.unwrap_or((1, 1));
        let (taken, _) = rest.split_at(period);
        list.extend(taken.iter().cloned());
        if let (Some(last), true) = (list.last_mut(), times > 1) {
            match period {
                1 => last.push_str(&format!(" ({times} times)")),
                _ => last.push_str(&format!(" (these {period} steps {times} times)")),
            }
        }
        rest = rest.get(period * times..).unwrap_or_default();
    }
    list
}

/// Returns the heading under which a claim is listed, from its place in the paper.
///
/// `Sect. 3.2, eq. (3.7)` is in `Section 3`; tables and figures have headings of their own; anything else
/// is listed under its first words, up to a comma, semicolon or bracket.
pub(crate) fn section_title(at: &str) -> String {
    let start = at.split([',', ';', '(']).next().unwrap_or_default().trim();
    if let Some(number) = start.strip_prefix("Sect.") {
        let main: String = number
            .trim()
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        if !main.is_empty() {
            return format!("Section {main}");
        }
    }
    match start.split(['.', ' ']).next() {
        Some("Fig" | "Figs" | "Figure" | "Figures") => "Figures".to_owned(),
        Some("Table" | "Tables") => "Tables".to_owned(),
        _ if start.is_empty() => "Elsewhere".to_owned(),
        _ => start.to_owned(),
    }
}

/// Returns the identifier of a figure in the report, by its number among the figures of the paper, from 1.
pub(crate) fn figure_anchor(number: usize) -> String {
    format!("figure-{number}")
}

/// Returns the number of a figure from its place in the paper: `2(a)` for `Fig. 2 (a)` and `Sect. 3.1, Figure 2(a)`.
pub(crate) fn figure_number(at: &str) -> Option<String> {
    let (_, after) = at.split_once("Fig")?;
    let after = after
        .trim_start_matches("ure")
        .trim_start_matches('.')
        .trim_start();
    let digits = after
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(after.len());
    let (number, rest) = after.split_at(digits);
    if number.is_empty() {
        return None;
    }
    let panel = rest.trim_start().strip_prefix('(').and_then(|rest| {
        let (letter, _) = rest.split_once(')')?;
        (letter.len() == 1 && letter.chars().all(|c| c.is_ascii_lowercase())).then_some(letter)
    });
    Some(match panel {
        Some(letter) => format!("{number}({letter})"),
        None => number.to_owned(),
    })
}

/// Returns the rank of a heading in a report: first everything before the first numbered section, then sections by
/// number, tables, figures. Headings of one rank keep their order.
pub(crate) fn section_rank(title: &str) -> usize {
    let number = title
        .strip_prefix("Section ")
        .and_then(|number| number.parse().ok());
    match (title, number) {
        ("Tables", _) => usize::MAX - 1,
        ("Figures", _) => usize::MAX,
        (_, Some(number)) => number,
        _ => 0,
    }
}

/// Lists words: "a, b and c".
pub(crate) fn enumeration(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_have_no_rows_of_zeros() {
        assert_eq!(
            decimal("[0.000000000000..., -0.8660254...], 1.5"),
            "[0, −0.8660254…], 1.5"
        );
    }

    #[test]
    fn unseen_characters_are_spelled_out_and_everything_else_is_kept() {
        assert_eq!(
            visible("a\u{202E}b\u{0}c\nπ²·𝔽"),
            "a‹U+202E›b‹U+0000›c\nπ²·𝔽"
        );
    }

    #[test]
    fn sections_are_named_by_their_main_number() {
        assert_eq!(section_title("Sect. 3.2, eq. (3.7)"), "Section 3");
        assert_eq!(section_title("Sect. 12"), "Section 12");
        assert_eq!(section_title("Sect. two, remark"), "Sect. two");
        assert_eq!(section_title("Fig. 10 (b)"), "Figures");
        assert_eq!(section_title("Table 1, row 2"), "Tables");
        assert_eq!(section_title("Abstract; second sentence"), "Abstract");
        assert_eq!(section_title(""), "Elsewhere");
    }

    #[test]
    fn sections_stand_by_number_before_tables_and_figures() {
        let mut titles = [
            "Figures",
            "Section 10",
            "Section 2",
            "Abstract",
            "Tables",
            "Sect. two",
        ];
        titles.sort_by_key(|title| section_rank(title));
        assert_eq!(
            titles,
            [
                "Abstract",
                "Sect. two",
                "Section 2",
                "Section 10",
                "Tables",
                "Figures"
            ]
        );
    }

    #[test]
    fn a_beginning_ends_with_a_whole_word_and_short_texts_stay_whole() {
        assert_eq!(beginning("one two three", 13), "one two three");
        assert_eq!(beginning("one two three", 12), "one two …");
        assert_eq!(beginning("πππππ", 3), "πππ …");
    }

    #[test]
    fn equal_steps_in_a_row_are_counted() {
        let steps = ["a", "a", "a", "b", "a"].map(str::to_owned);
        assert_eq!(counted(&steps), ["a (3 times)", "b", "a"]);
        let pairs = ["a", "b", "a", "b", "a", "b.", "c"].map(str::to_owned);
        assert_eq!(counted(&pairs), ["a", "b (these 2 steps 3 times)", "c"]);
        assert!(counted(&[]).is_empty());
    }

    #[test]
    fn anchors_hold_letters_digits_and_hyphens_only() {
        assert_eq!(anchor("eq-5.16 <b>\"é"), "eq-5-16--b---");
    }
}
