"""Decodes frames by section 8 of libribbon/recording/FORMAT.md; part of read_recording.py."""

import struct

import numpy as np

from zstd_frames import zstd_content

PLAIN, QUANTISED = 0, 1
INTRA, P_FRAME, B_FRAME = 0, 1, 2
PLANE_ORDER = (0, 3, 1, 2)
BLOCK_RESIDUALS = 64
BLOCK_COLUMNS = 4
LARGEST_NUMBER = 2**24
F = np.float32


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
    """A decoded frame: values by component, row and column, or only the coordinates."""

    def __init__(self, values=None, coordinates=None):
        self.values, self.coordinates = values, coordinates

    @property
    def plain(self):
        return self.coordinates is not None


class PositionCodec:
    def __init__(self, header):
        self.header = header
        self.along, self.across = header.along, header.across
        self.step = F(header.quantisation_step_m)
        unit = float(self.step) if self.step > 0 else 1.0
        rest_along = header.length_m / (self.along - 1) / unit
        rest_across = header.width_m / (self.across - 1) / unit
        self.over_rest = [F(1) / F(length * length) for length in (rest_along, rest_across)]
        self.planes = [plane_of(self.along, self.across, plane) for plane in PLANE_ORDER]
        self.blocks = [b for plane in PLANE_ORDER for b in blocks_of(self.along, self.across, plane)]

    def coordinates(self, frame):
        """3 x particles, f32."""
        if frame.plain:
            return frame.coordinates
        scaled = frame.values * self.step if self.step > 0 else frame.values
        return scaled.reshape(3, -1)

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
        return self.decode_quantised(Content(geometry), counting)

    def decode_quantised(self, content, references):
        """Section 8.3."""
        prediction = content.bytes(1)[0]
        if (prediction == INTRA) != (not references) or prediction > B_FRAME:
            raise Damaged("a prediction does not go with the references")
        if prediction == INTRA:
            weights = [F(w) / F(64) for w in struct.unpack("4b", content.bytes(4))]
        else:
            weights = take_weights(content, prediction)
        residual_grid = np.zeros((3, self.along, self.across), "i8")
        take_residuals(content, self.header.entropy_tables, self.blocks, residual_grid)
        frame = Frame(np.zeros((3, self.along, self.across), "f4"))
        with np.errstate(over="ignore", invalid="ignore"):
            if prediction == INTRA:
                self.rebuild_intra(frame, residual_grid, weights)
            else:
                self.rebuild_inter(frame, residual_grid, weights, prediction, references)
        return frame

    # Section 8.4.

    def set_numbers(self, frame, where, predicted, residuals, reference=None):
        """where: an index into the grid behind the component."""
        where = (slice(None), *where)
        odd = residuals % 2 == 1
        half = (residuals + 1) // 2
        if self.step > 0:
            m = np.where(np.isnan(predicted), F(-(2.0**30)), predicted)
            m = np.clip(m, F(-(2.0**30)), F(2.0**30))
            whole = np.trunc(m).astype("i8")
            fraction = m - whole.astype("f4")
            nearest = whole + (fraction >= 0.5) - (fraction < -0.5)
            below = ((fraction >= -0.5) & (fraction < 0)) | (fraction >= 0.5)
            offset = np.where(odd != below, half, -half)
            start = 0 if reference is None else reference.values[where].astype("i8")
            numbers = np.clip(wrapped(start + nearest + offset), -LARGEST_NUMBER, LARGEST_NUMBER)
            frame.values[where] = numbers.astype("f4")
        else:
            v = (F(0) if reference is None else reference.values[where]) + predicted
            v = np.where(np.isfinite(v), v, F(0))
            numbers = wrapped(ordered(v.view("i4")).astype("i8") + np.where(odd, half, -half))
            frame.values[where] = ordered(numbers).view("f4")

    # Section 8.5, intra.

    def rebuild_intra(self, frame, residuals, weights):
        self.rebuild_coarse(frame, residuals)
        _, outer3, pairs, outer = weights  # the first are plane 3's pairs, which has none
        i, j = self.planes[1]
        x = self.continued(frame, [0])
        middle = ((x(i - 1, j - 1) + x(i - 1, j + 1)) + (x(i + 1, j - 1) + x(i + 1, j + 1))) * F(0.25)
        far = ((x(i - 3, j - 1) + x(i - 3, j + 1)) + (x(i + 3, j - 1) + x(i + 3, j + 1))) * F(0.25)
        self.set_numbers(frame, (i, j), middle + outer3 * (far - middle), residuals[:, i, j])
        x = self.continued(frame, [0, 3])
        for i, j in self.planes[2:]:
            along = (x(i - 1, j) + x(i + 1, j)) * F(0.5)
            across = (x(i, j - 1) + x(i, j + 1)) * F(0.5)
            middle = (along + across) * F(0.5)
            far = ((x(i - 2, j - 1) + x(i - 2, j + 1)) + (x(i + 2, j - 1) + x(i + 2, j + 1))) * F(0.25)
            m = (middle + pairs * (along - across)) + outer * (far - middle)
            self.set_numbers(frame, (i, j), m, residuals[:, i, j])

    def rebuild_coarse(self, frame, residuals):
        """Plane 0, one particle after the other, row by row: each needs only what lies before it."""
        plane = frame.values[:, ::2, ::2]
        rows, columns = plane.shape[1:]
        for a in range(rows):
            if a == 1:
                upper = plane[:, 0, :].copy()
            elif a > 1:
                upper = line(plane[:, a - 1, :], plane[:, a - 2, :])
            for b in range(columns):
                if a == 0:
                    m = line_in_row(plane, b)
                elif b == 0:
                    m = upper[:, 0]
                else:
                    m = upper[:, b] + (plane[:, a, b - 1] - upper[:, b - 1])
                self.set_numbers(frame, (2 * a, 2 * b), m, residuals[:, 2 * a, 2 * b])

    def continued(self, frame, planes):
        """x(i, j) for particles of these planes and beyond their borders."""
        padded = {}
        for plane in planes:
            cells = frame.values[:, plane // 2 :: 2, plane % 2 :: 2]
            padded[plane] = extended(extended(cells, 1, 2), 2, 1)

        def values(i, j):
            plane = 2 * (i[0] % 2) + j[0] % 2
            return padded[plane][:, i // 2 + 2, j // 2 + 1]

        return values

    # Section 8.5, P and B.

    def rebuild_inter(self, frame, residuals, weights, prediction, references):
        first = references[0]
        terms = self.past_terms(prediction, references)
        self.rebuild_coarse_inter(frame, residuals, weights[:2], terms, first)
        motion = self.nearest(frame.values - first.values, [0])
        near, past = weights[2]
        i, j = self.planes[1]
        around = [(i - 1, j - 1), (i - 1, j + 1), (i + 1, j - 1), (i + 1, j + 1)]
        m = terms(past)[:, i, j] + paired(near, [motion(*cell) for cell in around])
        self.set_numbers(frame, (i, j), m, residuals[:, i, j], first)
        motion = self.nearest(frame.values - first.values, [0, 3])
        near, past = weights[3]
        expected = terms(past)
        for i, j in self.planes[2:]:
            around = [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]
            m = expected[:, i, j] + paired(near, [motion(*cell) for cell in around])
            self.set_numbers(frame, (i, j), m, residuals[:, i, j], first)

    def rebuild_coarse_inter(self, frame, residuals, weights, terms, first):
        """Stages 0 and 1: plane 0, column after column."""
        (_, past), (near, next_past) = weights
        expected = terms(past)[:, ::2, ::2]
        next_expected = terms(next_past)[:, ::2, ::2]
        rows = np.arange(expected.shape[1])
        for b in range(expected.shape[2]):
            m = expected[:, :, b]
            if b > 0:
                moved = frame.values[:, ::2, 2 * b - 2] - first.values[:, ::2, 2 * b - 2]
                before, after = np.maximum(rows - 1, 0), np.minimum(rows + 1, rows[-1])
                taps = near[0] * moved[:, before] + near[1] * moved
                m = next_expected[:, :, b] + (taps + near[2] * moved[:, after])
            where = (2 * rows, np.full_like(rows, 2 * b))
            self.set_numbers(frame, where, m, residuals[:, ::2, 2 * b], first)

    def nearest(self, motion, planes):
        """q(i, j) for particles of these planes; beyond a plane's border that of its nearest cell."""
        cells = {plane: motion[:, plane // 2 :: 2, plane % 2 :: 2] for plane in planes}

        def values(i, j):
            plane = cells[2 * (i[0] % 2) + j[0] % 2]
            return plane[
                :, np.clip(i // 2, 0, plane.shape[1] - 1), np.clip(j // 2, 0, plane.shape[2] - 1)
            ]

        return values

    def past_terms(self, prediction, references):
        """A function of the weights c0, c1, ...: past(i, j), 3 x along x across."""
        values = [extended(extended(r.values, 1, 1), 2, 1) for r in references]
        instead = [None, 0, 1 if prediction == P_FRAME else 0, 1]
        for k in range(len(values), 4):
            values.append(values[instead[k]])
        a, b, c, d = values
        p, second, v = Shifted(a), Shifted(b), Shifted(a - b)
        w = Shifted(b - c if prediction == P_FRAME else a - c)
        u = Shifted(d - b)

        def past(c):
            line = (c[0] * v(0, 0) + c[1] * v(-1, 0)) + c[2] * v(1, 0)
            sides = (c[3] * v(0, -1) + c[4] * v(0, 1)) + c[5] * w(0, 0)
            along = self.springs(p, (1, 0), c[6], c[8])
            across = self.springs(p, (0, 1), c[7], c[9])
            sum_of_all = (line + sides) + (along + across)
            if prediction == P_FRAME:
                return sum_of_all
            second_along = self.springs(second, (1, 0), F(0), c[11])
            second_across = self.springs(second, (0, 1), F(0), c[12])
            return sum_of_all + (c[10] * u(0, 0) + (second_along + second_across))

        return past

    def springs(self, p, step, bend, pull):
        """What the edges to the next and from the last particle in a direction add."""
        di, dj = step
        over_rest = self.over_rest[0 if di else 1]
        at_rest, stretched = bend - pull, pull * over_rest

        def weighed(edge):
            squared = (edge[0] * edge[0] + edge[1] * edge[1]) + edge[2] * edge[2]
            return (at_rest + stretched * squared) * edge

        return weighed(p(di, dj) - p(0, 0)) - weighed(p(0, 0) - p(-di, -dj))


class Shifted:
    """Calls give a field with one cell more on each side, seen from (di, dj) away."""

    def __init__(self, field):
        self.field = field

    def __call__(self, di, dj):
        rows, columns = self.field.shape[1] - 2, self.field.shape[2] - 2
        return self.field[:, 1 + di : 1 + di + rows, 1 + dj : 1 + dj + columns]


def plane_of(along, across, plane):
    """Rows and columns of the particles of a plane, row by row."""
    i, j = np.mgrid[plane // 2 : along : 2, plane % 2 : across : 2]
    return i.ravel(), j.ravel()


def wrapped(numbers):
    return numbers.astype("u8").astype("u4").view("i4")


def ordered(bits):
    return np.where(bits < 0, bits ^ np.int32(0x7FFFFFFF), bits)


def line(p, q):
    return (p + p) - q


def line_in_row(plane, b):
    if b == 0:
        return np.zeros(3, "f4")
    return plane[:, 0, 0].copy() if b == 1 else line(plane[:, 0, b - 1], plane[:, 0, b - 2])


def extended(field, axis, count):
    """The field continued in straight lines, `count` cells beyond each end of the axis."""
    cells = [field.take([k], axis=axis) for k in range(field.shape[axis])]
    for _ in range(count):
        first, last = cells[0], cells[-1]
        before = line(first, cells[1] if len(cells) > 1 else first)
        after = line(last, cells[-2] if len(cells) > 1 else last)
        cells = [before, *cells, after]
    return np.concatenate(cells, axis=axis)


def paired(weights, terms):
    n0, n1, n2, n3 = (weight * term for weight, term in zip(weights, terms, strict=True))
    return (n0 + n1) + (n2 + n3)


def take_weights(content, prediction):
    """Section 8.5, the last paragraph: near and past of each stage."""
    shift = content.bytes(1)[0]
    if shift > 30:
        raise Damaged("weights are shifted too far")

    def take(count):
        return [F(zigzag(content.varint())) * F(2.0**-shift) for _ in range(count)]

    past = 10 if prediction == P_FRAME else 13
    return [(take(near), take(past)) for near in (0, 3, 4, 4)]


# Section 8.6.


# Symbols in a byte and the escape of modes 1 to 7.
MODES = [(4, 3), (2, 5), (2, 7), (2, 11), (1, 31), (1, 63), (1, 127)]


def mode_of(number):
    """Symbols in a byte, escape, low bits, run."""
    per_byte, escape = MODES[min(number, 7) - 1]
    return per_byte, escape, max(0, number - 7), min(number, 7)


def blocks_of(along, across, plane):
    """Rows and columns of the ribbon that the blocks of a plane lie in, by column of the plane."""
    rows, columns = np.arange(plane // 2, along, 2), np.arange(plane % 2, across, 2)
    for b in range(0, len(columns), BLOCK_COLUMNS):
        chosen = columns[b : b + BLOCK_COLUMNS]
        length = BLOCK_RESIDUALS // {1: 1, 2: 2, 3: 4, 4: 4}[len(chosen)]
        for a in range(0, len(rows), length):
            yield [(rows[a : a + length], np.full(len(rows[a : a + length]), j)) for j in chosen]


def take_run(content, tables, run, symbols):
    if symbols == 0:
        return b""
    size = content.varint()
    if size == 0:
        return content.bytes(symbols)
    table = tables[run] if run < len(tables) else b""
    return zstd_content(b"\x28\xb5\x2f\xfd\x00" + content.bytes(size), symbols, table)


def take_modes(content, tables, blocks):
    """The mode of each block, by component."""
    steps = take_run(content, tables, 0, 3 * blocks)
    for component in range(3):
        mode, modes = 0, []
        for step in steps[component * blocks : (component + 1) * blocks]:
            mode += zigzag(step)
            if not 0 <= mode <= 31:
                raise Damaged(f"there is no mode {mode}")
            modes.append(mode)
        yield modes


def take_residuals(content, tables, blocks, residual_grid):
    """Puts the residuals of each component where they belong in the grid."""
    modes = list(take_modes(content, tables, len(blocks)))
    run_bytes = [0] * 8
    for component in modes:
        for number, block in zip(component, blocks, strict=True):
            if number > 0:
                per_byte, _, _, run = mode_of(number)
                run_bytes[run] += sum(-(-len(i) // per_byte) for i, _ in block)
    runs = [Content(take_run(content, tables, run, run_bytes[run])) for run in range(1, 8)]
    for component, component_modes in enumerate(modes):
        for number, block in zip(component_modes, blocks, strict=True):
            for i, j in block:
                residual_grid[component, i, j] = take_symbols(runs, number, len(i), content)
    add_low_bits(residual_grid, modes, blocks, content.rest())


def take_symbols(runs, number, count, content):
    """The residuals of a column of a block without low bits; takes escapes from the content."""
    if number == 0:
        return [0] * count
    per_byte, escape, _, run = mode_of(number)
    bits = 8 // per_byte
    data = runs[run - 1].bytes(-(-count // per_byte))
    high = [(data[k // per_byte] >> (k % per_byte * bits)) & ((1 << bits) - 1) for k in range(count)]
    return [symbol if symbol < escape else symbol + content.varint() for symbol in high]


def add_low_bits(residual_grid, modes, blocks, data):
    bits, at = int.from_bytes(data, "little"), 0
    for component, component_modes in enumerate(modes):
        for number, block in zip(component_modes, blocks, strict=True):
            low_bits = mode_of(number)[2] if number > 0 else 0
            if low_bits == 0:
                continue
            for column in block:
                for i, j in zip(*column, strict=True):
                    low = (bits >> at) & ((1 << low_bits) - 1)
                    high = residual_grid[component, i, j]
                    residual_grid[component, i, j] = (high << low_bits) | low
                    at += low_bits
    if len(data) != (at + 7) // 8:
        raise Damaged("a frame's geometry has another length than it needs")
