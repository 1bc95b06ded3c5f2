#!/usr/bin/env python3
"""Looks at the pages that `torse report` writes, in two widths of the window and both colour schemes.

    NODE_PATH=.../node_modules python3 tests/browser/looks.py reports/*.html

Nothing may be logged as an error, no two texts may lie upon each other, none may be cut at the side of the window, and
axe-core, if it is installed (`npm install axe-core`), may find nothing against the rules of accessibility. A page is
looked at as it opens, and once more with its first moving figure open. Without Chromium nothing is tested, without axe-core
less, and either is said.
"""

import pathlib
import sys

import chromium

# The boxes of what is not near the window are otherwise not worked out.
WHOLE = "<style>article, .sides { content-visibility: visible !important; }</style>"

LOOK = """<script>
addEventListener("load", async () => {
  const pause = (time) => new Promise((done) => setTimeout(done, time));
  const all = (rule) => [...document.querySelectorAll(rule)];
  // Boxes of the lines of every text that is seen; of a formula the box of the whole.
  const lines = () => {
    const boxes = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    // What is scrolled out of its frame is not seen; frames of parents are worked out once.
    const known = new Map([[document.body, [-Infinity, Infinity]]]);
    const frame = (part) => {
      if (!known.has(part)) {
        let [least, most] = frame(part.parentElement);
        if (getComputedStyle(part).overflowX !== "visible") {
          const { left, right } = part.getBoundingClientRect();
          [least, most] = [Math.max(least, left), Math.min(most, right)];
        }
        known.set(part, [least, most]);
      }
      return known.get(part);
    };
    const add = (node, rects, words) => {
      const [least, most] = frame(node.parentElement);
      for (const { left, right, top, bottom } of rects) {
        const box = { node, left: Math.max(left, least), right: Math.min(right, most), top, bottom, words };
        if (box.right - box.left > 2 && bottom - top > 2) boxes.push(box);
      }
    };
    while (walker.nextNode()) {
      const node = walker.currentNode, parent = node.parentElement;
      if (!node.textContent.trim() || !parent.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      if (parent.closest("math, svg, script, style, .skip, .tools")) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      add(node, range.getClientRects(), node.textContent.trim().slice(0, 30));
    }
    for (const math of all("math")) if (math.checkVisibility()) add(math, [math.getBoundingClientRect()], math.textContent.slice(0, 30));
    return boxes;
  };
  // A third of the height of the lower line must be free: accents and brackets may touch.
  const look = () => {
    const boxes = lines().sort((a, b) => a.top - b.top), over = [];
    boxes.forEach((a, k) => {
      for (let j = k + 1; j < boxes.length && boxes[j].top < a.bottom; j += 1) {
        const b = boxes[j];
        const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left), high = a.bottom - b.top;
        const least = Math.min(a.bottom - a.top, b.bottom - b.top);
        if (a.node !== b.node && wide > 3 && high > 0.66 * least) over.push(`${a.words} | ${b.words}`);
      }
    });
    const cut = boxes.filter((box) => box.right > innerWidth + 1).map(({ words }) => words);
    return { over, cut, wide: document.documentElement.scrollWidth - innerWidth };
  };
  const rules = async () => {
    if (!window.axe) return [];
    const { violations } = await axe.run(document, { resultTypes: ["violations"] });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.length} (${nodes[0].target})`);
  };
  try {
    await pause(100);
    seen.dark = matchMedia("(prefers-color-scheme: dark)").matches;
    seen.states = [{ state: "as it opens", ...look(), rules: await rules() }];
    const openAll = document.getElementById("open-all");
    if (openAll) {
      openAll.click();
      for (let tries = 0; document.querySelector("[data-inside]") && tries < 200; tries += 1) await pause(50);
      const figures = all("details.torse"), first = figures[0] || all("details.moving")[0];
      if (first) {
        for (let part = first; part; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
        await pause(300);
      }
      // All claims are open now: texts are compared in all of them, the rules of accessibility in one.
      const whole = look();
      const kept = first && first.closest("article");
      for (const details of all("article details")) if (!kept || !kept.contains(details)) details.open = false;
      await pause(100);
      seen.states.push({ state: "with all claims open", ...whole, rules: await rules() });
    }
  } catch (error) { seen.errors.push(String(error.stack || error)); }
""" + chromium.TELL + """
});
</script>"""


def faults(seen, scheme):
    """What is wrong with what was seen, in words."""
    if seen is None:
        return ["the page did not finish"]
    wrong = [f"error: {message}" for message in seen["errors"]]
    if seen.get("dark") != (scheme == "dark"):
        wrong.append("the colour scheme is another one")
    for state in seen.get("states", []):
        for what, words in (("over", "texts lie upon each other"), ("cut", "texts are cut"), ("rules", "rules of accessibility are broken")):
            if state[what]:
                wrong.append(f"{state['state']}: {len(state[what])} {words}: {state[what][:3]}")
        if state["wide"] > 0:
            wrong.append(f"{state['state']}: the page is {state['wide']} pixels wider than the window")
    return wrong


def main():
    browser = chromium.found()
    if browser is None:
        return 0
    pages = [pathlib.Path(name) for name in sys.argv[1:]]
    if not pages:
        print(__doc__)
        return 2
    axe = chromium.module("axe-core/axe.min.js")
    if axe is None:
        print("notice: axe-core is not installed, the rules of accessibility are not tested")
    script = f"<script>{axe.read_text(encoding='utf-8')}</script>" if axe else ""
    failed = False
    for page in pages:
        for width in chromium.WIDTHS:
            for scheme in chromium.SCHEMES:
                wrong = faults(chromium.run(browser, page, width, WHOLE + script + LOOK, scheme), scheme)
                failed = failed or bool(wrong)
                print(f"{page.name} at {width}, {scheme}: " + ("; ".join(wrong) or "fine"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
