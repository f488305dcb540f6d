#!/usr/bin/env python3
"""Writes the gallery's page from what samples/gallery.sh has measured.

usage: gallery_page.py SCENES RESULTS PAGE

What the page tells of knots that RESULTS does not hold stays, and so does all that stands below its last table.
Exit code 1 when a knot that was tied is not what was promised.
"""

import itertools
import json
import os
import sys
from pathlib import Path

import numpy as np

from restlessness import restlessness_mm

HEADINGS = ("knot", "particles", "stages", "frames", "wall, s", "processor, s", "intersecting pairs", "strain",
            "from the object, mm", "rest: 99 %, mm", "worst, mm", "verified")
HANDS = {"drawn": "As drawn", "mirrored": "With the other hand: over and under exchanged, hands reflected"}

TOP = """# Gallery

Knots of one ribbon round an object, each tied from its drawing by one command, and one picture of its last
frame. Made by `samples/gallery.sh`: it ties all of them, or those that it is called with (`--mirrored`: with the other
hand, too), verifies every frame and writes this page.

"""

MEASURED = """
## What was measured

Wall and processor time of the recorder on {cores} cores ({processor}), whatever else these did: where they did
nothing else, a run takes no longer than its processor time. *Strain* is the largest of all edges and frames; *from the
object* is how far the rows at which the ribbon comes nearest to itself lie from it in the last frame; *rest* is how far
particles are from their smooth paths (quadratics through nine frames, 50 a second) in the last two seconds: 99 % of all
are nearer than the one figure, none is further than the other; *verified* is what
`ribbon-play --verify` says of all frames: nothing intersects, gaps and strain are as stated, the knot stays the same
([verification.md](verification.md)).
"""


def description(scene):
    """The comment at the top of a scene, as one line."""
    lines = []
    for line in scene.read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return " ".join(lines)


class Run:
    """A knot as it was tied with one hand."""

    def __init__(self, scene, base):
        self.name = scene.stem
        self.stages = scene.read_text().count("\n[[stage]]\n")
        self.stats, self.verify, self.time = (
            json.loads(base.with_suffix(suffix).read_text()) for suffix in (".stats", ".verify", ".time"))
        self.restlessness_mm = restlessness_mm(np.load(base.with_suffix(".npy")).astype(float))

    def is_as_promised(self):
        return self.verify["passed"] and self.verify["outcome"]["embraces_object"]

    def row(self):
        distance_m = self.verify["outcome"]["knot_distance_m"]
        return (self.name, f"{self.stats['across']}x{self.stats['along']}", str(self.stages or ""),
                str(self.stats["frames"]),
                f"{self.time['wall_s']:.0f}", f"{self.time['user_s'] + self.time['system_s']:.0f}",
                str(self.verify["intersections"]["pairs"]),
                f"{100 * self.verify['strain']['largest']:.1f} %",
                "" if distance_m is None else f"{1000 * distance_m:.1f}",
                f"{np.percentile(self.restlessness_mm, 99):.3f}", f"{self.restlessness_mm.max():.2f}",
                "yes" if self.is_as_promised() else "**no**")


def runs_of(scenes, results, hand):
    bases = [(scene, results / f"{scene.stem}-{hand}") for scene in scenes]
    return [Run(scene, base) for scene, base in bases if base.with_suffix(".verify").exists()]


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return "of an unknown kind"


def line(cells):
    return "| " + " | ".join(cells) + " |"


def rows_below(lines, heading):
    """The rows of the table below a heading in the lines of a page, by their knots."""
    if heading not in lines:
        return {}
    below = itertools.takewhile(lambda row: row[:1] in ("", "|"), lines[lines.index(heading) + 1:])
    _, _, *rows = filter(None, below)
    return {row.split("|")[1].strip(): row for row in rows}


def remarks(lines):
    """What stands below the last table of a page."""
    last = max((i for i, row in enumerate(lines) if row.startswith("|")), default=len(lines))
    return "".join(row + "\n" for row in lines[last + 1:])


def pictures(scenes):
    rows = ["| | |", "|---|---|"]
    for scene in scenes:
        name, told = scene.stem, description(scene)
        command = f"`ribbon-record samples/gallery/{name}.toml -o {name}.rbn`"
        rows.append(f"| ![{name}](gallery/{name}.png) | **{name}**<br>{told}<br>{command} |")
    return "\n".join(rows) + "\n"


def main(scenes, results, page):
    scenes_of = {scene.stem: scene for scene in sorted(scenes.glob("*.toml"))}
    tied = {hand: runs_of(scenes_of.values(), results, hand) for hand in HANDS}
    before = page.read_text().splitlines() if page.exists() else []
    tables = {}
    for hand, heading in HANDS.items():
        rows = rows_below(before, f"**{heading}**") | {run.name: line(run.row()) for run in tied[hand]}
        tables[hand] = {knot: rows[knot] for knot in scenes_of if knot in rows}
    text = TOP + pictures([scenes_of[knot] for knot in tables["drawn"]])
    text += MEASURED.format(cores=os.cpu_count(), processor=processor())
    for hand, heading in HANDS.items():
        if tables[hand]:
            rows = [line(HEADINGS), line(("---",) * len(HEADINGS)), *tables[hand].values()]
            text += f"\n**{heading}**\n\n" + "\n".join(rows) + "\n"
    page.write_text(text + remarks(before))
    wrong = [f"{run.name}, {hand}" for hand in HANDS for run in tied[hand] if not run.is_as_promised()]
    for name in wrong:
        print(f"WRONG: {name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*map(Path, sys.argv[1:])))
