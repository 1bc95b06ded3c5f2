#!/usr/bin/env python3
"""Opens the pages that `torse report` writes in a headless Chromium and uses them.

    python3 tests/browser/check.py reports/*.html

Each page is copied, with a script at its end that filters, searches and moves sliders and writes down what it
saw; the browser runs it and hands back the page. A page passes if nothing was logged as an error, the filter hides
what it should, and a slider, a turn and a key change the picture, and putting back restores it. Without Chromium
nothing is tested, which is said; nothing but Python is needed.
"""

import base64
import html
import json
import pathlib
import re
import sys
import zlib

import chromium

LAST = """<script>
addEventListener("load", async () => {
  const frame = () => new Promise((done) => setTimeout(done, 60));
  const all = (rule) => [...document.querySelectorAll(rule)];
  const shown = () => all("article[data-verdict]").filter((claim) => !claim.hidden);
  try {
    seen.claims = shown().length;
    const chip = document.querySelector(".chip");
    chip.click();
    seen.alone = { verdict: chip.value, left: shown().length, wrong: shown().filter((claim) => claim.dataset.verdict !== chip.value).length };
    seen.address = location.search;
    document.getElementById("reset").click();
    seen.again = shown().length;
    const kind = document.getElementById("kind");
    kind.selectedIndex = 1;
    kind.dispatchEvent(new Event("input"));
    seen.kind = { left: shown().length, wrong: shown().filter((claim) => claim.dataset.kind !== kind.value).length };
    document.getElementById("reset").click();
    const section = document.getElementById("section");
    section.selectedIndex = section.options.length - 1;
    section.dispatchEvent(new Event("input"));
    seen.section = { left: shown().length, wrong: shown().filter((claim) => claim.dataset.section !== section.value).length };
    document.getElementById("reset").click();
    // The words of an opened claim are found like those of the others.
    const opened = shown()[0], details = opened.querySelector("details");
    details.open = true;
    for (let tries = 0; details.dataset.inside && tries < 20; tries += 1) await frame();
    const within = details.querySelector("dl").innerHTML.replace(/<[^>]*>/g, " ").trim().split(/\s+/).slice(-3).join(" ");
    const search = document.getElementById("search");
    search.value = opened.querySelector("h3").textContent;
    search.dispatchEvent(new Event("input"));
    seen.search = shown().length;
    search.value = within;
    search.dispatchEvent(new Event("input"));
    for (let tries = 0; opened.hidden && tries < 20; tries += 1) await frame();
    seen.within = !opened.hidden;
    search.value = "no claim has these words";
    search.dispatchEvent(new Event("input"));
    seen.none = { left: shown().length, told: !document.getElementById("nothing").hidden };
    document.getElementById("all").click();
    seen.after = shown().length;
    const last = shown().at(-1);
    location.hash = last.id;
    await frame();
    await frame();
    const middle = shown()[shown().length >> 1];
    location.hash = middle.id;
    await frame();
    await frame();
    seen.under = document.getElementById("tools").getBoundingClientRect().bottom - middle.querySelector("h3").getBoundingClientRect().top;
    seen.opened = last.querySelector("details").open && Boolean(last.querySelector("dl"));
    const cut = (box) => box.scrollWidth - box.clientWidth;
    // A fraction that is wider than the window is scrolled; everything else is broken.
    const piece = (box) => [...box.children].some((part) => part.getBoundingClientRect().width + 26 > box.clientWidth);
    seen.cut = all("#in-short .math, #corrections .math").filter((box) => cut(box) > 1 && !piece(box)).length;
    seen.short = document.querySelectorAll("#in-short li").length;
    seen.wide = document.documentElement.scrollWidth - innerWidth;
    seen.math = all("math").length;
    document.getElementById("open-all").click();
    for (let tries = 0; document.querySelector("[data-inside]") && tries < 100; tries += 1) await frame();
    seen.packed = all("[data-inside]").length;
    seen.moving = [];
    for (const details of all("details.moving")) {
      for (let part = details.parentElement; part; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
      details.open = true;
      await frame();
      await frame();
      const canvas = details.querySelector("canvas"), input = details.querySelector("input");
      const picture = () => canvas.toDataURL();
      const first = picture(), start = input.value;
      input.value = Number(input.value) === Number(input.max) ? input.min : input.max;
      input.dispatchEvent(new Event("input"));
      const slid = picture();
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: canvas.classList.contains("turns") ? "ArrowLeft" : "+", bubbles: true }));
      const turned = picture();
      details.querySelector("button").click();
      seen.moving.push({
        figure: details.closest("figure").id, named: Boolean(canvas.getAttribute("aria-label")), blank: first === document.createElement("canvas").toDataURL(),
        slid: slid !== first, turned: turned !== slid, restored: picture() === first && input.value === start,
      });
      details.open = false;
    }
  } catch (error) { seen.errors.push(String(error.stack || error)); }
""" + chromium.TELL + """
});
</script>"""


