// The modules answer what the command answers: the same bytes, over all designs and two hundred statements.
//
// TORSE names the command (target/debug/torse unless it is set), the modules are target/web/*.wasm.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { designs as folder, module, root, torse, verdicts } from "./support.mjs";

const temporary = mkdtempSync(join(tmpdir(), "torse-page-"));
after(() => rmSync(temporary, { recursive: true }));

/** Runs the command among the designs; what it writes to standard output. */
function run(...words) {
  const done = spawnSync(torse, words, { cwd: folder, maxBuffer: 1 << 28 });
  assert.ok([0, 1, 3].includes(done.status), `torse ${words.join(" ")}: ${done.stderr}`);
  return done.stdout;
}

const files = readdirSync(folder).filter((name) => name.endsWith(".toml"));

for (const file of files) {
  const source = { name: file, text: readFileSync(join(folder, file), "utf8"), files: [] };

  test(`${file} is measured as by the command`, async () => {
    const designs = await module("designs");
    const { body } = designs({ do: "measure", source, quick: false });
    assert.ok(Buffer.from(body).equals(run("inspect", file, "--format", "json")));
    const quick = designs({ do: "measure", source, quick: true });
    assert.ok(Buffer.from(quick.body).equals(run("inspect", file, "--quick", "--format", "json")));
  });

  test(`${file} is written as by the command`, async () => {
    const designs = await module("designs");
    for (const ending of ["dxf", "svg", "step", "iges", "3mf", "stl", "glb", "obj", "ply"]) {
      const { head, body } = designs({ do: "export", source, ending });
      const to = join(temporary, `${file}.${ending}`);
      const done = spawnSync(torse, ["export", file, "--to", to], { cwd: folder });
      if (head?.error) {
        assert.notEqual(done.status, 0, `${file}.${ending}: the page alone refuses it: ${head.error.text}`);
        continue;
      }
      assert.equal(done.status, 0, `${done.stderr}`);
      assert.ok(Buffer.from(body).equals(readFileSync(to)), `${file}.${ending}`);
    }
  });

  test(`the parts of ${file} are cut as by the command`, async () => {
    const designs = await module("designs");
    const { head, body } = designs({ do: "parts", source, ending: "dxf", purpose: "cut" });
    const place = mkdtempSync(join(temporary, "parts-"));
    const done = spawnSync(torse, ["unroll", file, "--to", join(place, "part.dxf")], { cwd: folder });
    const made = readdirSync(place).sort();
    if (head.error) {
      assert.deepEqual(made, [], `${head.error.text} ${done.stderr}`);
      return;
    }
    assert.equal(made.length, head.length);
    const texts = new Set(made.map((name) => readFileSync(join(place, name), "utf8")));
    let from = 0;
    for (const [name, length] of head) {
      assert.ok(texts.has(Buffer.from(body.slice(from, from + length)).toString()), name);
      from += length;
    }
  });
}

/** Statements with their settings, right and wrong, and some that cannot be read. */
const STATEMENTS = [
  ["sin(3*x) == 3*sin(x) + 4*sin(x)^3", ""],
  ["(a + b)^2 == a^2 + b^2", ""],
  ["sum(i, 0, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1", "n in 0.."],
  ["x*(1 - x) <= 1/4", "x in [0, 1]"],
  ["x + 1/x >= 2", "x > 0"],
  ["x/x == 1", ""],
  ["D(f(x)*g(x), x) == D(f(x), x)*g(x) + f(x)*D(g(x), x)", "f, g: function 1"],
  ["exp(x + y) == exp(x)*exp(y)", ""],
  ["cross(p, q) == -cross(q, p)", "p, q: vector 3"],
  ["x^2 > 0", "x != 0"],
  ["x + == 1", ""],
  ["x == 1", "x in somewhere"],
];

test("statements are decided as by the command, and refused with the same words", async () => {
  const input = STATEMENTS.map(([states, where]) => JSON.stringify({ states, where })).join("\n");
  const native = spawnSync(torse, ["decide", "-"], { input }).stdout.toString().trimEnd().split("\n");
  assert.equal(native.length, STATEMENTS.length);
  const ask = await module("formulas");
  let refused = 0;
  STATEMENTS.forEach(([statement, setting], k) => {
    const { head, body } = ask({ do: "decide", statement, setting });
    // The command says which line of its input it answers.
    const { number, ...answer } = JSON.parse(native[k]);
    assert.equal(number, k + 1);
    if (head.error) {
      refused += 1;
      assert.equal(answer.error, head.error.text, statement);
      return;
    }
    assert.equal(Buffer.from(body).toString().trimEnd(), JSON.stringify(answer), statement);
  });
  assert.equal(refused, 2);
});

test("the two hundred claims of two papers have the verdicts of the command", async () => {
  const ask = await module("formulas");
  let count = 0;
  for (const paper of ["bezier", "trigonometric"]) {
    const folder = join(root, "derivations", paper);
    const files = readdirSync(folder).filter((name) => name.endsWith(".toml")).map((name) => [name, readFileSync(join(folder, name))]);
    const { head } = ask({ do: "paper", files: files.map(([name, bytes]) => [name, bytes.length]) }, Buffer.concat(files.map(([, bytes]) => bytes)));
    assert.ok(!head.error, head.error?.text);
    const lines = head.claims.map((_, number) => Buffer.from(ask({ do: "claim", number }).body).toString().trimEnd());
    const { body } = ask({ do: "verdicts" }, Buffer.from(lines.join("\n")));
    assert.ok(Buffer.from(body).equals(Buffer.from(verdicts(paper))), paper);
    count += lines.length;
  }
  assert.ok(count >= 200, `${count}`);
});

test("packets that are cut are refused, and the module goes on", async () => {
  const ask = await module("formulas");
  const { head } = ask({ do: "paper", files: [["paper.toml", 100]] }, new Uint8Array(10));
  assert.match(head.error.text, /longer than the packet/);
  assert.ok(ask({ do: "nothing" }).head.error);
  assert.equal(ask({ do: "decide", statement: "x == x", setting: "" }).head.verdict, "holds");
});

test("a statement alone has the JSON of the command", async () => {
  const ask = await module("formulas");
  const statement = "sin(3*x) == 3*sin(x) + 4*sin(x)^3";
  const { head, body } = ask({ do: "decide", statement, setting: "" });
  assert.ok(Buffer.from(body).equals(run("decide", statement, "--format", "json")));
  assert.equal(head.verdict, "misprint");
  assert.match(head.correction.marked[1], /»-«/);
  assert.ok(head.correction.formula.mathml.join("").includes("<math"));
});

test("names that are not declared are told", async () => {
  const ask = await module("formulas");
  const { head } = ask({ do: "read", statement: "a*x^2 >= 0", setting: "x in [0, 1]" });
  assert.deepEqual(head.undeclared, ["a"]);
  assert.ok(head.mathematics.mathml.length > 0);
});

