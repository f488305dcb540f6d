#!/usr/bin/env python3
"""Checks every #include of the toolkit against the tables in libribbon/README.md.

usage: check_includes.py ROOT

Prints one line "file:line: what is wrong" per violation and exits with 1 when there is any.
"""

import re
import sys
from pathlib import Path

TOOLS = ("recorder", "player", "converter", "python")
SOURCES = {".h", ".hpp", ".cpp", ".inc"}

# Third-party headers that any file may include.
FREE = ("Eigen/", "tl/expected.hpp")

# Headers that only one tool may include.
HOMES = {
    "pybind11/": "python",
    "embree3/": "player",
    "GL/": "player",
    "assimp/Exporter.hpp": "converter",
    "assimp/cexport.h": "converter",
}

# What the operating system and the compiler bring. C++'s own headers have no dot.
SYSTEM = re.compile(
    r"[a-z_0-9]+|sys/.*|(csignal|dirent|dlfcn|fcntl|pthread|signal|termios|unistd|[a-z]mmintrin)\.h"
)

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
ROW = re.compile(r"\| `(\w+(?:/\w+)?)` \|(?:.*\|)?([^|]*)\|\s*$")


def read_rules(readme):
    """Folder -> folders that it may include, from the rows of the README's tables.

    A row `station/room` names the rooms of its own station that a room may include; of other stations
    it may include what its station may.
    """
    rules = {}
    for line in readme.read_text().splitlines():
        row = ROW.match(line)
        if row:
            house = row[1].rpartition("/")[0]
            names = re.findall(r"`(\w+)`", row[2])
            rules[row[1]] = {f"{house}/{name}" if house else name for name in names}
    return rules


def check_rules(rules, folders):
    """The tables themselves: a row for each folder, and one way to go."""
    for folder in sorted(folders ^ rules.keys()):
        missing = "no row" if folder in folders else "a row but no folder"
        yield f"libribbon/README.md: '{folder}' has {missing}"
    for folder in rules:
        upstream, pending = set(), list(rules[folder])
        while pending:
            name = pending.pop()
            if name not in upstream:
                upstream.add(name)
                pending.extend(rules.get(name, ()))
        if folder in upstream:
            yield f"libribbon/README.md: '{folder}' may include itself in a circle"


def includes_of(file):
    """(line, quoted or not, header) of each include."""
    for number, line in enumerate(file.read_text().splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found[1] == '"', found[2]


def folders_in(folder):
    return {path.name for path in folder.iterdir() if path.is_dir()}


def library_of(header):
    """toml++/toml.h -> toml++, zstd.h -> zstd"""
    return header.split("/")[0].removesuffix(".h").removesuffix(".hpp")


class Scan:
    def __init__(self, root):
        self.root = root
        self.rules = read_rules(root / "libribbon" / "README.md")
        self.stations = folders_in(root / "libribbon")
        self.tools = {tool for tool in TOOLS if (root / tool).is_dir()}
        self.rooms = {f"{station}/{room}" for station in self.stations
                      for room in folders_in(root / "libribbon" / station)}
        self.rooms |= {f"{tool}/{room}" for tool in self.tools for room in folders_in(root / tool)}
        self.users = {}  # third-party library -> the first file of libribbon that includes it

    def files(self):
        folders = [self.root / "libribbon"] + [self.root / tool for tool in sorted(self.tools)]
        for folder in folders:
            for file in sorted(folder.rglob("*")):
                if file.suffix in SOURCES:
                    yield file

    def violations(self):
        yield from check_rules(self.rules, self.stations | self.tools | self.rooms)
        for file in self.files():
            name = file.relative_to(self.root)
            for line, is_quoted, header in includes_of(file):
                ours = is_quoted or header.split("/")[0] in self.stations | self.tools
                problem = self.own(file, header) if ours else self.foreign(name, header)
                if problem:
                    yield f"{name}:{line}: {problem}"

    def own(self, file, header):
        """What is wrong with including one of our headers, None when nothing is."""
        parts = file.relative_to(self.root).parts
        parts = parts[1:] if parts[0] == "libribbon" else parts
        folder, target = parts[0], header.split("/")[0]
        if ".." in header.split("/"):
            return f"'{header}' goes up; name the folder instead"
        if target in self.stations and (self.root / "libribbon" / header).is_file():
            if target != folder and target not in self.rules.get(folder, ()):
                return f"'{folder}' may not include '{header}'"
        elif target in self.tools and (self.root / header).is_file():
            if target != folder:
                return f"'{folder}' may not include '{header}'"
        elif not (file.parent / header).is_file():
            return f"'{header}' is no file of libribbon or of '{folder}'"
        room, target_room = "/".join(parts[:2]), "/".join(header.split("/")[:2])
        if target == folder and room in self.rooms and target_room != room:
            if target_room not in self.rules.get(room, ()):
                return f"'{room}' may not include '{header}'"
        return None

    def foreign(self, name, header):
        """What is wrong with including a third-party header, None when nothing is."""
        if SYSTEM.fullmatch(header) or header.startswith(FREE):
            return None
        for prefix, home in HOMES.items():
            if header.startswith(prefix) and name.parts[0] != home:
                return f"<{header}> belongs in {home}/ only"
        if name.parts[0] != "libribbon":
            return None
        if name.suffix != ".cpp":
            return f"<{header}> belongs in a .cpp"
        user = self.users.setdefault(library_of(header), name)
        if user != name:
            return f"<{header}> is hidden in {user}; a library belongs in one .cpp"
        return None


def main(root):
    violations = list(Scan(Path(root)).violations())
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
