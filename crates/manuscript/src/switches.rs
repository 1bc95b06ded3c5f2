//! Conditionals of TeX: `\iffalse`, `\iftrue` and the switches of `\newif`.

use std::collections::BTreeMap;
use torse_syntax::latex::token::PlacedTex;

/// The conditionals that ask about the state of TeX, which is not known here.
const ASKING: [&str; 17] = [
    "if",
    "ifcat",
    "ifx",
    "ifnum",
    "ifdim",
    "ifodd",
    "ifvmode",
    "ifhmode",
    "ifmmode",
    "ifinner",
    "ifvoid",
    "ifhbox",
    "ifvbox",
    "ifeof",
    "ifcase",
    "ifdefined",
    "ifcsname",
];

/// The switches of a manuscript, each on or off.
#[derive(Debug, Default)]
pub struct Switches {
    state: BTreeMap<String, bool>,
    /// How many conditionals are open of which a part is kept.
    kept: usize,
}

impl Switches {
    /// Takes what a control sequence asks for out of the tokens that follow, the next one last. None if it is no conditional;
    /// else why it is not followed, if it is not.
    pub fn take(&mut self, name: &str, input: &mut Vec<PlacedTex>) -> Option<Option<String>> {
        match name {
            "newif" => {
                let switch = input.pop()?.command()?.strip_prefix("if")?.to_owned();
                self.state.insert(switch, false);
                return Some(None);
            }
            "fi" if self.kept > 0 => {
                self.kept -= 1;
                return Some(None);
            }
            "else" if self.kept > 0 => {
                self.kept -= 1;
                let _ = self.skip(input, false);
                return Some(None);
            }
            _ => {}
        }
        if let Some(switch) = name.strip_suffix("true").or(name.strip_suffix("false"))
            && let Some(state) = self.state.get_mut(switch)
        {
            *state = name.ends_with("true");
            return Some(None);
        }
        match self.holds(name)? {
            Some(true) => self.kept += 1,
            Some(false) => self.kept += usize::from(self.skip(input, true)),
            None => {
                let _ = self.skip(input, false);
                return Some(Some(format!(
                    "what `\\{name}` asks for is not known here: nothing is read up to its `\\fi`"
                )));
            }
        }
        Some(None)
    }

    /// Whether a conditional holds; none of what is no conditional, none inside of what is not known.
    #[expect(
        clippy::option_option,
        reason = "a conditional whose answer is not known is not no conditional"
    )]
    fn holds(&self, name: &str) -> Option<Option<bool>> {
        match name {
            "iftrue" => Some(Some(true)),
            "iffalse" => Some(Some(false)),
            _ if ASKING.contains(&name) => Some(None),
            _ => Some(Some(*self.state.get(name.strip_prefix("if")?)?)),
        }
    }

    /// Leaves out everything up to the matching `\fi`, or to the `\else` where that may end it.
    /// Returns whether it ends there.
    fn skip(&self, input: &mut Vec<PlacedTex>, to_else: bool) -> bool {
        let mut open = 0_usize;
        while let Some(token) = input.pop() {
            match token.command() {
                Some("fi") if open == 0 => return false,
                Some("fi") => open -= 1,
                Some("else") if open == 0 && to_else => return true,
                Some(name) if self.holds(name).is_some() => open += 1,
                _ => {}
            }
        }
        false
    }
}
