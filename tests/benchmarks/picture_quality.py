"""Measures what a better picture costs, and makes the table and the plot of it.

  picture_quality.py RIBBON_PLAY DOCUMENT PLOT KEPT RECORDING...

The first and the last frame of each recording are rendered from the three-quarter view and compared
with 1024 samples of the same light. Errors are those of 8-bit levels; time is the processor time of a
picture, without the start of the program. What is measured is added to the file KEPT picture by
picture, so that a run that was stopped goes on with the same build.
"""

import math
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np

from kept_results import KeptResults, checksum
from plot import WIDTH, Panel, colour_of, dot, picture, polyline, text, with_table

SIZE = (1280, 720)
REFERENCE = 1024
FRAMES = ["1", "-1"]

# Name, options, and the quality whose light it has.
SETTINGS = [
    *[(f"samples {n}", ["--samples", str(n)], "standard") for n in (1, 4, 16, 64, 256)],
    *[(f"noise {x}", ["--noise", str(x)], "standard") for x in (8, 4, 2, 1)],
    ("draft", ["--quality", "draft"], "draft"),
    ("standard", ["--quality", "standard"], "standard"),
    ("final", ["--quality", "final"], "final"),
]
COLOURS = {"samples": "#888888", "noise": "#c04020", "draft": "#2040a0", "standard": "#2040a0",
           "final": "#2040a0"}
KEY = [("--samples", "#888888"), ("--noise", "#c04020"), ("--quality", "#2040a0")]


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def render(play, recording, frame, options, size=SIZE):
    """The pixels, and the processor time that it took."""
    before = processor_seconds()
    command = [play, recording, "-o", "-", "--frames", frame, "--size", f"{size[0]}x{size[1]}", "--quiet"]
    raw = subprocess.run([*command, *options], check=True, stdout=subprocess.PIPE).stdout
    pixels = np.frombuffer(raw, np.uint8).reshape(size[1], size[0], 3).astype(float)
    return pixels, processor_seconds() - before


def measure_picture(play, recording, frame):
    """Of each setting: the mean square error of one picture, and its time."""
    _, start_s = render(play, recording, frame, ["--quality", "draft"], (16, 16))
    references = {
        quality: render(play, recording, frame, ["--quality", quality, "--samples", str(REFERENCE)])[0]
        for quality in ("draft", "standard", "final")
    }
    measured = {}
    for name, options, quality in SETTINGS:
        pixels, seconds = render(play, recording, frame, options)
        measured[name] = (np.mean((pixels - references[quality]) ** 2), seconds - start_s)
    return measured


def measure(play, kept, recordings):
    """Of each setting: mean square errors of all pictures, and their times."""
    results = {name: ([], []) for name, _, _ in SETTINGS}
    for recording in recordings:
        made_of = checksum(play, recording)
        for frame in FRAMES:
            measured = kept.of(f"quality {made_of} {frame}", lambda: measure_picture(play, recording, frame))
            for name, (square, seconds) in measured.items():
                results[name][0].append(square)
                results[name][1].append(seconds)
    return results


def decibels(mean_square):
    return 20 * math.log10(255) - 10 * math.log10(mean_square)


def rows_of(results):
    for name, (squares, times) in results.items():
        yield name, decibels(np.mean(squares)), decibels(max(squares)), math.sqrt(max(squares)), np.mean(times)


def table(results):
    lines = ["| option | PSNR, dB | worst picture, dB | worst error, levels | processor time, s |", "|---|---|---|---|---|"]
    for name, mean, worst, error, seconds in rows_of(results):
        option = name if " " in name else f"quality {name}"
        lines.append(f"| `--{option}` | {mean:.1f} | {worst:.1f} | {error:.2f} | {seconds:.2f} |")
    return "\n".join([*lines, ""])


def promise_panel(results):
    diagram = Panel(WIDTH, "what --noise asks and gets", "--noise", "worst error of a picture, levels",
                    [(t, f"{t:g}") for t in (0.5, 1, 2, 4, 8, 16)],
                    [(d, f"{d:g}") for d in (0.1, 0.3, 1, 3, 10)])
    yield from diagram.grid()
    yield polyline([diagram.at(x, x) for x in (0.5, 10)], "#888888")
    points = [(float(name.split()[1]), e) for name, _, _, e, _ in rows_of(results) if name.startswith("noise")]
    for asked, got in points:
        yield dot(*diagram.at(asked, got), COLOURS["noise"], f"asked {asked:g}, got {got:.2f}")


def cost_panel(results):
    diagram = Panel(0, "what a better picture costs", "processor time of a picture, s", "PSNR, dB",
                    [(t, f"{t:g}") for t in (0.003, 0.01, 0.03, 0.1, 0.3, 1, 3)],
                    [(d, f"{d:g}") for d in (25, 30, 35, 40, 45, 50, 55, 60, 65)])
    yield from diagram.grid()
    for family in ("samples", "noise"):
        points = [(t, d) for name, d, _, _, t in rows_of(results) if name.startswith(family)]
        yield polyline([diagram.at(max(t, 0.003), d) for t, d in points], COLOURS[family])
    for name, mean, _, _, seconds in rows_of(results):
        place = diagram.at(max(seconds, 0.003), mean)
        fill = colour_of(name, COLOURS, "black")
        yield dot(*place, fill, f"{name}: {mean:.1f} dB")
        yield text(place[0] + 7, place[1] + 4, name.split()[-1], "start", fill)


def main():
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    play, document, plot, recordings = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[5:]
    results = measure(play, KeptResults(sys.argv[4]), recordings)
    document.write_text(with_table(document.read_text(), "<!-- table quality -->", table(results)))
    plot.write_text(picture([*cost_panel(results), *promise_panel(results)], KEY))


if __name__ == "__main__":
    main()
