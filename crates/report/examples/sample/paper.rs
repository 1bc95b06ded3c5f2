//! A made-up paper with every verdict, long formulas, and strings that try to be markup.

use std::sync::Arc;
use torse_certificate::Proof;
use torse_certificate::proof::Emptiness;
use torse_plot::{Ambient, Interactive, InteractiveError, Part, Shape, Slider, palette};
use torse_prove::evidence::{Evidence, Witness};
use torse_report::{FigureImage, Image};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::claim_record::{Assumed, ClaimRecord, HypothesisSource, Role};
use torse_verdicts::correction::Correction;
use torse_verdicts::dependencies::Dependencies;
use torse_verdicts::finding::Finding;
use torse_verdicts::finding::Readings;
use torse_verdicts::judged::{Judged, Net};
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::statement::{
    EmptyDomain, FigureFinding, ProvedStatement, RefutedStatement, Repair, UndecidedStatement,
};

/// A string of everything that is markup somewhere.
pub const HOSTILE: &str = "#panic(1) $x$ @ref <label> </article><script>alert(1)</script> & \\ ` * _ \" ' \u{202E} \u{E0F6} \u{0} 漢 ﷽ 🂡";

fn formula(text: &str) -> Formula {
    Formula {
        text: text.to_owned(),
    }
}

fn assumed(text: &str) -> Assumed {
    Assumed {
        role: Role::Assume,
        formula: formula(text),
        from: HypothesisSource::Stated,
        needed: None,
    }
}

/// A claim of the sample as it is listed below.
struct Sample {
    name: &'static str,
    at: &'static str,
    kind: Kind,
    verdict: Verdict,
    printed: &'static str,
    evidence: Option<Evidence>,
    reading: Option<String>,
    parsed: Option<Formula>,
    assumed: Vec<Assumed>,
    conditions: Vec<Formula>,
    correction: Option<Correction>,
    derived: Option<Formula>,
    difference: Option<Formula>,
    witness: Option<Witness>,
    steps: Vec<String>,
    note: Option<String>,
    uses: Vec<String>,
    expect: Option<Verdict>,
}

fn entry(
    name: &'static str,
    at: &'static str,
    kind: Kind,
    verdict: Verdict,
    printed: &'static str,
) -> Sample {
    Sample {
        name,
        at,
        kind,
        verdict,
        printed,
        evidence: None,
        reading: None,
        parsed: None,
        assumed: Vec::new(),
        conditions: Vec::new(),
        correction: None,
        derived: None,
        difference: None,
        witness: None,
        steps: Vec::new(),
        note: None,
        uses: Vec::new(),
        expect: None,
    }
}

/// What its judges found of something: little.
fn judged<T>(statement: T) -> Box<Judged<T>> {
    Box::new(Judged {
        statement,
        net: Net::without_points("a sample"),
        replay: None,
    })
}

/// A proof of nothing, each step of which says that no point is to be looked at, for one of these reasons.
pub fn proved(evidence: Evidence, conditions: Vec<Formula>, reasons: Vec<String>) -> Finding {
    let nowhere = |reason: String| Proof::Nowhere(Emptiness::Undefined(reason));
    Finding::Proved(judged(ProvedStatement {
        evidence,
        conditions,
        needed: vec![],
        certificate: Arc::new(DecisionCertificate::Proof {
            conditions: vec![],
            of: Proof::Parts(reasons.into_iter().map(nowhere).collect()),
        }),
        ranges: vec![],
        witnesses: vec![],
    }))
}

/// A refutation at this point.
#[allow(dead_code, reason = "for tests")]
pub fn refuted(witness: Option<Witness>) -> Finding {
    Finding::Refuted(judged(without_repair(None, witness)))
}

fn without_repair(evidence: Option<Evidence>, witness: Option<Witness>) -> RefutedStatement {
    RefutedStatement {
        evidence: evidence.unwrap_or(Evidence::Witness),
        witness,
        difference: None,
        derived: None,
        certificate: None,
        repair: None,
        data: None,
        search_ended_early: false,
        parts: vec![],
        no_number: None,
    }
}

