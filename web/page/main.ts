// The page: two views, the colours, the address.

import { readAddress } from "./address.ts";
import { startDesigns } from "./designs.ts";
import { byId } from "./dom.ts";
import { startFormulas } from "./formulas.ts";
import { isServed, ServedFolder } from "./studio.ts";

declare const VERSION: string;

const VIEWS = ["designs", "formulas"] as const;

/** Keeps a choice where the browser allows it. */
function remembered(name: string, value?: string): string {
  try {
    if (value !== undefined) localStorage.setItem(name, value);
    return localStorage.getItem(name) ?? "";
  } catch {
    return value ?? "";
  }
}

function startColours(redraw: () => void): void {
  const theme = byId<HTMLSelectElement>("theme");
  const follow = () => {
    document.documentElement.dataset.theme = theme.value;
    redraw();
  };
  theme.value = remembered("torse-theme");
  theme.addEventListener("change", () => {
    remembered("torse-theme", theme.value);
    follow();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  follow();
}

const folder = isServed() ? new ServedFolder((lost) => (byId("lost").hidden = !lost)) : undefined;
const designs = startDesigns(folder);
const formulas = startFormulas(folder);
startColours(() => designs.redraw());
byId("version").textContent = `torse ${VERSION}`;

/** Shows the view of the address. */
function follow(): void {
  const { view, entries } = readAddress(location.hash);
  const shown = VIEWS.find((name) => name === view) ?? "designs";
  for (const name of VIEWS) {
    byId(name).hidden = name !== shown;
    const tab = byId(`tab-${name}`);
    if (name === shown) tab.setAttribute("aria-current", "page");
    else tab.removeAttribute("aria-current");
  }
  if (shown === "designs") void designs.open(entries);
  else formulas.open(entries);
}

window.addEventListener("hashchange", follow);
for (const part of document.querySelectorAll<HTMLElement>(".studio")) part.hidden = folder === undefined;
void Promise.resolve(folder?.start()).then(follow);
