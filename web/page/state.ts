// A design as it is typed, and as it crosses the border.

/** The name of the file, its text, and the files that it takes curves from. It does not change; others take its place. */
export interface DesignState {
  readonly name: string;
  readonly text: string;
  readonly files: Readonly<Record<string, Uint8Array<ArrayBuffer>>>;
}

/** Whether two states are of one design. */
export function sameSource(a: DesignState, b: DesignState): boolean {
  return a.name === b.name && a.text === b.text && a.files === b.files;
}

/** The design in the head of a question. */
export function sourceOf({ name, text, files }: DesignState): object {
  return { name, text, files: Object.entries(files).map(([name, bytes]) => [name, bytes.length]) };
}

/** Its files in the body. */
export function bodyOf({ files }: DesignState): Uint8Array<ArrayBuffer> {
  const all = Object.values(files);
  const body = new Uint8Array(all.reduce((sum, bytes) => sum + bytes.length, 0));
  let at = 0;
  for (const bytes of all) {
    body.set(bytes, at);
    at += bytes.length;
  }
  return body;
}

/** The name without its ending. */
export function changeName(name: string): string {
  return name.replace(/\.[^.]*$/, "") || "design";
}
