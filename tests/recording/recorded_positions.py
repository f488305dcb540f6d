"""Decodes frames by section 8 of libribbon/recording/FORMAT.md; part of read_recording.py."""

import pathlib
import struct

import numpy as np

from zstd_frames import zstd_content

EXACT, QUANTISED = 0, 1
LARGEST_NUMBER = 2**24
LARGEST_ORDINAL = np.int32(0x7F7FFFFF)
BLOCK = 16
F = np.float32
WHOLE_FROM = F(1.5 * 2**23)


class Damaged(Exception):
    """Bytes that are whole, and yet are not what the document says."""


class Content:
    """Takes what a payload or a frame's geometry is made of off its front."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def bytes(self, count):
        if count > len(self.data) - self.at:
            raise Damaged("a payload or a frame's geometry ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def rest(self):
        return self.bytes(len(self.data) - self.at)


class Frame:
    """A decoded frame: its step, values and motion by component, row and column, with one cell more on
    each side."""

    def __init__(self, step, along, across):
        self.step = step
        self.values = np.zeros((3, along + 2, across + 2), "f4")
        self.motion = np.zeros_like(self.values)

    def coordinates(self):
        """3 x particles, f32."""
        values = self.values[:, 1:-1, 1:-1]
        return (values * self.step if self.step > 0 else values).reshape(3, -1)


class PositionCodec:
    def __init__(self, header):
        self.along, self.across = header.along, header.across
        self.step = F(header.quantisation_step_m)

    def decode(self, encoding, geometry, reference):
        """Section 8.3."""
        if encoding not in (EXACT, QUANTISED) or encoding == QUANTISED and not self.step > 0:
            raise Damaged(f"encoding {encoding} is not known")
        frame = Frame(self.step if encoding == QUANTISED else F(0), self.along, self.across)
        if reference is not None and reference.step != frame.step:
            reference = None
        content = Content(geometry)
        with np.errstate(over="ignore", invalid="ignore"):
            self.decode_content(frame, content, reference)
        return frame

    def decode_content(self, frame, content, reference):
        if reference is not None:
            weights = np.frombuffer(content.bytes(36), "<i2").reshape(2, 9).astype("f4") * F(2**-13)
        residuals = take_residuals(content, self.along, self.across)
        for j in range(self.across):
            if reference is not None:
                self.decode_column(frame, j, residuals[:, j], weights[min(j, 1)], reference)
            else:
                self.decode_intra_column(frame, j, residuals[:, j])
            continue_over_ends(frame.values[:, :, j + 1])
            continue_over_ends(frame.motion[:, :, j + 1])
        continue_over_ends(frame.motion.swapaxes(1, 2)[:, :, 1:-1])

    # Section 8.4.

    def decode_column(self, frame, j, residuals, w, reference):
        v, m, q = (Shifted(field, j) for field in (reference.values, reference.motion, frame.motion))
        line = (w[0] * m(0, 0) + w[1] * m(-1, 0)) + w[2] * m(1, 0)
        sides = w[3] * m(0, -1) + w[4] * m(0, 1)
        bend = (v(-1, 0) + v(1, 0)) - (v(0, 0) + v(0, 0))
        near = (w[6] * q(-1, -1) + w[7] * q(0, -1)) + w[8] * q(1, -1)
        p = ((line + sides) + w[5] * bend) + near
        r = v(0, 0)
        values = self.values_from(frame.step, r, p, residuals)
        frame.values[:, 1:-1, j + 1] = values
        frame.motion[:, 1:-1, j + 1] = values - r

    def decode_intra_column(self, frame, j, residuals):
        d = np.cumsum(residuals, axis=1)
        if j > 0:
            beside = self.numbers_of(frame.step, frame.values[:, 1:-1, j])
            frame.values[:, 1:-1, j + 1] = self.values_of(frame.step, beside + d)
            return
        last = np.zeros(3, "i8")
        for i in range(self.along):
            value = self.values_of(frame.step, last + d[:, i])
            frame.values[:, i + 1, 1] = value
            last = self.numbers_of(frame.step, value)

    def values_from(self, step, r, p, residuals):
        if step > 0:
            shifted = p + WHOLE_FROM
            c = shifted.view("i4").astype("i8") - int(WHOLE_FROM.view("i4"))
            upwards = p < shifted - WHOLE_FROM
            return self.values_of(step, r.astype("i8") + c + np.where(upwards, residuals, -residuals))
        t = r + p
        t = np.where(np.isfinite(t), t, F(0))
        return self.values_of(step, self.numbers_of(step, t) + residuals)

    @staticmethod
    def numbers_of(step, values):
        return (values if step > 0 else ordered(values.view("i4"))).astype("i8")

    @staticmethod
    def values_of(step, numbers):
        numbers = wrapped(numbers)
        if step > 0:
            return np.clip(numbers, -LARGEST_NUMBER, LARGEST_NUMBER).astype("f4")
        return ordered(np.clip(numbers, ~LARGEST_ORDINAL, LARGEST_ORDINAL)).view("f4")


class Shifted:
    """Calls give column j of a field, seen from (di, dj) away."""

    def __init__(self, field, j):
        self.field, self.j = field, j

    def __call__(self, di, dj):
        rows = self.field.shape[1] - 2
        return self.field[:, 1 + di : 1 + di + rows, 1 + self.j + dj]


def continue_over_ends(field):
    """Section 8.2, along the second axis."""
    field[:, 0] = (field[:, 1] + field[:, 1]) - field[:, 2]
    field[:, -1] = (field[:, -2] + field[:, -2]) - field[:, -3]


def wrapped(numbers):
    return numbers.astype("u8").astype("u4").view("i4")


def ordered(bits):
    return np.where(bits < 0, bits ^ np.int32(0x7FFFFFFF), bits)


# Section 8.5.

FORMAT = pathlib.Path(__file__).parents[2] / "libribbon/recording/FORMAT.md"


def dictionaries():
    """Of the three runs, with the trees as the document lists them."""
    trees = []
    for line in FORMAT.read_text().split("### 8.5")[1].splitlines():
        if line.startswith("    # "):
            trees.append(b"")
        elif line.startswith("    "):
            trees[-1] += bytes.fromhex(line)
    start = bytes.fromhex("37A430EC01000000")
    end = bytes.fromhex("103F" * 3) + struct.pack("<5I", 1, 4, 8, 0, 0)
    return [start + tree + end for tree in trees]


DICTIONARIES = dictionaries()
PLANES = np.array([0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 13, 19, 28])


def take_run(content, kind, size):
    if size == 0:
        return np.zeros(0, "u1")
    (packed,) = struct.unpack("<I", content.bytes(4))
    if packed == 0:
        run = content.bytes(size)
    else:
        run = zstd_content(b"\x28\xb5\x2f\xfd" + content.bytes(packed), size, DICTIONARIES[kind])
    return np.frombuffer(run, "u1")


def parts(run, bits):
    """What a byte holds several of, unsigned."""
    return (run[:, None] >> np.arange(0, 8, bits, dtype="u1") & np.uint8(2**bits - 1)).reshape(-1)


def take_residuals(content, along, across):
    """By component, column and row."""
    count = 3 * across * -(-along // BLOCK)
    modes = parts(take_run(content, 0, -(-count // 2)), 4)[:count]
    residuals = np.zeros((count, BLOCK), "i8")
    for mode, bits in ((1, 2), (2, 4)):
        chosen = modes == mode if mode < 2 else modes >= 2
        run = take_run(content, mode, BLOCK * bits // 8 * np.count_nonzero(chosen))
        symbols = parts(run, bits).astype("i8")
        symbols -= (symbols >> (bits - 1)) << bits
        residuals[chosen] = symbols.reshape(-1, BLOCK)
    add_planes(residuals, PLANES[modes], content.rest())
    return residuals.reshape(3, across, -1)[:, :, :along]


def add_planes(residuals, counts, data):
    if len(data) != 2 * int(counts.sum()):
        raise Damaged("a frame's geometry has another length than it needs")
    planes = np.unpackbits(np.frombuffer(data, "u1"), bitorder="little").reshape(-1, BLOCK)
    at = 0
    for k in np.flatnonzero(counts):
        for plane in planes[at : at + counts[k]]:
            residuals[k] = 2 * residuals[k] + plane
        at += counts[k]
