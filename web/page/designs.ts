// The view of designs: a text that is shown in space and flat, bent, judged and written to files.

import { pack, unpack, toLetters, fromLetters, writeAddress } from "./address.ts";
import { byId, download, make, say, settled } from "./dom.ts";
import { Editor } from "./editor.ts";
import { listDownloads } from "./downloads.ts";
import { acceptFiles, type Contents } from "./files.ts";
import { FolderDesigns } from "./folder-designs.ts";
import { Handles } from "./handles.ts";
import { Steps } from "./history.ts";
import { Asker, GivenUp, type Message, Refusal, Trapped, unplaced } from "./modules.ts";
import { type DrawnPattern, drawPattern } from "./pattern.ts";
import { type DraggablePoint, PointTable } from "./points.ts";
import { bodyOf, changeName, sameSource, sourceOf, type DesignState } from "./state.ts";
import { Sliders } from "./sliders.ts";
import type { ServedFolder } from "./studio.ts";
import { numberAt, numbersOf, withNumber } from "./numbers.ts";
import { type Group, type Shade, Viewer } from "./viewer.ts";

/** The worked designs: name and text, put here when the page is built. */
declare const STARTS: { name: string; title: string; text: string }[];

interface Scene {
  title: string;
  names: string[];
  view: [number, number] | null;
  radius: number | null;
  unit: number;
  thickness: number | null;
  points: DraggablePoint[];
  triangles: Group[];
  lines: Group[];
  pattern: DrawnPattern | null;
  refused: { text: string; messages: Message[] } | null;
}

interface Measured {
  missed: string[];
  notes: string[];
  text: string;
}

/** An address longer than this is not written: browsers cut it. */
const MAX_ADDRESS = 60_000;
const FIRST = "lampshade";

