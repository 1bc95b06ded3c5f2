//! The interface for programs.

use crate::paper;
use torse_report::verdicts_json;

#[test]
fn the_json_of_a_claim_has_its_fields_in_order_and_null_where_there_is_nothing() {
    let text = verdicts_json(&paper::sample().claims[3..5]).unwrap();
    assert_eq!(
        text,
        r#"{
  "claims": [
    {
      "id": "sample/thm-4.det",
      "kind": "identity",
      "verdict": "false",
      "evidence": "witness",
      "part_of": null,
      "printed": "det H = 0 for every n",
      "reading": null,
      "garbled": null,
      "finding": null,
      "parsed": "det(H) == 0",
      "corrected": null,
      "corrected_condition": null,
      "condition": null,
      "witness": {
        "at": {
          "n": "2"
        },
        "left": "1/12",
        "right": "0",
        "left_decimal": "0.0833[3, 4]",
        "right_decimal": "0"
      },
      "note": null,
      "net": {
        "netted": false,
        "tried": 0,
        "decided": 0,
        "unvisited": [],
        "instances": 0,
        "why": "a sample",
        "conditions": [],
        "correction": null
      },
      "replay": null,
      "contradiction": null,
      "hypotheses": [],
      "symbols": [],
      "definitions": [],
      "bases": [],
      "unknowns": [],
      "readings": []
    },
    {
      "id": "sample/eq-5.third",
      "kind": "construction",
      "verdict": "conditional",
      "evidence": "identity",
      "part_of": null,
      "printed": "Q¹_1 = Q_m + (1/α₁)(Q_m − Q_{m−1})",
      "reading": null,
      "garbled": null,
      "finding": null,
      "parsed": "Q1 == Q[m] + ...",
      "corrected": null,
      "corrected_condition": null,
      "condition": "alpha_1 != 0 and mu + nu + 2 != 0",
      "witness": null,
      "note": null,
      "net": {
        "netted": false,
        "tried": 0,
        "decided": 0,
        "unvisited": [],
        "instances": 0,
        "why": "a sample",
        "conditions": [],
        "correction": null
      },
      "replay": null,
      "contradiction": null,
      "hypotheses": [],
      "symbols": [],
      "definitions": [],
      "bases": [],
      "unknowns": [],
      "readings": []
    }
  ],
  "totals": {
    "claims": 2,
    "verdicts": {
      "conditional": 1,
      "false": 1
    },
    "remarks": {
      "total": 0,
      "proved": 0,
      "conditional": 0
    }
  }
}
"#
    );
}

#[test]
fn the_json_keeps_the_order_of_the_file_and_of_the_witness_and_any_string() {
    let sample = paper::sample();
    let text = verdicts_json(&sample.claims).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let claims = value["claims"].as_array().unwrap();
    let ids: Vec<&str> = claims
        .iter()
        .map(|claim| claim["id"].as_str().unwrap())
        .collect();
    let expected: Vec<&str> = sample
        .claims
        .iter()
        .map(|outcome| outcome.claim.id.as_str())
        .collect();
    assert_eq!(ids, expected);
    assert_eq!(claims[5]["printed"], paper::HOSTILE);
    let place = |name: &str| text.find(&format!("\"{name}\": ")).unwrap();
    assert!(place("k") < place("mu") && place("mu") < place("nu"));
}
