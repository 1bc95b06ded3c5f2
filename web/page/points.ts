// The points of a design: a table in which they are typed, and the same numbers of the text when they are dragged.

import { byId, make } from "./dom.ts";
import { tidy } from "./numbers.ts";

/** What a module says of a point; see `modules/designs/src/points.rs`. */
export interface DraggablePoint {
  name: string;
  /** In millimetres. */
  at: [number, number, number];
  /** From where to where each coordinate stands in the text. */
  places: [[number, number], [number, number], [number, number]];
  /** Whether each is a number; formulas are not dragged. */
  plain: [boolean, boolean, boolean];
}

/** The points of a text. */
export interface TextPoints {
  text: string;
  points: DraggablePoint[];
  /** Millimetres of the unit of the text. */
  unit: number;
}

const AXES = ["x", "y", "z"] as const;

/** The text with these coordinates of a point, in its own unit; the others stay as they are. */
export function withPoint(of: TextPoints, point: DraggablePoint, values: (number | undefined)[]): string {
  let { text } = of;
  const order = [0, 1, 2].sort((a, b) => (point.places[b]?.[0] ?? 0) - (point.places[a]?.[0] ?? 0));
  for (const axis of order) {
    const value = values[axis];
    const place = point.places[axis];
    if (value === undefined || !point.plain[axis] || !place) continue;
    text = text.slice(0, place[0]) + String(tidy(value)) + text.slice(place[1]);
  }
  return text;
}

/** A value on the grid of this step; without a step as it is. */
export function snapped(value: number, step: number): number {
  return step > 0 ? tidy(Math.round(value / step) * step) : value;
}

/** A step of one, two or five times a power of ten, about so large. */
export function tidyStep(size: number): number {
  if (!(size > 0)) return 0;
  const power = 10 ** Math.floor(Math.log10(size));
  return tidy(([5, 2, 1].find((k) => k * power <= size) ?? 1) * power);
}

interface Row {
  row: HTMLTableRowElement;
  fields: HTMLInputElement[];
}

/** The table. Its rows are kept while the points have the same names: a field stays under the hand that types. */
export class PointTable {
  private rows = new Map<string, Row>();
  private shown: TextPoints = { text: "", points: [], unit: 1 };
  private readonly body = byId<HTMLTableSectionElement>("points");
  private readonly step = byId<HTMLInputElement>("snap");
  private stepFor = "";

  /** `onChange` is given the new text, and a word for changes that follow each other; `onLook` the point that is looked at. */
  constructor(
    private readonly onChange: (text: string, kind: string) => void,
    private readonly onLook: (name: string) => void,
  ) {}

  /** The grid on which points move, in the unit of the text. */
  get snap(): number {
    const step = Number(this.step.value.replace(",", "."));
    return Number.isFinite(step) && step > 0 ? step : 0;
  }

  /** Shows points; `design` names what they belong to, `size` is its size in millimetres: another design has another grid. */
  show(points: TextPoints, design: string, size: number): void {
    this.shown = points;
    if (this.stepFor !== design) {
      this.stepFor = design;
      this.step.value = String(tidyStep(size / points.unit / 100));
    }
    const listed = this.movable();
    const wanted = new Set(listed.map((point) => point.name));
    for (const [name, { row }] of this.rows) {
      if (wanted.has(name)) continue;
      row.remove();
      this.rows.delete(name);
    }
    for (const point of listed) {
      const { fields } = this.rows.get(point.name) ?? this.add(point.name);
      fields.forEach((field, axis) => this.update(field, point, axis));
    }
    byId("points-card").hidden = listed.length === 0;
  }

  /** The points of which a coordinate is a number. */
  movable(): DraggablePoint[] {
    return this.shown.points.filter(({ plain }) => plain.includes(true));
  }

  private add(name: string): Row {
    const fields = AXES.map((axis) => make("input", { type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", "aria-label": `${name}, ${axis}` }));
    const row = make("tr", {}, make("th", { scope: "row" }, name), ...fields.map((field) => make("td", {}, field)));
    fields.forEach((field, axis) => {
      field.addEventListener("change", () => this.typed(name, axis, field));
      field.addEventListener("keydown", (event) => {
        const way = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
        if (way === 0) return;
        event.preventDefault();
        this.moved(name, axis, way * (event.shiftKey ? 10 : 1));
      });
      field.addEventListener("focus", () => this.onLook(name));
      field.addEventListener("blur", () => this.onLook(""));
    });
    const made = { row, fields };
    this.rows.set(name, made);
    this.body.append(row);
    return made;
  }

  private update(field: HTMLInputElement, point: DraggablePoint, axis: number): void {
    const value = String(tidy((point.at[axis] ?? 0) / this.shown.unit));
    field.disabled = !point.plain[axis];
    field.title = field.disabled ? "a formula of the text" : "";
    if (document.activeElement !== field || field.dataset.shown !== value) field.value = value;
    field.dataset.shown = value;
  }

  /** The point of this name, and the value of its coordinate in the unit of the text. */
  private find(name: string, axis: number): { point: DraggablePoint; value: number } | undefined {
    const point = this.shown.points.find((point) => point.name === name);
    return point && { point, value: (point.at[axis] ?? 0) / this.shown.unit };
  }

  private typed(name: string, axis: number, field: HTMLInputElement): void {
    const value = Number(field.value.replace(",", "."));
    const found = this.find(name, axis);
    if (!found || field.value.trim() === "" || !Number.isFinite(value)) {
      field.value = field.dataset.shown ?? "";
      return;
    }
    this.put(found.point, axis, value, "");
  }

  private moved(name: string, axis: number, steps: number): void {
    const found = this.find(name, axis);
    const step = this.snap || tidyStep(Math.abs(found?.value ?? 1) / 100) || 1;
    if (found) this.put(found.point, axis, snapped(found.value + steps * step, this.snap), `point ${name} ${axis}`);
  }

  private put(point: DraggablePoint, axis: number, value: number, kind: string): void {
    const values = [0, 1, 2].map((k) => (k === axis ? value : undefined));
    const text = withPoint(this.shown, point, values);
    // Another key may come before the design is read again: it goes on from here.
    const after = { ...point, at: [...point.at] as DraggablePoint["at"] };
    after.at[axis] = value * this.shown.unit;
    this.onChange(text, kind);
    if (this.shown.points.includes(point)) this.renew(point, after, text);
  }

  /** The table as if the text with the moved point had been read: its places are behind those of the moved number. */
  private renew(before: DraggablePoint, after: DraggablePoint, text: string): void {
    const grown = text.length - this.shown.text.length;
    const from = [0, 1, 2].find((axis) => before.at[axis] !== after.at[axis]);
    const start = from === undefined ? text.length : (before.places[from]?.[0] ?? text.length);
    const shift = (place: [number, number]): [number, number] => [place[0] > start ? place[0] + grown : place[0], place[1] > start ? place[1] + grown : place[1]];
    const points = this.shown.points.map((point) => {
      const moved = point === before ? after : point;
      return { ...moved, places: moved.places.map(shift) as DraggablePoint["places"] };
    });
    this.shown = { ...this.shown, text, points };
    for (const point of this.movable()) this.rows.get(point.name)?.fields.forEach((field, axis) => this.update(field, point, axis));
  }
}
