"""Decodes frames by section 8 of libribbon/recording/FORMAT.md; part of read_recording.py."""

import struct

import numpy as np

from zstd_frames import zstd_content

PLAIN, LATTICE = 0, 1
WITHIN, FORWARD, BETWEEN = 0, 1, 2
PLANE_ORDER = (0, 3, 1, 2)
BLOCK_RANKS = 64
F = np.float32


class Damaged(Exception):
    """Bytes that are whole, and yet are not what the document says."""


class Content:
    """Takes what a frame's geometry is made of off its front."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def bytes(self, count):
        if count > len(self.data) - self.at:
            raise Damaged("a frame's geometry ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def varint(self):
        value = shift = 0
        while True:
            byte = self.bytes(1)[0]
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def rest(self):
        return self.bytes(len(self.data) - self.at)


def zigzag(number):
    return (number >> 1) ^ -(number & 1)


class Frame:
    """A decoded frame: numbers and values by component, row and column, or only the coordinates."""

    def __init__(self, numbers=None, values=None, coordinates=None):
        self.numbers, self.values, self.coordinates = numbers, values, coordinates

    @property
    def plain(self):
        return self.coordinates is not None


class LatticeCodec:
    def __init__(self, header):
        self.header = header
        self.along, self.across = header.along, header.across
        self.step = F(header.lattice_step_m)
        self.places = [plane_of(self.along, self.across, plane) for plane in PLANE_ORDER]

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
        if encoding != LATTICE:
            raise Damaged(f"encoding {encoding} is not known")
        counting = []
        for reference in references:
            if reference.plain:
                break
            counting.append(reference)
        return self.decode_lattice(Content(geometry), counting)

    def decode_lattice(self, content, references):
        """Section 8.3."""
        prediction = content.bytes(1)[0]
        if (prediction == WITHIN) != (not references) or prediction > BETWEEN:
            raise Damaged("a prediction does not go with the references")
        if prediction == WITHIN:
            weights = [F(w) / F(64) for w in struct.unpack("4b", content.bytes(4))]
        else:
            weights = take_weights(content, prediction)
        ranks = take_ranks(content, self.header.entropy_tables, [len(i) for i, _ in self.places])
        frame = Frame(
            np.zeros((3, self.along, self.across), "i4"), np.zeros((3, self.along, self.across), "f4")
        )
        rank_grid = np.zeros((3, self.along, self.across), "i8")
        for component in range(3):
            begin = 0
            for i, j in self.places:
                rank_grid[component, i, j] = ranks[component][begin : begin + len(i)]
                begin += len(i)
        with np.errstate(over="ignore", invalid="ignore"):
            if prediction == WITHIN:
                self.rebuild_within(frame, rank_grid, weights)
            else:
                self.rebuild_moved(frame, rank_grid, weights, prediction, references)
        return frame

    # Section 8.4.

    def set_numbers(self, frame, where, predicted, ranks, reference=None):
        """where: an index into the grid behind the component."""
        where = (slice(None), *where)
        odd = ranks % 2 == 1
        half = (ranks + 1) // 2
        if self.step > 0:
            m = np.where(np.isnan(predicted), F(-(2.0**30)), predicted)
            m = np.clip(m, F(-(2.0**30)), F(2.0**30))
            whole = np.trunc(m).astype("i8")
            fraction = m - whole.astype("f4")
            nearest = whole + (fraction >= 0.5) - (fraction < -0.5)
            below = ((fraction >= -0.5) & (fraction < 0)) | (fraction >= 0.5)
            offset = np.where(odd != below, half, -half)
            start = 0 if reference is None else reference.numbers[where].astype("i8")
            numbers = wrapped(start + nearest + offset)
            frame.values[where] = numbers.astype("f4")
        else:
            v = predicted if reference is None else reference.values[where] + predicted
            v = np.where(np.isfinite(v), v, F(0))
            numbers = wrapped(ordered(v.view("i4")).astype("i8") + np.where(odd, half, -half))
            frame.values[where] = ordered(numbers).view("f4")
        frame.numbers[where] = numbers

    # Section 8.5, within.

    def rebuild_within(self, frame, ranks, weights):
        self.rebuild_coarse(frame, ranks)
        pairs3, outer3, pairs, outer = weights
        del pairs3  # plane 3 has none
        i, j = self.places[1]
        x = self.continued(frame, [0])
        middle = ((x(i - 1, j - 1) + x(i - 1, j + 1)) + (x(i + 1, j - 1) + x(i + 1, j + 1))) * F(0.25)
        far = ((x(i - 3, j - 1) + x(i - 3, j + 1)) + (x(i + 3, j - 1) + x(i + 3, j + 1))) * F(0.25)
        self.set_numbers(frame, (i, j), middle + outer3 * (far - middle), ranks[:, i, j])
        x = self.continued(frame, [0, 3])
        for i, j in self.places[2:]:
            along = (x(i - 1, j) + x(i + 1, j)) * F(0.5)
            across = (x(i, j - 1) + x(i, j + 1)) * F(0.5)
            middle = (along + across) * F(0.5)
            far = ((x(i - 2, j - 1) + x(i - 2, j + 1)) + (x(i + 2, j - 1) + x(i + 2, j + 1))) * F(0.25)
            m = (middle + pairs * (along - across)) + outer * (far - middle)
            self.set_numbers(frame, (i, j), m, ranks[:, i, j])

    def rebuild_coarse(self, frame, ranks):
        """Plane 0, one particle after the other."""
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
                self.set_numbers(frame, (2 * a, 2 * b), m, ranks[:, 2 * a, 2 * b])

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

    # Section 8.5, forward and between.

    def rebuild_moved(self, frame, ranks, weights, prediction, references):
        coarse, near1, near2, near3, past3, near4, past4 = weights
        terms = self.past_terms(prediction, references)
        first = references[0]
        self.rebuild_coarse_moved(frame, ranks, weighted(coarse, terms), (near1, near2), first)
        motion = self.nearest(frame.values - first.values, [0])
        i, j = self.places[1]
        around = [(i - 1, j - 1), (i - 1, j + 1), (i + 1, j - 1), (i + 1, j + 1)]
        m = summed(weighted(past3, terms)[:, i, j], near3, [motion(*place) for place in around])
        self.set_numbers(frame, (i, j), m, ranks[:, i, j], first)
        motion = self.nearest(frame.values - first.values, [0, 3])
        past = weighted(past4, terms)
        for i, j in self.places[2:]:
            around = [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]
            m = summed(past[:, i, j], near4, [motion(*place) for place in around])
            self.set_numbers(frame, (i, j), m, ranks[:, i, j], first)

    def rebuild_coarse_moved(self, frame, ranks, past, nears, first):
        """Stages 0 to 2: plane 0."""
        rows, columns = past[:, ::2, ::2].shape[1:]
        missed = np.zeros((3, rows + 2, columns + 2), "f4")  # one cell more on each side
        a, b = (x.ravel() for x in np.mgrid[:rows, :columns])
        diagonal = [(-1, -1), (-1, 1), (1, -1), (1, 1)]
        straight = [(-1, 0), (1, 0), (0, -1), (0, 1)]
        stages = [
            ((a % 2 == 0) & (b % 2 == 0), [], []),
            ((a % 2 == 1) & (b % 2 == 1), nears[0], diagonal),
            (a % 2 != b % 2, nears[1], straight),
        ]
        for chosen, near, around in stages:
            i, j = a[chosen], b[chosen]
            if len(i) == 0:
                continue
            expected = past[:, 2 * i, 2 * j]
            m = summed(expected, near, [missed[:, i + 1 + di, j + 1 + dj] for di, dj in around])
            self.set_numbers(frame, (2 * i, 2 * j), m, ranks[:, 2 * i, 2 * j], first)
            moved = frame.values[:, 2 * i, 2 * j] - first.values[:, 2 * i, 2 * j]
            missed[:, i + 1, j + 1] = moved - expected

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
        """What c0, c1, ... weigh, each 3 x along x across."""
        values = [extended(extended(r.values, 1, 1), 2, 1) for r in references]
        values += [None] * (4 - len(values))
        first, second, third, fourth = values

        def difference(to, origin):
            return np.zeros_like(first) if to is None or origin is None else to - origin

        v = Shifted(difference(first, second))
        w = Shifted(difference(second, third) if prediction == FORWARD else difference(first, third))
        p = Shifted(first)
        twice = p(0, 0) + p(0, 0)
        terms = [v(0, 0), v(-1, 0), v(1, 0), v(0, -1), v(0, 1)]
        terms.append((v(-1, -1) + v(-1, 1)) + (v(1, -1) + v(1, 1)))
        terms.append(w(0, 0))
        terms.append((p(-1, 0) + p(1, 0)) - twice)
        terms.append((p(0, -1) + p(0, 1)) - twice)
        terms.append(((p(-1, -1) + p(-1, 1)) - twice) + ((p(1, -1) + p(1, 1)) - twice))
        terms += self.pulls(references[0])
        if prediction == BETWEEN:
            terms.append(Shifted(difference(fourth, second))(0, 0))
            terms += self.pulls(references[1] if len(references) > 1 else references[0])
        return terms

    def pulls(self, frame):
        """S and T of a frame."""
        unit = float(self.step) if self.step > 0 else 1.0
        lengths = [self.header.length_m, self.header.width_m]
        for axis, length in enumerate(lengths, 1):
            natural = length / (frame.values.shape[axis] - 1) / unit
            over_rest = F(1) / F(natural * natural)
            edge = np.diff(frame.values, axis=axis)
            squared = (edge[0] * edge[0] + edge[1] * edge[1]) + edge[2] * edge[2]
            pull = edge * (squared * over_rest - F(1))
            none = np.zeros_like(frame.values.take([0], axis=axis))
            yield np.diff(np.concatenate([none, pull, none], axis=axis), axis=axis)


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


def sum_of(weights, terms):
    total = weights[0] * terms[0]
    for weight, term in zip(weights[1:], terms[1:], strict=True):
        total = total + weight * term
    return total


def weighted(weights, terms):
    motion, more_motion, bend, pull = (
        sum_of(weights[begin:end], terms[begin:end]) for begin, end in [(0, 4), (4, 7), (7, 10), (10, None)]
    )
    return (motion + more_motion) + (bend + pull)


def summed(start, weights, terms):
    if len(weights) == 0:
        return start
    return start + (sum_of(weights[:2], terms[:2]) + sum_of(weights[2:], terms[2:]))


def take_weights(content, prediction):
    """Section 8.5, the last paragraph: past of stages 0 to 2, near 1, near 2, near and past of 3, of 4."""
    shift = content.bytes(1)[0]
    if shift > 30:
        raise Damaged("weights are shifted too far")
    past = 12 if prediction == FORWARD else 15
    return [
        [F(zigzag(content.varint())) * F(2.0**-shift) for _ in range(count)]
        for count in (past, 4, 4, 4, past, 4, past)
    ]


# Section 8.6.


def form_of(number):
    """Symbols in a byte, low bits, run."""
    if number <= 4:
        return (4 if number <= 2 else 2), 0, number
    return 1, max(0, number - 7), min(number, 7)


def take_run(content, tables, run, symbols):
    if symbols == 0:
        return b""
    size = content.varint()
    if size == 0:
        return content.bytes(symbols)
    table = tables[run] if run < len(tables) else b""
    return zstd_content(b"\x28\xb5\x2f\xfd\x00" + content.bytes(size), symbols, table)


def take_forms(content, tables, blocks):
    """The form of each block, by component."""
    steps = take_run(content, tables, 0, 3 * blocks)
    for component in range(3):
        form, forms = 0, []
        for step in steps[component * blocks : (component + 1) * blocks]:
            form += zigzag(step)
            if not 0 <= form <= 31:
                raise Damaged(f"there is no form {form}")
            forms.append(form)
        yield forms


def take_ranks(content, tables, plane_sizes):
    """The ranks of each component in the order of the planes."""
    sizes = [min(BLOCK_RANKS, n - k) for n in plane_sizes for k in range(0, n, BLOCK_RANKS)]
    forms = list(take_forms(content, tables, len(sizes)))
    run_bytes = [0] * 8
    for component in forms:
        for number, count in zip(component, sizes):
            per_byte, _, run = form_of(number)
            run_bytes[run] += -(-count // per_byte) if number else 0
    runs = [Content(take_run(content, tables, run, run_bytes[run])) for run in range(1, 8)]
    symbols = [
        [take_symbols(runs, number, count, content) for number, count in zip(component, sizes)]
        for component in forms
    ]
    return add_low_bits(symbols, forms, sizes, content.rest())


def take_symbols(runs, number, count, content):
    """The ranks of a block but for their low bits; escapes are taken from the content."""
    if number == 0:
        return [0] * count
    per_byte, _, run = form_of(number)
    bits = 8 // per_byte
    escape = (1 << bits) - 1
    data = runs[run - 1].bytes(-(-count // per_byte))
    high = [(data[k // per_byte] >> (k % per_byte * bits)) & escape for k in range(count)]
    return [symbol if symbol < escape else escape + content.varint() for symbol in high]


def add_low_bits(symbols, forms, sizes, data):
    bits, at = int.from_bytes(data, "little"), 0
    ranks = []
    for component, component_forms in zip(symbols, forms):
        numbers = []
        for block, number in zip(component, component_forms):
            low_bits = form_of(number)[1]
            for high in block:
                numbers.append((high << low_bits) | ((bits >> at) & ((1 << low_bits) - 1)))
                at += low_bits
        ranks.append(numbers)
    if len(data) != (at + 7) // 8:
        raise Damaged("a frame's geometry has another length than it needs")
    return ranks
