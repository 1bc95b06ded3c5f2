//! The rules of cutting services, as data.

use serde::{Deserialize, Serialize};

/// What a rule looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Check {
    /// The file states its unit.
    Units,
    /// There are no texts.
    Text,
    /// There is nothing but lines, arcs and curves.
    OnlyLines,
    /// Every contour is closed.
    Closed,
    /// No line lies twice in one place.
    Doubled,
    /// No contour crosses itself or another.
    Crossing,
    /// There is one part in the file.
    OnePart,
    /// How wide openings are.
    Hole,
    /// How far contours are from each other, and across material from themselves.
    Web,
    /// The radii of arcs.
    Radius,
    /// How many lines and arcs a contour has.
    Nodes,
    /// How long each of them is.
    ShortLines,
    /// The sides of the box around the part, the longer first: `at-most` bounds the longer, `at-least` the shorter.
    Size,
}

impl Check {
    /// Returns what its rules are about too, and is not looked at.
    #[must_use]
    pub fn not_looked_at(self) -> Option<&'static str> {
        match self {
            Self::Web => Some("slits"),
            _ => None,
        }
    }

    /// Returns the name in rule files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Units => "units",
            Self::Text => "text",
            Self::OnlyLines => "only-lines",
            Self::Closed => "closed",
            Self::Doubled => "doubled",
            Self::Crossing => "crossing",
            Self::OnePart => "one-part",
            Self::Hole => "hole",
            Self::Web => "web",
            Self::Radius => "radius",
            Self::Nodes => "nodes",
            Self::ShortLines => "short-lines",
            Self::Size => "size",
        }
    }
}

/// A rule and who publishes it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct LintRule {
    /// What it looks at.
    pub check: Check,
    /// The least that passes, in millimetres, or a count.
    #[serde(default)]
    pub at_least: Option<f64>,
    /// The most that passes.
    #[serde(default)]
    pub at_most: Option<f64>,
    /// What is added to the least, as a multiple of the thickness.
    #[serde(default)]
    pub per_thickness: Option<f64>,
    /// Who publishes it, and what it says.
    pub source: String,
    /// Where it is published.
    #[serde(default)]
    pub url: Option<String>,
}

impl LintRule {
    /// Returns the least that passes for a sheet of this thickness; none where the rule depends on a thickness that is
    /// not known.
    #[must_use]
    pub fn least(&self, thickness: Option<f64>) -> Option<f64> {
        match self.per_thickness {
            None => self.at_least,
            Some(share) => Some(self.at_least.unwrap_or(0.0) + share * thickness?),
        }
    }
}

/// The rules that a file is checked against.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct LintRules {
    /// Layers that are not cut, in small letters; a star stands for any letters.
    #[serde(default)]
    pub not_cut: Vec<String>,
    /// Ends that are no farther apart are one point, in millimetres.
    pub joined_within: f64,
    /// The rules.
    pub rules: Vec<LintRule>,
}

impl LintRules {
    /// Returns the rules of a file.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn parse(text: &str) -> Result<Self, String> {
        let rules: Self = toml::from_str(text).map_err(|error| error.to_string())?;
        let numbers = rules.rules.iter().flat_map(|rule| {
            [rule.at_least, rule.at_most, rule.per_thickness]
                .into_iter()
                .flatten()
        });
        if numbers
            .chain([rules.joined_within])
            .any(|n| !n.is_finite() || n < 0.0)
        {
            return Err("a bound is a number of at least 0".to_owned());
        }
        if rules.joined_within == 0.0 {
            return Err("`joined-within` is positive".to_owned());
        }
        for rule in &rules.rules {
            let bounded =
                rule.at_least.is_some() || rule.at_most.is_some() || rule.per_thickness.is_some();
            let needs = matches!(
                rule.check,
                Check::Hole
                    | Check::Web
                    | Check::Radius
                    | Check::Nodes
                    | Check::ShortLines
                    | Check::Size
            );
            if bounded != needs {
                let words = if needs {
                    "needs a bound"
                } else {
                    "has no bound"
                };
                return Err(format!("the check `{}` {words}", rule.check.name()));
            }
        }
        Ok(rules)
    }

    /// Returns the published rules that every worked design keeps.
    ///
    /// # Errors
    /// As [`LintRules::parse`]; a test says that there are none.
    pub fn published() -> Result<Self, String> {
        Self::parse(include_str!("rules.toml"))
    }

    /// Returns whether a layer of this name is cut.
    #[must_use]
    pub fn is_cut(&self, layer: &str) -> bool {
        let layer = layer.to_lowercase();
        !self
            .not_cut
            .iter()
            .any(|pattern| match pattern.strip_suffix('*') {
                Some(start) => layer.starts_with(start),
                None => layer == *pattern,
            })
    }
}
