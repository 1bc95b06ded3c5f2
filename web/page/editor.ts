// The text of a design with numbers of its lines and marks under what is wrong.

import { make } from "./dom.ts";
import type { Message } from "./modules.ts";

/** A text field with line numbers beside it and marks behind it. */
export class Editor {
  private readonly behind: HTMLElement;
  private readonly numbers: HTMLElement;

  constructor(
    readonly field: HTMLTextAreaElement,
    frame: HTMLElement,
    private readonly list: HTMLElement,
  ) {
    this.numbers = make("div", { class: "line-numbers", "aria-hidden": "true" });
    this.behind = make("pre", { class: "marks-behind", "aria-hidden": "true" });
    frame.prepend(this.numbers, this.behind);
    field.addEventListener("scroll", () => this.scrolled());
  }

  get text(): string {
    return this.field.value;
  }

  set text(text: string) {
    if (this.field.value === text) return;
    const { selectionStart, scrollTop, scrollLeft } = this.field;
    this.field.value = text;
    const caret = Math.min(selectionStart, text.length);
    this.field.setSelectionRange(caret, caret);
    this.field.scrollTo(scrollLeft, scrollTop);
  }

  /** Shows what is wrong: at its lines, and as a list of which each entry leads to its place. */
  show(messages: Message[]): void {
    const lines = this.text.split("\n");
    const placed = messages.filter((m) => m.line !== null && m.line <= lines.length);
    const wrong = new Set(placed.map((m) => m.line));
    this.numbers.replaceChildren(
      ...lines.map((_, k) => make("span", wrong.has(k + 1) ? { class: "wrong" } : {}, String(k + 1))),
    );
    const pieces: (Node | string)[] = [];
    let done = 0;
    for (const { from, to } of placed.map((m) => this.range(m)).sort((a, b) => a.from - b.from)) {
      if (from < done) continue;
      pieces.push(this.text.slice(done, from), make("mark", {}, this.text.slice(from, to)));
      done = to;
    }
    pieces.push(this.text.slice(done), "\n");
    this.behind.replaceChildren(...pieces);
    this.list.replaceChildren(...messages.map((message) => this.entry(message)));
    this.list.hidden = messages.length === 0;
    this.field.setAttribute("aria-invalid", String(messages.length > 0));
    this.scrolled();
  }

  private entry(message: Message): HTMLElement {
    const words = message.hint ? `${message.text} (${message.hint})` : message.text;
    if (message.line === null) return make("li", {}, words);
    const button = make("button", { type: "button" }, `line ${message.line}: ${words}`);
    button.addEventListener("click", () => {
      const { from, to } = this.range(message);
      this.field.focus();
      this.field.setSelectionRange(from, to);
      const height = Number.parseFloat(getComputedStyle(this.field).lineHeight);
      this.field.scrollTop = Math.max(0, ((message.line ?? 1) - 4) * height);
    });
    return make("li", {}, button);
  }

  /** Columns count characters, and places in the field count 16-bit units; lengths are bytes. */
  private range(message: Message): { from: number; to: number } {
    const lines = this.text.split("\n");
    const before = lines.slice(0, (message.line ?? 1) - 1).join("\n").length;
    const start = before + ((message.line ?? 1) > 1 ? 1 : 0);
    const line = lines[(message.line ?? 1) - 1] ?? "";
    const letters = [...line];
    const from = start + letters.slice(0, (message.column ?? 1) - 1).join("").length;
    const rest = this.text.slice(from);
    const wrong = new TextDecoder().decode(new TextEncoder().encode(rest).slice(0, Math.max(1, message.length)));
    return { from, to: Math.min(from + wrong.length, this.text.length) };
  }

  private scrolled(): void {
    const { scrollTop, scrollLeft } = this.field;
    this.numbers.style.transform = `translateY(${-scrollTop}px)`;
    this.behind.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
  }
}
