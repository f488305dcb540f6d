#!/usr/bin/env python3
"""Plots the tension along the band over time: how far each place of it is stretched, frame by frame.

usage: tension.py RECORDING PICTURE

The picture is made by matplotlib where it is installed (python3-matplotlib), in any format that it knows;
otherwise it is a plain .svg. In an editor that knows cells (# %%), each step can be run by itself.
"""

# %% What is needed: the package ribbon (docs/python.md) and NumPy.
import sys
from pathlib import Path

import numpy

import ribbon

try:
    from matplotlib import pyplot
except ModuleNotFoundError:
    pyplot = None

if len(sys.argv) != 3:
    sys.exit(__doc__)
picture = Path(sys.argv[2])
formats = pyplot.figure().canvas.get_supported_filetypes() if pyplot else ["svg"]
if picture.suffix.removeprefix(".") not in formats:
    remedy = f"name one of {', '.join(formats)}" if pyplot else "name a .svg or install python3-matplotlib"
    sys.exit(f"{picture}: a picture of this kind cannot be written; {remedy}")


# %% The strain along the band: length of each edge from row to row over its length at rest, less 1. Across
# the band the mean is taken: what is left is one number for each place along it, for each frame.
def strain_along(positions):
    return numpy.linalg.norm(numpy.diff(positions, axis=0), axis=2).mean(axis=1) / rest - 1


try:
    recording = ribbon.open(sys.argv[1])
    rest = recording.length / (recording.along - 1)
    strain = numpy.array([strain_along(positions) for positions in recording])
except ribbon.Error as error:
    sys.exit(str(error))
if len(strain) == 0:
    sys.exit(f"{sys.argv[1]}: the recording holds no frame yet; wait until one is recorded")
time = recording.numbers()["time"]
share = (numpy.arange(recording.along - 1) + 0.5) / (recording.along - 1)
print(f"{len(strain)} frames, strain from {100 * strain.min():.2f} % to {100 * strain.max():.2f} %")

# %% A picture of it: time downwards, the band from left to right.
limit = max(abs(strain.min()), abs(strain.max()), 1e-9)


def plot_by_matplotlib():
    figure, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
    image = axes.pcolormesh(share, time, 100 * strain, cmap="RdBu_r", vmin=-100 * limit, vmax=100 * limit,
                            rasterized=True)
    axes.invert_yaxis()
    axes.set(xlabel="share of the band's length", ylabel="time [s]", title=recording.scene_name)
    figure.colorbar(image, label="strain along the band [%]")
    figure.savefig(picture)


# %% The same as plain SVG, thinned to what can be seen.
def color(value):
    """Blue where the band is pressed together, white at rest, red where it is stretched."""
    pale = f"{round(255 * (1 - abs(value) / limit)):02x}"
    return f"#ff{pale}{pale}" if value > 0 else f"#{pale}{pale}ff"


def plot_as_svg():
    cells = strain[:: len(strain) // 100 + 1, :: strain.shape[1] // 140 + 1]
    count, places = cells.shape
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="-60 -30 880 480" font-family="sans-serif">',
             '<rect x="-60" y="-30" width="880" height="480" fill="white"/>',
             f'<g transform="scale({800 / places} {400 / count})" shape-rendering="crispEdges">']
    lines += [f'<rect x="{i}" y="{j}" width="1" height="1" fill="{color(cells[j, i])}"/>'
              for j in range(count) for i in range(places)]
    lines += ["</g>", f'<text x="0" y="-10">strain along the band, white 0, strongest {100 * limit:.1f} %; '
              f"time downwards, {time[0]:.1f} to {time[-1]:.1f} s</text>",
              '<text x="0" y="430">first end</text><text x="800" y="430" text-anchor="end">last end</text>', "</svg>"]
    picture.write_text("\n".join(lines))


try:
    if pyplot:
        plot_by_matplotlib()
    else:
        plot_as_svg()
except OSError as error:
    sys.exit(f"{picture}: {error.strerror}; choose another place")
