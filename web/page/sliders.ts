// Sliders and number fields for the numbers of a text.

import { make } from "./dom.ts";
import { type NumberPlace, tidy } from "./numbers.ts";

interface Row {
  row: HTMLElement;
  slider: HTMLInputElement;
  field: HTMLInputElement;
  place: NumberPlace;
}

/** The rows, kept while the text has the same numbers: a slider stays in the hand that drags it. */
export class Sliders {
  private rows = new Map<string, Row>();

  constructor(
    private readonly place: HTMLElement,
    private readonly onChange: (place: NumberPlace, value: number, kind: string) => void,
  ) {}

  /** Shows these numbers, and the one at the caret. */
  show(places: NumberPlace[], caret: NumberPlace | undefined): void {
    const all = caret ? [{ ...caret, name: `${caret.name} (at the caret)` }, ...places] : places;
    const wanted = new Set(all.map((place) => place.name));
    for (const [name, { row, slider, field }] of this.rows) {
      // The row of the caret goes when the caret does, but not from under a hand.
      const held = document.activeElement === slider || document.activeElement === field;
      if (wanted.has(name) || (held && name.endsWith("(at the caret)"))) continue;
      row.remove();
      this.rows.delete(name);
    }
    let previous: HTMLElement | null = null;
    for (const place of all) {
      const row = this.rows.get(place.name) ?? this.add(place);
      this.update(row, place);
      if (!row.row.isConnected || row.row.previousElementSibling !== previous) {
        if (previous) previous.after(row.row);
        else this.place.prepend(row.row);
      }
      previous = row.row;
    }
    const none = this.rows.size === 0;
    this.place.classList.toggle("none", none);
  }

  private add(place: NumberPlace): Row {
    const slider = make("input", { type: "range", "aria-label": place.name, min: String(place.low), max: String(place.high), step: String(place.step) });
    const field = make("input", { type: "text", inputmode: "decimal", "aria-label": `${place.name}, typed`, autocomplete: "off", spellcheck: "false" });
    const row: Row = { row: make("div", { class: "slider" }, make("span", { class: "slider-name", "aria-hidden": "true" }, place.name), slider, field), slider, field, place };
    slider.addEventListener("input", () => this.changed(row, tidy(Number(slider.value)), `slider ${place.name}`));
    field.addEventListener("change", () => {
      const value = Number(field.value.replace(",", "."));
      if (field.value.trim() !== "" && Number.isFinite(value)) this.changed(row, value, "");
      else field.value = String(row.place.value);
    });
    this.rows.set(place.name, row);
    return row;
  }

  private changed(row: Row, value: number, kind: string): void {
    this.onChange(row.place, value, kind);
  }

  private update(row: Row, place: NumberPlace): void {
    row.place = place;
    const { slider, field } = row;
    // A value that was typed outside of the bounds widens them.
    if (place.value < Number(slider.min) || place.value > Number(slider.max)) {
      slider.min = String(Math.min(place.low, place.value));
      slider.max = String(Math.max(place.high, place.value));
    }
    if (Number(slider.value) !== place.value) slider.value = String(place.value);
    if (document.activeElement !== field || field.dataset.shown !== String(place.value)) field.value = String(place.value);
    field.dataset.shown = String(place.value);
  }
}
