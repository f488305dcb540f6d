#!/usr/bin/env python3
"""Reads recordings by libribbon/recording/FORMAT.md alone; section numbers are those of that document.

usage: read_recording.py RECORDING

Prints what the recording holds. Shares nothing with the library: what both read alike, the document
says.
"""

import struct
import sys
import zlib
from pathlib import Path

import numpy as np

from recorded_positions import Content, Damaged, PositionCodec
from zstd_frames import zstd_content

SIGNATURE = b"\x89RBN\r\n\x1a\n"
MAGIC = b"\xb1REC"
HEADER, FRAME, INDEX, FOOTER, CHECKPOINT, SESSION, DIRECTORY = range(1, 8)
RECORD_HEAD_BYTES = 24
EDGES = ("along", "across", "diagonals")  # bits from the lowest on


class Fields(Content):
    """Takes fields from the front of a payload (conventions at the top of the document)."""

    def take(self, form):
        values = struct.unpack("<" + form, self.bytes(struct.calcsize("<" + form)))
        return values[0] if len(values) == 1 else values

    def string(self):
        return self.bytes(self.take("I"))

    def text(self):
        return self.string().decode()

    def block(self):
        return zstd_content(self.string())

    def matrix(self, form, rows):
        """Columns x rows."""
        count = self.take("I")
        return np.frombuffer(self.block(), form).reshape(count, rows)


def records(data):
    """(offset, type, payload) of each record that is whole (section 2)."""
    at = len(SIGNATURE)
    while at + RECORD_HEAD_BYTES <= len(data):
        magic, kind, size, payload_sum, head_sum = struct.unpack_from("<4sIQII", data, at)
        begin = at + RECORD_HEAD_BYTES
        if magic != MAGIC or zlib.crc32(data[at : at + 20]) != head_sum:
            at = next_head(data, at + 1)
            continue
        if size > len(data) - begin:  # a cut tail, unless another record follows
            at = next_head(data, begin)
            continue
        payload = data[begin : begin + size]
        if zlib.crc32(payload) == payload_sum:
            yield at, kind, payload
            at = begin + size
        else:
            at = next_head(data, begin)


def next_head(data, at):
    """Where the next head with a valid checksum begins, or the end of the file."""
    while (at := data.find(MAGIC, at)) >= 0 and at + RECORD_HEAD_BYTES <= len(data):
        if zlib.crc32(data[at : at + 20]) == struct.unpack_from("<I", data, at + 20)[0]:
            return at
        at += 1
    return len(data)


class Header:
    """Section 4."""

    def __init__(self, payload):
        fields = Fields(payload)
        self.recording_id = zlib.crc32(payload)
        self.major, self.minor, self.codec = fields.take("HHI")
        if self.major != 7:
            raise Damaged(f"this is version {self.major} of the format")
        self.along, self.across = fields.take("II")
        self.length_m, self.width_m, self.frames_per_second = fields.take("ddd")
        self.max_position_error_m, self.quantisation_step_m = fields.take("dd")
        self.scene_name, self.writer, self.scene_text = (fields.text() for _ in range(3))
        self.uv = fields.matrix("<f4", 2)
        self.obstacle = self.take_obstacle(fields) if fields.take("B") == 1 else None
        self.stated_gap_m = fields.take("d")
        self.centre_axis = fields.take("6d") if fields.take("B") == 1 else None
        self.origin = self.take_origin(fields) if fields.take("B") == 1 else None
        edges, self.strain_limit = fields.take("Bd")
        self.limited_edges = {name for bit, name in enumerate(EDGES) if edges >> bit & 1}
        self.input_curve = fields.matrix("<f4", 3)
        self.stages = [fields.text() for _ in range(fields.take("I"))]
        self.marks = [(fields.text(), fields.take("d")) for _ in range(fields.take("I"))]
        has_part = fields.take("B") == 1
        self.knot_between = (*fields.take("dd"), fields.text()) if has_part else None
        rows = fields.matrix("<f4", 1)[:, 0].astype(float)
        self.row_widths_m = rows if len(rows) > 0 else np.full(self.along, self.width_m)

    @property
    def particles(self):
        return self.along * self.across

    @staticmethod
    def take_obstacle(fields):
        return fields.text(), fields.matrix("<f4", 3), fields.matrix("<u4", 3)

    @staticmethod
    def take_origin(fields):
        return {
            "recording id": fields.take("I"),
            "scene name": fields.text(),
            "frame": fields.take("I"),
            "changed settings": fields.text(),
        }


    def edge_strain(self, positions):
        """abs(length / length at rest - 1) by kind of edge; positions 3 x particles."""
        now = self.edge_lengths(positions.astype("f8").reshape(3, self.along, self.across))
        at_rest = self.edge_lengths(self.flat())
        return {kind: np.abs(now[kind] / at_rest[kind] - 1) for kind in EDGES}

    def flat(self):
        """The particles of the flat ribbon, 2 x along x across."""
        along = np.linspace(0, self.length_m, self.along)[:, None]
        across = np.linspace(-0.5, 0.5, self.across) * self.row_widths_m[:, None]
        return np.stack(np.broadcast_arrays(along, across))

    @staticmethod
    def edge_lengths(grid):
        """By kind of edge; grid: coordinates x along x across."""
        diagonals = (grid[:, 1:, 1:] - grid[:, :-1, :-1], grid[:, 1:, :-1] - grid[:, :-1, 1:])
        edges = {
            "along": grid[:, 1:] - grid[:, :-1],
            "across": grid[:, :, 1:] - grid[:, :, :-1],
            "diagonals": np.stack(diagonals, axis=1),
        }
        return {kind: np.linalg.norm(edge, axis=0) for kind, edge in edges.items()}

    def largest_strain(self, positions):
        """Of the limited edges; 0 where none is."""
        strain = self.edge_strain(positions)
        return max((float(strain[kind].max()) for kind in self.limited_edges), default=0.0)


