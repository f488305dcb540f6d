"""Diagrams and tables for documents; part of plot_accuracy.py and plot_recording.py."""

import math
import sys
from xml.sax.saxutils import escape

WIDTH, HEIGHT, MARGIN = 460, 400, 60


def line(x1, y1, x2, y2, stroke):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{stroke}"/>'


def text(x, y, words, anchor="middle", fill="black", weight="normal"):
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{fill}" font-weight="{weight}">'
        f"{escape(words)}</text>"
    )


def dot(x, y, fill, words, radius=4):
    return (
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill}">'
        f"<title>{escape(words)}</title></circle>"
    )


def polyline(points, stroke):
    corners = " ".join("{:.1f},{:.1f}".format(*point) for point in points)
    return f'<polyline points="{corners}" fill="none" stroke="{stroke}" stroke-width="1.5"/>'


class Panel:
    """A diagram with logarithmic axes, whose ranges are what the first and the last tick say; ticks
    are values with their words."""

    def __init__(self, left, title, x_name, y_name, x_ticks, y_ticks):
        self.left, self.title, self.x_name, self.y_name = left, title, x_name, y_name
        self.x_ticks, self.y_ticks = x_ticks, y_ticks

    def at(self, x, y):
        def share(value, ticks):
            low, high = math.log(ticks[0][0]), math.log(ticks[-1][0])
            return (math.log(value) - low) / (high - low)

        return (
            self.left + MARGIN + share(x, self.x_ticks) * (WIDTH - MARGIN - 30),
            HEIGHT - MARGIN - share(y, self.y_ticks) * (HEIGHT - MARGIN - 40),
        )

    def grid(self):
        low_x, high_x = self.x_ticks[0][0], self.x_ticks[-1][0]
        low_y, high_y = self.y_ticks[0][0], self.y_ticks[-1][0]
        for x, words in self.x_ticks:
            yield line(*self.at(x, low_y), *self.at(x, high_y), "#dddddd")
            place, bottom = self.at(x, low_y)
            yield text(place, bottom + 18, words)
        for y, words in self.y_ticks:
            yield line(*self.at(low_x, y), *self.at(high_x, y), "#dddddd")
            left, place = self.at(low_x, y)
            yield text(left - 6, place + 4, words, "end")
        middle = self.left + (WIDTH + MARGIN - 30) / 2
        yield text(middle, 24, self.title, weight="bold")
        yield text(middle, HEIGHT - 18, self.x_name)
        yield text(self.left + MARGIN, 36, self.y_name, "start")


def colour_of(name, colours, other):
    """Of the first word that the name begins with."""
    return next((colours[word] for word in colours if name.startswith(word)), other)


def picture(panels, key):
    """Two panels beside each other; below them what the colours of the key mean."""
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * WIDTH + 60} {HEIGHT + 30}"'
        ' font-family="sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="white"/>',
        *panels,
    ]
    for i, (name, fill) in enumerate(key):
        lines += [dot(80 + 150 * i, HEIGHT + 12, fill, name), text(90 + 150 * i, HEIGHT + 16, name, "start")]
    return "\n".join([*lines, "</svg>", ""])


def with_table(document, begin, table):
    """The table in the place of what stands between the line `begin` and the end of the table."""
    begin, end = begin + "\n", "<!-- end of table -->\n"
    head, found, rest = document.partition(begin)
    _, found_end, tail = rest.partition(end)
    if not found or not found_end:
        sys.exit(f"the document has no place for a table; write {begin.strip()} and {end.strip()}")
    return head + begin + table + end + tail
