// `torse studio` in a browser: a folder's designs and papers are shown, shown again when they change, and saved.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, designs, root, torse } from "./support.mjs";

let chromium;
const started = [];
before(async () => {
  chromium = await browser();
});
after(async () => {
  await chromium?.close();
  for (const { child, folder } of started) {
    child.kill();
    rmSync(folder, { recursive: true });
  }
});

/** A folder with two designs and a paper, served, and its page. */
async function serve() {
  const folder = mkdtempSync(join(tmpdir(), "torse-studio-"));
  for (const name of ["lampshade", "cone-elbow"]) copyFileSync(join(designs, `${name}.toml`), join(folder, `${name}.toml`));
  mkdirSync(join(folder, "splines"));
  for (const name of readdirSync(join(root, "derivations/splines"))) {
    if (name.endsWith(".toml")) copyFileSync(join(root, "derivations/splines", name), join(folder, "splines", name));
  }
  const child = spawn(torse, ["studio", folder, "--page", join(root, "target/web/site")]);
  started.push({ child, folder });
  const [line] = await once(child.stdout, "data");
  const address = String(line).trim();
  const context = await chromium.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()) && wrong.push(message.text()));
  page.on("pageerror", (error) => wrong.push(String(error)));
  page.on("request", (request) => request.url().startsWith(address) || request.url().startsWith("blob:") || wrong.push(request.url()));
  return { child, folder, address, context, page, wrong };
}

const text = (page) => page.inputValue("#text");
const measured = (page) => page.waitForFunction(() => /Measured/.test(document.getElementById("judged").textContent), undefined, { timeout: 60_000 });
const textIs = (page, wanted) => page.waitForFunction((wanted) => document.getElementById("text").value === wanted, wanted, { timeout: 20_000 });

test("a design of the folder is shown, follows its file, and is saved when that is asked for", async () => {
  const { folder, address, context, page, wrong } = await serve();
  await page.goto(`${address}#designs?file=lampshade.toml`);
  await measured(page);
  const file = join(folder, "lampshade.toml");
  const first = readFileSync(file, "utf8");
  assert.equal(await text(page), first);
  assert.ok(await page.isDisabled("#save"));

  // What is changed in the page alone is not written.
  const second = first.replace("a = 160", "a = 150");
  await page.fill("#text", second);
  await page.waitForFunction(() => !document.getElementById("save").disabled);
  await page.waitForTimeout(600);
  assert.equal(readFileSync(file, "utf8"), first);
  await page.focus("#text");
  await page.keyboard.press("Control+s");
  await page.waitForFunction(() => document.getElementById("save").disabled);
  assert.equal(readFileSync(file, "utf8"), second);
  await page.waitForFunction(() => location.hash.includes("file=lampshade.toml"));

  // What an editor saves is shown, and can be undone.
  const third = second.replace("b = 120", "b = 130");
  writeFileSync(file, third);
  await textIs(page, third);
  await page.click("#undo");
  assert.equal(await text(page), second);
  await page.click("#redo");

  // Both change: neither is lost without a word.
  const mine = third.replace("b = 130", "b = 111");
  const theirs = third.replace("b = 130", "b = 140");
  await page.fill("#text", mine);
  writeFileSync(file, theirs);
  await page.waitForSelector("#conflict:not([hidden])");
  assert.equal(await text(page), mine);
  await page.click("#save");
  await page.waitForTimeout(600);
  assert.equal(readFileSync(file, "utf8"), theirs);
  await page.click("#keep-mine");
  await page.waitForFunction(() => document.getElementById("conflict").hidden);
  await page.click("#save");
  await page.waitForFunction(() => document.getElementById("save").disabled);
  assert.equal(readFileSync(file, "utf8"), mine);
  // The save that was refused is a refusal to the console as well.
  assert.deepEqual(wrong.filter((words) => !/412/.test(words)), []);
  await context.close();
});

test("another design of the folder is chosen, a new one is listed, and a worked one is none of the folder", async () => {
  const { folder, address, context, page, wrong } = await serve();
  await page.goto(address);
  await textIs(page, readFileSync(join(folder, "cone-elbow.toml"), "utf8"));
  const listed = () => page.$$eval("#folder-design option", (options) => options.map((option) => option.value).filter((value) => value !== ""));
  assert.deepEqual(await listed(), ["cone-elbow.toml", "lampshade.toml"]);
  writeFileSync(join(folder, "new.toml"), readFileSync(join(designs, "lampshade.toml"), "utf8").replace('title = "', 'title = "New: '));
  await page.waitForSelector('#folder-design option[value="new.toml"]', { state: "attached" });
  await page.selectOption("#folder-design", "new.toml");
  await page.waitForFunction(() => document.getElementById("title").textContent.startsWith("New: "));
  await page.selectOption("#start", "hull-strake");
  await page.waitForFunction(() => /^Bottom strake/.test(document.getElementById("title").textContent));
  await page.fill("#text", (await text(page)).replace("0.006", "0.005"));
  assert.ok(await page.isDisabled("#save"));
  assert.equal(await page.inputValue("#folder-design"), "");
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a paper of the folder is decided, and again when it is changed; that the command has ended is said", async () => {
  const { child, folder, address, context, page, wrong } = await serve();
  await page.goto(`${address}#formulas`);
  await page.waitForSelector('#folder-paper option[value="splines"]', { state: "attached" });
  await page.selectOption("#folder-paper", "splines");
  const done = () => page.waitForSelector("#answer .bar button:not([disabled])", { timeout: 120_000 });
  await done();
  const heading = () => page.textContent("#answer h2");
  const head = join(folder, "splines/paper.toml");
  const before = await heading();
  writeFileSync(head, readFileSync(head, "utf8").replace(/^title = (["'])/m, "title = $1Changed: "));
  await page.waitForFunction((before) => document.querySelector("#answer h2")?.textContent !== before, before, { timeout: 60_000 });
  assert.match(await heading(), /^Changed: /);
  await done();
  assert.deepEqual(wrong, []);
  child.kill();
  await page.waitForSelector("#lost:not([hidden])");
  await context.close();
});