/** Starts the view, with the designs of a folder where one is served. */
export function startDesigns(served: ServedFolder | undefined): { open(entries: URLSearchParams): Promise<void>; redraw(): void } {
  const drawer = new Asker("designs", lost);
  const judge = new Asker("designs", lost);
  // Pictures take seconds: nothing waits for them.
  const painter = new Asker("designs", lost);
  const editor = new Editor(byId<HTMLTextAreaElement>("text"), byId("editor"), byId("messages"));
  const bend = byId<HTMLInputElement>("bend");
  const viewer = startViewer();
  const begin: DesignState = { name: "", text: "", files: {} };
  const steps = new Steps<DesignState>(begin, sameSource);
  let framed = "";
  let proving = false;
  /** The number of the newest question that was answered: while a point is dragged, older states are judged too. */
  let asked = 0;
  let judgedFor = 0;
  let thickness: number | null = null;

  function lost(reason: string): void {
    say(`A worker was ended (${reason}). Nothing that you typed is lost; another one has been started.`);
  }

  const sliders = new Sliders(byId("sliders"), (place, value, kind) => {
    const text = withNumber(steps.now.text, place, value);
    change({ ...steps.now, text }, kind);
  });

  const folder = served && new FolderDesigns(served, {
    now: () => steps.now,
    take: (state) => change(state, ""),
    saved: () => keep.later(),
  });

  const table = new PointTable(
    (text, kind) => change({ ...steps.now, text }, kind),
    (name) => handles?.look(name),
  );
  const handles = viewer && new Handles(byId<SVGSVGElement>("handles"), viewer, {
    snap: () => table.snap,
    fits: ({ text }) => text === steps.now.text,
    change: (text, kind) => change({ ...steps.now, text }, kind),
    done: () => prove.later(),
  });

  // What changes shows at once; it is measured as well, and proved when it rests.
  const prove = settled(700, () => void measure(false));
  const keep = settled(300, () => void address());

  function change(state: DesignState, kind: string): void {
    if (steps.now === begin) steps.begin(state);
    else steps.go(state, kind, performance.now());
    follow();
  }

  /** Shows the state that holds. */
  function follow(): void {
    const { name, text, files } = steps.now;
    editor.text = text;
    const faces = name in files;
    editor.field.readOnly = faces;
    byId("design-name").textContent = faces ? `${name}: its faces are the design` : name;
    byId<HTMLButtonElement>("undo").disabled = !steps.canUndo;
    byId<HTMLButtonElement>("redo").disabled = !steps.canRedo;
    folder?.follow();
    showSliders();
    keep.later();
    prove.never();
    void show(true);
  }

  function showSliders(): void {
    const { text } = steps.now;
    const places = numbersOf(text);
    const focused = document.activeElement === editor.field;
    const caret = focused ? numberAt(text, editor.field.selectionStart) : undefined;
    const listed = caret && places.some((place) => place.from === caret.from);
    sliders.show(places, listed ? undefined : caret);
  }

  async function show(pattern: boolean): Promise<void> {
    const state = steps.now;
    const share = Number(bend.value);
    const question = { do: "show", source: sourceOf(state), share, pattern };
    const slow = pattern ? window.setTimeout(() => judged("busy", "torse is computing…", undefined), 600) : undefined;
    try {
      const { value, body } = await drawer.ask<Scene>(pattern ? "design" : "bend", question, bodyOf(state));
      const frame = framed !== state.name;
      framed = state.name;
      viewer?.show(value, body, frame, value.view);
      document.title = `${value.title} · torse`;
      byId("title").textContent = value.title;
      bendSays(share, value.radius);
      thickness = value.thickness;
      showLegend();
      const points = { text: state.text, points: value.points, unit: value.unit };
      if (state === steps.now) table.show(points, state.name, viewer?.size ?? 100);
      handles?.show(points);
      byId("handles").toggleAttribute("hidden", share !== 1 || !byId<HTMLInputElement>("show-points").checked);
      if (!pattern) return;
      editor.show([]);
      showPattern(value);
      await measure(true);
      if (state === steps.now) prove.later();
    } catch (error) {
      refused(error, state);
    } finally {
      window.clearTimeout(slow);
    }
  }

  function bendSays(share: number, radius: number | null): void {
    const percent = `${Math.round(100 * share)} %`;
    byId("bend-says").textContent = radius === null ? percent : `${percent}, radius ≥ ${Number(radius.toPrecision(3))} mm`;
  }

  function showPattern(scene: Scene): void {
    const place = byId<SVGSVGElement>("flat");
    const none = byId("no-flat");
    place.toggleAttribute("hidden", scene.pattern === null);
    none.hidden = scene.pattern !== null;
    bend.disabled = scene.pattern === null;
    for (const id of ["play", "gif"]) byId<HTMLButtonElement>(id).disabled = scene.pattern === null;
    byId("promise").textContent = scene.pattern?.summary ?? "";
    if (scene.pattern) drawPattern(place, scene.pattern);
    const reasons = scene.refused?.messages.map((m) => (m.hint ? `${m.text} (${m.hint})` : m.text));
    none.textContent = reasons ? `No pattern: ${reasons.join("; ")}` : "";
  }

  function refused(error: unknown, state: DesignState): void {
    if (error instanceof GivenUp || state !== steps.now) return;
    prove.never();
    if (error instanceof Refusal) {
      const messages = error.messages.length > 0 ? error.messages : [unplaced(error.message)];
      editor.show(messages);
      judged("wrong", messages.length === 1 ? "The text has a mistake." : `The text has ${messages.length} mistakes.`, []);
    } else {
      const reason = error instanceof Error ? error.message : String(error);
      judged("wrong", error instanceof Trapped ? `torse was ended by an error of its own: ${reason}` : reason, []);
    }
  }

  async function measure(quick: boolean): Promise<void> {
    const state = steps.now;
    const number = ++asked;
    // A proof that is under way is of an older state.
    if (!quick || proving) judge.stop();
    proving = !quick;
    if (!quick) judged("busy", "Measured; now it is proved…", undefined);
    try {
      const question = { do: "measure", source: sourceOf(state), quick };
      const { value } = await judge.ask<Measured>("measure", question, bodyOf(state));
      // While a point is dragged the newest answer is shown, though the point has gone on.
      const isNow = state === steps.now;
      if (!isNow && !(handles?.dragging && state.name === steps.now.name && number > judgedFor)) return;
      judgedFor = number;
      const words = quick ? "Measured" : "Measured, with bounds and proofs";
      const met = value.missed.length === 0;
      judged(met ? "met" : "missed", met ? `Yes: everything that the design demands is met. ${words}.` : `Not as the design demands. ${words}.`, value.missed);
      byId("report").textContent = value.text;
    } catch (error) {
      if (error instanceof GivenUp || state !== steps.now) return;
      judged("wrong", error instanceof Error ? error.message : String(error), []);
    }
    proving = false;
  }

  /** Says what was found; what is missed stays as it is where nothing is given. */
  function judged(state: string, words: string, missed: string[] | undefined): void {
    const place = byId("judged");
    place.className = `judged ${state}`;
    place.textContent = words;
    if (!missed) return;
    const list = byId("missed");
    list.hidden = missed.length === 0;
    list.replaceChildren(...missed.map((reason) => make("li", {}, reason)));
    viewer?.mark(new Set(viewer.names().filter((name) => missed.some((reason) => mentions(reason, name)))));
  }

  async function address(): Promise<void> {
    const { name, text, files } = steps.now;
    const start = STARTS.find((start) => `${start.name}.toml` === name && start.text === text);
    const bent = bend.value === "1" ? "" : bend.value;
    if (folder?.path) {
      writeAddress("designs", { file: folder.path, bend: bent });
      return;
    }
    if (start && Object.keys(files).length === 0) {
      writeAddress("designs", { start: start.name, bend: bent });
      return;
    }
    const packed = Object.fromEntries(Object.entries(files).map(([name, bytes]) => [name, toLetters(bytes)]));
    const design = await pack({ name, text, files: packed });
    byId("design-name").classList.toggle("too-long", design.length > MAX_ADDRESS);
    writeAddress("designs", design.length > MAX_ADDRESS ? {} : { design, bend: bent });
  }

  async function open(entries: URLSearchParams): Promise<void> {
    if (entries.has("bend")) bend.value = entries.get("bend") ?? "1";
    const packed = entries.get("design");
    if (packed) {
      try {
        const found = (await unpack(packed)) as { name: string; text: string; files: Record<string, string> };
        const files = Object.fromEntries(Object.entries(found.files).map(([name, letters]) => [name, fromLetters(letters)]));
        change({ name: String(found.name), text: String(found.text), files }, "");
        return;
      } catch {
        say("The address holds no design that can be read; it may have been cut.");
      }
    }
    const file = entries.get("file");
    if (folder && file) return folder.open(file);
    if (steps.now.text !== "" && !entries.has("start")) {
      follow();
      return;
    }
    const [first] = entries.has("start") ? [] : (folder?.paths ?? []);
    if (first) return folder?.open(first);
    begins(entries.get("start") ?? FIRST);
  }

  function begins(name: string): void {
    folder?.letGo();
    const start = STARTS.find((start) => start.name === name) ?? STARTS[0];
    if (start) change({ name: `${start.name}.toml`, text: start.text, files: {} }, "");
  }

  async function dropped(given: Iterable<File>): Promise<void> {
    const files: Record<string, Uint8Array<ArrayBuffer>> = {};
    for (const file of given) files[file.name] = new Uint8Array(await file.arrayBuffer());
    const listing = async (files: Record<string, Uint8Array<ArrayBuffer>>) => {
      const head = { do: "contents", files: Object.entries(files).map(([name, bytes]) => [name, bytes.length]) };
      return (await drawer.ask<Contents>("contents", head, bodyOf({ name: "", text: "", files }))).value;
    };
    try {
      const { state, words } = await acceptFiles(steps.now, files, listing);
      bend.value = "1";
      if (state.name !== steps.now.name) folder?.letGo();
      change(state, "");
      say(words);
    } catch (error) {
      if (!(error instanceof GivenUp)) say(error instanceof Error ? error.message : String(error));
    }
  }

  const undo = () => (steps.undo(), follow());
  const redo = () => (steps.redo(), follow());
  byId("undo").addEventListener("click", undo);
  byId("redo").addEventListener("click", redo);
  byId("designs").addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    const move = key === "z" ? (event.shiftKey ? redo : undo) : key === "y" ? redo : undefined;
    if (!move) return;
    event.preventDefault();
    move();
  });
  editor.field.addEventListener("input", () => change({ ...steps.now, text: editor.text }, "typing"));
  for (const event of ["keyup", "click", "focus"]) editor.field.addEventListener(event, showSliders);
  bend.addEventListener("input", () => {
    keep.later();
    void show(false);
  });
  const start = byId<HTMLSelectElement>("start");
  start.append(make("option", { value: "" }, "choose…"), ...STARTS.map(({ name, title }) => make("option", { value: name }, title)));
  start.addEventListener("change", () => {
    bend.value = "1";
    if (start.value !== "") begins(start.value);
    start.value = "";
  });
  byId("share").addEventListener("click", async () => {
    await address();
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    say("The address of the page holds the whole design; it was copied.");
  });
  byId("open").addEventListener("click", () => byId("files").click());
  byId<HTMLInputElement>("files").addEventListener("change", ({ target }) => {
    const field = target as HTMLInputElement;
    void dropped(field.files ?? []);
    field.value = "";
  });
  for (const event of ["dragover", "drop"] as const) {
    window.addEventListener(event, (happened) => {
      happened.preventDefault();
      if (event === "drop" && !byId("designs").hidden) void dropped(happened.dataTransfer?.files ?? []);
    });
  }
  const shade = byId<HTMLSelectElement>("shade");
  /** What the colours stand for: of strain that of the outer fibre, half of the thickness times the curvature. */
  function showLegend(): void {
    const strain = byId<HTMLOptionElement>("shade-strain");
    strain.disabled = thickness === null;
    if (thickness === null && shade.value === "strain") shade.value = "curvature";
    if (!viewer) return;
    viewer.shade = shade.value as Shade;
    const most = viewer.mostCurvature;
    byId("legend").hidden = shade.value === "pieces";
    const digits = (value: number) => String(Number(value.toPrecision(3)));
    const isStrain = shade.value === "strain" && thickness !== null;
    byId("legend-title").textContent = isStrain ? "strain of the outer fibre" : "radius of bending";
    byId("legend-low").textContent = isStrain ? "0 %" : "flat";
    byId("legend-high").textContent = isStrain ? `${digits(50 * (thickness ?? 0) * most)} %` : most > 0 ? `${digits(1 / most)} mm` : "";
    viewer.redraw();
  }
  shade.addEventListener("change", showLegend);
  byId("show-points").addEventListener("change", ({ target }) => {
    byId("handles").toggleAttribute("hidden", !(target as HTMLInputElement).checked || bend.value !== "1");
  });
  byId("gif").addEventListener("click", async () => {
    const state = steps.now;
    const button = byId<HTMLButtonElement>("gif");
    button.disabled = true;
    say("The moving picture is drawn…");
    try {
      const { body } = await painter.ask("gif", { do: "bending", source: sourceOf(state) }, bodyOf(state));
      download(`${changeName(state.name)}.gif`, body);
      say(`${changeName(state.name)}.gif: ${Math.round(body.length / 1000)} kB.`);
    } catch (error) {
      if (!(error instanceof GivenUp)) say(error instanceof Error ? error.message : String(error));
    }
    button.disabled = byId<HTMLButtonElement>("play").disabled;
    painter.stop();
  });
  byId("play").addEventListener("click", () => play(bend, () => void show(false)));
  listDownloads(byId("downloads"), drawer, () => ({ state: steps.now, name: changeName(steps.now.name) }));

  return { open, redraw: () => viewer?.redraw() };
}

