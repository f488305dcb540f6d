#!/usr/bin/env python3
"""Prints one table of what a soak has found so far.

usage: table.py RESULTS

Exit code 1 when a run that the gate guards has an intersection, a gap below the stated one, another
knot, lost frames, or oracles that disagree; runs without the gate are there to be wrong.
"""

import json
import re
import sys
from pathlib import Path

HEADINGS = ("scene", "start", "frames", "pairs", "CGAL", "gap / stated mm", "knot", "> 10 %", "worst",
            "steps/s")
PARTS = ("samples", "jitter", "force", "cost")
UNGUARDED = ("-cost-no-contact", "-cost-paper")

CGAL = re.compile(r"(\d+) frames, (\d+) lost, (\d+) intersecting pairs in \d+ frames, (\d+) disagreem")


class Run:
    """What is known of one run; parts that are not there yet are None."""

    def __init__(self, folder, name):
        self.name = name
        self.folder = folder
        self.stats = self.read(".stats")
        self.verify = self.read(".verify")
        self.strain = self.read(".strain")
        self.is_guarded = not name.endswith(UNGUARDED)
        cgal = folder / f"{name}.cgal"
        found = CGAL.search(cgal.read_text()) if cgal.exists() else None
        self.cgal = [int(number) for number in found.groups()] if found else None

    def read(self, extension):
        file = self.folder / (self.name + extension)
        return json.loads(file.read_text()) if file.exists() else None

    def is_refused(self):
        return (self.folder / f"{self.name}.refused").exists()

    def is_wrong(self):
        if self.is_refused():
            return True
        if self.cgal and (self.cgal[1] or self.cgal[3]):
            return True
        return self.is_guarded and bool(self.verify) and not self.verify["passed"]

    def cells(self):
        if self.is_refused():
            return [self.name, "refused"]
        return [self.name] + self.of_run() + self.of_verification() + self.of_springs()

    def of_run(self):
        if not self.stats:
            return ["", ""]
        return [self.stats["start"], str(self.stats["frames"])]

    def of_verification(self):
        cgal = ""
        if self.cgal:
            cgal = f"{self.cgal[3]} differ" if self.cgal[3] else str(self.cgal[2])
        if not self.verify:
            return ["", cgal, "", ""]
        gap, knot = self.verify["gap"], self.verify["knot"]
        smallest = f"{1000 * gap['smallest_m']:.4f}" if "smallest_m" in gap else "?"
        stated = f"{1000 * gap['stated_m']:.4f}" if gap["stated_m"] else "none"
        changes = sum(len(certified["changes"]) for certified in [knot, *knot["between"]])
        return [str(self.verify["intersections"]["pairs"]), cgal, f"{smallest} / {stated}",
                f"{changes} changes" if changes else "same"]

    def of_springs(self):
        strain = ["", ""]
        if self.strain:
            strain = [
                f"{100 * self.strain['worst_share']:.2f} %, {100 * self.strain['last_share']:.2f} %",
                f"{100 * self.strain['worst_elongation']:.1f} %",
            ]
        return strain + [f"{self.stats['steps_per_second']:.2f}" if self.stats else ""]


def print_rows(rows):
    rows = [row + [""] * (len(HEADINGS) - len(row)) for row in rows]
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEADINGS))]
    for index, row in enumerate(rows):
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |")
        if index == 0:
            print("|" + "|".join("-" * (width + 2) for width in widths) + "|")


def main(folder):
    runs = {part: [] for part in PARTS}
    for file in sorted(folder.glob("*.part")):
        runs[file.read_text().strip()].append(Run(folder, file.stem))
    for part in PARTS:
        if runs[part]:
            print(f"\n{part}\n")
            print_rows([list(HEADINGS)] + [run.cells() for run in runs[part]])
    print("\npairs: intersecting, in all frames. > 10 %: share of the springs in the worst frame and in the")
    print("last one. worst: of any spring in any frame. Springs: of stretch and shear.")
    wrong = [run.name for part in PARTS for run in runs[part] if run.is_wrong()]
    for name in wrong:
        print(f"WRONG: {name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
