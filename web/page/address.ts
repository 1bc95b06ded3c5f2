// The address holds everything: whoever opens a link sees the same.

/** What an address names: a view and its entries. */
export interface Address {
  view: string;
  entries: URLSearchParams;
}

/** Reads `#formulas?is=…`. */
export function readAddress(hash: string): Address {
  const [view = "", entries = ""] = hash.replace(/^#/, "").split(/\?(.*)/s);
  return { view, entries: new URLSearchParams(entries) };
}

/** Writes the address without a step in the history of the browser. */
export function writeAddress(view: string, entries: Record<string, string>): void {
  const kept = Object.entries(entries).filter(([, value]) => value !== "");
  const text = new URLSearchParams(kept).toString();
  history.replaceState(null, "", `#${view}${text ? `?${text}` : ""}`);
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream) {
  const packed = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

/** Bytes as letters that an address may hold. */
export function toLetters(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The bytes of letters. */
export function fromLetters(letters: string): Uint8Array<ArrayBuffer> {
  const text = atob(letters.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

/** Packs a value for an address. */
export async function pack(value: unknown): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(value)) as Uint8Array<ArrayBuffer>;
  return toLetters(await through(bytes, new CompressionStream("deflate-raw")));
}

/** The value that was packed. */
export async function unpack(letters: string): Promise<unknown> {
  const bytes = await through(fromLetters(letters), new DecompressionStream("deflate-raw"));
  return JSON.parse(new TextDecoder().decode(bytes));
}
