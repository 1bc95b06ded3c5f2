// Files that are dropped on the page: a design, or files of other programs with curves and faces.

import type { DesignState } from "./state.ts";

/** What a module finds in files; see `modules/designs/src/contents.rs`. */
export interface Contents {
  listings: { file: string; kind: string; curves: { name: string }[] }[];
  text: string;
  faces: string | null;
  start: string | null;
}

type Files = Record<string, Uint8Array<ArrayBuffer>>;

/** The state after files were dropped, and what is to be said of it. Throws what cannot be used. */
export async function acceptFiles(
  now: DesignState,
  files: Files,
  listing: (files: Files) => Promise<Contents>,
): Promise<{ state: DesignState; words: string }> {
  const names = Object.keys(files);
  if (names.length === 0) throw new Error("No file was dropped.");
  const design = names.find((name) => name.toLowerCase().endsWith(".toml"));
  const others = Object.fromEntries(Object.entries(files).filter(([name]) => name !== design));
  if (design) {
    const text = new TextDecoder().decode(files[design]);
    return { state: { name: design, text, files: { ...now.files, ...others } }, words: `${design} is opened.` };
  }
  // A file that the design names is what it waits for.
  if (names.every((name) => now.text.includes(name))) {
    return { state: { ...now, files: { ...now.files, ...others } }, words: `${names.join(", ")} is read.` };
  }
  const found = await listing(others);
  if (found.faces) {
    const bytes = others[found.faces];
    if (bytes) return { state: { name: found.faces, text: "", files: { [found.faces]: bytes } }, words: `The faces of ${found.faces} are the design.` };
  }
  const stem = (names[0] ?? "design").replace(/\.[^.]*$/, "");
  if (found.start) {
    return { state: { name: `${stem}.toml`, text: found.start, files: others }, words: `${names.join(", ")}: a patch lies between the first two curves.` };
  }
  throw new Error(`${names.join(", ")}: a design needs two curves, or a face with rulings. What is there: ${found.text.trim()}`);
}
