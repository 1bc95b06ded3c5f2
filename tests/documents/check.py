#!/usr/bin/env python3
"""Looks at the documents that `torse report` writes: PDF, README and letters.

    python3 tests/documents/check.py reports/*.pdf reports/*.md

A PDF passes if it is tagged and has a title, no page but the last of a section and the pictures that follow it is filled to
less than 60 %, no text leaves the margins, none lies upon another or is too small to be read, no picture is narrower than its
type allows, and no words are typed mathematics (`mu1`, `x^2`); veraPDF, if it is installed, must find nothing against
PDF/UA-1. A page of Markdown passes if no words outside of formulas and code are typed mathematics. The tools are those of
poppler (pdfinfo, pdftohtml, pdftoppm); what is missing is told, and leaves out what it would test.
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys

# Mathematics as it is typed, which readers should not see: `mu1`, `x^2`, `Q_{k}`.
TYPED = re.compile(r"\b(mu|nu|pi|sqrt|lambda|gamma)\d*\b|\^|_\{")

# One sentence of the worked example names functions of the language.
NAMED = "sum, binom, factorial, sqrt, sin and cos"

# The part of the text area that a page fills at least, unless a section ends on it.
FILL = 0.6

# Millimetres of an A4 page: margins at the sides, above and below the text.
PAGE, SIDE, TOP, BOTTOM = (210, 297), 20, 19, 17

# Headings of this many points begin a section; claims have smaller ones.
HEADING = 11

# The smallest type in points: scripts of scripts. Primes are strokes, and smaller.
SMALLEST = 4.9
PRIMES = "′″‴⁗"

# A picture is at least so many points wide: the type of the narrowest, which are made 480 pixels wide, is of 6 points and more.
NARROWEST = 270

# The widths that poppler tells are off by so many points where a line has large letters.
HANGS = 7


class Text:
    """A stretch of text of a page, in points."""

    def __init__(self, line, scale, fonts):
        left, top, width, height = (int(line[name]) / scale for name in ("left", "top", "width", "height"))
        self.left, self.top, self.right, self.bottom = left, top, left + width, top + height
        self.size, self.family = fonts[line["font"]]
        self.words = html.unescape(re.sub(r"<[^>]*>", "", line["words"]))

    @property
    def is_code(self):
        return "Mono" in self.family

    @property
    def is_formula(self):
        return "Math" in self.family


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False).stdout


def pages_of(document):
    """The texts of each page."""
    text = output("pdftohtml", "-zoom", "3", "-xml", "-i", "-stdout", str(document))
    fonts, pages = {}, []
    for page in re.split(r"<page ", text)[1:]:
        width = int(re.search(r'width="(\d+)"', page).group(1))
        scale = width / (PAGE[0] * 72 / 25.4)
        for number, size, family in re.findall(r'<fontspec id="(\d+)" size="(-?\d+)" family="([^"]*)"', page):
            fonts[number] = (int(size) / scale, family)
        lines = re.finditer(
            r'<text top="(?P<top>-?\d+)" left="(?P<left>-?\d+)" width="(?P<width>-?\d+)" height="(?P<height>-?\d+)" font="(?P<font>\d+)">(?P<words>.*?)</text>',
            page, re.S,
        )
        pages.append([Text(line.groupdict(), scale, fonts) for line in lines])
    return pages


def points(millimetres):
    return millimetres * 72 / 25.4


def fills(document):
    """How much of the text area of each page is filled, from the top down to its last ink."""
    # Grey pixels at 18 to the inch, a stream of images in the portable format: what is measured is the height alone.
    data = subprocess.run(["pdftoppm", "-r", "18", "-gray", str(document)], capture_output=True, check=False).stdout
    shares, place = [], 0
    while place < len(data):
        head = re.compile(rb"P5\s+(\d+)\s+(\d+)\s+255\s").match(data, place)
        width, height = int(head.group(1)), int(head.group(2))
        pixels = memoryview(data)[head.end():head.end() + width * height]
        first, last = (round(height * at / PAGE[1]) for at in (TOP, PAGE[1] - BOTTOM))
        inked = [row for row in range(first, last) if min(pixels[row * width:(row + 1) * width]) < 225]
        shares.append((inked[-1] + 1 - first) / (last - first) if inked else 0)
        place = head.end() + width * height
    return shares


def begins_section(page):
    """Whether the first text of the page, below its head, is the heading of a section."""
    body = [text for text in page if text.top > points(TOP) - 4 and text.words.strip()]
    return bool(body) and min(body, key=lambda text: text.top).size > HEADING


def holds_pictures_alone(page):
    """Whether a page has nothing but pictures with their captions: no claim, whose name is code."""
    body = [text for text in page if text.top > points(TOP) - 4 and text.words.strip()]
    return any(text.words.startswith("Figure") for text in body) and not any(text.is_code for text in body)


def ends_section(following):
    """Whether a section ends before these pages; pictures that found no room on its last page stand on pages of their own."""
    rest = [page for page in following if not holds_pictures_alone(page)]
    return not rest or begins_section(rest[0]) and rest[0] in following[:4]


def overlapping(page):
    """Words that lie upon each other; formulas stack their parts."""
    texts = sorted((text for text in page if not text.is_formula and len(text.words.strip()) > 2), key=lambda text: text.top)
    for number, first in enumerate(texts):
        for second in texts[number + 1:]:
            if second.top > first.bottom:
                break
            wide = min(first.right, second.right) - max(first.left, second.left)
            high = min(first.bottom, second.bottom) - max(first.top, second.top)
            if wide > 3 and high > 0.6 * min(first.size, second.size):
                yield f"{first.words.strip()[:24]} | {second.words.strip()[:24]}"


def small(page):
    """Words in smaller type than can be read."""
    for text in page:
        if text.size < SMALLEST and text.words.strip().strip(PRIMES):
            yield f"“{text.words.strip()[:24]}” is set in {text.size:.1f} points"


def narrow(document):
    """The widths of the pictures that are too narrow for their type, by the boxes that the tags tell."""
    boxes = re.findall(rb"/S/Figure[^<]*<</O/Layout/Placement/Block/BBox\[([-\d.]+) [-\d.]+ ([-\d.]+) ", document.read_bytes())
    widths = [float(right) - float(left) for left, right in boxes]
    return [f"a picture is {width:.0f} points wide" for width in widths if width < NARROWEST]


def typed(words):
    words = words.replace(NAMED, "")
    return [words[max(0, found.start() - 24):found.end() + 24] for found in TYPED.finditer(words)]


def document_faults(document):
    """What is wrong with a PDF, in words."""
    wrong = []
    facts = output("pdfinfo", str(document))
    if not re.search(r"^Tagged:\s+yes", facts, re.M):
        wrong.append("not tagged")
    if not re.search(r"^Title:\s+\S", facts, re.M):
        wrong.append("no title")
    pages = pages_of(document)
    for number, fill in enumerate(fills(document)[:-1], start=1):
        if fill < FILL and not ends_section(pages[number:]):
            wrong.append(f"page {number} is filled to {fill:.0%}")
    for number, page in enumerate(pages, start=1):
        for text in page:
            if text.words.strip() and text.right > points(PAGE[0] - SIDE) + HANGS:
                wrong.append(f"page {number}: “{text.words.strip()[-24:]}” leaves the margin by {text.right - points(PAGE[0] - SIDE):.0f} points")
        wrong += [f"page {number}: {both} lie upon each other" for both in overlapping(page)]
        wrong += [f"page {number}: {words}" for words in small(page)]
        words = " ".join(text.words for text in page if not text.is_code)
        wrong += [f"page {number}: typed mathematics: {stretch}" for stretch in typed(words)]
    return wrong + narrow(document)


def markdown_faults(page):
    """What is wrong with a page of Markdown, in words."""
    text = page.read_text(encoding="utf-8")
    for hidden in (r"```.*?```", r"\$`.*?`\$", r"`[^`]*`", r"<[^>]*>", r"\]\([^)]*\)"):
        text = re.sub(hidden, " ", text, flags=re.S)
    return [f"typed mathematics: {stretch!r}" for stretch in typed(html.unescape(text))]


def verapdf_faults(document):
    found = subprocess.run(["verapdf", "--flavour", "ua1", "--format", "text", str(document)], capture_output=True, text=True, check=False)
    return [] if found.stdout.startswith("PASS") else [f"veraPDF: {found.stdout.strip()[:200]}"]


def main():
    names = [pathlib.Path(name) for name in sys.argv[1:]]
    if not names:
        print(__doc__)
        return 2
    missing = [tool for tool in ("pdfinfo", "pdftohtml", "pdftoppm") if shutil.which(tool) is None]
    if missing:
        print(f"notice: {', '.join(missing)} not found (apt-get install poppler-utils), PDFs are not tested")
    verapdf = shutil.which("verapdf") is not None
    if not verapdf:
        print("notice: veraPDF is not installed, PDF/UA is not tested by it")
    failed = False
    for name in names:
        if name.suffix == ".pdf":
            if missing:
                continue
            wrong = document_faults(name) + (verapdf_faults(name) if verapdf else [])
        else:
            wrong = markdown_faults(name)
        failed = failed or bool(wrong)
        more = f"; and {len(wrong) - 8} more" if len(wrong) > 8 else ""
        print(f"{name.name}: " + ("; ".join(wrong[:8]) + more or "fine"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
