#!/usr/bin/env python3
"""Checks that some programs contain nothing of a static library, and that others do.

usage: check_links.py LIBRARY --with PROGRAM... --without PROGRAM...

The programs named after --with show that the check can see the library at all. Prints one line per
violation and exits with 1 when there is any.
"""

import argparse
import subprocess
import sys


def defined_symbols(file):
    """Names of the functions and data that `file` itself defines for others.

    Weak ones are left out: every program may have its own copy of an inline function.
    """
    lines = subprocess.run(
        ["nm", "--demangle", "--extern-only", "--defined-only", file],
        check=True, capture_output=True, text=True,
    ).stdout.splitlines()
    fields = (line.split(maxsplit=2) for line in lines)
    return {field[2] for field in fields if len(field) == 3 and field[1] in "TDBR"}


def main(arguments):
    library = defined_symbols(arguments.library)
    violations = []
    for program in arguments.programs_with:
        if not library & defined_symbols(program):
            violations.append(f"{program} has nothing of {arguments.library}")
    for program in arguments.programs_without:
        for symbol in sorted(library & defined_symbols(program)):
            violations.append(f"{program} contains {symbol} of {arguments.library}")
    print("\n".join(violations))
    return 1 if violations else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("library")
    parser.add_argument("--with", nargs="+", required=True, dest="programs_with")
    parser.add_argument("--without", nargs="+", required=True, dest="programs_without")
    sys.exit(main(parser.parse_args()))
