// The view of formulas: a statement is typed, read while it is typed, and decided when it is asked for.

import { writeAddress } from "./address.ts";
import { showAnswer, type Described } from "./answer.ts";
import { byId, make, say, settled } from "./dom.ts";
import { mathematics, type SetFormula } from "./mathematics.ts";
import { Asker, GivenUp, Refusal, Trapped, unplaced, type Message } from "./modules.ts";
import { type PaperFiles, paperFiles, verifyPaper, watchPapers } from "./paper.ts";
import type { ServedFolder } from "./studio.ts";

/** Statements to begin with: those of the README and of the library. */
const EXAMPLES: { title: string; is: string; where?: string }[] = [
  { title: "Triple angle, with a wrong sign", is: "sin(3*x) == 3*sin(x) + 4*sin(x)^3" },
  { title: "The freshman's dream", is: "(a + b)^2 == a^2 + b^2" },
  { title: "Bernstein polynomials sum to 1, for every degree", is: "sum(i, 0, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1", where: "n in 0.." },
  { title: "A bound", is: "x*(1 - x) <= 1/4", where: "x in [0, 1]" },
  { title: "Means", is: "x + 1/x >= 2", where: "x > 0" },
  { title: "True under a condition", is: "x/x == 1" },
  { title: "Product rule", is: "D(f(x)*g(x), x) == D(f(x), x)*g(x) + f(x)*D(g(x), x)", where: "f, g: function 1" },
];

/** What is proposed for a name that is not declared. */
const PROPOSALS: { title: string; entry(name: string): string }[] = [
  { title: "positive", entry: (name) => `${name} > 0` },
  { title: "not zero", entry: (name) => `${name} != 0` },
  { title: "in [0, 1]", entry: (name) => `${name} in [0, 1]` },
  { title: "in [−1, 1]", entry: (name) => `${name} in [-1, 1]` },
  { title: "a whole number from 0", entry: (name) => `${name} in 0..` },
  { title: "a whole number from 1", entry: (name) => `${name} in 1..` },
];

interface ReadStatement {
  undeclared: string[];
  mathematics: SetFormula | null;
}

