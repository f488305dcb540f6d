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

from plot import WIDTH, Panel, colour_of, dot, picture, polyline, text, with_table

COLOURS = {"rk4": "#1f5fa8", "symplectic_euler": "#2a8a4a", "implicit": "#b5651d"}
OTHER = "#999999"
LEVEL = "#c02020"
LEAST = 1e-6  # of what is drawn as an error


def decades(values, words):
    """The powers of ten around all values."""
    low = math.floor(math.log10(min(values)))
    high = max(low + 1, math.ceil(math.log10(max(values))))
    return [(10.0**power, words(10.0**power)) for power in range(low, high + 1)]


def panel(left, title, points):
    """points: (time, error, figures)."""
    diagram = Panel(
        left,
        title,
        "processor seconds per simulated second",
        "",
        decades([x for x, _, _ in points], lambda x: f"{x:g}"),
        decades([y for _, y, _ in points], lambda y: f"{100 * y:g} %"),
    )
    yield from diagram.grid()
    for x, y, figures in points:
        name = figures["name"]
        if not figures["level"]:
            yield dot(*diagram.at(x, y), colour_of(name, COLOURS, OTHER), name)
    levels = [(*diagram.at(x, y), f["name"]) for x, y, f in points if f["level"]]
    yield polyline([level[:2] for level in levels], LEVEL)
    for x, y, name in levels:
        yield dot(x, y, LEVEL, name, 5.5)
        yield text(x + 9, y - 7, name, "start", weight="bold")


def drawn(figures):
    compared = figures[1:]  # the first is what the others are compared with
    before = [(f["processor_s"], max(LEAST, f["before_contact"]), f) for f in compared]
    after = [(f["processor_s"], max(LEAST, f["after_contact"]["mean"]), f) for f in compared]
    panels = [
        *panel(0, "before contact, all particles", before),
        *panel(WIDTH, "whole fastening, the two ends", after),
    ]
    return picture(
        panels, [("levels", LEVEL), *COLOURS.items(), ("balanced, one number changed", OTHER)]
    )


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    figures_file, table_file, document, plot = map(Path, sys.argv[1:])
    rows = [row for row in table_file.read_text().splitlines(keepends=True) if row.startswith("|")]
    document.write_text(with_table(document.read_text(), "<!-- table -->", "".join(rows)))
    plot.write_text(drawn(json.loads(figures_file.read_text())))


if __name__ == "__main__":
    main()
