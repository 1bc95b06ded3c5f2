// Small words for the document.

/** The element with this id, which the page has. */
export function byId<T extends Element = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as Element as T;
}

/** Makes an element with text or children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Makes an element of SVG. */
export function makeSvg(tag: string, attributes: Record<string, string>, text = ""): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.textContent = text;
  return element;
}

/** Runs the last of several calls once they have stopped for so many milliseconds. */
export function settled(milliseconds: number, job: () => void): { later(): void; now(): void; never(): void } {
  let timer: number | undefined;
  const never = () => {
    window.clearTimeout(timer);
    timer = undefined;
  };
  return {
    never,
    later() {
      never();
      timer = window.setTimeout(job, milliseconds);
    },
    now() {
      never();
      job();
    },
  };
}

/** Offers bytes as a file. */
export function download(name: string, bytes: BlobPart): void {
  const url = URL.createObjectURL(new Blob([bytes]));
  const link = make("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const hush = settled(9000, () => say(""));

/** Says something that has happened, to the eye for a while and to screen readers. */
export function say(text: string): void {
  const place = byId("said");
  place.textContent = text;
  place.hidden = text === "";
  if (text !== "") hush.later();
}
