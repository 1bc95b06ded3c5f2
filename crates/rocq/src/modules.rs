//! Takes files of statements and proofs apart into a head and one module for each claim.

/// A file taken apart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Parts<'a> {
    /// The text before the first module.
    pub(crate) head: &'a str,
    /// The modules in order: names, and texts up to the next module.
    pub(crate) modules: Vec<(&'a str, &'a str)>,
}

/// Takes a file apart.
pub(crate) fn split(text: &str) -> Parts<'_> {
    let mut starts: Vec<usize> = text
        .match_indices("\nModule ")
        .map(|(place, _)| place)
        .collect();
    let head = text.get(..starts.first().copied().unwrap_or(text.len()));
    starts.push(text.len());
    let modules = starts
        .iter()
        .zip(starts.iter().skip(1))
        .filter_map(|(from, to)| {
            let body = text.get(*from..*to)?;
            let name = body.strip_prefix("\nModule ")?.lines().next()?;
            Some((name.strip_suffix('.')?, body))
        });
    Parts {
        head: head.unwrap_or(""),
        modules: modules.collect(),
    }
}

/// Joins the parts of a file.
pub(crate) fn join<'a>(head: &str, modules: impl IntoIterator<Item = &'a str>) -> String {
    modules.into_iter().fold(head.to_owned(), |mut text, body| {
        text.push_str(body);
        text
    })
}

/// Returns the same file with some of its modules; `None` if none is left.
pub(crate) fn with_some(text: &str, is_kept: impl Fn(&str) -> bool) -> Option<String> {
    let parts = split(text);
    let kept = parts.modules.iter().filter(|(name, _)| is_kept(name));
    let kept: Vec<&str> = kept.map(|(_, body)| *body).collect();
    (!kept.is_empty()).then(|| join(parts.head, kept))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_taken_apart_is_put_together_again() {
        let text =
            "head\nOpen Scope R_scope.\n\nModule one.\nx\nEnd one.\n\nModule two.\nEnd two.\n";
        let parts = split(text);
        let names: Vec<&str> = parts.modules.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, ["one", "two"]);
        let bodies = parts.modules.iter().map(|(_, body)| *body);
        assert_eq!(join(parts.head, bodies), text);
        assert_eq!(split("head").head, "head");
    }
}