impl Sample {
    fn finding(&mut self) -> Finding {
        let steps = std::mem::take(&mut self.steps);
        let evidence = self.evidence;
        match self.verdict {
            Verdict::Definition => Finding::Definition,
            Verdict::Reproduced | Verdict::Partial => Finding::Figure(FigureFinding {
                verdict: self.verdict,
                missing: steps,
                replaced: vec![],
                assumed: vec![],
            }),
            Verdict::Underspecified => Finding::Underspecified(String::new()),
            Verdict::OutOfScope => Finding::OutOfScope(String::new()),
            Verdict::Vacuous => Finding::Vacuous(judged(EmptyDomain {
                emptiness: Emptiness::Range("x".to_owned()),
                witnesses: vec![],
            })),
            Verdict::Undecided => Finding::Undecided(UndecidedStatement {
                reasons: steps,
                evidence,
            }),
            Verdict::Depends => Finding::Readings(Readings::new(vec![])),
            Verdict::Holds | Verdict::Conditional => proved(
                evidence.unwrap_or(Evidence::Identity),
                std::mem::take(&mut self.conditions),
                steps,
            ),
            Verdict::False | Verdict::Misprint => Finding::Refuted(judged(RefutedStatement {
                difference: self.difference.take(),
                derived: self.derived.take(),
                repair: self.correction.take().map(Repair::Misprint),
                ..without_repair(evidence, self.witness.take())
            })),
        }
    }

    fn outcome(mut self) -> Outcome {
        Outcome {
            finding: self.finding(),
            claim: ClaimRecord {
                id: format!("sample/{}", self.name),
                paper: "sample".to_owned(),
                at: self.at.to_owned(),
                kind: self.kind,
                printed: self.printed.to_owned(),
                part_of: None,
                reading: self.reading,
                garbled: None,
                compared: self.parsed.is_some(),
                parsed: self.parsed,
                assumed: self.assumed,
                table: Dependencies::default(),
                author_note: None,
                note: self.note,
                uses: self.uses,
                expect: self.expect,
            },
        }
    }
}

/// A sum of `terms` terms, the shape of a long difference.
fn long_sum(terms: usize) -> String {
    let term = |n: usize| {
        format!(
            "{}/{} mu^{} nu pi^2 sin(pi/2 x)^{}",
            3 * n + 1,
            2 * n + 1,
            n % 4 + 1,
            n % 3 + 1
        )
    };
    (1..=terms).map(term).collect::<Vec<_>>().join(" - ")
}

/// The paper.
pub fn sample() -> PaperOutcome {
    PaperOutcome {
        slug: "sample".to_owned(),
        title: "Shape-adjustable sample surfaces with blended trigonometric Bézier patches and their continuity".to_owned(),
        authors: "A. Ångström, B. Øst & C. Müller".to_owned(),
        venue: "Journal of Invented Results 12 (2021) 459".to_owned(),
        claims: [basis(), conditions(), values(), rest()]
            .into_iter()
            .flatten()
            .map(Sample::outcome)
            .collect(),
        faults: vec![],
        restored: None,
    }
}

