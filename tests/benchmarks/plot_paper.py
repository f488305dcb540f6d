#!/usr/bin/env python3
"""Makes tables and a plot of what samples/paper.sh has measured, into the same folder.

usage: plot_paper.py RESULTS [DOCUMENT]

A table takes the place of what stands in the document between the lines "<!-- table NAME -->" and
"<!-- end of table -->"; the names are those of TABLES. Pictures go into the folder beside it that has its name.
Exit code 1 when a run by the gate is not what was promised.
"""

import json
import shutil
import sys
from pathlib import Path

from plot import WIDTH, Panel, dot, picture, polyline, with_table

METHODS = {"gate": "gate", "published": "as published"}

# How box tests are told: key in the report, name, colour.
DETECTORS = (
    ("brute_force", "every pair", "#888888"),
    ("cells", "space enumeration", "#b5651d"),
    ("boxes", "hierarchy, boxes", "#1f5fa8"),
    ("curvature", "hierarchy, curvature", "#2a8a4a"),
    ("patches", "the gate's", "#c02020"),
)
STATES = {"loose": "loose, as drawn", "tight": "tight"}


class Run:
    """A ribbon that was tied by one method."""

    def __init__(self, verified):
        self.name, _, self.method = verified.stem.rpartition("-")
        self.verify, self.stats, self.time = (
            json.loads(verified.with_suffix(suffix).read_text()) for suffix in (".verify", ".stats", ".time"))

    def figure(self):
        return f"{self.name.partition('-')[0]}: {self.stats['across']}x{self.stats['along']}"

    def cells(self):
        """What became of it, for a row of a table."""
        pairs = self.verify["intersections"]
        return [
            f"{self.stats['simulated_s']:.1f}",
            str(pairs["pairs"]) + ("" if pairs["all_counted"] else " at least"),
            f"{pairs['frames']} of {self.verify['frames']['checked']}",
            str(pairs["most"]["pairs"]) if pairs["pairs"] else "0",
            str(self.stats["last_penetrating_edges"]),
            f"{100 * self.verify['strain']['largest']:.1f} %",
            self.knot(),
            f"{self.time['user_s'] + self.time['system_s']:.1f}",
        ]

    def knot(self):
        """The last certificate's knot, if it is another than the first."""
        changes = self.verify["knot"]["changes"]
        first = self.verify["knot"]["certificate"].split(",")[0].split(" (")[0]
        if not changes:
            return f"{first}, kept"
        last = changes[-1]["after"].split(";")[0].split(",")[0].split(" (")[0]
        times = "once" if len(changes) == 1 else f"{len(changes)} times"
        return f"changed {times}, at last {last}"


HEADINGS = ["simulated, s", "intersecting pairs", "in frames", "most in one", "edges left at the end", "strain", "knot",
            "processor, s"]


def runs_in(results, prefix):
    """Sorted by name, both methods of one name beside each other, the gate first."""
    return sorted((Run(path) for path in results.glob(prefix + "*.verify")), key=lambda run: (run.name, run.method))


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(row) + " |\n" for row in lines)


def figure_table(results):
    rows = []
    for run in runs_in(results, "1"):
        rows.append([run.figure(), METHODS[run.method], *run.cells()])
    return table(["Figure", "method", *HEADINGS], rows)


def stiffness_table(results):
    """The stiffness that the figures have stands in their table."""
    runs = runs_in(results, "stiffness-")
    runs.sort(key=lambda run: float(run.name.partition("-")[2]))
    rows = [[f"{float(run.name.partition('-')[2]):g}", METHODS[run.method], *run.cells()] for run in runs]
    return table(["k/m, 1/s²", "method", *HEADINGS], rows)


def rounded(count):
    return f"{count:.0f}" if count < 1e5 else f"{count:.1e}".replace("e+0", "e").replace("e+", "e")


def box_test_table(results):
    report = json.loads((results / "box_tests.json").read_text())
    rows = []
    for state in (state for state in STATES if state in report):
        for ribbon in report[state]["ribbons"]:
            counts = [rounded(ribbon[key]["box_tests"]) for key, _, _ in DETECTORS]
            rows.append([STATES[state], f"{ribbon['across']}x{ribbon['along']}", *counts,
                         str(ribbon["missed_by_curvature"])])
        growth = report[state]["growth"] or {}  # nothing of a single size
        exponents = [f"{growth[key]:.2f}" if key in growth else "" for key, _, _ in DETECTORS]
        rows.append([STATES[state], "exponent", *exponents, ""])
    names = [name for _, name, _ in DETECTORS]
    return table(["ribbon", "particles", *names, "close pairs that curvature misses"], rows)


def sheet_table(results):
    """The contact sheets that are drawn, as a document shows them."""
    rows = []
    for run in runs_in(results, "1"):
        if not (results / f"{run.name}-{run.method}.small.png").exists():
            continue
        title = f"Figure {run.figure()}, {METHODS[run.method]}"
        rows.append([title, f"![{title}](paper/{run.name}-{run.method}.png)"])
    return table(["", ""], rows)


TABLES = {"sheets": sheet_table, "figures": figure_table, "stiffness": stiffness_table, "box tests": box_test_table}


def box_test_panel(left, state, ribbons):
    particles = [ribbon["across"] * ribbon["along"] for ribbon in ribbons]
    x_ticks = [(count, f"{count}") for count in (1000, 2000, 4000, 8000, 16000)]
    y_ticks = [(10**i, f"1e{i}") for i in range(2, 10)]
    panel = Panel(left, STATES[state], "particles", "box tests of one detection", x_ticks, y_ticks)
    yield from panel.grid()
    for key, name, colour in DETECTORS:
        counts = [max(y_ticks[0][0], ribbon[key]["box_tests"]) for ribbon in ribbons]
        points = [panel.at(*point) for point in zip(particles, counts)]
        yield polyline(points, colour)
        for point, count in zip(points, counts):
            yield dot(*point, colour, f"{name}: {count:.0f}", radius=3)


def box_test_plot(results):
    report = json.loads((results / "box_tests.json").read_text())
    panels = []
    for i, state in enumerate(state for state in STATES if state in report):
        panels += box_test_panel(i * WIDTH, state, report[state]["ribbons"])
    return picture(panels, [(name, colour) for _, name, colour in DETECTORS])


def show_in(document, results, tables):
    words = document.read_text()
    for name, made in tables.items():
        words = with_table(words, f"<!-- table {name} -->", made)
    document.write_text(words)
    pictures = document.with_suffix("")
    pictures.mkdir(exist_ok=True)
    shutil.copy(results / "box-tests.svg", pictures)
    for small in results.glob("*.small.png"):
        shutil.copy(small, pictures / small.name.replace(".small", ""))


def main(results, document=None):
    tables = {name: make(results) for name, make in TABLES.items()}
    (results / "tables.md").write_text("\n".join(f"# {name}\n\n{made}" for name, made in tables.items()))
    (results / "box-tests.svg").write_text(box_test_plot(results))
    if document:
        show_in(document, results, tables)
    print(f"{results}/tables.md, {results}/box-tests.svg, {results}/*.png")
    wrong = [run.name for run in runs_in(results, "") if run.method == "gate" and not run.verify["passed"]]
    for name in wrong:
        print(f"WRONG: {name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(*map(Path, sys.argv[1:])))
