#!/usr/bin/env python3
"""Writes the manual page of a tool from what its --help and --version say.

usage: man_page.py TOOL PAGE
"""

import re
import subprocess
import sys
from pathlib import Path

# Where the help of an option begins, in its line or, where the option is longer, in the next.
COLUMN = 30

CONDITIONS = re.compile(r" (Needs|Excludes):((?: --[\w-]+)+)")


def roff(text):
    """Text as it is, for troff: no command, no hyphen where a minus is meant."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.splitlines())


def entries(lines):
    """(option, its help) of each option or positional in the lines of a section."""
    lines = list(lines)
    while lines:
        line = lines.pop(0)
        if lines and lines[0].startswith(" " * COLUMN):
            yield line.strip(), lines.pop(0).strip()
        else:
            yield line[:COLUMN].strip(), line[COLUMN:].strip()


def option_text(option, explained):
    """One paragraph: the option, what it does, and the options that it needs or goes without."""
    conditions = dict(CONDITIONS.findall(option))
    sentences = [explained[:1].upper() + explained[1:] + "."]
    if "Needs" in conditions:
        sentences.append(f"Only with {', '.join(conditions['Needs'].split())}.")
    if "Excludes" in conditions:
        sentences.append(f"Not with {', '.join(conditions['Excludes'].split())}.")
    return f".TP\n.B {roff(CONDITIONS.sub('', option))}\n{roff(' '.join(sentences))}"


def sections(help_text):
    """Title -> lines, of what stands behind the first line; "" is what belongs to no section."""
    found = {"": []}
    title = ""
    for line in help_text.splitlines()[1:]:
        heading = re.fullmatch(r"(Positionals|Options|Examples):", line)
        if heading:
            title = heading[1]
        elif line and not line.startswith(" "):
            title = ""
        if not heading and line:
            found.setdefault(title, []).append(line)
    return found


def notes_text(lines):
    """What stands below the examples; the exit codes under a title of their own."""
    for line in lines:
        yield re.sub(r"^Exit codes?: ", ".SH EXIT STATUS\n", roff(line))


def page(name, version, help_text):
    """The manual page as troff source."""
    description = help_text.splitlines()[0]
    parts = sections(help_text)
    usage, *notes = parts[""]
    text = [f'.TH {name.upper()} 1 "" "{version}" "User Commands"',
            f".SH NAME\n{name} \\- {roff(description[:1].lower() + description[1:].rstrip('.'))}",
            f".SH SYNOPSIS\n.B {roff(usage.removeprefix('Usage: '))}",
            f".SH DESCRIPTION\n{roff(description)}", ".SH OPTIONS"]
    text += [option_text(*entry) for entry in entries(parts["Positionals"] + parts["Options"])]
    text += [".SH EXAMPLES\n.nf", roff("\n".join(parts["Examples"])), ".fi"]
    text += [".SH NOTES", *notes_text(notes),
             ".SH SEE ALSO", "The documents in /usr/share/doc/ribbon, the samples in /usr/share/ribbon/samples."]
    return "\n".join(text) + "\n"


def answer(tool, question):
    return subprocess.run([tool, question], check=True, capture_output=True, text=True).stdout


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    tool, target = Path(sys.argv[1]), Path(sys.argv[2])
    target.write_text(page(tool.name, answer(tool, "--version").strip(), answer(tool, "--help")))


if __name__ == "__main__":
    main()