fn basis() -> Vec<Sample> {
    let definition = Sample {
        parsed: Some(formula("g[0,2](x) == (1 - s)*(1 - mu*s)")),
        ..entry(
            "def-1.g0",
            "Sect. 2.1, Definition 1",
            Kind::Definition,
            Verdict::Definition,
            "g_{0,2}(x) = (1 − sin(π/2 x)) (1 − μ sin(π/2 x))",
        )
    };
    let holds = Sample {
        evidence: Some(Evidence::Induction),
        parsed: Some(formula("sum(i, 0, k, f[i,k](x)) == 1")),
        assumed: vec![assumed("k >= 2"), assumed("mu in [-1, 1]")],
        steps: vec![
            "the sum over a range that is empty".to_owned(),
            "the quotient at zero".to_owned(),
        ],
        uses: vec!["sample/def-1.g0".to_owned()],
        ..entry(
            "thm-2.b",
            "Sect. 2.1, Theorem 2 (b)",
            Kind::Identity,
            Verdict::Holds,
            "Σ_{i=0}^{k} f_{i,k}(x) = 1",
        )
    };
    let misprint = Sample {
        evidence: Some(Evidence::Identity),
        reading: Some(
            "The copy prints “fl” for f and drops the prime; read as a second derivative."
                .to_owned(),
        ),
        parsed: Some(formula("D(f[0,k], x, 2)(0) == pi^2/4*(mu + 2*k*mu + k^2)")),
        assumed: vec![assumed("k >= 2")],
        correction: Some(Correction {
            statement: formula(
                "D(f[0,k], x, 2)(0) == pi^2/4*(2*mu + 2*(k-2)*(1+mu) + (k-2)*(k-3))",
            ),
            conditions: vec![],
            edits: vec![
                "the factor 2 added before μ".to_owned(),
                "k replaced by k − 2".to_owned(),
            ],
            unique: true,
        }),
        derived: Some(formula("pi^2/4*(...)")),
        difference: Some(formula("1/4*pi^2*mu + ...")),
        witness: Some(Witness {
            at: vec![
                ("k".to_owned(), "3".to_owned()),
                ("mu".to_owned(), "1/2".to_owned()),
                ("nu".to_owned(), "-355/1130".to_owned()),
            ],
            left:
                "3/4*pi^2 + 12345678901234567890123456789/9876543210987654321098765432109876543210"
                    .to_owned(),
            right: "17/8*pi^2".to_owned(),
            left_decimal: "7.4022033008170[1, 2]".to_owned(),
            right_decimal: "20.972909352315[0, 1]".to_owned(),
        }),
        note: Some(
            "The condition of Theorem 4 is derived from this value and inherits the error."
                .to_owned(),
        ),
        uses: vec![
            "sample/def-1.g0".to_owned(),
            "sample/thm-2.b".to_owned(),
            "other/eq-9".to_owned(),
        ],
        ..entry(
            "eq-3.7",
            "Sect. 2.2, eq. (3.7), second line",
            Kind::Identity,
            Verdict::Misprint,
            "f''_{0,k}(0) = (π²/4)(μ + 2kμ + k²)",
        )
    };
    vec![definition, holds, misprint]
}

fn conditions() -> Vec<Sample> {
    let wrong = Sample {
        evidence: Some(Evidence::Witness),
        parsed: Some(formula("det(H) == 0")),
        derived: Some(formula(&long_sum(14))),
        difference: Some(formula(&long_sum(60))),
        witness: Some(Witness {
            at: vec![("n".to_owned(), "2".to_owned())],
            left: "1/12".to_owned(),
            right: "0".to_owned(),
            left_decimal: "0.0833[3, 4]".to_owned(),
            right_decimal: "0".to_owned(),
        }),
        uses: vec!["sample/eq-3.7".to_owned()],
        ..entry(
            "thm-4.det",
            "Sect. 3.2, Theorem 4",
            Kind::Identity,
            Verdict::False,
            "det H = 0 for every n",
        )
    };
    let conditional = Sample {
        evidence: Some(Evidence::Identity),
        parsed: Some(formula("Q1 == Q[m] + ...")),
        conditions: vec![formula("alpha_1 != 0"), formula("mu + nu + 2 != 0")],
        ..entry(
            "eq-5.third",
            "Sect. 3.3, eq. (5), third line",
            Kind::Construction,
            Verdict::Conditional,
            "Q¹_1 = Q_m + (1/α₁)(Q_m − Q_{m−1})",
        )
    };
    let hostile = Sample {
        parsed: Some(formula(HOSTILE)),
        reading: Some(HOSTILE.to_owned()),
        note: Some(HOSTILE.to_owned()),
        steps: vec![HOSTILE.to_owned()],
        ..entry(
            "hostile <&\">#$@",
            "Sect. 3.4 <b>",
            Kind::Property,
            Verdict::Undecided,
            HOSTILE,
        )
    };
    vec![wrong, conditional, hostile]
}

