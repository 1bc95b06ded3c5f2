// The page in a browser, as somebody uses it: typed, dragged, dropped, shared, without a network.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, designs, page as address, root, torse, verdicts } from "./support.mjs";

const temporary = mkdtempSync(join(tmpdir(), "torse-page-"));
let chromium;
before(async () => {
  chromium = await browser();
});
after(async () => {
  await chromium?.close();
  rmSync(temporary, { recursive: true });
});

/** Opens the page without a network; every message of its console and every request is a failure. */
async function open(hash = "", options = {}) {
  const context = await chromium.newContext({ offline: true, acceptDownloads: true, viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()) && wrong.push(message.text()));
  page.on("pageerror", (error) => wrong.push(String(error)));
  page.on("request", (request) => /^(file|blob|data):/.test(request.url()) || wrong.push(request.url()));
  await page.goto(`${address}${hash}`);
  return { page, context, wrong };
}

/** Waits until the design was measured, with bounds and proofs if `proved`. */
async function judged(page, proved = false) {
  const wanted = proved ? /with bounds and proofs|mistake|ended/ : /Measured|mistake|ended/;
  await page.waitForFunction((wanted) => new RegExp(wanted).test(document.getElementById("judged").textContent), wanted.source, { timeout: 60_000 });
  return page.textContent("#judged");
}

/** The view in space as a picture. */
const shot = (page) => page.$eval("#space", (canvas) => canvas.toDataURL());

/** Waits until the view in space is another picture, or the one given. */
const changed = (page, before) => page.waitForFunction((before) => document.getElementById("space").toDataURL() !== before, before);
const shows = (page, picture) => page.waitForFunction((picture) => document.getElementById("space").toDataURL() === picture, picture);

const pattern = (page) => page.$eval("#flat .layer-outline path", (path) => path.getAttribute("d"));

