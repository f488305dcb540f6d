#!/usr/bin/env python3
"""How far the particles of a recording are from their smooth paths: what docs/measured.md tells of rest.

usage: restlessness.py POSITIONS_NPY [--seconds FROM TO] [--fps RATE] [--every N]

POSITIONS_NPY is what ribbon-convert writes of all frames, FROM and TO are seconds of the recording. With --every N
the smooth path of a particle goes through nine frames that are N apart, so that slower motion can be compared over
the same way.
"""

import argparse
import sys

import numpy as np


def restlessness_mm(positions, every=1):
    """Distances of particles from the quadratics through nine frames around each, by least squares."""
    quadratic = np.array([-21, 14, 39, 54, 59, 54, 39, 14, -21]) / 231
    middle = every * (len(quadratic) // 2)
    steps = len(positions) - 2 * middle
    smooth = sum(weight * positions[every * i:every * i + steps] for i, weight in enumerate(quadratic))
    return 1000 * np.linalg.norm(positions[middle:middle + steps] - smooth, axis=-1)


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("positions")
    parser.add_argument("--seconds", nargs=2, type=float, metavar=("FROM", "TO"))
    parser.add_argument("--fps", type=float, default=50)
    parser.add_argument("--every", type=int, default=1)
    return parser.parse_args()


def main():
    asked = options()
    positions = np.load(asked.positions).astype(float)
    if asked.seconds:
        first, last = (round(seconds * asked.fps) for seconds in asked.seconds)
        positions = positions[first:last + 1]
    if asked.every < 1 or len(positions) <= 8 * asked.every:
        sys.exit(f"{len(positions)} frames are too few for nine that are {asked.every} apart")
    distances = restlessness_mm(positions, asked.every)
    print(f"median {np.median(distances):.4f} mm, 99 % {np.percentile(distances, 99):.3f} mm, "
          f"worst {distances.max():.2f} mm")


if __name__ == "__main__":
    main()
