"""Reads, verifies and writes recordings of bands of cloth (docs/python.md).

    import ribbon

    recording = ribbon.open("knot.rbn")
    last = recording[-1]                      # along x across x 3, metres
    strain = recording.numbers()["worst_strain"]
    assert not ribbon.verify(recording).complaints
"""

import os
import time
import tomllib
from collections.abc import Iterable, Iterator
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from ._ribbon import FrameVerdict, Mesh, Recording, Verification, Verifier, Writer, __version__, verify
from .errors import Error

__all__ = ["Error", "FrameVerdict", "Mesh", "Recording", "Verification", "Verifier", "Writer", "__version__",
           "follow", "open", "scene", "verify", "write"]


def open(path: str | os.PathLike[str]) -> Recording:
    """Opens a recording, finished or not. Raises Error where it cannot be read."""
    return Recording(path)


def scene(recording: Recording) -> dict[str, Any]:
    """What the scene of a recording says, section by section; empty where it has none."""
    return tomllib.loads(recording.scene_text)


def follow(recording: Recording, every: float = 0.1) -> Iterator[NDArray[numpy.float32]]:
    """The frames of a recording as they come, until its writer ends; looks for new ones `every` seconds."""
    frame = 0
    grows = True
    while grows:
        grows = recording.being_written  # asked before, so that the last frames are not missed
        count = recording.refresh()
        for frame in range(frame, count):
            yield recording[frame]
        frame = count
        if grows:
            time.sleep(every)


def write(path: str | os.PathLike[str], frames: Iterable[ArrayLike], *, length: float, width: float,
          **settings: Any) -> None:
    """Writes frames, each along x across x 3 in metres, as a recording; settings are those of Writer."""
    frames = iter(frames)
    first = numpy.asarray(next(frames, None))
    if first.ndim != 3:
        raise ValueError("frames must be at least one array of along x across x 3")
    along, across, _ = first.shape
    with Writer(path, along=along, across=across, length=length, width=width, **settings) as writer:
        writer.append(first)
        for positions in frames:
            writer.append(positions)
