// The designs of a served folder: opened, shown again when they are saved elsewhere, and saved when it is asked for.

import { byId, make, say } from "./dom.ts";
import type { DesignState } from "./state.ts";
import { folderOf, type ServedFolder } from "./studio.ts";

/** The design that is open: as it stands in the folder. */
interface OpenDesign {
  path: string;
  tag: string;
  text: string;
}

/** What the view of designs gives and takes. */
export interface Shown {
  now(): DesignState;
  take(state: DesignState): void;
  /** The address is written anew. */
  saved(): void;
}

/** The designs of the folder. */
export class FolderDesigns {
  private design: OpenDesign | undefined;
  private readonly select = byId<HTMLSelectElement>("folder-design");
  private readonly save = byId<HTMLButtonElement>("save");
  private readonly conflict = byId("conflict");

  constructor(
    private readonly folder: ServedFolder,
    private readonly shown: Shown,
  ) {
    folder.watch((changed) => void this.changed(changed));
    this.select.addEventListener("change", () => void this.open(this.select.value));
    this.save.addEventListener("click", () => void this.write());
    byId("take-theirs").addEventListener("click", () => void this.takeTheirs());
    byId("keep-mine").addEventListener("click", () => void this.keepMine());
    byId("designs").addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "s") return;
      event.preventDefault();
      if (!this.save.disabled) void this.write();
    });
  }

  /** The paths of the designs. */
  get paths(): string[] {
    return this.folder.designs;
  }

  /** The path of the design that is shown as it stands in the folder; empty where it is another one, or changed. */
  get path(): string {
    return this.design && this.shown.now().text === this.design.text ? this.design.path : "";
  }

  /** Forgets the design: another one, which is none of the folder, is shown. */
  letGo(): void {
    this.design = undefined;
    this.follow();
  }

  /** Opens a design with the files that it names. */
  async open(path: string): Promise<void> {
    try {
      const { bytes, tag } = await this.folder.read(path);
      const text = new TextDecoder().decode(bytes);
      const files = await this.named(path, text);
      this.design = { path, tag, text };
      this.shown.take({ name: path.slice(folderOf(path).length), text, files });
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
    }
    this.follow();
  }

  /** Shows what can be done: after every change of the text. */
  follow(): void {
    const { design } = this;
    this.select.value = design?.path ?? "";
    const changed = design !== undefined && this.shown.now().text !== design.text;
    this.save.disabled = !changed;
    if (!changed) this.conflict.hidden = true;
  }

  /** The files that the text names, by the names that stand in it. */
  private async named(path: string, text: string): Promise<DesignState["files"]> {
    const folder = folderOf(path);
    const beside = this.folder.paths.filter((other) => other !== path && other.startsWith(folder));
    const files: Record<string, Uint8Array<ArrayBuffer>> = {};
    for (const other of beside) {
      const name = other.slice(folder.length);
      if (!name.endsWith(".toml") && text.includes(name)) files[name] = (await this.folder.read(other)).bytes;
    }
    return files;
  }

  private async changed(changed: Set<string>): Promise<void> {
    const designs = this.folder.designs;
    this.select.replaceChildren(make("option", { value: "" }, `${this.folder.name}…`), ...designs.map((path) => make("option", { value: path }, path)));
    this.follow();
    const { design } = this;
    if (!design) return;
    const before = this.shown.now();
    const beside = Object.keys(before.files).some((name) => changed.has(folderOf(design.path) + name));
    try {
      if (changed.has(design.path) && this.folder.paths.includes(design.path)) {
        const { bytes, tag } = await this.folder.read(design.path);
        const text = new TextDecoder().decode(bytes);
        if (this.design !== design || tag === design.tag) return;
        if (this.shown.now().text === design.text) await this.open(design.path);
        // Both have it: nothing is to be decided.
        else if (this.shown.now().text === text) this.design = { path: design.path, tag, text };
        else this.conflict.hidden = false;
      } else if (beside) {
        const now = this.shown.now();
        this.shown.take({ ...now, files: await this.named(design.path, now.text) });
      }
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
    }
    this.follow();
  }

  private async write(): Promise<void> {
    const { design } = this;
    if (!design) return;
    const { text } = this.shown.now();
    try {
      const tag = await this.folder.save(design.path, design.tag, text);
      if (tag === undefined) {
        this.conflict.hidden = false;
        return;
      }
      this.design = { path: design.path, tag, text };
      say(`${design.path} is saved.`);
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
    }
    this.follow();
    this.shown.saved();
  }

  private async takeTheirs(): Promise<void> {
    this.conflict.hidden = true;
    if (this.design) await this.open(this.design.path);
  }

  /** From now on the text counts as written after that of the file: a save replaces it. */
  private async keepMine(): Promise<void> {
    const { design } = this;
    this.conflict.hidden = true;
    if (!design) return;
    const { bytes, tag } = await this.folder.read(design.path);
    this.design = { path: design.path, tag, text: new TextDecoder().decode(bytes) };
    this.follow();
  }
}