class Frame:
    """Section 5.1. Geometry is decoded by Recording.positions()."""

    def __init__(self, payload):
        fields = Fields(payload)
        self.recording_id, self.frame, geometry_at = fields.take("IIH")
        self.encoding, flags = fields.take("HI")
        self.time_s, self.worst_strain = fields.take("dd")
        self.penetrating_edges, self.recovery_iterations = fields.take("II")
        self.reference = fields.take("I") if flags & 4 else None
        self.tightness = fields.take("5f") if flags & 1 else None
        self.stage = fields.take("B") if flags & 2 else 0
        if not fields.at <= geometry_at <= len(payload):
            raise Damaged(f"frame {self.frame} contradicts itself")
        self.geometry = payload[geometry_at:]

    def numbers(self):
        """What an index repeats."""
        return (
            self.time_s,
            self.worst_strain,
            self.penetrating_edges,
            self.recovery_iterations,
            self.frame,
            self.reference,
            self.tightness,
            self.stage,
        )


def columns(block, count, forms):
    """The columns of a table, `count` values each, as tuples of native numbers."""
    at = 0
    for form in forms:
        column = np.frombuffer(block, "<" + form, count, at)
        at += column.nbytes
        yield column.tolist()


class Index:
    """Section 6: what the frames and others in it are said to be, and where."""

    def __init__(self, payload):
        fields = Fields(payload)
        self.recording_id, self.previous = fields.take("IQ")
        frames = fields.take("I")
        forms = ["f8", "f8", "u4", "u4", "u4", "u8", "u4", "u4", "u1", *["f4"] * 5, "u1"]
        rows = list(zip(*columns(fields.block(), frames, forms)))
        others = fields.take("I")
        self.others = list(zip(*columns(fields.block(), others, ["u4", "u4", "u8", "u8"])))
        self.frames = list(self.placed(rows))

    @staticmethod
    def placed(rows):
        """(offset, record bytes, numbers as Frame.numbers()) of each frame."""
        frame, end = -1, 0
        for row in rows:
            frame = (frame + row[4] + 1) % 2**32
            begin = end + row[5]
            end = begin + row[6]
            reference = (frame - row[7]) % 2**32 if row[7] else None
            tightness = row[9:14] if row[8] else None
            yield begin, row[6], (*row[:4], frame, reference, tightness, row[14])


