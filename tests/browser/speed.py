#!/usr/bin/env python3
"""Measures how soon the pages that `torse report` writes answer to a slider.

    python3 tests/browser/speed.py reports/PAPER.html ...

The browser goes to the link of the first claim with a moving figure. As soon as there is a slider, it is moved; the clock
stops when the figure is drawn anew. The median of five runs, on two cores and from a file, is at most a second. Without
Chromium nothing is measured, which is said; a page without sliders is passed over.
"""

import base64
import json
import os
import pathlib
import queue
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import zlib

import chromium

LIMIT = 1.0
RUNS = 5
CORES = 2
# A run that takes longer has failed.
PATIENCE = 60

MOVE = """<script>
(() => {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const step = () => {
    const details = target.querySelector("details.moving");
    if (details) {
      for (let part = details; part && part !== target; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
      const input = details.querySelector("input[type=range]");
      if (input) {
        input.value = input.max;
        input.dispatchEvent(new Event("input"));
        console.log(`handled after ${performance.now()} ms`);
        return;
      }
    }
    setTimeout(step, 1);
  };
  step();
})();
</script>"""


def first_moving(text):
    """The id of the first claim with a moving figure."""
    packed = re.search(r'id="packed">([^<]*)<', text)
    insides = json.loads(zlib.decompress(base64.b64decode(packed.group(1)), -15)) if packed else []
    for number, inside in enumerate(insides):
        if 'class="moving' in inside:
            found = re.search(rf'<article id="([^"]*)"[^>]*>\s*<details data-inside="{number}"', text)
            return found.group(1) if found else None
    return None


def two_cores():
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:CORES])


def seconds(browser, page, claim):
    """From the start of the navigation to the first event that was handled; none if it never was."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        line = chromium.command(browser, profile, 1280)
        line += ["--remote-debugging-port=0", "--enable-logging=stderr", f"{page.as_uri()}#{claim}"]
        process = subprocess.Popen(
            line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", preexec_fn=two_cores,
        )
        told = queue.Queue()
        threading.Thread(target=lambda: [told.put(words) for words in process.stderr], daemon=True).start()
        end = time.monotonic() + PATIENCE
        try:
            while time.monotonic() < end:
                try:
                    found = re.search(r"handled after ([\d.]+) ms", told.get(timeout=0.5))
                except queue.Empty:
                    continue
                if found:
                    return float(found.group(1)) / 1000
        finally:
            process.kill()
            process.wait()
    return None


def main():
    browser = chromium.found()
    if browser is None:
        return 0
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    failed = False
    for name in sys.argv[1:]:
        page = pathlib.Path(name)
        text = page.read_text(encoding="utf-8")
        claim = first_moving(text)
        if claim is None:
            continue
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "page.html"
            head, _, tail = text.rpartition("</body>")
            copy.write_text(head + MOVE + "</body>" + tail, encoding="utf-8")
            runs = [seconds(browser, copy, claim) for _ in range(RUNS)]
        if None in runs:
            failed = True
            print(f"{page.name}: a slider was not handled within {PATIENCE} s")
            continue
        median = statistics.median(runs)
        failed = failed or median > LIMIT
        told = ", ".join(f"{run:.2f}" for run in sorted(runs))
        print(f"{page.name}: {'TOO SLOW' if median > LIMIT else 'fine'}, {median:.2f} s at {claim} (runs {told}; limit {LIMIT:.0f} s)")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