fn values() -> Vec<Sample> {
    let enclosed = Sample {
        evidence: Some(Evidence::Enclosure),
        parsed: Some(formula("kappa(1/2) == 0.7320")),
        steps: vec!["the root of a negative number".to_owned()],
        ..entry(
            "ex-5.2.kappa",
            "Sect. 5.2, Example 2",
            Kind::Value,
            Verdict::Holds,
            "κ(1/2) ≈ 0.7320",
        )
    };
    let inequality = Sample {
        evidence: Some(Evidence::Inequality),
        parsed: Some(formula("f[i,k](x) >= 0")),
        expect: Some(Verdict::Conditional),
        ..entry(
            "thm-2.a",
            "Sect. 5.2, Theorem 2 (a)",
            Kind::Inequality,
            Verdict::Holds,
            "f_{i,k}(x) ≥ 0 for x ∈ [0, 1]",
        )
    };
    let range = Sample {
        evidence: Some(Evidence::CheckedRange),
        note: Some(
            "Checked for every degree k ≤ 12; no proof for all degrees was found.".to_owned(),
        ),
        ..entry(
            "thm-3.tp",
            "Sect. 5.3, Theorem 3",
            Kind::Property,
            Verdict::Undecided,
            "The basis is totally positive, therefore the curve is variation diminishing.",
        )
    };
    vec![enclosed, inequality, range]
}

fn rest() -> Vec<Sample> {
    let of = |name, at, kind, verdict, printed| entry(name, at, kind, verdict, printed);
    vec![
        of(
            "tab-1.r2",
            "Table 1, second row",
            Kind::Value,
            Verdict::Underspecified,
            "(0, 1, 2, −1)",
        ),
        of(
            "sec-6.vacuous",
            "Sect. 6, last remark",
            Kind::Property,
            Verdict::Vacuous,
            "If μ > 1 and μ < −1, the surface is a cylinder.",
        ),
        of(
            "sec-6.easy",
            "Sect. 6, last line",
            Kind::Prose,
            Verdict::OutOfScope,
            "The method is easy to use in practice.",
        ),
        of(
            "fig-1",
            "Fig. 1",
            Kind::Figure,
            Verdict::Reproduced,
            "Basis functions of degree 3 for three shape parameters.",
        ),
        of(
            "fig-2",
            "Fig. 2 (a)",
            Kind::Figure,
            Verdict::Partial,
            "A vase.",
        ),
    ]
}

/// Pictures: one beside a claim and mentioned by another, one of a claim's own, one of no claim.
pub fn figures() -> Vec<FigureImage> {
    let of = |name: &str, caption: &str, image: Image, claims: &[&str]| FigureImage {
        name: name.to_owned(),
        caption: caption.to_owned(),
        alt: format!("A picture of {name}"),
        image,
        claims: claims.iter().map(|id| (*id).to_owned()).collect(),
        verdict: Verdict::Reproduced,
        assumes: Vec::new(),
        stand_in: Vec::new(),
        interactive: None,
        torse: None,
        step: None,
    };
    let basis = of(
        "basis",
        "The basis functions of degree 3 for μ = ν = 0 (solid) and μ = ν = 1 (dashed).",
        Image::Svg(curves()),
        &["sample/fig-1", "sample/thm-2.b"],
    );
    let gap = of(
        "gap",
        "The printed second derivative (dashed) and the true one: the gap is at x = 0.",
        Image::Svg(curves()),
        &["sample/eq-3.7"],
    );
    let hostile = of(
        "hostile",
        HOSTILE,
        Image::Png(PIXEL.to_vec()),
        &["sample/nowhere"],
    );
    vec![
        FigureImage {
            interactive: arch().ok(),
            ..basis
        },
        FigureImage {
            verdict: Verdict::Partial,
            assumes: vec!["the view".to_owned(), "the range of `x`".to_owned()],
            ..gap
        },
        FigureImage {
            verdict: Verdict::Underspecified,
            stand_in: vec![HOSTILE.to_owned()],
            ..hostile
        },
    ]
}

