//! Numbers that there are: with the number, or to be found; and statements that no number fulfils, somewhere or anywhere.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(2) {
        0 => there_is(stream),
        _ => there_is_none(stream),
    }
}

fn declared(claim: Claim) -> Claim {
    claim
        .symbol("x", "{ in = '[0, 1]' }")
        .symbol("y", "{}")
        .symbol("r", "{}")
        .symbol("s", "{}")
        .symbol("u", "{ in = '[0, 1]' }")
        .symbol("v", "{ in = '(0, 1)' }")
        .symbol("w", "{ in = '(0, inf)' }")
}

/// A claim with these witnesses, which it names half of the time.
fn seeking(
    stream: &mut Stream,
    states: String,
    truth: Truth,
    witnesses: &[(&str, String)],
) -> Claim {
    let mut claim = declared(Claim::new(Kind::Exists, States::Other(states), truth));
    let told = stream.once_in(2);
    for (name, value) in witnesses {
        let whole = format!("{name} == {value}");
        claim.exists.push(match told {
            true => whole.clone(),
            false => (*name).to_owned(),
        });
        claim.witnesses.push(whole);
    }
    claim
}

fn there_is(stream: &mut Stream) -> Claim {
    let (k, l) = (stream.positive(), stream.positive());
    let p = format!(
        "({}*x*y + {}*y + {})",
        stream.fraction(),
        stream.fraction(),
        k
    );
    match stream.below(8) {
        0 => {
            let states = format!("({k} + y^2)*r == {p}");
            seeking(
                stream,
                states,
                Truth::Holds,
                &[("r", format!("{p}/({k} + y^2)"))],
            )
        }
        1 => {
            let states = format!("r + {k}*s == {p} and r - {l}*s == y");
            let s = format!("({p} - y)/({k} + {l})");
            let r = format!("{p} - {k}*({s})");
            seeking(stream, states, Truth::Holds, &[("r", r), ("s", s)])
        }
        2 => {
            let states = format!("({k} + {l})*u == {k}*x + {l}*x^2");
            let u = format!("({k}*x + {l}*x^2)/({k} + {l})");
            seeking(stream, states, Truth::Holds, &[("u", u)])
        }
        3 => {
            let states = format!("y != 0 implies y*r == {p}");
            seeking(stream, states, Truth::Holds, &[("r", format!("{p}/y"))])
        }
        4 => {
            // No number does at y = 0.
            let states = format!("y*r == {k}");
            seeking(
                stream,
                states,
                Truth::Conditional,
                &[("r", format!("{k}/y"))],
            )
        }
        5 => {
            let states = format!("w - {k} == y^2");
            seeking(stream, states, Truth::Holds, &[("w", format!("y^2 + {k}"))])
        }
        6 => {
            let states = "s == abs(y) and r + s > y".to_owned();
            let mut claim = seeking(
                stream,
                states,
                Truth::Holds,
                &[("r", k.to_string()), ("s", "abs(y)".to_owned())],
            );
            claim.exists = claim.witnesses.clone();
            claim
        }
        _ => {
            // The witness is a wrong one: nothing follows.
            let states = format!("r == {p}");
            let mut claim = seeking(stream, states, Truth::Holds, &[("r", p.clone())]);
            if stream.once_in(4) {
                claim.exists = vec![format!("r == {p} + {k}")];
            }
            claim
        }
    }
}

fn there_is_none(stream: &mut Stream) -> Claim {
    let (k, l) = (stream.positive(), stream.positive());
    let fails = |place: &str| Truth::Fails(place.to_owned());
    match stream.below(5) {
        0 => {
            let states = format!("({k} + {l})*v == {k}*x + {l}*x^2");
            let v = format!("({k}*x + {l}*x^2)/({k} + {l})");
            seeking(stream, states, fails("x = 0"), &[("v", v)])
        }
        1 => {
            let states = format!("u == x + {k}");
            seeking(stream, states, fails("x = 1"), &[("u", format!("x + {k}"))])
        }
        2 => {
            let states = format!("r^2 + {k} == 0");
            seeking(
                stream,
                states,
                fails("everywhere"),
                &[("r", "y".to_owned())],
            )
        }
        3 => {
            let states = format!("w == y^2 - {k}");
            seeking(
                stream,
                states,
                fails("y = 0"),
                &[("w", format!("y^2 - {k}"))],
            )
        }
        _ => {
            let states = format!("r == y and 2*r == 2*y + {k}");
            seeking(
                stream,
                states,
                fails("everywhere"),
                &[("r", "y".to_owned())],
            )
        }
    }
}