# A page without claims, the landing page: it has no script of its own, and its policy allows none.
PLAIN = """<script>
addEventListener("load", () => {
  const maths = [...document.querySelectorAll(".math")];
  seen.cut = maths.filter((box) => box.scrollWidth - box.clientWidth > 1 && getComputedStyle(box).overflowX === "visible").length;
  seen.wide = document.documentElement.scrollWidth - innerWidth;
  seen.math = document.querySelectorAll("math").length;
""" + chromium.TELL + """
});
</script>"""


def unpacked(text):
    """The page with the insides of its claims, which it holds compressed, after what it shows."""
    packed = re.search(r'id="packed">([^<]*)<', text)
    insides = json.loads(zlib.decompress(base64.b64decode(packed.group(1)), -15)) if packed else []
    return text + "".join(insides)


# The most bytes of a page.
BUDGET = 2_000_000

# Mathematics as it is typed, which readers should not see: `mu1`, `x^2`, `Q_{k}`.
TYPED = re.compile(r"\b(mu|nu|pi|sqrt|lambda|gamma)\d*\b|\^|_\{")


def typed(page):
    """Stretches of a page's words, outside of formulas, code and names of claims, that are typed mathematics."""
    text = unpacked(page.read_text(encoding="utf-8"))
    for hidden in ("script", "style", "code", "math", "svg"):
        text = re.sub(rf"<{hidden}\b.*?</{hidden}>", " ", text, flags=re.S)
    # One sentence of the worked example names functions of the language.
    words = html.unescape(re.sub(r"<[^>]*>", " ", text)).replace("sum, binom, factorial, sqrt, sin and cos", "")
    return [words[max(0, found.start() - 20):found.end() + 20] for found in TYPED.finditer(words)]


def absent(page):
    """Files that the page leads to and that do not lie beside it."""
    text = unpacked(page.read_text(encoding="utf-8"))
    files = set(re.findall(r'(?:href|data-step|src)="([^"#:?]+)[#?"]', text))
    return sorted(name for name in files if not (page.parent / html.unescape(name)).is_file())


def faults(seen):
    """What is wrong with what was seen, in words."""
    if seen is None:
        return ["the page did not finish"]
    wrong = [f"error: {message}" for message in seen["errors"]]
    if wrong:
        return wrong
    if seen["cut"]:
        wrong.append(f"{seen['cut']} formulas of the first parts are cut")
    if seen["wide"] > 0:
        wrong.append(f"the page is {seen['wide']} pixels wider than the window")
    if seen["math"] == 0:
        wrong.append("no formulas")
    if "claims" not in seen:
        return wrong
    if seen["claims"] == 0 or seen["again"] != seen["claims"]:
        wrong.append("claims are missing after the filter is reset")
    if seen["alone"]["wrong"] or not seen["alone"]["left"]:
        wrong.append("a verdict that was asked for alone is not")
    if f"v={seen['alone']['verdict']}" not in seen["address"]:
        wrong.append("the address does not say what is shown")
    if seen["none"]["left"] or not seen["none"]["told"] or seen["after"] != seen["claims"]:
        wrong.append("an empty result is not told, or not undone")
    if seen["under"] > 0:
        wrong.append(f"the bar covers {seen['under']:.0f} pixels of a claim that is linked to")
    if not seen["opened"]:
        wrong.append("a link does not open its claim")
    for name in ("kind", "section"):
        if seen[name]["wrong"] or not 0 < seen[name]["left"] <= seen["claims"]:
            wrong.append(f"the filter by {name} shows something else")
    if not 0 < seen["search"] < seen["claims"] and seen["claims"] > 1:
        wrong.append("the search finds nothing or everything")
    if not seen["within"]:
        wrong.append("the search does not find the words of an opened claim")
    if seen["packed"]:
        wrong.append(f"{seen['packed']} claims stay packed")
    for figure in seen["moving"]:
        for what in ("named", "slid", "turned", "restored"):
            if not figure[what]:
                wrong.append(f"{figure['figure']} is not {what}")
        if figure["blank"]:
            wrong.append(f"{figure['figure']} is blank")
    return wrong


def main():
    browser = chromium.found()
    if browser is None:
        return 0
    pages = [pathlib.Path(name) for name in sys.argv[1:]]
    if not pages:
        print(__doc__)
        return 2
    failed = False
    for page in pages:
        if page.stat().st_size > BUDGET:
            failed = True
            print(f"{page.name}: {page.stat().st_size} bytes are more than {BUDGET}")
        missing = absent(page)
        if missing:
            failed = True
            print(f"{page.name}: {len(missing)} links lead to no file beside it: {missing[:3]}")
        found = typed(page)
        if found:
            failed = True
            print(f"{page.name}: {len(found)} stretches of typed mathematics: {found[:3]}")
        last = LAST if chromium.has_script(page.read_text(encoding="utf-8")) else PLAIN
        for width in chromium.WIDTHS:
            seen = chromium.run(browser, page, width, last)
            wrong = faults(seen)
            failed = failed or bool(wrong)
            good = "fine"
            if seen and "claims" in seen:
                good = f"fine, {seen['claims']} claims, {len(seen['moving'])} moving figures"
            print(f"{page.name} at {width}: " + ("; ".join(wrong) or good))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
