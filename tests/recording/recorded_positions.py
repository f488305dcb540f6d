"""Decodes frames by section 8 of libribbon/recording/FORMAT.md; part of read_recording.py."""

import pathlib
import struct

import numpy as np

from zstd_frames import zstd_content

PLAIN, QUANTISED = 0, 1
LARGEST_NUMBER = 2**24
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

    def varint(self):
        value = shift = 0
        while True:
            byte = self.bytes(1)[0]
            value |= (byte & 0x7F) << shift
            shift += 7
            if value >= 2**32 or shift > 28 and byte >= 0x80:
                raise Damaged("a number is larger than 32 bits")
            if byte < 0x80:
                return value

    def rest(self):
        return self.bytes(len(self.data) - self.at)


def zigzag(number):
    return (number >> 1) ^ -(number & 1)


class Frame:
    """A decoded frame: values and motion by component, row and column, with one cell more on each side;
    or only the coordinates."""

    def __init__(self, along=0, across=0, coordinates=None):
        self.coordinates = coordinates
        self.values = np.zeros((3, along + 2, across + 2), "f4")
        self.motion = np.zeros_like(self.values)

    @property
    def plain(self):
        return self.coordinates is not None


class PositionCodec:
    def __init__(self, header):
        self.along, self.across = header.along, header.across
        self.step = F(header.quantisation_step_m)

    def coordinates(self, frame):
        """3 x particles, f32."""
        if frame.plain:
            return frame.coordinates
        values = frame.values[:, 1:-1, 1:-1]
        return (values * self.step if self.step > 0 else values).reshape(3, -1)

    def decode(self, encoding, geometry, references):
        if encoding == PLAIN:
            content = zstd_content(geometry, 12 * self.along * self.across)
            return Frame(coordinates=np.frombuffer(content, "<f4").reshape(3, -1))
        if encoding != QUANTISED:
            raise Damaged(f"encoding {encoding} is not known")
        counting = []
        for reference in references:
            if reference.plain:
                break
            counting.append(reference)
        with np.errstate(over="ignore", invalid="ignore"):
            return self.decode_quantised(Content(geometry), counting)

    def decode_quantised(self, content, references):
        """Section 8.3."""
        frame = Frame(self.along, self.across)
        if references:
            weights = take_weights(content)
        residuals = take_residuals(content, self.along, self.across)
        for j in range(self.across):
            if references:
                self.decode_column(frame, j, residuals[:, j], weights[min(j, 1)], references)
            else:
                self.decode_intra_column(frame, j, residuals[:, j])
            continue_over_ends(frame.values[:, :, j + 1])
            continue_over_ends(frame.motion[:, :, j + 1])
        continue_over_ends(frame.motion.swapaxes(1, 2)[:, :, 1:-1])
        return frame

    # Section 8.4.

    def decode_column(self, frame, j, residuals, weights, references):
        w, n = weights
        first = references[0]
        v, m = Shifted(first.values, j), Shifted(first.motion, j)
        o = Shifted(references[1].motion if len(references) > 1 else np.zeros_like(first.motion), j)
        line = (w[0] * m(0, 0) + w[1] * m(-1, 0)) + w[2] * m(1, 0)
        sides = w[3] * m(0, -1) + w[4] * m(0, 1)
        bend = (v(-1, 0) + v(1, 0)) - (v(0, 0) + v(0, 0))
        p = (line + sides) + (w[5] * o(0, 0) + w[6] * bend)
        if j > 0:
            q = Shifted(frame.motion, j)
            p = p + ((n[0] * q(-1, -1) + n[1] * q(0, -1)) + n[2] * q(1, -1))
        r = v(0, 0)
        values = self.values_from(r, p, residuals)
        frame.values[:, 1:-1, j + 1] = values
        frame.motion[:, 1:-1, j + 1] = values - r

    def decode_intra_column(self, frame, j, residuals):
        d = np.cumsum(residuals, axis=1)
        frame.numbers = np.cumsum(d, axis=1) if j == 0 else frame.numbers + d
        frame.values[:, 1:-1, j + 1] = self.values_of(frame.numbers)

    def values_from(self, r, p, residuals):
        if self.step > 0:
            shifted = p + WHOLE_FROM
            c = shifted.view("i4").astype("i8") - int(WHOLE_FROM.view("i4"))
            upwards = p < shifted - WHOLE_FROM
            return self.values_of(r.astype("i8") + c + np.where(upwards, residuals, -residuals))
        t = r + p
        t = np.where(np.isfinite(t), t, F(0))
        return self.values_of(ordered(t.view("i4")).astype("i8") + residuals)

    def values_of(self, numbers):
        numbers = wrapped(numbers)
        if self.step > 0:
            return np.clip(numbers, -LARGEST_NUMBER, LARGEST_NUMBER).astype("f4")
        return ordered(numbers).view("f4")


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


def take_weights(content):
    """Those of column 0 and those of all others, each w and n."""
    shift = content.bytes(1)[0]
    if shift > 30:
        raise Damaged("weights are shifted too far")

    def take(count):
        return [F(zigzag(content.varint())) * F(2.0**-shift) for _ in range(count)]

    first = take(7)
    others = take(7)
    return (first, []), (others, take(3))


# Section 8.5.

FORMAT = pathlib.Path(__file__).parents[2] / "libribbon/recording/FORMAT.md"


def dictionaries():
    """Of the four runs, with the trees as the document lists them."""
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
LOW_BITS = np.array([0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 24])


def take_run(content, kind, size):
    if size == 0:
        return np.zeros(0, "u1")
    packed = content.varint()
    if packed == 0:
        run = content.bytes(size)
    else:
        frame = b"\x28\xb5\x2f\xfd\x00" + content.bytes(packed)
        run = zstd_content(frame, size, DICTIONARIES[kind])
    return np.frombuffer(run, "u1")


def parts(run, bits):
    """What a byte holds several of, unsigned."""
    return (run[:, None] >> np.arange(0, 8, bits, dtype="u1") & np.uint8(2**bits - 1)).reshape(-1)


def take_residuals(content, along, across):
    """By component, column and row."""
    count = 3 * across * -(-along // BLOCK)
    modes = parts(take_run(content, 0, -(-count // 2)), 4)[:count]
    residuals = np.zeros((count, BLOCK), "i8")
    for mode, in_a_byte in ((1, 4), (2, 2), (3, 1)):
        chosen = modes == mode if mode < 3 else modes >= 3
        run = take_run(content, mode, BLOCK // in_a_byte * np.count_nonzero(chosen))
        bits = 8 // in_a_byte
        symbols = parts(run, bits).astype("i8")
        symbols -= (symbols >> (bits - 1)) << bits
        residuals[chosen] = symbols.reshape(-1, BLOCK)
    add_low_bits(residuals, LOW_BITS[modes], content.rest())
    return residuals.reshape(3, across, -1)[:, :, :along]


def add_low_bits(residuals, counts, data):
    bits = np.unpackbits(np.frombuffer(data, "u1"), bitorder="little").astype("i8")
    if len(bits) != BLOCK * int(counts.sum()):
        raise Damaged("a frame's geometry has another length than it needs")
    at = 0
    for k in np.flatnonzero(counts):
        count = int(counts[k])
        low = bits[at : at + BLOCK * count]
        residuals[k] = (residuals[k] << count) + low.reshape(BLOCK, count) @ (1 << np.arange(count))
        at += BLOCK * count
