// Filter, search, keyboard and theme. Without this script the page is complete, only not filtered.
"use strict";
(() => {
  const byId = (id) => document.getElementById(id);
  const claims = [...document.querySelectorAll("article[data-verdict]")];
  const texts = new Map(claims.map((claim) => [claim, claim.textContent.toLowerCase()]));
  const sections = [...document.querySelectorAll("section[data-section]")];
  const chips = [...document.querySelectorAll(".chip")];
  const search = byId("search"), kind = byId("kind"), section = byId("section");

  const visible = () => claims.filter((claim) => !claim.hidden);

  function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const pressed = new Set(chips.filter((chip) => chip.getAttribute("aria-pressed") === "true").map((chip) => chip.value));
    for (const claim of claims) {
      claim.hidden = !(pressed.has(claim.dataset.verdict)
        && (!kind.value || claim.dataset.kind === kind.value)
        && (!section.value || claim.dataset.section === section.value)
        && words.every((word) => texts.get(claim).includes(word)));
    }
    for (const part of sections) part.hidden = !part.querySelector("article:not([hidden])");
    byId("shown").textContent = `${visible().length} of ${claims.length}`;
  }

  function reset() {
    search.value = kind.value = section.value = "";
    for (const chip of chips) chip.setAttribute("aria-pressed", "true");
    filter();
  }

  // A link to a claim shows it, whatever the filter hides.
  function reveal() {
    const target = byId(decodeURIComponent(location.hash.slice(1)));
    if (target && target.closest("[hidden]")) { reset(); target.scrollIntoView(); }
  }

  function step(direction) {
    const shown = visible();
    if (!shown.length) return;
    const here = shown.indexOf(document.activeElement.closest("article"));
    const next = here < 0 ? (direction > 0 ? 0 : shown.length - 1) : here + direction;
    const claim = shown[Math.max(0, Math.min(shown.length - 1, next))];
    claim.focus({ preventScroll: true });
    claim.scrollIntoView({ block: "start" });
  }

  for (const field of [search, kind, section]) field.addEventListener("input", filter);
  for (const chip of chips) {
    chip.addEventListener("click", () => {
      chip.setAttribute("aria-pressed", chip.getAttribute("aria-pressed") !== "true");
      filter();
    });
  }
  byId("reset").addEventListener("click", reset);
  byId("theme").addEventListener("click", () => {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName);
    if (event.key === "Escape" && typing) { search.value = ""; filter(); event.target.blur(); }
    else if (typing) return;
    else if (event.key === "/") { event.preventDefault(); search.focus(); }
    else if (event.key === "j") step(1);
    else if (event.key === "k") step(-1);
  });
  addEventListener("hashchange", reveal);
  byId("tools").hidden = false;
  filter();
  reveal();
})();
