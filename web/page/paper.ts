// A paper's folder that is dropped: its claims are decided one by one, and shown as they are.

import { VERDICTS } from "./answer.ts";
import { byId, download, make, say } from "./dom.ts";
import { Asker, GivenUp } from "./modules.ts";
import { bodyOf } from "./state.ts";
import type { ServedFolder } from "./studio.ts";

interface ReadPaper {
  id: string;
  title: string;
  claims: string[];
}

interface DecidedClaim {
  id: string;
  at: string;
  printed: string;
  verdict: string;
  label: string;
  corrected: string | null;
}

/** The texts of a paper, by their names in its folder. */
export type PaperFiles = Record<string, Uint8Array<ArrayBuffer>>;

/** The text files of a folder, named as its paper names them: from the folder with `paper.toml`. */
export async function paperFiles(given: Iterable<File>): Promise<PaperFiles | undefined> {
  const all = [...given].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
  const head = all.find(({ path }) => /(^|\/)paper\.toml$/.test(path));
  if (!head) return undefined;
  const folder = head.path.slice(0, -"paper.toml".length);
  const files: PaperFiles = {};
  for (const { path, file } of all) {
    if (!path.startsWith(folder) || !path.endsWith(".toml")) continue;
    files[path.slice(folder.length)] = new Uint8Array(await file.arrayBuffer());
  }
  return files;
}

/** Decides the claims of a paper and shows them in their order. Ends when `asker` is stopped. */
export async function verifyPaper(place: HTMLElement, asker: Asker, files: PaperFiles): Promise<void> {
  const listed = Object.entries(files).map(([name, bytes]) => [name, bytes.length]);
  const { value: paper } = await asker.ask<ReadPaper>("paper", { do: "paper", files: listed }, bodyOf({ name: "", text: "", files }));
  const progress = make("progress", { max: String(paper.claims.length), value: "0", "aria-label": "Claims decided" });
  const tally = make("p", { class: "note", role: "status" });
  const rows = make("tbody");
  const head = make("tr", {}, ...["Where", "Claim", "Verdict", "Should read"].map((title) => make("th", { scope: "col" }, title)));
  const keep = make("button", { type: "button", disabled: "" }, "JSON of all verdicts");
  const table = make("div", { class: "scrolled", tabindex: "0" }, make("table", { class: "claims" }, make("thead", {}, head), rows));
  place.replaceChildren(make("article", { class: "card" }, make("h2", {}, paper.title || paper.id), progress, tally, table, make("div", { class: "bar" }, keep)));
  const counts = new Map<string, number>();
  const lines: string[] = [];
  for (const [number, id] of paper.claims.entries()) {
    try {
      const { value, body } = await asker.ask<DecidedClaim>("claim", { do: "claim", number });
      lines.push(new TextDecoder().decode(body).trimEnd());
      counts.set(value.label, (counts.get(value.label) ?? 0) + 1);
      rows.append(row(value));
    } catch (error) {
      if (error instanceof GivenUp) {
        tally.textContent += " Stopped.";
        return;
      }
      rows.append(make("tr", {}, make("td", {}), make("td", {}, make("code", {}, id)), make("td", { colspan: "2" }, error instanceof Error ? error.message : String(error))));
      // A module that was ended holds no paper any more.
      await asker.ask("paper", { do: "paper", files: listed }, bodyOf({ name: "", text: "", files }));
    }
    progress.value = number + 1;
    tally.textContent = `${number + 1} of ${paper.claims.length}: ${[...counts].map(([label, count]) => `${count} ${label}`).join(", ")}.`;
  }
  const { body } = await asker.ask("verdicts", { do: "verdicts" }, new TextEncoder().encode(lines.join("\n")) as Uint8Array<ArrayBuffer>);
  keep.disabled = false;
  keep.addEventListener("click", () => download(`${paper.id}-verdicts.json`, body));
}

function row(claim: DecidedClaim): HTMLElement {
  const verdict = make("td", { class: `word word-${claim.verdict}` }, `${VERDICTS[claim.verdict]?.sign ?? "·"} ${claim.label}`);
  const name = claim.id.replace(/^[^/]*\//, "");
  return make("tr", {}, make("td", {}, claim.at), make("td", {}, make("code", {}, name)), verdict, make("td", {}, ...(claim.corrected ? [make("code", {}, claim.corrected)] : [])));
}

/** Lists the papers of a served folder, and calls with the files of the chosen one: when it is chosen, and when one of them changes. */
export function watchPapers(folder: ServedFolder, verify: (files: PaperFiles) => void): void {
  const select = byId<HTMLSelectElement>("folder-paper");
  const read = async () => {
    if (select.value === "") return;
    // The folder itself has no path; `./` stands for it.
    const path = select.value === "./" ? "" : select.value;
    try {
      verify(await folder.paper(path));
    } catch (error) {
      say(error instanceof Error ? error.message : String(error));
    }
  };
  select.addEventListener("change", () => void read());
  folder.watch((changed) => {
    const chosen = select.value;
    const papers = folder.papers.map((path) => make("option", { value: path || "./" }, path || folder.name));
    select.replaceChildren(make("option", { value: "" }, "choose…"), ...papers);
    select.value = chosen;
    const before = chosen === "./" ? "" : `${chosen}/`;
    if (chosen !== "" && [...changed].some((path) => path.startsWith(before) && path.endsWith(".toml"))) void read();
  });
}