/** Starts the view. */
export function startFormulas(served: ServedFolder | undefined): { open(entries: URLSearchParams): void } {
  const statement = byId<HTMLTextAreaElement>("statement");
  const setting = byId<HTMLTextAreaElement>("setting");
  const stop = byId<HTMLButtonElement>("stop");
  const place = byId("answer");
  const reader = new Asker("formulas");
  const prover = new Asker("formulas");
  let asked = "";

  const entries = () => ({ is: statement.value, where: setting.value });
  const address = () => writeAddress("formulas", entries());

  const read = settled(120, async () => {
    try {
      const { value } = await reader.ask<ReadStatement>("read", { do: "read", statement: statement.value, setting: setting.value });
      byId("preview").replaceChildren(...(value.mathematics ? [mathematics(value.mathematics)] : []));
      showNames(value.undeclared);
    } catch (error) {
      if (error instanceof Trapped) showNames([]);
    }
  });

  const changed = () => {
    address();
    showMessages([]);
    place.classList.toggle("old", asked !== "" && asked !== JSON.stringify(entries()));
    read.later();
  };

  function showNames(names: string[]): void {
    const chips = names.map((name) => {
      const choice = make("select", { "aria-label": `What is ${name}?` }, make("option", { value: "" }, "a real number"));
      for (const { title, entry } of PROPOSALS) choice.append(make("option", { value: entry(name) }, title));
      choice.addEventListener("change", () => {
        setting.value = [setting.value.trim().replace(/;$/, ""), choice.value].filter((part) => part !== "").join("; ");
        changed();
        setting.focus();
      });
      return make("span", { class: "chip" }, make("code", {}, name), " is ", choice);
    });
    byId("names").replaceChildren(...(chips.length > 0 ? [make("span", { class: "note" }, "Not declared:"), ...chips] : []));
  }

  function showMessages(messages: Message[]): void {
    const list = byId("statement-messages");
    list.hidden = messages.length === 0;
    statement.setAttribute("aria-invalid", String(messages.length > 0));
    list.replaceChildren(
      ...messages.map((message) => {
        const words = message.hint ? `${message.text} (${message.hint})` : message.text;
        const field = message.file === "the statement" ? statement : message.file === "the setting" ? setting : null;
        if (!field || message.line === null || message.column === null) return make("li", {}, words);
        const button = make("button", { type: "button" }, `${message.file}, column ${message.column}: ${words}`);
        const before = field.value.split("\n").slice(0, message.line - 1).join("\n").length;
        const at = before + (message.line > 1 ? 1 : 0) + message.column - 1;
        button.addEventListener("click", () => {
          field.focus();
          field.setSelectionRange(at, at + Math.max(1, message.length));
        });
        return make("li", {}, button);
      }),
    );
  }

  async function decide(): Promise<void> {
    if (statement.value.trim() === "") return;
    prover.stop();
    asked = JSON.stringify(entries());
    const mine = asked;
    place.setAttribute("aria-busy", "true");
    place.classList.remove("old");
    stop.hidden = false;
    showMessages([]);
    const question = { do: "decide", statement: statement.value, setting: setting.value };
    try {
      const { value, body } = await prover.ask<Described>("decide", question);
      showAnswer(place, value, body);
    } catch (error) {
      if (error instanceof GivenUp) {
        if (mine === asked) place.replaceChildren();
      } else if (error instanceof Refusal) {
        showMessages(error.messages.length > 0 ? error.messages : [unplaced(error.message)]);
        place.replaceChildren();
      } else {
        const reason = error instanceof Error ? error.message : String(error);
        place.replaceChildren(make("div", { class: "card refused", role: "alert" }, make("p", {}, `The prover was ended: ${reason}. Nothing that you typed is lost; it is started again with the next question.`)));
      }
    }
    if (mine === asked) {
      place.setAttribute("aria-busy", "false");
      stop.hidden = true;
    }
  }

  const example = byId<HTMLSelectElement>("example");
  EXAMPLES.forEach(({ title }, k) => example.append(make("option", { value: String(k) }, title)));
  example.addEventListener("change", () => {
    const chosen = EXAMPLES[Number(example.value)];
    if (example.value === "" || !chosen) return;
    statement.value = chosen.is;
    setting.value = chosen.where ?? "";
    example.value = "";
    changed();
    void decide();
  });
  statement.addEventListener("input", changed);
  setting.addEventListener("input", changed);
  byId("ask").addEventListener("submit", (event) => {
    event.preventDefault();
    void decide();
  });
  byId("ask").addEventListener("keydown", (event) => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey || (event.target === statement && !event.shiftKey))) {
      event.preventDefault();
      void decide();
    }
  });
  stop.addEventListener("click", () => prover.stop());
  async function verify(files: PaperFiles): Promise<void> {
    prover.stop();
    asked = "a paper";
    stop.hidden = false;
    showMessages([]);
    place.classList.remove("old");
    try {
      await verifyPaper(place, prover, files);
    } catch (error) {
      if (error instanceof Refusal) showMessages(error.messages.length > 0 ? error.messages : [unplaced(error.message)]);
      else if (!(error instanceof GivenUp)) say(error instanceof Error ? error.message : String(error));
    }
    stop.hidden = true;
  }

  byId("open-paper").addEventListener("click", () => byId("paper").click());
  byId<HTMLInputElement>("paper").addEventListener("change", ({ target }) => {
    const field = target as HTMLInputElement;
    const given = [...(field.files ?? [])];
    field.value = "";
    void paperFiles(given).then((files) => (files ? verify(files) : say("There is no paper.toml in what was opened.")));
  });
  if (served) watchPapers(served, (files) => void verify(files));
  byId("share-formula").addEventListener("click", async () => {
    address();
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    say("The address of the page holds the statement; it was copied.");
  });

  return {
    open(given) {
      if (given.has("is")) {
        statement.value = given.get("is") ?? "";
        setting.value = given.get("where") ?? "";
      } else if (statement.value === "") {
        const first = EXAMPLES[0];
        statement.value = first?.is ?? "";
      }
      changed();
      if (given.has("is")) void decide();
    },
  };
}
