#!/usr/bin/env python3
"""What reaches a position is computed alike everywhere: by exactly rounded operations and functions of
our own, in an order that is written down.

usage: check_functions.py ROOT

Prints one line "file:line: what is wrong" for each function of the C library that is rounded as its
authors liked, and for each sum of Eigen, whose order depends on vector instructions, in the stations
from the drawing to the simulation, which ask those of knots whether a start is the one that was
meant. Exits with 1 when there is any.
"""

import re
import sys
from pathlib import Path

STATIONS = ("geometry", "scene", "curve", "ribbon_mesh", "obstacle", "knot", "simulation")

# Only text of messages depends on it.
EXEMPT = {"libribbon/curve/place.cpp"}

LIBRARY = re.compile(
    r"(?<![\w.>:])(?:std::)?(a?(?:sin|cos|tan)h?|atan2|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot"
    r"|lerp|erfc?|[tl]gamma)[fl]?\s*\("
)
EIGEN = re.compile(
    r"(?:\.|->)(norm|squaredNorm|stableNorm|lpNorm|dot|sum|mean|trace|normalized?|stableNormalized?"
    r"|a?(?:sin|cos|tan)h?|exp|log|pow|cbrt)\s*(?:<[^>]*>)?\("
)
PRODUCT = re.compile(r"(transpose\(\) \*)")
TYPES = re.compile(r"\b(Rotation2Dd?|AngleAxisd?|Quaterniond?|arc_endpoint_to_center)\b")
COMMENT = re.compile(r"//.*")

PATTERNS = (
    (LIBRARY, "'{}' of the C library is not exactly rounded; see geometry/angles.h, geometry/vectors.h"),
    (EIGEN, "'{}' of Eigen has no order of its own; see geometry/vectors.h, integration/ordered_sums.h"),
    (PRODUCT, "'{}' is a sum of Eigen, which has no order of its own; see geometry/vectors.h"),
    (TYPES, "'{}' calls functions of the C library; see geometry/angles.h"),
)


def problems_of(text):
    """(line, what is wrong) of a source."""
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, problem in PATTERNS:
            for found in pattern.finditer(COMMENT.sub("", line)):
                yield number, problem.format(found[1])


def violations(root):
    for station in STATIONS:
        for file in sorted((root / "libribbon" / station).rglob("*")):
            name = file.relative_to(root).as_posix()
            if file.suffix in {".h", ".cpp", ".inc"} and name not in EXEMPT:
                for line, problem in problems_of(file.read_text()):
                    yield f"{name}:{line}: {problem}"


def main(root):
    found = list(violations(Path(root)))
    for violation in found:
        print(violation)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