/// A surface (u, v, 1 - u^2 + mu v^2 + mu nu u v) over the square, its diagonal and three points.
pub fn arch() -> Result<Interactive, InteractiveError> {
    let slider = |name: &str, start: f64| Slider {
        name: name.to_owned(),
        label: format!("$\\{name}_{{1}}$"),
        least: -1.0,
        greatest: 1.0,
        start,
        step: 0.01,
    };
    let at = |k: usize, n: usize| 2.0 * k as f64 / (n - 1) as f64 - 1.0;
    let nets = |points: Vec<[f64; 2]>| -> Vec<Vec<[f64; 3]>> {
        vec![
            points.iter().map(|[u, v]| [*u, *v, 1.0 - u * u]).collect(),
            points.iter().map(|[_, v]| [0.0, 0.0, v * v]).collect(),
            points.iter().map(|[u, v]| [0.0, 0.0, u * v]).collect(),
        ]
    };
    let part = |number: usize, label: &str, shape: Shape, points: Vec<[f64; 2]>| Part {
        label: label.to_owned(),
        colour: palette(number),
        shape,
        nets: nets(points),
    };
    let (rows, columns) = (25, 13);
    let grid = |rows: usize, columns: usize| {
        (0..rows * columns)
            .map(|k| [at(k / columns, rows), at(k % columns, columns)])
            .collect::<Vec<_>>()
    };
    let parts = vec![
        part(
            0,
            "$S(u, v)$",
            Shape::Surface { columns, rows },
            grid(rows, columns),
        ),
        part(
            1,
            "diagonal",
            Shape::Curve,
            (0..33).map(|k| [at(k, 33); 2]).collect(),
        ),
        part(
            2,
            "net",
            Shape::Net {
                columns: 3,
                rows: 3,
            },
            grid(3, 3),
        ),
        part(
            3,
            "",
            Shape::Points,
            vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        ),
    ];
    Interactive::new(
        vec![slider("mu", 0.5), slider("nu", 0.0)],
        vec![vec![0, 0], vec![1, 0], vec![1, 1]],
        Ambient::Space,
        parts,
    )
}

/// A small plot, drawn by hand.
fn curves() -> String {
    let path = |power: i32, style: &str| {
        let point = |n: i32| {
            let x = f64::from(n) / 40.0;
            let y =
                x.powi(power) * (1.0 - x).powi(3 - power) * [1.0, 3.0, 3.0, 1.0][power as usize];
            format!("{:.1},{:.1}", 30.0 + 340.0 * x, 190.0 - 160.0 * y)
        };
        let points: Vec<String> = (0..=40).map(point).collect();
        format!(
            "<polyline fill=\"none\" stroke-width=\"2\" {style} points=\"{}\"/>",
            points.join(" ")
        )
    };
    let styles = [
        "stroke=\"#0072b2\"",
        "stroke=\"#d55e00\"",
        "stroke=\"#009e73\" stroke-dasharray=\"6 4\"",
        "stroke=\"#cc79a7\"",
    ];
    let curves: String = styles
        .iter()
        .zip(0..)
        .map(|(style, power)| path(power, style))
        .collect();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 400 220\" width=\"400\" height=\"220\"><path d=\"M30 20V190H380\" fill=\"none\" stroke=\"#333\"/>{curves}</svg>"
    )
}

/// A picture of one grey pixel.
const PIXEL: &[u8] = &[
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3A, 0x7E, 0x9B,
    0x55, 0x00, 0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9C, 0x63, 0x68, 0x00, 0x00, 0x00,
    0x82, 0x00, 0x81, 0x77, 0xCD, 0x72, 0xB6, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE,
    0x42, 0x60, 0x82,
];
