// Modules in workers: asked by the page, ended when they fail or are no longer wanted, started anew when they are asked again.

import type { Packet } from "./packet.ts";

/** The name of a module. */
export type ModuleName = "designs" | "formulas";

/** What is wrong, with its place in a text. */
export interface Message {
  file: string | null;
  line: number | null;
  column: number | null;
  length: number;
  text: string;
  hint: string | null;
}

/** A message without a place. */
export function unplaced(text: string): Message {
  return { file: null, line: null, column: null, length: 0, text, hint: null };
}

/** Why there is no answer: the input is refused. */
export class Refusal extends Error {
  constructor(
    text: string,
    readonly messages: Message[],
  ) {
    super(text);
  }
}

/** The question was given up for a newer one. */
export class GivenUp extends Error {}

/** The module was ended by a trap: an error of torse, or its memory was spent. */
export class Trapped extends Error {}

/** The source of the worker, put here when the page is built. */
declare const WORKER_SOURCE: string;

const compiled = new Map<ModuleName, Promise<WebAssembly.Module>>();

/** The module: within the page as packed base64, or a file beside it. */
function compile(name: ModuleName): Promise<WebAssembly.Module> {
  let module = compiled.get(name);
  if (!module) {
    module = load(name).then((bytes) => WebAssembly.compile(bytes));
    module.catch(() => compiled.delete(name));
    compiled.set(name, module);
  }
  return module;
}

async function load(name: ModuleName): Promise<ArrayBuffer> {
  const inside = document.getElementById(`module-${name}`);
  if (!inside) {
    const response = await fetch(`${name}.wasm`);
    if (!response.ok) throw new Error(`${name}.wasm: ${response.status}`);
    return response.arrayBuffer();
  }
  const packed = Uint8Array.from(atob(inside.textContent ?? ""), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

interface Waiting {
  resolve(answer: Packet): void;
  reject(reason: Error): void;
}

/** A worker with a module. Of questions of one kind only the newest waits; older ones are given up. */
export class Asker {
  private worker: Worker | undefined;
  private waiting: { kind: string; question: Packet; promise: Waiting }[] = [];
  private current: { id: number; kind: string; promise: Waiting } | undefined;
  private next = 1;

  constructor(
    private readonly name: ModuleName,
    private readonly onTrap: (reason: string) => void = () => {},
  ) {}

  /** Asks; `kind` is what a newer question replaces. Rejects with a Refusal, GivenUp or Trapped. */
  ask<T>(kind: string, head: object, body = new Uint8Array(0)): Promise<{ value: T; body: Uint8Array<ArrayBuffer> }> {
    return new Promise<Packet>((resolve, reject) => {
      this.waiting = this.waiting.filter((older) => {
        if (older.kind === kind) older.promise.reject(new GivenUp());
        return older.kind !== kind;
      });
      this.waiting.push({ kind, question: { head, body }, promise: { resolve, reject } });
      void this.go();
    }).then(({ head, body }) => {
      const refused = (head as { error?: { text: string; messages: Message[] } } | null)?.error;
      if (refused) throw new Refusal(refused.text, refused.messages);
      return { value: head as T, body };
    });
  }

  /** Ends what is being answered, and everything that waits. */
  stop(): void {
    this.end(new GivenUp());
  }

  private end(reason: Error): void {
    this.worker?.terminate();
    this.worker = undefined;
    const { current, waiting } = this;
    this.current = undefined;
    this.waiting = [];
    current?.promise.reject(reason);
    for (const { promise } of waiting) promise.reject(new GivenUp());
  }

  private async go(): Promise<void> {
    if (this.current) return;
    const first = this.waiting.shift();
    if (!first) return;
    const id = this.next++;
    this.current = { id, kind: first.kind, promise: first.promise };
    try {
      const module = await compile(this.name);
      // It may have been stopped while the module was compiled.
      if (this.current?.id !== id) return;
      this.worker ??= this.start(module);
      this.worker.postMessage({ id, question: first.question });
    } catch (error) {
      this.trap(String(error));
    }
  }

  private start(module: WebAssembly.Module): Worker {
    const source = URL.createObjectURL(new Blob([WORKER_SOURCE], { type: "text/javascript" }));
    const worker = new Worker(source, { name: this.name });
    URL.revokeObjectURL(source);
    worker.onmessage = ({ data }: MessageEvent<{ id: number; answer?: Packet; failed?: string }>) => {
      if (this.worker !== worker || this.current?.id !== data.id) return;
      if (data.failed !== undefined) return this.trap(data.failed);
      const { promise } = this.current;
      this.current = undefined;
      if (data.answer) promise.resolve(data.answer);
      void this.go();
    };
    worker.onerror = (event) => this.trap(event.message || "the worker ended");
    worker.postMessage({ module });
    return worker;
  }

  private trap(reason: string): void {
    this.end(new Trapped(reason));
    this.onTrap(reason);
  }
}
