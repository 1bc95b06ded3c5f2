// The folder that `torse studio` serves beside the page: listed a few times a second, read, and saved when it is asked for.

/** A file as it was read. */
export interface FolderFile {
  bytes: Uint8Array<ArrayBuffer>;
  /** The digest of its contents, which a save names. */
  tag: string;
}

interface FolderList {
  folder: string;
  /** Paths with texts that change when the files do. */
  files: Record<string, string>;
  cut: boolean;
}

/** Milliseconds between two looks at the folder. */
const PAUSE = 400;

/** Whether the page was served by the command. */
export function isServed(): boolean {
  return document.querySelector('meta[name="torse-studio"]') !== null;
}

/** The served folder. */
export class ServedFolder {
  private list: FolderList = { folder: "", files: {}, cut: false };
  private shown = "";
  private readonly watching: ((changed: Set<string>) => void)[] = [];

  /** `onLost` says whether the command has ended. */
  constructor(private readonly onLost: (lost: boolean) => void) {}

  /** Calls with the paths that are new, gone or changed. */
  watch(job: (changed: Set<string>) => void): void {
    this.watching.push(job);
  }

  get name(): string {
    return this.list.folder;
  }

  /** The paths of designs: texts that belong to no paper. */
  get designs(): string[] {
    const papers = this.papers.map((paper) => (paper === "" ? "" : `${paper}/`));
    const inPaper = (path: string) => papers.some((paper) => path.startsWith(paper) && !path.slice(paper.length).includes("/"));
    return this.paths.filter((path) => path.endsWith(".toml") && !inPaper(path) && !/(^|\/)Cargo\.toml$/.test(path));
  }

  /** The folders of papers; an empty text for the served folder itself. */
  get papers(): string[] {
    return this.paths.filter((path) => /(^|\/)paper\.toml$/.test(path)).map((path) => path.replace(/\/?paper\.toml$/, ""));
  }

  get paths(): string[] {
    return Object.keys(this.list.files);
  }

  /** Begins to look at the folder; resolves when it was listed once. */
  async start(): Promise<void> {
    await this.look();
    const again = () => setTimeout(() => void this.look().then(again), PAUSE);
    again();
  }

  /** The files of a paper's folder, by their names in it. */
  async paper(folder: string): Promise<Record<string, Uint8Array<ArrayBuffer>>> {
    const before = folder === "" ? "" : `${folder}/`;
    const files: Record<string, Uint8Array<ArrayBuffer>> = {};
    for (const path of this.paths) {
      if (path.startsWith(before) && path.endsWith(".toml")) files[path.slice(before.length)] = (await this.read(path)).bytes;
    }
    return files;
  }

  /** The file with this path. */
  async read(path: string): Promise<FolderFile> {
    const response = await fetch(`file?name=${encodeURIComponent(path)}`);
    if (!response.ok) throw new Error(`${path}: ${(await response.text()).trim()}`);
    return { bytes: new Uint8Array(await response.arrayBuffer()), tag: response.headers.get("ETag") ?? "" };
  }

  /** Writes a text in the place of the file that has this digest, and returns the new digest; none if the file has changed. */
  async save(path: string, tag: string, text: string): Promise<string | undefined> {
    const response = await fetch(`file?name=${encodeURIComponent(path)}`, { method: "PUT", headers: { "If-Match": tag }, body: text });
    if (response.status === 412) return undefined;
    if (!response.ok) throw new Error(`${path}: ${(await response.text()).trim()}`);
    return response.headers.get("ETag") ?? "";
  }

  private async look(): Promise<void> {
    let text: string;
    try {
      const response = await fetch("files");
      if (!response.ok) throw new Error();
      text = await response.text();
    } catch {
      this.onLost(true);
      return;
    }
    this.onLost(false);
    if (text === this.shown) return;
    const before = this.list.files;
    this.shown = text;
    this.list = JSON.parse(text) as FolderList;
    const now = this.list.files;
    const all = new Set([...Object.keys(before), ...Object.keys(now)]);
    const changed = new Set([...all].filter((path) => before[path] !== now[path]));
    for (const job of this.watching) job(changed);
  }
}

/** The folder of a path, with the `/` behind it. */
export function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf("/") + 1);
}
