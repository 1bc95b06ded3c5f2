// Pictures of the page, to be looked at: node tests/look.mjs FOLDER.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { browser, page as address } from "./support.mjs";

const folder = process.argv[2] ?? "pictures";
mkdirSync(folder, { recursive: true });
const chromium = await browser();
const VIEWS = {
  design: "#designs?start=lampshade",
  strake: "#designs?start=hull-strake&bend=0.5",
  elbow: "#designs?start=cone-elbow",
  square: "#designs?start=square-to-round&bend=0.4",
  surfaces: "#designs?start=gbt-surfaces",
  refuted: "#formulas?is=sin(3*x)+%3D%3D+3*sin(x)+%2B+4*sin(x)%5E3",
  sum: "#formulas?is=sum(i%2C+0%2C+n%2C+binom(n%2C+i)*x%5Ei*(1+-+x)%5E(n+-+i))+%3D%3D+1&where=n+in+0..",
};
const only = process.argv[3]?.split(",");
for (const [width, scheme] of [[1440, "light"], [1440, "dark"], [360, "light"], [360, "dark"]]) {
  for (const [name, hash] of Object.entries(VIEWS)) {
    if (only && !only.includes(name)) continue;
    const context = await chromium.newContext({ offline: true, viewport: { width, height: 900 }, colorScheme: scheme });
    const page = await context.newPage();
    page.on("console", (message) => console.log(name, message.text()));
    page.on("pageerror", (error) => console.log(name, String(error)));
    await page.goto(`${address}${hash}`);
    const done = hash.startsWith("#designs") ? () => /Yes|Not as|mistake|ended/.test(document.getElementById("judged").textContent) : () => document.querySelector(".verdict");
    await page.waitForFunction(done, undefined, { timeout: 20_000 }).catch(() => console.log(name, "is not ready"));
    await page.waitForTimeout(400);
    await page.screenshot({ path: join(folder, `${name}-${width}-${scheme}.png`), fullPage: true });
    await context.close();
  }
}
await chromium.close();
