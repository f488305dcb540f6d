"""Reads the part of USD's text form that a mesh in motion needs, strictly: written from its grammar.

Whatever the grammar does not have here is refused: unknown types, names that are no identifiers, values that
do not fit their type, two things of one name, time samples that do not ascend, targets that are not there.
"""

import math
import pathlib
import re

import numpy as np

from read_alembic import demand

TOKEN = re.compile(
    r"""(?P<space>[ \t\r\n]+)
    |(?P<string>"(?:[^"\\\x00-\x1f]|\\["\\])*")
    |(?P<asset>@@@[^\n]*?@@@|@[^@\n]*@)
    |(?P<path><[A-Za-z0-9_/.:]*>)
    |(?P<number>-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.]))
    |(?P<word>[A-Za-z_][A-Za-z0-9_:.]*)
    |(?P<mark>\[\]|[(){}\[\]=,:])""",
    re.VERBOSE,
)
IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")

# Of a type: how many numbers a value has (None: it is no number) and what they are.
TYPES = {
    "bool": (1, bool),
    "int": (1, int),
    "token": (None, str),
    "string": (None, str),
    "asset": (None, pathlib.Path),
    "float2": (2, float),
    "float3": (3, float),
    "point3f": (3, float),
    "normal3f": (3, float),
    "texCoord2f": (2, float),
    "color3f": (3, float),
}
PRIMS = ("Xform", "Mesh", "GeomSubset", "Scope", "Material", "Shader")

# Metadata of a layer, a prim or a property, and the type of its value.
METADATA = {
    "defaultPrim": str,
    "doc": str,
    "upAxis": str,
    "displayName": str,
    "interpolation": str,
    "metersPerUnit": float,
    "framesPerSecond": float,
    "timeCodesPerSecond": float,
    "startTimeCode": float,
    "endTimeCode": float,
    "apiSchemas": list,
}


class Prim:
    def __init__(self, kind, name):
        self.kind = kind
        self.name = name
        self.metadata = {}
        self.properties = {}
        self.children = {}


class Attribute:
    def __init__(self, kind, is_array):
        self.kind = kind
        self.is_array = is_array
        self.metadata = {}
        self.value = None
        self.samples = None  # by time code
        self.connection = None
        self.is_uniform = False

    def is_empty(self, kind, is_array):
        """Was it only declared, with this type? Then samples may follow."""
        is_alike = (self.kind, self.is_array) == (kind, is_array)
        return is_alike and self.value is None and self.samples is None and self.connection is None


class Tokens:
    def __init__(self, text):
        self.text = text
        self.at = 0
        self.kind, self.token = None, None
        self.step()

    def step(self):
        """The token that stood here."""
        before = self.token
        while True:
            if self.at == len(self.text):
                self.kind, self.token = "end", ""
                return before
            found = TOKEN.match(self.text, self.at)
            demand(found, f"no token at {self.at}: {self.text[self.at:self.at + 20]!r}")
            self.at = found.end()
            self.kind, self.token = found.lastgroup, found[0]
            if self.kind != "space":
                return before

    def take(self, token):
        demand(self.token == token, f"{self.token!r} instead of {token!r} before {self.at}")
        return self.step()

    def take_kind(self, kind):
        demand(self.kind == kind, f"{self.token!r} instead of a {kind} before {self.at}")
        return self.step()

    def string(self):
        return re.sub(r"\\(.)", r"\1", self.take_kind("string")[1:-1])

    def separated(self, opening, closing, item):
        """Items between brackets, with commas between them; the last may have one, too."""
        self.take(opening)
        items = []
        while self.token != closing:
            items.append(item())
            if self.token != closing:
                self.take(",")
        self.take(closing)
        return items


