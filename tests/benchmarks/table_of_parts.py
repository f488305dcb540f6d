#!/usr/bin/env python3
"""Makes the table of what each part of the codec buys.

usage: table_of_parts.py FOLDER DOCUMENT

The folder holds 0.json, 1.json, ..., which benchmark_recording has written, the first with all parts, and
0.name, ..., which say what was left out. The table takes the place of the one that the document calls "parts".
"""

import json
import sys
from pathlib import Path

from plot import with_table
from plot_recording import Figures, bound_text, table


def rows(figures):
    """Bits by bound, one row for each part."""
    for name, part in figures:
        yield [name, *(f"{part.bits('ribbon', bound):.2f}" for bound in part.bounds)]


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder, document = Path(sys.argv[1]), Path(sys.argv[2])
    names = sorted(folder.glob("*.name"), key=lambda file: int(file.stem))
    figures = [
        (name.read_text().strip(), Figures(json.loads(name.with_suffix(".json").read_text())))
        for name in names
    ]
    made = table(["without", *map(bound_text, figures[0][1].bounds)], rows(figures))
    document.write_text(with_table(document.read_text(), "<!-- table parts -->", made))


if __name__ == "__main__":
    main()
