//! What styles say about where an element is and whether it is seen: attributes, `style` and the style sheets of the file.
//!
//! Of style sheets those rules matter that set `display`, `visibility` or `transform`. Selectors are a name, a class, an id,
//! or a name with a class; a rule of another kind that sets one of the three is refused.

use crate::read::error::{ReadResult, at_line};
use roxmltree::{Document, Node};

/// The properties that matter.
const PROPERTIES: [&str; 5] = [
    "display",
    "visibility",
    "transform",
    "transform-origin",
    "transform-box",
];

/// A rule of a style sheet for one selector.
struct Rule<'d> {
    /// The name of the element, unless it is any.
    tag: Option<&'d str>,
    class: Option<&'d str>,
    id: Option<&'d str>,
    declarations: Vec<(&'d str, &'d str)>,
}

impl Rule<'_> {
    fn fits(&self, node: Node<'_, '_>) -> bool {
        let classes = node.attribute("class").unwrap_or_default();
        self.tag.is_none_or(|tag| tag == node.tag_name().name())
            && self
                .class
                .is_none_or(|class| classes.split_whitespace().any(|own| own == class))
            && self.id.is_none_or(|id| node.attribute("id") == Some(id))
    }

    /// The higher goes before the lower.
    fn rank(&self) -> [bool; 3] {
        [self.id.is_some(), self.class.is_some(), self.tag.is_some()]
    }
}

/// The style sheets of a file.
pub(super) struct Styles<'d> {
    rules: Vec<Rule<'d>>,
}

impl<'d> Styles<'d> {
    /// Reads the style sheets.
    ///
    /// # Errors
    /// A rule that hides or moves something, by a selector that is not read.
    pub(super) fn new(document: &'d Document<'d>) -> ReadResult<Self> {
        let mut rules = Vec::new();
        let is_style = |node: &Node<'_, '_>| node.tag_name().name() == "style";
        for node in document.root().descendants().filter(is_style) {
            let line = document.text_pos_at(node.range().start).row;
            let line = usize::try_from(line).unwrap_or(1);
            for text in node.children().filter_map(|child| child.text()) {
                sheet(text, line, &mut rules)?;
            }
        }
        Ok(Self { rules })
    }

    /// The value of a property: that of the element's own `style`, of the rule of the highest rank, the last of them, of the
    /// attribute.
    pub(super) fn property(&self, node: Node<'d, 'd>, name: &str) -> Option<&'d str> {
        let own = declarations(node.attribute("style").unwrap_or_default())
            .filter(|(property, _)| *property == name)
            .last();
        if let Some((_, value)) = own {
            return Some(value);
        }
        let mut found: Option<([bool; 3], &'d str)> = None;
        for rule in self.rules.iter().filter(|rule| rule.fits(node)) {
            let own = rule
                .declarations
                .iter()
                .rev()
                .find(|(property, _)| *property == name);
            if let Some((_, value)) = own
                && found.is_none_or(|(rank, _)| rule.rank() >= rank)
            {
                found = Some((rule.rank(), value));
            }
        }
        found.map(|(_, value)| value).or(node.attribute(name))
    }
}

/// The declarations `name: value` of a text.
fn declarations(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split(';').filter_map(|part| {
        let (name, value) = part.split_once(':')?;
        let value = value.trim();
        let value = value.strip_suffix("!important").unwrap_or(value);
        Some((name.trim(), value.trim()))
    })
}

/// The rules of a style sheet.
fn sheet<'d>(text: &'d str, line: usize, rules: &mut Vec<Rule<'d>>) -> ReadResult<()> {
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        let (body, next) = after.split_once('}').unwrap_or((after, ""));
        rest = next;
        // A comment before the selector.
        let head = before.rsplit("*/").next().unwrap_or(before).trim();
        let wanted = |(name, _): &(&str, &str)| PROPERTIES.contains(name);
        let all: Vec<(&str, &str)> = declarations(body).filter(wanted).collect();
        if head.starts_with('@') || body.contains('{') {
            if PROPERTIES.iter().any(|name| body.contains(name)) {
                return Err(refused(line, head));
            }
            continue;
        }
        if all.is_empty() {
            continue;
        }
        for selector in head.split(',').map(str::trim) {
            let rule = simple(selector, &all).ok_or_else(|| refused(line, selector))?;
            rules.push(rule);
        }
    }
    Ok(())
}

fn refused(line: usize, selector: &str) -> crate::read::ReadError {
    let shown: String = selector.chars().take(40).collect();
    at_line(
        line,
        format!(
            "the style sheet hides or moves elements by `{shown}`: read are names, classes and ids"
        ),
    )
}

/// The rule of a selector `name`, `.class`, `name.class`, `#id` or `*`.
fn simple<'d>(selector: &'d str, all: &[(&'d str, &'d str)]) -> Option<Rule<'d>> {
    let is_name = |text: &str| {
        !text.is_empty()
            && text
                .chars()
                .all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
    };
    let mut rule = Rule {
        tag: None,
        class: None,
        id: None,
        declarations: all.to_vec(),
    };
    if let Some(id) = selector.strip_prefix('#') {
        rule.id = Some(id).filter(|id| is_name(id));
        return rule.id.is_some().then_some(rule);
    }
    let (tag, class) = match selector.split_once('.') {
        Some((tag, class)) => (tag, Some(class)),
        None => (selector, None),
    };
    if !matches!(tag, "" | "*") {
        rule.tag = Some(tag).filter(|tag| is_name(tag));
        rule.tag?;
    }
    if let Some(class) = class {
        rule.class = Some(class).filter(|class| is_name(class));
        rule.class?;
    }
    Some(rule).filter(|_| !selector.is_empty())
}
