// Puts the page together: target/web/torse.html, one file with the modules within, which works from a folder without a
// network; and target/web/site/, the same with the modules beside it, loaded when they are asked for: index.html for a host of
// static files, studio.html for `torse studio`.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, readdirSync, writeFileSync, copyFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { buildSync } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "..");
const out = join(root, "target/web");
const MODULES = ["designs", "formulas"];

/** Bundles a file of TypeScript. */
function bundle(file, define) {
  const made = buildSync({ entryPoints: [join(here, "page", file)], bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8", write: false, define });
  return made.outputFiles[0].text;
}

const starts = readdirSync(join(root, "designs"))
  .filter((file) => file.endsWith(".toml"))
  .sort()
  .map((file) => {
    const text = readFileSync(join(root, "designs", file), "utf8");
    return { name: file.slice(0, -5), title: /^title = "(.*)"$/m.exec(text)?.[1] ?? file, text };
  });
const version = /^version = "(.*)"$/m.exec(readFileSync(join(root, "Cargo.toml"), "utf8"))[1];
const worker = bundle("worker.ts", {});
const script = bundle("main.ts", {
  STARTS: JSON.stringify(starts),
  VERSION: JSON.stringify(version),
  WORKER_SOURCE: JSON.stringify(worker),
}).replaceAll("</script", "<\\/script");
const style = readFileSync(join(here, "page/style.css"), "utf8").trim();
const template = readFileSync(join(here, "page/page.html"), "utf8");

/** The page; `connect` is what it may load, `studio` what tells it that the command serves it. */
function page(modules, connect, studio = "") {
  const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  const policy = [
    "default-src 'none'",
    `script-src ${hash(script)} 'wasm-unsafe-eval' blob:`,
    `style-src ${hash(style)}`,
    "worker-src blob:",
    `connect-src ${connect}`,
    "img-src data: blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const parts = { policy, style, modules, script, studio };
  return template.replace(/@@(\w+)@@/g, (_, name) => parts[name]);
}

const wasm = Object.fromEntries(MODULES.map((name) => [name, readFileSync(join(out, `${name}.wasm`))]));
const within = MODULES.map((name) => {
  const packed = gzipSync(wasm[name], { level: 9 }).toString("base64");
  return `<script type="text/plain" id="module-${name}">${packed}</script>`;
}).join("\n");
const single = page(within, "'none'");
writeFileSync(join(out, "torse.html"), single);
mkdirSync(join(out, "site"), { recursive: true });
writeFileSync(join(out, "site/index.html"), page("", "'self'"));
writeFileSync(join(out, "site/studio.html"), page("", "'self'", '<meta name="torse-studio">\n'));
for (const name of MODULES) copyFileSync(join(out, `${name}.wasm`), join(out, `site/${name}.wasm`));
console.log(`torse.html: ${(single.length / 1e6).toFixed(2)} MB; script ${(script.length / 1e3).toFixed(0)} kB`);
for (const name of MODULES) {
  console.log(`${name}.wasm: ${(wasm[name].length / 1e6).toFixed(2)} MB, ${(gzipSync(wasm[name], { level: 9 }).length / 1e6).toFixed(2)} MB packed`);
}
