// The flat pattern as a drawing, with its size and a bar of a known length.

import { makeSvg } from "./dom.ts";

/** What a module says of a pattern; see `modules/designs/src/pattern.rs`. */
export interface DrawnPattern {
  paths: { layer: string; points: [number, number][]; closed: boolean }[];
  texts: { at: [number, number]; height: number; angle: number; text: string }[];
  bounds: [[number, number], [number, number]];
  summary: string;
}

/** Digits that a screen shows. */
function short(value: number): string {
  return String(Number(value.toFixed(4)));
}

/** Draws it; y upwards as in the file. */
export function drawPattern(place: SVGSVGElement, pattern: DrawnPattern): void {
  const [[left, bottom], [right, top]] = pattern.bounds;
  const [width, height] = [right - left, top - bottom];
  const size = Math.max(width, height, 1e-9);
  const room = 0.04 * size;
  place.setAttribute("viewBox", [left - room, -top - room, width + 2 * room, height + 2.9 * room].map(short).join(" "));
  const layers = new Map<string, SVGElement>();
  // What is cut comes first, so that its area lies behind the lines.
  for (const name of ["outline", "ruling", "up", "down", "regression", "mark"]) {
    layers.set(name, makeSvg("g", { class: `layer-${name}` }));
  }
  // An outline and the holes in it are one path: what is cut out is seen through.
  let cut = "";
  for (const { layer, points, closed } of pattern.paths) {
    const path = `M${points.map(([x, y]) => `${short(x)} ${short(-y)}`).join("L")}${closed ? "Z" : ""}`;
    if (layer === "outline") cut += path;
    else layers.get(layer)?.append(makeSvg("path", { d: path }));
  }
  layers.get("outline")?.append(makeSvg("path", { d: cut, "fill-rule": "evenodd" }));
  for (const { at, height, angle, text } of pattern.texts) {
    const [x, y] = [short(at[0]), short(-at[1])];
    // Letters on the drawing are as high as on the sheet.
    const attributes = { x, y, "font-size": short(height * 1.4), transform: `rotate(${short(-angle)} ${x} ${y})` };
    layers.get("mark")?.append(makeSvg("text", attributes, text));
  }
  place.replaceChildren(...layers.values(), ...bar(left, -bottom + 1.4 * room, size));
  const words = `Flat pattern, ${short(Number(width.toPrecision(5)))} by ${short(Number(height.toPrecision(5)))} mm`;
  place.setAttribute("aria-label", words);
}

/** A bar as long as a tidy number of millimetres. */
function bar(x: number, y: number, size: number): SVGElement[] {
  const power = 10 ** Math.floor(Math.log10(size / 4));
  const length = [5, 2, 1].map((k) => k * power).find((k) => k <= size / 3) ?? power;
  const tick = 0.012 * size;
  const path = `M${short(x)} ${short(y - tick)}v${short(tick)}h${short(length)}v${short(-tick)}`;
  const label = makeSvg("text", { x: short(x + length + tick), y: short(y), "font-size": short(0.034 * size) }, `${length} mm`);
  const group = makeSvg("g", { class: "scale-bar" });
  group.append(makeSvg("path", { d: path }), label);
  return [group];
}