test("the page opens from a file, without a request or a message, and shows a design", async () => {
  const { page, wrong, context } = await open();
  assert.match(await judged(page, true), /^Yes/);
  assert.ok((await pattern(page)).length > 100);
  const painted = await page.evaluate(() => {
    const canvas = document.getElementById("space");
    const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) count += data[k] > 0 ? 1 : 0;
    return count / (copy.width * copy.height);
  });
  assert.ok(painted > 0.05, `${painted} of the view is painted`);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a formula is typed, refuted and corrected", async () => {
  const { page, wrong, context } = await open("#formulas");
  await page.fill("#statement", "(a + b)^2 == a^2 + b^2");
  // The statement that the page begins with has names, too.
  await page.waitForFunction(() => [...document.querySelectorAll("#names code")].map((name) => name.textContent).join() === "a,b");
  await page.waitForSelector("#preview math");
  await page.click("#decide");
  await page.waitForSelector(".verdict", { timeout: 60_000 });
  assert.match(await page.textContent(".verdict"), /False/);
  assert.match(await page.textContent("#answer table"), /left side\s*4/);
  const json = await page.$eval("#json", (pre) => pre.textContent);
  const native = spawnSync(torse, ["decide", "(a + b)^2 == a^2 + b^2", "--format", "json"]).stdout.toString();
  assert.equal(json, native);
  // A declaration that is proposed is taken, and a mistake is shown where it is.
  await page.selectOption("#names select >> nth=0", { label: "positive" });
  assert.equal(await page.inputValue("#setting"), "a > 0");
  await page.fill("#statement", "x + == 1");
  await page.click("#decide");
  await page.waitForSelector("#statement-messages li", { timeout: 20_000 });
  assert.match(await page.textContent("#statement-messages"), /the statement, column 5/);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the folder of a paper is decided claim by claim, with the JSON of the command", async () => {
  const { page, wrong, context } = await open("#formulas");
  await page.setInputFiles("#paper", join(root, "derivations/splines"));
  await page.waitForSelector("#answer button:not([disabled])", { timeout: 120_000 });
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#answer button")]);
  await download.saveAs(join(temporary, "verdicts.json"));
  const native = verdicts("splines");
  assert.equal(readFileSync(join(temporary, "verdicts.json"), "utf8"), native);
  const claims = JSON.parse(native).claims.length;
  assert.equal(await page.locator("#answer tbody tr").count(), claims);
  assert.match(await page.textContent("#answer [role=status]"), new RegExp(`^${claims} of ${claims}`));
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a slider changes the text, the pattern and the address, and can be undone", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const [before, text] = [await pattern(page), await page.inputValue("#text")];
  const slider = page.locator('input[type="range"][aria-label="a"]');
  await slider.focus();
  for (let k = 0; k < 5; k++) await page.keyboard.press("ArrowRight");
  await page.waitForFunction((before) => document.querySelector("#flat .layer-outline path").getAttribute("d") !== before, before);
  assert.match(await page.inputValue("#text"), /^a = (?!160$)/m);
  await page.waitForFunction(() => location.hash.includes("design="));
  await page.click("#undo");
  assert.equal(await page.inputValue("#text"), text);
  await page.waitForFunction((before) => document.querySelector("#flat .layer-outline path").getAttribute("d") === before, before);
  await page.click("#redo");
  assert.notEqual(await page.inputValue("#text"), text);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("what is wrong is shown at its line, and what is missed in red", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const text = await page.inputValue("#text");
  await page.fill("#text", text.replace('apex = "apex"', 'apex = "summit"'));
  await page.waitForSelector("#messages button");
  const line = text.split("\n").findIndex((line) => line.includes('apex = "apex"')) + 1;
  assert.match(await page.textContent("#messages"), new RegExp(`line ${line}:.*summit`));
  assert.equal(await page.textContent(".line-numbers .wrong"), String(line));
  // Two halves of cones that do not meet smoothly are missed, and their numbers told.
  await page.fill("#text", text.replace("from = [0, \"b\", 0], to = [\"-a\", 0, 0]", "from = [0, \"b\", 0], to = [\"-a\", 10, 0]"));
  await page.waitForSelector("#missed li");
  assert.match(await page.getAttribute("#judged", "class"), /missed/);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the sheet bends from flat to its shape, and the pattern stays", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const before = await pattern(page);
  const shape = await shot(page);
  await page.$eval("#bend", (slider) => {
    slider.value = "0";
    slider.dispatchEvent(new Event("input"));
  });
  await page.waitForFunction(() => /^0 %/.test(document.getElementById("bend-says").textContent));
  await changed(page, shape);
  assert.equal(await pattern(page), before);
  await page.waitForFunction(() => /bend=0/.test(location.hash));
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the files that are downloaded are those of the command", async () => {
  const { page, wrong, context } = await open("#designs?start=cone-elbow");
  await judged(page);
  for (const ending of ["dxf", "svg", "step", "3mf", "stl"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[data-file="whole.${ending}"]`)]);
    assert.equal(download.suggestedFilename(), `cone-elbow.${ending}`);
    const [here, there] = [join(temporary, `page.${ending}`), join(temporary, `command.${ending}`)];
    await download.saveAs(here);
    spawnSync(torse, ["export", "cone-elbow.toml", "--to", there], { cwd: designs });
    assert.ok(readFileSync(here).equals(readFileSync(there)), ending);
  }
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a link shows the same design to somebody else", async () => {
  const first = await open("#designs?start=hull-strake");
  await judged(first.page);
  const text = (await first.page.inputValue("#text")).replace("thickness = 0.006", "thickness = 0.005");
  await first.page.fill("#text", text);
  await first.page.waitForFunction(() => location.hash.includes("design="));
  await judged(first.page);
  const hash = await first.page.evaluate(() => location.hash);
  const second = await open(hash);
  await judged(second.page);
  assert.equal(await second.page.inputValue("#text"), text);
  assert.equal(await pattern(second.page), await pattern(first.page));
  assert.deepEqual([...first.wrong, ...second.wrong], []);
  await first.context.close();
  await second.context.close();
});

test("curves of a file that is dropped become a design, and the design unrolls as by the command", async () => {
  const { page, wrong, context } = await open();
  await judged(page);
  const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200"><path id="deck" d="M0 0C100 40 200 40 300 0"/><path id="keel" d="M0 100C100 150 200 150 300 100"/></svg>';
  const data = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "strake.svg"));
    return data;
  }, svg);
  await page.dispatchEvent("#main", "drop", { dataTransfer: data });
  await page.waitForFunction(() => document.getElementById("text").value.includes("strake.svg#"));
  await page.waitForFunction(() => document.getElementById("title").textContent === "strake.svg");
  // Both lie in one plane, where no developable but the plane touches them.
  assert.match(await page.inputValue("#text"), /^ruled = /m);
  const text = await page.inputValue("#text");
  assert.match(text, /import = "strake.svg#deck"/);
  writeFileSync(join(temporary, "strake.svg"), svg);
  writeFileSync(join(temporary, "strake.toml"), text);
  const [download] = await Promise.all([page.waitForEvent("download"), page.click('[data-file="whole.dxf"]')]);
  await download.saveAs(join(temporary, "page.dxf"));
  spawnSync(torse, ["export", "strake.toml", "--to", "command.dxf"], { cwd: temporary });
  assert.ok(readFileSync(join(temporary, "page.dxf")).equals(readFileSync(join(temporary, "command.dxf"))));
  assert.deepEqual(wrong, []);
  await context.close();
});

/** Takes the handle of a point and moves it by so many pixels, and holds it there. */
async function drag(page, name, dx, dy) {
  const box = await page.locator(`.handle[data-point="${name}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 8; k++) {
    await page.mouse.move(x + (dx * k) / 8, y + (dy * k) / 8);
    await page.waitForTimeout(30);
  }
}

test("a point is dragged on a grid, in one step back, and the file is that of the command", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page, true);
  const [text, before] = [await page.inputValue("#text"), await pattern(page)];
  await page.fill("#snap", "5");
  await drag(page, "apex", 30, -14);
  await page.mouse.up();
  await page.waitForFunction((before) => document.querySelector("#flat .layer-outline path").getAttribute("d") !== before, before);
  const moved = await page.inputValue("#text");
  const apex = /^apex = \[(.*), (.*), (.*)\]$/m.exec(moved).slice(1).map(Number);
  assert.notDeepEqual(apex, [10, 0, 330]);
  // Of the three coordinates two have moved, and stand on the grid.
  assert.equal(apex.filter((value, k) => value === [10, 0, 330][k]).length, 1, `${apex}`);
  for (const value of apex) assert.equal(value % 5, 0, `${apex}`);
  // Nothing else of the text has changed.
  assert.equal(moved.replace(/^apex = .*$/m, ""), text.replace(/^apex = .*$/m, ""));
  assert.equal(await page.inputValue('[aria-label="apex, x"]'), String(apex[0]));
  const [file] = await Promise.all([page.waitForEvent("download"), page.click('[data-file="whole.dxf"]')]);
  await file.saveAs(join(temporary, "page.dxf"));
  writeFileSync(join(temporary, "lampshade.toml"), moved);
  spawnSync(torse, ["export", "lampshade.toml", "--to", "command.dxf"], { cwd: temporary });
  assert.ok(readFileSync(join(temporary, "page.dxf")).equals(readFileSync(join(temporary, "command.dxf"))));
  await page.click("#undo");
  assert.equal(await page.inputValue("#text"), text);
  await page.waitForFunction((before) => document.querySelector("#flat .layer-outline path").getAttribute("d") === before, before);
  await page.click("#redo");
  assert.equal(await page.inputValue("#text"), moved);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("what is missed is red while a point is in the hand, and a formula does not move", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page, true);
  const text = await page.inputValue("#text");
  // The start of a quarter of the rim: the one before ends elsewhere then.
  await drag(page, "third 1", 0, -40);
  await page.waitForFunction(() => /missed/.test(document.getElementById("judged").className) && document.querySelectorAll("#missed li").length > 0, undefined, { timeout: 20_000 });
  await page.mouse.up();
  const moved = await page.inputValue("#text");
  assert.notEqual(moved, text);
  assert.match(moved, /third = .*from = \["-a", /);
  assert.ok(await page.isDisabled('[aria-label="third 1, x"]'));
  await page.keyboard.press("Control+z");
  await page.click("#undo").catch(() => {});
  assert.equal(await page.inputValue("#text"), text);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("keys move a point: typed, and by steps", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  await page.fill("#snap", "2");
  const field = page.locator('[aria-label="apex, z"]');
  await field.focus();
  for (const key of ["ArrowUp", "ArrowUp", "Shift+ArrowUp", "ArrowDown"]) await page.keyboard.press(key);
  assert.match(await page.inputValue("#text"), /^apex = \[10, 0, 352\]$/m);
  assert.equal(await page.locator('.handle.looked[data-point="apex"]').count(), 1);
  await field.fill("341.5");
  await page.keyboard.press("Enter");
  assert.match(await page.inputValue("#text"), /^apex = \[10, 0, 341.5\]$/m);
  await judged(page);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("colours stand for curvature and strain, and the legend says how far they go", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const plain = await shot(page);
  await page.selectOption("#shade", "curvature");
  await changed(page, plain);
  assert.match(await page.textContent("#legend-high"), /^[\d.]+ mm$/);
  const radius = Number.parseFloat(await page.textContent("#legend-high"));
  await page.selectOption("#shade", "strain");
  // Of the outer fibre of a sheet of 0.4 mm.
  const strain = Number.parseFloat(await page.textContent("#legend-high"));
  assert.ok(Math.abs(strain - (100 * 0.2) / radius) < 0.01 * strain, `${strain} % at ${radius} mm`);
  // A design without a sheet has no strain.
  await page.selectOption("#start", "gbt-spine");
  await page.waitForFunction(() => /spine|Spine/.test(document.getElementById("text").value));
  await judged(page);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the bending sheet is kept as a GIF with the bytes of the command", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const [file] = await Promise.all([page.waitForEvent("download", { timeout: 120_000 }), page.click("#gif")]);
  assert.equal(file.suggestedFilename(), "lampshade.gif");
  await file.saveAs(join(temporary, "page.gif"));
  spawnSync(torse, ["draw", "lampshade.toml", "--to", join(temporary, "command.gif")], { cwd: designs });
  assert.ok(readFileSync(join(temporary, "page.gif")).equals(readFileSync(join(temporary, "command.gif"))));
  assert.deepEqual(wrong, []);
  await context.close();
});

test("two hundred steps of a slider leave the heap as it was", async () => {
  const { page, context } = await open("#designs?start=cone-elbow");
  await judged(page);
  const session = await context.newCDPSession(page);
  const heap = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return (await page.evaluate(() => performance.memory.usedJSHeapSize)) / 1e6;
  };
  const drag = (count) =>
    page.evaluate(async (count) => {
      const slider = document.querySelector('#sliders input[type="range"]');
      const [low, high] = [Number(slider.min), Number(slider.max)];
      const shown = () => document.querySelector("#flat .layer-outline path").getAttribute("d");
      for (let k = 0; k < count; k++) {
        const before = shown();
        slider.value = String(low + (high - low) * (0.4 + 0.2 * Math.abs(Math.sin(k))));
        slider.dispatchEvent(new Event("input"));
        for (let wait = 0; wait < 200 && shown() === before; wait++) await new Promise((done) => setTimeout(done, 5));
      }
    }, count);
  await drag(20);
  const before = await heap();
  await drag(200);
  const grown = (await heap()) - before;
  assert.ok(grown < 3, `${grown} MB more after two hundred steps, from ${before} MB`);
  await context.close();
});

test("a module that traps is started again, and nothing that was typed is lost", async () => {
  const { page, context } = await open("#formulas");
  // Deep nesting, which ends a small stack if anything does; whatever comes of it, the page stays usable.
  const deep = `${"(".repeat(20_000)}x${")".repeat(20_000)} == x`;
  await page.fill("#statement", deep);
  await page.click("#decide");
  await page.waitForSelector("#answer .card, #statement-messages li", { timeout: 60_000 });
  assert.equal(await page.inputValue("#statement"), deep);
  await page.fill("#statement", "x + x == 2*x");
  await page.click("#decide");
  await page.waitForSelector(".verdict-holds", { timeout: 60_000 });
  await context.close();
});

for (const [width, scheme] of [[360, "light"], [360, "dark"], [1440, "light"], [1440, "dark"], [3840, "light"]]) {
  test(`at ${width} pixels in ${scheme} colours nothing overflows and axe finds no violation`, async () => {
    const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
    for (const hash of ["#designs?start=lampshade", "#formulas?is=(a+%2B+b)%5E2+%3D%3D+a%5E2+%2B+b%5E2"]) {
      // The page's policy lets no script of a test in.
      const { page, context } = await open(hash, { viewport: { width, height: 900 }, colorScheme: scheme, reducedMotion: "reduce", bypassCSP: true });
      if (hash.startsWith("#designs")) await judged(page);
      else await page.waitForSelector(".verdict", { timeout: 60_000 });
      if (hash.startsWith("#designs")) await page.selectOption("#shade", "strain");
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${hash} is ${wide} pixels too wide`);
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => globalThis.axe.run());
      assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(", ")}`), []);
      await context.close();
    }
  });
}

test("keys reach everything: tabs, sliders, the view in space", async () => {
  const { page, wrong, context } = await open("#designs?start=lampshade");
  await judged(page);
  const reached = new Set();
  for (let k = 0; k < 100; k++) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label") || document.activeElement.tagName));
  }
  for (const id of ["tab-formulas", "theme", "start", "open", "share", "space", "bend", "play", "a", "a, typed", "text"]) assert.ok(reached.has(id), `${id} among ${[...reached]}`);
  await page.focus("#space");
  const front = await shot(page);
  await page.keyboard.press("ArrowLeft");
  await changed(page, front);
  await page.keyboard.press("Home");
  await shows(page, front);
  assert.deepEqual(wrong, []);
  await context.close();
});
