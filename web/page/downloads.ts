// Files of a design, made when they are asked for.

import { download, make, say } from "./dom.ts";
import { type Asker, GivenUp } from "./modules.ts";
import { bodyOf, type DesignState, sourceOf } from "./state.ts";

/** What is offered, group by group. */
const GROUPS: { title: string; note: string; endings: string[]; purpose?: string }[] = [
  { title: "To cut", note: "one file a part, closed contours alone", endings: ["dxf", "svg"], purpose: "cut" },
  { title: "To bend", note: "with the bend lines of tools", endings: ["dxf", "svg"], purpose: "bend" },
  { title: "Pattern", note: "all pieces with their rulings and bend angles", endings: ["dxf", "svg"] },
  { title: "Model", note: "surfaces for CAD programs", endings: ["step", "iges"] },
  { title: "Mesh", note: "a solid where the sheet has a thickness", endings: ["3mf", "stl", "glb", "obj"] },
];

/** Lists the files; `current` says of which design. */
export function listDownloads(place: HTMLElement, asker: Asker, current: () => { state: DesignState; name: string }): void {
  for (const { title, note, endings, purpose } of GROUPS) {
    const buttons = endings.map((ending) => {
      const button = make("button", { type: "button", "data-file": `${purpose ?? "whole"}.${ending}`, "aria-label": `${title}: ${ending.toUpperCase()}` }, ending.toUpperCase());
      button.addEventListener("click", async () => {
        const { state, name } = current();
        button.disabled = true;
        try {
          if (purpose) await parts(asker, state, name, ending, purpose);
          else await whole(asker, state, name, ending);
        } catch (error) {
          if (!(error instanceof GivenUp)) say(`${name}.${ending}: ${error instanceof Error ? error.message : String(error)}`);
        }
        button.disabled = false;
      });
      return button;
    });
    place.append(make("div", { class: "download" }, make("h3", {}, title), make("span", { class: "group" }, ...buttons), make("p", { class: "note" }, note)));
  }
  const own = make("button", { type: "button", "data-file": "design.toml", "aria-label": "Design: TOML" }, "TOML");
  own.addEventListener("click", () => {
    const { state, name } = current();
    const file = state.files[state.name];
    if (file) download(state.name, file);
    else download(`${name}.toml`, state.text);
  });
  place.append(make("div", { class: "download" }, make("h3", {}, "Design"), make("span", { class: "group" }, own), make("p", { class: "note" }, "for the command torse, and for this page")));
}

async function whole(asker: Asker, state: DesignState, name: string, ending: string): Promise<void> {
  const { body } = await asker.ask("export", { do: "export", source: sourceOf(state), ending }, bodyOf(state));
  download(`${name}.${ending}`, body);
}

/** A file a part, named as the command names it. */
async function parts(asker: Asker, state: DesignState, name: string, ending: string, purpose: string): Promise<void> {
  const question = { do: "parts", source: sourceOf(state), ending, purpose };
  const { value, body } = await asker.ask<[string, number][]>("parts", question, bodyOf(state));
  let from = 0;
  for (const [part, length] of value) {
    const file = value.length > 1 ? `${name}-${part.replace(/[^\p{L}\p{N}._-]/gu, "_")}` : name;
    download(`${file}.${ending}`, body.slice(from, from + length));
    from += length;
  }
}
