// Packets: what crosses the border between the page and a module. See `modules/border/src/lib.rs`.

/** JSON with bytes behind it. */
export interface Packet {
  head: unknown;
  body: Uint8Array<ArrayBuffer>;
}

/** What a module exports. */
export interface ModuleExports {
  memory: WebAssembly.Memory;
  torse_reserve(length: number): number;
  torse_answer(): number;
  torse_answer_length(): number;
}

/** The bytes before the head; the head's length is a multiple of it. */
const ALIGNMENT = 8;

/** Starts a module. Nothing of a page is given to it: what its libraries import for browsers is never called. */
export async function instantiate(module: WebAssembly.Module): Promise<ModuleExports> {
  const imports: Record<string, Record<string, () => never>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = () => {
      throw new Error(`the module asks its page for ${name}`);
    };
  }
  const instance = await WebAssembly.instantiate(module, imports);
  return instance.exports as unknown as ModuleExports;
}

/** Asks a module and returns what it answers. A trap is thrown: the module must not be asked again. */
export function ask(module: ModuleExports, question: Packet): Packet {
  const text = new TextEncoder().encode(JSON.stringify(question.head));
  const padded = Math.ceil(text.length / ALIGNMENT) * ALIGNMENT;
  const length = ALIGNMENT + padded + question.body.length;
  const at = module.torse_reserve(length);
  const written = new Uint8Array(module.memory.buffer, at, length);
  new DataView(written.buffer, at).setUint32(0, padded, true);
  written.fill(0x20, ALIGNMENT, ALIGNMENT + padded);
  written.set(text, ALIGNMENT);
  written.set(question.body, ALIGNMENT + padded);
  const from = module.torse_answer() >>> 0;
  // The memory may have grown, and have another buffer.
  const answer = new Uint8Array(module.memory.buffer, from, module.torse_answer_length() >>> 0);
  const headLength = new DataView(answer.buffer, from).getUint32(0, true);
  const head = new TextDecoder().decode(answer.subarray(ALIGNMENT, ALIGNMENT + headLength));
  return { head: JSON.parse(head), body: answer.slice(ALIGNMENT + headLength) };
}
