#!/usr/bin/env python3
"""Draws time against error, as measured by benchmark_accuracy, and puts its table into the document.

usage: plot_accuracy.py FIGURES_JSON TABLE_TEXT DOCUMENT PLOT_SVG

The table takes the place of what stands in the document between the lines "<!-- table -->" and
"<!-- end of table -->".
"""

import json
import math
import sys
from pathlib import Path
from xml.sax.saxutils import escape

COLOURS = {"rk4": "#1f5fa8", "symplectic_euler": "#2a8a4a", "implicit": "#b5651d"}
OTHER = "#999999"
LEVEL = "#c02020"
WIDTH, HEIGHT, MARGIN = 440, 380, 60
LEAST = 1e-6  # of what is drawn as an error


class Panel:
    """One diagram, both axes logarithmic, its lower left corner `left` from the picture's."""

    def __init__(self, left, title, points):
        self.left = left
        self.title = title
        self.points = points
        self.x_range = decades([x for x, _, _ in points])
        self.y_range = decades([y for _, y, _ in points])

    def at(self, x, y):
        def share(value, ends):
            return (math.log10(value) - ends[0]) / (ends[1] - ends[0])

        return (
            self.left + MARGIN + share(x, self.x_range) * (WIDTH - MARGIN - 20),
            HEIGHT - MARGIN - share(y, self.y_range) * (HEIGHT - MARGIN - 40),
        )

    def grid(self):
        low_x, high_x = self.x_range
        low_y, high_y = self.y_range
        for power in range(low_x, high_x + 1):
            x, bottom = self.at(10.0**power, 10.0**low_y)
            _, top = self.at(10.0**power, 10.0**high_y)
            yield line(x, bottom, x, top, "#dddddd")
            yield text(x, bottom + 18, f"{10.0**power:g}", "middle")
        for power in range(low_y, high_y + 1):
            left, y = self.at(10.0**low_x, 10.0**power)
            right, _ = self.at(10.0**high_x, 10.0**power)
            yield line(left, y, right, y, "#dddddd")
            yield text(left - 6, y + 4, f"{100 * 10.0**power:g} %", "end")
        yield text(self.left + WIDTH / 2 + 20, 24, self.title, "middle", "bold")
        yield text(self.left + WIDTH / 2 + 20, HEIGHT - 16, "processor seconds per simulated second", "middle")

    def drawn(self):
        yield from self.grid()
        for x, y, figures in self.points:
            if not figures["level"]:
                yield dot(*self.at(x, y), 3.5, colour(figures["name"]), figures["name"])
        levels = [(x, y, f["name"]) for x, y, f in self.points if f["level"]]
        corners = " ".join("{:.1f},{:.1f}".format(*self.at(x, y)) for x, y, _ in levels)
        yield f'<polyline points="{corners}" fill="none" stroke="{LEVEL}"/>'
        for x, y, name in levels:
            place_x, place_y = self.at(x, y)
            yield dot(place_x, place_y, 5.5, LEVEL, name)
            yield text(place_x + 9, place_y - 7, name, "start", "bold")


def decades(values):
    """The powers of ten around all values."""
    low = math.floor(math.log10(min(values)))
    return low, max(low + 1, math.ceil(math.log10(max(values))))


def colour(name):
    return next((COLOURS[word] for word in COLOURS if name.startswith(word)), OTHER)


def line(x1, y1, x2, y2, stroke):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{stroke}"/>'


def text(x, y, words, anchor, weight="normal"):
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-weight="{weight}">'
        f"{escape(words)}</text>"
    )


def dot(x, y, radius, fill, words):
    return (
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill}">'
        f"<title>{escape(words)}</title></circle>"
    )


def key():
    """What the colours mean, on one line at the bottom."""
    names = [("levels", LEVEL), *COLOURS.items(), ("balanced, one number changed", OTHER)]
    for i, (name, fill) in enumerate(names):
        yield dot(80 + 150 * i, HEIGHT + 12, 5, fill, name)
        yield text(92 + 150 * i, HEIGHT + 16, name, "start")


def picture(figures):
    compared = figures[1:]  # the first is what the others are compared with
    before = [(f["processor_s"], max(LEAST, f["before_contact"]), f) for f in compared]
    after = [(f["processor_s"], max(LEAST, f["after_contact"]["mean"]), f) for f in compared]
    panels = [
        Panel(0, "before contact, all particles", before),
        Panel(WIDTH, "whole fastening, the two ends", after),
    ]
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * WIDTH + 20} {HEIGHT + 30}"'
        ' font-family="sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    for panel in panels:
        lines.extend(panel.drawn())
    lines.extend(key())
    return "\n".join([*lines, "</svg>", ""])


def with_table(document, table):
    begin, end = "<!-- table -->\n", "<!-- end of table -->\n"
    head, rest = document.split(begin)
    _, tail = rest.split(end)
    return head + begin + table + end + tail


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    figures_file, table_file, document, plot = map(Path, sys.argv[1:])
    rows = [row for row in table_file.read_text().splitlines(keepends=True) if row.startswith("|")]
    document.write_text(with_table(document.read_text(), "".join(rows)))
    plot.write_text(picture(json.loads(figures_file.read_text())))


if __name__ == "__main__":
    main()
