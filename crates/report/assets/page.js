// Opens the claims; filter, search, keyboard and theme.
"use strict";
(() => {
  const byId = (id) => document.getElementById(id);
  const claims = [...document.querySelectorAll("article[data-verdict]")];
  const texts = new Map(claims.map((claim) => [claim, claim.textContent.toLowerCase()]));
  const sections = [...document.querySelectorAll("section[data-section]")];
  const chips = [...document.querySelectorAll(".chip")];
  const search = byId("search"), kind = byId("kind"), section = byId("section");

  // The insides of the claims and of the notation: a list in JSON, packed.
  const insides = (async () => {
    const bytes = Uint8Array.from(atob(byId("packed").textContent), (sign) => sign.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return JSON.parse(await new Response(stream).text());
  })();

  // What is packed, with the number of its inside, which the element loses when it is filled.
  const packed = new Map([...document.querySelectorAll("[data-inside]")].map((details) => [details, details.dataset.inside]));

  // Puts the inside into its place, once.
  function fill(details, list) {
    if (details.dataset.inside === undefined) return;
    details.insertAdjacentHTML("beforeend", list[details.dataset.inside]);
    delete details.dataset.inside;
  }
  document.addEventListener("toggle", async ({ target }) => {
    if (target.open && target.dataset.inside !== undefined) fill(target, await insides);
  }, true);

  // Readers search what they have not opened, too. Its words are gathered when somebody searches: they are many.
  let gathered;
  const gather = () => {
    gathered ??= insides.then((list) => {
      for (const claim of claims) {
        const inside = list[packed.get(claim.querySelector("details"))];
        const words = inside.replace(/<(script|svg).*?<\/\1>/gs, " ").replace(/<[^>]*>/g, " ");
        texts.set(claim, `${texts.get(claim)} ${words.toLowerCase()}`);
      }
      filter();
    });
  };

  const visible = () => claims.filter((claim) => !claim.hidden);

  // No verdict pressed means: every one. The state stands in the address, so that it can be sent.
  const pressed = () => chips.filter((chip) => chip.getAttribute("aria-pressed") === "true").map((chip) => chip.value);
  const press = (chip, on) => chip.setAttribute("aria-pressed", String(on));

  // Marks the words where they stand, as far as they are shown.
  function mark(words) {
    if (!globalThis.Highlight) return;
    const ranges = [];
    for (const claim of words.length ? visible() : []) {
      const walker = document.createTreeWalker(claim, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) {
        const node = walker.currentNode, text = node.data.toLowerCase();
        for (const word of words) {
          for (let at = text.indexOf(word); at >= 0 && ranges.length < 2000; at = text.indexOf(word, at + word.length)) {
            const range = new Range();
            range.setStart(node, at);
            range.setEnd(node, at + word.length);
            ranges.push(range);
          }
        }
      }
    }
    CSS.highlights.set("found", new Highlight(...ranges));
  }

  function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length) gather();
    const verdicts = pressed();
    for (const claim of claims) {
      claim.hidden = !((!verdicts.length || verdicts.includes(claim.dataset.verdict))
        && (!kind.value || claim.dataset.kind === kind.value)
        && (!section.value || claim.dataset.section === section.value)
        && words.every((word) => texts.get(claim).includes(word)));
    }
    for (const part of sections) part.hidden = !part.querySelector("article:not([hidden])");
    const count = visible().length;
    byId("shown").textContent = `${count} of ${claims.length}`;
    byId("nothing").hidden = count > 0;
    mark(words);
  }

  function remember() {
    const state = new URLSearchParams();
    if (search.value) state.set("q", search.value);
    if (pressed().length) state.set("v", pressed().join(","));
    if (kind.value) state.set("kind", kind.value);
    if (section.value) state.set("section", section.value);
    const query = state.toString();
    try { history.replaceState(null, "", (query ? "?" + query : location.pathname) + location.hash); } catch { /* an address that may not change */ }
  }

  function recall() {
    const state = new URLSearchParams(location.search);
    search.value = state.get("q") || "";
    const verdicts = (state.get("v") || "").split(",");
    for (const chip of chips) press(chip, verdicts.includes(chip.value));
    kind.value = state.get("kind") || "";
    section.value = state.get("section") || "";
  }

  function changed() { filter(); remember(); }

  function reset() {
    search.value = kind.value = section.value = "";
    for (const chip of chips) press(chip, false);
    changed();
  }

  // A link to a claim shows and opens it, whatever the filter hides.
  async function reveal() {
    const name = decodeURIComponent(location.hash.slice(1));
    if (!name) return;
    if (!byId(name)) {
      const list = await insides;
      const inside = list.findIndex((html) => html.includes(`id="${name}"`));
      const details = document.querySelector(`details[data-inside="${inside}"]`);
      if (details) fill(details, list);
    }
    const target = byId(name);
    if (!target) return;
    const own = target.querySelector(":scope > details");
    if (own) fill(own, await insides);
    if (target.closest("[hidden]")) reset();
    for (let part = target.querySelector(":scope > details") || target; part; part = part.parentElement) {
      if (part.tagName === "DETAILS") part.open = true;
    }
    target.scrollIntoView();
  }

  function step(direction) {
    const shown = visible();
    if (!shown.length) return;
    const here = shown.indexOf(document.activeElement.closest("article"));
    const next = here < 0 ? (direction > 0 ? 0 : shown.length - 1) : here + direction;
    const claim = shown[Math.max(0, Math.min(shown.length - 1, next))];
    claim.querySelector("details").open = true;
    claim.focus({ preventScroll: true });
    claim.scrollIntoView({ block: "start" });
  }

  for (const field of [search, kind, section]) field.addEventListener("input", changed);
  for (const chip of chips) {
    // A click shows this verdict alone, with the shift key this one besides.
    chip.addEventListener("click", (event) => {
      const on = chip.getAttribute("aria-pressed") !== "true";
      const alone = on || pressed().length > 1;
      for (const other of chips) if (!event.shiftKey && other !== chip) press(other, false);
      press(chip, event.shiftKey ? on : alone);
      changed();
    });
  }
  byId("reset").addEventListener("click", reset);
  byId("all").addEventListener("click", reset);
  byId("open-all").addEventListener("click", (event) => {
    const open = event.currentTarget.getAttribute("aria-pressed") !== "true";
    event.currentTarget.setAttribute("aria-pressed", String(open));
    for (const details of packed.keys()) details.open = open;
  });
  byId("theme").addEventListener("click", () => {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName);
    if (event.key === "Escape" && typing) { search.value = ""; changed(); event.target.blur(); }
    else if (typing) return;
    else if (event.key === "/") { event.preventDefault(); search.focus(); }
    else if (event.key === "j") step(1);
    else if (event.key === "k") step(-1);
  });
  // Of the drawing, the claims that one rests on and those that rest on it, near and far.
  for (const graph of document.querySelectorAll(".graph")) {
    const lines = [...graph.querySelectorAll("path")], nodes = [...graph.querySelectorAll("a")];
    const reach = (start, from, to) => {
      const found = new Set([start]);
      for (const name of found) for (const line of lines) if (line.dataset[from] === name) found.add(line.dataset[to]);
      return found;
    };
    const show = (name) => {
      graph.classList.toggle("one", !!name);
      if (!name) return;
      const below = reach(name, "b", "a"), above = reach(name, "a", "b");
      for (const node of nodes) node.classList.toggle("near", below.has(node.dataset.claim) || above.has(node.dataset.claim));
      for (const line of lines) {
        const { a, b } = line.dataset;
        line.classList.toggle("near", (below.has(a) && below.has(b)) || (above.has(a) && above.has(b)));
      }
    };
    for (const node of nodes) {
      for (const event of ["pointerenter", "focus"]) node.addEventListener(event, () => show(node.dataset.claim));
      for (const event of ["pointerleave", "blur"]) node.addEventListener(event, () => show(null));
    }
  }
  // What a word means is told where it is pointed at.
  const meanings = JSON.parse(byId("meanings").textContent);
  document.addEventListener("pointerover", ({ target }) => {
    const word = target.closest("[data-word]");
    if (word && !word.title) word.title = meanings[word.dataset.word] || "";
  });
  addEventListener("hashchange", reveal);
  byId("tools").hidden = false;
  recall();
  filter();
  reveal();
})();
