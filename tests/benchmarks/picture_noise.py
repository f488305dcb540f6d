"""Measures on all samples whether --noise keeps its promise, and makes the table of it.

  picture_noise.py RIBBON_PLAY DOCUMENT KEPT RECORDING...

Three frames of each recording, each in another view or with a ground, are compared with 1024 samples.
What --noise bounds is the error of a region, a tile of 16x16 pixels that shows more than the backdrop:
the root of the mean square over its pixels, in 8-bit levels. What is measured is added to the file
KEPT picture by picture, so that a run that was stopped goes on with the same build.
"""

import sys
from pathlib import Path

import numpy as np

from kept_results import KeptResults, checksum
from picture_quality import REFERENCE, render
from plot import with_table

SIZE = (640, 360)
TILE = 16
ASKED = (8, 4, 2, 1)
SCENES = [("1", ["--ground"]), ("100", ["--view", "knot"]), ("-1", ["--view", "three-quarter"])]


def tiles(pixels):
    return [pixels[y:y + TILE, x:x + TILE] for y in range(0, SIZE[1], TILE) for x in range(0, SIZE[0], TILE)]


def shows_more_than_backdrop(tile):
    """Of the backdrop each row is of one colour."""
    return np.ptp(tile, axis=1).any()


def measure_picture(play, recording, frame, options):
    """Of each noise: the mean square errors of the tiles of one picture."""
    reference, _ = render(play, recording, frame, [*options, "--samples", str(REFERENCE)], SIZE)
    shown = [shows_more_than_backdrop(tile) for tile in tiles(reference)]
    errors = {}
    for asked in ASKED:
        pixels, _ = render(play, recording, frame, [*options, "--noise", str(asked)], SIZE)
        squares = np.array([np.mean(tile) for tile in tiles((pixels - reference) ** 2)])
        errors[str(asked)] = squares[shown].tolist()
    return errors


def measure(play, kept, recordings):
    """Of each noise: the mean square errors of the tiles of each picture."""
    results = {asked: [] for asked in ASKED}
    for recording in recordings:
        made_of = checksum(play, recording)
        for frame, options in SCENES:
            errors = kept.of(f"noise {made_of} {frame} {' '.join(options)}",
                             lambda: measure_picture(play, recording, frame, options))
            for asked in ASKED:
                results[asked].append(np.array(errors[str(asked)]))
    return results


def table(results):
    lines = ["| `--noise` | error, mean of the pictures | worst picture | 99 of 100 regions below | worst region |",
             "|---|---|---|---|---|"]
    for asked, pictures in results.items():
        errors = [np.sqrt(np.mean(squares)) for squares in pictures]
        regions = np.sqrt(np.concatenate(pictures))
        lines.append(f"| {asked} | {np.mean(errors):.2f} | {max(errors):.2f} | "
                     f"{np.percentile(regions, 99):.2f} | {max(regions):.2f} |")
    return "\n".join([*lines, ""])


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    play, document, kept, recordings = sys.argv[1], Path(sys.argv[2]), KeptResults(sys.argv[3]), sys.argv[4:]
    results = measure(play, kept, recordings)
    document.write_text(with_table(document.read_text(), "<!-- table noise -->", table(results)))


if __name__ == "__main__":
    main()
