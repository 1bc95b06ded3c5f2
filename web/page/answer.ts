// What was found of a statement: the verdict first, then what it rests on.

import { download, make, say } from "./dom.ts";
import { mathematics, type SetFormula } from "./mathematics.ts";

/** What a module says of a statement; see `modules/formulas/src/lib.rs`. */
export interface Described {
  verdict: string;
  says: string;
  evidence: string | null;
  replayed: boolean | null;
  statement: SetFormula | null;
  conditions: SetFormula[];
  correction: { formula: SetFormula; marked: [string, string] } | null;
  witness: { at: [string, string][]; left: string; right: string } | null;
  steps: string[];
  explanation: [string, string][][];
}

/** How a verdict is told: a sign, and a sentence. */
export const VERDICTS: Record<string, { sign: string; says: string }> = {
  holds: { sign: "✓", says: "True" },
  conditional: { sign: "≈", says: "True under a condition" },
  misprint: { sign: "✗", says: "False as stated, and a correction is proved" },
  false: { sign: "✗", says: "False" },
  undecided: { sign: "?", says: "Not decided" },
  vacuous: { sign: "∅", says: "It says nothing: no values satisfy its hypotheses" },
  depends: { sign: "?", says: "It depends on the reading" },
};

/** The answer as cards. */
export function showAnswer(place: HTMLElement, found: Described, json: Uint8Array<ArrayBuffer>): void {
  const parts: Node[] = [];
  const head = make("div", { class: `verdict verdict-${found.verdict}` });
  const told = VERDICTS[found.verdict];
  head.append(make("span", { class: "sign", "aria-hidden": "true" }, told?.sign ?? "·"));
  const words = make("div", {}, make("h2", {}, told?.says ?? found.says));
  if (found.replayed !== null) {
    words.append(make("p", { class: "note" }, found.replayed ? "Decided exactly; an independent checker accepts the proof." : "Decided exactly; the checker does not follow the proof."));
  }
  head.append(words);
  parts.push(head);
  if (found.correction) {
    const { formula, marked } = found.correction;
    parts.push(
      part("What is right", make("div", { class: "mathematics" }, mathematics(formula)), make("p", { class: "was" }, ...markedText(marked[0], "del")), make("p", { class: "now" }, ...markedText(marked[1], "ins"))),
    );
  }
  if (found.witness) parts.push(part("Where it is false", counterexample(found.witness)));
  if (found.conditions.length > 0) {
    parts.push(part("True provided that", ...found.conditions.map((formula) => make("div", { class: "mathematics" }, mathematics(formula)))));
  }
  parts.push(part("How it was found", explanation(found)));
  parts.push(source(json));
  place.replaceChildren(make("article", { class: "card" }, ...parts));
}

function part(title: string, ...content: Node[]): HTMLElement {
  return make("section", { class: "part" }, make("h3", {}, title), ...content);
}

/** The text with what is between » and « in an element of its own. */
function markedText(text: string, tag: "del" | "ins"): Node[] {
  return text.split(/[»«]/).map((piece, k) => (k % 2 === 1 ? make(tag, {}, piece) : document.createTextNode(piece)));
}

function counterexample(witness: { at: [string, string][]; left: string; right: string }): HTMLElement {
  const row = (name: string, value: string) => make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, value));
  const rows = witness.at.map(([name, value]) => row(name, value));
  rows.push(row("left side", witness.left), row("right side", witness.right));
  return make("div", { class: "scrolled", tabindex: "0" }, make("table", {}, make("tbody", {}, ...rows)));
}

function explanation(found: Described): HTMLElement {
  const list = make("dl", { class: "explanation" });
  for (const group of found.explanation) {
    for (const [label, text] of group) {
      if (label === "verdict") continue;
      if (label !== "") list.append(make("dt", {}, label));
      list.append(make("dd", {}, text));
    }
  }
  return list;
}

/** The JSON of the command, to be seen, copied and kept. */
function source(json: Uint8Array<ArrayBuffer>): HTMLElement {
  const text = new TextDecoder().decode(json);
  const copy = make("button", { type: "button" }, "Copy");
  copy.addEventListener("click", async () => {
    await navigator.clipboard?.writeText(text).catch(() => {});
    say("Copied.");
  });
  const keep = make("button", { type: "button" }, "Download");
  keep.addEventListener("click", () => download("torse-decide.json", json));
  const pretty = make("pre", { id: "json", tabindex: "0" }, text);
  return make("details", {}, make("summary", {}, "JSON, as torse decide --format json"), make("div", { class: "bar" }, copy, keep), pretty);
}
