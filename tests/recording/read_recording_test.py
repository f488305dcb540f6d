#!/usr/bin/env python3
"""The reader written from FORMAT.md alone reads every recording as our own does, bit for bit.

usage: read_recording_test.py RECORDINGS_FOR_READERS FOLDER RECORDING...

Runs the program, which writes recordings of all kinds into the folder and what our reader decodes from
them; the RECORDINGs are read besides. Fails when anything differs.
"""

import struct
import subprocess
import sys
from pathlib import Path

import numpy as np

from read_recording import EDGES, Recording


def differences(recording_file, frames_file):
    """What is wrong, one line each."""
    data = recording_file.read_bytes()
    recording = Recording(data)
    if not recording_file.stem.startswith("damaged"):
        recording.check_indices()
        if recording.directory:
            recording.check_directory(data)
    header = recording.header
    if limits(header) != our_limits(frames_file.with_suffix(".limits")):
        yield "the limit of strain or the widths of the rows differ"
    if header.input_curve.tobytes() != frames_file.with_suffix(".curve").read_bytes():
        yield "the input curve differs"
    ours = our_frames(frames_file, header.particles)
    for number in sorted(ours.keys() | recording.frames.keys()):
        if recording.readable(number) != (number in ours):
            yield f"frame {number} is readable to one of the readers"
        elif number in ours:
            theirs = recording.positions(number).view("<u4").T.reshape(-1)
            count = np.count_nonzero(ours[number] != theirs)
            if count > 0:
                yield f"frame {number} differs in {count} coordinates"


def limits(header):
    """Which kinds of edges are limited, to what, and the widths of the rows."""
    edges = tuple(kind in header.limited_edges for kind in EDGES)
    return edges, header.strain_limit, tuple(header.row_widths_m)


def our_limits(limits_file):
    content = limits_file.read_bytes()
    *limited, limit = struct.unpack_from("<3Bd", content)
    return tuple(map(bool, limited)), limit, tuple(np.frombuffer(content[11:], "<f8"))


def our_frames(frames_file, particles):
    """The bits of the coordinates by the number of the frame."""
    rows = np.fromfile(frames_file, "<u4").reshape(-1, 1 + 3 * particles)
    return {int(row[0]): row[1:] for row in rows}


def compare(recording_file, frames_file):
    found = list(differences(recording_file, frames_file))
    for line in found:
        print(f"{recording_file.name}: {line}")
    return not found


def finds_a_planted_difference(recording_file, frames_file):
    """A comparison that never fails would look like equal frames."""
    frames = bytearray(frames_file.read_bytes())
    frames[len(frames) // 2] ^= 1
    planted = frames_file.with_suffix(".planted")
    planted.write_bytes(frames)
    return len(list(differences(recording_file, planted))) == 1


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder, *others = map(Path, sys.argv[1:])
    for file in folder.glob("*"):
        file.unlink()
    subprocess.run([program, folder], check=True)
    recordings = sorted(folder.glob("*.rbn"))
    if others:
        subprocess.run([program, folder, *others], check=True)
    pairs = [(file, folder / (file.stem + ".frames")) for file in recordings + others]
    same = [compare(*pair) for pair in pairs]
    if not finds_a_planted_difference(*pairs[0]):
        sys.exit("a difference of one bit was not noticed")
    print(f"{sum(same)} of {len(same)} recordings are read alike")
    sys.exit(0 if same and all(same) else 1)


if __name__ == "__main__":
    main()
