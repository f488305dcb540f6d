"""Reads an Alembic file strictly: written from the layout, without a look at the writer.

Every group, piece of data, header, text, time sampling and count must be as Alembic 1.8.5 writes it; each
byte of the file must belong to exactly one group or piece of data; keys must be those of the samples. What is
only customary (which properties a mesh has) is for the caller to check.
"""

import struct

import numpy as np

DATA = 1 << 63
WORD = (1 << 64) - 1

# Of a property: number of the type, then its name in metadata and in NumPy.
TYPES = {6: "<i4", 10: "<f4", 11: "<f8"}

KNOWN_BITS = 0x0FFFFFFF & ~0x200


class Refused(Exception):
    """The file is not what it should be."""


def demand(good, what):
    if not good:
        raise Refused(what)


def rotated(word, by):
    return ((word << by) | (word >> (64 - by))) & WORD


def mixed(word, first, by, second):
    return rotated(word * first & WORD, by) * second & WORD


def avalanched(word):
    word = (word ^ (word >> 33)) * 0xFF51AFD7ED558CCD & WORD
    word = (word ^ (word >> 33)) * 0xC4CEB9FE1A85EC53 & WORD
    return word ^ (word >> 33)


def murmur(data):
    """MurmurHash3_x64_128 with seed 0, as 16 bytes."""
    c1, c2 = 0x87C37B91114253D5, 0x4CF5AD432745937F
    h1 = h2 = 0
    whole = len(data) // 16 * 16
    for k1, k2 in struct.iter_unpack("<QQ", data[:whole]):
        h1 = (rotated(h1 ^ mixed(k1, c1, 31, c2), 27) + h2) & WORD
        h1 = (h1 * 5 + 0x52DCE729) & WORD
        h2 = (rotated(h2 ^ mixed(k2, c2, 33, c1), 31) + h1) & WORD
        h2 = (h2 * 5 + 0x38495AB5) & WORD
    k1, k2 = struct.unpack("<QQ", data[whole:].ljust(16, b"\0"))
    h1 ^= mixed(k1, c1, 31, c2) ^ len(data)
    h2 ^= mixed(k2, c2, 33, c1) ^ len(data)
    h1 = (h1 + h2) & WORD
    h2 = (h2 + h1) & WORD
    h1, h2 = avalanched(h1), avalanched(h2)
    h1 = (h1 + h2) & WORD
    return struct.pack("<QQ", h1, (h2 + h1) & WORD)


