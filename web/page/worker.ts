// A worker that holds one module: it starts the module that the page sends first, and answers questions one by one.

import { ask, instantiate, type ModuleExports, type Packet } from "./packet.ts";

interface Asked {
  id: number;
  question: Packet;
}

let starting: Promise<ModuleExports> | undefined;

self.onmessage = async (event: MessageEvent<{ module: WebAssembly.Module } | Asked>) => {
  const data = event.data;
  if ("module" in data) {
    starting = instantiate(data.module);
    return;
  }
  try {
    const module = await starting;
    if (!module) throw new Error("no module was sent");
    const answer = ask(module, data.question);
    self.postMessage({ id: data.id, answer }, { transfer: [answer.body.buffer] });
  } catch (error) {
    // A trap leaves the module in an unknown state: the page ends this worker.
    self.postMessage({ id: data.id, failed: String(error) });
  }
};