class Recording:
    """A recording, found by scanning it; where it has indices they must agree with that."""

    def __init__(self, data):
        if data[: len(SIGNATURE)] != SIGNATURE:
            raise Damaged("this is no recording")
        found = list(records(data))
        if not found or found[0][1] != HEADER:
            raise Damaged("the header is lost")
        self.header = Header(found[0][2])
        self.frames, self.offsets = {}, {}
        self.others, self.indices, self.sessions, self.checkpoints = [], [], [], {}
        self.directory = None
        for offset, kind, payload in found[1:]:
            self.take(offset, kind, payload)
        self.codec = PositionCodec(self.header)
        self.decoded = {}

    def take(self, offset, kind, payload):
        if struct.unpack_from("<I", payload)[0] != self.header.recording_id and kind != FOOTER:
            return
        if kind == FRAME:
            frame = Frame(payload)
            self.frames[frame.frame] = frame
            self.offsets[frame.frame] = offset
        elif kind == INDEX:
            self.indices.append((offset, Index(payload)))
        elif kind == CHECKPOINT:
            self.take_checkpoint(offset, payload)
        elif kind == SESSION:
            self.take_session(offset, payload)
        elif kind == DIRECTORY:
            self.directory = (offset, payload)

    def take_checkpoint(self, offset, payload):
        """Section 5.2."""
        fields = Fields(payload)
        _, frame, steps, size, checksum, begin = fields.take("IIQQII")
        state = zstd_content(payload[begin:])
        if len(state) != size or zlib.crc32(state) != checksum:
            raise Damaged(f"the checkpoint of frame {frame} is not what it says")
        self.checkpoints[frame] = (steps, state)
        self.others.append((CHECKPOINT, frame, offset, RECORD_HEAD_BYTES + len(payload)))

    def take_session(self, offset, payload):
        """Section 5.3."""
        fields = Fields(payload)
        _, first_frame, reason = fields.take("IIB")
        self.sessions.append((first_frame, reason, fields.text(), fields.text()))
        self.others.append((SESSION, first_frame, offset, RECORD_HEAD_BYTES + len(payload)))

    def check_indices(self):
        """Each index tells the truth, each points to the one before (section 6)."""
        previous = 0
        for offset, index in self.indices:
            if index.previous != previous:
                raise Damaged(f"the index at {offset} does not point to the one before")
            previous = offset
            for begin, size, numbers in index.frames:
                self.check_indexed(begin, size, numbers)
            for other in index.others:
                if other[0] in (CHECKPOINT, SESSION) and other not in self.others:
                    raise Damaged(f"the index at {offset} knows a record that is not there")

    def check_indexed(self, begin, size, numbers):
        frame = self.frames[numbers[4]]
        whole = frame.numbers()
        same = whole[:6] == numbers[:6] and (whole[6] and tuple(whole[6])) == numbers[6]
        same = same and whole[7] == numbers[7]
        head = RECORD_HEAD_BYTES + 40 + (20 if frame.tightness else 0)
        if not same or self.offsets[frame.frame] != begin or size < head + len(frame.geometry):
            raise Damaged(f"an index is wrong about frame {frame.frame}")

    def check_directory(self, data):
        """Section 7: footer and directory, which only a finished recording has."""
        at, payload = self.directory
        footer = struct.unpack("<QII", data[-16:])
        if footer != (at, self.header.recording_id, 0):
            raise Damaged("the footer does not point to the directory")
        fields = Fields(payload)
        _, frames, ending, _, count = fields.take("IIB3sI")
        forms = ["u8", "u4", "u4", "u4", "u4", "u4"]
        table = list(zip(*columns(fields.block(), count, forms)))
        for (offset, index), row in zip(self.indices, table, strict=True):
            numbers = [frame[2][4] for frame in index.frames]
            limits = (min(numbers), max(numbers)) if numbers else row[2:4]
            if (offset, *limits, len(numbers), len(index.others)) != (row[0], *row[2:]):
                raise Damaged(f"the directory is wrong about the index at {offset}")
        if frames != max(self.frames, default=-1) + 1:
            raise Damaged("the directory counts other frames than there are")
        return ending

    def readable(self, number):
        """Is the frame there, and are all that it needs?"""
        if number not in self.frames:
            return False
        reference = self.frames[number].reference
        return reference is None or self.readable(reference)

    def positions(self, number):
        """Coordinates of a frame, 3 x particles, f32."""
        return self.frame(number).coordinates()

    def frame(self, number):
        if number not in self.decoded:
            frame = self.frames[number]
            reference = None if frame.reference is None else self.frame(frame.reference)
            self.decoded[number] = self.codec.decode(frame.encoding, frame.geometry, reference)
        return self.decoded[number]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    data = Path(sys.argv[1]).read_bytes()
    recording = Recording(data)
    recording.check_indices()
    header = recording.header
    print(f"{header.scene_name}, {header.across}x{header.along}, {len(recording.frames)} frames")
    print(f"limited edges: {sorted(header.limited_edges)}, to {100 * header.strain_limit:g} %")
    print(f"input curve: {len(header.input_curve)} points")
    print(f"stages: {', '.join(header.stages) or 'none'}")
    print(f"marks: {', '.join(name for name, _ in header.marks) or 'none'}")
    print(f"knot between: {header.knot_between or 'not asked for'}")
    for number in sorted(recording.frames):
        frame = recording.frames[number]
        positions = recording.positions(number)
        strain = f"{100 * header.largest_strain(positions):.4g} %"
        print(
            f"frame {number}: {frame.time_s:g} s, from {frame.reference}, "
            f"centre {positions.mean(axis=1)}, strain {strain}"
        )


if __name__ == "__main__":
    main()