/** Starts the view in space, or says why there is none. */
function startViewer(): Viewer | undefined {
  const canvas = byId<HTMLCanvasElement>("space");
  try {
    const viewer = new Viewer(canvas);
    const zoom = (factor: number) => () => {
      viewer.camera.scale(factor);
      viewer.redraw();
    };
    byId("zoom-in").addEventListener("click", zoom(1.25));
    byId("zoom-out").addEventListener("click", zoom(0.8));
    byId("zoom-home").addEventListener("click", () => viewer.home());
    return viewer;
  } catch (error) {
    canvas.hidden = true;
    const place = byId("no-space");
    place.hidden = false;
    place.textContent = error instanceof Error ? error.message : String(error);
    return undefined;
  }
}

/** Whether a text speaks of this name. */
function mentions(text: string, name: string): boolean {
  return ` ${text.replace(/[`:,;()"]/g, " ")} `.includes(` ${name} `);
}

/** Unrolls the sheet, or bends it again where it is flat; at once for who wants no motion. */
function play(bend: HTMLInputElement, show: () => void): void {
  const from = Number(bend.value);
  const to = from > 0.5 ? 0 : 1;
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const started = performance.now();
  const frame = (now: number) => {
    const done = still ? 1 : Math.min(1, (now - started) / 2200);
    const eased = done * done * (3 - 2 * done);
    bend.value = String(from + (to - from) * eased);
    show();
    if (done < 1) requestAnimationFrame(frame);
    else bend.dispatchEvent(new Event("input"));
  };
  requestAnimationFrame(frame);
}