class Bytes:
    """Takes numbers and texts off the front."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count):
        demand(self.at + count <= len(self.data), "a header ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self, kind):
        return struct.unpack("<" + kind, self.take(struct.calcsize("<" + kind)))[0]

    def text(self, count):
        return self.take(count).decode()

    def more(self):
        return self.at < len(self.data)


class Ogawa:
    """Groups and data by their place, each byte of the file visited."""

    def __init__(self, content):
        self.content = content
        self.visited = {}  # begin: end
        demand(content[:8] == b"Ogawa\xff\x00\x01", "not a finished Ogawa file")
        self.root = self.group(self._number(8))

    def _number(self, at):
        demand(16 <= at + 8 <= len(self.content), "a place outside the file")
        return struct.unpack_from("<Q", self.content, at)[0]

    def _visit(self, begin, end):
        demand(16 <= begin and end <= len(self.content), "a place outside the file")
        demand(self.visited.get(begin, end) == end, "two things begin at one place")
        self.visited[begin] = end

    def group(self, child):
        demand(child & DATA == 0, "data where a group is expected")
        if child == 0:
            return []
        count = self._number(child)
        demand(0 < count <= len(self.content) // 8, "a group with a wrong count")
        self._visit(child, child + 8 + 8 * count)
        return list(struct.unpack_from(f"<{count}Q", self.content, child + 8))

    def data(self, child):
        demand(child & DATA != 0, "a group where data are expected")
        begin = child & ~DATA
        if begin == 0:
            return b""
        size = self._number(begin)
        self._visit(begin, begin + 8 + size)
        return self.content[begin + 8 : begin + 8 + size]

    def demand_no_gaps(self):
        at = 16
        for begin, end in sorted(self.visited.items()):
            demand(begin == at, "bytes that belong to nothing, or to two things")
            at = end
        demand(at == len(self.content), "bytes after the end")


def deserialized(text):
    """The pairs of a metadata text, whose keys ascend."""
    if not text:
        return {}
    pairs = [pair.split("=", 1) for pair in text.split(";")]
    demand(all(len(pair) == 2 for pair in pairs), f"metadata {text!r}")
    keys = [key for key, _ in pairs]
    demand(keys == sorted(set(keys)), f"the keys of metadata {text!r}")
    return dict(pairs)


class Property:
    def __init__(self, name, metadata):
        self.name = name
        self.metadata = metadata
        self.children = {}  # of a compound
        self.samples = None  # arrays; of a constant property, one
        self.count = 0
        self.time_sampling = 0
        self.is_array = False

    def sample(self, number):
        return self.samples[min(number, len(self.samples) - 1)]


class Object:
    def __init__(self, name, metadata, properties, children):
        self.name = name
        self.metadata = metadata
        self.properties = properties
        self.children = children


class Archive:
    def __init__(self, path):
        self.file = Ogawa(path.read_bytes())
        root = self.file.root
        demand(len(root) == 6, "the root has not six children")
        demand(self.file.data(root[0]) == struct.pack("<i", 0), "another version of the layout")
        demand(self.file.data(root[1]) == struct.pack("<i", 10805), "another library version")
        self.metadata = deserialized(self.file.data(root[3]).decode())
        self.time_samplings = list(self._time_samplings(Bytes(self.file.data(root[4]))))
        demand(self.time_samplings[0][1:] == (1.0, 0.0), "time sampling 0 is not the default")
        self.table = [""] + list(self._table(Bytes(self.file.data(root[5]))))
        demand(len(set(self.table)) == len(self.table) < 255, "the metadata table")
        self.used = set()
        self.hashes = []
        self.hash_places = set()  # whose bytes Alembic gives no meaning but to differ
        self.top = self._object(root[2], "ABC", "")
        demand(self.used == set(range(1, len(self.table))), "metadata that nothing uses")
        demand(len(set(self.hashes)) == len(self.hashes), "two objects with one hash")
        self.file.demand_no_gaps()

    @staticmethod
    def _time_samplings(data):
        while data.more():
            samples = data.number("I")
            seconds = data.number("d")
            demand(data.number("I") == 1, "a time sampling that is not uniform")
            yield samples, seconds, data.number("d")

    @staticmethod
    def _table(data):
        while data.more():
            size = data.number("B")
            demand(size > 0, "an empty text in the metadata table")
            yield data.text(size)

    def _metadata(self, number):
        demand(number < len(self.table), "a number outside the metadata table")
        if number > 0:
            self.used.add(number)
        return self.table[number]

    def _object(self, place, name, metadata):
        group = self.file.group(place)
        demand(len(group) >= 2, f"object {name!r} has no properties or no headers")
        headers = self.file.data(group[-1])
        demand(len(headers) >= 32, f"object {name!r} has no hashes")
        hashes = headers[-32:]
        self.hashes.append(hashes)
        end = (group[-1] & ~DATA) + 8 + len(headers)
        self.hash_places.update(range(end - 32, end))
        demand((hashes[16:] == bytes(16)) == (len(group) == 2), "the hash of no children")
        children = list(self._children(Bytes(headers[:-32]), group[1:-1]))
        demand(len(children) == len(group) - 2, f"object {name!r}: headers and children differ")
        names = [child.name for child in children]
        demand(len(set(names)) == len(names), "two objects with one name")
        return Object(
            name,
            deserialized(metadata),
            self._properties(group[0]),
            {child.name: child for child in children},
        )

    def _children(self, headers, places):
        for place in places:
            name = headers.text(headers.number("I"))
            demand(name and "/" not in name, f"an object named {name!r}")
            yield self._object(place, name, self._metadata(headers.number("B")))
        demand(not headers.more(), "more headers than objects")

    def _properties(self, place):
        group = self.file.group(place)
        if not group:
            return {}
        headers = Bytes(self.file.data(group[-1]))
        properties = [self._property(headers, child) for child in group[:-1]]
        demand(not headers.more(), "more headers than properties")
        demand(len({p.name for p in properties}) == len(properties), "two properties of one name")
        return {p.name: p for p in properties}

    def _property(self, headers, place):
        info = headers.number("I")
        demand(info & ~KNOWN_BITS == 0, f"unknown bits in {info:#x}")
        kind, hint = info & 3, info >> 2 & 3
        demand(hint < 3, "a size hint of 3")
        width = "BHI"[hint]
        count = headers.number(width) if kind else 0
        time_sampling = headers.number(width) if info & 0x100 else 0
        found = Property(headers.text(headers.number(width)), "")
        text = self._metadata(info >> 20)
        largest = max(len(text), len(found.name), count, time_sampling)
        demand(hint == (largest > 0xFF) + (largest > 0xFFFF), f"size hint {hint} for {largest}")
        found.metadata = deserialized(text)
        if kind == 0:
            demand(info & 0xFFF0 == 0 and info & 0xF0000 == 0, "a compound with values")
            found.children = self._properties(place)
            return found
        found.count, found.time_sampling, found.is_array = count, time_sampling, kind != 1
        demand(time_sampling < len(self.time_samplings), "a time sampling that is not there")
        found.samples = self._samples(info, count, place)
        return found

    def _samples(self, info, count, place):
        is_array, is_constant = info & 3 != 1, bool(info & 0x800)
        number = TYPES.get(info >> 4 & 15)
        extent = info >> 12 & 255
        demand(number and extent, "numbers of an unknown type")
        group = self.file.group(place)
        stored = 1 if is_constant else count
        demand(count >= 1 and (is_constant or count >= 2), "a wrong number of samples")
        demand(len(group) == stored * (2 if is_array else 1), "samples and their number differ")
        if is_array:
            demand(all(child == DATA for child in group[1::2]), "dimensions of a plain array")
            group = group[::2]
        samples = [self._sample(self.file.data(child), number, extent) for child in group]
        sizes = {len(sample) for sample in samples}
        demand((len(sizes) == 1) == bool(info & 0x400), "whether all samples have one size")
        demand((sizes == {1}) == bool(info & 1), "whether samples are single values")
        demand(is_constant or len({s.tobytes() for s in samples}) > 1, "constant, but not said so")
        return samples

    @staticmethod
    def _sample(data, number, extent):
        demand(len(data) >= 16, "a sample without its key")
        demand(murmur(data[16:]) == data[:16], "a key that is not that of its data")
        numbers = np.frombuffer(data[16:], number)
        demand(len(numbers) % extent == 0, "a sample that ends within a value")
        return numbers.reshape(-1, extent)
