#!/usr/bin/env python3
"""Compares the developables of report pages with the geometry room, in a headless Chromium.

    cargo run -p torse-tests --example torses > target/torses.json
    python3 tests/browser/torses.py target/torses.json reports/*.html

The page's own script evaluates and unrolls each figure at the slider states of the file; rulings, edges of regression
and flat patterns may differ by a millionth of the size of the sheet. Flat patterns are first laid with their first
ruling along the first axis and the next ones above it, for a pattern may be turned. Without Chromium nothing is
tested, which is said.
"""

import json
import pathlib
import sys

import check
import chromium

TOLERANCE = 1e-6

COMPARE = """<script>
addEventListener("load", async () => {
  const seen = { errors: [], figures: {} };
  const reference = JSON.parse(document.getElementById("reference").textContent);
  const away = (a, b) => Math.hypot(...a.map((c, k) => c - b[k]));
  const between = ([p, q], share) => p.map((c, k) => c + share * (q[k] - c));
  // The pattern with its first ruling along the first axis and the middle of the next one above it.
  const laid = (rulings) => {
    const [[p, q], next] = rulings, size = away(p, q), way = [(q[0] - p[0]) / size, (q[1] - p[1]) / size];
    const turned = ([x, y]) => [way[0] * (x - p[0]) + way[1] * (y - p[1]), way[0] * (y - p[1]) - way[1] * (x - p[0])];
    const side = Math.sign(turned(between(next, 0.5))[1]) || 1;
    return rulings.map((ends) => ends.map((end) => { const [x, y] = turned(end); return [x, side * y]; }));
  };
  try {
    document.getElementById("open-all").click();
    for (let tries = 0; document.querySelector("[data-inside]") && tries < 100; tries += 1) await new Promise((done) => setTimeout(done, 50));
    for (const details of document.querySelectorAll("details.torse")) {
      const states = reference[details.dataset.name];
      if (!states) continue;
      for (let part = details; part; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
      for (let tries = 0; !details.torse && tries < 50; tries += 1) await new Promise((done) => setTimeout(done, 20));
      const worst = { states: states.length, ends: 0, edge: 0, edges: 0, flat: 0, flats: 0 };
      for (const { values, pieces } of states) {
        const found = details.torse.state(values);
        pieces.forEach(({ share, rulings }, number) => {
          const { stations } = found[number], step = (stations.length - 1) / (rulings.length - 1);
          const here = rulings.map((_, k) => stations[k * step]);
          const size = Math.max(...rulings.map(({ ends }) => Math.max(away(...ends), away(ends[0], rulings[0].ends[0]))));
          const worse = (what, distance) => { worst[what] = Math.max(worst[what], Number.isFinite(distance) ? distance / size : Infinity); };
          rulings.forEach(({ x, ends, edge }, k) => {
            if (Math.abs(here[k].x - x) > 1e-12) throw new Error("another ruling");
            ends.forEach((end, j) => worse("ends", away(end, here[k].ends[j])));
            if (edge) { worse("edge", away(edge, here[k].edge)); worst.edges += 1; }
          });
          if (!rulings.every(({ flat }) => flat)) return;
          const flats = here.map((one) => share.map((s) => details.torse.flat(one, s)));
          laid(flats).forEach((ends, k) => ends.forEach((end, j) => worse("flat", away(end, laid(rulings.map(({ flat }) => flat))[k][j]))));
          worst.flats += 1;
        });
      }
      seen.figures[details.dataset.name] = worst;
    }
  } catch (error) { seen.errors.push(String(error.stack || error)); }
""" + chromium.TELL + """
});
</script>"""


def main():
    browser = chromium.found()
    if browser is None:
        return 0
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    reference = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    missing, failed = set(reference), False
    for name in sys.argv[2:]:
        page = pathlib.Path(name)
        text = page.read_text(encoding="utf-8")
        here = {figure: states for figure, states in reference.items() if f'data-name="{figure}"' in check.unpacked(text)}
        if not here:
            continue
        data = f'<script type="application/json" id="reference">{json.dumps(here)}</script>'
        seen = chromium.run(browser, page, 1280, data + COMPARE, first="")
        seen = seen or {"errors": ["the page did not finish"], "figures": {}}
        for error in seen["errors"]:
            failed = True
            print(f"{page.name}: {error}")
        for figure, worst in seen["figures"].items():
            missing.discard(figure)
            wrong = [what for what in ("ends", "edge", "flat") if not worst[what] <= TOLERANCE]
            failed = failed or bool(wrong)
            told = ", ".join(f"{what} {worst[what]:.1e}" for what in ("ends", "edge", "flat"))
            print(f"{figure}: {'WRONG ' + ' '.join(wrong) if wrong else 'fine'}, {worst['states']} states, {worst['edges']} edge points, {worst['flats']} patterns: {told}")
    for figure in sorted(missing):
        failed = True
        print(f"{figure}: no page has it")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
