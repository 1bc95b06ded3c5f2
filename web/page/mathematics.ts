// Formulas as MathML.

import { make } from "./dom.ts";

/** A formula in the forms that a page shows and copies. */
export interface SetFormula {
  text: string;
  latex: string;
  mathml: string[];
}

/** The formula as an element; a line may be broken between its pieces. */
export function mathematics(formula: SetFormula): HTMLElement {
  const place = make("span", { class: "formula", title: formula.text });
  for (const piece of formula.mathml) {
    // MathML of the module: read as a document of its own, in which no script runs.
    const read = new DOMParser().parseFromString(piece, "text/html");
    place.append(make("span", { class: "formula-piece" }, ...read.body.childNodes), " ");
  }
  return place;
}