class Layer:
    def __init__(self, path):
        text = path.read_bytes().decode()
        demand(text.startswith("#usda 1.0\n"), "the first line is not '#usda 1.0'")
        self.tokens = Tokens(text[len("#usda 1.0\n") :])
        self.metadata = self._metadata()
        self.prims = {}
        self.targets = []
        while self.tokens.kind != "end":
            self._add(self.prims, self._prim())
        demand(self.metadata.get("defaultPrim") in self.prims, "no such default prim")
        for target in self.targets:
            demand(self._is_there(target), f"no such target as {target}")

    @staticmethod
    def _add(where, prim):
        demand(prim.name not in where, f"two prims named {prim.name}")
        where[prim.name] = prim

    def _is_there(self, target):
        path, _, attribute = target.partition(".")
        prims, prim = self.prims, None
        for name in path[1:].split("/"):
            prim = prims.get(name)
            if prim is None:
                return False
            prims = prim.children
        return not attribute or attribute in prim.properties

    def _metadata(self):
        found = {}
        if self.tokens.token != "(":
            return found
        self.tokens.step()
        while self.tokens.token != ")":
            is_list_edit = self.tokens.token == "prepend"
            if is_list_edit:
                self.tokens.step()
            name = self.tokens.take_kind("word")
            demand(name in METADATA and name not in found, f"metadata {name}")
            demand(is_list_edit == (METADATA[name] is list), f"whether {name} is prepended")
            self.tokens.take("=")
            found[name] = self._metadatum(METADATA[name])
        self.tokens.step()
        return found

    def _metadatum(self, kind):
        if kind is list:
            return self.tokens.separated("[", "]", self.tokens.string)
        return self.tokens.string() if kind is str else self._number(float)

    def _prim(self):
        self.tokens.take("def")
        kind = self.tokens.take_kind("word")
        demand(kind in PRIMS, f"a prim of type {kind}")
        prim = Prim(kind, self.tokens.string())
        demand(IDENTIFIER.match(prim.name), f"{prim.name!r} is no identifier")
        prim.metadata = self._metadata()
        self.tokens.take("{")
        while self.tokens.token != "}":
            if self.tokens.token == "def":
                self._add(prim.children, self._prim())
            else:
                self._property(prim)
        self.tokens.step()
        return prim

    def _property(self, prim):
        is_uniform = self.tokens.token == "uniform"
        if is_uniform:
            self.tokens.step()
        kind = self.tokens.take_kind("word")
        is_array = self.tokens.token == "[]"
        if is_array:
            self.tokens.step()
        name, _, role = self.tokens.take_kind("word").partition(".")
        declared = prim.properties.get(name)
        fills = role == "timeSamples" and declared and declared.is_empty(kind, is_array)
        demand(not declared or fills, f"two properties named {name}")
        if kind == "rel":
            prim.properties[name] = self._target()
            return
        demand(kind in TYPES, f"a property of type {kind}")
        attribute = prim.properties[name] = declared or Attribute(kind, is_array)
        attribute.is_uniform = is_uniform
        if role == "timeSamples":
            attribute.samples = self._samples(attribute)
        elif role == "connect":
            attribute.connection = self._target()
        else:
            demand(not role, f"{name}.{role}")
            if self.tokens.token == "=":
                self.tokens.step()
                attribute.value = self._value(attribute)
            attribute.metadata = self._metadata()

    def _target(self):
        self.tokens.take("=")
        self.targets.append(self.tokens.take_kind("path")[1:-1])
        return self.targets[-1]

    def _samples(self, attribute):
        self.tokens.take("=")
        samples = {}

        def sample():
            time = self._number(float)
            self.tokens.take(":")
            demand(not samples or time > max(samples), "time samples that do not ascend")
            samples[time] = self._value(attribute)

        self.tokens.separated("{", "}", sample)
        return samples

    def _value(self, attribute):
        size, kind = TYPES[attribute.kind]
        if kind is pathlib.Path:
            return pathlib.Path(self.tokens.take_kind("asset").strip("@"))
        item = self.tokens.string if size is None else lambda: self._item(size, kind)
        if not attribute.is_array:
            return item()
        return np.array(self.tokens.separated("[", "]", item), np.float32 if kind is float else kind)

    def _item(self, size, kind):
        if size == 1:
            return self._number(kind)
        numbers = self.tokens.separated("(", ")", lambda: self._number(kind))
        demand(len(numbers) == size, f"{len(numbers)} numbers instead of {size}")
        return numbers

    def _number(self, kind):
        text = self.tokens.take_kind("number")
        if kind is bool:
            demand(text in "01", f"{text} is no bool")
            return text == "1"
        demand(kind is float or re.fullmatch(r"-?\d+", text), f"{text} is no whole number")
        demand(math.isfinite(float(text)), f"{text} is too large")
        return kind(text)
