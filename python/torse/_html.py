"""Explanations as HTML and as text."""

from html import escape


def table(groups):
    """Groups of labels and texts as a table."""
    rows = []
    for group in groups:
        for label, text in group:
            rows.append(
                f"<tr><th style='text-align: left'>{escape(label)}</th>"
                f"<td style='text-align: left'>{escape(text)}</td></tr>"
            )
    return "<table>" + "".join(rows) + "</table>"


def text(groups):
    """The same as lines."""
    blocks = []
    for group in groups:
        blocks.append("\n".join(f"{label:14}{text}" for label, text in group))
    return "\n\n".join(blocks)
