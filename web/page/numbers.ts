// The numbers of a design's text that have a slider: those of [let] and [sheet], shape parameters, parts and ranges, and
// the number at the caret.

/** A number in a text. */
export interface NumberPlace {
  /** What it is, unique in the text. */
  name: string;
  /** Where it stands. */
  from: number;
  to: number;
  value: number;
  /** A slider goes from the one to the other. */
  low: number;
  high: number;
  step: number;
}

const NUMBER = /(?<![\w"'.+-])[+-]?(?:\d[\d_]*)(?:\.\d+)?(?:[eE][+-]?\d+)?(?![\w"'.])/g;
/** Arrays of numbers with names of their own, and their bounds. */
const ARRAYS: Record<string, { names: string[]; low: number; high: number }> = {
  shape: { names: ["μ", "ν"], low: -1, high: 1 },
  part: { names: ["from", "to"], low: 0, high: 1 },
  tension: { names: ["k₁", "k₂"], low: 0.1, high: 4 },
};

/** The line without its comment; a `#` in quotes is none. */
function code(line: string): string {
  const found = /^(?:[^#"']|"(?:[^"\\]|\\.)*"|'[^']*')*/.exec(line);
  return found ? found[0] : line;
}

/** A slider around a value: from half of it to one and a half, in steps that look tidy. */
function around(value: number): { low: number; high: number; step: number } {
  const size = Math.abs(value) || 1;
  const step = 10 ** Math.floor(Math.log10(size) - 1.7);
  const low = Math.floor((value - 0.6 * size) / step) * step;
  const high = Math.ceil((value + 0.6 * size) / step) * step;
  return { low: tidy(low), high: tidy(high), step: tidy(step) };
}

/** The same with spaces for what is in quotes. */
function withoutStrings(line: string): string {
  return line.replace(/"(?:[^"\\]|\\.)*"|'[^']*'/g, (quoted) => " ".repeat(quoted.length));
}

function place(name: string, text: string, from: number, bounds?: { low: number; high: number }): NumberPlace {
  const value = Number(text.replaceAll("_", ""));
  const range = bounds ? { ...bounds, step: (bounds.high - bounds.low) / 200 } : around(value);
  return { name, from, to: from + text.length, value, ...range };
}

/** Finds the numbers that have a slider. */
export function numbersOf(text: string): NumberPlace[] {
  const found: NumberPlace[] = [];
  let section = "";
  let start = 0;
  for (const whole of text.split("\n")) {
    const line = code(whole);
    const header = /^\s*\[+\s*([A-Za-z_"'][\w.\s"'-]*)\]+\s*$/.exec(line);
    const entry = /^\s*([\w."'-]+)\s*=\s*/.exec(line);
    if (header) {
      section = header[1]?.trim() ?? "";
    } else if (entry && /^(let|sheet)$/.test(section)) {
      const rest = line.slice(entry[0].length);
      const number = /^[+-]?\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?\s*$/.exec(rest);
      if (number) found.push(place(entry[1] ?? "", number[0].trim(), start + entry[0].length));
    }
    for (const array of withoutStrings(line).matchAll(/\b(shape|part|tension)\s*=\s*\[([^[\]]*)\]/g)) {
      const known = ARRAYS[array[1] ?? ""];
      if (!known) continue;
      // The name of an entry on a line of its own, as in `first = { gbt = …, shape = … }`.
      const of = entry && entry[1] !== array[1] ? entry[1] : section.split(".").pop();
      const begin = (array.index ?? 0) + array[0].indexOf("[");
      for (const [k, number] of [...array[0].slice(array[0].indexOf("[")).matchAll(NUMBER)].entries()) {
        const name = `${of} ${array[1]} ${known.names[k] ?? k + 1}`;
        const same = found.filter((other) => other.name === name || other.name.startsWith(`${name} (`)).length;
        found.push(place(same > 0 ? `${name} (${same + 1})` : name, number[0], start + begin + (number.index ?? 0), known));
      }
    }
    start += whole.length + 1;
  }
  return found;
}

/** The number at a place of the text, if it is not in a comment. */
export function numberAt(text: string, caret: number): NumberPlace | undefined {
  const start = text.lastIndexOf("\n", caret - 1) + 1;
  const end = text.indexOf("\n", caret);
  const line = code(text.slice(start, end < 0 ? text.length : end));
  for (const number of line.matchAll(NUMBER)) {
    const from = start + (number.index ?? 0);
    const to = from + number[0].length;
    const row = text.slice(0, from).split("\n").length;
    if (from <= caret && caret <= to) return place(`line ${row}`, number[0], from);
  }
  return undefined;
}

/** The text with another number in its place. */
export function withNumber(text: string, at: NumberPlace, value: number): string {
  return text.slice(0, at.from) + String(tidy(value)) + text.slice(at.to);
}

/** The value without digits that only rounding has made. */
export function tidy(value: number): number {
  return Number(value.toPrecision(10));
}
