#!/usr/bin/env python3
"""Makes tables and a plot of what benchmark_recording has measured.

usage: plot_recording.py FIGURES_JSON DOCUMENT PLOT_SVG

A table takes the place of what stands in the document between the lines "<!-- table NAME -->" and
"<!-- end of table -->"; the names are those of TABLES.
"""

import json
import sys
from pathlib import Path
from statistics import harmonic_mean, mean

from plot import WIDTH, Panel, colour_of, dot, picture, polyline, text, with_table

DEFAULT_BOUND = 1e-5
COLOURS = {
    "ribbon": "#c02020",
    "meshoptimizer": "#2a8a4a",
    "Draco": "#7a4fa8",
    "zfp": "#b5651d",
    "integers": "#1f5fa8",
}
OTHER = "#888888"


def bound_text(bound):
    return f"{bound:.0e}".replace("e-0", "e-") if bound else "0"


def rounded(value):
    """Three digits, and never 1e+01."""
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


class Figures:
    """What was measured, over all recordings."""

    def __init__(self, report):
        self.recordings = report["recordings"]
        self.long = report.get("long", [None])[0]  # not where our codec was measured alone
        everything = [row for recording in self.recordings for row in recording["codecs"]]
        self.bounds = list(dict.fromkeys(row["bound"] for row in everything))
        self.codecs = list(dict.fromkeys(row["codec"] for row in everything))

    def of(self, codec, bound):
        """One row for each recording; none where the codec does not do this bound everywhere."""
        rows = [
            row
            for recording in self.recordings
            for row in recording["codecs"]
            if row["codec"] == codec and row["bound"] == bound
        ]
        return rows if len(rows) == len(self.recordings) else []

    def bits(self, codec, bound):
        rows = self.of(codec, bound)
        return mean(row["bits"] for row in rows) if rows else None

    def speed(self, codec, bound, which):
        rows = self.of(codec, bound)
        return harmonic_mean([row[which] for row in rows]) if rows else None

    def worst_error(self, codec, bounds):
        errors = [r["worst_error_over_bound"] for b in bounds for r in self.of(codec, b)]
        return max(errors, default=None)

    def files(self, bound):
        return [f for recording in self.recordings for f in recording["files"] if f["bound"] == bound]


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def own_tables(figures):
    """Our own codec at every bound."""
    samples = [recording["name"] for recording in figures.recordings]
    names = [name.removeprefix("overhand-").removesuffix("-16x400") for name in samples]
    head = ["codec", "bound", *names, "mean", "encode, GB/s", "decode, GB/s", "worst error / bound"]
    rows = []
    for codec in (c for c in figures.codecs if c.startswith("ribbon")):
        for bound in figures.bounds:
            measured = figures.of(codec, bound)
            if not measured:
                continue
            worst = figures.worst_error(codec, [bound])
            rows.append(
                [codec, bound_text(bound)]
                + [f"{row['bits']:.2f}" for row in measured]
                + [f"{figures.bits(codec, bound):.2f}"]
                + [rounded(figures.speed(codec, bound, s)) for s in ("encode_gb_per_s", "decode_gb_per_s")]
                + ["exact" if bound == 0 else f"{worst:.3f}"]
            )
    return table(head, rows)


def file_table(figures):
    """Whole files, the long one last."""
    rows = []
    for bound in figures.bounds:
        files = figures.files(bound)
        rows.append(file_row("samples", bound, files))
    rows.append(file_row(f"{figures.long['frames']} frames", figures.long["bound"], [figures.long]))
    head = ["file", "bound", "bits", "open, ms", "seek, median, ms", "seek, 99th percentile, ms"]
    return table(head, rows)


def file_row(name, bound, files):
    return [
        name,
        bound_text(bound),
        f"{mean(f['bits'] for f in files):.2f}",
        rounded(1e3 * max(f["open_s"] for f in files)),
        rounded(1e3 * mean(f["seek_median_s"] for f in files)),
        rounded(1e3 * max(f["seek_p99_s"] for f in files)),
    ]


def peer_table(figures):
    """All codecs; speeds at the default bound, or of exact frames where there is nothing else."""
    rows = []
    for codec in figures.codecs:
        bits = [figures.bits(codec, bound) for bound in figures.bounds]
        shown = DEFAULT_BOUND if figures.of(codec, DEFAULT_BOUND) else 0
        speeds = [figures.speed(codec, shown, s) for s in ("encode_gb_per_s", "decode_gb_per_s")]
        worst = figures.worst_error(codec, [bound for bound in figures.bounds if bound > 0])
        rows.append(
            [codec]
            + ["" if b is None else f"{b:.2f}" for b in bits]
            + ["" if s is None else rounded(s) for s in speeds]
            + ["exact" if worst is None else f"{worst:.3f}"]
        )
    head = ["codec", *map(bound_text, figures.bounds), "encode, GB/s", "decode, GB/s", "worst error / bound"]
    return table(head, rows)


TABLES = {"own": own_tables, "files": file_table, "peers": peer_table}


def with_tables(document, figures):
    for name, make in TABLES.items():
        document = with_table(document, f"<!-- table {name} -->", make(figures))
    return document


def colour(codec):
    return colour_of(codec, COLOURS, OTHER)


def ticks(values):
    return [(value, f"{value:g}") for value in values]


def size_panel(figures):
    bounds = [bound for bound in figures.bounds if bound > 0]
    panel = Panel(0, "size", "bound on the error, of the length", "bits per particle and frame",
                  [(b, bound_text(b)) for b in bounds], ticks([1, 2, 4, 8, 16, 32, 64]))
    yield from panel.grid()
    for codec in figures.codecs:
        points = [(b, figures.bits(codec, b)) for b in bounds if figures.bits(codec, b)]
        if len(points) > 1:
            yield polyline([panel.at(b, max(1, y)) for b, y in points], colour(codec))
        for bound, bits in points:
            yield dot(*panel.at(bound, max(1, bits)), colour(codec), f"{codec}: {bits:.2f}")


def speed_panel(figures):
    title = f"decoding at {bound_text(DEFAULT_BOUND)} (grey: exact)"
    panel = Panel(WIDTH, title, "bits per particle and frame", "GB/s",
                  ticks([2, 4, 8, 16, 32, 64, 128]), ticks([0.03, 0.1, 0.3, 1, 3, 10, 30, 100]))
    yield from panel.grid()
    for codec in figures.codecs:
        shown = DEFAULT_BOUND if figures.of(codec, DEFAULT_BOUND) else 0
        if not figures.of(codec, shown):
            continue
        place = panel.at(figures.bits(codec, shown), figures.speed(codec, shown, "decode_gb_per_s"))
        fill = colour(codec) if shown else OTHER
        yield dot(*place, fill, codec)
        yield text(place[0] + 7, place[1] + 4, codec.split(",")[0], "start", fill)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    report, document, plot = map(Path, sys.argv[1:])
    figures = Figures(json.loads(report.read_text()))
    document.write_text(with_tables(document.read_text(), figures))
    panels = [*size_panel(figures), *speed_panel(figures)]
    plot.write_text(picture(panels, COLOURS.items()))


if __name__ == "__main__":
    main()
