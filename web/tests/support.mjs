// What the tests share: the command, the modules, the page in a browser.

import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { buildSync } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, "../..");
export const designs = join(root, "designs");
/** The command, built by `cargo build`. */
export const torse = process.env.TORSE ?? join(root, "target/debug/torse");
/** What the command says of a paper, without what the kernel accepted: the list of that is no part of a paper's folder. */
export function verdicts(paper) {
  const json = spawnSync(torse, ["verify", paper, "--format", "json"], { cwd: root, maxBuffer: 1 << 28 }).stdout;
  return json.toString().replaceAll(/^ *"kernel": "accepted",\n/gm, "");
}

/** The page as one file. */
export const page = pathToFileURL(join(root, "target/web/torse.html")).href;

/** The page's own words for packets, for this process. */
const { outputFiles } = buildSync({ entryPoints: [join(here, "../page/packet.ts")], bundle: true, format: "esm", write: false });
const packets = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);

/** Starts a module and returns how it is asked. */
export async function module(name) {
  const bytes = readFileSync(join(root, `target/web/${name}.wasm`));
  const exports = await packets.instantiate(await WebAssembly.compile(bytes));
  return (head, body = new Uint8Array(0)) => packets.ask(exports, { head, body });
}

/** Starts Debian's Chromium without a network. */
export async function browser() {
  const { chromium } = await import("playwright-core");
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(executablePath)) throw new Error(`${executablePath} is not there: apt-get install chromium`);
  const args = [
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--js-flags=--expose-gc",
  ];
  return chromium.launch({ executablePath, args });
}
