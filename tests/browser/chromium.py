"""A headless Chromium that runs a page with a script at its end and hands back what the script wrote down."""

import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")

# Window widths and colour schemes in which pages are looked at.
WIDTHS = (360, 1280)
SCHEMES = ("light", "dark")

# Errors are caught from the first script on.
FIRST = """<script>
window.seen = { errors: [] };
addEventListener("error", (event) => seen.errors.push(String(event.message || event.type)), true);
addEventListener("securitypolicyviolation", (event) => seen.errors.push(`policy: ${event.violatedDirective}`));
console.error = (...words) => seen.errors.push(words.join(" "));
</script>"""

# What was seen is left in the page.
TELL = """
  const report = document.createElement("pre");
  report.id = "what-was-seen";
  report.textContent = JSON.stringify(seen);
  document.body.append(report);
"""

POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>')


def found():
    """The browser's program, or nothing, which is said."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print("skipped: no Chromium found")
    return browser


def command(browser, profile, width, scheme="light"):
    """The command line of a window of this width, without what the browser does for itself."""
    return [
        browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage",
        f"--user-data-dir={profile}", f"--window-size={width},900",
        f"--blink-settings=preferredColorScheme={SCHEMES[::-1].index(scheme)}",
    ]


def dumped(browser, page, width, scheme="light"):
    """The page as it stands after its scripts have run."""
    with tempfile.TemporaryDirectory() as profile:
        line = command(browser, profile, width, scheme) + ["--virtual-time-budget=60000", "--dump-dom", page.as_uri()]
        return subprocess.run(line, capture_output=True, text=True, timeout=300, check=False).stdout


def has_script(text):
    """Whether the page has a script of its own: the landing page has none, and its policy allows none."""
    return 'id="open-all"' in text


def run(browser, page, width, last, scheme="light", first=FIRST):
    """What was seen by a script that runs at the end of the page; `last` is markup."""
    text = page.read_text(encoding="utf-8")
    if not has_script(text):
        text = POLICY.sub("", text)
    text = text.replace("<head>", "<head>" + first, 1)
    # The copy lies elsewhere than the figures.
    text = text.replace('src="figures/', f'src="{page.parent.resolve().as_uri()}/figures/')
    head, _, tail = text.rpartition("</body>")
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "page.html"
        copy.write_text(head + last + "</body>" + tail, encoding="utf-8")
        dump = dumped(browser, copy, width, scheme)
    seen = re.search(r'<pre id="what-was-seen">(.*?)</pre>', dump, re.S)
    return json.loads(html.unescape(seen.group(1))) if seen else None


def module(path):
    """A file of an installed package of Node, such as `axe-core/axe.min.js`: in a folder of NODE_PATH, or above."""
    folders = [pathlib.Path(name) for name in os.environ.get("NODE_PATH", "").split(os.pathsep) if name]
    folders += [folder / "node_modules" for folder in (pathlib.Path.cwd(), *pathlib.Path.cwd().parents)]
    return next((folder / path for folder in folders if (folder / path).is_file()), None)
