// Handles of points over the view in space, dragged in the plane of two axes.

import { makeSvg } from "./dom.ts";
import { type DraggablePoint, snapped, type TextPoints, withPoint } from "./points.ts";
import type { Viewer } from "./viewer.ts";

/** A point that is dragged: from where, in which text. */
interface Held {
  of: TextPoints;
  point: DraggablePoint;
  from: [number, number];
  id: number;
}

/** How far from the border of the view a handle stays, in CSS pixels. */
const BORDER = 9;

/** What handles ask of the view of designs. */
export interface HandleHooks {
  /** The grid in the unit of the text; 0 for none. */
  snap(): number;
  /** Whether the text is the one in which the points stand. */
  fits(of: TextPoints): boolean;
  /** A text in which a point has moved. */
  change(text: string, kind: string): void;
  /** The point was let go. */
  done(): void;
}

/** The handles. They are for pointers; keys move points in the table. */
export class Handles {
  private shown: TextPoints = { text: "", points: [], unit: 1 };
  private circles = new Map<string, SVGElement>();
  private held: Held | undefined;
  private looked = "";
  private drags = 0;

  constructor(
    private readonly overlay: SVGSVGElement,
    private readonly viewer: Viewer,
    private readonly hooks: HandleHooks,
  ) {
    viewer.onDraw = () => this.place();
    overlay.addEventListener("pointermove", (event) => this.moved(event));
    for (const end of ["pointerup", "pointercancel"] as const) overlay.addEventListener(end, (event) => this.gone(event));
  }

  /** Whether a point is in the hand. */
  get dragging(): boolean {
    return this.held !== undefined;
  }

  /** Shows the handles of these points. */
  show(points: TextPoints): void {
    this.shown = points;
    const movable = points.points.filter(({ plain }) => plain.includes(true));
    const names = new Set(movable.map(({ name }) => name));
    for (const [name, circle] of this.circles) {
      if (names.has(name)) continue;
      circle.remove();
      this.circles.delete(name);
    }
    for (const { name } of movable) {
      if (this.circles.has(name)) continue;
      const circle = makeSvg("circle", { class: "handle", r: "6", "data-point": name });
      circle.append(makeSvg("title", {}, name));
      circle.addEventListener("pointerdown", (event) => this.taken(event, name));
      this.circles.set(name, circle);
      this.overlay.append(circle);
    }
    this.place();
  }

  /** Shows which point is looked at. */
  look(name: string): void {
    this.looked = name;
    this.place();
  }

  private place(): void {
    for (const point of this.shown.points) {
      const circle = this.circles.get(point.name);
      if (!circle) continue;
      const [x, y] = this.viewer.project(point.at);
      // What lies beyond the view has its handle at the border.
      const [right, bottom] = [this.overlay.clientWidth - BORDER, this.overlay.clientHeight - BORDER];
      const [shownX, shownY] = [Math.max(BORDER, Math.min(right, x)), Math.max(BORDER, Math.min(bottom, y))];
      circle.setAttribute("cx", shownX.toFixed(1));
      circle.setAttribute("cy", shownY.toFixed(1));
      circle.classList.toggle("beyond", shownX !== x || shownY !== y);
      circle.classList.toggle("looked", point.name === this.looked || point.name === this.held?.point.name);
    }
  }

  private taken(event: PointerEvent, name: string): void {
    const point = this.shown.points.find((point) => point.name === name);
    if (!point || event.button !== 0 || !this.hooks.fits(this.shown)) return;
    event.preventDefault();
    event.stopPropagation();
    this.overlay.setPointerCapture(event.pointerId);
    this.drags += 1;
    this.held = { of: this.shown, point, from: [event.clientX, event.clientY], id: event.pointerId };
    this.place();
  }

  private moved(event: PointerEvent): void {
    const { held } = this;
    if (!held || event.pointerId !== held.id) return;
    const { point, of, from } = held;
    const way = this.way(point, [event.clientX - from[0], event.clientY - from[1]], event.shiftKey);
    const step = event.altKey ? 0 : this.hooks.snap();
    const values = way.map((shift, axis) => (shift === undefined ? undefined : snapped(((point.at[axis] ?? 0) + shift) / of.unit, step)));
    this.hooks.change(withPoint(of, point, values), `drag ${this.drags}`);
  }

  private gone(event: PointerEvent): void {
    if (event.pointerId !== this.held?.id) return;
    this.held = undefined;
    this.place();
    this.hooks.done();
  }

  /** The shift in millimetres of each coordinate that moves: of the two that are seen best, or, with Shift, of the third. */
  private way({ plain }: DraggablePoint, [dx, dy]: [number, number], third: boolean): (number | undefined)[] {
    const [right, up] = this.viewer.camera.axes();
    const [sx, sy] = [dx * this.viewer.perPixel(), -dy * this.viewer.perPixel()];
    const free = [0, 1, 2].filter((axis) => plain[axis]);
    const area = ([i, j]: [number, number]) => (right[i] ?? 0) * (up[j] ?? 0) - (right[j] ?? 0) * (up[i] ?? 0);
    const pairs = free.flatMap((i) => free.filter((j) => j > i).map((j) => [i, j] as [number, number]));
    const best = pairs.sort((a, b) => Math.abs(area(b)) - Math.abs(area(a)))[0];
    const out: (number | undefined)[] = [undefined, undefined, undefined];
    const alone = third && best ? free.find((axis) => !best.includes(axis)) : best ? undefined : free[0];
    if (alone !== undefined) {
      const [a, b] = [right[alone] ?? 0, up[alone] ?? 0];
      // An axis along which one looks is not moved.
      const length = a * a + b * b;
      if (length > 1e-3) out[alone] = (a * sx + b * sy) / length;
    } else if (best && Math.abs(area(best)) > 1e-3) {
      const [i, j] = best;
      out[i] = (sx * (up[j] ?? 0) - sy * (right[j] ?? 0)) / area(best);
      out[j] = (sy * (right[i] ?? 0) - sx * (up[i] ?? 0)) / area(best);
    }
    return out;
  }
}
